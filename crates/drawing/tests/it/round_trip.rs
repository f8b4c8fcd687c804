//! What is written is read again.

use drawing::{Item, Options, Point, Sheet, layer_name};
use proptest::prelude::*;

/// Convex outlines side by side: corners on circles, each in a cell of its own.
fn outlines() -> impl Strategy<Value = Vec<Vec<Point>>> {
    let one = (3usize..9, 0.0..std::f64::consts::TAU, 0.05..0.45f64, prop::collection::vec(0.2..1.0f64, 9));
    let many = prop::collection::vec(one, 1..12);
    (many, -1e3..1e3f64, -1e3..1e3f64).prop_map(|(shapes, x, y)| {
        let outline = |(k, (count, start, radius, steps)): (usize, (usize, f64, f64, Vec<f64>))| {
            let total: f64 = steps[..count].iter().sum();
            let mut angle = start;
            let corner = |step: &f64| {
                angle += std::f64::consts::TAU * step / total;
                [x + k as f64 + radius * angle.cos(), y + radius * angle.sin()]
            };
            steps[..count].iter().map(corner).collect()
        };
        shapes.into_iter().enumerate().map(outline).collect()
    })
}

fn sheet(outlines: &[Vec<Point>]) -> Sheet {
    let mut sheet = Sheet::default();
    sheet.layer("BLOCKS", 3);
    let item = |points: &Vec<Point>| Item::Line { layer: "BLOCKS".into(), points: points.clone(), closed: true };
    sheet.items = outlines.iter().map(item).collect();
    sheet
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn outlines_come_back_to_a_nanometre(outlines in outlines()) {
        let read = drawing::read(&sheet(&outlines).dxf(), &Options::default());
        prop_assert!(read.is_usable(), "{:?}", read.findings);
        prop_assert_eq!(read.drawing.outlines.len(), outlines.len());
        for (found, drawn) in read.drawing.outlines.iter().zip(&outlines) {
            prop_assert_eq!(found.points.len(), drawn.len());
            prop_assert_eq!(&found.layer, "BLOCKS");
            for (p, q) in found.points.iter().zip(drawn) {
                prop_assert!((p[0] - q[0]).hypot(p[1] - q[1]) <= 1e-9);
            }
        }
    }

    #[test]
    fn circles_come_back_to_a_nanometre(x in -1e3..1e3f64, y in -1e3..1e3f64, radius in 1e-3..1e2f64) {
        let circle = Item::Circle { layer: "GRAINS".into(), centre: [x, y], radius };
        let read = drawing::read(&Sheet { layers: vec![], items: vec![circle] }.dxf(), &Options::default());
        let found = &read.drawing.circles[0];
        prop_assert!((found.centre[0] - x).abs() <= 1e-9 && (found.centre[1] - y).abs() <= 1e-9);
        prop_assert!((found.radius - radius).abs() <= 1e-9);
        prop_assert_eq!(&found.layer, "GRAINS");
    }
}

#[test]
fn the_same_sheet_gives_the_same_bytes_in_metres() {
    let sheet = sheet(&[vec![[0.0, 0.0], [1.0, 0.0], [0.5, 1.0]]]);
    assert_eq!(sheet.dxf(), sheet.dxf());
    let text = String::from_utf8(sheet.dxf()).unwrap();
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    let value = |name: &str| lines.iter().position(|line| *line == name).map(|at| lines[at + 2]);
    assert_eq!((value("$ACADVER"), value("$INSUNITS")), (Some("AC1024"), Some("6")));
}

#[test]
fn every_handle_is_given_once_and_every_owner_is_there() {
    let text = String::from_utf8(sheet(&[vec![[0.0, 0.0], [1.0, 0.0], [0.5, 1.0]]]).dxf()).unwrap();
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    let pairs: Vec<(&str, &str)> = lines.chunks_exact(2).map(|pair| (pair[0], pair[1])).collect();
    let after_header = pairs.iter().position(|pair| pair.1 == "TABLES").unwrap();
    let values = |codes: &[&str]| -> Vec<u32> {
        let known = pairs[after_header..].iter().filter(|(code, _)| codes.contains(code));
        known.map(|(_, value)| u32::from_str_radix(value, 16).unwrap()).collect()
    };
    let mut handles = values(&["5", "105"]);
    handles.sort_unstable();
    assert_eq!(handles, (1..=handles.len() as u32).collect::<Vec<_>>());
    assert!(values(&["330", "350"]).iter().all(|owner| *owner == 0 || handles.contains(owner)));
    let seed = pairs.iter().position(|pair| pair.1 == "$HANDSEED").unwrap();
    assert_eq!(u32::from_str_radix(pairs[seed + 1].1, 16).unwrap(), handles.len() as u32 + 1);
}

/// Lines of loads and levels beside blocks are no outlines; lines that were meant to meet are an error.
#[test]
fn single_lines_on_a_layer_of_their_own_are_left_out_and_told() {
    let line =
        |layer: &str, points: &[Point]| Item::Line { layer: layer.into(), points: points.to_vec(), closed: false };
    let block = Item::Line {
        layer: "BLOCKS".into(),
        points: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
        closed: true,
    };
    let read = |items: Vec<Item>| drawing::read(&Sheet { layers: vec![], items }.dxf(), &Options::default());
    let beside = vec![
        block.clone(),
        line("SURFACE", &[[-1.0, 1.4], [0.5, 1.5], [2.0, 1.4]]),
        // An arrow with its barbs in one line.
        line("LOADS", &[[0.2, 1.5], [0.2, 1.1], [0.23, 1.16], [0.2, 1.1], [0.17, 1.16]]),
        line("LOADS", &[[0.6, 1.5], [0.6, 1.1]]),
    ];
    let found = read(beside.clone());
    assert!(found.is_usable(), "{:?}", found.findings);
    assert_eq!((found.drawing.layers.len(), found.drawing.outlines.len()), (1, 1));
    let told: Vec<&str> = found.findings.iter().filter(|one| one.code == "D104").map(|one| &one.message[..]).collect();
    assert_eq!(told.len(), 2, "{told:?}");
    assert!(told.iter().any(|words| words.starts_with("2 open lines of this layer")), "{told:?}");
    let refused =
        |more: Vec<Item>| read([vec![block.clone()], more].concat()).findings.iter().any(|one| one.code == "D301");
    // Sides of a block that miss one another by 2 mm, a block without its fourth side, an open line among blocks, and lines alone.
    let (a, b, c) = ([3.0, 0.0], [4.0, 0.0], [4.002, 0.0]);
    assert!(refused(vec![
        line("RING", &[a, b]),
        line("RING", &[c, [4.0, 1.0]]),
        line("RING", &[[4.0, 1.002], [3.0, 1.0]])
    ]));
    assert!(refused(vec![line("RING", &[a, b, [4.0, 1.0], [3.0, 1.0]])]));
    assert!(refused(vec![line("BLOCKS", &[a, b])]));
    assert!(!read(beside[1..].to_vec()).is_usable());
}

#[test]
fn names_of_layers_are_made_legal() {
    assert_eq!(layer_name(" 0.5/1.0 MPa, <high>\n"), "0.5-1.0 MPa- -high-");
    assert_eq!(layer_name("\t"), "0");
}
