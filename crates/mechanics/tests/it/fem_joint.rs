//! Laws of pairs of facing points.

use crate::fem_law::Dice;
use crate::fem_tools::{bed_of_mortar, tie};
use mechanics::fem::joint::{Contact, JointLaw, LiftOff, Mortar, PairMemory, PairState, Shear};

const FRESH: PairMemory = PairMemory { slip: 0.0, crush: 0.0, broken: false, state: PairState::Closed };

fn mortar() -> Mortar {
    Mortar { lift_off: LiftOff::Force(1e3), ..bed_of_mortar(1.25e9, 0.19, 0.0125) }
}

fn panel(when_open: bool) -> Shear {
    Shear::Panel { strength: 1e6, when_open }
}

/// A bed that rubs: friction 0.6 and a cohesion [Pa].
fn rubbing(cohesion: f64) -> Mortar {
    Mortar { shear: Shear::Friction { coefficient: 0.6, cohesion }, ..mortar() }
}

fn contact(separation: bool) -> Contact {
    Contact { normal: 10e9, tangential: 4e9, friction: 0.4, cohesion: 0.0, separation, rounding: 0.0 }
}

fn all() -> Vec<JointLaw> {
    vec![
        tie(100e9, 40e9),
        JointLaw::Mortar(mortar()),
        JointLaw::Mortar(Mortar { compressive_strength: Some(5e6), shear: panel(true), ..mortar() }),
        JointLaw::Mortar(rubbing(0.0)),
        JointLaw::Mortar(rubbing(2e5)),
        JointLaw::Mortar(Mortar { compressive_strength: Some(5e6), lift_off: LiftOff::Stress(0.0), ..rubbing(2e5) }),
        JointLaw::Contact(contact(true)),
        JointLaw::Contact(contact(false)),
        JointLaw::Contact(Contact { cohesion: 2e5, ..contact(true) }),
        JointLaw::Contact(Contact { cohesion: 2e5, ..contact(false) }),
    ]
}

#[test]
fn a_bed_of_mortar_has_the_stiffness_of_the_railway_paper() {
    // Equation 1 there: E A / (l n) a spring, 6.17 E for 0.54 m of depth, 12.5 mm of mortar and 7 springs.
    let area = 0.54 / 7.0;
    let answer = mortar().respond([-1e-6, 0.0], area, &FRESH);
    assert!((answer.tangent[0][0] * area / 1.25e9 - 6.17).abs() < 0.005);
}

#[test]
fn mortar_holds_until_it_is_broken_and_never_again() {
    let (law, area) = (mortar(), 0.54 / 7.0);
    let limit = 1e3 / area / law.normal;
    let before = law.respond([limit * 0.999, 0.0], area, &FRESH);
    assert!(before.state == PairState::Closed && before.traction[0] * area > 0.99e3 && !before.memory.broken);
    let overstress = |opening: f64, memory: &PairMemory| {
        let tension = law.respond([opening, 0.0], area, memory).traction[0];
        JointLaw::Mortar(law).overstress(tension, area, memory)
    };
    assert!((overstress(limit * 0.999, &FRESH) - 0.999).abs() < 1e-12);
    // Whoever seeks balance breaks it; until then it answers as if it were whole, and says how far it is beyond its strength.
    let beyond = law.respond([limit * 3.0, 1e-6], area, &FRESH);
    assert!(beyond.state == PairState::Closed && beyond.tangent == before.tangent && !beyond.memory.broken);
    assert!((overstress(limit * 3.0, &FRESH) - 3.0).abs() < 1e-12);
    let broken = PairMemory { broken: true, ..FRESH };
    assert_eq!(overstress(limit * 3.0, &broken), 0.0);
    let after = law.respond([limit * 1.001, 1e-6], area, &broken);
    assert!(after.state == PairState::Open && after.traction == [0.0, 0.0] && after.tangent == [[0.0; 2]; 2]);
    let again = law.respond([limit * 0.5, 1e-6], area, &after.memory);
    assert!(again.state == PairState::Open && again.traction[0] == 0.0);
    // Closed again it presses, and its shear starts from where it touched.
    let shut = law.respond([-1e-6, 2e-6], area, &again.memory);
    assert!(
        (shut.traction[0] + law.normal * 1e-6).abs() < 1e-6 && (shut.traction[1] - law.tangential * 1e-6).abs() < 1e-3
    );
}

#[test]
fn mortar_without_strength_opens_at_once() {
    let law = Mortar { lift_off: LiftOff::Stress(0.0), ..mortar() };
    let open = law.respond([1e-12, 0.0], 0.1, &FRESH);
    assert!(open.state == PairState::Open && open.traction == [0.0, 0.0] && open.memory.broken);
    assert_eq!(JointLaw::Mortar(law).overstress(1.0, 0.1, &FRESH), 0.0);
}

#[test]
fn mortar_crushes_for_good() {
    let law = Mortar { compressive_strength: Some(5e6), ..mortar() };
    let crushed = law.respond([-1e-4, 0.0], 0.1, &FRESH);
    assert!(crushed.traction[0] == -5e6 && crushed.tangent[0][0] == 0.0);
    let back = law.respond([-1e-4 + 2e-5, 0.0], 0.1, &crushed.memory);
    assert!((back.traction[0] + 5e6 - 2e-5 * law.normal).abs() < 1.0 && back.tangent[0][0] == law.normal);
}

#[test]
fn a_panel_slides_at_its_strength_and_remembers() {
    let law = mortar();
    let slid = law.respond([-1e-5, 1e-3], 0.1, &FRESH);
    assert!(slid.state == PairState::Sliding && slid.traction[1] == 1e6 && slid.tangent[1] == [0.0, 0.0]);
    let back = law.respond([-1e-5, 1e-3 - 1e-6], 0.1, &slid.memory);
    assert!(back.state == PairState::Closed && (back.traction[1] - (1e6 - 1e-6 * law.tangential)).abs() < 1e-3);
    let panels = Mortar { shear: panel(true), ..law };
    let open = panels.respond([1e-3, 1e-3], 0.1, &PairMemory { broken: true, ..FRESH });
    assert!(open.state == PairState::Open && open.traction == [0.0, 1e6]);
}

/// Coulomb with the tension that a whole pair takes: under pressure, under tension, without any, and where it has opened.
#[test]
fn mortar_that_rubs_has_the_strength_of_coulomb() {
    let (law, area) = (rubbing(2e5), 0.1);
    let shear = |normal: f64, memory: &PairMemory| law.respond([normal / law.normal, 1.0], area, memory).traction[1];
    for (normal, strength) in [(-1e6, 8e5), (0.0, 2e5), (5e3, 1.97e5)] {
        assert!((shear(normal, &FRESH) - strength).abs() < 1e-6 * strength, "{normal}");
    }
    // A bond is lost with the tension that it took; friction is not.
    let broken = PairMemory { broken: true, ..FRESH };
    assert!(law.respond([1e-6, 1.0], area, &broken).traction == [0.0; 2]);
    assert!((shear(-1e6, &broken) - 6e5).abs() < 1e-3);
    // Under more tension than cohesion over friction nothing is left.
    let pulled = Mortar { lift_off: LiftOff::Stress(1e6), ..law }.respond([5e5 / law.normal, 1.0], area, &FRESH);
    assert!(pulled.traction[1] == 0.0 && pulled.state == PairState::Sliding);
    // It slides at pressure, and its shear follows what presses.
    let slid = law.respond([-1e6 / law.normal, -1.0], area, &FRESH);
    assert!(slid.state == PairState::Sliding && (slid.tangent[1][0] - 0.6 * law.normal).abs() < 1.0);
    assert!(slid.tangent[1][1] == 0.0 && !JointLaw::Mortar(law).symmetric());
}

/// Cohesion without strength in tension is lost in one event: whoever seeks balance breaks the pair.
#[test]
fn a_bond_without_tension_breaks_and_does_not_flicker() {
    let law = Mortar { lift_off: LiftOff::Stress(0.0), ..rubbing(2e5) };
    let overstress = |tension: f64| JointLaw::Mortar(law).overstress(tension, 0.1, &FRESH);
    assert!(overstress(0.1) < 1.0 && overstress(0.5) > 1.0);
    let whole = law.respond([1e-9, 1e-7], 0.1, &FRESH);
    assert!(whole.state == PairState::Closed && !whole.memory.broken);
}

#[test]
fn friction_slides_at_its_cone() {
    for separation in [true, false] {
        let law = contact(separation);
        let press = 1e-5;
        let limit = 0.4 * law.normal * press;
        for way in [1.0, -1.0] {
            let held = law.respond([-press, way * limit / law.tangential * 0.999], &FRESH);
            assert_eq!(held.state, PairState::Closed);
            let slid = law.respond([-press, way * limit / law.tangential * 5.0], &FRESH);
            assert!(slid.state == PairState::Sliding && (slid.traction[1] - way * limit).abs() < 1e-9 * limit);
            assert!((slid.tangent[1][0] + way * 0.4 * law.normal).abs() < 1.0 && slid.tangent[1][1] == 0.0);
            // Pressed harder it holds where it has slid to; let go of, it slides again under what is left of the pressure.
            let harder = law.respond([-2.0 * press, way * limit / law.tangential * 5.0], &slid.memory);
            assert!(harder.state == PairState::Closed && (harder.traction[1] - way * limit).abs() < 1e-9 * limit);
            let softer = law.respond([-0.5 * press, way * limit / law.tangential * 5.0], &slid.memory);
            assert!(
                softer.state == PairState::Sliding && (softer.traction[1] - 0.5 * way * limit).abs() < 1e-9 * limit
            );
        }
    }
}

#[test]
fn only_a_contact_that_may_separate_opens() {
    let apart = [1e-5, 1e-6];
    let opens = contact(true).respond(apart, &FRESH);
    assert!(opens.state == PairState::Open && opens.traction == [0.0, 0.0] && opens.memory.slip == 1e-6);
    let holds = contact(false).respond(apart, &FRESH);
    assert!(holds.state == PairState::Sliding && (holds.traction[0] - 1e5).abs() < 1e-9 && holds.traction[1] == 0.0);
    let glued = Contact { cohesion: 2e5, ..contact(false) }.respond(apart, &FRESH);
    assert!(glued.state == PairState::Closed && (glued.traction[1] - 4e3).abs() < 1e-9);
}

#[test]
fn tangents_are_the_slopes_of_traction() {
    for law in all() {
        let (mut dice, mut seen, mut kinks) = (Dice(3), [0; 3], 0);
        for _ in 0..5000 {
            let scale = 10f64.powf(-4.5 + 2.0 * dice.roll());
            let old = law.respond([1e-4 * dice.roll(), 1e-4 * dice.roll()], 0.1, &FRESH).memory;
            let at = [scale * dice.roll() - 0.3 * scale, scale * dice.roll()];
            let here = law.respond(at, 0.1, &old);
            let step = 1e-7 * scale;
            let mut worst = 0.0_f64;
            for j in 0..2 {
                let moved = |by: f64| {
                    let mut at = at;
                    at[j] += by;
                    law.respond(at, 0.1, &old).traction
                };
                let (ahead, behind) = (moved(step), moved(-step));
                for i in 0..2 {
                    let slope = (ahead[i] - behind[i]) / (2.0 * step);
                    worst = worst.max((slope - here.tangent[i][j]).abs() / law.stiffness()[0]);
                }
            }
            // The laws are linear piece by piece: rounding of the traction over the step, and a step in ten million across a kink.
            if worst > 1e-6 {
                kinks += 1
            } else {
                seen[here.state as usize] += 1
            }
            assert!(here.traction.iter().all(|t| t.is_finite()));
            // Kept, and asked again, it stays.
            let again = law.respond(at, 0.1, &here.memory);
            let size = here.traction[0].abs() + here.traction[1].abs() + 1.0;
            assert!((0..2).all(|i| (again.traction[i] - here.traction[i]).abs() < 1e-9 * size), "{law:?} {at:?}");
        }
        assert!(kinks <= 2, "{law:?}: {kinks}");
        if law != tie(100e9, 40e9) {
            assert!(seen.iter().filter(|count| **count > 100).count() >= 2, "{law:?}: {seen:?}");
        }
    }
}

/// The rounded corner: half the friction of the rounding at no pressure, next to nothing far from it, and a tangent that is the slope.
#[test]
fn the_corner_of_friction_is_rounded() {
    let round = Contact { rounding: 500.0, ..contact(false) };
    let shear =
        |law: &Contact, normal: f64| law.respond([normal / law.normal, 1.0], &PairMemory::default()).traction[1];
    assert!((shear(&round, 0.0) - 0.4 * 250.0).abs() < 1e-9);
    for pressure in [50e3, 200e3] {
        let sharp = shear(&contact(false), -pressure);
        assert!((shear(&round, -pressure) - sharp).abs() < 0.4 * 500.0 * 500.0 / (4.0 * pressure) * 1.001);
    }
    for normal in [-2e3, -100.0, 0.0, 100.0, 2e3] {
        let step = 1.0;
        let slope = (shear(&round, normal + step) - shear(&round, normal - step)) / (2.0 * step);
        let tangent = round.respond([normal / round.normal, 1.0], &PairMemory::default()).tangent[1][0] / round.normal;
        assert!((slope - tangent).abs() < 1e-5, "{normal}: {slope} {tangent}");
    }
}
