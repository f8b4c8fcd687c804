//! Block model files: read, and every mistake said with its place.

use bridge::fields::{Kind, Need, blocks, sections_of};
use bridge::{Severity, is_block_file, read_blocks};
use proptest::prelude::*;

/// Every key there is.
const GOOD: &str = r#"
[model]
name = "Wall"
width = "2 m"
gravity = "9.81 m/s^2"
[drawing]
file = "wall.dxf"
unit = "mm"
chord_tolerance = "2 mm"
gap_tolerance = "3 mm"
concave = "cut"
[[drawing.layer]]
name = "STONES"
role = "block"
material = "stone"
[[drawing.layer]]
name = "NOTES"
role = "ignore"
[[material]]
name = "stone"
density = "2000 kg/m^3"
elastic_modulus = "15 GPa"
poisson_ratio = 0.2
compressive_strength = "40 MPa"
rounding = "5 mm"
[[material]]
name = "brick"
density = "1800 kg/m^3"
elastic_modulus = "5 GPa"
poisson_ratio = 0.2
[[joint]]
first = "brick"
second = "stone"
normal_stiffness = "4 GPa/m"
shear_stiffness = "1 GPa/m"
friction_angle = "30 deg"
cohesion = "1 kPa"
tensile_strength = "1 kPa"
fixed_length = "0.1 m"
least_length = "0.01 m"
[[joint]]
mortar_normal_stiffness = "4 GPa/m"
mortar_shear_stiffness = "1 GPa/m"
friction_angle = "35 deg"
cohesion = "0 kPa"
[[block]]
name = "lintel"
layer = "STONES"
material = "stone"
role = "support"
outline_m = [[0, 0], [1.5, 0.0], [1.5, 0.5], [0, 0.5]]
[[particles]]
layer = "FILL"
material = "brick"
circles_m = [[0.5, 2.0, 0.05], [0.7, 2.0, 0.05]]
[[load]]
name = "push"
x = "1.5 m"
y = "0.2 m"
right = "4 kN"
[[load]]
layer = "STONES"
down = "1 kN/m"
permanent = true
[[load]]
block = "lintel"
down = "1 kN/m"
[analysis]
method = "dem"
load_step = "1 kN/m"
"#;

#[test]
fn the_whole_file_is_read_in_si() {
    let read = read_blocks(GOOD.as_bytes());
    assert_eq!(read.diagnostics, []);
    let file = read.file.unwrap();
    let drawing = file.drawing.unwrap();
    assert_eq!((drawing.unit, drawing.chord_tolerance, drawing.gap_tolerance), (Some(1e-3), 2e-3, 3e-3));
    assert!(drawing.cut_concave && drawing.layers.len() == 2);
    assert_eq!(file.joints[0].between, Some([0, 1]));
    assert_eq!(file.joints[1].between, None);
    assert_eq!(file.loads[0].force, [2e3, 0.0]);
    assert_eq!((file.loads[1].force, file.loads[1].permanent), ([0.0, -1e3], true));
    assert_eq!(file.blocks[0].outline[2], [1.5, 0.5]);
    assert_eq!(file.particles[0].circles.len(), 2);
}

#[test]
fn every_key_of_the_cards_is_in_the_file_above() {
    for section in sections_of(&blocks::FILE).into_iter().filter(|section| section.path != "analysis") {
        for field in section.fields.iter().filter(|f| !matches!(f.kind, Kind::Table(_) | Kind::Tables(_))) {
            assert!(GOOD.contains(&format!("\n{} = ", field.key)), "{}.{}", section.path, field.key);
        }
        assert!(section.fields.iter().all(|f| !f.doc.is_empty() && f.need != Need::Optional("")));
    }
}

#[test]
fn every_mistake_has_its_code_and_place() {
    for (right, wrong, code) in [
        ("role = \"block\"", "role = \"blok\"", "B013"),
        ("material = \"stone\"\n[[drawing", "[[drawing", "B011"),
        ("material = \"stone\"\n[[drawing", "material = \"ston\"\n[[drawing", "B013"),
        ("role = \"ignore\"", "role = \"ignore\"\nmaterial = \"stone\"", "B015"),
        ("unit = \"mm\"", "unit = \"mil\"", "B013"),
        ("chord_tolerance = \"2 mm\"", "chord_tolerance = 2", "B101"),
        ("[0, 0.5]]", "[0, \"0.5\"]]", "B012"),
        ("[0, 0.5]]", "[0, 0.5, 1]]", "B012"),
        ("[0, 0.5]]", "[0, 1e9]]", "B106"),
        ("[0, 0.5]]", "[0, nan]]", "B106"),
        ("0.05]]", "-0.05]]", "B107"),
        ("y = \"0.2 m\"\n", "", "B011"),
        ("block = \"lintel\"\n", "", "B011"),
        ("block = \"lintel\"", "block = \"lintel\"\nlayer = \"STONES\"", "B016"),
        ("right = \"4 kN\"\n", "", "B011"),
        ("first = \"brick\"\n", "", "B011"),
        ("first = \"brick\"\nsecond = \"stone\"\n", "", "D405"),
        ("name = \"brick\"", "name = \"stone\"", "D405"),
        ("normal_stiffness = \"4 GPa/m\"\nshear", "shear", "B401"),
        ("elastic_modulus = \"5 GPa\"\n", "", "B401"),
        ("load_step = \"1 kN/m\"", "", "B401"),
        ("method = \"dem\"", "method = \"dem\"\nanalysis = \"thickness\"", "D405"),
        ("file = \"wall.dxf\"", "fiel = \"wall.dxf\"", "B010"),
    ] {
        assert!(GOOD.contains(right), "{right}");
        let text = GOOD.replacen(right, wrong, 1);
        let read = read_blocks(text.as_bytes());
        let found = read.diagnostics.iter().find(|finding| finding.code == code);
        let found = found.unwrap_or_else(|| panic!("{wrong}: {:?}", read.diagnostics));
        assert!(found.severity == Severity::Error && read.file.is_none());
        assert!(found.help.as_ref().is_some_and(|help| !help.is_empty()) && found.range.end <= text.len());
    }
}

#[test]
fn kinds_of_files_are_told_apart() {
    assert!(is_block_file(GOOD.as_bytes()) && is_block_file(b"[drawing]\n") && is_block_file(b"[model\n[[block]]\n"));
    for other in ["", "[bridge]\n", "[[span]]\n[[block]]\n", "\u{0}", "[joint]\n"] {
        assert!(!is_block_file(other.as_bytes()), "{other}");
    }
    assert!(!is_block_file(b"\xff"));
}

#[test]
fn the_example_of_the_guide_reads() {
    let guide = include_str!("../../../../docs/input/drawings.md");
    let example = guide.split("```toml\n").nth(1).and_then(|rest| rest.split("```").next()).unwrap();
    let read = read_blocks(example.as_bytes());
    assert!(read.file.is_some() && read.diagnostics.is_empty(), "{:?}", read.diagnostics);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn changed_files_are_answered(changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6)) {
        let mut bytes = GOOD.as_bytes().to_vec();
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        let read = read_blocks(&bytes);
        let refused = read.diagnostics.iter().any(|finding| finding.severity == Severity::Error);
        prop_assert_eq!(read.file.is_none(), refused);
    }

    #[test]
    fn lines_taken_away_are_answered(drop in prop::collection::vec(any::<prop::sample::Index>(), 1..8)) {
        let mut lines: Vec<&str> = GOOD.lines().collect();
        for at in drop {
            let at = at.index(lines.len());
            lines.remove(at);
        }
        let read = read_blocks(lines.join("\n").as_bytes());
        let refused = read.diagnostics.iter().any(|finding| finding.severity == Severity::Error);
        prop_assert_eq!(read.file.is_none(), refused);
    }
}

#[test]
fn what_a_block_model_leaves_out_is_said() {
    let codes = |text: &str| -> Vec<&str> { read_blocks(text.as_bytes()).diagnostics.iter().map(|f| f.code).collect() };
    assert_eq!(codes(&GOOD.replacen("width = \"2 m\"\n", "", 1)), ["P028"]);
    assert_eq!(codes(&GOOD.replacen("role = \"support\"", "role = \"block\"", 1)), ["P029"]);
    let without = GOOD.split("[[load]]").next().expect("the rest");
    assert!(codes(without).contains(&"P030"), "{:?}", codes(without));
}
