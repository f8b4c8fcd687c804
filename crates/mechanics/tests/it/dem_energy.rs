//! The account of the filled arch, whose contacts open and close in hundreds on the way to collapse.

use crate::dem_bridgemill::{bridgemill, paper, run};
use mechanics::dem::{ContactLength, Damping, Settings};

/// What the account of a run to collapse leaves unexplained, as a share of the work done.
fn drift(damping: Damping, time_step_factor: f64) -> f64 {
    let settings = Settings { time_step_factor, ..paper(damping, ContactLength::Fixed) };
    let energy = run(&bridgemill(true, 1.0), None, &settings).energy;
    energy.drift() / (energy.gravity.abs() + energy.loads.abs())
}

/// A contact that opens or closes within a step has its energy wrong by the square of the step: half the step leaves a
/// quarter or less (at least a third is asked for). That the drift goes away with the step is what says that nothing
/// was forgotten in the account; local damping moves faster, so it starts at 1e-5 instead of 5e-6.
#[test]
fn the_drift_falls_with_the_square_of_the_step() {
    for (damping, at_half) in [(Damping::Adaptive, 1e-6), (Damping::Local(0.7), 2.5e-6)] {
        let (whole, half) = (drift(damping, 0.9), drift(damping, 0.45));
        println!("{damping:?}: {whole:e} at 0.9, {half:e} at 0.45 of the critical step");
        assert!(whole.abs() < 1e-5 && whole.abs() >= 3.0 * half.abs(), "{damping:?}: {whole:e} {half:e}");
        assert!(half.abs() < at_half, "{damping:?}: {half:e}");
    }
}
