//! Why the work of a calibration ends before its end.

use crate::analysis::AnalysisError;

/// See above.
#[derive(Debug)]
pub(super) enum Halt {
    /// The onlooker stopped it.
    Stopped,
    Failed(AnalysisError),
}

impl<E: Into<AnalysisError>> From<E> for Halt {
    fn from(error: E) -> Halt {
        Halt::Failed(error.into())
    }
}
