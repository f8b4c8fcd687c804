//! Colour and shape of each method: told apart by those who see no colours too.

use crate::sheet::{Pen, Sheet, Spot};
use outcome::validation::Predictor;

/// Colours of Okabe and Ito (2008), which readers with any colour vision tell apart.
pub(super) fn colour(by: Predictor) -> &'static str {
    match by {
        Predictor::Weight => "#0072b2",
        Predictor::Pressure => "#d55e00",
        Predictor::Continuum => "#009e73",
        Predictor::Path => "#a0467d",
        Predictor::Movement => "#b8860b",
        Predictor::Particles => "#4d4d4d",
    }
}

/// The mark of a method: circle, square, triangle, diamond, the triangle upside down, hourglass.
pub(super) fn mark(sheet: &mut Sheet, at: Spot, by: Predictor) {
    let pen = Pen::shape(colour(by), "white", 1.0).class("prediction");
    let points: &[Spot] = match by {
        Predictor::Weight => return sheet.circle(at, 5.2, pen),
        Predictor::Pressure => &[[-4.7, -4.7], [4.7, -4.7], [4.7, 4.7], [-4.7, 4.7]],
        Predictor::Continuum => &[[0.0, -6.0], [5.8, 4.6], [-5.8, 4.6]],
        Predictor::Path => &[[0.0, -6.4], [6.4, 0.0], [0.0, 6.4], [-6.4, 0.0]],
        Predictor::Movement => &[[0.0, 6.0], [5.8, -4.6], [-5.8, -4.6]],
        Predictor::Particles => &[[-5.0, -5.0], [5.0, -5.0], [-5.0, 5.0], [5.0, 5.0]],
    };
    let points: Vec<Spot> = points.iter().map(|p| [at[0] + p[0], at[1] + p[1]]).collect();
    sheet.polygon(&points, pen);
}
