//! Block models from files and drawings.

use crate::analysis::{blocks_as_built, collapse, collapse_of_blocks};
use crate::samples::bridgemill;
use bridge::{Method, Severity};
use drawing::{Item, Sheet};
use mechanics::watch::Unwatched;
use outcome::collapse::Status;
use outcome::picture::Partner;
use structure::blocks::{Assembled, assemble, of_bridge, toml};
use structure::discretise::discretise;

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
    let points = |c: &outcome::collapse::Collapse| c.picture.thrust_lines.iter().map(Vec::len).collect::<Vec<_>>();
    assert_eq!(points(&of_blocks), points(&of_bridge), "one line of thrust through every joint");
    assert_eq!(blocks_as_built(&scene).shapes.len(), of_blocks.blocks);
}

/// Circles of 0.2 m between three supports, and a plate of a metre on them.
const BOX: &str = r#"
[model]
name = "Box"
[[block]]
material = "stone"
role = "support"
outline_m = [[-0.2, -0.2], [1.2, -0.2], [1.2, 0.0], [-0.2, 0.0]]
[[block]]
material = "stone"
role = "support"
outline_m = [[-0.2, 0.0], [0.0, 0.0], [0.0, 1.0], [-0.2, 1.0]]
[[block]]
material = "stone"
role = "support"
outline_m = [[1.0, 0.0], [1.2, 0.0], [1.2, 1.0], [1.0, 1.0]]
[[block]]
name = "plate"
material = "stone"
outline_m = [[0.05, 0.42], [0.95, 0.42], [0.95, 0.52], [0.05, 0.52]]
[[particles]]
layer = "GRAINS"
material = "gravel"
circles_m = [[0.1, 0.11, 0.1], [0.3, 0.11, 0.1], [0.5, 0.11, 0.1], [0.7, 0.11, 0.1], [0.9, 0.11, 0.1],
    [0.1, 0.31, 0.1], [0.3, 0.31, 0.1], [0.5, 0.31, 0.1], [0.7, 0.31, 0.1], [0.9, 0.31, 0.1]]
[[material]]
name = "stone"
density = "2000 kg/m^3"
compressive_strength = "20 MPa"
[[material]]
name = "gravel"
density = "1800 kg/m^3"
[[joint]]
normal_stiffness = "1 GPa/m"
shear_stiffness = "0.4 GPa/m"
friction_angle = "30 deg"
cohesion = "0 kPa"
[[load]]
block = "plate"
down = "10 kN/m"
[analysis]
method = "dem"
load_step = "10 kN/m"
load_limit = "20 kN/m"
"#;

#[test]
fn circles_in_a_box_come_to_rest_and_carry_a_plate() {
    let scene = read(BOX, None).scene.unwrap();
    let found = collapse_of_blocks(&scene, None, &mut Unwatched).unwrap();
    assert_eq!((found.status, found.particles), (Status::StableToLastLoad, 10));
    assert_eq!((found.picture.particles.len(), found.last_stable_load), (10, Some(20e3)));
    let state = &found.picture.snapshots[found.picture.last_stable.unwrap()];
    // What the floor carries is the load and all weight but for what the walls hold by friction.
    let weight = 9.81 * (10.0 * 1800.0 * std::f64::consts::PI * 0.01 + 2000.0 * 0.9 * 0.1);
    let up = |shape: usize| {
        let forces = state.particle_forces.iter().filter(move |f| f.partner == Partner::Shape(shape));
        // The normal points to the particle; shear is positive along the normal turned left.
        forces.map(|f| f.compression * f.normal[1] + f.shear * f.normal[0]).sum::<f64>()
    };
    let carried = up(0) + up(1) + up(2);
    // Rest is judged at an out-of-balance force of 1e-5 to 1e-4 of the acting ones; some particles carry little.
    assert!((carried - weight - 20e3).abs() < 1e-2 * (weight + 20e3), "{carried} {weight}");
}

#[test]
fn limit_analysis_refuses_particles_and_discrete_elements_ask_for_a_step() {
    let mut scene = read(BOX, None).scene.unwrap();
    scene.plan.load_step = None;
    let missing = collapse_of_blocks(&scene, None, &mut Unwatched).unwrap_err().to_string();
    assert!(missing.contains("load_step") && missing.contains("particles"), "{missing}");
    scene.plan.method = Method::Limit;
    let refused = collapse_of_blocks(&scene, None, &mut Unwatched).unwrap_err().to_string();
    assert!(refused.contains("10 particles"), "{refused}");
}

#[test]
fn circles_over_other_bodies_and_sticking_ones_are_said() {
    for (right, wrong, code, words) in [
        ("[0.3, 0.11, 0.1]", "[0.28, 0.11, 0.1]", "D407", "at (0.1000, 0.1100) m"),
        ("[0.1, 0.11, 0.1]", "[0.1, 0.08, 0.1]", "D407", "into the block BLOCKS 1"),
        ("[0.5, 0.31, 0.1]", "[0.5, 0.47, 0.1]", "D407", "into the block plate"),
        ("cohesion = \"0 kPa\"", "cohesion = \"0 kPa\"\ntensile_strength = \"10 kPa\"", "D408", "tensile"),
        ("\"gravel\"\ncircles", "\"stone\"\ncircles", "D408", "stone and stone"),
    ] {
        assert!(BOX.contains(right), "{right}");
        let assembled = read(&BOX.replacen(right, wrong, 1), None);
        assert!(codes(&assembled).contains(&code), "{wrong}: {:?}", assembled.diagnostics);
        assert!(assembled.diagnostics.iter().any(|d| d.message.contains(words)), "{:?}", assembled.diagnostics);
    }
    // A tenth of the radius is what particles may press on one another.
    assert!(read(&BOX.replacen("[0.3, 0.11, 0.1]", "[0.295, 0.11, 0.1]", 1), None).scene.is_some());
}
