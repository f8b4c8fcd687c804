//! Pressure of the fill on the backs of blocks.

use super::of;
use crate::elevation::{self as draw, INK, PRESSURE, Sign};
use crate::geometry::{Extent, View, as_built, round_down};
use crate::sheet::place::Room;
use crate::sheet::{HAIR, MARGIN, MEDIUM, Pen, SMALL, Sheet, Spot, Style, THIN, font};
use crate::{soil, words};
use outcome::picture::{Picture, Point};
use outcome::soil::SoilPressure;

/// Share of the larger dimension of the bridge that the largest pressure is drawn with.
const SHARE: f64 = 0.1;
/// Length of the arrow of the largest shear stress on the sheet, and least way from one arrow to the next.
const ARROW: f64 = 15.0;
const APART: f64 = 17.0;
/// Distance of arrows from the back, into the blocks.
const BELOW: f64 = 5.0;
/// Shear below this share of the largest has no arrow.
const LEAST: f64 = 0.15;

/// Pressure as a band normal to the backs of the blocks, shear as arrows along them. None without pressures.
pub fn soil_pressure(picture: &Picture) -> Option<String> {
    let soil = of(picture)?;
    let sides: Vec<&SoilPressure> = soil.pressures.iter().filter(drawable).collect();
    let greatest = |values: &dyn Fn(&SoilPressure) -> [f64; 2]| {
        sides.iter().flat_map(|p| values(p)).map(f64::abs).fold(0.0, f64::max)
    };
    let (largest, shear) = (greatest(&|p| p.pressure), greatest(&|p| p.shear));
    let built = as_built(&picture.shapes).filter(|_| largest > 0.0)?;
    // Metres of the drawing for a pascal.
    let scale = SHARE * built.size()[0].max(built.size()[1]) / largest;

    let second = "Pressure of the fill on the blocks at the lower bound of the load";
    let (mut sheet, top) = draw::heading("soil-pressure", picture, second);
    let extent = soil::around(draw::extent(picture).unwrap_or(built), picture, 0.0);
    let tips = Extent::of(sides.iter().flat_map(|p| band(p, scale)));
    let extent = tips.map_or(extent, |e| extent.with(e));
    let (frame, view) = draw::fit(extent, top + soil::above(picture), draw::TALLEST);
    soil::behind(&mut sheet, &view, extent, picture);
    draw::blocks(&mut sheet, &view, &picture.shapes, |k| picture.shapes[k].outline.clone());
    draw::avoid_blocks(&mut sheet, &view, &picture.shapes, |k| picture.shapes[k].outline.clone());
    bands(&mut sheet, &view, &sides, scale);
    arrows(&mut sheet, &view, &sides);
    draw::load_arrows(&mut sheet, &view, picture, None);
    soil::plates(&mut sheet, &view, picture, 0.0);
    name_largest(&mut sheet, &view, &sides, scale, Room::between(top, frame.bottom + 20.0));

    let mut y = draw::scale_bar(&mut sheet, &view, frame.bottom + 26.0);
    let entries = [
        (Sign::Pressure, "pressure, normal to the back", true),
        (Sign::Shear, "shear stress on the blocks", shear > 0.0),
        (Sign::Load, "load", soil::any_load(picture)),
    ];
    y = draw::key(&mut sheet, y + 2.0, &entries);
    let round = round_down(largest / 1e3);
    y = scales(&mut sheet, y + 2.0, round, 1e3 * round * scale * view.scale);
    let mut caption = format!("Largest pressure: {} kPa.", words::three_digits(largest / 1e3));
    if shear > 0.0 {
        caption += &format!(
            " Largest shear stress: {} kPa. Its arrows stand in the blocks on which it acts; their length grows with the stress.",
            words::three_digits(shear / 1e3)
        );
    }
    Some(sheet.end(y + 2.0, &caption))
}

fn drawable(p: &&SoilPressure) -> bool {
    let numbers = p.ends.iter().flatten().chain(&p.pressure).chain(&p.shear);
    numbers.copied().all(f64::is_finite) && p.ends[0] != p.ends[1]
}

/// Unit vectors along a stretch and towards the soil, which lies on its left.
fn frame_of(p: &SoilPressure) -> [Point; 2] {
    let way = [p.ends[1][0] - p.ends[0][0], p.ends[1][1] - p.ends[0][1]];
    let length = way[0].hypot(way[1]);
    let along = way.map(|c| c / length);
    [along, [-along[1], along[0]]]
}

/// Corners of the band of one stretch: its ends, and the tips of the pressure above them.
fn band(p: &SoilPressure, scale: f64) -> [Point; 4] {
    let [_, out] = frame_of(p);
    let tip = |k: usize| [0, 1].map(|c| p.ends[k][c] + scale * p.pressure[k] * out[c]);
    [p.ends[0], p.ends[1], tip(1), tip(0)]
}

/// Whether a stretch begins where another ends.
fn follows(before: &SoilPressure, p: &SoilPressure) -> bool {
    (0..2).all(|c| (before.ends[1][c] - p.ends[0][c]).abs() < 1e-6)
}

/// The pressures as one area, with a line along their tips.
fn bands(sheet: &mut Sheet, view: &View, sides: &[&SoilPressure], scale: f64) {
    let quads: Vec<[Spot; 4]> = sides.iter().map(|p| band(p, scale).map(|c| view.spot(c))).collect();
    let (mut areas, mut lines) = (quads.clone(), Vec::new());
    for (k, quad) in quads.iter().enumerate() {
        let [start, end, tip_of_end, tip_of_start] = *quad;
        // From the tip of what is before, or from the back where a row of stretches begins.
        match k.checked_sub(1).filter(|&j| follows(sides[j], sides[k])) {
            Some(before) => {
                let tip = quads[before][2];
                areas.push([start, tip_of_start, tip, start]);
                lines.push([tip, tip_of_start]);
            }
            None => lines.push([start, tip_of_start]),
        }
        lines.push([tip_of_start, tip_of_end]);
        if sides.get(k + 1).is_none_or(|next| !follows(sides[k], next)) {
            lines.push([tip_of_end, end]);
        }
    }
    sheet.open("pressure");
    sheet.areas(&areas, PRESSURE[0]);
    sheet.close();
    sheet.open_drawn("pressure-line", Pen::line(PRESSURE[1], THIN));
    sheet.strokes(&lines, THIN);
    sheet.close();
}

/// Arrows of the mean shear stress over stretches in a row.
fn arrows(sheet: &mut Sheet, view: &View, sides: &[&SoilPressure]) {
    let mut found: Vec<(f64, Point, Point)> = Vec::new();
    let mut run: Vec<&SoilPressure> = Vec::new();
    for (k, side) in sides.iter().enumerate() {
        run.push(side);
        let turns = sides.get(k + 1).is_none_or(|next| {
            let ([a, _], [b, _]) = (frame_of(side), frame_of(next));
            !follows(side, next) || a[0] * b[0] + a[1] * b[1] < 0.8
        });
        let whole: f64 = run.iter().map(|p| length(p)).sum();
        if !turns && whole * view.scale < APART {
            continue;
        }
        let mean = |value: &dyn Fn(&SoilPressure) -> f64| run.iter().map(|p| length(p) * value(p)).sum::<f64>() / whole;
        let stress = mean(&|p| 0.5 * (p.shear[0] + p.shear[1]));
        let middle = [0, 1].map(|c| mean(&|p| 0.5 * (p.ends[0][c] + p.ends[1][c])));
        found.push((stress, middle, [0, 1].map(|c| mean(&|p| frame_of(p)[0][c]))));
        run.clear();
    }
    let largest = found.iter().map(|f| f.0.abs()).fold(0.0, f64::max);
    sheet.open("shear");
    for (stress, middle, along) in found.into_iter().filter(|f| f.0.abs() > LEAST * largest) {
        let size = along[0].hypot(along[1]);
        let (at, way) = (view.spot(middle), [along[0] / size, -along[1] / size]);
        // Into the blocks: to the right of the way, and y runs down.
        let at = [at[0] - BELOW * way[1], at[1] + BELOW * way[0]];
        let half = 0.5 * ARROW * stress / largest;
        let end = |side: f64| [at[0] + side * half * way[0], at[1] + side * half * way[1]];
        sheet.arrow(end(-1.0), end(1.0), Pen::line(INK, THIN).class("shear"));
    }
    sheet.close();
}

fn length(p: &SoilPressure) -> f64 {
    (p.ends[1][0] - p.ends[0][0]).hypot(p.ends[1][1] - p.ends[0][1])
}

/// Names the largest pressure at its tip.
fn name_largest(sheet: &mut Sheet, view: &View, sides: &[&SoilPressure], scale: f64, room: Room) {
    let ends = sides.iter().flat_map(|p| [0, 1].map(|k| (p.pressure[k], band(p, scale)[3 - k], frame_of(p)[1])));
    let Some((value, tip, out)) = ends.max_by(|a, b| a.0.abs().total_cmp(&b.0.abs())) else { return };
    let at = view.spot(tip);
    sheet.circle(at, 2.0, Pen::shape("white", PRESSURE[1], MEDIUM).class("largest"));
    let text = format!("{} kPa", words::three_digits(value / 1e3));
    sheet.label(at, &text, Style::on_drawing(), room.towards([out[0], -out[1]]));
}

/// How high a round pressure is drawn; returns the y below.
fn scales(sheet: &mut Sheet, top: f64, kilopascals: f64, height: f64) -> f64 {
    let style = Style::small();
    let (left, y) = (MARGIN + 4.0, top + height + 8.0);
    sheet.open("pressure-scale");
    sheet.line([left, y], [left, y - height], Pen::line(PRESSURE[1], MEDIUM).class("pressure-bar"));
    for end in [y, y - height] {
        sheet.line([left - 4.0, end], [left + 4.0, end], Pen::line(INK, HAIR));
    }
    let text = format!("{} kPa", words::four_digits(kilopascals));
    sheet.text([left + 10.0, y - 0.5 * height + 0.5 * font::CAPITAL * SMALL], &text, style);
    sheet.close();
    y + 6.0
}
