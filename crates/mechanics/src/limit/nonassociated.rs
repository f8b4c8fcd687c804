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
//! made to have one answer by a small weight on the squares of the compressions, which picks the state of least
//! self-stress and makes the end point nearly independent of the start (measured from four starts on three walls of
//! Ferris and Tin-Loi: equal to 1e-4). Without it the loads lie up to 17 % higher. Where rings slide on backing that is blocks, ends
//! still depend on the start. The lowest is reported, with the spread over all starts.

use super::collapse::TOLERANCE;
use super::equilibrium::Equilibrium;
use super::joints::{Joint, Strength};
use super::program::{Ending, Interpretation, NEARLY, Program, Solution};
use super::proven;
use crate::watch::CancelToken;

/// Share of a joint's compression down to which the fictitious surface is level.
pub(super) const REACH: f64 = 0.3;
/// Weight of the newest compressions in the first rounds.
pub(super) const DAMPING: f64 = 0.6;
/// How many rounds one start has.
#[derive(Clone, Copy)]
struct Rounds {
    /// From this one on the weight falls as one over the rounds: two rings that slide on one another have states of equal load
    /// between which full steps would wander without end.
    calmed: usize,
    /// The last one.
    most: usize,
}

/// From a start that knows nothing of the end.
const FROM_AFAR: Rounds = Rounds { calmed: 20, most: 60 };
/// From the end of a load nearby.
const NEARBY: Rounds = Rounds { calmed: 10, most: 30 };
/// Weight on the squares of compressions that picks the state of least self-stress. From 1e-2 down to 1e-5 the loads of three walls of Ferris and
/// Tin-Loi change by less than 1e-3; compressed joints give way in the mechanism by about a tenth of the weight, and at
/// 1e-5 that is below what counts as motion.
pub(super) const QUADRATIC_WEIGHT: f64 = 1e-5;
/// End of the rounds: largest change of the load factor, relative. Tighter than the 1e-4 to which starts agree.
const SETTLED: f64 = 1e-6;
/// Largest relative difference between the load factor with the fictitious surfaces and with forces that keep to the
/// true ones as well.
const CONFIRMED: f64 = 1e-5;
/// Relative gap and residuals of a round that may be gone on from: where joints crush the solver often rests early.
const ROUGHLY: f64 = 1e-4;
/// Rounds in a row that may go half of the way back to the last one that was solved.
const RETREATS: usize = 6;
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
    /// Scaled compressions of the joints there: a start for a load that differs a little.
    pub compressions: Vec<f64>,
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
    let mut starts: Vec<(Vec<f64>, f64)> = vec![(everywhere, QUADRATIC_WEIGHT)];
    if let Some(forces) = associated {
        starts.push((compressions(equilibrium, joints, forces), QUADRATIC_WEIGHT));
        starts.push((compressions(equilibrium, joints, forces), 0.0));
    }
    let mut best: Option<Settled> = None;
    let mut iterations = 0;
    let count = starts.len();
    for (k, (start, quadratic_weight)) in starts.into_iter().enumerate() {
        let (found, used) = from(
            equilibrium,
            joints,
            strengths,
            (start, quadratic_weight),
            FROM_AFAR,
            &equilibrium.token.part(k, count),
        );
        iterations += used;
        let Some(end) = found else { continue };
        let range = end.range();
        best = Some(match best {
            None => end.settled(range),
            Some(old) => {
                let spread = [old.spread[0].min(range[0]), old.spread[1].max(range[1])];
                match end.solution.factor < old.solution.factor {
                    true => end.settled(spread),
                    false => Settled { spread, ..old },
                }
            }
        });
    }
    best.map(|b| Settled { iterations, ..b })
}

/// Runs the iteration from the end point of a load nearby alone: one start in place of three, and half the rounds.
pub(super) fn settle_near(
    equilibrium: &Equilibrium,
    joints: &[Joint],
    strengths: &[Strength],
    near: &[f64],
) -> Option<Settled> {
    let start = (near.to_vec(), QUADRATIC_WEIGHT);
    let (found, iterations) = from(equilibrium, joints, strengths, start, NEARBY, &equilibrium.token);
    let end = found?;
    let range = end.range();
    Some(Settled { iterations, ..end.settled(range) })
}

/// Where one start ended.
struct End {
    /// Forces that keep to the true law, with the mechanism of the fictitious one.
    solution: Solution,
    /// The factor that the fictitious one reached.
    fictitious: f64,
    compressions: Vec<f64>,
}

impl End {
    fn range(&self) -> [f64; 2] {
        let own = self.solution.factor;
        [own.min(self.fictitious), own.max(self.fictitious)]
    }

    fn settled(self, spread: [f64; 2]) -> Settled {
        Settled { solution: self.solution, spread, compressions: self.compressions, iterations: 0 }
    }
}

/// Runs the iteration from one start; the iterations of the solver beside it.
fn from(
    equilibrium: &Equilibrium,
    joints: &[Joint],
    strengths: &[Strength],
    (start, quadratic_weight): (Vec<f64>, f64),
    rounds: Rounds,
    token: &CancelToken,
) -> (Option<End>, u32) {
    let (mut compression, mut previous, mut iterations) = (start, f64::INFINITY, 0);
    let mut solve = |reach: f64, cap: Option<f64>, nearly: f64, compression: &mut dyn Iterator<Item = f64>| {
        let fictitious: Vec<Strength> =
            strengths.iter().zip(compression).map(|(s, c)| level(s, reach, c.max(0.0) * equilibrium.force)).collect();
        let solution = Program {
            equilibrium,
            joints,
            strengths: &fictitious,
            scaled_loads: &equilibrium.variable,
            constant_loads: &equilibrium.permanent,
            cap,
            objective: Vec::new(),
            quadratic_weight,
            interpretation: Interpretation::Factor,
        }
        .solve_or(TOLERANCE, nearly);
        iterations += solution.iterations;
        solution
    };
    let (mut end, mut solved, mut retreats): (Option<(Solution, f64)>, Option<Vec<f64>>, usize) = (None, None, 0);
    for round in 0..rounds.most {
        token.reach(round as f64 / rounds.most as f64);
        // A round that comes to rest early is no reason to give up the start: the end is looked at by itself.
        let solution = solve(REACH, None, ROUGHLY, &mut compression.iter().copied());
        if solution.ending == Ending::Unknown {
            let Some(solved) = solved.as_ref().filter(|_| retreats < RETREATS && !token.is_cancelled()) else { break };
            compression.iter_mut().zip(solved).for_each(|(now, before)| *now = 0.5 * (*now + before));
            retreats += 1;
            continue;
        }
        retreats = 0;
        let size = solution.factor.abs().max(1e-3);
        let last = round + 1 == rounds.most;
        if last || (solution.factor - previous).abs() <= SETTLED * size {
            // Forces that keep to the true surfaces too and carry the same load, under the mechanism of the fictitious
            // ones. The load is flat in the compressions, which are known less well.
            let mut loose = compression.iter().map(|c| c * (1.0 + LOOSE));
            let near = solve(1.0, Some(solution.factor), NEARLY, &mut loose);
            let true_forces = match near.ending {
                Ending::Unknown => proven::roomy(equilibrium, joints, strengths)
                    .and_then(|roomy| proven::within(equilibrium, joints, strengths, &roomy, &near))
                    .map(|(forces, factor)| Solution { forces, factor, ..near }),
                _ => Some(near),
            };
            if let Some(true_forces) = true_forces
                && (solution.factor - true_forces.factor).abs() <= if last { WANDERS } else { CONFIRMED } * size
            {
                let fictitious = if last { solution.factor } else { true_forces.factor };
                end = Some((Solution { velocities: solution.velocities, ..true_forces }, fictitious));
                break;
            }
        }
        previous = solution.factor;
        solved = Some(compression.clone());
        let (calmed, beyond) = (rounds.calmed as f64, round.saturating_sub(rounds.calmed) as f64);
        let newest = DAMPING * calmed / (calmed + 2.0 * beyond);
        for (old, new) in compression.iter_mut().zip(compressions(equilibrium, joints, &solution.forces)) {
            *old += newest * (new - *old);
        }
    }
    let end = end.map(|(solution, fictitious)| End { solution, fictitious, compressions: compression });
    (end, iterations)
}

/// The fictitious strength of a joint that was compressed by `compression` [N/m], level down to a share `reach` of it.
pub(super) fn level(strength: &Strength, reach: f64, compression: f64) -> Strength {
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
pub(super) fn compressions(equilibrium: &Equilibrium, joints: &[Joint], forces: &[f64]) -> Vec<f64> {
    let each = joints.iter().zip(&equilibrium.first_column);
    each.map(|(joint, &c)| forces[c..c + joint.points.len()].iter().sum()).collect()
}
