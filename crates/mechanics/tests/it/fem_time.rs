//! Steps through time: an oscillator, a beam under a moving load, a wave in a bar.

use crate::fem_tools::{elastic, forces, grid, held, model, moved, node, of, solved};
use mechanics::fem::law::{Elastic, Material, Plane, VonMises};
use mechanics::fem::{
    Damping, Element, Kinematics, Model, Motion, Section, Settings, State, Status, Workspace, at_rest, transient,
};
use mechanics::plane::vec2;
use mechanics::watch::Unwatched;

/// Constant average acceleration: no numerical damping, stable at any step for linear systems.
const AVERAGE: f64 = 0.0;

fn exactly() -> Settings {
    Settings { tolerance: 1e-12, ..Settings::default() }
}

/// A unit square on rollers that stretches along y alone: one free mode, of stiffness E and a third of its mass.
fn oscillator(section: Section, kinematics: Kinematics) -> (Model, f64) {
    let mesh = grid(1, 1, vec2);
    let supports = [
        held(node(1, 0, 0), true, true),
        held(node(1, 1, 0), true, true),
        held(node(1, 0, 1), true, false),
        held(node(1, 1, 1), true, false),
    ];
    let body = model(mesh, section, &supports, kinematics);
    // Confined modulus for a ratio of zero: E; consistent mass of the top: rho / 3.
    let frequency = (section.solid.material.elastic().modulus / (section.density / 3.0)).sqrt();
    (body, frequency)
}

/// Heights of the top at every step of free vibration from a stretch of `start` [m].
fn vibration(
    model: &Model,
    alpha: f64,
    step: f64,
    steps: u64,
    start: f64,
    each: &mut dyn FnMut(&State, &Workspace, &Motion),
) -> Vec<f64> {
    let mut work = Workspace::new(model).unwrap();
    let motion = Motion::new(model, &mut work, alpha, Damping::default(), step).unwrap();
    let mut state = State::new(model);
    for corner in [node(1, 0, 1), node(1, 1, 1)] {
        state.displacements[2 * corner.0 as usize + 1] = start;
    }
    let none = vec![0.0; 8];
    at_rest(model, &mut state, &mut work, &motion, &none).unwrap();
    let mut heights = vec![start];
    let mut see = |_: u64, state: &State, work: &Workspace| {
        heights.push(moved(state, node(1, 0, 1))[1]);
        each(state, work, &motion);
    };
    let settings = exactly();
    let mut forces = |_: u64| none.clone();
    let outcome =
        transient((model, &settings), (&mut state, &mut work), (&motion, steps), &mut forces, &mut see, &mut Unwatched);
    assert_eq!(outcome.status, Status::Completed, "{outcome:?}");
    heights
}

/// Average acceleration stretches the period of an undamped oscillator by a known amount: T / T0 = w dt / (2 atan(w dt / 2)). The
/// phase over many steps gives it: heights are exactly cos(k w' dt).
#[test]
fn the_period_error_is_that_of_the_scheme() {
    let (body, frequency) = oscillator(elastic(1e6, 0.0, Plane::Strain, Element::Q4), Kinematics::Small);
    for (angle, ratio) in [(0.1, 1.000833), (0.5, 1.020497), (1.0, 1.078405)] {
        let heights = vibration(&body, AVERAGE, angle / frequency, 200, 1e-3, &mut |_, _, _| {});
        // Every three heights give the angle of a step: h1 + h-1 = 2 h0 cos.
        for three in heights.windows(3).filter(|three| three[1].abs() > 5e-4) {
            let step = (0.5 * (three[0] + three[2]) / three[1]).acos();
            assert!((angle / step - ratio).abs() < 1e-6, "{angle}: {}", angle / step);
        }
    }
}

/// Average acceleration keeps the energy of a linear body to rounding; Hilber, Hughes and Taylor's scheme loses it.
#[test]
fn energy_is_kept() {
    let n = 6;
    let mesh = grid(n, 2, |s, t| vec2(2.0 * s, t * (0.5 + 0.2 * s)));
    let supports = [0, 1, 2].map(|j| held(node(n, 0, j), true, true));
    let body = model(mesh, elastic(1e7, 0.3, Plane::Strain, Element::QM6), &supports, Kinematics::Small);
    let pull = forces(&body, &[(node(n, n, 2), 3e3, -2e3)]);
    let bent = solved(&body, pull);
    let mut work = Workspace::new(&body).unwrap();
    let none = vec![0.0; bent.forces.len()];
    let mut change = |alpha: f64, steps: u64| {
        let motion = Motion::new(&body, &mut work, alpha, Damping::default(), 2e-3).unwrap();
        let mut state = bent.clone();
        at_rest(&body, &mut state, &mut work, &motion, &none).unwrap();
        let energy = |state: &State, work: &mut Workspace| {
            work.stiffness(&body, state).unwrap();
            let strain: f64 = state.displacements.iter().zip(&work.internal).map(|(u, f)| 0.5 * u * f).sum();
            strain + motion.kinetic_energy(&body, work, state)
        };
        let mut other = Workspace::new(&body).unwrap();
        let start = energy(&state, &mut other);
        let mut worst = 0.0_f64;
        let mut last = start;
        let mut see = |_: u64, state: &State, _: &Workspace| {
            last = energy(state, &mut other);
            worst = worst.max((last / start - 1.0).abs());
        };
        let settings = exactly();
        let outcome = transient(
            (&body, &settings),
            (&mut state, &mut work),
            (&motion, steps),
            &mut |_| none.clone(),
            &mut see,
            &mut Unwatched,
        );
        assert_eq!(outcome.status, Status::Completed);
        (worst, last / start)
    };
    let (worst, _) = change(AVERAGE, 500);
    assert!(worst < 1e-10, "{worst}");
    let (_, left) = change(-0.1, 500);
    assert!((0.01..0.999).contains(&left), "{left}");
}

/// A body that yields as it swings loses energy and never gains any.
#[test]
fn yielding_takes_energy() {
    let material = Material::VonMises(VonMises { elastic: Elastic { modulus: 1e6, ratio: 0.0 }, strength: 300.0 });
    let (body, frequency) = oscillator(of(material, Plane::Strain, Element::Q4), Kinematics::Small);
    let heights = vibration(&body, AVERAGE, 0.05 / frequency, 600, 2e-3, &mut |_, _, _| {});
    // Confined stretching flows at 2 G e = sqrt(3) k: e = 5.2e-4; the swing ends within twice that around where it came to rest.
    let late = &heights[400..];
    let swing = late.iter().fold(f64::NEG_INFINITY, |a: f64, b| a.max(*b))
        - late.iter().fold(f64::INFINITY, |a: f64, b| a.min(*b));
    assert!(swing < 0.6 * 4e-3 && swing > 1e-4, "{swing}");
}

/// A force that crosses a simply supported beam (Fryba; benchmark of 199 modes): L 20 m, E 210 GPa, I 0.02 m^4, 2000 kg/m, 100 kN.
/// A beam of quadrilaterals is made of the section that gives E I and m, slender enough for shear and rotatory inertia to
/// stay below the tolerance of 0.1 %: they are taken out through the first frequency and the static sag of the very mesh.
#[test]
fn a_moving_load_crosses_a_beam() {
    let (length, n) = (20.0, 80);
    // Depth 0.2 m at a modulus that gives E I = 4.2e9 N m^2.
    let depth: f64 = 0.2;
    let modulus = 4.2e9 * 12.0 / depth.powi(3);
    let section = Section { density: 2000.0 / depth, ..elastic(modulus, 0.0, Plane::Stress, Element::QM6) };
    let mesh = grid(n, 2, |s, t| vec2(length * s, depth * (t - 0.5)));
    let supports = [held(node(n, 0, 1), true, true), held(node(n, n, 1), false, true)];
    let beam = model(mesh, section, &supports, Kinematics::Small);
    let middle = node(n, n / 2, 1);
    let sag = -moved(&solved(&beam, forces(&beam, &[(middle, 0.0, -100e3)])), middle)[1];
    assert!((sag / 0.003_968_254 - 1.0).abs() < 1e-3, "{sag}");
    for (speed, peak) in [(10.0, 0.004146704), (30.0, 0.004530706), (80.0, 0.006070089), (180.0, 0.006671552)] {
        let steps = 2000;
        let step = length / speed / steps as f64;
        let mut work = Workspace::new(&beam).unwrap();
        let motion = Motion::new(&beam, &mut work, AVERAGE, Damping::default(), step).unwrap();
        let mut state = State::new(&beam);
        let mut load = |k: u64| {
            // Hermite's shares: a force within an element acts on a beam's nodes with moments; here, on the couple of their rows.
            let at = (k + 1) as f64 / steps as f64 * n as f64;
            let (i, s) = ((at.floor() as usize).min(n - 1), at - (at.floor().min(n as f64 - 1.0)));
            let width = length / n as f64;
            let (one, two) = (1.0 - 3.0 * s * s + 2.0 * s * s * s, 3.0 * s * s - 2.0 * s * s * s);
            let (left, right) = (width * (s - 2.0 * s * s + s * s * s), width * (s * s * s - s * s));
            let mut list = vec![(node(n, i, 1), 0.0, -100e3 * one), (node(n, i + 1, 1), 0.0, -100e3 * two)];
            for (column, moment) in [(i, -100e3 * left), (i + 1, -100e3 * right)] {
                list.push((node(n, column, 2), -moment / depth, 0.0));
                list.push((node(n, column, 0), moment / depth, 0.0));
            }
            forces(&beam, &list)
        };
        let mut most = 0.0_f64;
        let mut see = |_: u64, state: &State, _: &Workspace| most = most.max(-moved(state, middle)[1]);
        let settings = Settings { tolerance: 1e-8, ..Settings::default() };
        let outcome = transient(
            (&beam, &settings),
            (&mut state, &mut work),
            (&motion, steps),
            &mut load,
            &mut see,
            &mut Unwatched,
        );
        assert_eq!(outcome.status, Status::Completed, "{:?}", outcome.steps.last());
        assert!((most / peak - 1.0).abs() < 1e-3, "{speed} m/s: {most} for {peak}");
    }
}

/// A step force at the end of a bar sends a wave of unit speed through it. Behind its front the material moves at unit speed, so that
/// at time 8 the middle has moved by 8 less the time of arrival.
#[test]
fn a_wave_runs_at_its_speed() {
    for (n, tolerance) in [(50, 0.01), (100, 0.005), (200, 0.0025)] {
        let mesh = grid(n, 1, |s, t| vec2(10.0 * s, 0.1 * t));
        let mut supports = vec![held(node(n, 0, 0), true, true), held(node(n, 0, 1), true, true)];
        supports.extend((1..=n).flat_map(|i| [0, 1].map(|j| held(node(n, i, j), false, true))));
        let section = Section { density: 1.0, ..elastic(1.0, 0.0, Plane::Stress, Element::Q4) };
        let bar = model(mesh, section, &supports, Kinematics::Small);
        let push = forces(&bar, &[(node(n, n, 0), 0.05, 0.0), (node(n, n, 1), 0.05, 0.0)]);
        let mut work = Workspace::new(&bar).unwrap();
        let step = 0.5 * 10.0 / n as f64;
        let motion = Motion::new(&bar, &mut work, AVERAGE, Damping::default(), step).unwrap();
        let mut state = State::new(&bar);
        at_rest(&bar, &mut state, &mut work, &motion, &push).unwrap();
        let steps = (8.0 / step).round() as u64;
        let settings = Settings { tolerance: 1e-9, ..Settings::default() };
        let outcome = transient(
            (&bar, &settings),
            (&mut state, &mut work),
            (&motion, steps),
            &mut |_| push.clone(),
            &mut |_, _, _| {},
            &mut Unwatched,
        );
        assert_eq!(outcome.status, Status::Completed);
        let speed = 5.0 / (8.0 - moved(&state, node(n, n / 2, 0))[0]);
        // The scheme's own oscillation behind the front dies with the mesh.
        assert!((speed - 1.0).abs() < tolerance, "{n}: {speed}");
    }
}

/// Two circular frequencies are damped as asked.
#[test]
fn rayleigh_damping_meets_its_two_frequencies() {
    let damping = Damping::of(0.02, [10.0, 40.0]);
    for frequency in [10.0, 40.0] {
        let ratio = 0.5 * (damping.mass / frequency + damping.stiffness * frequency);
        assert!((ratio - 0.02_f64).abs() < 1e-15);
    }
    let (body, frequency) = oscillator(elastic(1e6, 0.0, Plane::Strain, Element::Q4), Kinematics::Small);
    let damping = Damping::of(0.02, [frequency, 5.0 * frequency]);
    let mut work = Workspace::new(&body).unwrap();
    let step = 0.01 / frequency;
    let motion = Motion::new(&body, &mut work, AVERAGE, damping, step).unwrap();
    let mut state = State::new(&body);
    for corner in [node(1, 0, 1), node(1, 1, 1)] {
        state.displacements[2 * corner.0 as usize + 1] = 1e-3;
    }
    let none = vec![0.0; 8];
    at_rest(&body, &mut state, &mut work, &motion, &none).unwrap();
    let mut least = 0.0_f64;
    let mut see = |_: u64, state: &State, _: &Workspace| least = least.min(moved(state, node(1, 0, 1))[1]);
    let settings = exactly();
    let outcome = transient(
        (&body, &settings),
        (&mut state, &mut work),
        (&motion, 400),
        &mut |_| none.clone(),
        &mut see,
        &mut Unwatched,
    );
    assert_eq!(outcome.status, Status::Completed);
    // Half a period later: exp(-pi ratio / sqrt(1 - ratio^2)) of the start.
    let exact = 1e-3 * (-std::f64::consts::PI * 0.02 / (1.0_f64 - 0.0004).sqrt()).exp();
    assert!((-least / exact - 1.0).abs() < 1e-4, "{least} for {exact}");
}
