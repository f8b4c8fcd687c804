//! Files of vehicles and rules of one's own, as the command reads them.

use crate::stage::Stage;

const LORRY: &str = "code = \"lorry\"\ntitle = \"Lorry\"\nways = \"road\"\n\
    source = { text = \"a plate\", date = \"2026\", confidence = \"assumed\" }\n\n[[vehicle]]\ncode = \"our-lorry\"\n\
    title = \"Lorry\"\naxle_loads_kn = [80.0, 110.0]\nspacings_m = [4.0]\naxles_may_be_dropped = true\n\
    wheel_track_m = 1.8\ncontact_length_m = 0.30\n";

/// A vehicle that no rule was made for is refused with its place and what to write; so are all other slips, at once.
#[test]
fn slips_in_names_and_files_are_told_together() {
    let stage = Stage::with_example("vehicle-files", "bridgemill");
    let text = stage.read("bridge/vehicles.toml");
    stage.write("bridge/lorry.toml", LORRY);
    let asked = |names: &str| {
        let more = format!("vehicles = [{names}]\nvehicle_files = [\"lorry.toml\"]\n\n[dispersal]");
        text.replacen("rule = \"characteristic\"", "rule = \"cs-454\"", 1).replacen("[dispersal]", &more, 1)
    };
    stage.write("bridge/own.toml", asked("\"our-lorry\", \"LM1\", \"hb46\""));
    let (answer, ending) = stage.object(&["check", "bridge/own.toml"]);
    assert_eq!(ending.code, Some(2), "{}", ending.stderr);
    let said: Vec<&str> =
        answer["errors"].as_array().expect("errors").iter().filter_map(|e| e["message"].as_str()).collect();
    for part in ["our-lorry", "LM1", "hb46"] {
        assert!(said.iter().any(|message| message.contains(part)), "{part}: {said:?}");
    }
    // Several slips of one file are reported at once, each with its line.
    let wrong =
        LORRY.replace("ways = \"road\"", "ways = \"water\"").replace("= [4.0]", "= []").replace("= 1.8", "= \"1.8 m\"");
    stage.write("bridge/lorry.toml", &wrong);
    let (answer, _) = stage.object(&["check", "bridge/own.toml"]);
    let said: Vec<&str> =
        answer["errors"].as_array().expect("errors").iter().filter_map(|e| e["message"].as_str()).collect();
    let told = |part: &str| said.iter().any(|message| message.contains("lorry.toml") && message.contains(part));
    assert!(told("line 3") && told("line 12"), "{said:?}");
    // What such a file would have brought is not reported as missing.
    assert!(said.iter().all(|message| !message.contains("there is no vehicle")), "{said:?}");
}

/// A name that nothing bears is answered with the few that are nearest, and with where all are listed.
#[test]
fn a_name_that_nothing_bears_is_answered_with_the_nearest() {
    let stage = Stage::with_example("vehicle-names", "bridgemill");
    let text = stage.read("bridge/vehicles.toml");
    for (written, wanted) in [
        ("hb-46", "write \"hb-45\", or a name that extrados vehicles lists"),
        ("lm", "write \"lm1\""),
        ("crane", "write a name that extrados vehicles lists"),
    ] {
        let asked = format!("vehicles = [\"{written}\"]\n\n[dispersal]");
        stage.write("bridge/one.toml", text.replacen("[dispersal]", &asked, 1));
        let (answer, _) = stage.object(&["check", "bridge/one.toml"]);
        let errors = answer["errors"].as_array().expect("errors");
        assert_eq!(errors.len(), 1, "{errors:?}");
        let help = errors[0]["help"].as_str().expect("help");
        assert!(help.starts_with(wanted) && help.len() < 160, "{written}: {help}");
    }
}

/// Axles of 11.5 kN where tonnes were meant are doubted by `check` and with every sweep, not by an assessment alone.
#[test]
fn tonnes_for_kilonewtons_are_doubted_wherever_vehicles_move() {
    let stage = Stage::with_example("vehicle-doubts", "bridgemill");
    let text = stage.read("bridge/vehicles.toml");
    let source = "source = { text = \"a plate\", date = \"2026\", confidence = \"read\" }";
    let under = format!(
        "\n[[under]]\nrule = \"cs-454\"\nlive_load = {{ value = 1.5, {source} }}\nimpact = {{ kind = \"included\", {source} }}\n"
    );
    let asked = "vehicles = [\"our-lorry\"]\nvehicle_files = [\"lorry.toml\"]\n\n[dispersal]";
    stage.write(
        "bridge/own.toml",
        text.replacen("rule = \"characteristic\"", "rule = \"cs-454\"", 1).replacen("[dispersal]", asked, 1),
    );
    let told = |axles: &str| {
        stage.write("bridge/lorry.toml", LORRY.replace("[80.0, 110.0]", axles) + &under);
        [&["check"][..], &["collapse", "--sweep"]].map(|command| {
            let (answer, ending) = stage.object(&[command, &["bridge/own.toml"]].concat());
            assert!(ending.code.is_some_and(|code| code < 2), "{command:?}: {}", ending.stderr);
            answer["warnings"].as_array().expect("warnings").iter().any(|one| one.to_string().contains("P080"))
        })
    };
    assert_eq!((told("[8.0, 11.5]"), told("[80.0, 115.0]")), ([true; 2], [false; 2]));
}

/// Schemas of both kinds of files are printed alone.
#[test]
fn schemas_of_vehicles_and_rules_are_printed() {
    let stage = Stage::with_example("vehicle-schemas", "tiny");
    for (flag, key) in [("--vehicles", "vehicle"), ("--rule", "factors")] {
        let ending = stage.run(&["schema", flag]);
        assert_eq!(ending.code, Some(0), "{}", ending.stderr);
        let answer: serde_json::Value = serde_json::from_str(&ending.stdout).expect("a schema");
        assert!(answer["properties"][key].is_object(), "{flag}");
    }
}
