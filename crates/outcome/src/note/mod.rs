//! What a result assumes, as data: each kind of note has its numbers [SI] and, beside them, the one sentence that says it. Files keep the
//! data; the published formats and the reports print the sentence, and nothing reads it back.

mod at_rest;
mod barrel;
mod blocks;
mod defect;
mod fill;
mod passage;
mod soil;
mod state;
mod update;
mod vehicles;

pub use at_rest::AtRest;
pub use barrel::Barrel;
pub use blocks::{Blocks, Bond, FiniteStones};
pub use defect::{DefectNote, place_of_defect, words_of_defect};
pub use fill::Fill;
pub use passage::{InPassage, JointShear};
pub use soil::Soil;
pub use state::{Size, State};
pub use update::InUpdate;
pub use vehicles::{Governing, Moving, Sideways};

use crate::sentences::subjects;
use crate::wire::{Unit, Wire};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

subjects! {
    /// An assumption or a caveat of a result.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub enum Note {
        /// Loads at rest.
        AtRest,
        /// Supports, spans, cracks, walls and what a plane model leaves out.
        Barrel,
        /// Blocks and joints, by the method.
        Blocks,
        /// Defects of rings.
        DefectNote,
        /// Fill, backing, water, road and dispersal.
        Fill,
        /// Trains that pass.
        InPassage,
        /// Model updating.
        InUpdate,
        /// Loads and vehicles that move.
        Moving,
        /// Fill that yields as a continuum.
        Soil,
        /// What helps a bridge and may come and go.
        State,
    }
}

impl Wire for Note {
    fn wire(&self, _: Unit) -> Value {
        json!(self.to_string())
    }
}

/// The sentences of notes.
pub fn words(notes: &[Note]) -> Vec<String> {
    notes.iter().map(Note::to_string).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::help::Help;

    #[test]
    fn notes_are_data_in_files_and_sentences_for_readers() {
        let notes: [Note; 4] = [
            Blocks::FrictionNonAssociated { associated_load: Some(12_345.0) }.into(),
            Barrel::Cracks { strips: vec![2.0, 2.5] }.into(),
            State::Counted { helps: vec![Help::Water], without: Size::Load(2e4), with: Size::Load(1e4) }.into(),
            InPassage::Mortar { shear: JointShear::Friction([(0.5, 1e3), (0.5, 0.0)]) }.into(),
        ];
        let kept = serde_json::to_string(&notes).unwrap();
        assert_eq!(serde_json::from_str::<Vec<Note>>(&kept).unwrap(), notes);
        let [friction, cracks, counted, mortar] = notes.map(|note| note.to_string());
        assert!(friction.ends_with("collapse; the associated load is 12.35 kN/m."), "{friction}");
        assert!(
            cracks.starts_with("Longitudinal cracks through the barrel leave strips of 2.00 m, 2.50 m: each"),
            "{cracks}"
        );
        assert_eq!(counted, "Without water in the fill the bridge would carry 20.00 kN/m in place of 10.00 kN/m.");
        assert!(
            mortar.contains("[joint], tan 28.6° and 1.0 kPa (tan 28.6° and 0.0 kPa between rings): nothing"),
            "{mortar}"
        );
    }
}
