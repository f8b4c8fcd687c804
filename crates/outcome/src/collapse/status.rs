//! How an analysis ended.

use crate::words::words;

words! {
    /// How an analysis ended. All of these are answers.
    #[derive(Default)]
    pub enum Status {
        /// A load was found that makes a mechanism.
        Collapsed = "collapsed",
        /// Every load up to the limit was carried.
        StableToLastLoad = "stable-to-last-load",
        /// A load step neither came to rest nor collapsed.
        Stalled = "stalled",
        /// The bridge does not stand under its own weight.
        UnstableUnderSelfWeight = "unstable-under-self-weight",
        /// The limit load is unbounded.
        Locks = "locks",
        /// A load step used up its iterations.
        StepLimit = "step-limit",
        /// The method did not reach its tolerance.
        #[default]
        NotConverged = "not-converged",
        /// Stopped by its onlooker.
        Cancelled = "cancelled",
        /// An analysis without a collapse load ended as it should.
        Completed = "completed",
    }
}

impl Status {
    /// The exit code of the command: 0 finished, 1 finished and the bridge does not stand, 3 could not finish, 130
    /// interrupted.
    pub fn exit_code(self) -> u8 {
        match self {
            Status::Collapsed | Status::StableToLastLoad | Status::Stalled | Status::Locks | Status::Completed => 0,
            Status::UnstableUnderSelfWeight => 1,
            Status::StepLimit | Status::NotConverged => 3,
            Status::Cancelled => 130,
        }
    }
}
