//! Collapse load over the position of a moving load.

use crate::chart::{Axis, Chart, Entry, Mark, Panel, PanelPoint, runs};
use crate::elevation::INK;
use crate::sheet::Pen;
use crate::ticks::Ticks;
use crate::words;

/// What the vertical axis of an envelope is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ordinate {
    /// Collapse load over the load as described.
    Factor,
    /// Adequacy factor of a vehicle under a rule.
    Adequacy,
}

/// One curve of an envelope.
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    /// What it is called: a direction, a vehicle.
    pub label: String,
    /// Position of the reference point along the bridge [m] and value there. Positions without a mechanism are not
    /// finite and leave a gap.
    pub points: Vec<(f64, f64)>,
}

/// The load factors of a sweep of a bridge's loads over their position: what every method that was followed gives. None without a
/// finite point.
pub fn sweep_drawing(name: &str, found: &outcome::sweep::Sweep) -> Option<String> {
    type Factor = fn(&outcome::sweep::SweepPoint) -> Option<f64>;
    let factors: &[(&str, Factor)] = match found.is_deformable() {
        _ if found.points.iter().any(|p| p.upper_factor.is_some()) => &[
            ("lower bound", |p| p.load_factor),
            ("upper bound", |p| p.upper_factor),
            ("fill as weight", |p| p.rigid_factor),
        ],
        true => &[("deformable joints", |p| p.deformable_factor), ("rigid blocks", |p| p.rigid_factor)],
        false => &[("load factor", |p| p.load_factor)],
    };
    let curve = |(label, factor): &(&str, Factor)| {
        let points = found.points.iter().map(|point| (point.position, factor(point).unwrap_or(f64::NAN)));
        Sweep { label: (*label).to_owned(), points: points.collect() }
    };
    envelope(name, Ordinate::Factor, &factors.iter().map(curve).collect::<Vec<_>>(), None)
}

/// Line colours and dashes, told apart in grey print by their dashes.
const STYLES: [(&str, &str); 4] = [("#0b5394", ""), ("#a02020", "9 4"), ("#3d3d3d", "2.5 3"), ("#7a6a00", "10 3 2 3")];

/// The curves, with the least value of all marked as governing, and a note below them. None without a finite point.
pub fn envelope(title: &str, quantity: Ordinate, sweeps: &[Sweep], note: Option<&str>) -> Option<String> {
    let (second, x_name, y_name) = match quantity {
        Ordinate::Factor => (
            "Load factor at collapse over the position of the load",
            "position of the reference point along the bridge [m]",
            "load factor at collapse [–]",
        ),
        Ordinate::Adequacy => (
            "Adequacy factor over the position of the vehicle, worst axles at each",
            "position of the first axle along the bridge [m]",
            "adequacy factor [–]",
        ),
    };
    let finite = |&(x, v): &(f64, f64)| x.is_finite() && v.is_finite();
    let points = || sweeps.iter().flat_map(|s| s.points.iter().copied()).filter(finite);
    let governing = points().min_by(|a, b| a.1.total_cmp(&b.1).then(a.0.total_cmp(&b.0)))?;
    // Far from the middle of a span factors grow without bound; the axis ends where they no longer matter.
    let (low_x, high_x) = points().fold((f64::INFINITY, f64::NEG_INFINITY), |r, p| (r.0.min(p.0), r.1.max(p.0)));
    let largest = points().map(|p| p.1).fold(0.0_f64, f64::max);
    let ceiling = largest.min(3.5 * governing.1.abs().max(1e-300));
    let y = Axis::round(y_name, Ticks::over(governing.1.min(0.0), ceiling, 6));

    let mut panel = Panel::new(Axis::exact(x_name, low_x, high_x, 8), y);
    panel.clip("curves", "plane");
    for (k, sweep) in sweeps.iter().enumerate() {
        let (colour, dashes) = STYLES[k % STYLES.len()];
        let places: Vec<PanelPoint> = sweep.points.iter().map(|point| [point.0, point.1]).collect();
        for run in runs(&places) {
            panel.curve(run, Pen::line(colour, 1.8).dashed(dashes).class("sweep"));
            if run.len() == 1 {
                panel.circles(run, 1.6, Pen::shape(colour, "none", 0.0));
            }
        }
    }
    panel.close();
    let at = [governing.0, governing.1];
    panel.curve([at, [at[0], panel.y.range[0]]], Pen::line(INK, 0.9).dashed("5 4").class("governing"));
    panel.mark(at, Mark::Full, INK);
    let size = words::four_digits(governing.1);
    panel.label(at, format!("governing: {size} at {}", words::metres(governing.0)), [0.5, 0.8], 10.0);

    let mut chart = Chart::of(panel, 340.0);
    let styled = sweeps.iter().zip(STYLES.iter().cycle()).filter(|(sweep, _)| !sweep.label.is_empty());
    chart.key = styled.map(|(sweep, style)| Entry::line(*style, &sweep.label)).collect();
    chart.words.extend(note.map(str::to_owned));
    Some(chart.draw("envelope", title, second))
}
