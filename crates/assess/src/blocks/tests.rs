//! Block models from files and drawings.

use super::{Assembled, assemble, of_bridge, toml};
use crate::analysis::{blocks_as_built, collapse, collapse_of_blocks};
use crate::discretise::discretise;
use crate::samples::bridgemill;
use bridge::{Method, Severity};
use drawing::{Item, Sheet};
use mechanics::watch::Unwatched;

/// Three blocks of a metre in a column between a floor and nothing.
const COLUMN: &str = r#"
[model]
name = "Column"
[drawing]
file = "column.dxf"
[[drawing.layer]]
name = "floor"
role = "support"
material = "stone"
[[drawing.layer]]
name = "STONES"
role = "block"
material = "stone"
[[material]]
name = "stone"
density = "2000 kg/m^3"
compressive_strength = "unlimited"
[[joint]]
friction_angle = "35 deg"
cohesion = "0 kPa"
[[load]]
layer = "STONES"
right = "1 kN/m"
"#;

fn square(x: f64, y: f64, width: f64) -> Vec<[f64; 2]> {
    vec![[x, y], [x + width, y], [x + width, y + 1.0], [x, y + 1.0]]
}

fn column(more: &[Item]) -> Vec<u8> {
    let item = |layer: &str, points| Item::Line { layer: layer.into(), points, closed: true };
    let mut items = vec![item("FLOOR", square(-1.0, -1.0, 3.0))];
    items.extend((0..3).map(|k| item("STONES", square(0.0, f64::from(k), 1.0))));
    items.extend(more.iter().cloned());
    Sheet { layers: Vec::new(), items }.dxf()
}

fn read(text: &str, dxf: Option<&[u8]>) -> Assembled {
    let read = bridge::read_blocks(text.as_bytes());
    let file = read.file.unwrap_or_else(|| panic!("{:?}", read.diagnostics));
    assemble(&file, dxf)
}

fn codes(assembled: &Assembled) -> Vec<&str> {
    let errors = assembled.diagnostics.iter().filter(|d| d.severity == Severity::Error);
    errors.map(|d| d.code).collect()
}

#[test]
fn a_column_pushed_by_its_weight_overturns_at_its_slope() {
    let assembled = read(COLUMN, Some(&column(&[])));
    let scene = assembled.scene.unwrap();
    assert_eq!(scene.bodies.iter().filter(|b| b.held).count(), 1);
    assert_eq!(scene.bodies[1].name, "STONES 1");
    let found = collapse_of_blocks(&scene, None, &mut Unwatched).unwrap();
    // Pushed sideways in proportion to its mass, the column of 1 m by 3 m turns about its toe: a third of its weight.
    let weight = 3.0 * 2000.0 * 9.81;
    let load = found.collapse_load.unwrap();
    assert!((load - weight / 3.0).abs() < 1e-6 * weight, "{load}");
}

#[test]
fn layers_and_entries_must_fit_one_another() {
    let line = Item::Line { layer: "WALL".into(), points: square(5.0, 0.0, 1.0), closed: true };
    let circle = Item::Circle { layer: "STONES".into(), centre: [9.0, 0.0], radius: 0.5 };
    let strange = read(COLUMN, Some(&column(&[line, circle])));
    assert_eq!(codes(&strange), ["D401", "D403"]);
    let unmapped = &strange.diagnostics[0];
    assert!(unmapped.message.contains("WALL") && unmapped.message.contains("1 outline"), "{}", unmapped.message);
    assert!(unmapped.help.as_ref().unwrap().contains("name = \"WALL\", role = \"block\""), "{:?}", unmapped.help);
    let absent = COLUMN.replace("name = \"floor\"", "name = \"ground\"");
    assert_eq!(codes(&read(&absent, Some(&column(&[])))), ["D401", "D402"]);
    let grains = COLUMN.replace("role = \"block\"", "role = \"particles\"");
    assert!(codes(&read(&grains, Some(&column(&[])))).contains(&"D403"));
}

#[test]
fn loads_find_their_blocks_or_say_so() {
    let at = |load: &str| COLUMN.replace("layer = \"STONES\"\nright", &format!("{load}\nright"));
    let found = |load: &str| read(&at(load), Some(&column(&[])));
    // On an edge, and 0.4 mm outside of it.
    for place in ["x = \"1 m\"\ny = \"2.5 m\"", "x = \"1.0004 m\"\ny = \"2.5 m\"", "block = \"STONES 3\""] {
        let scene = found(place).scene.unwrap();
        assert_eq!(scene.bodies[scene.forces[0].body].name, "STONES 3");
    }
    for (place, words) in [
        ("x = \"1.5 m\"\ny = \"2.5 m\"", "STONES 3, 0.5000 m"),
        ("x = \"-0.5 m\"\ny = \"-0.5 m\"", "STONES 1"),
        ("block = \"FLOOR 1\"", "free block"),
        ("block = \"KEYSTONE\"", "STONES 1"),
        ("layer = \"FLOOR\"", "another layer"),
    ] {
        let wrong = found(place);
        let help = wrong.diagnostics[0].help.clone().unwrap();
        assert_eq!(codes(&wrong), ["D404"], "{place}");
        assert!(help.contains(words) || words == "STONES 1", "{place}: {help}");
    }
}

#[test]
fn pairs_without_a_joint_and_blocks_without_a_core_are_refused() {
    let bare = COLUMN.replace("[[joint]]", "[[joint]]\nfirst = \"stone\"\nsecond = \"stone\"");
    assert!(read(&bare, Some(&column(&[]))).scene.is_some());
    let two = COLUMN.replace("material = \"stone\"\n[[drawing", "material = \"brick\"\n[[drawing")
        + "[[material]]\nname = \"brick\"\ndensity = \"1800 kg/m^3\"\n";
    assert!(read(&two, Some(&column(&[]))).scene.is_some(), "one joint for all pairs");
    let lacking = two.replace("[[joint]]", "[[joint]]\nfirst = \"stone\"");
    assert_eq!(codes(&read(&lacking, Some(&column(&[])))), ["D405"]);
    let round = COLUMN.replace("density = \"2000 kg/m^3\"", "density = \"2000 kg/m^3\"\nrounding = \"0.6 m\"");
    assert!(codes(&read(&round, Some(&column(&[])))).contains(&"D405"));
}

#[test]
fn a_refused_drawing_gives_no_model_and_says_all() {
    let open = Item::Line { layer: "STONES".into(), points: square(7.0, 0.0, 1.0), closed: false };
    let assembled = read(COLUMN, Some(&column(&[open])));
    assert!(assembled.scene.is_none());
    assert!(assembled.findings.iter().any(|f| f.code == "D301"));
}

#[test]
fn a_written_model_is_read_to_the_same_bits() {
    let bridge = bridgemill();
    let scene = of_bridge(&bridge, &discretise(&bridge).unwrap());
    let again = read(&toml(&scene), None).scene.unwrap();
    assert_eq!((&again.bodies, &again.forces, &again.plan), (&scene.bodies, &scene.forces, &scene.plan));
    assert_eq!(again.materials, scene.materials);
    assert_eq!(again.discretised().model, scene.discretised().model);
    // Once more, to the same text.
    assert_eq!(toml(&again), toml(&scene));
}

#[test]
fn the_blocks_of_a_bridge_carry_what_the_bridge_does() {
    let mut bridge = bridgemill();
    bridge.plan.method = Method::Limit;
    let scene = of_bridge(&bridge, &discretise(&bridge).unwrap());
    let of_bridge = collapse(&bridge, None, &mut Unwatched).unwrap();
    let of_blocks = collapse_of_blocks(&scene, None, &mut Unwatched).unwrap();
    let (a, b) = (of_bridge.collapse_load.unwrap(), of_blocks.collapse_load.unwrap());
    // The solver's own tolerance.
    assert!((a - b).abs() < 1e-6 * a, "{a} {b}");
    let points = |c: &crate::analysis::Collapse| c.picture.thrust_lines.iter().map(Vec::len).collect::<Vec<_>>();
    assert_eq!(points(&of_blocks), points(&of_bridge), "one line of thrust through every joint");
    assert_eq!(blocks_as_built(&scene).shapes.len(), of_blocks.blocks);
}
