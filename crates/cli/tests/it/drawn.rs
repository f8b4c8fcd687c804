//! What drawings of a bridge show: every dimension, every layer, thrust in rings and piers, and which case of a sweep is drawn.

use crate::stage::Stage;

const BRIDGE: &str = r#"
bridge = { name = "Backed", width = "3.0 m" }
masonry = { density = "2200 kg/m^3", compressive_strength = "10 MPa" }
joint = { friction_angle = "35 deg", cohesion = "0 kPa" }
cover = [
    { layer = "fill", thickness = "0.30 m", density = "1900 kg/m^3" },
    { layer = "surfacing", thickness = "0.10 m", density = "2300 kg/m^3" },
]
backing = { height = "0.8 m", density = "2100 kg/m^3" }
dispersal = { rule = "uniform", slope = "2:1" }
span = [
    { profile = "segmental", span = "6.0 m", rise = "1.5 m", thickness = "0.45 m", voussoirs = 31 },
    { profile = "segmental", span = "4.0 m", rise = "1.2 m", thickness = "0.35 m", voussoirs = 21 },
]
pier = [{ width = "1.1 m", height = "3.5 m", courses = 10 }]
load = [{ kind = "axle", axle_force = "100 kN", contact_length = "0.30 m", effective_width = "2.5 m", at = "1/4 of span 1" }]
sweep = { rule = "characteristic", vehicles = ["cs454-bogie-10"] }
"#;

#[test]
fn layers_backing_piers_and_every_rise_are_drawn_with_their_sizes() {
    let stage = Stage::new("drawn-elevation");
    stage.write("backed.toml", BRIDGE);
    assert_eq!(stage.object(&["check", "backed.toml", "--out", "drawn"]).1.code, Some(0));
    let svg = stage.read("drawn/bridge.svg");
    let words = [
        "fill, 0.3 m over the crown",
        "surfacing, 0.1 m thick",
        "backing, to 0.8 m above the springings",
        ">1.1 m<",
        ">1.5 m<",
        ">1.2 m<",
    ];
    words.iter().for_each(|word| assert!(svg.contains(word), "{word}"));
}

#[test]
fn the_line_of_thrust_goes_down_the_pier() {
    let stage = Stage::new("drawn-thrust");
    stage.write("backed.toml", BRIDGE);
    stage.object(&["collapse", "backed.toml", "--method", "limit", "--out", "drawn"]);
    let table = stage.read("drawn/thrust-line.csv");
    let rows: Vec<Vec<f64>> =
        table.lines().skip(1).map(|row| row.split(',').map(|cell| cell.parse().expect("a number")).collect()).collect();
    let pier: Vec<_> = rows.iter().filter(|row| row[0] == 2.0).collect();
    // Ten courses: nine joints between them and one on the foundation, all inside the pier, from the foundation up.
    assert_eq!(pier.len(), 10);
    assert!(pier.iter().all(|row| (6.0..=7.1).contains(&row[1]) && (-3.5 - 1e-9..0.0).contains(&row[2])), "{pier:?}");
    assert!(
        pier.windows(2).all(|two| two[1][2] > two[0][2] && two[1][3] < two[0][3]),
        "higher joints carry less weight"
    );
}

#[test]
fn drawings_of_a_sweep_say_which_vehicle_stands_where() {
    let stage = Stage::new("drawn-sweep");
    stage.write("backed.toml", BRIDGE);
    stage.object(&["collapse", "backed.toml", "--sweep", "--out", "drawn"]);
    for figure in ["mechanism", "thrust-line", "stress", "envelope"] {
        let svg = stage.read(&format!("drawn/{figure}.svg"));
        // Lines are broken where they are full.
        let text = svg.replace("</text>", " ");
        for word in ["travelling to the", "on the bridge"] {
            assert!(text.contains(word), "{figure}: {word}");
        }
    }
}
