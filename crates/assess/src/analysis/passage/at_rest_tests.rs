//! Loads at rest against a crawling vehicle, the mirrored bridge, the whole system, and what yielding leaves behind.

use super::road_tests::{passed, road, sensors};
use super::{AtRest, PassageError, Solution, WantedSlices, at_rest};
use crate::analysis::AnalysisError;
use bridge::load_test::{LoadTest, Patch, PatchForce, Position, Readings, Sequence, Standing};
use bridge::passage::{Face, Heading, Sensor, SensorKind, SensorPosition};
use bridge::{Bridge, SoilLaw};
use mechanics::watch::Unwatched;
use outcome::passage::PassageStatus;

/// The two-span road with the lorry of its file standing at these places, one after the other.
fn stands(law: SoilLaw, fronts: &[(f64, Heading)], share: f64) -> Bridge {
    let mut bridge = road("");
    bridge.service.fill.law = law;
    bridge.service.abutment_fill.soil.law = law;
    let asked = bridge.passage.as_mut().unwrap();
    asked.sensors = sensors(share);
    asked.plan.tolerance = 1e-12;
    let position = |(k, &(front_axle, direction)): (usize, &(f64, Heading))| Position {
        name: format!("P{}", k + 1),
        vehicles: vec![Standing { vehicle: None, front_axle, direction }],
        forces: Vec::new(),
    };
    bridge.load_test = Some(LoadTest {
        train: Some(asked.train.clone()),
        way: Some(asked.way.clone()),
        plan: asked.plan.clone(),
        sensors: asked.sensors.clone(),
        positions: fronts.iter().enumerate().map(position).collect(),
        sequence: Sequence::Independent,
        readings: Readings::default(),
    });
    bridge
}

/// The same bridge without memory: nothing yields, breaks or slides.
fn without_memory(mut bridge: Bridge) -> Bridge {
    bridge.service.fill.law = SoilLaw::Elastic;
    bridge.service.abutment_fill.soil.law = SoilLaw::Elastic;
    (bridge.service.mortar.lift_off, bridge.service.mortar.shear_strength) = (1e12, Some(1e12));
    bridge.service.fill_contact.friction_coefficient = Some(1e6);
    bridge
}

fn test(bridge: &mut Bridge) -> &mut LoadTest {
    bridge.load_test.as_mut().unwrap()
}

fn stood(bridge: &Bridge) -> (AtRest, Solution) {
    let test = at_rest::setup(bridge).unwrap();
    let found = test.solve(bridge, WantedSlices::default(), &mut Unwatched).unwrap();
    assert_eq!(found.status, PassageStatus::Completed, "{:?}", found.reason);
    assert!(found.values.iter().all(|values| values.len() == test.names.len()));
    (test, found)
}

fn largest(values: &[Vec<f64>]) -> f64 {
    let most = values.iter().flatten().fold(0.0_f64, |most, value| most.max(value.abs()));
    assert!(most > 1e-6, "{most}");
    most
}

/// Where nothing keeps a memory a crawling vehicle is the same vehicle at rest, place by place: both ways, and in any order.
#[test]
fn a_crawling_vehicle_is_one_at_rest_in_every_place() {
    for heading in [Heading::Right, Heading::Left] {
        let mut bridge = without_memory(stands(SoilLaw::Elastic, &[], 0.4));
        bridge.passage.as_mut().unwrap().plan.direction = heading;
        let (set, crawled) = passed(&bridge);
        let places: Vec<usize> = (1..9).map(|k| k * set.positions.len() / 9).collect();
        let fronts: Vec<(f64, Heading)> = places.iter().map(|k| (set.positions[*k], heading)).collect();
        let mut at_rest = without_memory(stands(SoilLaw::Elastic, &fronts, 0.4));
        for sequence in [Sequence::Independent, Sequence::InOrder] {
            test(&mut at_rest).sequence = sequence;
            let (_, found) = stood(&at_rest);
            let most = largest(&crawled.values);
            let pairs = found.values.iter().zip(&crawled.values);
            let apart = pairs
                .flat_map(|(rested, crawled)| rested.iter().zip(&places).map(|(value, k)| (value - crawled[*k]).abs()));
            // One by one: a maximum passes over what is no number.
            apart.for_each(|apart| assert!(apart < 1e-9 * most, "{apart} of {most}"));
        }
    }
}

/// The mirror image of a bridge under the mirror images of its loads moves as the mirror image.
#[test]
fn loads_on_the_other_side_give_mirrored_readings() {
    let patch = |x| Patch { x, force: PatchForce::Whole(120e3), length: 0.4, width: Some(0.6) };
    let mut here = stands(SoilLaw::Elastic, &[(2.3, Heading::Right), (5.1, Heading::Left)], 0.3);
    let surface = at_rest::setup(&here).unwrap().setup.meshed.picture().surface.clone();
    let middle = 0.5 * (surface[0][0] + surface.last().unwrap()[0]);
    let mut there = here.clone();
    for position in &mut test(&mut there).positions {
        for vehicle in &mut position.vehicles {
            vehicle.front_axle = 2.0 * middle - vehicle.front_axle;
            vehicle.direction = if vehicle.direction == Heading::Right { Heading::Left } else { Heading::Right };
        }
    }
    test(&mut here).positions[1].forces.push(patch(1.7));
    test(&mut there).positions[1].forces.push(patch(2.0 * middle - 1.7));
    let ((_, one), (_, other)) = (stood(&here), stood(&there));
    let most = largest(&one.values);
    for (left, right, sign) in [(0, 1, 1.0), (1, 0, 1.0), (2, 3, -1.0), (3, 2, -1.0)] {
        for (a, b) in one.values[left].iter().zip(&other.values[right]) {
            assert!((a - sign * b).abs() < 1e-9 * most, "{a} {b} of {most}");
        }
    }
}

/// In order, the first position is that of an unloaded bridge; where fill yields, it reads otherwise when it comes again, and each position by itself does not.
#[test]
fn what_yields_is_left_behind_in_order_alone() {
    let at = 0.5 * road("").spans[0].span;
    let fronts = [(at, Heading::Right), (at + 2.0, Heading::Right), (at, Heading::Right)];
    let mut bridge = stands(SoilLaw::DruckerPrager, &fronts, 0.5);
    let heavy = |k: usize| Patch { x: at + k as f64, force: PatchForce::Whole(400e3), length: 0.3, width: Some(1.0) };
    test(&mut bridge).positions[1].forces.push(heavy(1));
    let (_, alone) = stood(&bridge);
    test(&mut bridge).sequence = Sequence::InOrder;
    let (_, in_order) = stood(&bridge);
    let most = largest(&alone.values);
    for (alone, in_order) in alone.values.iter().zip(&in_order.values) {
        assert!((alone[0] - in_order[0]).abs() < 1e-7 * most, "{alone:?} {in_order:?}");
        assert_eq!(alone[0], alone[2], "each by itself");
    }
    let apart = alone.values.iter().zip(&in_order.values).map(|(a, b)| (a[2] - b[2]).abs()).fold(0.0, f64::max);
    assert!(apart > 1e-4 * most, "what is left behind: {apart} of {most}");
    // The same of a bridge without memory.
    let (_, elastic) = stood(&without_memory(bridge));
    for values in &elastic.values {
        assert!((values[0] - values[2]).abs() < 1e-9 * most, "{values:?}");
    }
}

/// Sensors of stress are read by the whole system, position by position; displacements beside them are those of the condensed path.
#[test]
fn stresses_are_read_by_the_whole_system() {
    let mut bridge = stands(SoilLaw::Elastic, &[(2.0, Heading::Right), (4.5, Heading::Left)], 0.4);
    let (condensed, quick) = stood(&bridge);
    assert!(condensed.has_derivatives());
    let place = SensorPosition::Span { span: 0, share: 0.5 };
    let stress = Sensor { name: "stress".into(), kind: SensorKind::Stress, place, face: Face::Intrados };
    test(&mut bridge).sensors.push(stress);
    let (whole, found) = stood(&bridge);
    assert!(!whole.has_derivatives() && found.values[4].iter().all(|stress| stress.abs() > 1e2));
    let most = largest(&quick.values);
    for (a, b) in quick.values.iter().flatten().zip(found.values.iter().flatten()) {
        // The whole system stops at 1e-12 of its loads.
        assert!((a - b).abs() < 1e-7 * most, "{a} {b} of {most}");
    }
}

/// What presses on the bridge is what the file says, over the width that carries it.
#[test]
fn loads_press_with_their_weight_over_what_carries_them() {
    let mut bridge = stands(SoilLaw::Elastic, &[(3.0, Heading::Right)], 0.4);
    let depth = bridge.cover.depth;
    let position = &mut test(&mut bridge).positions[0];
    position.forces = vec![
        Patch { x: 2.0, force: PatchForce::Whole(100e3), length: 0.3, width: Some(0.5) },
        Patch { x: 2.0, force: PatchForce::Whole(100e3), length: 0.3, width: None },
        Patch { x: 2.0, force: PatchForce::PerWidth(10e3), length: 0.3, width: None },
    ];
    let total = |bridge: &Bridge| -> f64 {
        let set = at_rest::setup(bridge).unwrap().setup;
        set.loads.forces(1.0, set.meshed.sets.surface.len()).iter().sum()
    };
    let wanted = 15.5e3 * bridge.gravity / (1.8 + depth) + 100e3 / (0.5 + depth) + 100e3 / bridge.width + 10e3;
    assert!((total(&bridge) / wanted - 1.0).abs() < 1e-9, "{} {wanted}", total(&bridge));
    // A vehicle of the library.
    let vehicle = |name: &str| Standing { vehicle: Some(name.to_owned()), front_axle: 9.0, direction: Heading::Right };
    let library = crate::vehicles::library(bridge.gravity).unwrap();
    let fixed = |one: &&crate::vehicles::Vehicle| {
        let plain = one.spacings_m.iter().all(|spacing| matches!(spacing, crate::vehicles::Spacing::Fixed(_)));
        plain && one.uniform.is_empty() && (1..4).contains(&one.spacings_m.len())
    };
    let mut on_roads =
        library.vehicles().filter(|(model, _)| model.ways == crate::vehicles::Ways::Road).map(|(_, one)| one);
    let lorry = on_roads.find(fixed).unwrap();
    test(&mut bridge).positions[0] =
        Position { name: "L".into(), vehicles: vec![vehicle(&lorry.code)], forces: Vec::new() };
    let wanted = 1e3 * lorry.axle_loads_kn.iter().sum::<f64>() / bridge.width.min(lorry.wheel_track_m + depth);
    assert!((total(&bridge) / wanted - 1.0).abs() < 1e-9, "{} {wanted}", total(&bridge));
    let refused = |bridge: &Bridge| match at_rest::setup(bridge).unwrap_err() {
        AnalysisError::Passage(error) => error,
        other => panic!("{other:?}"),
    };
    test(&mut bridge).positions[0].vehicles = vec![vehicle("lorri")];
    assert!(matches!(refused(&bridge), PassageError::NoSuchVehicle { .. }), "{}", refused(&bridge));
    test(&mut bridge).positions[0].vehicles = vec![vehicle("paper-short")];
    assert!(refused(&bridge).to_string().contains("no [track]"), "{}", refused(&bridge));
    test(&mut bridge).positions[0].vehicles = vec![Standing { front_axle: 500.0, ..vehicle(&lorry.code) }];
    assert!(refused(&bridge).to_string().contains("nothing of it stands on the bridge"), "{}", refused(&bridge));
    bridge.load_test = None;
    assert_eq!(refused(&bridge), PassageError::NoLoadTest);
}
