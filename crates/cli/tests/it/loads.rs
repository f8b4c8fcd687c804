//! Loads that nobody can flatter: levels, lanes beside, braking, shallow cover, shorter strips, and files of one's own.

use crate::stage::{Ending, Stage, number};
use serde_json::Value;

/// A 5 m arch of a ring so thick, with further sections.
fn bridge(thickness: &str, cover: &str) -> String {
    format!(
        "[bridge]\nname = \"Base\"\nwidth = \"6.0 m\"\n[[span]]\nprofile = \"segmental\"\nspan = \"5.0 m\"\nrise = \"1.25 m\"\n\
         thickness = \"{thickness} m\"\nvoussoirs = 31\n[masonry]\ndensity = \"2200 kg/m^3\"\ncompressive_strength = \"8 MPa\"\n[joint]\n\
         friction_angle = \"33 deg\"\ncohesion = \"0 kPa\"\n[[cover]]\nlayer = \"fill\"\nthickness = \"{cover} m\"\ndensity = \"1900 kg/m^3\"\n\
         [[cover]]\nlayer = \"surfacing\"\nthickness = \"0.10 m\"\ndensity = \"2300 kg/m^3\"\n[carriageway]\nlanes = 2\n\
         edge_distance = \"0.6 m\"\nskew = \"0 deg\"\n[dispersal]\nrule = \"uniform\"\nslope = \"2:1\"\n"
    )
}

const AXLE: &str = "[[load]]\nname = \"axle\"\nkind = \"axle\"\naxle_force = \"100 kN\"\ncontact_length = \"0.3 m\"\n\
    effective_width = \"3 m\"\nat = \"1/4 of span 1\"\n";

fn sweep(rule: &str, vehicles: &str, more: &str) -> String {
    format!("{AXLE}[sweep]\n{rule}\nvehicles = [{vehicles}]\nstep = \"0.5 m\"\n{more}\n[assess]\nsource = \"CS 454\"\n")
}

fn assessed(stage: &Stage, text: &str) -> (Value, Ending) {
    stage.write("bridge.toml", text);
    stage.object(&["assess", "bridge.toml", "--skip", "sensitivity", "--skip", "service", "--skip", "collapse"])
}

fn vehicle<'a>(answer: &'a Value, code: &str) -> &'a Value {
    let all = answer["vehicles"]["vehicles"].as_array().unwrap_or_else(|| panic!("no vehicles: {answer}"));
    all.iter().find(|one| one["code"] == code).unwrap_or_else(|| panic!("no {code}: {answer}"))
}

/// 44 t means the whole level: no more is carried of it than of the worst of its load cases, and the grade follows.
#[test]
fn a_weight_level_is_carried_when_all_its_cases_are() {
    let stage = Stage::new("loads-level");
    let text = bridge("0.37", "0.40") + &sweep("rule = \"cs-454\"", "\"gb-44t\", \"gb-18t\", \"cs-454\"", "");
    let (answer, _) = assessed(&stage, &text);
    let least = answer["vehicles"]["vehicles"]
        .as_array()
        .expect("vehicles")
        .iter()
        .filter(|one| one["code"].as_str().is_some_and(|code| code.starts_with("cs454")))
        .map(|one| number(one, "adequacy"))
        .fold(f64::INFINITY, f64::min);
    let level = number(vehicle(&answer, "gb-44t"), "adequacy");
    assert!(level <= least * (1.0 + 1e-6), "{level} {least}");
    assert!(least < 1.0 && number(vehicle(&answer, "gb-18t"), "adequacy") > least, "{answer}");
    let grades = answer["vehicles"]["grades"][0][2].as_str().expect("grades");
    assert!(grades.contains("not carried: 44 t"), "{grades}");
    let case = vehicle(&answer, "gb-44t")["case"].as_str().expect("a case");
    assert!(case.contains("cs454-"), "the load case of the level that governs: {case}");
}

/// With a lane beside it, HB leaves less than alone; axles of SV are overloaded as well.
#[test]
fn the_lane_beside_an_abnormal_vehicle_is_loaded() {
    let stage = Stage::new("loads-beside");
    for (code, alone_from) in [("hb-45", "lanes = 1"), ("sv-80", "lanes = 1")] {
        let text = bridge("0.60", "0.40") + &sweep("rule = \"cs-454\"", &format!("\"{code}\""), "");
        let (with, _) = assessed(&stage, &text);
        let (alone, _) = assessed(&stage, &text.replace("lanes = 2", alone_from));
        let factors = [&with, &alone].map(|answer| number(vehicle(answer, code), "adequacy"));
        assert!(factors[0] < 0.95 * factors[1], "{code}: {factors:?}");
        let stands = vehicle(&with, code)["stands"].as_str().expect("how it stands");
        assert!(stands.contains("in the lane beside") && stands.contains("cs454-"), "{stands}");
        let said = with["vehicles"]["assumptions"].to_string();
        assert!(said.contains("In the lanes beside"), "{said}");
        assert!(!vehicle(&alone, code)["stands"].as_str().unwrap().contains("beside"), "nothing without a lane");
    }
    let text = bridge("0.60", "0.40") + &sweep("rule = \"cs-454\"", "\"sv-80\"", "");
    let (answer, _) = assessed(&stage, &text);
    assert!(vehicle(&answer, "sv-80")["impact"].as_str().unwrap().contains("overload 1.2 on the critical axle"));
    assert!((number(vehicle(&answer, "sv-80"), "load_factor") - 1.1 * 1.16 * 1.1).abs() < 1e-9);
}

/// What a rule asks for, whether braking is written and why, and which load cases were not moved are data.
#[test]
fn what_a_rule_asks_for_reaches_the_result() {
    let stage = Stage::new("loads-requires");
    let asks = |answer: &Value, what: &str| {
        let list = answer["vehicles"]["requires"].as_array().expect("requires");
        list.iter()
            .any(|one| one["what"] == what && one["source"]["text"].as_str().is_some_and(|text| !text.is_empty()))
    };
    let rail = |more: &str| bridge("0.75", "0.40") + &sweep("rule = \"en-1991-2\"", "\"lm71\"", more);
    let (without, _) = assessed(&stage, &rail(""));
    assert!(asks(&without, "braking") && asks(&without, "strength"), "{without}");
    assert!(without["vehicles"]["braking"].is_null(), "{without}");
    let (with, _) = assessed(&stage, &rail("braking = 0\nbraking_reason = \"long track\""));
    assert_eq!(
        (number(&with["vehicles"], "braking"), &with["vehicles"]["braking_reason"]),
        (0.0, &"long track".into())
    );
    // Next to none is none, and why it may be left out stands beside the verdict.
    let said = |answer: &Value, what: &str| {
        answer["beside"].to_string().contains(what) || answer["missing"].to_string().contains(what)
    };
    assert!(said(&with, "braking 0: long track"), "{with}");
    let (next_to_none, _) = assessed(&stage, &rail("braking = 1e-9"));
    assert!(said(&next_to_none, "no reason for braking = 0.000000001"), "{next_to_none}");
    let text = bridge("0.45", "0.40") + &sweep("rule = \"cs-454\"", "\"cs454-single\"", "");
    let (one, _) = assessed(&stage, &text);
    assert!(!asks(&one, "braking"), "{one}");
    let missing = one["vehicles"]["load_cases_missing"].as_array().expect("missing").len();
    assert_eq!(missing, 5, "{one}");
    let (all, _) = assessed(&stage, &text.replace("cs454-single", "cs-454"));
    assert_eq!(all["vehicles"]["load_cases_missing"].as_array().map(Vec::len), Some(0));
}

/// Under less than 2 ft of cover AASHTO spreads nothing, whatever the cover is; above it loads spread.
#[test]
fn shallow_cover_spreads_nothing_by_aashto() {
    let stage = Stage::new("loads-shallow");
    let width = |cover: &str| {
        let text = bridge("0.45", cover) + &sweep("rule = \"aashto-mbe\"", "\"aashto-type-3\"", "");
        let (answer, _) =
            assessed(&stage, &text.replace("lanes = 2", "lanes = 1").replace("edge_distance = \"0.6 m\"\n", ""));
        number(vehicle(&answer, "aashto-type-3"), "effective_width_m")
    };
    let [shallow, less, deep] = ["0.15", "0.30", "0.55"].map(width);
    assert!((shallow - less).abs() < 1e-9, "{shallow} {less}");
    assert!(deep > shallow + 0.5, "{shallow} {deep}");
}

/// A uniform load may be shorter: half of it or all of it, the least factor counts; a stack of material stays as it is.
#[test]
fn a_uniform_load_is_shortened_where_that_does_more_harm() {
    let stage = Stage::new("loads-patch");
    let factor = |length: &str, fixed: &str| {
        let load = format!(
            "[[load]]\nname = \"udl\"\nkind = \"patch\"\npressure = \"100 kPa\"\nlength = \"{length} m\"\n{fixed}at = \"1/4 of span 1\"\n"
        );
        let limits = "[assess]\nsource = \"CS 454\"\nadequacy_factor = 2.0\nadequacy_source = \"CS 454, 7.3\"\n";
        stage.write("bridge.toml", bridge("0.45", "0.40") + &load + limits);
        let (answer, _) = stage.object(&["assess", "bridge.toml", "--skip", "sensitivity", "--skip", "service"]);
        let check =
            answer["checks"].as_array().expect("checks").iter().find(|one| one["code"] == "C201").expect("C201");
        (number(check, "value"), answer)
    };
    let (half, _) = factor("2.5", "");
    let (full, answer) = factor("5", "");
    assert!(full <= half * (1.0 + 1e-3), "what half of it does, all of it may do: {half} {full}");
    let part = &answer["shortened"][0];
    assert!(number(part, "length_m") < 4.0 && number(part, "of_m") == 5.0, "{part}");
    let (fixed, answer) = factor("5", "whole_length = true\n");
    assert!(fixed > 1.2 * full && answer["shortened"].as_array().is_some_and(Vec::is_empty), "{fixed} {full}");
}

const LORRY: &str = "code = \"lorry\"\ntitle = \"Lorry\"\nways = \"road\"\nsource = { text = \"C&U\", date = \"1986\", confidence = \"read\" }\n\
    [[vehicle]]\ncode = \"our-lorry\"\ntitle = \"Lorry 44 t\"\naxle_loads_kn = [68.7, 103.0, 57.0, 67.7, 67.7, 67.7]\n\
    spacings_m = [3.0, 1.3, 5.0, 1.35, 1.35]\naxles_may_be_dropped = true\nwheel_track_m = 1.80\ncontact_length_m = 0.30\n\
    [[under]]\nrule = \"cs-454\"\nlive_load = { value = 1.0, source = { text = \"x\", date = \"2020\", confidence = \"recalled\" } }\n\
    [under.impact]\nkind = \"included\"\nsource = { text = \"x\", date = \"2020\", confidence = \"recalled\" }\n";

/// The factor that acted, what differs from the rule's, and doubtful values of a vehicle's own file are data.
#[test]
fn files_of_vehicles_are_told_with_their_factors_and_doubts() {
    let stage = Stage::new("loads-lorry");
    let text =
        bridge("0.45", "0.40") + &sweep("rule = \"cs-454\"", "\"our-lorry\"", "vehicle_files = [\"lorry.toml\"]");
    stage.write("lorry.toml", LORRY);
    let (answer, _) = assessed(&stage, &text);
    let own = vehicle(&answer, "our-lorry");
    assert_eq!((number(own, "live_load"), &own["factors_of_vehicle_file"]), (1.0, &true.into()));
    let changed = answer["vehicles"]["safety"]["changed_factors"].as_array().expect("changed");
    let live =
        changed.iter().find(|one| one["factor"] == "live load on lorry").unwrap_or_else(|| panic!("{changed:?}"));
    assert_eq!((&live["library"], &live["file"]), (&"1.9".into(), &"1".into()));
    assert!(answer["vehicles"]["doubtful"].as_array().is_some_and(Vec::is_empty), "{answer}");
    stage
        .write("lorry.toml", LORRY.replace("[68.7, 103.0, 57.0, 67.7, 67.7, 67.7]", "[7.0, 10.5, 5.8, 6.9, 6.9, 6.9]"));
    let (answer, _) = assessed(&stage, &text);
    assert_eq!(answer["vehicles"]["doubtful"][0]["code"], "P080", "{answer}");
    stage.write("lorry.toml", LORRY.replace("wheel_track_m = 1.80", "wheel_track_m = 1800"));
    let (answer, ending) = assessed(&stage, &text);
    assert_eq!(ending.code, Some(2), "{answer}");
}

/// What a rule file changes of the library's rule is listed, and an impossible factor refused.
#[test]
fn a_rule_file_is_held_against_the_library() {
    let stage = Stage::new("loads-rule");
    let library =
        include_str!("../../../rules/data/rules/cs-454.toml").replacen("code = \"cs-454\"", "code = \"our-rule\"", 1);
    let text = bridge("0.45", "0.40") + &sweep("rule_file = \"own.toml\"", "\"cs454-single\"", "");
    stage
        .write("own.toml", library.replacen("[factors.live_load]\nvalue = 1.9", "[factors.live_load]\nvalue = 1.2", 1));
    let (answer, _) = assessed(&stage, &text);
    let safety = &answer["vehicles"]["safety"];
    assert_eq!((&safety["rule_file"], &safety["based_on"]), (&"own.toml".into(), &"cs-454".into()), "{safety}");
    let changed = safety["changed_factors"].as_array().expect("changed");
    assert!(changed.iter().any(|one| one["factor"] == "live load" && one["file"] == "1.2"), "{changed:?}");
    let requires = answer["vehicles"]["requires"].as_array().expect("requires").len();
    stage.write("own.toml", library.replace("[[requires]]\nwhat = \"strength\"", "[[requires]]\nwhat = \"skew\""));
    let (answer, _) = assessed(&stage, &text);
    assert!(
        answer["vehicles"]["requires"].as_array().expect("requires").len() >= requires,
        "the library's rule still asks"
    );
    stage
        .write("own.toml", library.replacen("[factors.condition]\nvalue = 1.0", "[factors.condition]\nvalue = 2.0", 1));
    let (answer, ending) = assessed(&stage, &text);
    assert_eq!(ending.code, Some(2), "{answer}");
}

/// Factors of `[assess]` that no standard has are refused, and a force over more width than an axle spreads over is doubted.
#[test]
fn flattering_limits_and_widths_are_refused_or_doubted() {
    let stage = Stage::new("loads-limits");
    for limits in ["adequacy_factor = 0.1", "adequacy_factor = 1.0\nload_factor_included = 20", "adequacy_factor = 5"] {
        let (answer, ending) = assessed(&stage, &(bridge("0.45", "0.40") + AXLE + "[assess]\n" + limits + "\n"));
        assert_eq!(ending.code, Some(2), "{limits}: {answer}");
    }
    let edge = |force: &str| {
        let load = format!(
            "[[load]]\nname = \"axle\"\nkind = \"knife-edge\"\nforce = \"{force}\"\nlength = \"0.3 m\"\nat = \"1/4 of span 1\"\n"
        );
        let wide = bridge("0.45", "0.40").replace("width = \"6.0 m\"", "width = \"12.0 m\"");
        stage.write("bridge.toml", wide + &load + "[assess]\nsource = \"a\"\n");
        let (answer, _) = stage.object(&["check", "bridge.toml"]);
        answer["warnings"].to_string().contains("P032")
    };
    assert!(edge("100 kN") && !edge("25 kN/m"));
    // So is an axle, which spreads over 1.8 + 1.5 + 0.5 m here, and cover through which nothing is left of it.
    let doubted = |cover: &str, width: &str, code: &str| {
        let axle = AXLE.replace("effective_width = \"3 m\"", &format!("effective_width = \"{width}\""));
        stage.write("bridge.toml", bridge("0.45", cover) + &axle + "[assess]\nsource = \"a\"\n");
        stage.object(&["check", "bridge.toml"]).0["warnings"].to_string().contains(code)
    };
    assert!(doubted("0.40", "4.5 m", "P032") && !doubted("0.40", "3 m", "P032"));
    assert!(doubted("4.00", "3 m", "P034") && !doubted("0.40", "3 m", "P034"));
    for (old, new) in [("2200 kg/m^3", "22000 kg/m^3"), ("\"8 MPa\"", "\"8 GPa\"")] {
        let (answer, ending) = assessed(&stage, &(bridge("0.45", "0.40").replacen(old, new, 1) + AXLE));
        assert_eq!(ending.code, Some(2), "{new}: {answer}");
    }
}
