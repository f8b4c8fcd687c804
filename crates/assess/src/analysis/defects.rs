//! Defects of rings in words and as lines of the drawing.

use super::geometry::point;
use bridge::defect::{Defect, DefectKind};
use bridge::{Bridge, Span};
use outcome::note::{DefectNote, Note, place_of_defect, words_of_defect};
use outcome::picture::DefectMark;
use structure::discretise::defect_line;

/// Every defect with the number of its span.
fn every(bridge: &Bridge) -> impl Iterator<Item = (usize, &Span, &Defect)> {
    bridge.spans.iter().enumerate().flat_map(|(number, span)| span.defects.iter().map(move |one| (number, span, one)))
}

/// What blocks feel of each defect, for the assumptions of a result.
pub(super) fn told(bridge: &Bridge) -> Vec<Note> {
    every(bridge).map(|(number, span, one)| felt(bridge, number, span, one)).collect()
}

/// What a finite element model of stones, joints and fill feels of them.
pub(super) fn told_of_elements(bridge: &Bridge) -> Vec<Note> {
    let note = |(number, span, one): (usize, &Span, &Defect)| match one.kind {
        DefectKind::ThinRing { .. } => felt(bridge, number, span, one),
        _ => DefectNote::LeftOut { span: named(bridge, number), defect: *one }.into(),
    };
    every(bridge).map(note).collect()
}

fn felt(bridge: &Bridge, number: usize, span: &Span, one: &Defect) -> Note {
    DefectNote::Felt { span: named(bridge, number), defect: *one, stones: span.rings[0].voussoirs }.into()
}

/// The number of a span, where there are several.
fn named(bridge: &Bridge, number: usize) -> Option<usize> {
    (bridge.spans.len() > 1).then_some(number)
}

/// The lines that drawings mark.
pub(super) fn marks(bridge: &Bridge) -> Vec<DefectMark> {
    let mark = |(number, _, one): (usize, &Span, &Defect)| DefectMark {
        words: format!("{}, {}", words_of_defect(one), place_of_defect(named(bridge, number), one)),
        line: defect_line(bridge, number, one).into_iter().map(point).collect(),
    };
    every(bridge).map(mark).collect()
}
