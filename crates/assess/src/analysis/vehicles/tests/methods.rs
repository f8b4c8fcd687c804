//! The governing case by the other methods, and without dilation.

use super::factors::own_rule;
use super::*;

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

/// One search, two questions: the loads of a file that stand as a vehicle without factors does come to what the vehicle comes to, also where
/// joints slide.
#[test]
fn loads_of_a_file_carry_what_a_vehicle_without_factors_carries() {
    let mut sliding = spans(1);
    let ring = Ring { crown_thickness: 0.22, springing_thickness: 0.22, voussoirs: 21 };
    sliding.spans[0].rings = vec![ring.clone(), ring];
    for (b, slides) in [(bridgemill(&["cs454-bogie-10"]), false), (sliding, true)] {
        let found = swept(&b);
        let vehicle = &found.vehicles[0];
        assert_eq!(vehicle.without_dilation.is_some(), slides);
        let governs = vehicle.case.clone().unwrap();
        let (rule, all) = chosen(&b, b.sweep.as_ref().unwrap()).unwrap();
        let axles = Some([0, all[0].vehicle.patterns()[0].axles.len() - 1]);
        let case = outcome::vehicles::Case { axles, ..governs };
        let factored = factored::bridge(&b, &rule, &case.weights);
        let one = factored::with_case(&factored, b.sweep.as_ref().unwrap(), &rule, &all[0], &case);
        let places = crate::analysis::Places::Every(found.step);
        let loads = crate::analysis::sweep(&one, places, true, &mut Unwatched).unwrap();
        let [by_file, by_rule] =
            [loads.worst().and_then(|point| point.load_factor), vehicle.adequacy].map(Option::unwrap);
        // Worst places are sought to a hundredth of a step, from other positions: near a minimum that is a change of second order.
        assert!((by_file / by_rule - 1.0).abs() < 1e-4, "{by_file} {by_rule}");
    }
}
