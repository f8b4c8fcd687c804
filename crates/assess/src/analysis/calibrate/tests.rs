//! The measurement chain on packings whose modulus is known, and the whole on a small bridge.

use super::calibrate_fill;
use super::press::Rig;
use super::report;
use super::sample::Sample;
use super::settled::Laws;
use crate::samples;
use bridge::{Bridge, Modulus};
use mechanics::blocks::{ContactLaw, LawTable, Particle, Stiffness};
use mechanics::dem;
use mechanics::ids::{GroupId, Table};
use mechanics::plane::vec2;
use mechanics::watch::{Progress, Unwatched, Watch, Wish};
use outcome::calibration::Measured;
use outcome::sweep::Ended;

const LENGTH: f64 = 0.1;

fn slippery(stiffness: f64) -> ContactLaw {
    ContactLaw {
        normal: Stiffness::Given(stiffness),
        shear: Stiffness::Given(stiffness),
        friction: 0.0,
        cohesion: 0.0,
        tension: 0.0,
        crushing: f64::INFINITY,
        fixed_length: Some(LENGTH),
        least_length: LENGTH,
    }
}

/// `n` by `n` discs that touch one another and the walls of a square of 1 m.
fn lattice(n: usize, between: f64, at_walls: f64) -> Sample {
    let radius = 0.5 / n as f64;
    let at = |k: usize| (2 * k + 1) as f64 * radius;
    let disc = |k: usize| Particle { centre: vec2(at(k % n), at(k / n)), radius, density: 1890.0, group: GroupId(0) };
    let mut table = LawTable::uniform(2, slippery(at_walls));
    table.set(GroupId(0), GroupId(0), slippery(between));
    let mut groups = Table::default();
    let (grains, walls) = (groups.push("fill".to_owned()), groups.push("walls".to_owned()));
    Sample {
        seed: 0,
        square: 0,
        size: 1.0,
        particles: (0..n * n).map(disc).collect(),
        cuts: Vec::new(),
        smallest: radius,
        mean_diameter: 2.0 * radius,
        laws: Laws { table, groups, layers: vec![grains], walls, gravity: vec2(0.0, -9.81) },
    }
}

fn press(sample: &Sample, multiple: f64) -> Measured {
    let mut bridge = samples::bridgemill();
    bridge.plan.tolerance = 1e-7;
    let rig = Rig::new(&bridge, &sample.laws);
    let pressed = rig.press(sample, multiple, &mut Unwatched).unwrap();
    assert_eq!(pressed.status, dem::Status::StableToLastLoad);
    report::measured(multiple, std::slice::from_ref(sample), &[pressed], &rig.plan)
}

/// Columns of discs are springs in series: n - 1 contacts of stiffness k l among themselves and two of k' l at floor and
/// block, each under the force of one column. With n columns on 1 m the modulus is h n / ((n - 1) / (k l) + 2 / (k' l)),
/// whatever their weight; all moduli are the same, and stress spreads evenly. The height is that under the block's own
/// weight; at rest within 1e-7 of the acting forces.
#[test]
fn a_square_lattice_has_its_exact_modulus() {
    for (n, between, at_walls, multiple) in [(4, 0.3e9, 0.3e9, 1.0), (6, 0.3e9, 5e9, 1.0), (6, 0.3e9, 5e9, 8.0)] {
        let sample = lattice(n, between, at_walls);
        let found = press(&sample, multiple);
        let rows = n as f64;
        let compliance = (rows - 1.0) / (multiple * between * LENGTH) + 2.0 / (at_walls * LENGTH);
        let exact = rows / compliance;
        for spread in [found.tangent, found.least_squares, found.secant, found.late_secant] {
            let modulus = spread.unwrap().mean;
            // The height under weight and block is less than 1 m by some 1e-4.
            assert!((modulus / exact - 1.0).abs() < 1e-3, "{n} {multiple}: {modulus} {exact}");
        }
        assert_eq!((found.left_out, found.curve.len()), (0, 11));
        assert!((found.curve[0].0.stress - 2.6e3).abs() < 1e-9 && (found.curve[10].0.stress - 252.6e3).abs() < 1e-6);
    }
}

/// A shallow bridge whose fill holds a few small squares.
fn small() -> Bridge {
    let text = include_str!("../../../../../examples/bridgemill/calibration.toml");
    let read = bridge::read(text.as_bytes());
    let mut bridge = read.bridge.expect("the example is sound");
    bridge.calibration.multiples = vec![1.0, 4.0];
    bridge.calibration.compare_with.clear();
    bridge.calibration.seeds = 1;
    bridge.calibration.steps = 3;
    bridge.calibration.ignored_steps = 1;
    bridge.calibration.wanted_modulus = None;
    // Fewer and larger particles: quick.
    if let Some(particles) = &mut bridge.particles {
        particles.sizes = bridge::Sizes::Count { count: 400, ratio: 1.5 };
    }
    bridge
}

/// Equation (1) with the mortar's 65 and 27 GPa/m, particles of 40 MPa and 0.2, and 0.15 m between centres: the first
/// estimate of the paper, 0.266 and 0.111 GPa/m to its three digits.
#[test]
fn the_first_estimate_is_that_of_the_paper() {
    let bridge = small();
    let particles = bridge.particles.as_ref().unwrap();
    let law = structure::discretise::fill::law(particles, &particles.joint);
    assert!((law.normal.at(0.15) / 1e9 - 0.266).abs() < 0.0005, "{}", law.normal.at(0.15));
    assert!((law.shear.at(0.15) / 1e9 - 0.111).abs() < 0.0005, "{}", law.shear.at(0.15));
}

#[test]
fn stiffer_contacts_make_stiffer_fill_and_the_same_bits() {
    let bridge = small();
    let found = calibrate_fill(&bridge, &mut Unwatched).unwrap();
    assert_eq!(found.verdict, Ended::Completed);
    assert!(found.squares >= 8 && found.table.len() == 2, "{} {}", found.squares, found.table.len());
    let [soft, stiff] = [&found.table[0], &found.table[1]].map(|m| m.at(Modulus::Tangent).unwrap().modulus);
    assert!(stiff > 1.5 * soft && stiff < 4.0 * soft, "{soft} {stiff}");
    assert!(found.replaced > 0 && found.replaced <= found.cut);
    let drawn = found.drawn.as_ref().unwrap();
    assert!(drawn.pressed[1].0.block < drawn.pressed[0].0.block);
    let single = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let alone = single.install(|| calibrate_fill(&bridge, &mut Unwatched)).unwrap();
    assert_eq!(outcome::published::calibration_curves(&found), outcome::published::calibration_curves(&alone));
}

#[test]
fn what_cannot_be_calibrated_says_so() {
    let reason = |change: fn(&mut Bridge)| {
        let mut bridge = small();
        change(&mut bridge);
        calibrate_fill(&bridge, &mut Unwatched).unwrap_err().to_string()
    };
    assert!(reason(|b| b.particles = None).contains("as = \"particles\""));
    assert!(reason(|b| b.calibration.sample_size = 5.0).contains("smaller sample_size"));
    assert!(reason(|b| b.calibration.sample_size = 0.3).contains("too few particles"));
    let saved = |b: &mut Bridge| b.particles.as_mut().unwrap().file = Some("packing.csv".into());
    assert!(reason(saved).contains("remove `file`"));
}

/// An onlooker who has had enough.
struct Impatient(u32);

impl Watch for Impatient {
    fn look(&mut self, _: &Progress) -> Wish {
        self.0 = self.0.saturating_sub(1);
        if self.0 == 0 { Wish::Stop } else { Wish::GoOn }
    }
}

#[test]
fn it_stops_when_asked() {
    for patience in [1, 60] {
        let found = calibrate_fill(&small(), &mut Impatient(patience)).unwrap();
        assert_eq!(found.verdict, Ended::Cancelled, "{patience}");
    }
}

/// Discs roll past one another: no friction of their contacts makes a fill of 55 degrees, and the answer says what it has.
#[test]
fn a_strength_that_discs_do_not_have_is_out_of_reach() {
    let mut bridge = small();
    bridge.calibration.multiples = vec![1.0];
    bridge.calibration.wanted_friction_angle = Some(55f64.to_radians());
    bridge.calibration.confining_pressures = vec![50e3, 200e3];
    bridge.calibration.sheared_samples = 3;
    if let Some(particles) = &mut bridge.particles {
        particles.sizes = bridge::Sizes::Count { count: 900, ratio: 1.5 };
    }
    let found = calibrate_fill(&bridge, &mut Unwatched).unwrap();
    assert_eq!(found.verdict, Ended::Undetermined);
    assert!(found.warnings.iter().any(|w| w.code() == "A163"), "{:?}", found.warnings);
    let strength = found.strength.as_ref().unwrap();
    let angle = strength.found.friction_angle.mean.to_degrees();
    assert!(!strength.reached && strength.check.is_some());
    assert!(angle > 8.0 && angle < 50.0, "{angle}");
    assert!(strength.found.contact.friction_angle.to_degrees() > angle + 10.0);
    // The peaks grow with the confining pressure.
    let [low, high] = [strength.found.peaks[0], strength.found.peaks[1]];
    assert!(high[1] > 2.0 * low[1] && low[1] > low[0], "{:?}", strength.found.peaks);
    // The moduli are those with the contacts of the answer.
    assert_eq!(found.table.len(), 1);
}
