//! Model updating: the moduli of a bridge from the records of a train's passage.

mod outcome;

pub use outcome::{
    Histories, PaperSearch, ParameterPlace, PosteriorReport, RecordsUsed, RunUsed, SearchLine, Update, UpdateStatus,
};

/// A search for parameters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Search {
    /// The railway paper's, by single sweeps and surfaces of two.
    Hierarchical,
    /// Trust-region least squares from many starts.
    Modern,
    /// Evolution over the whole ranges.
    Referee,
    /// A plain gradient search from one start.
    Gradient,
}

impl Search {
    /// The word that scripts read.
    pub fn word(self) -> &'static str {
        match self {
            Search::Hierarchical => "hierarchical",
            Search::Modern => "modern",
            Search::Referee => "referee",
            Search::Gradient => "gradient",
        }
    }
}
