//! The mechanism of blocks and fill: where the fill slips.

use super::{loops, of, on_sheet};
use crate::colour::blue_for_much;
use crate::elevation::INK;
use crate::geometry::View;
use crate::mechanism::drawn;
use crate::sheet::{Anchor, Area, HAIR, MARGIN, Pen, Sheet, Style};
use outcome::picture::Picture;
use outcome::soil::SoilPicture;

/// Classes of dissipation, each of one colour.
const CLASSES: usize = 12;
/// Powers of ten that they cover.
const DECADES: i32 = 3;
/// Share of the map of colours at which the lowest class begins, so that it differs from the pale fill.
const FIRST: f64 = 0.14;

/// The mechanism with the fill moved along and coloured by its dissipation. None without soil, or without a mechanism.
pub fn soil_mechanism(picture: &Picture) -> Option<String> {
    let soil = of(picture).filter(|soil| soil.dissipation.len() == soil.triangles.len())?;
    drawn(picture, Some(soil))
}

/// The class of a triangle, from 1; 0 where it dissipates next to nothing.
fn class(dissipation: f64) -> usize {
    if dissipation.is_nan() || dissipation <= 0.0 {
        return 0;
    }
    let share = 1.0 + dissipation.log10() / f64::from(DECADES);
    (share * CLASSES as f64).ceil().clamp(0.0, CLASSES as f64) as usize
}

/// The colour of a class.
fn colour(class: usize) -> String {
    blue_for_much(FIRST + (1.0 - FIRST) * class.saturating_sub(1) as f64 / (CLASSES - 1) as f64)
}

/// Triangles that dissipate, moved and coloured, over the pale fill.
pub(crate) fn dissipating(sheet: &mut Sheet, view: &View, soil: &SoilPicture, scale: f64) {
    let classes: Vec<usize> = soil.dissipation.iter().map(|&d| class(d)).collect();
    sheet.open("dissipation");
    for class in 1..=CLASSES {
        let outlines = on_sheet(soil, &loops(soil, |t| classes.get(t) == Some(&class)), view, scale);
        let colour = colour(class);
        // A hair of the same colour closes the seams between classes.
        sheet.loops(&outlines, Pen::shape(&colour, &colour, 0.3).class("slip"));
    }
    sheet.close();
}

/// What the colours stand for; returns the y below.
pub(crate) fn key(sheet: &mut Sheet, top: f64) -> f64 {
    let style = Style::small();
    let title = "Power dissipated per area of the fill, relative to the largest";
    let (left, wide) = (MARGIN + 18.0, 320.0);
    let y = sheet.paragraph(MARGIN, top, 760.0, title, style);
    let (upper, lower) = (y + 5.0, y + 17.0);
    let at = |share: f64| left + share * wide;
    sheet.open("legend");
    for k in 0..CLASSES {
        let (a, b) = (at(k as f64 / CLASSES as f64), at((k + 1) as f64 / CLASSES as f64));
        let colour = colour(k + 1);
        sheet.rectangle(Area { left: a, right: b, top: upper, bottom: lower }, Pen::shape(&colour, INK, HAIR));
    }
    for decade in 0..=DECADES {
        let x = at(f64::from(decade) / f64::from(DECADES));
        sheet.line([x, lower], [x, lower + 4.0], Pen::line(INK, 0.9));
        let words = crate::words::four_digits(10f64.powi(decade - DECADES));
        sheet.text([x, lower + 16.0], &words, style.anchored(Anchor::Middle));
    }
    sheet.close();
    lower + 22.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn classes_are_even_in_powers_of_ten() {
        assert_eq!([0.0, -1.0, f64::NAN, 1e-3, 1e-9].map(class), [0; 5]);
        assert_eq!([1.1e-3, 1.1e-2, 0.11, 0.9, 1.0, 7.0].map(class), [1, 5, 9, 12, 12, 12]);
        let colours: std::collections::BTreeSet<String> = (1..=CLASSES).map(colour).collect();
        assert_eq!(colours.len(), CLASSES);
    }
}
