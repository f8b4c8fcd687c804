//! Everything that is known of a bridge when it is judged. Checks and condition read this and nothing else.

use crate::checks::verdict;
use crate::condition::condition;
use crate::next;
use bridge::Bridge;
use bridge::assess::Assess;
use outcome::assessment::{Assessment, Facts};
use outcome::checked::Checked;
use outcome::given::Doubt;
use outcome::statics::Statics;

/// A bridge with the facts of its stages.
#[derive(Debug, Clone, PartialEq)]
pub struct Evidence {
    /// The bridge that was analysed: with updated parameters where records gave them.
    pub bridge: Bridge,
    /// What the file asks for.
    pub asked: Assess,
    /// The facts.
    pub facts: Facts,
    /// Weights and reactions at rest, where they were made.
    pub statics: Option<Statics>,
    /// Doubtful values of the file, of its vehicles and of its rule.
    pub doubts: Vec<Doubt>,
}

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
