//! A load that is proven to be carried where the solver came to rest a little early.
//!
//! Its forces miss equilibrium and strength by the solver's residuals. Elastic joints take what is out of balance; what then lies
//! outside strength is drawn in towards a state of the permanent loads with room to every limit. Limits are convex, so that a share
//! `room / (room + outside)` of the way is within all of them, and the same share of the load is carried.

use super::bounds;
use super::collapse::TOLERANCE;
use super::compliance::Stiffness;
use super::equilibrium::Equilibrium;
use super::program::{Interpretation, Program, Solution};

/// Widest gap of both bounds, relative, with which a load counts as found.
const GAP: f64 = 2e-3;

/// Scaled joint forces that balance the permanent loads with room to every limit of every joint.
pub(super) struct Roomy {
    forces: Vec<f64>,
    room: f64,
}

/// The state with most room; none where the blocks stand on a limit, or where it was not found.
pub(super) fn roomy(equilibrium: &Equilibrium) -> Option<Roomy> {
    let program = Program {
        scaled_loads: &[],
        // A room of the whole weight at every contact keeps the program bounded.
        cap: Some(1.0),
        interpretation: Interpretation::Margin,
        ..Program::of_the_factor(equilibrium)
    };
    let found = program.solve(TOLERANCE);
    let forces = balanced(equilibrium, found.forces, 0.0)?;
    let room = bounds::room(equilibrium, &forces);
    (room > 0.0).then_some(Roomy { forces, room })
}

/// The solution with forces in equilibrium and within strength, and the load that they carry. None where the mechanism's bound lies
/// further away than [`GAP`], on either side.
pub(super) fn proven(equilibrium: &Equilibrium, roomy: &Roomy, found: &Solution) -> Option<Solution> {
    let (forces, factor) = within(equilibrium, roomy, found)?;
    let upper = bounds::least_upper(equilibrium, &forces, &found.velocities);
    let meet = upper.violation < TOLERANCE && (upper.factor - factor).abs() <= GAP * factor.abs();
    (factor > 0.0 && meet).then(|| Solution { solved: true, forces, factor, ..found.clone() })
}

/// A factor up to `most` that is proven to be carried, scaled; none where nothing is. The load may be far from a mechanism, which makes
/// forces easier to find than those of the largest one.
pub(super) fn carried_up_to(equilibrium: &Equilibrium, roomy: &Roomy, most: f64) -> Option<f64> {
    let found = Program { cap: Some(most), ..Program::of_the_factor(equilibrium) }.solve(TOLERANCE);
    within(equilibrium, roomy, &found).map(|(_, factor)| factor)
}

/// Forces in equilibrium and within strength near those of a solution, and the factor that they carry.
fn within(equilibrium: &Equilibrium, roomy: &Roomy, found: &Solution) -> Option<(Vec<f64>, f64)> {
    let mut forces = balanced(equilibrium, found.forces.clone(), found.factor)?;
    let outside = -bounds::room(equilibrium, &forces);
    let mut factor = found.factor;
    if outside > 0.0 {
        let share = roomy.room / (roomy.room + outside);
        for (f, r) in forces.iter_mut().zip(&roomy.forces) {
            *f = share * *f + (1.0 - share) * r;
        }
        factor *= share;
    }
    let kept = bounds::yield_violation(equilibrium, &forces) <= ROUND_OFF * (1.0 + factor.abs());
    kept.then_some((forces, factor))
}

/// Round-off of sums of scaled forces.
const ROUND_OFF: f64 = 1e-11;

/// The forces with restraints between their bounds and what is out of balance taken by elastic joints.
fn balanced(equilibrium: &Equilibrium, mut forces: Vec<f64>, factor: f64) -> Option<Vec<f64>> {
    for r in &equilibrium.restraints {
        forces[r.column] = forces[r.column].clamp(0.0, r.most);
    }
    let left = equilibrium.residual(&forces, factor);
    let more = Stiffness::alike(equilibrium)?.balance(&left)?;
    for (f, d) in forces.iter_mut().zip(more) {
        *f += d;
    }
    Some(forces)
}

#[cfg(test)]
mod tests {
    use super::super::settings::{Friction, Settings};
    use super::*;
    use crate::blocks::{Block, BlockModel, ContactLaw, Held, LawTable, Loading, PointForce, Stiffness};
    use crate::ids::{BlockId, GroupId, Id, Table};
    use crate::plane::{Polygon, vec2};

    /// A block of 0.25 m by 1 m on the ground, pushed sideways at its middle by a share of its weight. It turns about the middle of
    /// what it crushes, `N / 2 f` inside its edge: (0.125 - 0.025) / 0.5.
    const CARRIED: f64 = 0.2;

    fn pushed() -> (BlockModel, Loading) {
        let block = |x, y, width, height, density, held| Block {
            outline: Polygon::rectangle(vec2(x, y), width, height).unwrap(),
            rounding: 0.0,
            density,
            group: GroupId(0),
            held,
        };
        let weight = 2000.0 * 9.81 * 0.25;
        let law = ContactLaw {
            normal: Stiffness::Given(1e9),
            shear: Stiffness::Given(1e8),
            friction: 0.7,
            cohesion: 0.0,
            tension: 0.0,
            crushing: weight / 0.05,
            fixed_length: None,
            least_length: 0.0,
        };
        let ground = block(-1.0, -0.5, 3.0, 0.5, 0.0, Held::FIXED);
        let model = BlockModel {
            blocks: [ground, block(0.0, 0.0, 0.25, 1.0, 2000.0, Held::FREE)].into_iter().collect(),
            particles: Table::default(),
            groups: ["block".to_string()].into_iter().collect(),
            laws: LawTable::uniform(1, law),
            gravity: vec2(0.0, -9.81),
        };
        let push = PointForce { block: BlockId::new(1), at: vec2(0.125, 0.5), force: vec2(weight, 0.0) };
        (model, Loading { variable: vec![push], ..Loading::default() })
    }

    #[test]
    fn rough_forces_prove_a_load_below_the_true_one() {
        let (model, loading) = pushed();
        let settings = Settings { friction: Friction::Associated, crushing: true, ..Settings::default() };
        let (_, equilibrium) = Equilibrium::new(&model, &loading, &settings).unwrap();
        let roomy = roomy(&equilibrium).expect("the block stands with room");
        let exact = Program::of_the_factor(&equilibrium).solve(TOLERANCE);
        let scale = equilibrium.factor_scale;
        assert!((exact.factor * scale / CARRIED - 1.0).abs() < 1e-6, "{}", exact.factor * scale);
        // Forces and load beyond what can be carried, as a solver leaves them: the proof stays below, by about what was added.
        for beyond in [0.0, 1e-7, 1e-5, 1e-4] {
            let mut rough = exact.clone();
            rough.factor *= 1.0 + beyond;
            rough.forces.iter_mut().for_each(|f| *f *= 1.0 - beyond);
            let found = proven(&equilibrium, &roomy, &rough).expect("both bounds meet");
            let carried = found.factor * scale;
            assert!(carried <= CARRIED * (1.0 + 1e-9), "{beyond}: {carried}");
            assert!(carried >= CARRIED * (1.0 - 20.0 * beyond - 1e-6), "{beyond}: {carried}");
            assert!(bounds::lower(&equilibrium, &found.forces).violation < 1e-10);
        }
        // However far out, nothing beyond is claimed.
        let mut wrong = exact.clone();
        wrong.factor *= 1.5;
        let claimed = proven(&equilibrium, &roomy, &wrong);
        assert!(claimed.is_none_or(|found| found.factor * scale <= CARRIED * (1.0 + 1e-9)));
    }
}
