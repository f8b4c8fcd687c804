//! A lower answer where the way without dilation has no end: no friction in the joints that slide.
//!
//! Sliding without dilation is not associated, so that forces within the friction cones prove nothing by themselves.
//! They do for a smaller strength to which level sliding is normal and which lies inside every cone that the true forces
//! may reach (D. Radenkovic, "Théorèmes limites pour un matériau de Coulomb à dilatation non standardisée", C. R. Acad.
//! Sci. Paris 252, 1961, second theorem). Level sliding is normal to `|S| <= constant` alone, and inside every cone
//! `|S| <= friction N` with `N >= 0` lies only `S = 0`.
//!
//! Written out: let forces `f` with these strengths balance the factor `a`, and let true forces `g` move at `b` as a
//! mechanism whose joints open about their points everywhere and slide level in the joints without friction. By
//! virtual work `(a - b) P` is the sum of `(f - g)` times the motions, `P > 0` being what the load does. Opening points have
//! `g = 0` and `f >= 0`, sliding joints `f = 0` and `g` against the motion: no term is positive, so `a <= b`.
//!
//! What it bounds are mechanisms in which no other joint slides. Joints that slide in the mechanism found lose their
//! friction too, until none does; a mechanism in which yet others slide is not excluded.

use super::bounds;
use super::collapse::largest_factor;
use super::equilibrium::Equilibrium;
use super::joints::Strength;
use super::mechanism::mechanism;
use super::outcome::Status;
use crate::blocks::BlockModel;

/// Scaled load factor without friction and cohesion in the joints that slide; `None` where that carries nothing.
/// `sliding` are those of the associated mechanism.
pub(super) fn smooth(model: &BlockModel, equilibrium: &Equilibrium, sliding: &[usize]) -> Option<f64> {
    let mut weaker = equilibrium.clone();
    let mut slides = vec![false; equilibrium.joints.len()];
    let mut more = sliding.to_vec();
    // Every round takes the friction of one joint more at least.
    loop {
        for &joint in &more {
            slides[joint] = true;
            let strength = &mut weaker.joints[joint].strength;
            *strength = Strength { friction: 0.0, cohesion: 0.0, ..*strength };
        }
        let found = largest_factor(&weaker);
        if found.status != Status::Solved {
            return None;
        }
        let moving = mechanism(model, equilibrium, &found.solution.velocities)?;
        more = moving.sliding.into_iter().filter(|&joint| !slides[joint]).collect();
        if more.is_empty() {
            return Some(bounds::lower(equilibrium, &found.solution.forces).factor);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::joints::Joint;
    use super::super::settings::Settings;
    use super::*;
    use crate::blocks::{Block, ContactLaw, Held, LawTable, Loading, PointForce, Stiffness};
    use crate::ids::{BlockId, GroupId, Id, Table};
    use crate::plane::{Polygon, vec2};

    /// Of the floor [rad].
    const SLOPE: f64 = 0.2;
    const FRICTION: f64 = 0.6;
    /// Of a block of 2 m by 1 m [N/m].
    const WEIGHT: f64 = 2.0 * 2000.0 * 10.0;

    /// So many blocks in a row on a sloping floor, the lowest against a stop and pushed up the slope by 1 N/m. Gravity is
    /// inclined in place of the floor.
    fn pushed_uphill(blocks: usize) -> (BlockModel, Loading) {
        let block = |x: f64, y: f64, width: f64, held: Held| Block {
            outline: Polygon::rectangle(vec2(x, y), width, 1.0).unwrap(),
            rounding: 0.0,
            density: 2000.0,
            group: GroupId(0),
            held,
        };
        let law = ContactLaw {
            normal: Stiffness::Given(1e9),
            shear: Stiffness::Given(1e8),
            friction: FRICTION,
            cohesion: 0.0,
            tension: 0.0,
            crushing: f64::INFINITY,
            fixed_length: None,
            least_length: 0.0,
        };
        let fixed = [block(-1.0, -1.0, 20.0, Held::FIXED), block(-1.0, 0.0, 1.0, Held::FIXED)];
        let row = (0..blocks).map(|k| block(2.0 * k as f64, 0.0, 2.0, Held::FREE));
        let model = BlockModel {
            blocks: fixed.into_iter().chain(row).collect(),
            particles: Table::default(),
            groups: ["block".to_string()].into_iter().collect(),
            laws: LawTable::uniform(1, law),
            gravity: vec2(-SLOPE.sin(), -SLOPE.cos()) * 10.0,
        };
        let push = PointForce { block: BlockId::new(2), at: vec2(0.0, 0.2), force: vec2(1.0, 0.0) };
        (model, Loading { variable: vec![push], ..Loading::default() })
    }

    /// Loads [N/m] with all friction, and with none where the first block of the row lies on the floor and where more slides then.
    fn loads(blocks: usize) -> [f64; 2] {
        let (model, loading) = pushed_uphill(blocks);
        let (_, equilibrium) = Equilibrium::new(&model, &loading, &Settings::default()).unwrap();
        let rough = largest_factor(&equilibrium);
        assert_eq!(rough.status, Status::Solved);
        let floor = |joint: &Joint| (joint.first, joint.second) == (BlockId::new(0), BlockId::new(2));
        let sliding = [equilibrium.joints.iter().position(floor).unwrap()];
        let without = smooth(&model, &equilibrium, &sliding).unwrap();
        [rough.solution.factor, without].map(|factor| factor * equilibrium.factor_scale)
    }

    /// Ten times the tolerance of the solver.
    fn same(found: f64, expected: f64) -> bool {
        (found / expected - 1.0).abs() < 10.0 * super::super::collapse::TOLERANCE
    }

    #[test]
    fn a_block_without_friction_is_pushed_up_a_slope_by_its_weight_along_it() {
        let [rough, without] = loads(1);
        assert!(same(rough, WEIGHT * (SLOPE.sin() + FRICTION * SLOPE.cos())), "{rough}");
        assert!(same(without, WEIGHT * SLOPE.sin()), "{without}");
    }

    #[test]
    fn joints_that_slide_only_without_the_friction_of_others_lose_theirs_too() {
        let [rough, without] = loads(3);
        assert!(same(rough, 3.0 * WEIGHT * (SLOPE.sin() + FRICTION * SLOPE.cos())), "{rough}");
        assert!(same(without, 3.0 * WEIGHT * SLOPE.sin()), "{without}");
    }
}
