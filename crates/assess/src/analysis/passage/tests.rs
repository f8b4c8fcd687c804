//! The parts of a passage together: set-up on a real mesh, report of a made-up solution.

use super::*;
use crate::samples;
use bridge::passage::PassageAnalysis;
use bridge::passage::{Passage as Asked, Sensor, SensorKind, SensorPosition};
use bridge::train::{Train, built_in, read_toml};
use outcome::note::{DefectNote, InPassage, Note};
use outcome::passage::Measurand;
use outcome::passage::StepLog;

/// Two spans under the short train of the library.
pub(super) fn railway() -> Bridge {
    let mut bridge = samples::railway();
    let vehicles = read_toml(built_in("paper-short").unwrap().text.as_bytes()).vehicles.unwrap();
    let train = Train { name: "paper-short".into(), file: None, vehicles };
    let asked = Asked { train, ..samples::passage() };
    bridge.passage = Some(asked);
    bridge
}

/// A ring that is thinner throughout has a smaller mesh; mortar that is lost is not felt, and the result says so.
#[test]
fn finite_elements_say_which_defects_they_leave_out() {
    use bridge::defect::{Defect, DefectKind, Face};
    let sound = railway();
    let mut b = sound.clone();
    let whole = |kind| Defect { kind, from_to: [0.0, 6.0], shares: [0.0, 1.0] };
    for span in &mut b.spans {
        span.defects = vec![
            whole(DefectKind::LostMortar { face: Face::Intrados, depth: 0.05 }),
            whole(DefectKind::ThinRing { face: Face::Intrados, depth: 0.06 }),
        ];
    }
    let meshed = setup(&b).unwrap().meshed;
    let told = model::assumptions(&b, &meshed);
    let left_out = |said: &Note| matches!(said, Note::DefectNote(DefectNote::LeftOut { defect, .. }) if *defect == b.spans[0].defects[0]);
    let felt = |said: &Note| matches!(said, Note::DefectNote(DefectNote::Felt { defect, .. }) if *defect == b.spans[0].defects[1]);
    assert!(told.iter().any(left_out) && told.iter().any(felt), "{told:?}");
    let deepest = |of: &structure::discretise::mesh::Meshed| {
        let ring = of.picture().surface[0][0];
        let crown = 0.5 * sound.spans[0].span;
        let near = of.mesh.nodes.iter().filter(|p| (p.x - crown).abs() < 0.05 && p.x > ring);
        near.map(|p| p.y).filter(|y| *y > 0.5).fold(f64::INFINITY, f64::min)
    };
    let lost = deepest(&meshed) - deepest(&setup(&sound).unwrap().meshed);
    // A node beside the crown lies up to a millimetre lower.
    assert!((lost - 0.06).abs() < 1.5e-3, "{lost}");
}

#[test]
fn a_passage_is_set_up_on_the_mesh() {
    let bridge = railway();
    let setup = setup(&bridge).unwrap();
    assert_eq!(setup.sensors.len(), 6, "the channels of Table 1");
    let surface = &setup.meshed.picture().surface;
    assert!((setup.positions[0] - surface[0][0]).abs() < 1e-12, "the first axle starts where the mesh begins");
    let last = setup.positions.last().unwrap() - setup.loads.wheelbase();
    assert!(last >= surface.last().unwrap()[0], "the last axle has left");
    let step = setup.positions[1] - setup.positions[0];
    assert!((step - 12.5 * 0.005).abs() < 1e-12, "45 km/h at 200 Hz: {step}");
    // The whole dead load, and axles that stand well inside.
    let length = surface.last().unwrap()[0] - surface[0][0];
    let dead: f64 = setup.dead_load.iter().sum();
    assert!((dead - (3e3 + setup.meshed.ballast_pressure) * length).abs() < 1e-6 * dead);
    let front = surface.last().unwrap()[0] - 0.3 * length;
    let force: f64 = setup.loads.forces(front, setup.meshed.sets.surface.len()).iter().sum();
    let axles = setup.loads.axles_above(front, surface[0][0], front);
    let axles: f64 = axles.iter().map(|(_, force)| force).sum();
    // All but what the rail carries beyond the left end.
    assert!((force / (axles / bridge.width) - 1.0).abs() < 0.1, "{force} {axles}");
}

/// A homogeneous stretch of the whole mesh strains every stone along its face alike, whatever its direction.
#[test]
fn sensors_on_a_mesh_read_a_homogeneous_strain() {
    let setup = setup(&railway()).unwrap();
    let mesh = &setup.meshed.mesh;
    let moved = |node: mechanics::ids::NodeId| [1e-4 * mesh.nodes[node].x, 1e-4 * mesh.nodes[node].y];
    for sensor in setup.sensors.iter().filter(|sensor| sensor.quantity == Measurand::Strain) {
        let value = sensor.reading.value(moved, |_| [0.0; 3]);
        assert!((value - 1e-4).abs() < 1e-13, "{}: {value}", sensor.name);
    }
}

#[test]
fn what_cannot_be_set_up_says_why() {
    let mut bridge = railway();
    bridge.passage.as_mut().unwrap().plan.time_step = 1e-5;
    bridge.passage.as_mut().unwrap().plan.speed = 0.01;
    assert!(matches!(setup(&bridge), Err(AnalysisError::Passage(PassageError::TooManyPositions { .. }))));
    let mut bridge = railway();
    bridge.passage.as_mut().unwrap().plan.from = Some(1e3);
    assert!(matches!(setup(&bridge), Err(AnalysisError::Passage(PassageError::NoWay { .. }))));
    let mut bridge = railway();
    let strain = SensorKind::Strain { gauge_length: 5.0 };
    let place = SensorPosition::Span { span: 0, share: 0.5 };
    let long = Sensor { name: "long".into(), kind: strain, place, face: bridge::passage::Face::Extrados };
    bridge.passage.as_mut().unwrap().sensors = vec![long];
    assert!(matches!(setup(&bridge), Err(AnalysisError::Passage(PassageError::LongGauge { .. }))));
    bridge.passage = None;
    assert_eq!(setup(&bridge).unwrap_err(), AnalysisError::Passage(PassageError::NoTrain));
}

/// A run that breaks off keeps what it has.
#[test]
fn a_report_ends_where_the_solution_ends() {
    let bridge = railway();
    let setup = setup(&bridge).unwrap();
    let step = |iterations, open_joints| StepLog { iterations, open_joints, ..StepLog::default() };
    let solution = Solution {
        status: PassageStatus::NotConverged,
        reason: Some("test".into()),
        self_weight: vec![1.0; 6],
        values: vec![vec![0.0, 2.0, -3.0]; 6],
        derivatives: Vec::new(),
        degrees_of_freedom: 7,
        condensed_degrees_of_freedom: None,
        taking_part: Vec::new(),
        log: vec![step(3, 1), step(4, 5), step(2, 0)],
        moments: Vec::new(),
        influence: None,
        no_influence_at: None,
        assumptions: vec![InPassage::Base.into()],
    };
    let report = report(&bridge, &setup, solution);
    assert_eq!((report.times.len(), report.positions.len(), report.channels.len()), (3, 3, 6));
    assert_eq!((report.iterations_total, report.open_joints), (9, 5));
    assert_eq!(report.channels[0].peak_value(), -3.0);
    assert_eq!(report.assumptions.last(), Some(&InPassage::Base.into()));
}

/// A solution without anything in it.
fn solved() -> Solution {
    Solution {
        status: PassageStatus::Completed,
        reason: None,
        self_weight: vec![0.0; 6],
        values: vec![vec![0.0]; 6],
        derivatives: Vec::new(),
        degrees_of_freedom: 7,
        condensed_degrees_of_freedom: None,
        taking_part: Vec::new(),
        log: Vec::new(),
        moments: Vec::new(),
        influence: None,
        no_influence_at: None,
        assumptions: Vec::new(),
    }
}

#[test]
fn a_passage_beside_walls_says_that_they_are_left_out() {
    let mut bridge = railway();
    let setup = setup(&bridge).unwrap();
    let codes =
        |bridge: &Bridge| report(bridge, &setup, solved()).warnings.iter().map(|one| one.code()).collect::<Vec<_>>();
    assert!(!codes(&bridge).contains(&outcome::warning::WALLS_LEFT_OUT));
    bridge.spandrel_wall = Some(samples::spandrel_wall(&bridge));
    assert!(codes(&bridge).contains(&outcome::warning::WALLS_LEFT_OUT));
}

/// A record that bends much at its peak is named, a smooth one is not, and where influence lines found no balance is told.
#[test]
fn peaks_between_positions_and_missing_influence_lines_are_told() {
    let bridge = railway();
    let setup = setup(&bridge).unwrap();
    let told = |apart: f64, no_influence_at: Option<f64>| {
        let wave: Vec<f64> = (0..setup.positions.len()).map(|k| (-(k as f64 * apart - 10.0).powi(2)).exp()).collect();
        let mut values = vec![vec![0.0; wave.len()]; 6];
        values[0] = wave;
        let found = report(&bridge, &setup, Solution { values, no_influence_at, ..solved() });
        found.warnings.iter().map(|one| one.message()).collect::<Vec<_>>()
    };
    // The parabola through neighbours of the peak of exp(-x^2) bends by 2 (1 - exp(-d^2)).
    assert!(told(0.25, None).iter().all(|words| !words.contains("peaks may lie")), "{:?}", told(0.25, None));
    let coarse = told(1.0, None);
    let wanted = format!("{} may be 16 % larger", setup.sensors[0].name);
    assert!(coarse.iter().any(|words| words.contains(&wanted)), "{coarse:?}");
    assert!(told(0.25, Some(3.25)).iter().any(|words| words.contains("no balance at 3.25 m")));
}

/// A plan for the condensed path that cannot be followed: what was done is told, and why.
#[test]
fn the_path_that_was_taken_is_told() {
    let mut bridge = railway();
    let told = |bridge: &Bridge| {
        let setup = setup(bridge).unwrap();
        let report = report(bridge, &setup, solved());
        (report.path, report.assumptions.contains(&InPassage::AllFreedoms.into()))
    };
    assert_eq!(told(&bridge), (PassagePath::Condensed, false));
    bridge.passage.as_mut().unwrap().plan.analysis = PassageAnalysis::Transient;
    assert_eq!(told(&bridge), (PassagePath::Plain, true));
    bridge.passage.as_mut().unwrap().plan.path = PassagePath::Plain;
    assert_eq!(told(&bridge), (PassagePath::Plain, false));
}

/// The names that scripts rely on, in the units that they say.
#[test]
fn the_object_has_the_fields_that_scripts_read() {
    let bridge = railway();
    let setup = setup(&bridge).unwrap();
    let solution = Solution {
        status: PassageStatus::Completed,
        reason: None,
        self_weight: vec![-1e-3; 6],
        values: vec![vec![0.0, 2e-4, -3e-4, 1e-4]; 6],
        derivatives: Vec::new(),
        degrees_of_freedom: 7,
        condensed_degrees_of_freedom: None,
        taking_part: Vec::new(),
        log: vec![StepLog { stage: Part::Passage, iterations: 3, plastic_points: 4, ..StepLog::default() }],
        moments: Vec::new(),
        influence: None,
        no_influence_at: None,
        assumptions: Vec::new(),
    };
    let passage = report(&bridge, &setup, solution);
    let object = passage.object();
    let near = |value: &serde_json::Value, wanted: f64| (value.as_f64().unwrap() - wanted).abs() < 1e-9 * wanted.abs();
    let crown = &object["channels"][0];
    assert_eq!((crown["quantity"].as_str(), crown["unit"].as_str()), (Some("displacement"), Some("mm")));
    assert!(near(&crown["peak"], -0.3) && near(&crown["minimum"], -0.3) && near(&crown["maximum"], 0.2), "{crown}");
    assert!(near(&crown["self_weight"], -1.0) && near(&crown["time_of_peak_s"], 0.01), "{crown}");
    let strain = &object["channels"][3];
    assert_eq!((strain["quantity"].as_str(), strain["unit"].as_str()), (Some("strain"), Some("microstrain")));
    assert!(near(&strain["peak"], -300.0), "{strain}");
    let counts = ["degrees_of_freedom", "load_positions", "iterations_total", "open_joints", "plastic_points"];
    assert_eq!(counts.map(|key| object[key].as_u64()), [Some(7), Some(4), Some(3), Some(0), Some(4)]);
    let table = outcome::published::channels_table(&passage);
    let lines: Vec<&str> = table.lines().collect();
    assert!(lines[0].starts_with("time_s,crown_displacement_mm,pier_springing_displacement_mm,"), "{}", lines[0]);
    assert!(lines[2].starts_with("0.005,0.2"), "{}", lines[2]);
    assert_eq!(lines.len(), 5);
    assert_eq!(outcome::published::passage_log(&passage).lines().count(), 2);
}

/// A slice by the condensed path, self-weight included, is what the whole system gives when it goes from the bridge at rest straight
/// to that position; also for other moduli than those that the set-up was made for.
#[test]
fn slices_are_those_of_the_whole_system() {
    use bridge::passage::PassagePath;
    use mechanics::watch::Unwatched;
    let text = include_bytes!("../../../../../examples/railway-arch/passage.toml");
    let mut bridge = bridge::read(text).bridge.unwrap();
    let base = setup(&bridge).unwrap();
    let middle = |share: f64| base.positions[(share * base.positions.len() as f64) as usize];
    let positions = [middle(0.2), middle(0.5)];
    bridge.service.fill.elastic_modulus = bridge.service.fill.elastic_modulus.map(|modulus| 1.3 * modulus);
    let found =
        slices(&bridge, &base, WantedSlices { positions: &positions, ..Default::default() }, &mut Unwatched).unwrap();
    assert_eq!(found.status, PassageStatus::Completed, "{:?}", found.reason);
    for (k, position) in positions.iter().enumerate() {
        let mut one = Setup { positions: vec![*position], times: vec![0.0], ..base.clone() };
        one.plan.path = PassagePath::Plain;
        one.plan.tolerance = 1e-9;
        let plain = solve(&bridge, &one, Scope::Sensors, &[], &mut Unwatched).unwrap();
        let size = plain.values.iter().fold(0.0_f64, |most, value| most.max(value[0].abs()));
        assert!(size > 0.0);
        for (s, sensor) in base.sensors.iter().enumerate() {
            let (here, there) = (found.values[s][k], plain.values[s][0]);
            // The plain path stops at 1e-9 of its loads.
            assert!((here - there).abs() <= 1e-7 * there.abs().max(1e-3 * size), "{}: {here} {there}", sensor.name);
        }
    }
}

/// Derivatives of slices are those of slices with other quantities; what is expected beforehand changes nothing.
#[test]
fn slices_tell_their_derivatives() {
    use mechanics::watch::Unwatched;
    let text = include_bytes!("../../../../../examples/railway-arch/passage.toml");
    let mut bridge = bridge::read(text).bridge.unwrap();
    // Where a spring breaks, differences jump.
    bridge.service.mortar.lift_off = 0.0;
    let base = setup(&bridge).unwrap();
    let middle = |share: f64| base.positions[(share * base.positions.len() as f64) as usize];
    let positions = [middle(0.35), middle(0.5)];
    let with = |k: usize, share: f64| {
        let mut other = bridge.clone();
        let modulus =
            if k == 0 { &mut other.service.fill.elastic_modulus } else { &mut other.service.mortar.elastic_modulus };
        let before = modulus.unwrap();
        *modulus = Some((1.0 + share) * before);
        (other, share * before)
    };
    let neighbours = [with(0, 1e-6), with(1, 1e-6)];
    let plain = WantedSlices { positions: &positions, ..Default::default() };
    let found = slices(&bridge, &base, WantedSlices { neighbours: &neighbours, ..plain }, &mut Unwatched).unwrap();
    assert_eq!(found.status, PassageStatus::Completed, "{:?}", found.reason);
    assert!(!found.taking_part.is_empty());
    for k in 0..2 {
        let values = |share: f64| {
            let (other, by) = with(k, share);
            let expecting = WantedSlices { expected: &found.taking_part, ..plain };
            (slices(&other, &base, expecting, &mut Unwatched).unwrap().values, by)
        };
        let ((more, by), (less, _)) = (values(1e-4), values(-1e-4));
        for (s, sensor) in base.sensors.iter().enumerate() {
            let differences: Vec<f64> = (0..2).map(|p| (more[s][p] - less[s][p]) / (2.0 * by)).collect();
            let size = differences.iter().fold(0.0_f64, |most, d| most.max(d.abs()));
            for (own, difference) in found.derivatives[k][s].iter().zip(&differences) {
                // Joints open a little farther along within the difference.
                assert!((own - difference).abs() <= 2e-3 * size, "{k}, {}: {own:e} {difference:e}", sensor.name);
            }
        }
    }
    let expecting = WantedSlices { expected: &found.taking_part, ..plain };
    let again = slices(&bridge, &base, expecting, &mut Unwatched).unwrap();
    for (a, b) in again.values.iter().flatten().zip(found.values.iter().flatten()) {
        assert!((a - b).abs() <= 1e-8 * b.abs().max(1e-9), "{a:e} {b:e}");
    }
}
