//! What evidence amounts to: the assessment.

use crate::checks::verdict;
use crate::condition::condition;
use crate::evidence::Evidence;
use crate::next;
use outcome::assessment::Assessment;
use outcome::checked::Checked;

impl Evidence {
    /// What its checks amount to.
    pub fn judged(self, checked: Vec<Checked>) -> Assessment {
        let verdict = verdict(&self, &checked);
        Assessment {
            bridge: self.bridge.name.clone(),
            next: next::steps(&self, &checked, &verdict),
            verdict,
            condition: condition(&self),
            limits_source: self.asked.limits.source,
            facts: self.facts,
            checked,
            statics: self.statics,
        }
    }
}
