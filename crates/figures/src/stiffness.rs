//! Load over the stiffness of the joints, with that of rigid blocks as its asymptote.

use crate::chart::{Axis, Chart, Entry, Mark, Panel, PanelPoint};
use crate::elevation::INK;
use crate::sheet::Pen;
use crate::ticks::Ticks;
use crate::words;
use outcome::picture::Picture;

const CURVE: &str = "#0b5394";
const RIGID: &str = "#a02020";

/// The largest load in balance over the stiffness of the joints, that of the result marked, and the load of rigid blocks. Nothing
/// where only one stiffness was tried.
pub(crate) fn over_stiffness(picture: &Picture) -> Option<String> {
    let over = picture.over_stiffness.as_ref().filter(|over| over.points.len() > 1)?;
    let [first, last] = [over.points.first()?[0], over.points.last()?[0]];
    let most = over.points.iter().map(|point| point[1]).fold(over.rigid, f64::max) / 1e3;
    let x = Axis::logarithmic("stiffness of the joints, as a multiple of that of this result [–]", first, last);
    let mut panel = Panel::new(x, Axis::round("load [kN/m]", Ticks::over(0.0, 1.04 * most, 6)));
    panel.curve(
        [first, last].map(|times| [times, over.rigid / 1e3]),
        Pen::line(RIGID, 1.4).dashed("9 4").class("rigid"),
    );
    let places: Vec<PanelPoint> = over.points.iter().map(|[times, load]| [*times, load / 1e3]).collect();
    panel.curve(&places[..], Pen::line(CURVE, 1.8).class("curve"));
    for (place, [times, load]) in places.into_iter().zip(&over.points) {
        let own = *times == 1.0;
        panel.mark(place, Mark::Full, if own { INK } else { CURVE });
        if own {
            panel.label(place, format!("this result: {}", words::force(*load)), [0.7, 0.7], 11.0);
        }
    }
    let mut chart = Chart::of(panel, 300.0);
    chart.key = vec![
        Entry::line((CURVE, ""), "deformable joints").marked(Mark::Full, CURVE),
        Entry::line((RIGID, "9 4"), format!("rigid blocks: {}", words::force(over.rigid))),
    ];
    Some(chart.draw("stiffness", &picture.title, "Largest load in balance over the stiffness of the joints"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use outcome::picture::OverStiffness;

    #[test]
    fn the_result_is_marked_among_other_stiffnesses_below_the_rigid_load() {
        let points = vec![[0.1, 60e3], [1.0, 132e3], [10.0, 182e3], [100.0, 209e3]];
        let mut picture =
            Picture { over_stiffness: Some(OverStiffness { points, rigid: 231e3 }), ..Picture::default() };
        let svg = over_stiffness(&picture).unwrap();
        assert!(svg.contains("this result: 132") && svg.contains("rigid blocks: 231"), "{svg}");
        assert_eq!(svg.matches("class=\"rigid\"").count(), 1);
        picture.over_stiffness.as_mut().unwrap().points.truncate(1);
        assert_eq!(over_stiffness(&picture), None);
    }
}
