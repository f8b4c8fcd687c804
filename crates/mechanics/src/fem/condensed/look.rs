//! All parts that do not take part, in many balanced places at once.

use super::{Condensed, CondensedError, Place};
use crate::fem::many::WIDEST;

/// Steps of which the way beyond a stretch of positions is made out.
const SINCE: usize = 3;

impl Condensed<'_> {
    /// Parts that would have to take part where positions end and where something broke on the way to the one of that number, and whether each of the positions
    /// stands as it is. Positions on a way are looked at beyond their end, too, going on by so many steps. The solutions that are kept begin with those of the ends.
    pub(super) fn joining(
        &mut self,
        ends: &[&Place],
        breaks: &[(usize, &Place)],
        ahead: usize,
    ) -> Result<(Vec<usize>, Vec<bool>), CondensedError> {
        let mut found = (Vec::new(), vec![true; ends.len()]);
        let (beside, apart) = breaks.split_at(breaks.len().min(WIDEST - ends.len()));
        for breaks in apart.chunks(WIDEST) {
            self.displace(&breaks.iter().map(|(_, place)| *place).collect::<Vec<_>>());
            self.look(&breaks.iter().map(|(position, _)| Some(*position)).collect::<Vec<_>>(), &mut found)?;
        }
        self.displace(&ends.iter().copied().chain(beside.iter().map(|(_, place)| *place)).collect::<Vec<_>>());
        let mut of: Vec<Option<usize>> =
            (0..ends.len()).chain(beside.iter().map(|(position, _)| *position)).map(Some).collect();
        if ahead > 0 && ends.len() > 1 && of.len() < self.block.width() {
            self.block.extend_beyond(ends.len(), SINCE, ahead, of.len());
            of.push(None);
        }
        self.look(&of, &mut found)?;
        Ok(found)
    }

    /// Looks at all parts that do not take part, in each of the solutions found last, which is of a position or of none.
    fn look(&mut self, of: &[Option<usize>], found: &mut (Vec<usize>, Vec<bool>)) -> Result<(), CondensedError> {
        let (joining, stands) = found;
        for index in self.screening.unproven(self.model, &self.block, of.len(), &self.is_active) {
            let part = &mut self.parts[index];
            if part.proves_linear(self.model, &self.block, of.len()) {
                continue;
            }
            let mut joins = false;
            for (lane, position) in of.iter().enumerate() {
                part.evaluate_in(self.model, &self.block, lane).ok_or(CondensedError::Broken)?;
                if part.needs_retaining(self.model) {
                    joins = true;
                    position.iter().for_each(|&position| stands[position] = false);
                }
            }
            if joins && !joining.contains(&index) {
                joining.push(index);
            }
        }
        Ok(())
    }
}
