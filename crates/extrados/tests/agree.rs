//! The page and the command agree: of every rule and every vehicle of the library that it is made for, the load view, the sweep and the
//! verdict say one number.

use extrados::results::collapse::Status;
use extrados::results::note::{Moving, Note};
use extrados::results::vehicles::{Direction, VehicleSweep};
use extrados::{
    AssessOptions, Choice, Means, Memory, Placing, Project, Refusal, StageName, SweepOptions, Swept, Unwatched,
    VehicleChoice, library,
};

/// A bridge small enough for every vehicle under every rule, with what its `[sweep]` has, and more; it may not be usable.
fn bridge(sweep: &str, more: &str) -> Project {
    let text = format!(
        r#"
bridge = {{ name = "Small", width = "5.5 m" }}
masonry = {{ density = "2200 kg/m^3", compressive_strength = "10 MPa" }}
joint = {{ friction_angle = "40 deg", cohesion = "0 kPa" }}
cover = [{{ layer = "fill", thickness = "0.40 m", density = "1900 kg/m^3" }}]
dispersal = {{ rule = "uniform", slope = "2:1" }}
span = [{{ profile = "segmental", span = "4.0 m", rise = "1.0 m", thickness = "0.40 m", voussoirs = 13 }}]
load = [{{ kind = "knife-edge", force = "1 kN/m", length = "0.3 m", at = "1/4 of span 1" }}]
sweep = {{ step = "0.4 m", {sweep} }}
{more}
"#
    );
    Project::read("bridge.toml", &Memory::default().with("bridge.toml", text.as_str())).expect("a file")
}

fn swept(project: &Project) -> Result<VehicleSweep, Refusal> {
    match extrados::sweep(project, &SweepOptions::default(), &mut Unwatched)? {
        Swept::Vehicles(found) => Ok(*found),
        Swept::Loads(_) => panic!("vehicles"),
    }
}

/// Adequacy factors of an assessment, vehicle by vehicle.
fn assessed(project: &Project) -> Vec<(String, Option<f64>)> {
    let skip = vec![StageName::Collapse, StageName::Sensitivity, StageName::Service, StageName::SupportMovement];
    let options = AssessOptions { skip, command: "test".to_owned(), day: "2026-01-01".to_owned() };
    let found = extrados::assess(project, &options, &Means::default(), &mut Unwatched).expect("an assessment");
    let facts = found.expect("it is not stopped").assessment.facts.vehicles;
    let facts = facts.made().expect("vehicles");
    facts.vehicles.iter().map(|one| (one.code.clone(), one.adequacy)).collect()
}

fn same(a: Option<f64>, b: Option<f64>, within: f64) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() <= within * a.abs().max(b.abs()),
        (a, b) => a == b,
    }
}

/// Whether the load view says of every vehicle of a sweep, where it governs, what the sweep says, and no less beside it.
fn agrees(project: &Project, found: &VehicleSweep) -> usize {
    let mut compared = 0;
    for one in &found.vehicles {
        let (Some(case), Some(adequacy)) = (&one.case, one.adequacy) else { continue };
        let leftward = case.direction == Direction::Left;
        let asked = VehicleChoice { vehicle: one.code.clone(), rule: found.rule.code.clone(), leftward };
        let mut placing = Placing::vehicle(project, &Choice::default(), &asked).expect("it is put");
        let what = format!("{} under {}: {}", one.code, found.rule.code, placing.factors());
        let answer = placing.put(case.position);
        let told = (answer.factor, &answer.case);
        assert!(same(answer.factor, Some(adequacy), 1e-6), "{what}: {told:?} and {adequacy} by {case:?}");
        assert!(same(placing.carried(case.position).factor, Some(adequacy), 1e-6), "{what}");
        // Whatever was asked before.
        let along = [case.position - 0.2, case.position].map(|place| placing.carried(place).factor);
        assert!(same(along[1], Some(adequacy), 1e-6), "{what}: {along:?} and {adequacy}");
        let quick = placing.put_quickly(case.position).factor.expect("a number");
        assert!(quick >= adequacy * (1.0 - 1e-6), "{what}: {quick} and {adequacy}");
        // The load of the state that is drawn is that of the case.
        let load = answer.case.as_ref().map(|case| case.load);
        assert!(same(Some(answer.reference), load, 1e-9), "{what}: {} and {load:?}", answer.reference);
        compared += 1;
    }
    compared
}

#[test]
fn load_view_sweep_and_verdict_say_one_number_of_every_rule_and_vehicle() {
    let library = library().expect("the library");
    let mut compared = 0;
    for rule in &library.rules {
        let mut of_rule = 0;
        let plain = bridge(&format!("rule = {:?}", rule.code), "");
        for model in &library.models {
            let project = bridge(&format!("rule = {:?}, vehicles = [{:?}]", rule.code, model.code), "");
            let (vehicle, rule_code) = (model.vehicles[0].code.clone(), rule.code.clone());
            let asked = VehicleChoice { vehicle, rule: rule_code, leftward: false };
            let put = Placing::vehicle(&plain, &Choice::default(), &asked);
            // A rule that is not made for a model refuses it, in the load view as in a sweep.
            let found = match (swept(&project), put) {
                (Ok(found), Ok(_)) => found,
                (Err(refusal), Err(refused)) => {
                    assert!(refusal.message.contains("is not made for") && refused.message.contains("is not made for"));
                    continue;
                }
                (swept, put) => panic!("{} under {}: {:?} {:?}", model.code, rule.code, swept.err(), put.err()),
            };
            let of_model = agrees(&project, &found);
            let carried = found.vehicles.iter().filter(|one| one.status == Status::Collapsed).count();
            assert_eq!(of_model, carried, "{} under {}", model.code, rule.code);
            let swept: Vec<(String, Option<f64>)> =
                found.vehicles.iter().map(|one| (one.code.clone(), one.factor())).collect();
            let assessed = assessed(&project);
            assert_eq!(assessed.len(), swept.len(), "{} under {}", model.code, rule.code);
            for ((code, by_sweep), (other, by_verdict)) in swept.iter().zip(&assessed) {
                assert!(code == other && same(*by_sweep, *by_verdict, 1e-12), "{code}: {by_sweep:?} {by_verdict:?}");
            }
            of_rule += of_model;
        }
        assert!(of_rule > 0, "{} is tried with no vehicle", rule.code);
        compared += of_rule;
    }
    assert!(compared > 100, "{compared}");
}

/// Lanes, an edge, braking and curvature act in the load view as in a sweep.
#[test]
fn what_else_acts_in_a_sweep_acts_in_the_load_view() {
    for (sweep, more) in [
        ("braking = 0.25", ""),
        ("braking = 0.25, directions = \"left\"", ""),
        ("subsets = false", ""),
        ("dispersal = \"file\"", ""),
        ("directions = \"right\"", "carriageway = { lanes = 2, lane_width = \"2.5 m\", edge_distance = \"0.5 m\" }"),
    ] {
        let sweep = format!("rule = \"cs-454\", vehicles = [\"cs454-single\", \"cs454-bogie-8\", \"hb-45\"], {sweep}");
        let project = bridge(&sweep, more);
        assert!(agrees(&project, &swept(&project).expect(&sweep)) > 0, "{sweep} {more}");
    }
}

/// The page says which factors act; loads of the file have none.
#[test]
fn the_factors_that_act_are_named() {
    let project = bridge("rule = \"cs-454\"", "");
    let placing = Placing::loads(&project, &Choice::default()).expect("it is put");
    assert!(placing.factors().starts_with("nominal"), "{}", placing.factors());
    let asked = VehicleChoice { vehicle: "cs454-single".to_owned(), ..VehicleChoice::default() };
    let placing = Placing::vehicle(&project, &Choice::default(), &asked).expect("it is put");
    assert_eq!(placing.factors(), "factors: live load 1.9, impact 1.8 on the critical axle");
    assert!(placing.assumptions().iter().any(|said| matches!(said, Note::Moving(Moving::Width { .. }))));
}
