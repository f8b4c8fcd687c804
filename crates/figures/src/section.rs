//! A surveyed section of an intrados: its points on the fitted curve, and how far each lies from it.

use crate::chart::{Axis, Panel, PanelPoint};
use crate::elevation::{INK, scale_bar};
use crate::geometry::Extent;
use crate::sheet::{MEDIUM, Pen, Sheet, Spot};
use crate::ticks::Ticks;
use outcome::section::{Section, Surveyed};

/// Tallest drawing of the section.
const TALLEST: f64 = 330.0;
/// Height of the chart.
const HEIGHT: f64 = 190.0;
const POINT: &str = "#2a6f97";
const LEFT_OUT: &str = "#c02020";

/// The section as SVG.
pub fn section_drawing(name: &str, section: &Section) -> String {
    let kept = section.points.iter().filter(|point| !point.is_left_out).count();
    let second = format!(
        "Smooth curve through {kept} surveyed points: span {:.3} m, rise {:.3} m; points scatter by {:.1} mm",
        section.span(),
        section.rise(),
        1e3 * section.scatter
    );
    let (mut sheet, top) = Sheet::titled("section", name, &second);
    let below = elevation(&mut sheet, section, top);
    let below = deviations(&mut sheet, section, below + 8.0);
    let left_out = section.left_out().count();
    let words = match left_out {
        0 => "No point was left out.".to_owned(),
        1 => "One point (red) was left out: it lies further from the curve than five times the scatter.".to_owned(),
        _ => format!(
            "{left_out} points (red) were left out: they lie further from the curve than five times the scatter. Those beyond the axis are drawn at its edge."
        ),
    };
    let faces = match section.faces.len() {
        0 => "",
        1 => " The face of an abutment (dashed) is no part of the arch.",
        _ => " The faces of the abutments (dashed) are no part of the arch.",
    };
    sheet.end(below, &(words + faces))
}

/// Points on the curve, to scale; returns what is below.
fn elevation(sheet: &mut Sheet, section: &Section, top: f64) -> f64 {
    let faces = || section.faces.iter().map(|face| [[face.x, face.top], [face.foot, face.bottom]]);
    let all = section.drawn.iter().copied().chain(section.points.iter().map(|point| point.at)).chain(faces().flatten());
    let Some(extent) = Extent::of(all) else { return top };
    let (_, view) = crate::elevation::fit(extent, top, TALLEST);
    sheet.open("section");
    let dots = |left_out: bool| {
        let of = section.points.iter().filter(move |point| point.is_left_out == left_out);
        of.map(|point| view.spot(point.at)).collect::<Vec<Spot>>()
    };
    sheet.dots(&dots(false), 1.6, POINT);
    sheet.polyline(&view.spots(&section.drawn), Pen::line(INK, MEDIUM).class("curve"));
    for [top, foot] in faces().map(|face| face.map(|end| view.spot(end))) {
        sheet.line(top, foot, Pen::line(LEFT_OUT, 1.2).dashed("5 3"));
    }
    sheet.dots(&dots(true), 3.0, LEFT_OUT);
    sheet.close();
    let lowest = view.spot([extent.low[0], extent.low[1]])[1];
    scale_bar(sheet, &view, lowest + 14.0)
}

/// Distances from the curve over the distance along the bridge; what lies beyond the axis is drawn at its edge.
fn deviations(sheet: &mut Sheet, section: &Section, top: f64) -> f64 {
    let kept = || section.points.iter().filter(|point| !point.is_left_out);
    let largest = kept().map(|point| 1e3 * point.deviation.abs()).fold(1.0, f64::max);
    let places = || section.points.iter().map(|point| point.at[0]);
    let [low, high] = [places().fold(f64::INFINITY, f64::min), places().fold(f64::NEG_INFINITY, f64::max)];
    let x = Axis::exact("along the bridge, as surveyed [m]", low, high, 8);
    let y = Axis::round("from the curve, outwards [mm]", Ticks::over(-1.15 * largest, 1.15 * largest, 6));
    let [lowest, highest] = y.range;
    let place = |point: &Surveyed| [point.at[0], (1e3 * point.deviation).clamp(lowest, highest)];
    let mut panel = Panel::new(x, y);
    panel.open("deviations");
    panel.level(0.0, Pen::line(INK, 1.2));
    for (left_out, radius, colour) in [(false, 1.8, POINT), (true, 3.4, LEFT_OUT)] {
        let points = section.points.iter().filter(|point| point.is_left_out == left_out);
        let places: Vec<PanelPoint> = points.map(place).collect();
        panel.add(move |sheet, axes| sheet.dots(&axes.spots(&places), radius, colour));
    }
    panel.close();
    panel.whole(sheet, [top, HEIGHT], panel.y.widest(), true)
}
