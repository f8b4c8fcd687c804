//! The file of a surveyed bridge, and what shells and `man` know of the command.

use crate::stage::Stage;

const FIVE: [&str; 10] = ["--span", "6", "--rise", "1.5 m", "--ring", "18 in", "--width", "16' 6\"", "--cover", "0.5"];

fn new<'a>(folder: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    [&["new", folder][..], &FIVE, more].concat()
}

/// Five numbers and a rule, by every vehicle that goes with it: a verdict.
#[test]
fn five_numbers_and_a_rule_make_a_file_that_is_judged() {
    let stage = Stage::new("new-surveyed");
    let (answer, ending) = stage.object(&new("mill-lane", &["--rule", "cs-454"]));
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    assert_eq!(answer["files"][0], "bridge.toml");
    assert!(answer["assumed"].as_array().is_some_and(|assumed| assumed.len() == 9), "{answer}");
    let text = stage.read("mill-lane/bridge.toml");
    for line in
        ["name = \"mill-lane\"", "span = \"6 m\"", "thickness = \"18 in\"", "width = \"16.5 ft\"", "rule = \"cs-454\""]
    {
        assert!(text.contains(line), "{line} is not in\n{text}");
    }
    let (judged, ending) = stage.object(&["assess", "mill-lane/bridge.toml", "--out", "judged"]);
    assert_eq!((judged["status"].as_str(), ending.code), (Some("inadequate"), Some(1)), "{}", judged["verdict"]);
    assert_eq!(judged["load_cases_left_out"].as_array().map(Vec::len), Some(0), "{}", judged["verdict"]);
    // What was there before stays.
    assert_eq!(stage.object(&new("mill-lane", &[])).0["errors"][0]["code"], "F103");
}

/// What is known of rings, fill, skew and condition: a stated skew is never taken for a square bridge, and one that nobody states is told.
#[test]
fn rings_fill_skew_and_condition_are_flags() {
    let stage = Stage::new("new-more");
    let more =
        ["--rings", "3", "--bond", "100", "--fill", "old-fill", "--lost-mortar", "20mm", "--reference", "ABC1/0123"];
    let strong = ["--ring", "0.9", "--rule", "cs-454"];
    let with = |folder: &'static str, own: &[&'static str]| {
        let sheet = ["new", folder, "--span", "6", "--rise", "1.5", "--width", "6", "--cover", "0.5"];
        assert_eq!(stage.object(&[&sheet[..], &strong, own].concat()).1.code, Some(0));
        stage.read(&format!("{folder}/bridge.toml"))
    };
    let text = with("all", &[&more[..], &["--skew", "12deg", "--condition", "cracked along the east wall"]].concat());
    for line in [
        "skew = \"12deg\"",
        "material = \"old-fill\"",
        "thickness = \"0.3 m\"  # 1/3 of 0.9 m",
        "[ring_joint]",
        "cohesion = \"100 kPa\"\n",
        "depth = \"20mm\"",
        "structure_number = \"ABC1/0123\"",
        "finding = \"cracked along the east wall\"",
    ] {
        assert!(text.contains(line), "{line} is not in\n{text}");
    }
    let said = stage.run(&new("x", &["--fill", "sand", "--skew", "12 m", "--fill-density", "heavy"])).stderr;
    for flag in
        ["--fill: there is no fill called \"sand\"", "--skew: \"12 m\" is a length", "--fill-density: \"heavy\""]
    {
        assert!(said.contains(flag), "{flag} is not in\n{said}");
    }
    // A square bridge is one that says so; without an answer the file has no skew, and the verdict says what it takes.
    for (folder, skew, status) in [
        ("square", &["--skew", "0"][..], "adequate"),
        ("skew", &["--skew", "12"], "undetermined"),
        ("open", &[], "adequate"),
    ] {
        assert_eq!(with(folder, skew).contains("skew"), folder != "open");
        let (judged, _) =
            stage.object(&["assess", &format!("{folder}/bridge.toml"), "--out", &format!("out-{folder}")]);
        let words = judged["verdict"].to_string();
        assert_eq!(judged["status"], status, "{folder}: {words}");
        assert_eq!(words.contains("gives no skew"), folder == "open", "{folder}: {words}");
    }
}

/// All slips at once, by the flags that they stand at.
#[test]
fn slips_are_named_by_their_flags() {
    let stage = Stage::new("new-slips");
    let wrong = ["new", "x", "--span", "six", "--rise", "-1", "--ring", "3 kN", "--width", "5", "--cover", "0.5"];
    let said = stage.run(&wrong).stderr;
    for flag in ["--span: \"six\" is no number", "--ring: \"3 kN\" is a force", "write --ring with its unit"] {
        assert!(said.contains(flag), "{flag} is not in\n{said}");
    }
    let typed = |ring: &str, density: &str| {
        let sheet = ["new", "y", "--span", "6", "--rise", "1.5", "--ring", ring, "--width", "5", "--cover", "0.5"];
        stage.run(&[&sheet[..], &["--density", density]].concat()).stderr
    };
    assert!(typed("0,45", "2200").contains("write --ring as 0.45"), "{}", typed("0,45", "2200"));
    assert!(typed("450", "2200").contains("did you mean \"450 mm\"?"), "{}", typed("450", "2200"));
    // What is possible and unusual makes a file, and is told at once.
    let light = typed("0.45", "22");
    assert!(light.contains("warning[P001]") && light.contains("did you mean \"22 kN/m^3\"?"), "{light}");
    let out_of_range = [&wrong[..3], &["6"], &wrong[4..7], &["0.45"], &wrong[8..]].concat();
    assert!(stage.run(&out_of_range).stderr.contains("--rise: \"-1 m\" is out of its possible range"));
    let unknown = stage.run(&new("x", &["--rule", "cs-45", "--vehicle", "cs454-singel"])).stderr;
    assert!(
        unknown.contains("F126") && unknown.contains("\"cs-454\"") && unknown.contains("\"cs454-single\""),
        "{unknown}"
    );
    let lacks = stage.run(&["new", "x", "--span", "6", "--rise", "1.5"]).stderr;
    assert!(["--ring", "--width", "--cover"].iter().all(|flag| lacks.contains(flag)), "{lacks}");
    assert!(stage.names(".").iter().all(|name| !name.starts_with("x/")));
    let help = stage.run(&["new", "--help"]).stdout;
    // Lines are folded where the width of the screen is known.
    let help = help.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(extrados::examples::ALL.iter().all(|one| help.contains(one.name) && help.contains(one.about)), "{help}");
}

/// The commands, as the help lists them.
fn commands(stage: &Stage) -> Vec<String> {
    let help = stage.run(&["--help"]).stdout;
    let listed = help.lines().skip_while(|line| *line != "Commands:").skip(1).take_while(|line| !line.is_empty());
    // What follows on a line of its own is set in further.
    let names = listed.filter(|line| !line.starts_with("   ")).filter_map(|line| line.split_whitespace().next());
    names.filter(|name| *name != "help").map(str::to_owned).collect()
}

#[test]
fn shells_complete_every_command_and_each_has_a_page_of_the_manual() {
    let stage = Stage::new("new-shells");
    let commands = commands(&stage);
    assert!(commands.len() > 20, "{commands:?}");
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = stage.run(&["completions", shell]).stdout;
        assert!(
            commands.iter().chain([&"--sweep".to_owned()]).all(|word| script.contains(word.trim_start_matches('-'))),
            "{shell}"
        );
    }
    assert_eq!(stage.run(&["man", "share/man1"]).code, Some(0));
    for name in commands.iter().map(|name| format!("extrados-{name}.1")).chain(["extrados.1".to_owned()]) {
        let page = stage.read(&format!("share/man1/{name}"));
        assert!(page.starts_with(".ie") && page.contains(".TH extrados"), "{name}: {page}");
    }
}
