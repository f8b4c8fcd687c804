//! Sweeps of vehicles against analyses of one case at a time.

mod factors;
mod methods;
mod widths;

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
        condition_factor: None,
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

/// Where normal traffic is not carried, the weight limit is looked up: the same grades as by asking for them, and nothing else changes. Where it is
/// carried, where the limit was asked for, and beside abnormal vehicles alone, nothing is.
#[test]
fn a_weight_limit_is_looked_up_where_normal_traffic_is_not_carried() {
    let with = |ring: f64, vehicles: &[&str]| {
        let mut b = spans(1);
        let ring = Ring { crown_thickness: ring, springing_thickness: ring, voussoirs: 21 };
        b.spans[0].rings = vec![ring];
        b.sweep = Some(bridge::SweepPlan { rule: "cs-454".into(), ..plan(vehicles) });
        b
    };
    let sought = |b: &Bridge| vehicle_sweep_with_restrictions(b, &mut Unwatched).unwrap();
    let weak = with(0.40, &["cs-454"]);
    let (found, plain) = (sought(&weak), swept(&weak));
    assert!(plain.headline().unwrap().0 < 1.0 && plain.grades().is_empty());
    assert_eq!((found.headline(), found.vehicles.len()), (plain.headline(), plain.vehicles.len()));
    let (own, asked) = (found.grades(), swept(&with(0.40, &["gb-restrictions"])).grades());
    assert_eq!((own.len(), &own[0].highest, &own[0].carried), (1, &asked[0].highest, &asked[0].carried));
    // Axles that nobody read are told of the limit as of any vehicle, of those that were moved alone.
    let told: Vec<String> = found
        .warnings
        .iter()
        .filter(|one| one.code() == outcome::warning::VEHICLE_NOT_READ)
        .map(|one| one.message())
        .collect();
    assert!(told.iter().any(|words| words.contains("gb-3t") && !words.contains("gb-44t")), "{told:?}");
    assert!(
        own[0].highest.is_some() && own[0].not_carried.len() == 1 && own[0].not_carried[0] == asked[0].not_carried[0]
    );
    for b in [with(0.70, &["cs-454"]), with(0.40, &["gb-13t"]), with(0.30, &["hb-45"])] {
        let found = sought(&b);
        assert_eq!(found.restrictions, Vec::new(), "{:?}", found.headline());
    }
    assert!(sought(&with(0.30, &["hb-45"])).headline().unwrap().0 < 1.0);
}

/// The condition of the barrel multiplies what is carried, and no factor of an inspector raises it.
#[test]
fn a_condition_factor_of_the_file_takes_its_share() {
    let mut b = spans(1);
    b.sweep = Some(bridge::SweepPlan { rule: "cs-454".into(), ..plan(&["cs454-single"]) });
    let whole = swept(&b);
    b.sweep.as_mut().unwrap().condition_factor = Some(0.8);
    let found = swept(&b);
    let [whole_factor, less] = [&whole, &found].map(|one| one.vehicles[0].adequacy.unwrap());
    assert!((less / whole_factor - 0.8).abs() < 1e-9, "{less} of {whole_factor}");
    assert_eq!(found.rule.factors.condition.source.confidence, rules::Confidence::Read);
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
        let axles: Vec<_> = one.envelope.iter().map(|point| point.case.axles).collect();
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
