//! Everything that is known of a bridge when it is judged. Checks and condition read this and nothing else.

use bridge::Bridge;
use bridge::assess::Assess;
use outcome::assessment::Facts;
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
    /// Paths of values whose remark in the file says that they are assumed.
    pub assumed: Vec<String>,
}
