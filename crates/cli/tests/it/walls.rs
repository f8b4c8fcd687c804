//! A bridge with spandrel walls: both strips, their sum, their files; what cannot stand is refused in words.

use crate::stage::{Stage, number, object};

fn bridge() -> String {
    let text = include_str!("../../../../verification/walls/spandrel-wall-dem/bridge.toml");
    text.replace("method = \"dem\"", "method = \"limit\"").replace("strip = \"wall\"", "strip = \"both\"")
}

#[test]
fn both_strips_and_their_sum_stand_in_the_answer() {
    let stage = Stage::new("walls-both");
    stage.write("b.toml", bridge());
    let ending = stage.run(&["collapse", "b.toml", "--out", "o", "--details"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    for line in ["  fill  ", "  wall  ", "  both  "] {
        assert!(ending.stdout.contains(line), "{line} is not in\n{}", ending.stdout);
    }
    let answer = object(&stage.read("o/result.json"));
    let fill = number(&answer, "collapse_load_kn_per_m");
    let wall = number(&answer["wall_strip"], "collapse_load_kn_per_m");
    let sum = &answer["combination"];
    let widths: Vec<f64> = (0..2).map(|k| number(&sum["components"][k], "width_m")).collect();
    assert_eq!(widths, [3.5, 0.5]);
    let total = number(sum, "total_kn");
    assert!((total - 3.5 * fill - 0.5 * wall).abs() < 1e-9 * total);
    assert!(wall > fill);
    let names = stage.names("o/wall");
    for name in ["bridge.svg", "mechanism.png", "hinges.csv", "paraview"] {
        assert!(names.iter().any(|there| there == name), "{name} is not among {names:?}");
    }
    assert!(answer["warnings"].as_array().expect("warnings").iter().any(|w| w["code"] == "A114"));
}

#[test]
fn an_interrupted_run_of_both_strips_goes_on_to_the_same_numbers() {
    let text = bridge().replace("method = \"limit\"", "method = \"dem\"").replace("\"5 kN/m\"", "\"50 kN/m\"");
    let text = text.replace("\"150 GPa/m\"", "\"5 GPa/m\"").replace("\"75 GPa/m\"", "\"2 GPa/m\"");
    let stage = Stage::new("walls-resume");
    stage.write("b.toml", &text);
    let (whole, _) = stage.object(&["collapse", "b.toml", "--out", "whole"]);
    let mut child = stage
        .command(&["collapse", "b.toml", "--out", "cut", "--keep-every", "0.02", "--json", "--quiet"])
        .stdout(std::process::Stdio::null())
        .stderr(std::process::Stdio::null())
        .spawn()
        .expect("starts");
    // Until it has kept something, or is through.
    let kept = stage.folder.join("cut/run.checkpoint");
    while !kept.exists() && child.try_wait().expect("a child").is_none() {
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    let _ = child.kill();
    let _ = child.wait();
    let (resumed, ending) = stage.object(&["collapse", "b.toml", "--out", "cut", "--resume"]);
    assert_eq!(ending.code, Some(0), "{}", ending.stderr);
    assert_eq!(resumed["combination"], whole["combination"]);
}

/// Limit loads of the example's walls without dilation and with it, and the least behind the first, with this in their section.
fn limit_loads(stage: &Stage, change: &str) -> [f64; 3] {
    let text = include_str!("../../../../examples/bridgemill/case-4.toml");
    stage.write("wall.toml", text.replace("[spandrel_wall]", &format!("[spandrel_wall]\n{change}")));
    let (answer, _) = stage.object(&["collapse", "wall.toml", "--method", "limit", "--out", "o"]);
    let least = answer["non_associated_spread_kn_per_m"][0].as_f64().expect("it comes and goes");
    [number(&answer, "limit_load_kn_per_m"), number(&answer, "associated_load_kn_per_m"), least]
}

/// Rows of `docs/verification/spandrel-wall.md`, which prints a tenth of a kN/m.
#[test]
fn walls_carry_by_limit_analysis_what_their_page_prints() {
    let stage = Stage::new("walls-page");
    let page = include_str!("../../../../docs/verification/spandrel-wall.md");
    let [road, dilating, least] = limit_loads(&stage, "");
    let sentence = format!("gives {road:.1} kN/m without dilation and {dilating:.1} with it");
    assert!(page.contains(&sentence), "{sentence}");
    assert!(page.contains(&format!("| none: `case-4.toml` | 578.31 | | {least:.1} |")), "{least}");
    let [fill, _, behind] = limit_loads(&stage, "top = \"0.203 m\"");
    assert!(page.contains(&format!("| none | 421.69 | {behind:.1} |")), "{behind}");
    assert!(
        page.contains(&format!("the example {road:.1}, and {fill:.1} with its wall up to 0.203 m")),
        "{road} {fill}"
    );
    assert!((road - 716.70).abs() < 0.05 && (fill - 505.35).abs() < 0.05, "{road} {fill}");
}

#[test]
fn a_loading_block_on_cover_and_a_wall_that_is_not_there_are_refused_with_their_place() {
    let stage = Stage::new("walls-refused");
    let block = "length = \"0.5 m\"\nthrough = \"block\"\nblock_weight = \"10 kN/m\"";
    stage.write("block.toml", bridge().replace("length = \"0.5 m\"\nat", &format!("{block}\nat")));
    let refused = stage.run(&["check", "block.toml"]);
    assert_eq!(refused.code, Some(2));
    assert!(refused.stderr.contains("B305") && refused.stderr.contains("through"), "{}", refused.stderr);
    let text = bridge();
    let (start, end) = (text.find("[spandrel_wall]").expect("wall"), text.find("[dispersal]").expect("dispersal"));
    stage.write("none.toml", format!("{}{}", &text[..start], &text[end..]));
    let refused = stage.run(&["check", "none.toml"]);
    assert_eq!(refused.code, Some(2));
    assert!(refused.stderr.contains("B406"), "{}", refused.stderr);
    // A top so low that no brick finds room above the crown.
    stage.write("low.toml", bridge().replace("thickness = \"0.5 m\"", "thickness = \"0.5 m\"\ntop = \"0.01 m\""));
    let refused = stage.run(&["check", "low.toml"]);
    assert_eq!(refused.code, Some(2));
    assert!(refused.stderr.contains("x = ") && refused.stderr.contains("`top`"), "{}", refused.stderr);
}
