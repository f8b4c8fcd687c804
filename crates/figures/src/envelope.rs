//! Collapse load over the position of a moving load.

use crate::chart::{Axes, Axis, Entry, Mark, key};
use crate::elevation::INK;
use crate::sheet::place::Room;
use crate::sheet::{Pen, Sheet, Spot, Style};
use crate::ticks::Ticks;
use crate::words;

/// What the vertical axis of an envelope is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ordinate {
    /// Collapse load over the load as described.
    Factor,
    /// Adequacy factor of a vehicle under a rule.
    Adequacy,
    /// Collapse load [N/m].
    Load,
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
const HEIGHT: f64 = 340.0;
const X_NAME: &str = "position of the reference point along the bridge [m]";
const FIRST_AXLE: &str = "position of the first axle along the bridge [m]";

/// The curves, with the least value of all marked as governing, and a note below them. None without a finite point.
pub fn envelope(title: &str, quantity: Ordinate, sweeps: &[Sweep], note: Option<&str>) -> Option<String> {
    let unit = |v: f64| if quantity == Ordinate::Load { v / 1e3 } else { v };
    let finite = |&(x, v): &(f64, f64)| x.is_finite() && v.is_finite();
    let points = || sweeps.iter().flat_map(|s| s.points.iter().copied()).filter(finite);
    let governing = points().min_by(|a, b| a.1.total_cmp(&b.1).then(a.0.total_cmp(&b.0)))?;
    // Far from the middle of a span factors grow without bound; the axis ends where they no longer matter.
    let (low_x, high_x) = points().fold((f64::INFINITY, f64::NEG_INFINITY), |r, p| (r.0.min(p.0), r.1.max(p.0)));
    let largest = points().map(|p| p.1).fold(0.0_f64, f64::max);
    let ceiling = largest.min(3.5 * governing.1.abs().max(1e-300));
    let y = Ticks::over(unit(governing.1.min(0.0)), unit(ceiling), 6);

    let mut sheet = Sheet::new("envelope");
    let second = match quantity {
        Ordinate::Factor => "Load factor at collapse over the position of the load",
        Ordinate::Adequacy => "Adequacy factor over the position of the vehicle, worst axles at each",
        Ordinate::Load => "Collapse load over the position of the load",
    };
    let top = sheet.title(title, second);
    let y_name = match quantity {
        Ordinate::Factor => "load factor at collapse [–]",
        Ordinate::Adequacy => "adequacy factor [–]",
        Ordinate::Load => "collapse load [kN/m]",
    };
    let (axes, mut bottom) = Axes::draw(
        &mut sheet,
        top,
        HEIGHT,
        &Axis::exact(if quantity == Ordinate::Adequacy { FIRST_AXLE } else { X_NAME }, low_x, high_x, 8),
        &Axis::round(y_name, y),
    );
    sheet.open_clipped("curves", "plane", axes.area);
    for (k, sweep) in sweeps.iter().enumerate() {
        let (colour, dashes) = STYLES[k % STYLES.len()];
        let mut run: Vec<Spot> = Vec::new();
        for point in sweep.points.iter().chain(std::iter::once(&(f64::NAN, f64::NAN))) {
            if finite(point) {
                run.push(axes.spot(point.0, unit(point.1)));
                continue;
            }
            sheet.avoid_line(&run);
            sheet.polyline(&run, Pen::line(colour, 1.8).dashed(dashes).class("sweep"));
            if let [alone] = run[..] {
                sheet.circle(alone, 1.6, Pen::shape(colour, "none", 0.0));
            }
            run.clear();
        }
    }
    sheet.close();

    let at = axes.spot(governing.0, unit(governing.1));
    sheet.line(at, [at[0], axes.area.bottom], Pen::line(INK, 0.9).dashed("5 4").class("governing"));
    sheet.avoid_line(&[at, [at[0], axes.area.bottom]]);
    Mark::Full.draw(&mut sheet, at, INK);
    let size = match quantity {
        Ordinate::Factor | Ordinate::Adequacy => words::four_digits(governing.1),
        Ordinate::Load => words::force(governing.1),
    };
    let room = Room { area: axes.area.grown(-5.0), towards: [0.5, 0.8], clear: 10.0 };
    let text = format!("governing: {size} at {}", words::metres(governing.0));
    sheet.label(at, &text, Style::on_drawing(), room);

    let entries: Vec<Entry> = sweeps
        .iter()
        .enumerate()
        .filter(|(_, s)| !s.label.is_empty())
        .map(|(k, s)| Entry { line: Some(STYLES[k % STYLES.len()]), mark: None, text: &s.label })
        .collect();
    if !entries.is_empty() {
        bottom = key(&mut sheet, bottom, &entries);
    }
    if let Some(note) = note {
        bottom = sheet.caption(bottom, note);
    }
    Some(sheet.finish(bottom))
}
