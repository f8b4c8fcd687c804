//! What leads a result is carried: by every method, with walls, where a run stalls, and where positions found no answer.

use super::vehicles::vehicle_sweep;
use super::*;
use crate::samples;
use bridge::{Directions, JointContact, Ring, Span, SweepPlan};
use mechanics::watch::{Progress, Unwatched, Wish};
use outcome::collapse::Status;
use outcome::sweep::Ended;
use outcome::warning;

fn limit(b: &Bridge) -> Collapse {
    collapse(
        &Bridge { plan: bridge::Plan { method: Method::Limit, ..b.plan.clone() }, ..b.clone() },
        None,
        &mut Unwatched,
    )
    .unwrap()
}

fn codes(warnings: &[outcome::warning::Warning]) -> Vec<&str> {
    warnings.iter().map(|w| w.code()).collect()
}

/// A short ring that discrete elements make collapse in a moment.
fn short() -> Bridge {
    let mut b = samples::bridgemill();
    let ring = Ring { crown_thickness: 0.4, springing_thickness: 0.4, voussoirs: 15 };
    b.spans[0] = Span { span: 5.0, rise: 1.25, rings: vec![ring], ..b.spans[0].clone() };
    b.loads[0].position = 1.25;
    b.masonry.rounding = 0.002;
    b.dispersal.rule = bridge::DispersalRule::Uniform;
    for joint in [&mut b.joint, &mut b.ring_joint] {
        joint.normal_stiffness = Some(bridge::JointStiffness::Contact(40e9));
        joint.shear_stiffness = Some(bridge::JointStiffness::Contact(15e9));
        (joint.fixed_length, joint.least_length) = (None, None);
    }
    (b.plan.load_step, b.plan.load_limit) = (None, None);
    b
}

/// Masonry of 1.5 MPa: limit analysis lets its hinges crush, the contact points of discrete elements hardly do.
fn weak() -> Bridge {
    let mut b = short();
    b.masonry.compressive_strength = Some(1.5e6);
    b
}

#[test]
fn the_headline_is_the_smaller_of_the_methods() {
    let found = collapse(&weak(), None, &mut Unwatched).unwrap();
    let (stable, crushing) = (found.last_stable_load.unwrap(), found.crushing_limit_load.unwrap());
    assert!(stable > 1.04 * crushing, "contact points leave crushing out: {stable} {crushing}");
    let headline = found.headline().unwrap();
    assert_eq!(headline.load, crushing, "{}", headline.from);
    assert!(headline.from.contains("limit analysis"), "{}", headline.from);
    let by_limit = limit(&weak());
    assert!((by_limit.carried().unwrap() / crushing - 1.0).abs() < 1e-6);
    // Where discrete elements carry less, they lead.
    let strong = collapse(&short(), None, &mut Unwatched).unwrap();
    let least = strong.last_stable_load.unwrap().min(strong.limit_load.unwrap());
    assert_eq!(strong.carried(), Some(least));
}

#[test]
fn discrete_elements_say_that_joints_bear_on_two_points_and_that_crushing_is_left_out() {
    let found = collapse(&weak(), None, &mut Unwatched).unwrap();
    let said = codes(&found.warnings);
    assert!(said.contains(&warning::TWO_POINT_JOINTS) && said.contains(&warning::CRUSHING_LEFT_OUT), "{said:?}");
    let crushing = found.warnings.iter().find(|w| w.code() == warning::CRUSHING_LEFT_OUT).unwrap();
    assert!(
        crushing.message().contains(&format!("{:.2} kN/m", found.crushing_limit_load.unwrap() / 1e3)),
        "{crushing:?}"
    );
    let by_limit = limit(&weak());
    assert!(!codes(&by_limit.warnings).contains(&warning::TWO_POINT_JOINTS));
    let mut distributed = weak();
    distributed.plan.contact = Some(JointContact::Distributed);
    let found = collapse(&distributed, None, &mut Unwatched).unwrap();
    assert!(!codes(&found.warnings).contains(&warning::TWO_POINT_JOINTS));
    let told = outcome::note::Blocks::DiscreteElements { distributed: true };
    assert!(found.assumptions.contains(&told.into()));
}

#[test]
fn a_stalled_run_has_no_collapse_load() {
    use mechanics::dem;
    let d = structure::discretise::discretise(&short()).unwrap();
    let program = dem::Program { increment: 1.0, limit: 1.0, resolution: None, watched: d.watched };
    let mut outcome =
        dem::collapse(&d.model, &d.loading, &program, &engine::dem::settings(&short()), None, &mut Unwatched).unwrap();
    outcome.collapse_factor = Some(3.0);
    for (status, collapse, stalled) in
        [(dem::Status::Stalled, None, Some(3e3)), (dem::Status::Collapsed, Some(3e3), None)]
    {
        outcome.status = status;
        let mut c = engine::dem::report(&short(), &d, &outcome, "test", &|factor| d.load(factor));
        engine::dem::loads(&outcome, &d, &mut c);
        assert_eq!((c.collapse_load, c.stalled_load), (collapse, stalled));
        notes::dem(&short(), &d, &mut c);
        assert_eq!(codes(&c.warnings).contains(&warning::STALLED), stalled.is_some());
    }
}

#[test]
fn with_walls_the_headline_is_the_sum_of_what_the_strips_carry() {
    let mut b = short();
    b.width = 3.0;
    b.spandrel_wall = Some(samples::spandrel_wall(&b));
    b.plan.strip = bridge::Strip::Both;
    b.plan.method = Method::Limit;
    let found = collapse(&b, None, &mut Unwatched).unwrap();
    let (both, wall) = (found.combination.clone().unwrap(), found.wall_strip.clone().unwrap());
    let thick = b.spandrel_wall.as_ref().unwrap().thickness;
    let Some(on_wall) = wall.carried() else { return assert_eq!(found.headline(), None) };
    let sum = found.last_stable_load.unwrap() * (3.0 - thick) + on_wall * thick;
    assert!((both.headline.unwrap() / sum - 1.0).abs() < 1e-12);
    let headline = found.headline().unwrap();
    assert!((headline.whole / sum - 1.0).abs() < 1e-12 && (headline.load * 3.0 / sum - 1.0).abs() < 1e-12);
    let object = found.object();
    for key in ["headline_kn", "last_stable_load_kn"] {
        assert!((object[key].as_f64().unwrap() * 1e3 / sum - 1.0).abs() < 1e-9, "{key}: {}", object[key]);
    }
}

#[test]
fn the_load_that_is_carried_stands_first() {
    for b in [short(), weak()] {
        let found = limit(&b);
        let text = outcome::published::json(&found.object());
        let at = |key: &str| text.find(&format!("\"{key}\"")).unwrap_or_else(|| panic!("{key} in {text}"));
        assert!(at("headline_kn_per_m") < at("last_stable_load_kn_per_m"));
        assert!(at("last_stable_load_kn_per_m") < at("collapse_load_kn_per_m"));
        assert!(at("last_stable_load_kn") < at("collapse_load_kn"));
        assert_eq!(found.carried(), found.limit().unwrap().lower_bound);
    }
}

/// Two half-brick rings that may slide on one another, under two vehicles.
fn two_rings(vehicles: &[&str]) -> Bridge {
    let mut b = samples::bridgemill();
    let ring = Ring { crown_thickness: 0.215, springing_thickness: 0.215, voussoirs: 24 };
    b.spans[0] = Span { span: 5.0, rise: 1.25, rings: vec![ring; 2], ..b.spans[0].clone() };
    (b.width, b.cover.depth) = (3.0, 0.3);
    b.cover.layers = vec![samples::fill(0.3, 1900.0)];
    (b.joint.friction_angle, b.ring_joint.friction_angle) = (35f64.to_radians(), 28f64.to_radians());
    b.masonry.rounding = 0.0001;
    b.plan.method = Method::Limit;
    b.sweep = Some(SweepPlan {
        rule: "characteristic".into(),
        rule_file: None,
        vehicles: vehicles.iter().map(|v| v.to_string()).collect(),
        vehicle_files: Vec::new(),
        step: Some(0.5),
        directions: Directions::Right,
        subsets: false,
        own_dispersal: false,
        braking: 0.0,
        braking_given: false,
        braking_reason: None,
        condition_factor: None,
        discrete_elements: false,
        texts: Vec::new(),
    });
    b
}

/// However the way without dilation ends: a sweep is never completed on a governing run that found no answer, and never
/// above what that run carries.
#[test]
fn a_sweep_never_says_more_than_its_governing_run() {
    let b = two_rings(&["cs454-single"]);
    let found = vehicle_sweep(&b, &mut Unwatched).unwrap();
    let v = &found.vehicles[found.governing.unwrap()];
    let run = found.collapse.as_ref().unwrap();
    match run.carried() {
        Some(load) => {
            let by_itself = load / run.reference_load * found.rule.capacity_factor();
            assert!(v.factor().unwrap() <= by_itself * (1.0 + 1e-6), "{:?} {by_itself}", v.factor());
        }
        None => {
            assert_eq!((found.status(), v.adequacy), (Ended::Undetermined, None));
            assert!(v.positions_not_converged > 0 && v.adequacy_at_most.is_some());
            assert!(codes(&found.warnings).contains(&warning::POSITIONS_NOT_CONVERGED));
            assert!(codes(&found.warnings).contains(&warning::ASSOCIATED_SLIDING));
        }
    }
}

/// Stops after so many steps.
struct After(u64);

impl Watch for After {
    fn look(&mut self, progress: &Progress) -> Wish {
        if progress.steps >= self.0 { Wish::Stop } else { Wish::GoOn }
    }
}

#[test]
fn a_sweep_that_is_stopped_keeps_what_is_done_and_settles_nothing() {
    let mut b = samples::bridgemill();
    b.plan.method = Method::Limit;
    let stopped = sweep(&b, Places::Every(0.02), true, &mut After(20)).unwrap();
    assert!(!stopped.whole && stopped.ended() == Ended::Cancelled);
    assert!((20..900).contains(&stopped.points.len()), "{}", stopped.points.len());
    b.sweep = two_rings(&["cs454-bogie-10", "cs454-single"]).sweep;
    b.sweep.as_mut().unwrap().step = Some(0.02);
    let stopped = vehicle_sweep(&b, &mut After(20)).unwrap();
    assert_eq!(stopped.status(), Ended::Cancelled);
    assert!(stopped.vehicles.iter().any(|v| !v.envelope.is_empty()));
    assert!(stopped.vehicles.iter().all(|v| v.adequacy.is_none() && v.status == Status::Cancelled));
    assert_eq!(stopped.headline(), None);
}

#[test]
fn the_worst_position_is_sought_between_the_positions_until_every_axle_has_crossed() {
    let mut b = samples::bridgemill();
    b.plan.method = Method::Limit;
    b.loads[0].kind =
        bridge::LoadKind::Axles { axles: vec![(50e3, 0.0), (150e3, 12.0)], contact_length: 0.3, effective_width: 3.0 };
    let coarse = sweep(&b, Places::Every(2.0), true, &mut Unwatched).unwrap();
    let fine = sweep(&b, Places::Every(0.05), true, &mut Unwatched).unwrap();
    let [coarse_least, fine_least] = [&coarse, &fine].map(|s| s.worst().unwrap().load_factor.unwrap());
    assert!((coarse_least / fine_least - 1.0).abs() < 2e-3, "{coarse_least} {fine_least}");
    // Both quarters are reached by the heavy axle, whichever side of the first load it stands.
    let places: Vec<f64> = coarse.points.iter().map(|p| p.position).collect();
    let offset = structure::discretise::dispersal::strips(&b.loads[0], -b.loads[0].position)[1].middle;
    let reached = |x: f64| places.iter().any(|p| p + offset <= x) && places.iter().any(|p| p + offset >= x);
    assert!(reached(0.01) && reached(18.29), "{places:?} {offset}");
    assert!(places.windows(2).all(|pair| pair[0] <= pair[1]));
}

#[test]
fn positions_of_a_check_do_not_grow_apart_with_the_length_of_the_bridge() {
    let mut b = short();
    b.plan.method = Method::Limit;
    b.spans = vec![b.spans[0].clone(); 8];
    b.piers = vec![bridge::Pier::plain(1.0, 1.0, 3.0, 3); 7];
    let found = crate::chain::ultimate(&b, &mut Unwatched).unwrap().unwrap();
    let swept = &found.sweep;
    assert!(swept.step <= 5.0 / 60.0 + 1e-9, "{}", swept.step);
    assert!(found.facts.positions > 500 && found.facts.positions_not_converged == 0, "{:?}", found.facts);
    // The worst place of a finer sweep around it is the same one.
    let worst = found.facts.position_m.unwrap();
    let fine = sweep(&b, Places::Between([worst - 0.1, worst + 0.1], 81), true, &mut Unwatched).unwrap();
    let least = fine.worst().unwrap().load_factor.unwrap();
    assert!((found.facts.load_factor.unwrap() / least - 1.0).abs() < 1e-4, "{:?} {least}", found.facts.load_factor);
}
