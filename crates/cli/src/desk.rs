//! What every command is given.

use crate::screen::Screen;
use std::time::Instant;

/// Where a command speaks, and what its answer says of the run.
pub(crate) struct Desk {
    pub screen: Screen,
    pub clock: Instant,
    pub schema: String,
    /// The command line.
    pub words: Vec<String>,
}
