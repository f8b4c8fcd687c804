//! Which cases are answered without dilation beside their factors with it.

use super::{Answer, Key};

/// How much more dilation may be worth in a case than in any that was answered: a fifth of its factor.
const WORTH: f64 = 0.8;

/// Cases in turn from the least factor with dilation up, as long as one of them may govern without.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Turns {
    /// The least share of its factor with dilation that a case had without.
    share: f64,
    /// The least factor of all.
    least: f64,
}

impl Turns {
    /// Begins with the least factor with dilation.
    pub(crate) fn from(least: f64) -> Turns {
        Turns { share: 1.0, least }
    }

    /// Whether a case with this factor with dilation may carry less than all before it.
    pub(crate) fn may_govern(&self, dilatant: f64) -> bool {
        dilatant * self.share * WORTH < self.least
    }

    /// Takes what a case carries without dilation.
    pub(crate) fn met(&mut self, dilatant: f64, level: f64) {
        if dilatant > 0.0 {
            self.share = self.share.min(level / dilatant);
        }
        self.least = self.least.min(level);
    }
}

/// Of answers along drives those that are least among their neighbours, and others no nearer together than so far [m].
pub(crate) fn spaced(mut answers: Vec<Answer>, apart: f64) -> Vec<Answer> {
    answers.sort_by(|a, b| (a.key.drive.cmp(&b.key.drive)).then(a.key.position.total_cmp(&b.key.position)));
    let mut last: Option<Key> = None;
    let mut is_kept = |k: usize| {
        let Answer { key, factor, .. } = answers[k];
        let beside = [k.checked_sub(1), Some(k + 1)].into_iter().flatten().filter_map(|other| answers.get(other));
        let is_least = beside.filter(|other| other.key.drive == key.drive).all(|other| factor < other.factor);
        let before = last.filter(|last| last.drive == key.drive);
        let is_far = before.is_none_or(|last| key.position - last.position > apart * (1.0 - 1e-9));
        if is_least || is_far {
            last = Some(key);
        }
        is_least || is_far
    };
    let kept: Vec<usize> = (0..answers.len()).filter(|&k| is_kept(k)).collect();
    kept.into_iter().map(|k| answers[k]).collect()
}

#[cfg(test)]
mod tests {
    use super::{Answer, Key, Turns, spaced};

    #[test]
    fn places_near_one_another_are_asked_where_they_are_least() {
        let answer =
            |drive: usize, k: usize, factor: f64| Answer { key: Key::at(drive, 0.1 * k as f64), factor, upper: factor };
        let factors = [5.0, 4.0, 3.0, 2.5, 2.9, 3.3, 3.6, 3.5, 3.7];
        let drive = |drive: usize| factors.iter().enumerate().map(move |(k, factor)| answer(drive, k, *factor));
        let kept = spaced(drive(1).chain(drive(0)).collect(), 0.3);
        let told: Vec<(usize, f64)> = kept.iter().map(|one| (one.key.drive, one.factor)).collect();
        let one = |drive: usize| [5.0, 2.5, 3.6, 3.5].map(|factor| (drive, factor));
        assert_eq!(told, [one(0), one(1)].concat());
        assert_eq!(spaced(drive(0).collect(), 0.05).len(), 9, "places that are farther apart are all asked");
    }

    #[test]
    fn cases_are_asked_until_dilation_would_have_to_be_worth_a_fifth_more_than_in_any() {
        let mut turns = Turns::from(4.0);
        assert!(turns.may_govern(4.0) && turns.may_govern(4.99) && !turns.may_govern(5.01));
        turns.met(4.0, 3.0);
        // A case of 4.9 that lost as much would carry 3.7, and with a fifth less 2.94.
        assert!(turns.may_govern(4.9) && !turns.may_govern(5.1));
        turns.met(4.9, 2.45);
        assert!(turns.may_govern(6.1) && !turns.may_govern(6.2));
    }
}
