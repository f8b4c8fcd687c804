//! Sliding without dilation, by the iteration of Gilbert, Casapulla and Ahmed, "Limit analysis of masonry block
//! structures with non-associative frictional joints using linear programming", Computers and Structures 84 (2006).
//!
//! A linear program cannot let a joint slide level while its strength grows with compression. So each joint is given a
//! fictitious strength that does not grow, `friction` times the compression of the round before, and the compressions
//! are brought up to date, damped, until the load factor no longer changes and forces that obey the true friction law
//! reach it too. The mechanism then slides level. Near zero compression the fictitious surface runs to the origin, steeper than the
//! true one by `1 / REACH`, for otherwise an open joint could carry shear.
//!
//! A statically indeterminate wall has many such end points: the load depends on its self-stress. Every round can be
//! made to have one answer by a small price on the squares of the compressions, which picks the state of least
//! self-stress and makes the end point nearly independent of the start (measured from four starts on three walls of
//! Ferris and Tin-Loi: equal to 1e-4). Without it the loads lie up to 17 % higher. The lowest is reported, with the
//! spread over all starts.

use super::collapse::TOLERANCE;
use super::equilibrium::Equilibrium;
use super::joints::{Joint, Strength};
use super::program::{Ending, Program, Role, Solution};
use crate::watch::Pace;

/// Share of a joint's compression down to which the fictitious surface is level.
const REACH: f64 = 0.3;
/// Weight of the newest compressions in the first rounds.
const DAMPING: f64 = 0.6;
/// From this round on the weight falls as one over the rounds: two rings that slide on one another have states of equal
/// load between which full steps would wander without end.
const CALMED: usize = 20;
/// Most rounds of one start.
const ROUNDS: usize = 60;
/// Price that picks the state of least self-stress. From 1e-2 down to 1e-5 the loads of three walls of Ferris and
/// Tin-Loi change by less than 1e-3; compressed joints give way in the mechanism by about a tenth of the price, and at
/// 1e-5 that is below what counts as motion.
const PRICE: f64 = 1e-5;
/// End of the rounds: largest change of the load factor, relative. Tighter than the 1e-4 to which starts agree.
const SETTLED: f64 = 1e-6;
/// Largest relative difference between the load factor with the fictitious surfaces and with forces that keep to the
/// true ones as well.
const CONFIRMED: f64 = 1e-5;
/// How much more shear than the fictitious surfaces allow those forces may have, relative: the compressions settle to
/// about the root of what the load settles to.
const LOOSE: f64 = 1e-2;
/// The same as [`CONFIRMED`] after the last round, where the factor still wanders. The forces are in equilibrium and keep to the true
/// law all the same; the mechanism slides level to this accuracy. Both factors enter the spread.
const WANDERS: f64 = 5e-3;

/// Where the iteration ended from its several starts.
pub(super) struct Settled {
    /// The lowest end point.
    pub solution: Solution,
    /// Scaled factors of all end points: lowest and highest.
    pub spread: [f64; 2],
    /// Iterations of the solver in all.
    pub iterations: u32,
}

/// Runs the iteration from several starts; `None` when none of them settles. `associated` are the forces of the
/// associated program, where it has a solution.
pub(super) fn settle(
    equilibrium: &Equilibrium,
    joints: &[Joint],
    strengths: &[Strength],
    associated: Option<&[f64]>,
) -> Option<Settled> {
    // As compressed as the whole weight: the strongest start; the associated state: the published one.
    let everywhere = vec![1.0; joints.len()];
    let mut starts: Vec<(Vec<f64>, f64)> = vec![(everywhere, PRICE)];
    if let Some(forces) = associated {
        starts.push((compressions(equilibrium, joints, forces), PRICE));
        starts.push((compressions(equilibrium, joints, forces), 0.0));
    }
    let mut best: Option<Settled> = None;
    let mut iterations = 0;
    let count = starts.len();
    for (k, (start, price)) in starts.into_iter().enumerate() {
        let (found, used) = from(equilibrium, joints, strengths, start, price, &equilibrium.pace.part(k, count));
        iterations += used;
        let Some((solution, fictitious)) = found else { continue };
        let range = [solution.factor.min(fictitious), solution.factor.max(fictitious)];
        best = Some(match best {
            None => Settled { spread: range, solution, iterations },
            Some(old) => {
                let spread = [old.spread[0].min(range[0]), old.spread[1].max(range[1])];
                let lower = if solution.factor < old.solution.factor { solution } else { old.solution };
                Settled { solution: lower, spread, iterations }
            }
        });
    }
    best.map(|b| Settled { iterations, ..b })
}

/// Runs the iteration from one start: forces that keep to the true law with the mechanism of the fictitious one, and the
/// factor that the fictitious one reached.
fn from(
    equilibrium: &Equilibrium,
    joints: &[Joint],
    strengths: &[Strength],
    start: Vec<f64>,
    price: f64,
    pace: &Pace,
) -> (Option<(Solution, f64)>, u32) {
    let (mut compression, mut previous, mut iterations) = (start, f64::INFINITY, 0);
    let mut solve = |reach: f64, cap: Option<f64>, compression: &mut dyn Iterator<Item = f64>| {
        let fictitious: Vec<Strength> =
            strengths.iter().zip(compression).map(|(s, c)| level(s, reach, c.max(0.0) * equilibrium.force)).collect();
        let solution = Program {
            equilibrium,
            joints,
            strengths: &fictitious,
            drive: &equilibrium.variable,
            rest: &equilibrium.permanent,
            cap,
            reward: Vec::new(),
            price,
            role: Role::Factor,
        }
        .solve(TOLERANCE);
        iterations += solution.iterations;
        // A round that comes to rest a little early is no reason to give up the start: the end is looked at by itself.
        (solution.ending != Ending::Unknown).then_some(solution)
    };
    let mut end = None;
    for round in 0..ROUNDS {
        pace.reach(round as f64 / ROUNDS as f64);
        let Some(solution) = solve(REACH, None, &mut compression.iter().copied()) else { break };
        let size = solution.factor.abs().max(1e-3);
        let last = round + 1 == ROUNDS;
        if last || (solution.factor - previous).abs() <= SETTLED * size {
            // Forces that keep to the true surfaces too and carry the same load, under the mechanism of the fictitious
            // ones. The load is flat in the compressions, which are known less well.
            let mut loose = compression.iter().map(|c| c * (1.0 + LOOSE));
            if let Some(true_forces) = solve(1.0, Some(solution.factor), &mut loose)
                && (solution.factor - true_forces.factor).abs() <= if last { WANDERS } else { CONFIRMED } * size
            {
                let reached = if last { solution.factor } else { true_forces.factor };
                end = Some((Solution { velocities: solution.velocities, ..true_forces }, reached));
                break;
            }
        }
        previous = solution.factor;
        let calmed = round.saturating_sub(CALMED) as f64;
        let newest = DAMPING * CALMED as f64 / (CALMED as f64 + 2.0 * calmed);
        for (old, new) in compression.iter_mut().zip(compressions(equilibrium, joints, &solution.forces)) {
            *old += newest * (new - *old);
        }
    }
    (end, iterations)
}

/// The fictitious strength of a joint that was compressed by `compression` [N/m], level down to a share `reach` of it.
fn level(strength: &Strength, reach: f64, compression: f64) -> Strength {
    if !strength.friction.is_finite() {
        return *strength;
    }
    Strength {
        friction: strength.friction / reach,
        most_shear: strength.friction * compression + strength.cohesion,
        ..*strength
    }
}

/// Scaled compression of each joint.
fn compressions(equilibrium: &Equilibrium, joints: &[Joint], forces: &[f64]) -> Vec<f64> {
    let each = joints.iter().zip(&equilibrium.first_column);
    each.map(|(joint, &c)| forces[c..c + joint.points.len()].iter().sum()).collect()
}
