//! Roads that are not level: felt, drawn, and refused where they are not known.

use crate::stage::{Stage, number};

const HUMP: &str = include_str!("../../../bridge/tests/it/files/road.toml");

#[test]
fn a_hump_is_drawn_and_carried() {
    let stage = Stage::new("roads-hump");
    stage.write("hump.toml", HUMP);
    let (found, _) = stage.object(&["collapse", "hump.toml", "--method", "limit"]);
    let words = found["assumptions"].to_string();
    // 102.62 m less 99.80 m less the rise and the ring, 2.46 m.
    assert!(words.contains("the least over a crown, 0.360 m"), "{words}");
    assert!(stage.read("out/hump/bridge.svg").contains("0.36 m"));
    // A road as high over the haunches as over the crown weighs more on them, and spreads the load further.
    stage.write("high.toml", HUMP.replace("102.10 m", "102.62 m").replace("102.30 m", "102.62 m"));
    let (high, _) = stage.object(&["collapse", "high.toml", "--method", "limit"]);
    let carried = |answer| number(answer, "last_stable_load_kn_per_m");
    assert!(carried(&high) > 1.02 * carried(&found), "{} {}", carried(&high), carried(&found));
    // The same road without levels.
    let level = HUMP
        .split("[road]")
        .next()
        .unwrap_or_default()
        .replace("layer = \"fill\"", "layer = \"fill\"\nthickness = \"0.26 m\"");
    let rest = HUMP.split_once("[dispersal]").map_or("", |parts| parts.1);
    stage.write("level.toml", format!("{level}\n[dispersal]{rest}"));
    let (level, _) = stage.object(&["collapse", "level.toml", "--method", "limit"]);
    assert!((carried(&level) / carried(&high) - 1.0).abs() < 1e-9, "{} {}", carried(&level), carried(&high));
}

#[test]
fn roads_that_cannot_lie_there_are_named_with_their_place() {
    let stage = Stage::new("roads-wrong");
    for (from, to, code, words) in [
        ("99.80 m", "109.80 m", "B226", "below the extrados of span 1"),
        ("102.62 m", "102.31 m", "B226", "the layers above the fill need 0.100 m"),
        ("[\"4 m\"", "[\"-8 m\"", "B226", "from left to right"),
        ("layer = \"fill\"", "layer = \"fill\"\nthickness = \"0.2 m\"", "B016", "exclude one another"),
        ("thickness = \"0.10 m\"", "", "B011", "thickness"),
        ("[road]", "[raod]", "B010", "road"),
    ] {
        stage.write("wrong.toml", HUMP.replace(from, to));
        let ending = stage.run(&["check", "wrong.toml"]);
        assert!(
            ending.code == Some(2) && ending.stderr.contains(code) && ending.stderr.contains(words),
            "{to}: {}",
            ending.stderr
        );
    }
}

#[test]
fn roads_that_are_not_level_are_refused_where_they_are_not_known() {
    let stage = Stage::new("roads-refused");
    let road = "\n[road]\nlevels = [[\"-5 m\", \"4.0 m\"], [\"9 m\", \"4.2 m\"]]\n";
    let particles = include_str!("../../../bridge/tests/it/files/particles.toml");
    let continuum = include_str!("../../../bridge/tests/it/files/continuum.toml");
    for (name, text, method) in [("particles", particles, "dem"), ("continuum", continuum, "limit")] {
        let lowest = text.lines().position(|line| line.starts_with("[[cover]]")).expect("a layer");
        let under = |(k, line): (usize, &str)| {
            (k < lowest || !line.starts_with("thickness") || k > lowest + 6).then(|| format!("{line}\n"))
        };
        let text: String = text.lines().enumerate().filter_map(under).collect();
        stage.write(&format!("{name}.toml"), format!("{text}{road}"));
        let ending = stage.run(&["collapse", &format!("{name}.toml"), "--method", method]);
        assert!(ending.code == Some(2) && ending.stderr.contains("none but a level one"), "{name}: {}", ending.stderr);
    }
}
