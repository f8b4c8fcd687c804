//! Colour bars: what a colour stands for.

use crate::elevation::INK;
use crate::sheet::{Anchor, Area, HAIR, Pen, SMALL, Sheet, Style};
use crate::ticks::Ticks;

/// A scale of colours with its values.
pub struct Scale<'a> {
    /// What it measures, with its unit.
    pub title: &'a str,
    /// Values along it.
    pub ticks: Ticks,
    /// Colour of a share from 0 to 1.
    pub colour: fn(f64) -> String,
    /// Whether values above its end are drawn in the colour of its end.
    pub cut: bool,
}

impl Scale<'_> {
    /// The colour of a value.
    pub fn of(&self, value: f64) -> String {
        let [low, high] = self.ticks.range();
        (self.colour)((value - low) / (high - low))
    }

    /// Draws the bar under its title; returns the y below.
    pub fn draw(&self, sheet: &mut Sheet, left: f64, right: f64, top: f64) -> f64 {
        const STEPS: usize = 96;
        let style = Style { size: SMALL, ..Style::default() };
        let y = sheet.paragraph(left, top, right - left + 10.0, self.title, style);
        let (left, right) = (left + 10.0, right - 14.0);
        let (upper, lower) = (y + 5.0, y + 19.0);
        let at = |share: f64| left + share * (right - left);
        sheet.open("legend");
        for k in 0..STEPS {
            let (a, b) = (k as f64 / STEPS as f64, (k + 1) as f64 / STEPS as f64);
            let colour = (self.colour)(0.5 * (a + b));
            // Neighbours overlap a little, so that no white seam shows between them.
            let end = (at(b) + 0.4).min(right);
            sheet.rectangle(
                Area { left: at(a), right: end, top: upper, bottom: lower },
                Pen::shape(&colour, "none", 0.0),
            );
        }
        sheet.rectangle(Area { left, right, top: upper, bottom: lower }, Pen::line(INK, HAIR));
        if self.cut {
            let tip = [right + 9.0, 0.5 * (upper + lower)];
            let colour = (self.colour)(1.0);
            sheet.polygon(&[[right, upper], tip, [right, lower]], Pen::shape(&colour, INK, HAIR));
        }
        let [low, high] = self.ticks.range();
        for &value in &self.ticks.values {
            let x = at((value - low) / (high - low));
            sheet.line([x, lower], [x, lower + 4.0], Pen::line(INK, 0.9));
            sheet.text([x, lower + 17.0], &self.ticks.words(value), style.anchored(Anchor::Middle));
        }
        sheet.close();
        lower + 24.0
    }
}

/// The value below which a share of the finite values lies; zero without any.
pub fn quantile(values: impl IntoIterator<Item = f64>, share: f64) -> f64 {
    let mut values: Vec<f64> = values.into_iter().filter(|v| v.is_finite()).collect();
    values.sort_by(f64::total_cmp);
    let at = (share * values.len().saturating_sub(1) as f64).round() as usize;
    values.get(at).copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quantile_leaves_what_is_not_a_number_out() {
        assert_eq!(quantile([3.0, f64::NAN, 1.0, 2.0], 0.5), 2.0);
        assert_eq!(quantile([3.0, 1.0, 2.0], 1.0), 3.0);
        assert_eq!(quantile([], 0.5), 0.0);
    }
}
