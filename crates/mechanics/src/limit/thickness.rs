//! The least thickness at which the blocks stand.

use super::collapse::TOLERANCE;
use super::equilibrium::Equilibrium;
use super::mechanism::mechanism;
use super::outcome::Mechanism;
use super::program::{Interpretation, Program};
use super::settings::Settings;
use crate::blocks::{BlockModel, Loading, ModelError};
use crate::watch::CancelToken;

/// How the search for a thickness ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ThicknessStatus {
    /// The least thickness was found.
    Found,
    /// The blocks stand even at the thinnest.
    StandsAtThinnest,
    /// The blocks fall even at the thickest.
    FallsAtThickest,
    /// A program was not solved to its tolerance.
    NotConverged,
    /// It was stopped on the way.
    Cancelled,
}

/// The least thickness and how the blocks fall below it.
#[derive(Debug, Clone, PartialEq)]
pub struct LeastThickness {
    /// How the search ended.
    pub status: ThicknessStatus,
    /// Thinnest found to stand [m]; within the tolerance asked for of `falls`.
    pub stands: Option<f64>,
    /// Thickest found to fall [m].
    pub falls: Option<f64>,
    /// How the blocks fall, at `falls`.
    pub mechanism: Option<Mechanism>,
    /// Programs solved.
    pub trials: u32,
}

/// One thickness tried.
struct Trial {
    thickness: f64,
    margin: f64,
    mechanism: Option<Mechanism>,
}

/// Searches `between` two thicknesses [m], down to a bracket of `tolerance` [m], for the least one at which gravity,
/// permanent loads and `factor` times the variable loads are carried. `make` builds the model of a thickness; thicknesses are tried
/// while `token` goes on.
///
/// The search runs on a margin, not on a yes or no: the force by which every contact point can be kept compressed and
/// every joint from sliding. It changes sign at the least thickness and is continuous there. Equilibrium alone is
/// asked for, so the flow rule of sliding plays no part.
///
/// # Errors
/// A model with nothing that is free to move, with particles, or with a block whose rounding leaves nothing of an edge.
pub fn minimum_thickness(
    between: [f64; 2],
    tolerance: f64,
    factor: f64,
    settings: &Settings,
    token: &CancelToken,
    make: impl Fn(f64) -> (BlockModel, Loading),
) -> Result<LeastThickness, ModelError> {
    let mut trials = 0;
    let mut attempt = |thickness: f64| {
        trials += 1;
        token.step();
        let (model, loading) = make(thickness);
        margin(&model, &loading, factor, settings, token)
            .map(|found| found.map(|(margin, mechanism)| Trial { thickness, margin, mechanism }))
    };
    let nothing = |status| LeastThickness { status, stands: None, falls: None, mechanism: None, trials: 0 };
    let not_converged = || match !token.is_cancelled() {
        true => nothing(ThicknessStatus::NotConverged),
        false => nothing(ThicknessStatus::Cancelled),
    };
    let (Some(mut thin), Some(mut thick)) = (attempt(between[0])?, attempt(between[1])?) else {
        return Ok(not_converged());
    };
    if thick.margin < -STANDS {
        let falls = Some(thick.thickness);
        return Ok(LeastThickness {
            falls,
            mechanism: thick.mechanism,
            trials,
            ..nothing(ThicknessStatus::FallsAtThickest)
        });
    }
    if thin.margin >= -STANDS {
        let stands = Some(thin.thickness);
        return Ok(LeastThickness { stands, trials, ..nothing(ThicknessStatus::StandsAtThinnest) });
    }
    // The secant of the margins, with the Illinois rule against one end that never moves, kept a little inside.
    let (mut low, mut high) = (thin.margin, thick.margin.max(0.0));
    let (mut last, whole) = (0, thick.thickness - thin.thickness);
    while thick.thickness - thin.thickness > tolerance {
        let width = thick.thickness - thin.thickness;
        token.reach((width / whole).ln() / (tolerance / whole).ln());
        let secant = thin.thickness - low * width / (high - low);
        let inset = (0.4 * tolerance).max(0.01 * width).min(0.5 * width);
        let next = secant.clamp(thin.thickness + inset, thick.thickness - inset);
        let Some(trial) = attempt(next)? else { return Ok(not_converged()) };
        if trial.margin >= -STANDS {
            high = trial.margin.max(0.0);
            low *= if last == 1 { 0.5 } else { 1.0 };
            (thick, last) = (trial, 1);
        } else {
            low = trial.margin;
            high *= if last == -1 { 0.5 } else { 1.0 };
            (thin, last) = (trial, -1);
        }
    }
    Ok(LeastThickness {
        status: ThicknessStatus::Found,
        stands: Some(thick.thickness),
        falls: Some(thin.thickness),
        mechanism: thin.mechanism,
        trials,
    })
}

/// Margins down to this, relative to the permanent loads, are nought to the tolerance of the solver.
const STANDS: f64 = 1e-8;

/// The scaled margin and the motion that limits it; `None` when the program was not solved.
fn margin(
    model: &BlockModel,
    loading: &Loading,
    factor: f64,
    settings: &Settings,
    token: &CancelToken,
) -> Result<Option<(f64, Option<Mechanism>)>, ModelError> {
    let (_, mut equilibrium) = Equilibrium::of_free(model, loading, settings)?;
    equilibrium.token = token.clone();
    let program = Program {
        scaled_loads: &[],
        constant_loads: &equilibrium.loads(factor / equilibrium.factor_scale),
        // A margin of the whole weight at every contact is more than anyone asks for, and keeps the program bounded.
        cap: Some(1.0),
        interpretation: Interpretation::Margin,
        ..Program::of_the_factor(&equilibrium)
    };
    let solution = program.solve(TOLERANCE);
    Ok((solution.solved && !token.is_cancelled())
        .then(|| (solution.factor, mechanism(model, &equilibrium, &solution.velocities))))
}
