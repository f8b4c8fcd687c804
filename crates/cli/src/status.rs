//! How a command ended: the words of `status`, each with its exit code and its card. Those of an analysis are its own.

use outcome::collapse::Status as AnalysisStatus;

/// Statuses: the word that scripts read with the exit code of the command, what it means and what to do.
macro_rules! statuses { ($($Name:ident: $head:expr, $meaning:literal;)*) => {
    /// How a command ended.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub(crate) enum Status { $($Name),* }

    /// Every status, in the order of the manual.
    pub(crate) const ALL: &[Status] = &[$(Status::$Name),*];

    impl Status {
        fn row(self) -> (&'static str, u8, &'static str) {
            let ((word, code), meaning) = match self { $(Status::$Name => ($head, $meaning)),* };
            (word, code, meaning)
        }
    }
} }

/// The word and the exit code of an analysis that ended so.
fn of(status: AnalysisStatus) -> (&'static str, u8) {
    (status.word(), status.exit_code())
}

statuses! {
    Collapsed: of(AnalysisStatus::Collapsed),
        "A load was found that turns the bridge into a mechanism: the result of a collapse analysis.";
    StableToLastLoad: of(AnalysisStatus::StableToLastLoad),
        "Every load up to the largest one tried was carried. Raise `load_limit` in [analysis] to find the collapse load.";
    Stalled: of(AnalysisStatus::Stalled),
        "A load step neither came to rest nor collapsed: the out-of-balance force oscillates without settling. \
                 The last stable load is valid, and no collapse load is given. Another damping, or a smaller time step \
                 factor, often gives a clear result.";
    UnstableUnderSelfWeight: of(AnalysisStatus::UnstableUnderSelfWeight),
        "The blocks do not stand under their own weight, before any load is applied. Check thickness, supports \
                 and densities, and look at the picture. A thin ring under deep fill may stand only because the fill \
                 resists: see [fill_pressure], and as = \"blocks\" in [backing].";
    Locks: of(AnalysisStatus::Locks),
        "The limit load is infinite: as rigid blocks with these joints the bridge cannot become a mechanism \
                 under this load. Give the masonry a compressive strength, or let a support move.";
    StepLimit: of(AnalysisStatus::StepLimit),
        "A load step used up its iterations while it was still settling. Raise `step_limit` in [analysis], or choose another damping.";
    NotConverged: of(AnalysisStatus::NotConverged),
        "The method found no reliable result: a number stopped being finite, or the solver stopped early. The \
                 message says where.";
    Cancelled: of(AnalysisStatus::Cancelled),
        "The run was interrupted. Its state is in the checkpoint; the same command with --resume continues to \
                 the same numbers. `vary` keeps finished runs, and the same command uses them automatically. A sweep \
                 holds the positions solved by then.";
    Completed: of(AnalysisStatus::Completed),
        "The command did what it was asked.";
    Adequate: ("adequate", 0),
        "An assessment finished, everything that its rule asks for was made and met, and so is every other limit of \
                 the file. Checks without a limit in the file are listed as not made and do not count; the head names \
                 the rule and what qualifies the verdict. extrados explain A190 has the ladder of verdicts.";
    Inadequate: ("inadequate", 1),
        "The command finished, and a check or a verification case is not met, or records were found doubtful.";
    Undetermined: ("undetermined", 3),
        "The command finished without a result: an analysis on which a check depends did not finish, no \
                 position of the loads turns the bridge into a mechanism, a position of a sweep has no result, no run \
                 of `vary` found the requested number, or no contact stiffness gives the fill the wanted modulus. An \
                 assessment whose analyses all finished, but in which something is missing that its rule asks for, \
                 is undetermined too and ends with exit code 1: its limits may be met, its strength is not shown, \
                 and `missing` says what to write.";
    UnusableInput: ("unusable-input", 2),
        "The input cannot be used; `errors` says what is wrong, where, and what to write instead.";
    NotWritten: ("not-written", 3),
        "The results could not be written; the message says where and why.";
}

impl Status {
    /// The word that scripts read.
    pub(crate) fn name(self) -> &'static str {
        self.row().0
    }

    /// The exit code of the command.
    pub(crate) fn exit_code(self) -> u8 {
        self.row().1
    }

    /// What it means, and what to do.
    pub(crate) fn meaning(self) -> &'static str {
        self.row().2
    }

    /// The worst of several analyses; where nothing failed, the command has completed.
    pub(crate) fn worst_of(all: impl Iterator<Item = AnalysisStatus>) -> Status {
        Status::of(extrados::written::worst(all).word())
    }

    /// The status of something that ended with this word.
    pub(crate) fn of(word: &str) -> Status {
        ALL.iter().copied().find(|status| status.name() == word).unwrap_or(Status::Undetermined)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_unique_and_lead_back() {
        for &status in ALL {
            assert_eq!(Status::of(status.name()), status);
        }
        assert_eq!(Status::of("fine"), Status::Undetermined);
    }
    #[test]
    fn every_status_of_an_analysis_is_one_of_the_command() {
        for &one in AnalysisStatus::ALL {
            assert_eq!(Status::of(one.word()).name(), one.word());
            assert_eq!(Status::of(one.word()).exit_code(), one.exit_code());
        }
    }
}
