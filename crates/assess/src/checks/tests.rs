//! Checks on facts made by hand.

use super::check::used;
use super::*;
use bridge::assess::{Assess, Limits};
use bridge::passage::Face;
use outcome::assessment::{Facts, Stage};
use outcome::checked::{Judgement, Rung, Unit};
use outcome::collapse::{Criterion, Status};
use outcome::facts::{
    AugmentFacts, JointFacts, MovementFacts, SafetyFacts, SectionFacts, ServiceFacts, ServiceLoadFacts, SweptFacts,
    UltimateFacts, VehicleFacts,
};
use outcome::facts::{Reading, RingSection, Watched};
use outcome::vehicles::PermissibleFactor;
use rules::Confidence;

fn place(place: RingSection, quantity: Watched, self_weight: f64, minimum: f64, maximum: f64) -> SectionFacts {
    SectionFacts {
        place,
        quantity,
        about: format!("{place} of span 1"),
        span: 1,
        face: Face::Intrados,
        self_weight,
        minimum,
        minimum_at_m: 3.0,
        maximum,
        maximum_at_m: 9.0,
        minimum_span: 1,
        maximum_span: 1,
    }
}

/// The numbers of the railway paper's first two rows: live load at rest is the printed column over 1 + CDA.
fn assessment() -> Evidence {
    let bridge = crate::samples::bridgemill();
    let live = -0.67 / 1.817;
    let load = ServiceLoadFacts {
        name: "25t".into(),
        places: vec![
            place(RingSection::Crown, Watched::Deflection, 0.09, live, 0.01),
            place(RingSection::Crown, Watched::Stress, 0.009, -0.04, 0.001),
            place(RingSection::Abutment, Watched::Stress, -0.83, -0.37, 0.1),
        ],
        joints: vec![JointFacts {
            reading: Reading::Total,
            augment: 0.817,
            shear_augment: 0.817,
            eccentricity_augment: 0.817,
            shear_mpa: 0.4,
            eccentricity: 0.2,
            ..JointFacts::default()
        }],
        ..ServiceLoadFacts::default()
    };
    let augment = AugmentFacts { total: 0.817, design: 0.6, ..AugmentFacts::default() };
    let service = ServiceFacts { augment, loads: vec![load], ..ServiceFacts::default() };
    let ultimate = UltimateFacts { status: Status::Collapsed, load_factor: Some(4.0), ..UltimateFacts::default() };
    let limits = Limits {
        deflection: Some(1.25e-3),
        compression: Some(2.589e6),
        tension: Some(0.2589e6),
        joint_shear: Some(1e6),
        thrust_zone: Some(0.5),
        adequacy_factor: Some(2.0),
        adequacy_source: Some("a test, clause 1".into()),
        load_factor_included: 1.0,
        model_factor: Some(1.0),
        permissible_share: Some(0.5),
        movement_factor: 1.0,
        ..Limits::default()
    };
    Evidence {
        bridge,
        asked: Assess { limits, ..Assess::default() },
        statics: None,
        doubts: Vec::new(),
        assumed: Vec::new(),
        facts: Facts {
            update: Stage::NotAsked("no records".into()),
            service: Stage::Made(service),
            ultimate: Stage::Made(ultimate),
            vehicles: Stage::NotAsked("no sweep".into()),
            cases: Stage::NotAsked(String::new()),
            movement: Stage::NotAsked("no support moves".into()),
            sensitivity: Stage::NotAsked("later".into()),
        },
    }
}

/// A vehicle that was moved over the bridge.
fn vehicle(code: &str, adequacy: Option<f64>, status: Status) -> SweptFacts {
    SweptFacts { code: code.into(), status, adequacy, loads_confidence: Confidence::Read, ..SweptFacts::default() }
}

/// A rule's factor on live loads and its model factor, each with how sure it is.
fn safety(live_load: (f64, Confidence), model: (f64, Confidence)) -> SafetyFacts {
    SafetyFacts {
        rule: "own".into(),
        live_load: live_load.0,
        live_load_confidence: live_load.1,
        model: model.0,
        model_confidence: model.1,
        ..SafetyFacts::default()
    }
}

/// An assessment by the six axles of CS 454, of masonry with a strength, square as the file says.
fn by_cs_454() -> Evidence {
    let mut a = assessment();
    a.asked.limits = Limits { load_factor_included: 1.0, movement_factor: 1.0, ..Limits::default() };
    a.facts.ultimate = Stage::NotAsked("no load".into());
    a.bridge.masonry.compressive_strength = Some(8e6);
    a.bridge.sweep =
        Some(bridge::SweepPlan { rule: "cs-454".into(), ..crate::analysis::vehicles::tests::plan(&["cs-454"]) });
    a
}

/// Vehicles under a rule with this safety.
fn moved(vehicles: Vec<SweptFacts>, safety: SafetyFacts) -> Stage<VehicleFacts> {
    Stage::Made(VehicleFacts { vehicles, safety, ..VehicleFacts::default() })
}

#[test]
fn the_crown_has_the_columns_of_table_7() {
    let found = (crown_deflection::CHECK.run)(&assessment()).unwrap();
    let [own, design, sum, total, whole] = found[1].columns.as_ref().unwrap().values;
    // Printed to hundredths: -0.59, -0.50, -0.67, -0.58 mm.
    for (ours, printed) in [(own, 0.09), (design, -0.59), (sum, -0.50), (total, -0.67), (whole, -0.58)] {
        assert!((ours - printed).abs() < 0.006, "{ours} {printed}");
    }
    assert!((found[1].utilisation - 0.58 / 1.25).abs() < 1e-9 && found[1].met());
}

/// A limit that is missing is asked for by the form of its line and a place to look for it: a value would be another bridge's.
#[test]
fn a_check_that_lacks_its_limit_offers_no_value() {
    let mut a = assessment();
    a.asked = Assess::default();
    let asked: Vec<String> = CHECKS
        .iter()
        .filter_map(|check| (check.run)(&a).err())
        .filter(|not_made| not_made.why.contains("the file gives no limit: write "))
        .map(|not_made| not_made.why)
        .collect();
    assert!(asked.len() >= 8, "{asked:?}");
    for why in &asked {
        assert!(!why.contains(|letter: char| letter.is_ascii_digit()), "{why}");
        assert!(
            why.contains("in [assess], from the ") || why.contains("in [assess], as ") || why.contains("from tests"),
            "{why}"
        );
    }
}

#[test]
fn codes_are_unique_and_in_order_and_say_something() {
    assert!(CHECKS.windows(2).all(|pair| pair[0].code < pair[1].code));
    assert!(CHECKS.iter().all(|card| card.text.len() > 100 && !card.source.is_empty() && !card.clause.is_empty()));
}

#[test]
fn the_largest_utilisation_governs_and_failures_leave_nothing_settled() {
    let mut a = assessment();
    let checked = run(&a);
    let (check, finding) = governing(&checked).unwrap();
    let worst = &checked[check].outcome.as_ref().unwrap()[finding];
    // 0.2 of the depth against 0.25.
    assert_eq!((checked[check].code.as_str(), worst.utilisation), ("C106", 0.8));
    let judged = |a: &Evidence| verdict(a, &run(a));
    assert_eq!((judged(&a).status, judged(&a).strength.assessed), (Judgement::Adequate, true));
    a.facts.ultimate = Stage::Failed("no answer".into());
    assert_eq!((judged(&a).status, judged(&a).finished), (Judgement::Undetermined, false));
    a.asked.limits.joint_shear = Some(0.3e6);
    assert_eq!(judged(&a).status, Judgement::Inadequate);
    a.asked = Assess::default();
    a.facts.ultimate = Stage::NotAsked("no load".into());
    assert_eq!((judged(&a).status, judged(&a).finished), (Judgement::Undetermined, true));
}

/// Limits that are met are no verdict on strength: not without a source of the factor, nor with a factor of 1.
#[test]
fn limits_that_are_met_assess_no_strength() {
    let mut a = assessment();
    a.asked.limits.adequacy_source = None;
    let found = verdict(&a, &run(&a));
    assert_eq!((found.status, found.headline), (Judgement::Undetermined, Rung::Undetermined));
    assert!(
        found.finished && found.strength.missing.iter().any(|words| words.contains("adequacy_source")),
        "{found:?}"
    );
    let sourced = Some("a test".to_owned());
    (a.asked.limits.adequacy_source, a.asked.limits.adequacy_factor) = (sourced, Some(1.0));
    assert_eq!(verdict(&a, &run(&a)).status, Judgement::Undetermined);
    a.asked.limits.load_factor_included = 1.9;
    assert_eq!(verdict(&a, &run(&a)).status, Judgement::Adequate);
}

/// A rule without a factor on live loads passes nothing, and turns down what fails even so.
#[test]
fn a_rule_without_safety_passes_no_vehicle() {
    let mut a = by_cs_454();
    let mut with = |adequacy: f64, live_load: f64, confidence: Confidence| {
        let heavy = vehicle("heavy", Some(adequacy), Status::Collapsed);
        a.facts.vehicles = moved(vec![heavy], safety((live_load, confidence), (1.0, Confidence::Read)));
        let found = verdict(&a, &run(&a));
        (found.status, found.strength.assessed)
    };
    assert_eq!(with(24.0, 1.0, Confidence::Read), (Judgement::Undetermined, false));
    assert_eq!(with(24.0, 1.9, Confidence::Assumed), (Judgement::Undetermined, false));
    assert_eq!(with(0.99, 1.0, Confidence::Read).0, Judgement::Inadequate);
    assert_eq!(with(1.01, 1.9, Confidence::Recalled), (Judgement::Adequate, true));
    assert_eq!(with(0.99, 1.9, Confidence::Recalled).0, Judgement::Inadequate);
}

/// A standard's factors cover its own method; under an engineer's own, and where the file asks for it, the model factor of tests counts.
#[test]
fn the_model_factor_of_tests_counts_under_factors_that_are_no_standards() {
    let mut a = by_cs_454();
    let judged = |a: &mut Evidence, adequacy: f64| {
        let heavy = vehicle("heavy", Some(adequacy), Status::Collapsed);
        a.facts.vehicles = moved(vec![heavy], safety((1.9, Confidence::Recalled), (1.0, Confidence::Recalled)));
        let found = verdict(a, &run(a));
        (found.status, found.strength.missing.join("; ").contains("tests to collapse"))
    };
    assert_eq!(judged(&mut a, 1.01), (Judgement::Adequate, false));
    assert_eq!(judged(&mut a, 0.99), (Judgement::Inadequate, false));
    // On purpose: then it is part of the limit.
    a.asked.limits.model_factor_of_tests = true;
    assert_eq!(judged(&mut a, 1.5), (Judgement::Inadequate, false));
    assert_eq!(judged(&mut a, 1.91), (Judgement::Adequate, false));
    a.asked.limits.model_factor_of_tests = false;
    // The same rule in a file of the engineer's, whose model factor nobody read; and one that was.
    let standard = include_str!("../../../rules/data/rules/cs-454.toml");
    let own = standard.replace("code = \"cs-454\"", "code = \"own\"");
    let mut with_file = |text: &str| {
        let plan = a.bridge.sweep.as_mut().unwrap();
        (plan.rule_file, plan.texts) = (Some("own.toml".into()), vec![("own.toml".into(), text.to_owned())]);
        let heads = [1.5, 1.91].map(|adequacy| judged(&mut a, adequacy));
        (heads, verdict(&a, &run(&a)).head())
    };
    let (found, head) = with_file(&own);
    assert_eq!(found, [(Judgement::Undetermined, true), (Judgement::Adequate, false)]);
    assert!(head.starts_with("Adequate by rule \"own\" of own.toml"), "{head}");
    let at = own.find("[factors.model]").unwrap();
    let read = own[..at].to_owned() + &own[at..].replacen("\"recalled\"", "\"read\"", 1);
    assert_eq!(with_file(&read).0[0], (Judgement::Adequate, false));
    // Under the factor of a file: 4.0 is carried, 2.5 asked for.
    let mut a = assessment();
    (a.asked.limits.adequacy_factor, a.asked.limits.model_factor) = (Some(2.5), None);
    assert_eq!(verdict(&a, &run(&a)).status, Judgement::Undetermined);
    a.asked.limits.adequacy_factor = Some(2.0);
    assert_eq!(verdict(&a, &run(&a)).status, Judgement::Adequate);
}

/// A rule is met by every load case, with strength, dispersal, directions and positions as it asks, and with every stage that the file asks
/// for: one thing less, and the verdict is open and says what to write.
#[test]
fn a_rule_is_met_by_all_that_it_asks_for() {
    let passed = |a: &mut Evidence| {
        let safety = safety((1.9, Confidence::Recalled), (1.0, Confidence::Recalled));
        a.facts.vehicles = moved(vec![vehicle("heavy", Some(2.0), Status::Collapsed)], safety);
    };
    let judged = |change: &dyn Fn(&mut Evidence)| {
        let mut a = by_cs_454();
        passed(&mut a);
        change(&mut a);
        let found = verdict(&a, &run(&a));
        (found.status, found.head() + ": " + &found.strength.missing.join("; "))
    };
    let plan = |a: &mut Evidence, change: &dyn Fn(&mut bridge::SweepPlan)| change(a.bridge.sweep.as_mut().unwrap());
    let (status, head) = judged(&|_| {});
    assert!(status == Judgement::Adequate && head.starts_with("Adequate by CS 454 ("), "{head}");
    type Change<'a> = &'a dyn Fn(&mut Evidence);
    let open: [(&str, Change); 8] = [
        ("cs454-triple-8", &|a| plan(a, &|plan| plan.vehicles = vec!["cs454-single".into()])),
        ("cs454-single", &|a| plan(a, &|plan| plan.vehicles = vec!["hb-45".into()])),
        ("compressive_strength", &|a| a.bridge.masonry.compressive_strength = None),
        ("dispersal", &|a| plan(a, &|plan| plan.own_dispersal = true)),
        ("directions", &|a| plan(a, &|plan| plan.directions = bridge::Directions::Right)),
        ("subsets", &|a| plan(a, &|plan| plan.subsets = false)),
        ("step", &|a| plan(a, &|plan| plan.step = Some(8.0))),
        ("--skip vehicles", &|a| {
            a.facts.vehicles = Stage::LeftOut { stage: "vehicles".into(), why: "left out by --skip vehicles".into() }
        }),
    ];
    for (words, change) in open {
        let (status, told) = judged(change);
        assert!(status == Judgement::Undetermined && told.contains(words), "{words}: {told}");
    }
    // An update that was left out counts for all checks, a passage for none that was asked for.
    let left = |stage: &str| (stage.to_owned(), format!("left out by --skip {stage}"));
    let (status, told) = judged(&|a| {
        let (stage, why) = left("update");
        a.facts.update = Stage::LeftOut { stage, why };
    });
    assert!(status == Judgement::Undetermined && told.contains("update left out"), "{told}");
    let (status, _) = judged(&|a| {
        let (stage, why) = left("service");
        a.facts.service = Stage::LeftOut { stage, why };
    });
    assert_eq!(status, Judgement::Adequate);
    // One grade of a restriction stands for itself.
    let (status, told) = judged(&|a| plan(a, &|plan| plan.vehicles = vec!["gb-18t".into()]));
    assert!(status == Judgement::Adequate && told.contains("for 18 t"), "{told}");
}

/// What is doubtful, changed or taken stands in the line of the verdict itself.
#[test]
fn the_head_names_what_qualifies_it() {
    let mut a = by_cs_454();
    let safety = SafetyFacts {
        changed_factors: vec![rules::ChangedFactor {
            factor: "live load".into(),
            library: "1.9".into(),
            file: "1.2".into(),
            source: "owner".into(),
        }],
        ..safety((1.9, Confidence::Recalled), (1.0, Confidence::Recalled))
    };
    a.facts.vehicles = moved(vec![vehicle("heavy", Some(2.0), Status::Collapsed)], safety);
    a.doubts = vec![outcome::given::Doubt { code: "P001".into(), message: "density".into() }];
    let found = verdict(&a, &run(&a));
    let head = found.head();
    for words in ["not the library's: live load", "1 doubtful value", "skew not given"] {
        assert!(head.contains(words), "{words}: {head}");
    }
    let beside = found.beside().join("; ");
    assert!(beside.contains("live load 1.2 in place of 1.9 (source named: owner)"), "{beside}");
    assert!(beside.contains("record: 7 bridges tested to collapse"), "{beside}");
}

/// A vehicle that limit analysis left open is neither passed nor forgotten; one that fails is turned down all the same.
#[test]
fn a_vehicle_left_open_leaves_the_verdict_open() {
    let mut a = by_cs_454();
    let mut with = |other: f64| {
        let vehicles =
            vec![vehicle("light", Some(other), Status::Collapsed), vehicle("heavy", None, Status::NotConverged)];
        a.facts.vehicles = moved(vehicles, safety((1.9, Confidence::Read), (0.0, Confidence::Assumed)));
        let found = verdict(&a, &run(&a));
        (found.status, found.finished)
    };
    assert_eq!(with(2.0), (Judgement::Undetermined, false));
    assert_eq!(with(0.9), (Judgement::Inadequate, true));
}

/// An answer is missing at some position, but the others turn the bridge down already: the true factor is not above theirs.
#[test]
fn what_fails_at_some_position_fails_whatever_the_others_say() {
    let mut a = by_cs_454();
    let mut with = |at_most: f64| {
        let vehicle = SweptFacts {
            code: "heavy".into(),
            status: Status::NotConverged,
            adequacy_at_most: Some(at_most),
            positions: 271,
            position_m: Some(3.0),
            positions_not_converged: 1,
            ..SweptFacts::default()
        };
        let safety = SafetyFacts { live_load: 1.9, live_load_confidence: Confidence::Read, ..SafetyFacts::default() };
        a.facts.vehicles = Stage::Made(VehicleFacts { vehicles: vec![vehicle], safety, ..VehicleFacts::default() });
        let basis = (vehicles::CHECK.run)(&a).map(|found| found[0].basis.clone()).unwrap_or_default();
        (verdict(&a, &run(&a)).status, basis.contains("at most: 1 of 271 positions have no answer"))
    };
    assert_eq!(with(0.4), (Judgement::Inadequate, true));
    assert_eq!(with(1.4), (Judgement::Undetermined, false));
}

/// A square model is no bound for a skew bridge, and assumed loads are nobody's: neither makes a bridge adequate, and what is
/// missing says what to write.
#[test]
fn skew_and_assumed_loads_give_no_verdict_of_adequacy() {
    let mut a = by_cs_454();
    let sourced = SafetyFacts {
        live_load: 1.9,
        live_load_confidence: Confidence::Read,
        model: 1.0,
        model_confidence: Confidence::Read,
        ..SafetyFacts::default()
    };
    let vehicle = |confidence: Confidence| SweptFacts {
        code: "wagon".into(),
        status: Status::Collapsed,
        adequacy: Some(3.0),
        loads_confidence: confidence,
        ..SweptFacts::default()
    };
    let mut with = |confidence: Confidence, skew: f64, source: Option<&str>| {
        a.facts.vehicles = Stage::Made(VehicleFacts {
            vehicles: vec![vehicle(confidence)],
            safety: sourced.clone(),
            ..VehicleFacts::default()
        });
        a.bridge.spans[0].skew = skew.to_radians();
        a.asked.limits.skew_source = source.map(str::to_owned);
        let found = verdict(&a, &run(&a));
        (found.status, found.strength.missing.join(" "))
    };
    assert_eq!(with(Confidence::Read, 0.0, None).0, Judgement::Adequate);
    assert_eq!(with(Confidence::Recalled, 10.0, None).0, Judgement::Adequate);
    let (status, missing) = with(Confidence::Assumed, 0.0, None);
    assert!(status == Judgement::Undetermined && missing.contains("of wagon assumed"), "{status} {missing}");
    let (status, missing) = with(Confidence::Read, 20.0, None);
    assert!(
        status == Judgement::Undetermined && missing.contains("skew by 20 degrees") && missing.contains("skew_source")
    );
    assert_eq!(with(Confidence::Read, 20.0, Some("model in three dimensions, report 12")).0, Judgement::Adequate);
}

/// A sweep of minutes is not repeated for every value of the file: what is left to do is named.
#[test]
fn values_of_a_slow_sweep_are_not_tried() {
    let mut a = assessment();
    let mut with = |slow_cases| {
        let vehicles = vec![SweptFacts { slow_cases, ..vehicle("heavy", Some(0.2), Status::Collapsed) }];
        let safety = safety((1.9, Confidence::Read), (1.0, Confidence::Read));
        a.facts.vehicles = Stage::Made(VehicleFacts { vehicles, safety, ..VehicleFacts::default() });
        let document = bridge::edit::Document::parse("").unwrap();
        crate::chain::sensitivity(&document, &a, &run(&a), &mut mechanics::watch::Unwatched).unwrap_err().to_string()
    };
    assert!(with(5_000).contains("make them with extrados vary"));
    // The bridge of this test has no [sweep] to repeat.
    assert!(with(20).contains("no utilisation"));
}

#[test]
fn the_stress_range_follows_its_bound() {
    let mut a = assessment();
    a.asked.limits.load_cycles = Some(1e6);
    let why = (fatigue::CHECK.run)(&a).unwrap_err();
    assert!(why.why.contains("compressive_strength"), "{}", why.why);
    a.bridge.masonry.compressive_strength = Some(10e6);
    let found = (fatigue::CHECK.run)(&a).unwrap();
    // Abutment: most 0.83 + 1.6 x 0.37 = 1.422, least 0.83 - 0.16 = 0.67; root of 0.752 x 1.422 over 10.
    assert!((found[0].value - (0.752_f64 * 1.422).sqrt() / 10.0).abs() < 1e-12);
    assert!((found[0].limit - 0.4).abs() < 1e-12);
}

#[test]
fn a_limit_of_nothing_is_met_by_nothing_else() {
    assert_eq!((used(0.0, 0.0), used(-1.0, 0.0), used(1.0, 0.0)), (0.0, 0.0, f64::MAX));
}

#[test]
fn a_thrust_without_a_zone_is_told_and_not_judged() {
    let mut a = assessment();
    a.asked.limits.thrust_zone = None;
    let why = (thrust::CHECK.run)(&a).unwrap_err();
    assert!(!why.failed && why.why.contains("thrust_zone =") && why.why.contains("0.200 of the depth"), "{}", why.why);
    a.facts.service = Stage::NotAsked("no train".into());
    assert!(!(thrust::CHECK.run)(&a).unwrap_err().why.contains("in service"));
}

/// Compression is negative and has its own limit; what stays compressed uses nothing of the limit on tension. By hand from the
/// facts: -0.83 - 1.6 x 0.37, and -0.83 + 1.6 x 0.1.
#[test]
fn stresses_have_their_sign_their_side_and_their_unit() {
    let found = (stress::ABUTMENT.run)(&assessment()).unwrap();
    let [pressed, pulled, ..] = &found[..] else { panic!("{found:?}") };
    assert!((pressed.value + 1.422).abs() < 1e-12 && (pressed.limit + 2.589).abs() < 1e-12, "{pressed:?}");
    assert!((pressed.utilisation - 1.422 / 2.589).abs() < 1e-12 && pressed.unit == Unit::Megapascal);
    assert!((pulled.value + 0.67).abs() < 1e-12 && (pulled.limit - 0.2589).abs() < 1e-12, "{pulled:?}");
    assert_eq!(pulled.utilisation, 0.0);
    // A live load that pulls by 1.0 leaves -0.83 + 1.6.
    let mut a = assessment();
    let Stage::Made(facts) = &mut a.facts.service else { panic!() };
    facts.loads[0].places[2].maximum = 1.0;
    let found = (stress::ABUTMENT.run)(&a).unwrap();
    assert!((found[1].value - 0.77).abs() < 1e-12 && !found[1].met(), "{:?}", found[1]);
    let shear = (joint_shear::CHECK.run)(&a).unwrap();
    assert_eq!((shear[0].value, shear[0].limit, shear[0].utilisation), (0.4, 1.0, 0.4));
}

/// More capacity uses less of the limit, and the two readings of one number are reciprocal.
#[test]
fn a_stronger_bridge_uses_less() {
    let mut a = assessment();
    let used = |a: &Evidence| {
        [(adequacy::CHECK.run)(a).unwrap()[0].clone(), (permissible::CHECK.run)(a).unwrap()[0].clone()]
            .map(|finding| finding.utilisation)
    };
    // 2 asked of 4; 1/4 of the ultimate load, half is permitted.
    assert_eq!(used(&a), [0.5, 0.5]);
    a.facts.ultimate =
        Stage::Made(UltimateFacts { status: Status::Collapsed, load_factor: Some(8.0), ..UltimateFacts::default() });
    assert_eq!(used(&a), [0.25, 0.25]);
}

/// A share of a load that is not known is no met limit.
#[test]
fn a_bridge_that_does_not_stand_settles_nothing_of_its_share() {
    let mut a = assessment();
    a.asked.limits.adequacy_factor = None;
    let with = |status: Status| UltimateFacts { status, ..UltimateFacts::default() };
    for (status, failed) in
        [(Status::UnstableUnderSelfWeight, true), (Status::NotConverged, true), (Status::Locks, false)]
    {
        a.facts.ultimate = Stage::Made(with(status));
        assert_eq!((permissible::CHECK.run)(&a).unwrap_err().failed, failed, "{status}");
    }
    a.asked.limits.adequacy_factor = Some(1.0);
    a.facts.ultimate = Stage::Made(with(Status::UnstableUnderSelfWeight));
    assert_eq!(verdict(&a, &run(&a)).status, Judgement::Inadequate);
}

/// The smaller of both methods counts, for the vehicle that was made by both.
#[test]
fn discrete_elements_count_where_they_carry_less() {
    let at = |code: &str, adequacy: f64| SweptFacts {
        position_m: Some(3.0),
        ..vehicle(code, Some(adequacy), Status::Collapsed)
    };
    let mut a = assessment();
    let mut with = |by_dem: f64| {
        a.facts.vehicles = Stage::Made(VehicleFacts {
            vehicles: vec![at("heavy", 1.1), at("light", 2.0)],
            governing: Some("heavy".into()),
            adequacy_by_discrete_elements: Some(by_dem),
            safety: safety((1.9, Confidence::Read), (0.0, Confidence::Assumed)),
            ..VehicleFacts::default()
        });
        let found = (vehicles::CHECK.run)(&a).unwrap();
        assert_eq!(found[1].value, 2.0);
        found[0].clone()
    };
    let less = with(0.8);
    assert_eq!((less.value, less.utilisation, less.met()), (0.8, 1.25, false));
    assert!(less.basis.starts_with("discrete elements (limit analysis 1.100)"), "{}", less.basis);
    let more = with(1.3);
    assert_eq!((more.value, more.met()), (1.1, true));
    assert!(more.basis.starts_with("limit analysis;"), "{}", more.basis);
    assert_eq!(with(0.0).utilisation, f64::MAX);
}

/// A factor on a movement makes what may be expected smaller.
#[test]
fn a_movement_is_compared_with_what_stood_over_its_factor() {
    let mut a = assessment();
    (a.asked.limits.expected_movement, a.asked.limits.movement_factor) = (Some(0.02), 2.0);
    a.facts.movement = Stage::Made(MovementFacts { last_stable_mm: Some(50.0), ..MovementFacts::default() });
    let found = (movement::CHECK.run)(&a).unwrap();
    assert_eq!((found[0].value, found[0].limit, found[0].utilisation), (20.0, 25.0, 0.8));
}

/// Nominal vehicles are compared, and the thrust that leaves a middle third is not; without deformable joints there is nothing
/// to compare.
#[test]
fn states_in_service_are_compared_for_nominal_loads() {
    let onset = |criterion, adequacy| PermissibleFactor { criterion, adequacy, position: 3.0 };
    let one = SweptFacts {
        permissible: vec![
            onset(Criterion::MiddleThird, 0.1),
            onset(Criterion::HalfOpen, 0.6),
            onset(Criterion::HalfStrength, 0.8),
        ],
        ..vehicle("heavy", Some(1.4), Status::Collapsed)
    };
    let mut a = assessment();
    a.asked.limits.onset_factor = Some(1.0);
    a.facts.vehicles = moved(vec![one], SafetyFacts { live_load: 1.5, ..SafetyFacts::default() });
    let found = (onset::CHECK.run)(&a).unwrap();
    assert!((found[0].value - 0.9).abs() < 1e-12 && !found[0].met(), "{found:?}");
    assert!(!found[0].strength && found[0].basis.contains("half open"), "{found:?}");
    a.facts.vehicles = moved(Vec::new(), SafetyFacts::default());
    assert!((onset::CHECK.run)(&a).unwrap_err().why.contains("method = \"path\""));
    a.asked.limits.onset_factor = None;
    assert!((onset::CHECK.run)(&a).unwrap_err().why.contains("onset_factor"));
}
