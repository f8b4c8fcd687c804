//! Recheck of the eliminated parts: the linear system is solved for many equilibria at once, and every part that screening does
//! not prove linear is evaluated in each of them.

use super::{Condensed, CondensedError, Equilibrium};
use crate::fem::many::WIDEST;

/// Steps before the end of a batch over which displacements are extrapolated beyond it.
const EXTRAPOLATION_BASE: usize = 3;

/// What a recheck of some positions has found.
pub(super) struct Recheck {
    /// Eliminated parts that are nonlinear in some position and have to be retained.
    pub to_retain: Vec<usize>,
    /// Whether each position is valid: no eliminated part is nonlinear there.
    pub valid: Vec<bool>,
}

impl Condensed {
    /// Rechecks the eliminated parts at the equilibria `ends` of some positions, and at those in which springs broke on the way
    /// to the position with the number beside them. Where the positions follow one another, parts are also rechecked `lookahead`
    /// steps beyond the last one, by extrapolation: parts that are nonlinear there alone are retained early. The solutions of the
    /// linear system that are kept begin with those of `ends`.
    pub(super) fn recheck_eliminated(
        &mut self,
        ends: &[&Equilibrium],
        breaks: &[(usize, &Equilibrium)],
        lookahead: usize,
    ) -> Result<Recheck, CondensedError> {
        let mut found = Recheck { to_retain: Vec::new(), valid: vec![true; ends.len()] };
        let (last, first) = breaks.split_at(breaks.len().min(WIDEST - ends.len()));
        for breaks in first.chunks(WIDEST) {
            self.solve_full_system(&breaks.iter().map(|(_, equilibrium)| *equilibrium).collect::<Vec<_>>());
            self.recheck_solutions(
                &breaks.iter().map(|(position, _)| Some(*position)).collect::<Vec<_>>(),
                &mut found,
            )?;
        }
        let last_breaks = last.iter().map(|(_, equilibrium)| *equilibrium);
        self.solve_full_system(&ends.iter().copied().chain(last_breaks).collect::<Vec<_>>());
        let mut positions: Vec<Option<usize>> =
            (0..ends.len()).chain(last.iter().map(|(position, _)| *position)).map(Some).collect();
        if lookahead > 0 && ends.len() > 1 && positions.len() < self.block.width {
            self.block.extend_beyond(ends.len(), EXTRAPOLATION_BASE, lookahead, positions.len());
            positions.push(None);
        }
        self.recheck_solutions(&positions, &mut found)?;
        Ok(found)
    }

    /// Rechecks the eliminated parts in the solutions found last, which belong to the given `positions`, or to none.
    fn recheck_solutions(&mut self, positions: &[Option<usize>], found: &mut Recheck) -> Result<(), CondensedError> {
        for index in self.screening.unproven(&self.model, &self.block, positions.len(), &self.is_retained) {
            let part = &mut self.parts[index];
            if part.proves_linear(&self.model, &self.block, positions.len()) {
                continue;
            }
            let mut retain = false;
            for (lane, position) in positions.iter().enumerate() {
                part.evaluate_in(&self.model, &self.block, lane).ok_or(CondensedError::Broken)?;
                if part.needs_retaining(&self.model) {
                    retain = true;
                    position.iter().for_each(|&position| found.valid[position] = false);
                }
            }
            if retain && !found.to_retain.contains(&index) {
                found.to_retain.push(index);
            }
        }
        Ok(())
    }
}
