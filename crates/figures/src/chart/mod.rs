//! Charts: panels below one another, what stands in their planes, what its signs mean, and words.

mod axes;
mod heading;
mod key;
mod panel;

pub(crate) use axes::{Axes, Axis, NAME};
pub(crate) use heading::{HEADING, Heading, heading, heading_lines};
pub(crate) use key::{Entry, Key, key};
pub(crate) use panel::{Panel, PanelPoint, ZERO, runs};

use crate::elevation::INK;
use crate::sheet::{MARGIN, MEDIUM, Pen, Sheet, Spot, WIDTH};

/// A chart that draws itself.
#[derive(Default)]
pub(crate) struct Chart<'a> {
    /// From top to bottom.
    pub panels: Vec<Panel<'a>>,
    /// Height of each.
    pub height: f64,
    /// Height of a line of their headings.
    pub heading: f64,
    pub key: Vec<Entry<'a>>,
    /// What is said below, a paragraph each.
    pub words: Vec<String>,
}

impl<'a> Chart<'a> {
    /// Of one panel.
    pub(crate) fn of(panel: Panel<'a>, height: f64) -> Chart<'a> {
        Chart { panels: vec![panel], height, ..Chart::default() }
    }

    /// The drawing of a name under its title and second line.
    pub(crate) fn draw(&self, name: &str, title: &str, second: &str) -> String {
        let (mut sheet, mut y) = Sheet::titled(name, title, second);
        let widest = self.panels.iter().map(|panel| panel.y.widest()).fold(0.0, f64::max);
        let (left, right) = (Axes::left(widest), WIDTH - MARGIN);
        for (place, panel) in self.panels.iter().enumerate() {
            y += self.heading * heading_lines(left, right, &panel.heading);
            heading(&mut sheet, [left, y - 1.0], right, &panel.heading);
            let lowest = place + 1 == self.panels.len();
            y = panel.whole(&mut sheet, [y, self.height], widest, lowest);
        }
        if !self.key.is_empty() {
            y = key(&mut sheet, y, &self.key);
        }
        for words in &self.words {
            y = sheet.caption(y, words);
        }
        sheet.finish(y)
    }
}

/// Marks of points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Mark {
    /// A filled circle.
    Full,
    /// An open circle.
    Hollow,
    /// A larger ring around a mark.
    Ring,
}

impl Mark {
    pub(crate) fn draw(self, sheet: &mut Sheet, at: Spot, colour: &str) {
        match self {
            Mark::Full => sheet.circle(at, 3.6, Pen::shape(colour, colour, MEDIUM).class("point")),
            Mark::Hollow => sheet.circle(at, 3.6, Pen::shape("white", colour, 1.5).class("point hollow")),
            Mark::Ring => sheet.circle(at, 8.0, Pen::line(INK, MEDIUM).class("marked")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ticks::Ticks;

    #[test]
    fn a_chart_draws_every_panel_in_its_order_and_breaks_lines_at_their_gaps() {
        let panel = |name: &str| {
            let mut panel = Panel::new(Axis::exact("x", 0.0, 4.0, 4), Axis::round("y", Ticks::over(0.0, 1.0, 2)));
            panel.heading.0 = name.to_owned();
            let places: Vec<PanelPoint> = (0..5).map(|k| [f64::from(k), if k == 2 { f64::NAN } else { 0.5 }]).collect();
            runs(&places).for_each(|run| panel.curve(run, Pen::line(INK, 1.0).class("run")));
            panel.mark([4.0, 1.0], Mark::Full, INK);
            panel
        };
        let mut chart = Chart { panels: vec![panel("one"), panel("two")], height: 100.0, ..Chart::default() };
        chart.key.push(Entry::mark(Mark::Hollow, INK, "a sign"));
        let svg = chart.draw("try", "Title", "");
        roxmltree::Document::parse(&svg).unwrap();
        assert_eq!(
            ["run", "point", "axes", "key"].map(|class| svg.matches(&format!("class=\"{class}\"")).count()),
            [4, 2, 2, 1]
        );
        assert!(svg.find(">one<") < svg.find(">two<") && svg.find(">two<") < svg.find(">a sign<"), "{svg}");
        // Values below stand below the lowest panel alone.
        assert_eq!(svg.matches(">3<").count(), 1);
    }
}
