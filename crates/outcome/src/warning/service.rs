//! Passages, updates and what a command says of stages and figures.

use super::cards::warnings;
use crate::sentences::listed;
use findings::words::{counted, verb};

warnings! {
    /// Of passages, updates and their records.
    Service {
        /// A passage that broke off.
        BROKEN_PASSAGE: BrokenPassage { reason: String } => "{reason}";
        /// A wide tolerance, as a share of the applied forces.
        LOOSE_PASSAGE: Loose { tolerance: f64 } =>
            "a step counts as converged at an out-of-balance force of {tolerance:.1e} of the applied forces";
        WALLS_LEFT_OUT: WallsLeftOut => "the strip of finite elements lies between the spandrel walls: their stiffness, and their parting from \
                                         the barrel, is left out";
        LOCKING_FILL: Locking { elements: usize } =>
            "up to {} of the fill {} as a whole: plain elements then carry more than the fill does, on a coarse mesh by a tenth",
            counted(*elements, "element"), verb(*elements, "flows", "flow");
        /// Channels whose peaks may lie between the positions, so far apart, with the largest share that they may miss.
        COARSE_PASSAGE: CoarsePassage { apart [m]: f64, channels: Vec<String>, share: f64 } =>
            "peaks may lie between the positions, which are up to {apart:.2} m apart: {} may be {:.0} % larger", listed(channels), 100.0 * share;
        /// Where the axle stood that found no balance.
        NO_INFLUENCE_LINES: NoInfluenceLines { at [m]: f64 } =>
            "there are no influence lines: the heaviest axle by itself finds no balance at {at:.2} m";
        /// What an update could not tell, and why.
        UNTOLD: Untold { what: Asked, why: String } => "{what} could not be told: {why}";
        SYNTHETIC: Synthetic { records: Vec<String> } => "records that were computed and not measured: {}", listed(records);
        AT_BOUND: AtBound { parameter: String } => "{parameter} stands on a bound of its range and has not converged";
        WANDERED: Wandered { peaks: Vec<String> } => "peaks outside the slices of the search: {}", listed(peaks);
    }
}

crate::sentences::notes! {
    /// What an update is asked for.
    Asked {
        StartFit => "the start model's fit";
        Identifiability => "identifiability";
        Intervals => "intervals";
        Posterior => "the posterior";
    }
}

warnings! {
    /// Of a command: its stages, its figures, its verdict.
    Command {
        NOT_DRAWN: NotDrawn { particles: usize, most: usize } =>
            "{particles} particles are not drawn: figures hold at most {most}; ParaView files and tables hold all of them";
        /// What an assessment of strength lacks.
        STRENGTH_OPEN: StrengthOpen { missing: Vec<String> } => "{}", missing.join("; ");
        /// A stage that failed, and how.
        STAGE_FAILED: StageFailed { stage: String, state: String } => "stage {stage}: {state}";
    }
}
