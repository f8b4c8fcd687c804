//! Colour bars: what a colour stands for.

use crate::chart::Axis;
use crate::elevation::INK;
use crate::sheet::{Anchor, Area, HAIR, Pen, Sheet, Style};
use crate::ticks::Ticks;

/// A scale of colours with its values.
pub(crate) struct Scale<'a> {
    /// What it measures with its unit, from where to where, and the values along it.
    pub axis: Axis<'a>,
    /// Colour of a share from 0 to 1.
    pub colour: fn(f64) -> String,
    /// Whether values above its end are drawn in the colour of its end.
    pub cut: bool,
}

impl<'a> Scale<'a> {
    /// From zero to `end`, or beyond it to a round number; cut where `largest` lies beyond that.
    pub(crate) fn upto(name: &'a str, [end, largest]: [f64; 2], steps: usize, colour: fn(f64) -> String) -> Scale<'a> {
        let axis = Axis::round(name, Ticks::over(0.0, if end > 0.0 { end } else { 1.0 }, steps));
        let cut = largest > axis.range[1];
        Scale { axis, colour, cut }
    }

    /// The colour of a value.
    pub(crate) fn of(&self, value: f64) -> String {
        (self.colour)(self.axis.share(value))
    }

    /// Draws the bar under its title; returns the y below.
    pub(crate) fn draw(&self, sheet: &mut Sheet, left: f64, right: f64, top: f64) -> f64 {
        const STEPS: usize = 96;
        let style = Style::small();
        let y = sheet.paragraph(left, top, right - left + 10.0, self.axis.name, style);
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
        for &value in &self.axis.ticks.values {
            let x = at(self.axis.share(value));
            sheet.line([x, lower], [x, lower + 4.0], Pen::line(INK, 0.9));
            sheet.text([x, lower + 17.0], &self.axis.words(value), style.anchored(Anchor::Middle));
        }
        sheet.close();
        lower + 24.0
    }
}

/// The value below which a share of the finite values lies; zero without any.
pub(crate) fn quantile(values: impl IntoIterator<Item = f64>, share: f64) -> f64 {
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
