//! Principal stresses in the fill beside the line of thrust: how the fill spreads a load, and where the ring carries it.

use super::of;
use crate::bar::quantile;
use crate::elevation::{self as draw, INK, Sign, TENSION};
use crate::geometry::{View, as_built, round_down};
use crate::sheet::{HAIR, MARGIN, MEDIUM, Pen, Sheet, Spot, Style, THIN};
use crate::thrust;
use crate::{soil, words};
use outcome::picture::{Picture, Point};
use outcome::soil::SoilPicture;
use std::collections::BTreeMap;

/// Side of the squares over which stresses are averaged, on the sheet; each has one cross.
const CELL: f64 = 12.0;
/// Places along a side of a square at which its stress is taken.
const PLACES: i64 = 3;
/// Length of a stroke on the sheet that all but a share of the stresses stay below, and of the longest stroke at most.
const USUAL: f64 = 0.95 * CELL;
const RARE: f64 = 0.05;
const LONGEST: f64 = 40.0;
/// Strokes shorter than this are not drawn.
const SHORTEST: f64 = 0.8;

/// Mean of the stresses at the corners of a triangle.
pub(crate) fn mean(corners: &[[f64; 3]; 3]) -> [f64; 3] {
    [0, 1, 2].map(|c| corners.iter().map(|s| s[c]).sum::<f64>() / 3.0)
}

/// A stress on the sheet.
struct Cross {
    at: Spot,
    /// The principal stresses [Pa], tension positive, each with its direction on the sheet.
    principal: [(f64, Spot); 2],
}

impl Cross {
    /// The larger principal stress [Pa], without its sign.
    fn size(&self) -> f64 {
        self.principal[0].0.abs().max(self.principal[1].0.abs())
    }
}

/// Crosses along the principal stresses that carry the lower bound, with the line of thrust and the loads. None without stresses of
/// soil.
pub fn soil_stress(picture: &Picture) -> Option<String> {
    let soil = of(picture).filter(|soil| soil.stresses.len() == soil.triangles.len())?;
    let built = as_built(&picture.shapes)?;
    let second = match picture.thrust_lines.is_empty() {
        true => "Principal stresses in the fill at the lower bound of the load",
        false => "Principal stresses in the fill and line of thrust at the lower bound of the load",
    };
    let (mut sheet, top) = draw::heading("soil-stress", picture, second);
    let extent = soil::around(draw::extent(picture).unwrap_or(built), picture, 0.0);
    let (frame, view) = draw::fit(extent, top + soil::above(picture), draw::TALLEST);
    let [[left, _], [right, _]] = [view.spot(extent.low), view.spot(extent.high)];
    let mut crosses = crosses(soil, &view);
    crosses.retain(|c| left < c.at[0] && c.at[0] < right);
    let largest = crosses.iter().map(Cross::size).filter(|s| s.is_finite()).fold(0.0, f64::max);
    let scale = scale(quantile(crosses.iter().map(Cross::size), 1.0 - RARE), largest);

    soil::open(&mut sheet, &view, extent);
    soil::pale(&mut sheet, &view, picture, 0.0);
    strokes(&mut sheet, &crosses, scale);
    sheet.close();
    draw::blocks(&mut sheet, &view, &picture.shapes, |k| picture.shapes[k].outline.clone());
    draw::load_arrows(&mut sheet, &view, picture, None);
    soil::plates(&mut sheet, &view, picture, 0.0);
    thrust::lines(&mut sheet, &view, picture);

    let mut y = draw::scale_bar(&mut sheet, &view, frame.bottom + 10.0);
    let pulls = crosses.iter().flat_map(|c| c.principal).any(|p| p.0 > 0.0 && length(p.0, scale) >= SHORTEST);
    let entries = [
        (Sign::Compression, "compression", true),
        (Sign::Tension, "tension", pulls),
        (Sign::Thrust, "line of thrust", !picture.thrust_lines.is_empty()),
        (Sign::Load, "load", soil::any_load(picture)),
    ];
    y = draw::key(&mut sheet, y + 2.0, &entries);
    y = lengths(&mut sheet, y + 2.0, largest, scale);
    let side = words::metres(CELL / view.scale);
    let caption = format!(
        "Each cross stands for the mean stress of a square of {side}. The length of a stroke grows with the square root of the stress; the larger compression is the thicker stroke. Largest stress of a square: {} kPa.",
        words::three_digits(largest / 1e3)
    );
    Some(sheet.end(y + 2.0, &caption))
}

/// Length of a stroke on the sheet over the root of its stress [Pa].
fn scale(usual: f64, largest: f64) -> f64 {
    let of = |length: f64, stress: f64| if stress > 0.0 { length / stress.sqrt() } else { f64::INFINITY };
    let scale = of(USUAL, usual).min(of(LONGEST, largest));
    if scale.is_finite() { scale } else { 0.0 }
}

/// Length of the stroke of a stress on the sheet.
fn length(stress: f64, scale: f64) -> f64 {
    scale * stress.abs().sqrt()
}

/// A cross for each square that soil fills by a half or more.
fn crosses(soil: &SoilPicture, view: &View) -> Vec<Cross> {
    let step = CELL / PLACES as f64;
    // Sum of stresses and places, by square; corners of soil and sheet lie anywhere, squares at whole numbers.
    let mut cells: BTreeMap<(i64, i64), ([f64; 3], f64, Spot)> = BTreeMap::new();
    for (corners, stresses) in soil.triangles.iter().zip(&soil.stresses) {
        let spots = corners.map(|k| view.spot(soil.points[k]));
        let bounds = [0, 1].map(|c| {
            let low = spots.iter().map(|s| s[c]).fold(f64::INFINITY, f64::min);
            let high = spots.iter().map(|s| s[c]).fold(f64::NEG_INFINITY, f64::max);
            // Whole numbers of places, half a step off the lines between squares; none where a corner is not finite.
            [(low / step - 0.5).ceil() as i64, (high / step - 0.5).floor() as i64]
        });
        if spots.iter().flatten().any(|c| !c.is_finite() || c.abs() > 1e5) {
            continue;
        }
        for j in bounds[1][0]..=bounds[1][1] {
            for i in bounds[0][0]..=bounds[0][1] {
                let at = [(i as f64 + 0.5) * step, (j as f64 + 0.5) * step];
                let Some(shares) = shares(spots, at) else { continue };
                let here = cells.entry((i.div_euclid(PLACES), j.div_euclid(PLACES))).or_default();
                (0..3).for_each(|c| here.0[c] += (0..3).map(|k| shares[k] * stresses[k][c]).sum::<f64>());
                here.1 += 1.0;
                (0..2).for_each(|c| here.2[c] += at[c]);
            }
        }
    }
    let full = 0.5 * (PLACES * PLACES) as f64;
    let filled = cells.into_values().filter(|(sum, places, _)| *places > full && sum.iter().all(|s| s.is_finite()));
    let cross = |(sum, places, at): ([f64; 3], f64, Spot)| Cross {
        at: at.map(|c| c / places),
        principal: principal(sum.map(|s| s / places)),
    };
    filled.map(cross).collect()
}

/// How much each corner of a triangle counts at a point; none outside.
fn shares([a, b, c]: [Spot; 3], p: Spot) -> Option<[f64; 3]> {
    let cross = |o: Spot, u: Spot, v: Spot| (u[0] - o[0]) * (v[1] - o[1]) - (u[1] - o[1]) * (v[0] - o[0]);
    let whole = cross(a, b, c);
    let shares = [cross(p, b, c) / whole, cross(p, c, a) / whole, cross(p, a, b) / whole];
    // A point on a side belongs to both triangles beside it, which does no harm to a mean.
    shares.iter().all(|s| *s >= 0.0).then_some(shares)
}

/// The most compressive principal stress first [Pa], tension positive, with directions on the sheet.
fn principal([xx, yy, xy]: [f64; 3]) -> [(f64, Point); 2] {
    let (mean, radius) = (0.5 * (xx + yy), (0.5 * (xx - yy)).hypot(xy));
    // Of the least compressive one; on the sheet y runs down.
    let (sin, cos) = (0.5 * (2.0 * xy).atan2(xx - yy)).sin_cos();
    [(mean - radius, [-sin, -cos]), (mean + radius, [cos, -sin])]
}

/// All crosses: compression plain and the larger one thicker, tension with a short bar at both ends.
fn strokes(sheet: &mut Sheet, crosses: &[Cross], scale: f64) {
    let (mut presses, mut pulls) = ([Vec::new(), Vec::new()], Vec::new());
    for cross in crosses {
        for (rank, (stress, way)) in cross.principal.into_iter().enumerate() {
            let half = 0.5 * length(stress, scale);
            if 2.0 * half < SHORTEST {
                continue;
            }
            let end = |side: f64| [cross.at[0] + side * half * way[0], cross.at[1] + side * half * way[1]];
            if stress <= 0.0 {
                presses[rank].push([end(-1.0), end(1.0)]);
                continue;
            }
            pulls.push([end(-1.0), end(1.0)]);
            for [x, y] in [end(-1.0), end(1.0)] {
                pulls.push([[x - 1.6 * way[1], y + 1.6 * way[0]], [x + 1.6 * way[1], y - 1.6 * way[0]]]);
            }
        }
    }
    sheet.open_drawn("compression", Pen::line(INK, THIN));
    sheet.strokes(&presses[0], 0.9);
    sheet.strokes(&presses[1], HAIR);
    sheet.close();
    sheet.open_drawn("tension", Pen::line(TENSION, THIN));
    sheet.strokes(&pulls, THIN);
    sheet.close();
}

/// Strokes of round stresses; returns the y below.
fn lengths(sheet: &mut Sheet, top: f64, largest: f64, scale: f64) -> f64 {
    let style = Style::small();
    let most = round_down(largest / 1e3);
    let (mut x, y) = (MARGIN, top + 12.0);
    sheet.open("lengths");
    for part in [0.01, 0.1, 1.0] {
        let long = length(1e3 * part * most, scale);
        if long < SHORTEST {
            continue;
        }
        sheet.line([x, y - 4.0], [x + long, y - 4.0], Pen::line(INK, MEDIUM).class("length"));
        let text = format!("{} kPa", words::four_digits(part * most));
        sheet.text([x + long + 6.0, y], &text, style);
        x += long + style.width(&text) + 26.0;
    }
    sheet.close();
    y + 6.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn principal_stresses_stand_along_their_directions() {
        // Upright compression of 5, level one of 1.
        let [(most, way), (least, other)] = principal([-1.0, -5.0, 0.0]);
        assert_eq!((most, least), (-5.0, -1.0));
        assert!(way[0].abs() < 1e-12 && (way[1].abs() - 1.0).abs() < 1e-12 && other[1].abs() < 1e-12);
        // Pure shear pulls along the rising diagonal, which runs up the sheet as y falls.
        let [(most, way), (least, pull)] = principal([0.0, 0.0, 2.0]);
        assert!((most + 2.0).abs() < 1e-12 && (least - 2.0).abs() < 1e-12);
        assert!(pull[0] * pull[1] < -0.49 && way[0] * way[1] > 0.49, "{pull:?} {way:?}");
    }

    #[test]
    fn usual_strokes_fit_their_square_and_none_is_too_long() {
        assert!((length(4e4, scale(4e4, 5e4)) - USUAL).abs() < 1e-12);
        assert!((length(4e6, scale(1e4, 4e6)) - LONGEST).abs() < 1e-12);
        assert_eq!(scale(0.0, 0.0), 0.0);
    }

    #[test]
    fn shares_are_those_of_the_corners() {
        let corners = [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
        assert_eq!(shares(corners, [0.5, 0.5]), Some([0.5, 0.25, 0.25]));
        assert_eq!(shares(corners, [2.0, 2.0]), None);
        assert_eq!(shares([[1.0, 1.0]; 3], [1.0, 1.0]), None);
    }
}
