//! Which pairs break.
//!
//! A pair that loses its tension at once when it breaks gives the model two balanced states: one in which it holds, and one in which it has let go. A joint
//! that is loaded slowly keeps to the first as long as there is one. So balance is sought with all whole pairs holding; if some are then beyond their strength,
//! those that are so most break, for good, and balance is sought again, until none is. The state that is found does not depend on how Newton's method gets
//! there. It is the rule of sequentially linear analysis (J. G. Rots and S. Invernizzi, Int. J. Numer. Anal. Meth. Geomech. 28,
//! 2004, 821-856), within each step of the load.

/// Overstress, over the largest there is, from which pairs break together: alike pairs of a symmetric ring must, whatever rounding says. Each turn costs some
/// iterations: with 0.9 an evaluation for updating, whose steps are long, takes a tenth longer.
const ALIKE: f64 = 0.5;

/// Those of `pairs`, by number with their tension over strength, that break first; none where all are within their strength.
pub(in crate::fem) fn weakest(pairs: impl Iterator<Item = (usize, f64)>) -> Vec<usize> {
    let beyond: Vec<(usize, f64)> = pairs.filter(|(_, overstress)| *overstress > 1.0).collect();
    let most = beyond.iter().fold(0.0_f64, |most, (_, overstress)| most.max(*overstress));
    beyond.into_iter().filter(|(_, overstress)| *overstress >= ALIKE * most).map(|(pair, _)| pair).collect()
}

#[cfg(test)]
mod tests {
    use super::weakest;

    #[test]
    fn the_most_overstressed_break_first_and_alike_ones_together() {
        let of = |overstress: &[f64]| weakest(overstress.iter().copied().enumerate());
        assert_eq!(of(&[0.0, 0.3, 1.0]), [0; 0]);
        assert_eq!(of(&[1.2, 0.3, 3.0, 1.0, 2.9999, 1.4]), [2, 4]);
        assert_eq!(of(&[1.05, 1.0, 1.1]), [0, 2]);
        assert_eq!(of(&[1.0 + 1e-12, 0.99]), [0]);
        assert_eq!(of(&[f64::NAN, 2.0]), [1]);
    }
}
