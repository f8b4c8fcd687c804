//! Figures of a passage: the mesh, the sensors and the loads of the example, and fields that are made up but of the size
//! of real ones. Nothing is solved here.

use assess::analysis::passage::{Setup, Solution, report, setup};
use bridge::Bridge;
use outcome::passage::{Influence, Moment, Pair, PairState, Part, Row, RowKind, StepLog};
use outcome::passage::{Passage, PassageStatus};
use std::collections::BTreeMap;

fn example() -> Bridge {
    let text = include_str!("../../../examples/railway-arch/passage.toml");
    bridge::read(text.as_bytes()).bridge.expect("the example is good")
}

/// A dip of a length around a place.
fn dip(x: f64, at: f64, length: f64) -> f64 {
    (-((x - at) / length).powi(2)).exp()
}

/// Sum of what each axle does to a point at `at`: [`dip`]s of half a span, the ones beside it of the other sign.
fn effect(axles: &[(f64, f64)], at: f64) -> f64 {
    let one = |x: f64| dip(x, at, 2.2) - 0.25 * dip(x, at - 6.5, 2.5) - 0.25 * dip(x, at + 6.5, 2.5);
    axles.iter().map(|(x, force)| one(*x) * force / 200e3).sum()
}

fn axles(setup: &Setup, position: f64) -> Vec<(f64, f64)> {
    setup.loads.axles_above(position, -100.0, 200.0)
}

/// The bridge while the first axle stands at a place.
fn moment(bridge: &Bridge, setup: &Setup, name: &str, position: Option<f64>) -> Moment {
    let mesh = &setup.meshed.mesh;
    let above = position.map(|at| axles(setup, at)).unwrap_or_default();
    let end = structure::discretise::bridge_length(bridge);
    let displacements: Vec<[f64; 2]> = mesh
        .nodes
        .iter()
        .map(|node| {
            let deep = ((node.y + 3.0) / 5.0).clamp(0.0, 1.0);
            let rest = -3e-4 * deep * deep * dip(node.x, 0.5 * end, end);
            [4e-5 * deep * (node.x / 3.0).sin() * effect(&above, node.x), rest - 1.4e-4 * deep * effect(&above, node.x)]
        })
        .collect();
    let stresses: Vec<[f64; 4]> = mesh
        .quads
        .iter()
        .map(|quad| {
            let x = quad.nodes.iter().map(|node| mesh.nodes[*node].x).sum::<f64>() / 4.0;
            let stiff = if mesh.zones[quad.zone].contains("fill") { 0.05 } else { 1.0 };
            let size = -2.5e5 * stiff * (1.0 + effect(&above, x).max(0.0));
            [size, 0.4 * size, 0.1 * size, 0.2 * size]
        })
        .collect();
    let yielding: Vec<bool> = mesh
        .quads
        .iter()
        .zip(&stresses)
        .map(|(quad, stress)| mesh.zones[quad.zone] == "fill" && stress[0] < -2.2e4)
        .collect();
    let joints = setup.meshed.sets.spans.iter().enumerate();
    let joints = joints.flat_map(|(span, set)| set.joints[0].iter().enumerate().map(move |(k, id)| (*id, [span, k])));
    let rows: Vec<Row> = BTreeMap::from_iter(joints)
        .into_iter()
        .map(|(id, [span, joint])| {
            let nodes = &mesh.interfaces[id].one;
            let last = (nodes.len() - 1) as f64;
            let pairs = nodes.iter().enumerate().map(|(k, node)| {
                let at = [mesh.nodes[*node].x, mesh.nodes[*node].y];
                let across = 2.0 * k as f64 / last - 1.0;
                let normal = -3e5 * (1.0 + 1.3 * across * (0.9 * joint as f64 + effect(&above, at[0])).sin());
                let state = match (normal > 0.0, joint == 3 && span == 1) {
                    (true, _) => PairState::Open,
                    (false, true) => PairState::Sliding,
                    (false, false) => PairState::Closed,
                };
                let opening = if normal > 0.0 { 1e-10 * normal } else { 0.0 };
                Pair {
                    at,
                    area: 0.54 / (last + 1.0),
                    normal: normal.min(0.0),
                    shear: 0.1 * normal,
                    opening,
                    sliding: 0.0,
                    state,
                }
            });
            Row { kind: RowKind::Joint { span, joint }, pairs: pairs.collect() }
        })
        .collect();
    Moment {
        name: name.to_owned(),
        time: position.map_or(0.0, |at| (at - setup.positions[0]) / setup.plan.speed),
        position: position.unwrap_or(setup.positions[0]),
        axles: above,
        displacements,
        stresses,
        yielding,
        rows,
    }
}

/// Records and pictures of a passage that nobody computed.
fn made_up(bridge: &Bridge) -> Passage {
    let setup = setup(bridge).expect("the example can be set up");
    let places = [3.0, 6.0, 0.0, 3.0, 6.0, 0.0];
    let sizes = [-1.6e-4, 1.2e-4, -2e-5, 1.1e-6, -1.2e-5, -1.1e-5];
    let record = |position: f64| -> Vec<f64> {
        let above = axles(&setup, position);
        places.iter().zip(sizes).map(|(at, size)| size * effect(&above, *at)).collect()
    };
    let along: Vec<Vec<f64>> = setup.positions.iter().map(|position| record(*position)).collect();
    let values = (0..6).map(|k| along.iter().map(|values| values[k]).collect()).collect();
    let positions: Vec<f64> = (0..=400).map(|k| -5.0 + 0.1 * f64::from(k)).collect();
    let line = |k: usize| positions.iter().map(|x| sizes[k] * effect(&[(*x, 201e3)], places[k])).collect();
    let influence = Influence { force: 201e3, values: (0..6).map(line).collect(), positions: positions.clone() };
    let step = |time: f64| StepLog { stage: Part::Passage, time, iterations: 3, ..StepLog::default() };
    let solution = Solution {
        status: PassageStatus::Completed,
        reason: None,
        self_weight: sizes.iter().map(|size| 3.0 * size).collect(),
        values,
        derivatives: Vec::new(),
        degrees_of_freedom: 2 * setup.meshed.mesh.nodes.len(),
        condensed_degrees_of_freedom: Some(3000),
        taking_part: Vec::new(),
        log: setup.times.iter().map(|time| step(*time)).collect(),
        moments: vec![
            moment(bridge, &setup, "self-weight", None),
            moment(bridge, &setup, "peak of crown displacement", Some(4.8)),
            moment(bridge, &setup, "peak of pier springing displacement", Some(42.3)),
        ],
        influence: Some(influence),
        no_influence_at: None,
        assumptions: Vec::new(),
    };
    report(bridge, &setup, solution)
}

#[test]
fn a_passage_is_drawn() {
    let passage = made_up(&example());
    let drawings = figures::passage_drawings(&passage);
    let names: Vec<&str> = drawings.iter().map(|(name, _)| name.as_str()).collect();
    for name in ["records", "influence-lines", "moment-0-stress", "moment-1-displacement", "moment-2-ring"] {
        assert!(names.contains(&name), "{name} in {names:?}");
    }
    for (name, svg) in &drawings {
        let document = roxmltree::Document::parse(svg).expect("well-formed");
        assert!(!svg.contains("NaN") && !svg.contains("inf\""), "{name}");
        let class = |class: &str| document.descendants().filter(|node| node.attribute("class") == Some(class)).count();
        match name.as_str() {
            "records" | "influence-lines" => assert_eq!(class("curve"), 6, "{name}"),
            _ if name.starts_with("moment-0") => assert_eq!(class("wheel"), 0, "{name}"),
            _ => assert!(class("wheel") > 0, "{name}"),
        }
        // The whole bridge in some thirty thousand elements is still a drawing that can be sent around.
        assert!(svg.len() < 6_000_000, "{name}: {}", svg.len());
    }
    if let Some(folder) = std::env::var_os("EXTRADOS_WRITE_FIGURES") {
        std::fs::create_dir_all(&folder).expect("a folder");
        for (name, svg) in &drawings {
            let picture = figures::png(svg, figures::PNG_WIDTH).expect("a picture");
            std::fs::write(std::path::Path::new(&folder).join(format!("{name}.png")), picture).expect("written");
        }
    }
}

#[test]
fn every_moment_is_in_the_series() {
    let passage = made_up(&example());
    let files = figures::passage_paraview(&passage);
    let text = |name: &str| {
        let file = files.iter().find(|file| file.name == name).unwrap_or_else(|| panic!("no {name}"));
        String::from_utf8(file.bytes.clone()).expect("text")
    };
    for kind in ["mesh", "joints"] {
        let series = text(&format!("paraview/{kind}.pvd"));
        assert_eq!(series.matches("<DataSet").count(), 3);
        let one = text(&format!("paraview/{kind}-0001.vtu"));
        roxmltree::Document::parse(&one).expect("well-formed");
        let cells = if kind == "mesh" {
            passage.mesh.quads.len()
        } else {
            passage.moments[1].rows.iter().map(|row| row.pairs.len()).sum()
        };
        assert!(one.contains(&format!("NumberOfCells=\"{cells}\"")), "{kind}");
    }
}

/// A passage that broke off at once, or that records nothing, still has its files.
#[test]
fn a_passage_without_material_is_not_drawn() {
    let mut passage = made_up(&example());
    passage.times.clear();
    passage.positions.clear();
    passage.channels.iter_mut().for_each(|channel| channel.values.clear());
    passage.influence = None;
    passage.moments.clear();
    assert!(figures::passage_drawings(&passage).is_empty());
    assert!(figures::passage_paraview(&passage).is_empty());
}
