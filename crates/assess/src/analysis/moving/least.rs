//! Which of several answers governs.

use super::Key;

/// Cases tie whose factors differ by less than this, relative. Two bounds of one factor may lie 1e-9 of it apart, and round-off
/// below that differs from one machine to another; what differs in a vehicle or its place moves a factor by far more, or not at all.
const TIES: f64 = 1e-7;

/// An answered case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Answer {
    pub key: Key,
    /// Factor of forces within strength.
    pub factor: f64,
    /// Factor of a mechanism.
    pub upper: f64,
}

/// The least factor of answers, with the first case of those that tie for it: which one governs does not hang on round-off.
pub(crate) fn least(answers: &[Answer]) -> Option<Answer> {
    let least = answers.iter().min_by(|a, b| a.factor.total_cmp(&b.factor))?;
    let first = answers.iter().find(|answer| answer.factor <= least.factor * (1.0 + TIES))?;
    Some(Answer { key: first.key, ..*least })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_case_that_ties_governs_by_the_least_factor() {
        let answer =
            |position: f64, factor: f64| Answer { key: Key::at(0, position), factor, upper: factor * (1.0 + 1e-12) };
        let [far, last, first] = [answer(1.0, 4.1), answer(3.0, 4.0), answer(2.0, 4.0 * (1.0 + 4e-10))];
        assert_eq!(least(&[far, first, last]), Some(Answer { key: first.key, ..last }));
        assert_eq!(least(&[far, last, first]), Some(last));
        assert_eq!(least(&[far]), Some(far));
        assert_eq!(least(&[]), None);
    }
}
