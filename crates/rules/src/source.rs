//! Where a number is from, and how sure it is.

use crate::shape::{table, words};

table! {
    /// Where numbers are from.
    #[derive(Eq)]
    pub struct Source = "source" {
        must text: String, "document and clause or table";
        must date: String, "its year or edition";
        must confidence: Confidence, "how sure the number is";
        may[default] note: String, "what else a reader should know";
    }
}

words! {
    /// How sure a number is, the surest first.
    #[derive(PartialOrd, Ord, Default)]
    pub enum Confidence {
        /// Read in the source.
        Read = "read",
        /// Calculated from what was read.
        Calculated = "calculated",
        /// From memory: confirm it in the source before a verdict rests on it.
        Recalled = "recalled",
        /// Chosen, because no source gives it; the note says why.
        #[default]
        Assumed = "assumed",
    }
}
