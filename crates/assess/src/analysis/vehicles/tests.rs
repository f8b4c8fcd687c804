//! Sweeps of vehicles against analyses of one case at a time.

use super::*;
use crate::samples;
use bridge::{Directions, Layer, LayerKind, Method, Pier, Ring, Span, SweepPlan};
use mechanics::watch::Unwatched;
use outcome::collapse::Status;
use outcome::note::{Governing, Moving, Note};
use outcome::vehicles::Of;

/// A sweep of vehicles in steps of half a metre.
pub(crate) fn plan(vehicles: &[&str]) -> SweepPlan {
    SweepPlan {
        rule: "characteristic".into(),
        rule_file: None,
        vehicles: vehicles.iter().map(|v| v.to_string()).collect(),
        vehicle_files: Vec::new(),
        step: Some(0.5),
        directions: Directions::Both,
        subsets: true,
        own_dispersal: false,
        braking: 0.0,
        braking_given: false,
        braking_reason: None,
        discrete_elements: false,
        texts: Vec::new(),
    }
}

fn bridgemill(vehicles: &[&str]) -> Bridge {
    let mut b = samples::bridgemill();
    b.cover.layers = vec![samples::fill(0.478, 1890.0)];
    b.plan.method = Method::Limit;
    b.sweep = Some(plan(vehicles));
    b
}

fn spans(count: usize) -> Bridge {
    let mut b = bridgemill(&["cs454-bogie-10"]);
    let ring = Ring { crown_thickness: 0.45, springing_thickness: 0.45, voussoirs: 21 };
    let span = Span { span: 6.0, rise: 1.5, rings: vec![ring], ..b.spans[0].clone() };
    b.spans = vec![span; count];
    b.piers = vec![Pier::plain(1.0, 1.0, 3.0, 6); count - 1];
    b
}

fn swept(b: &Bridge) -> VehicleSweep {
    vehicle_sweep(b, &mut Unwatched).unwrap()
}

/// The governing case once more, by itself, through the interior-point method.
fn alone(b: &Bridge, found: &VehicleSweep, index: usize) -> f64 {
    let plan = b.sweep.as_ref().unwrap();
    let (rule, vehicles) = chosen(b, plan).unwrap();
    let given = (&found.weights[..], found.step);
    let vehicles = beside::loaded(b, (&rule, plan), vehicles, given, &mut Unwatched).unwrap();
    let case = found.vehicles[index].case.as_ref().unwrap();
    let factored = factored::bridge(b, &rule, &case.weights);
    let mut one = factored::with_case(&factored, plan, &rule, &vehicles[index], case);
    one.plan.friction = bridge::Friction::Associated;
    let c = crate::analysis::collapse_by_limit(&one, &mut mechanics::watch::Unwatched).unwrap();
    assert!((c.reference_load / case.load - 1.0).abs() < 1e-9, "{} {}", c.reference_load, case.load);
    c.collapse_load.unwrap() / c.reference_load * rule.capacity_factor()
}

#[test]
fn the_governing_case_by_itself_has_the_same_factor() {
    let mut several = spans(3);
    several.sweep = Some(plan(&["cs454-bogie-10", "lm71"]));
    let mut factors = bridgemill(&["cs454-triple-8", "hb-30"]);
    factors.sweep.as_mut().unwrap().rule = "cs-454".into();
    let mut eurocode = bridgemill(&["lm1"]);
    eurocode.sweep.as_mut().unwrap().rule = "en-1991-2".into();
    for b in [bridgemill(&["hb-45", "lm71", "lm1", "cs454-bogie-9.5"]), several, factors, eurocode] {
        let found = swept(&b);
        for (k, v) in found.vehicles.iter().enumerate() {
            let [lower, upper] = v.bounds.unwrap();
            assert!((upper / lower - 1.0).abs() < 1e-8, "{}: {lower} {upper}", v.code);
            let one = alone(&b, &found, k);
            assert!((lower / one - 1.0).abs() < 1e-6, "{}: {lower} {one}", v.code);
            assert_eq!(v.by_interior_point, 0, "{}", v.code);
            let uniform = v.case.as_ref().unwrap().uniform;
            assert!(v.code != "lm1" || uniform.is_some(), "uniform loads take part: {uniform:?}");
            let least = v.envelope.iter().filter_map(|p| p.adequacy).fold(f64::INFINITY, f64::min);
            assert!((least / lower - 1.0).abs() < 1e-12, "the envelope holds the worst position");
        }
    }
}

/// Grades are those of the vehicles that are carried, lightest first whatever the order of the plan; the highest is the last before one that
/// is not.
#[test]
fn a_bridge_has_the_grades_that_it_carries() {
    let asked = ["en15528-e5", "en15528-a", "en15528-b2", "en15528-c2", "en15528-c4", "en15528-d2", "en15528-d4"];
    let mut b = spans(1);
    b.sweep = Some(plan(&asked));
    let factor =
        |found: &VehicleSweep, code: &str| found.vehicles.iter().find(|v| v.code == code).unwrap().adequacy.unwrap();
    // A ring of such strength that line category C4 fails by a hair or holds by one.
    let all = swept(&b);
    for scale in [1.02, 0.98] {
        let mut b = b.clone();
        let text = rules::FILES[1].iter().find(|f| f.0 == "characteristic").unwrap().1;
        let live = format!("[factors.live_load]\nvalue = {:.9}", scale * factor(&all, "en15528-c4"));
        let plan = b.sweep.as_mut().unwrap();
        plan.rule_file = Some("own.toml".into());
        plan.texts = vec![("own.toml".into(), text.replacen("[factors.live_load]\nvalue = 1.0", &live, 1))];
        let found = swept(&b);
        let graded = &found.grades()[0];
        assert_eq!(graded.of, "line category");
        let holds = |name: &str| factor(&found, &format!("en15528-{}", name.to_lowercase())) >= 1.0;
        assert!(graded.carried.iter().all(|name| holds(name)) && !graded.not_carried.iter().any(|name| holds(name)));
        assert_eq!(graded.carried.len() + graded.not_carried.len(), asked.len());
        let wanted = if scale > 1.0 { "B2" } else { "C4" };
        assert!(graded.carried.contains(&wanted.to_owned()), "{graded:?}");
        assert_eq!(graded.highest.as_deref(), Some(wanted), "{graded:?}");
    }
}

#[test]
fn a_symmetric_bridge_has_the_same_factor_both_ways() {
    let mut b = bridgemill(&["hl-93-truck"]);
    // Positions of both ways mirror one another when they start from both ends.
    let mut factor = |ways: Directions| {
        b.sweep.as_mut().unwrap().directions = ways;
        swept(&b).vehicles[0].adequacy.unwrap()
    };
    let [right, left, both] = [Directions::Right, Directions::Left, Directions::Both].map(&mut factor);
    assert!((right / left - 1.0).abs() < 1e-6, "{right} {left}");
    assert!((both / right.min(left) - 1.0).abs() < 1e-9);
}

/// Two axles so far apart that one alone makes the mechanism of a span: with and without the other the factors differ by round-off.
#[test]
fn the_case_that_governs_does_not_hang_on_round_off() {
    let vehicle = r#"
code = "apart"
title = "Two axles"
ways = "road"
source = { text = "made for a test", date = "2026", confidence = "assumed" }

[[vehicle]]
code = "apart"
title = "Two axles 7 m apart"
axle_loads_kn = [100.0, 100.0]
spacings_m = [7.0]
axles_may_be_dropped = true
wheel_track_m = 1.80
contact_length_m = 0.30

[[under]]
rule = "characteristic"
live_load = { value = 1.0, source = { text = "none", date = "2026", confidence = "assumed" } }

[under.impact]
kind = "included"
source = { text = "none", date = "2026", confidence = "assumed" }
"#;
    let governing = |change: f64| {
        let mut b = spans(2);
        b.piers = vec![Pier::plain(2.5, 2.5, 1.0, 2)];
        b.spans[0].rise *= 1.0 + change;
        let plan = b.sweep.as_mut().unwrap();
        (plan.vehicles, plan.vehicle_files) = (vec!["apart".into()], vec!["apart.toml".into()]);
        plan.texts = vec![("apart.toml".into(), vehicle.into())];
        let found = swept(&b);
        let one = &found.vehicles[0];
        let axles: Vec<_> = one.envelope.iter().map(|point| point.axles).collect();
        (axles, one.envelope.iter().filter_map(|point| point.adequacy).collect::<Vec<_>>())
    };
    let (axles, factors) = governing(0.0);
    assert!(axles.contains(&Some([0, 1])) && axles.contains(&Some([0, 0])), "{axles:?}");
    for change in [1e-12, -1e-12, 3e-12, -3e-12] {
        let (others, other) = governing(change);
        assert_eq!(axles, others, "{change:e}");
        assert!(factors.iter().zip(&other).all(|(a, b)| (a / b - 1.0).abs() < 1e-9));
    }
}

#[test]
fn axles_that_help_are_left_out() {
    let mut b = bridgemill(&["cooper-e80"]);
    let all = swept(&b).vehicles[0].adequacy.unwrap();
    b.sweep.as_mut().unwrap().subsets = false;
    let whole = swept(&b).vehicles[0].adequacy.unwrap();
    assert!(all < 0.98 * whole, "{all} {whole}");
}

#[test]
fn factors_of_a_rule_divide_the_factor() {
    // Axles, and axles with uniform loads beside them.
    let mut b = bridgemill(&["cs454-single", "lm71"]);
    let before = swept(&b);
    let text = rules::FILES[1].iter().find(|f| f.0 == "characteristic").unwrap().1;
    let twice = text.replacen("[factors.live_load]\nvalue = 1.0", "[factors.live_load]\nvalue = 2.0", 1);
    let worse = twice.replacen("[factors.condition]\nvalue = 1.0", "[factors.condition]\nvalue = 0.8", 1);
    let plan = b.sweep.as_mut().unwrap();
    plan.rule_file = Some("own.toml".into());
    plan.texts = vec![("own.toml".into(), worse)];
    let found = swept(&b);
    for (plain, v) in before.vehicles.iter().zip(&found.vehicles) {
        let share = v.adequacy.unwrap() / plain.adequacy.unwrap();
        assert!((share / (0.8 / 2.0) - 1.0).abs() < 1e-9, "{}: {share}", v.code);
    }
    assert_eq!(found.vehicles[0].load_factors, [2.0, 1.8]);
    // A factor left out is no factor of one.
    b.sweep.as_mut().unwrap().texts[0].1 = text.replacen("[factors.live_load]", "[factors.lively_load]", 1);
    let said = vehicle_sweep(&b, &mut Unwatched).unwrap_err().to_string();
    assert!(said.contains("own.toml") && said.contains("lively_load"), "{said}");
}

/// More weight holds an arch of this shape together, so that adverse factors would raise its adequacy: weights that help have
/// their favourable factor, and no factor on weights may give more than weights without factors.
#[test]
fn weights_that_help_have_the_favourable_factor() {
    let mut b = bridgemill(&["hb-45", "cs454-single"]);
    b.cover.layers.push(Layer {
        name: LayerKind::Surfacing,
        thickness: 0.1,
        density: 2300.0,
        ..b.cover.layers[0].clone()
    });
    b.sweep.as_mut().unwrap().rule = "cs-454".into();
    // One lane: what stands beside HB is another matter.
    b.carriageway = Some(bridge::Carriageway { lanes: Some(1), ..bridge::Carriageway::default() });
    let found = swept(&b);
    assert_eq!(found.weights.len(), 8);
    let (rule, _) = chosen(&b, b.sweep.as_ref().unwrap()).unwrap();
    let text = rules::FILES[1].iter().find(|f| f.0 == "cs-454").unwrap().1.to_owned();
    let with = |factors: [f64; 3]| {
        let [m, f, s] = factors;
        let text = text
            .replacen("value = 1.15", &format!("value = {m:?}"), 1)
            .replacen("value = 1.2", &format!("value = {f:?}"), 1)
            .replacen("value = 1.75", &format!("value = {s:?}"), 1);
        // One set of factors, whatever helps.
        let mut plan = b.sweep.clone().unwrap();
        plan.rule_file = Some("own.toml".into());
        plan.texts = vec![("own.toml".into(), text)];
        let mut one = b.clone();
        one.sweep = Some(plan);
        let (own, vehicles) = chosen(&one, one.sweep.as_ref().unwrap()).unwrap();
        let weights = vec![Weights { masonry: m, fill: Some(f), surfacing: Some(s) }];
        assert_eq!(own.factors.masonry_weight.value, m);
        search::all(
            &one,
            (&own, one.sweep.as_ref().unwrap()),
            (&vehicles, &weights),
            (found.step, true),
            &mut Unwatched,
        )
        .unwrap()
    };
    let (plain, adverse) = (with([1.0; 3]), with([1.15, 1.2, 1.75]));
    for (k, v) in found.vehicles.iter().enumerate() {
        let [least, plain, adverse] = [v, &plain[k], &adverse[k]].map(|v| v.adequacy.unwrap());
        assert!(adverse > 1.02 * plain, "{}: adverse factors alone would raise {plain} to {adverse}", v.code);
        assert!(least <= plain * (1.0 + 1e-9), "{}: {least} {plain}", v.code);
        // Another road: every combination by a sweep of its own.
        let all = found.weights.iter().map(|w| {
            let one = search::all(
                &b,
                (&rule, b.sweep.as_ref().unwrap()),
                (&chosen(&b, b.sweep.as_ref().unwrap()).unwrap().1, &[*w]),
                (found.step, true),
                &mut Unwatched,
            );
            one.unwrap()[k].adequacy.unwrap()
        });
        let smallest = all.fold(f64::INFINITY, f64::min);
        // The worst place between positions is sought under the weights that govern at positions.
        assert!((least / smallest - 1.0).abs() < 1e-6, "{}: {least} {smallest}", v.code);
    }
    let is_lightest = |said: &Note| {
        let Note::Moving(Moving::EveryWeight { combinations: 8, governing }) = said else { return false };
        matches!(governing, Governing::Vehicle { weights, .. } if weights.masonry == 1.0)
    };
    assert!(found.assumptions.iter().any(is_lightest), "{:?}", found.assumptions);
    // Heavier masonry by a tenth must not make the bridge better than it is without factors.
    let mut heavy = b.clone();
    heavy.masonry.density *= 1.1;
    let heavier = swept(&heavy).vehicles[0].adequacy.unwrap();
    assert!(heavier < adverse[0].adequacy.unwrap());
}

/// The factor is a concave function of the weights, so that it is least at a corner.
#[test]
fn no_weight_between_the_factors_is_worse() {
    let mut b = bridgemill(&["hb-45"]);
    b.sweep.as_mut().unwrap().rule = "cs-454".into();
    let found = swept(&b);
    let (rule, vehicles) = chosen(&b, b.sweep.as_ref().unwrap()).unwrap();
    let least = found.vehicles[0].adequacy.unwrap();
    for (m, f) in [(1.05, 1.0), (1.15, 1.1), (1.0, 1.13), (1.1, 1.05)] {
        let weights = [Weights { masonry: m, fill: Some(f), surfacing: None }];
        let between = search::all(
            &b,
            (&rule, b.sweep.as_ref().unwrap()),
            (&vehicles, &weights),
            (found.step, true),
            &mut Unwatched,
        )
        .unwrap();
        let between = between[0].adequacy.unwrap();
        assert!(between > least * (1.0 - 1e-6), "{m} {f}: {between} {least}");
    }
}

#[test]
fn a_bridge_that_does_not_stand_is_told_with_its_weights() {
    let mut b = bridgemill(&["cs454-single"]);
    b.spans[0].rings[0].crown_thickness = 0.15;
    b.spans[0].rings[0].springing_thickness = 0.15;
    b.sweep.as_mut().unwrap().rule = "cs-454".into();
    let found = swept(&b);
    let v = &found.vehicles[0];
    assert_eq!((v.status, v.adequacy, found.governing), (Status::UnstableUnderSelfWeight, None, None));
    let falls =
        |said: &Note| matches!(said, Note::Moving(Moving::EveryWeight { governing: Governing::Falls { .. }, .. }));
    assert!(found.assumptions.iter().any(falls), "{:?}", found.assumptions);
}

#[test]
fn unknown_names_are_answered_with_those_there_are() {
    let mut b = bridgemill(&["hb45"]);
    let said = vehicle_sweep(&b, &mut Unwatched).unwrap_err().to_string();
    assert!(said.contains("\"hb45\"") && said.contains("\"hb-45\"") && said.contains("extrados vehicles"), "{said}");
    b.sweep = Some(SweepPlan { rule: "bd21".into(), ..plan(&[]) });
    let said = vehicle_sweep(&b, &mut Unwatched).unwrap_err().to_string();
    assert!(said.contains("cs-454"), "{said}");
    b.sweep = None;
    assert!(vehicle_sweep(&b, &mut Unwatched).is_err());
}

#[test]
fn numbers_do_not_depend_on_threads() {
    let b = spans(2);
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| swept(&b))
    };
    assert_eq!(with(1), with(3));
}

#[test]
fn sections_balance_the_load_that_passes() {
    let b = bridgemill(&["cs454-single"]);
    let found = swept(&b);
    let v = &found.vehicles[0];
    let names: Vec<&str> = v.sections.iter().map(|s| s.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "span 1 left springing",
            "span 1 quarter point",
            "span 1 crown",
            "span 1 three-quarter point",
            "span 1 right springing"
        ]
    );
    for s in &v.sections {
        let of = |word: Of| s.extremes.iter().find(|e| e.of == word).unwrap();
        let (large, small) = (of(Of::LargestThrust), of(Of::SmallestThrust));
        assert!(large.thrust > small.thrust && small.thrust > 0.0, "{}", s.name);
        assert!(of(Of::OutermostThrust).eccentricity >= of(Of::InnermostThrust).eccentricity);
        // The thrust of the ring alone is some 700 kN/m; one axle of 30 kN/m adds less than its weight at 1 : 4.
        assert!(large.thrust - small.thrust < 2.0 * large.case.load, "{}: {large:?} {small:?}", s.name);
    }
    // The crown is compressed most with the axle near it.
    let crown = &v.sections[2].extremes[0];
    assert!((crown.case.position - 9.15).abs() < 1.5, "{crown:?}");
}

#[test]
fn discrete_elements_carry_less_than_rigid_blocks_in_the_governing_case() {
    let mut b = bridgemill(&["cs454-bogie-10"]);
    b.sweep.as_mut().unwrap().discrete_elements = true;
    let found = swept(&b);
    let c = found.discrete_elements.unwrap();
    let (by_dem, by_limit) = (c.adequacy.unwrap(), c.limit.unwrap());
    // Deformable joints carry up to 15 % less than rigid ones, and the last stable step lies up to a step below.
    assert!(by_dem < by_limit && by_dem > 0.8 * by_limit, "{by_dem} {by_limit}");
    // A poor condition lessens what discrete elements carry as it lessens what limit analysis gives.
    let mut poor = b.clone();
    own_rule(&mut poor, "characteristic", &[("[factors.condition]\nvalue = 1.0", "[factors.condition]\nvalue = 0.8")]);
    let poor = swept(&poor).discrete_elements.unwrap();
    for (less, all) in [(poor.adequacy.unwrap(), by_dem), (poor.limit.unwrap(), by_limit)] {
        assert!((less / all / 0.8 - 1.0).abs() < 1e-9, "{less} {all}");
    }
    // Masonry that crushes turns inside its edges, by discrete elements as by limit analysis.
    b.masonry.compressive_strength = Some(6e6);
    let crushed = swept(&b).discrete_elements.unwrap();
    let inset = crushed.inset.unwrap();
    assert!(c.inset.is_none() && (0.02..0.1).contains(&inset), "{inset}");
    let [dem, limit] = [crushed.adequacy.unwrap() / by_dem, crushed.limit.unwrap() / by_limit];
    assert!(limit < 0.9 && dem < 0.9, "crushing takes {limit} by limit analysis, {dem} by discrete elements");
    b.masonry.compressive_strength = None;
    // Joints so soft that the ring sinks through under its own weight: nothing is carried, whatever rigid blocks would carry.
    let mut soft = b.clone();
    for joint in [&mut soft.joint, &mut soft.ring_joint] {
        joint.normal_stiffness = Some(bridge::JointStiffness::Contact(4.84e7));
        joint.shear_stiffness = Some(bridge::JointStiffness::Contact(0.573e7));
    }
    let c = swept(&soft).discrete_elements.unwrap();
    assert_eq!((c.status, c.adequacy), (Some(Status::UnstableUnderSelfWeight), Some(0.0)));
    // Without stiffness there is no second method, and the sweep says so.
    b.joint.normal_stiffness = None;
    b.ring_joint.normal_stiffness = None;
    let c = swept(&b).discrete_elements.unwrap();
    assert!(c.adequacy.is_none() && c.reason.is_some_and(|r| r.contains("stiffness")));
}

/// The text of a rule with other values in the place of its factors, as an engineer's own file.
fn own_rule(b: &mut Bridge, code: &str, changes: &[(&str, &str)]) {
    let mut text = rules::FILES[1].iter().find(|f| f.0 == code).unwrap().1.to_owned();
    for (old, new) in changes {
        assert!(text.contains(old), "{old}");
        text = text.replacen(old, new, 1);
    }
    let plan = b.sweep.as_mut().unwrap();
    plan.rule_file = Some("own.toml".into());
    plan.texts = vec![("own.toml".into(), text)];
}

/// Factors on what resists divide it: a bridge with them is one of that much weaker stuff, and never stronger.
#[test]
fn factors_on_resistance_make_the_bridge_weaker() {
    let mut b = bridgemill(&["cs454-single"]);
    b.masonry.compressive_strength = Some(10e6);
    b.fill_pressure = Some(bridge::FillPressure {
        applies: true,
        friction_angle: 30f64.to_radians(),
        cohesion: 10e3,
        mobilisation: 0.5,
        cohesion_mobilisation: 0.1,
        least: bridge::LeastPressure::AtRest,
        half_movement: 0.02,
    });
    let factor = |name: &str, value: &str| {
        (format!("[factors.{name}]\nvalue = 1.0"), format!("[factors.{name}]\nvalue = {value}"))
    };
    // As described: what fill pressure adds is not counted, and would not show.
    let adequacy = |b: &Bridge| with_braking(b, &mut Unwatched).unwrap().vehicles[0].adequacy.unwrap();
    let plain = adequacy(&b);
    for name in ["masonry_strength", "friction", "fill_pressure"] {
        let (old, new) = factor(name, "1.25");
        let mut with = b.clone();
        own_rule(&mut with, "characteristic", &[(&old, &new)]);
        let mut weaker = b.clone();
        match name {
            "masonry_strength" => weaker.masonry.compressive_strength = Some(8e6),
            "friction" => {
                for joint in [&mut weaker.joint, &mut weaker.ring_joint] {
                    joint.friction_angle = (0.8 * joint.friction_angle.tan()).atan();
                }
            }
            _ => {
                let fill = weaker.fill_pressure.as_mut().unwrap();
                (fill.mobilisation, fill.cohesion_mobilisation) = (0.4, 0.08);
            }
        }
        let [with, weaker] = [adequacy(&with), adequacy(&weaker)];
        assert!((with / weaker - 1.0).abs() < 1e-9, "{name}: {with} {weaker}");
        assert!(with <= plain * (1.0 + 1e-9), "{name}: {with} {plain}");
    }
    let (rule, _) = {
        let (old, new) = factor("friction", "1.25");
        own_rule(&mut b, "characteristic", &[(&old, &new)]);
        chosen(&b, b.sweep.as_ref().unwrap()).unwrap()
    };
    let weights = Weights { masonry: 1.0, fill: Some(1.0), surfacing: None };
    let joint = factored::bridge(&b, &rule, &weights).joint;
    assert!((joint.friction_angle.tan() / b.joint.friction_angle.tan() - 0.8).abs() < 1e-12);
}

/// Every weight of the bridge has the factor of its own group.
#[test]
fn every_weight_has_the_factor_of_its_group() {
    let mut b = bridgemill(&[]);
    b.cover.layers.push(Layer { name: LayerKind::Surfacing, ..b.cover.layers[0].clone() });
    b.cover.layers.push(Layer { name: LayerKind::Ballast, ..b.cover.layers[0].clone() });
    b.cover.backing = Some(samples::backing(1.0));
    b.spandrel_wall = Some(samples::spandrel_wall(&b));
    let mut factored = b.clone();
    weights::put(&Weights { masonry: 2.0, fill: Some(3.0), surfacing: Some(5.0) }, &mut factored);
    assert_eq!(factored.masonry.density / b.masonry.density, 2.0);
    let layers: Vec<f64> =
        factored.cover.layers.iter().zip(&b.cover.layers).map(|(a, b)| a.density / b.density).collect();
    assert_eq!(layers, [3.0, 5.0, 5.0]);
    assert_eq!(factored.cover.backing.unwrap().density, 6000.0);
    assert_eq!(factored.spandrel_wall.unwrap().density, 4000.0);
}

/// A bridge and its mirror image: what drives to the right over one drives to the left over the other.
#[test]
fn a_mirrored_bridge_is_crossed_the_other_way() {
    let mut b = spans(2);
    b.spans[1].span = 4.0;
    b.spans[1].rise = 1.2;
    let mut mirrored = b.clone();
    mirrored.spans.reverse();
    let one = |b: &Bridge, ways: Directions| {
        let mut b = b.clone();
        b.sweep = Some(SweepPlan { directions: ways, step: Some(0.1), ..plan(&["hl-93-truck"]) });
        let v = swept(&b).vehicles.remove(0);
        (v.adequacy.unwrap(), v.case.unwrap())
    };
    for (ways, other) in [(Directions::Right, Directions::Left), (Directions::Left, Directions::Right)] {
        let (here, case) = one(&b, ways);
        let (there, seen) = one(&mirrored, other);
        // Positions do not fall on one another; the worst one is sought to a millimetre.
        assert!((here / there - 1.0).abs() < 1e-4, "{here} {there}");
        assert!((case.position + seen.position - 11.0).abs() < 0.05, "{case:?} {seen:?}");
    }
}

/// The rule spreads loads through the cover, and what is spread harms less.
#[test]
fn loads_spread_as_the_rule_says() {
    let mut b = bridgemill(&["cs454-single"]);
    own_rule(&mut b, "cs-454", &[("length_per_depth = 1.0", "length_per_depth = 0.0")]);
    let on_a_spot = swept(&b).vehicles[0].adequacy.unwrap();
    own_rule(&mut b, "cs-454", &[("length_per_depth = 1.0", "length_per_depth = 2.0")]);
    let wide = swept(&b).vehicles[0].adequacy.unwrap();
    b.sweep = Some(SweepPlan { rule: "cs-454".into(), ..plan(&["cs454-single"]) });
    let spread = swept(&b).vehicles[0].adequacy.unwrap();
    assert!(on_a_spot < 0.99 * spread && spread < 0.99 * wide, "{on_a_spot} {spread} {wide}");
}

/// Where joints slide, as those between rings do, the factor without dilation counts: it is never more than the associated one.
#[test]
fn sliding_without_dilation_counts() {
    let mut b = bridgemill(&["cs454-single"]);
    let ring = Ring { crown_thickness: 0.215, springing_thickness: 0.215, voussoirs: 20 };
    b.spans[0] = Span { span: 5.0, rise: 1.25, rings: vec![ring; 2], ..b.spans[0].clone() };
    (b.joint.friction_angle, b.ring_joint.friction_angle) = (35f64.to_radians(), 28f64.to_radians());
    let found = swept(&b);
    let v = &found.vehicles[0];
    let (level, [lower, _]) = (v.without_dilation.unwrap(), v.bounds.unwrap());
    assert!(level < 0.99 * lower, "{level} {lower}");
    assert!((v.adequacy.unwrap() / level - 1.0).abs() < 1e-9);
}

/// What the governing case carries where no load was found for it is below its load: no adequacy factor, and no bound from above.
#[test]
fn a_governing_case_without_an_answer_leaves_a_bound_from_above() {
    let found = swept(&bridgemill(&["cs454-single"]));
    let mut v = found.vehicles[0].clone();
    let mut run = *found.collapse.unwrap();
    let adequacy = v.adequacy.unwrap();
    run.status = Status::NotConverged;
    run.last_stable_load = run.last_stable_load.map(|load| 0.5 * load);
    for _ in 0..2 {
        v.governed_by(&run, 1.0);
        assert_eq!((v.status, v.adequacy, v.adequacy_at_most), (Status::NotConverged, None, Some(adequacy)));
    }
}

/// What discrete elements lack of limit analysis with crushing is what their joints give: it falls with the stiffness, and
/// carried on to rigid joints nothing is left but what one inset for all hinges costs, 3 %.
#[test]
fn discrete_elements_come_to_limit_analysis_as_joints_stiffen() {
    let mut b = bridgemill(&["cs454-bogie-10"]);
    b.masonry.compressive_strength = Some(6e6);
    b.plan.resolution = Some(1e3);
    b.sweep.as_mut().unwrap().discrete_elements = true;
    let gap = |times: f64| {
        let mut b = b.clone();
        for joint in [&mut b.joint, &mut b.ring_joint] {
            joint.normal_stiffness = Some(bridge::JointStiffness::Contact(4.84e9 * times));
            joint.shear_stiffness = Some(bridge::JointStiffness::Contact(0.573e9 * times));
        }
        let c = swept(&b).discrete_elements.unwrap();
        assert!(c.inset.is_some());
        1.0 - c.adequacy.unwrap() / c.limit.unwrap()
    };
    let [soft, stiff] = [2.0, 8.0].map(gap);
    assert!(stiff < 0.5 * soft && soft > 0.02, "{soft} {stiff}");
    let rigid = (4.0 * stiff - soft) / 3.0;
    assert!(rigid.abs() < 0.03, "{soft} {stiff}: {rigid}");
}

/// A vehicle with a multiple of another's loads is answered by the other, and by itself alike.
#[test]
fn a_multiple_of_a_vehicle_has_its_share_of_the_factor() {
    let mut b = bridgemill(&["hb-25", "hb-45"]);
    b.sweep.as_mut().unwrap().step = Some(0.9);
    let both = swept(&b).vehicles;
    b.sweep.as_mut().unwrap().vehicles = vec!["hb-45".into()];
    let alone = swept(&b).vehicles.remove(0);
    let twin = &both[1];
    assert_eq!((twin.cases, twin.status), (0, alone.status));
    assert!((both[0].adequacy.unwrap() / twin.adequacy.unwrap() - 45.0 / 25.0).abs() < 1e-9);
    assert!((twin.adequacy.unwrap() / alone.adequacy.unwrap() - 1.0).abs() < 1e-6);
    let [a, b] = [twin, &alone].map(|v| v.case.clone().unwrap());
    assert_eq!((a.position, a.axles, a.direction, a.weights), (b.position, b.axles, b.direction, b.weights));
    assert!((a.load / b.load - 1.0).abs() < 1e-9);
    assert_eq!((&twin.sections, twin.envelope.len()), (&alone.sections, alone.envelope.len()));
}

/// A rule acts on the load models that it was made for, and refuses others by name, all of them at once.
#[test]
fn a_vehicle_is_refused_under_a_rule_that_was_not_made_for_it() {
    let mut b = bridgemill(&["lm1", "hl-93-truck", "LM71", "cs454-single", "hb46"]);
    b.sweep.as_mut().unwrap().rule = "cs-454".into();
    let said = vehicle_sweep(&b, &mut Unwatched).unwrap_err().to_string();
    for part in ["\"lm1\"", "\"hl-93-truck\"", "\"LM71\"", "characteristic, en-1991-2", "[[under]]"] {
        assert!(said.contains(part), "{part}: {said}");
    }
    assert!(said.contains("\"hb46\"") && !said.contains("cs454-single\" of load"), "{said}");
    // Names are the same in capitals, and a near one is told.
    let known = bridgemill(&["LM71", "Cs454-Bogie-10"]);
    assert_eq!(chosen(&known, known.sweep.as_ref().unwrap()).unwrap().1.len(), 2);
    let near = bridgemill(&["cs454-bogie-11"]);
    let said = vehicle_sweep(&near, &mut Unwatched).unwrap_err().to_string();
    assert!(said.contains("write \"cs454-bogie-10\", or"), "{said}");
}

/// HB contains impact: under CS 454 it has 1.3 and nothing on top, where axles of CS 454 have 1.9 and 1.8 on the critical one.
#[test]
fn loads_that_contain_impact_get_none() {
    let mut b = bridgemill(&["hb-45", "cs454-single"]);
    b.sweep.as_mut().unwrap().rule = "cs-454".into();
    let found = swept(&b);
    let factors: Vec<[f64; 2]> = found.vehicles.iter().map(|v| v.load_factors).collect();
    assert_eq!(factors, [[1.3, 1.0], [1.9, 1.8]]);
    assert!(found.vehicles[0].case.as_ref().unwrap().critical_axle.is_none());
    let said: Vec<&str> = found.warnings.iter().map(|w| w.code()).collect();
    assert!(said.contains(&warning::RECALLED_FACTOR) && said.contains(&warning::NO_LONGITUDINAL), "{said:?}");
}

/// A load model is refused on spans for which it is known to fall short, and left out, with a word, where it was not named.
#[test]
fn spans_that_are_too_long_for_a_load_model_are_refused() {
    let mut b = spans(2);
    b.spans[1].span = 16.0;
    b.spans[1].rise = 4.0;
    b.sweep = Some(SweepPlan { rule: "irs-bridge-rules".into(), ..plan(&["25t-2008"]) });
    let said = vehicle_sweep(&b, &mut Unwatched).unwrap_err().to_string();
    assert!(said.contains("not made for spans over 14 m") && said.contains("16 m"), "{said}");
    b.sweep.as_mut().unwrap().vehicles.clear();
    let out = crate::vehicles::left_out(&b, b.sweep.as_ref().unwrap());
    assert!(out.len() == 2 && out[0].model == "25t-2008", "{out:?}");
    b.spans[1] = b.spans[0].clone();
    let (_, vehicles) = chosen(&b, b.sweep.as_ref().unwrap()).unwrap();
    assert!(vehicles.iter().any(|v| v.vehicle.code == "25t-2008"));
}

/// Load models that are taken only by name stay out of a sweep of all that a rule is made for; named, they are swept, and a
/// vehicle of uniform loads alone has a factor with both bounds.
#[test]
fn some_load_models_are_taken_only_by_name() {
    let mut b = bridgemill(&["sw-0", "lm2"]);
    let found = swept(&b);
    assert_eq!(found.vehicles.len(), 2);
    for (k, v) in found.vehicles.iter().enumerate() {
        let [lower, upper] = v.bounds.unwrap();
        assert!((upper / lower - 1.0).abs() < 1e-8, "{}: {lower} {upper}", v.code);
        assert!((lower / alone(&b, &found, k) - 1.0).abs() < 1e-6, "{}", v.code);
    }
    let case = found.vehicles[0].case.clone().unwrap();
    assert!(case.axles.is_none() && case.uniform.is_some(), "{case:?}");
    b.sweep.as_mut().unwrap().vehicles.clear();
    let (_, all) = chosen(&b, b.sweep.as_ref().unwrap()).unwrap();
    assert!(all.iter().any(|v| v.vehicle.code == "lm71") && all.iter().all(|v| v.vehicle.code != "sw-0"));
}

/// On spans of 3 and 12 m an axle has the coefficient of the span that it stands on, not the shortest's on both.
#[test]
fn motion_adds_by_the_span_that_is_loaded() {
    let mut b = spans(2);
    b.cover.depth = 0.0;
    b.spans[0].span = 3.0;
    b.spans[0].rise = 0.75;
    b.spans[1].span = 12.0;
    b.spans[1].rise = 3.0;
    b.sweep = Some(SweepPlan { rule: "irs-bridge-rules".into(), ..plan(&["25t-2008-close"]) });
    let (rule, vehicles) = chosen(&b, b.sweep.as_ref().unwrap()).unwrap();
    let foot = factored::footprint(&b, b.sweep.as_ref().unwrap(), &rule, &vehicles[0]);
    let long = 1.0 + 0.15 + 8.0 / 18.0;
    let places = [-1.0, 1.5, 3.5, 4.5, 10.0, 20.0].map(|x| foot.axle_at(x));
    for (found, wanted) in places.iter().zip([2.0, 2.0, 2.0, long, long, long]) {
        assert!((found - wanted).abs() < 1e-12, "{places:?}");
    }
    let pieces = foot.pieces(1.0, 6.0);
    for (found, wanted) in pieces.iter().zip([(1.0, 4.0, 2.0), (4.0, 6.0, long)]) {
        let apart = [found.0 - wanted.0, found.1 - wanted.1, found.2 - wanted.2];
        assert!(pieces.len() == 2 && apart.iter().all(|d| d.abs() < 1e-12), "{pieces:?}");
    }
}

/// Two vehicles abreast share the width between them, one at the edge lacks the width beyond it, and a lane's uniform load
/// stands on its own width.
#[test]
fn vehicles_abreast_and_at_the_edge_have_less_width() {
    let mut b = bridgemill(&["cs454-single"]);
    b.sweep.as_mut().unwrap().rule = "cs-454".into();
    let width = |b: &Bridge| {
        let (rule, vehicles) = chosen(b, b.sweep.as_ref().unwrap()).unwrap();
        across::worst(b, &rule, &vehicles[0])
    };
    let with = |b: &Bridge, lanes: Option<usize>, edge: Option<f64>| {
        let mut b = b.clone();
        b.carriageway = Some(bridge::Carriageway { lanes, edge_distance: edge, ..Default::default() });
        width(&b)
    };
    let alone = with(&b, Some(1), None);
    assert!((alone.axles - 3.778).abs() < 1e-9 && alone.abreast == 1, "{alone:?}");
    let two = with(&b, Some(2), None);
    assert!((two.axles - 0.5 * (3.778 + 2.5)).abs() < 1e-9 && two.abreast == 2, "{two:?}");
    assert_eq!(width(&b), two, "two fit on 8.3 m");
    let edge = with(&b, Some(1), Some(0.4));
    assert!(edge.derivation.ends_with("0.59 m of it lie beyond the edge"), "{edge:?}");
    assert!((edge.axles - (3.778 - (0.989 - 0.4))).abs() < 1e-9 && edge.at_edge, "{edge:?}");
    let both = with(&b, Some(2), Some(0.4));
    assert!((both.axles - 0.5 * (3.778 + 2.5 - 0.589)).abs() < 1e-9 && both.at_edge, "{both:?}");
    assert_eq!(with(&b, Some(1), Some(2.0)).axles, alone.axles, "far from the edge");
    // A barrel narrower than the load has spread carries as a whole, wherever the vehicle stands.
    b.width = 2.6;
    let narrow = with(&b, Some(1), Some(0.4));
    assert!((narrow.axles - 2.6).abs() < 1e-9 && narrow.derivation.contains("the barrel has 2.60 m"), "{narrow:?}");
    b.width = 8.3;
    // Multiple presence of HL-93: one lane counts 1.2, two count 1.
    b.sweep = Some(plan(&["hl-93-tandem"]));
    let one = width(&b);
    assert!((one.axles - 0.5 * (3.778 + 2.5)).abs() < 1e-9);
    // Its lane load stands on 3 m and what it spreads, not on an axle's width.
    let lane = (3.0 + 0.478) / 1.2;
    assert!((one.uniform[0] - lane).abs() < 1e-9, "{one:?}");
    // One abnormal vehicle at a time.
    b.sweep = Some(plan(&["hb-45"]));
    assert_eq!(width(&b).abreast, 1);
    // A skew bridge says that it was taken as square.
    let mut skew = bridgemill(&["cs454-single"]);
    skew.spans[0].skew = 0.3;
    let said: Vec<&str> = swept(&skew).warnings.iter().map(|w| w.code()).collect();
    assert!(said.contains(&warning::SKEW) && said.contains(&warning::ACROSS_ASSUMED), "{said:?}");
}

/// A resultant beside the middle of the track leaves the part that is centred on it, and the heavier rail its half of the width; it never
/// helps, and the width follows radius, speed, cant and side force without jumps.
#[test]
fn centrifugal_and_side_forces_move_the_resultant() {
    let mut b = bridgemill(&["cs454-single"]);
    b.sweep.as_mut().unwrap().rule = "cs-454".into();
    let (rule, vehicles) = chosen(&b, b.sweep.as_ref().unwrap()).unwrap();
    let width = |sideways: bridge::Sideways, edge: Option<f64>, lanes: usize| {
        let mut b = b.clone();
        b.carriageway =
            Some(bridge::Carriageway { lanes: Some(lanes), edge_distance: edge, sideways, ..Default::default() });
        across::worst(&b, &rule, &vehicles[0])
    };
    let none = bridge::Sideways::default();
    let alone = width(none, None, 1).axles;
    assert!((alone - 3.778).abs() < 1e-9);
    // By hand: 60 km/h on 300 m is 0.0944 of the weight, at 1.8 m of height 0.170 m outwards; cant of 90 mm on 1.5 m takes 0.108 m of it.
    let speed = 60.0 / 3.6;
    let curve = bridge::Sideways { curve: Some((300.0, speed)), ..none };
    let shift = 1.8 * speed * speed / (9.81 * 300.0);
    assert!((curve.eccentricity(9.81).0 - shift).abs() < 1e-12 && (shift - 0.1699).abs() < 1e-4, "{shift}");
    let canted = bridge::Sideways { cant: 0.09, ..curve };
    let (left, moving) = canted.eccentricity(9.81);
    assert!((left - 0.108).abs() < 1e-9 && !moving, "standing on the cant governs: {left}");
    // Centred part: 3.778 - 2 e; heavier rail: 3.778 / (1 + 2 e / 1.5).
    let found = width(curve, None, 1);
    assert!((found.axles - (alone - 2.0 * shift).min(alone / (1.0 + 2.0 * shift / 1.5))).abs() < 1e-9, "{found:?}");
    assert!(found.derivation.contains("that moves lies 0.170 m beside"), "{}", found.derivation);
    for edge in [None, Some(0.4)] {
        for lanes in [1, 2] {
            let mut before = width(none, edge, lanes).axles;
            for step in 1..=60 {
                let side = bridge::Sideways { side_force: 0.005 * f64::from(step), ..none };
                let found = width(side, edge, lanes).axles;
                assert!(found <= before + 1e-12 && found > 0.9 * before, "{edge:?} {lanes}: {found} after {before}");
                before = found;
            }
        }
    }
    // On strips between cracks the heavier wheel counts.
    let mut cracked = b.clone();
    let asked = |sideways| bridge::Carriageway {
        lanes: Some(1),
        edge_distance: Some(0.4),
        cracks: vec![0.8],
        sideways,
        ..Default::default()
    };
    cracked.carriageway = Some(asked(curve));
    let strip = across::worst(&cracked, &rule, &vehicles[0]);
    assert!((strip.axles - 0.8 / (0.5 + shift / 1.5)).abs() < 1e-9, "{strip:?}");
    // The result says what is left out of forces across.
    let mut told = b.clone();
    told.carriageway = Some(asked(curve));
    assert!(swept(&told).warnings.iter().any(|w| w.message().contains("not as forces on walls")));
}

/// A longitudinal crack never helps, follows its place without jumps, and leaves an edge strip what a closed form says.
#[test]
fn longitudinal_cracks_leave_strips() {
    for code in ["cs454-single", "cs454-double", "hl-93-tandem"] {
        let mut b = bridgemill(&[code]);
        b.sweep.as_mut().unwrap().rule = "cs-454".into();
        let Ok((rule, vehicles)) = chosen(&b, b.sweep.as_ref().unwrap()) else { continue };
        let width = |cracks: &[f64], lanes: Option<usize>, edge: Option<f64>| {
            let mut b = b.clone();
            let asked =
                bridge::Carriageway { lanes, edge_distance: edge, cracks: cracks.to_vec(), ..Default::default() };
            b.carriageway = Some(asked);
            across::worst(&b, &rule, &vehicles[0])
        };
        let sound = width(&[], Some(1), Some(0.4));
        let mut last: Option<f64> = None;
        for step in 1..830 {
            let at = 0.01 * f64::from(step);
            let one = width(&[at], Some(1), Some(0.4));
            assert!(one.axles <= sound.axles + 1e-12, "{code}: a crack at {at} m helps");
            assert_eq!(one.strip.is_some(), one.axles < sound.axles - 1e-12);
            let mirrored = width(&[b.width - at], Some(1), Some(0.4));
            assert!((one.axles - mirrored.axles).abs() < 1e-9, "{code}, {at} m: {} {}", one.axles, mirrored.axles);
            let two = width(&[at.min(4.0), 4.1], Some(1), Some(0.4));
            assert!(two.axles <= width(&[4.1], Some(1), Some(0.4)).axles + 1e-9, "{code}: a second crack helps");
            // A tyre is 0.3 m wide: over 10 mm its share changes by a thirtieth, and what it stands on by no more than that.
            if let Some(last) = last {
                assert!((one.axles / last - 1.0).abs() < 0.15, "{code}: from {last} to {} at {at} m", one.axles);
            }
            last = Some(one.axles);
        }
        // A crack at the very edge changes nothing.
        assert!((width(&[1e-6], Some(1), Some(0.4)).axles - sound.axles).abs() < 1e-5);
    }
    // One wheel on an edge strip 0.8 m wide, 0.4 m from the edge: half the axle on 0.8 m, as the whole axle on 1.6 m.
    let mut b = bridgemill(&["cs454-single"]);
    b.sweep.as_mut().unwrap().rule = "cs-454".into();
    b.carriageway =
        Some(bridge::Carriageway { lanes: Some(1), edge_distance: Some(0.4), cracks: vec![0.8], ..Default::default() });
    let (rule, vehicles) = chosen(&b, b.sweep.as_ref().unwrap()).unwrap();
    let found = across::worst(&b, &rule, &vehicles[0]);
    assert!((found.axles - 1.6).abs() < 1e-9 && found.strip == Some([0.0, 0.8]), "{found:?}");
    assert!(found.derivation.contains("1.60 m"), "{}", found.derivation);
}

/// Cohesion and tension of joints are divided as friction and strength are.
#[test]
fn cohesion_of_joints_has_a_factor() {
    let mut b = bridgemill(&["cs454-single"]);
    b.sweep.as_mut().unwrap().rule = "cs-454".into();
    for joint in [&mut b.joint, &mut b.ring_joint] {
        (joint.cohesion, joint.tensile_strength) = (100e3, 40e3);
    }
    let (rule, _) = chosen(&b, b.sweep.as_ref().unwrap()).unwrap();
    let weights = Weights { masonry: 1.0, fill: Some(1.0), surfacing: None };
    let factored = factored::bridge(&b, &rule, &weights);
    for joint in [factored.joint, factored.ring_joint] {
        assert_eq!((joint.cohesion, joint.tensile_strength), (50e3, 20e3), "as the strength of masonry, 2");
    }
    let text = rules::FILES[1].iter().find(|f| f.0 == "cs-454").unwrap().1;
    let own = format!(
        "{text}\n[factors.cohesion]\nvalue = 4.0\nsource = {{ text = \"own\", date = \"2026\", confidence = \"assumed\" }}\n"
    );
    let own = rules::read_rule("own.toml", &own).unwrap();
    assert_eq!(factored::bridge(&b, &own, &weights).joint.cohesion, 25e3);
}

/// What stands beside an abnormal vehicle is found from what each carries by itself. Both on the bridge at once, on the width that they
/// share, carry no less, and not much more: they are worst at the same place.
#[test]
fn traffic_beside_an_abnormal_vehicle_is_counted_on_the_safe_side() {
    let mut b = bridgemill(&["hb-30"]);
    b.sweep.as_mut().unwrap().rule = "cs-454".into();
    let plan = b.sweep.clone().unwrap();
    let found = swept(&b);
    let least = found.vehicles[0].adequacy.unwrap();
    let (rule, bare) = chosen(&b, &plan).unwrap();
    let given = (&found.weights[..], found.step);
    let with = beside::loaded(&b, (&rule, &plan), bare.clone(), given, &mut Unwatched).unwrap();
    let lane = with[0].beside.clone().unwrap();
    assert!(lane.share > 0.1 && found.vehicles[0].across.beside == lane.code, "{lane:?}");
    // The traffic by itself, at its own worst place, on a lane of its own.
    let mut own = b.clone();
    own.carriageway = Some(bridge::Carriageway { lanes: Some(1), ..bridge::Carriageway::default() });
    own.sweep.as_mut().unwrap().vehicles = vec![lane.code.clone()];
    let traffic = swept(&own);
    let (_, theirs) = chosen(&own, own.sweep.as_ref().unwrap()).unwrap();
    // Both cases under the weights of the first, each over the width that both share.
    let case = found.vehicles[0].case.as_ref().unwrap();
    let shared = found.vehicles[0].across.axles * (1.0 + lane.share);
    let factored = factored::bridge(&b, &rule, &case.weights);
    let first = factored::with_case(&factored, &plan, &rule, &bare[0], case);
    let second = factored::with_case(&factored, &plan, &rule, &theirs[0], traffic.vehicles[0].case.as_ref().unwrap());
    let (share, length) = (bare[0].acting.beside.as_ref().unwrap().share, structure::discretise::bridge_length(&b));
    // The bridge is symmetric: the traffic's worst place is on either side.
    let together = [false, true].map(|mirrored| {
        let mut both = first.clone();
        both.loads.iter_mut().for_each(|load| on_width(load, shared, 1.0));
        both.loads.extend(second.loads.iter().cloned().map(|mut load| {
            on_width(&mut load, shared, share);
            load.position = if mirrored { length - load.position } else { load.position };
            load
        }));
        both.plan.friction = bridge::Friction::Associated;
        let run = crate::analysis::collapse_by_limit(&both, &mut Unwatched).unwrap();
        run.collapse_load.unwrap() / run.reference_load * rule.capacity_factor()
    });
    let together = together[0].min(together[1]);
    assert!(least <= together * (1.0 + 1e-6) && least > 0.8 * together, "{least} {together}");
}

/// An axle of a share of its force over a width.
fn on_width(load: &mut bridge::Load, width: f64, share: f64) {
    let bridge::LoadKind::Axles { axles, effective_width, .. } = &mut load.kind else { panic!("an axle") };
    axles.iter_mut().for_each(|axle| axle.0 *= share);
    *effective_width = width;
}
