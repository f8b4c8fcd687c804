//! Many small marks of one kind, written short: a run has thousands of particles and twice as many contacts.

use super::{Pen, Sheet, Spot, number};
use std::fmt::Write as _;

impl Sheet {
    /// Like [`Sheet::open`], with a pen for all that follows.
    pub(crate) fn open_drawn(&mut self, class: &str, pen: Pen) {
        let _ = write!(self.body, "<g class=\"{class}\"");
        Pen { class: "", ..pen }.write(&mut self.body);
        self.body.push_str(">\n");
    }
    /// A disc that takes its outline from the group that it is in.
    pub(crate) fn disc(&mut self, at: Spot, radius: f64, fill: &str) {
        if at.iter().all(|c| c.is_finite()) && radius.is_finite() {
            let (x, y, r) = (number(at[0]), number(at[1]), number(radius));
            let _ = writeln!(self.body, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\" fill=\"{fill}\"/>");
        }
    }
    /// Discs of one radius and one colour as one path: dots of a round pen, a quarter of the size of circles.
    pub(crate) fn dots(&mut self, spots: &[Spot], radius: f64, colour: &str) {
        // Not every viewer draws a line without length.
        let path = path(spots.iter().map(std::slice::from_ref), "", "h.01");
        if let Some(path) = path.filter(|_| radius.is_finite()) {
            let width = number(2.0 * radius);
            let _ = writeln!(
                self.body,
                "<path d=\"{path}\" stroke=\"{colour}\" stroke-width=\"{width}\" stroke-linecap=\"round\"/>"
            );
        }
    }
    /// Lines of one width in the colour of the group that they are in, as one path.
    pub(crate) fn strokes(&mut self, lines: &[[Spot; 2]], width: f64) {
        if let Some(path) = path(lines.iter().map(|line| &line[..]), "L", "") {
            let _ = writeln!(self.body, "<path d=\"{path}\" stroke-width=\"{}\"/>", number(width));
        }
    }
    /// Quadrilaterals of one colour as one path; a hair of the same colour closes the seams between neighbours.
    pub(crate) fn areas(&mut self, quads: &[[Spot; 4]], colour: &str) {
        if let Some(path) = path(quads.iter().map(|quad| &quad[..]), "L", "Z") {
            let _ =
                writeln!(self.body, "<path d=\"{path}\" fill=\"{colour}\" stroke=\"{colour}\" stroke-width=\"0.3\"/>");
        }
    }
    /// Closed chains of points as one path; chains with a coordinate that is not finite are left out.
    pub(crate) fn loops(&mut self, loops: &[Vec<Spot>], pen: Pen) {
        let chains = loops.iter().filter(|chain| chain.len() > 2);
        if let Some(path) = path(chains.map(Vec::as_slice), " ", "Z") {
            let _ = write!(self.body, "<path d=\"{path}\"");
            pen.write(&mut self.body);
            self.body.push_str(" stroke-linejoin=\"round\"/>\n");
        }
    }
}

/// Chains of points as the data of a path, with something between points and behind each chain; chains with a coordinate that is not
/// finite are left out.
fn path<'s>(chains: impl Iterator<Item = &'s [Spot]>, between: &str, behind: &str) -> Option<String> {
    let mut path = String::new();
    for chain in chains.filter(|chain| chain.iter().flatten().all(|c| c.is_finite())) {
        for (k, spot) in chain.iter().enumerate() {
            let _ = write!(path, "{}{} {}", if k == 0 { "M" } else { between }, number(spot[0]), number(spot[1]));
        }
        path.push_str(behind);
    }
    (!path.is_empty()).then_some(path)
}
