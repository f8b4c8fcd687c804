//! What every command is given.

use crate::clock::Clock;
use crate::screen::Screen;

/// Where a command speaks, and what its answer says of the run.
pub(crate) struct Desk {
    pub screen: Screen,
    pub clock: Clock,
    pub schema: String,
    /// The command line.
    pub words: Vec<String>,
}
