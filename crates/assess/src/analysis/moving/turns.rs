//! Which cases are answered without dilation beside their factors with it.

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

#[cfg(test)]
mod tests {
    use super::Turns;

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
