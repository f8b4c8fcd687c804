//! Fill that yields as a continuum: its outline behind other drawings, the plates under its loads, and its own figures.

pub(crate) mod mechanism;
pub(crate) mod pressure;
pub(crate) mod stress;

use crate::elevation::{self as draw, INK};
use crate::geometry::{Extent, View};
use crate::sheet::{HAIR, Pen, Sheet, Spot, THICK};
use outcome::picture::{Picture, Point};
use outcome::soil::SoilPicture;
use std::collections::{BTreeMap, BTreeSet};

/// Colour of the fill behind something.
pub(crate) const PALE: &str = "#f3efe4";
/// Lines in and around the fill.
const RIM: &str = "#b9b09c";

/// The soil, where there are triangles whose corners exist.
pub(crate) fn of(picture: &Picture) -> Option<&SoilPicture> {
    let fits = |soil: &&SoilPicture| soil.triangles.iter().flatten().all(|&k| k < soil.points.len());
    picture.soil.as_ref().filter(|soil| !soil.triangles.is_empty()).filter(fits)
}

/// Where a corner is drawn: as built, or moved by the mechanism times `scale` [m].
pub(crate) fn place(soil: &SoilPicture, corner: usize, scale: f64) -> Point {
    let ([x, y], [u, v]) = (soil.points[corner], soil.motions.get(corner).copied().unwrap_or_default());
    [x + scale * u, y + scale * v]
}

/// Ends of a plate, moved by the mechanism times `scale` [m].
fn plate_ends(plate: &outcome::soil::Plate, scale: f64) -> [Point; 2] {
    [0, 1].map(|k| [0, 1].map(|c| plate.ends[k][c] + scale * plate.motions[k][c]))
}

/// How far soil that stands still is drawn beyond the ends of a bridge, as a share of its length.
const BEYOND: f64 = 0.08;
/// Share of the largest motion below which soil stands still.
const STILL: f64 = 0.02;

/// Around a bridge and its soil, as built and moved by the mechanism times `scale`. Soil that stands still far beyond
/// the ends of the bridge is left out.
pub(crate) fn around(extent: Extent, picture: &Picture, scale: f64) -> Extent {
    let Some(soil) = of(picture) else { return extent };
    let reach = BEYOND * extent.size()[0];
    let (least, far) = (STILL * largest_motion(picture), [extent.low[0] - reach, extent.high[0] + reach]);
    let moves = |k: usize| soil.motions.get(k).is_some_and(|u| u[0].hypot(u[1]) > least);
    let near = |k: usize, [x, y]: Point| [if moves(k) { x } else { x.clamp(far[0], far[1]) }, y];
    let corners = (0..soil.points.len()).flat_map(|k| [0.0, scale].map(|scale| near(k, place(soil, k, scale))));
    let plates = soil.plates.iter().flat_map(|p| plate_ends(p, scale));
    Extent::of(corners.chain(plates)).map_or(extent, |e| extent.with(e))
}

/// Begins a group in which soil is drawn no farther than the drawing goes.
pub(crate) fn open(sheet: &mut Sheet, view: &View, extent: Extent) {
    sheet.open_clipped("ground", "ground", view.area(extent).grown(1.0));
}

/// The fill pale behind something, as built.
pub(crate) fn behind(sheet: &mut Sheet, view: &View, extent: Extent, picture: &Picture) {
    if of(picture).is_some() {
        open(sheet, view, extent);
        pale(sheet, view, picture, 0.0);
        sheet.close();
    }
}

/// Largest motion of soil and plates in the mechanism [m]; zero without soil.
pub(crate) fn largest_motion(picture: &Picture) -> f64 {
    let Some(soil) = of(picture) else { return 0.0 };
    let all = soil.motions.iter().chain(soil.plates.iter().flat_map(|p| &p.motions));
    all.map(|u| u[0].hypot(u[1])).filter(|u| u.is_finite()).fold(0.0, f64::max)
}

/// Closed loops around the triangles that are wanted, as corners, with the triangles on their left. Sides that two wanted triangles
/// share are no part of any loop.
pub(crate) fn loops(soil: &SoilPicture, wanted: impl Fn(usize) -> bool) -> Vec<Vec<usize>> {
    let own = soil.triangles.iter().enumerate().filter(|(t, _)| wanted(*t));
    let sides: BTreeSet<[usize; 2]> = own.flat_map(|(_, &[a, b, c])| [[a, b], [b, c], [c, a]]).collect();
    let mut next: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for &[a, b] in sides.iter().filter(|[a, b]| !sides.contains(&[*b, *a])) {
        next.entry(a).or_default().push(b);
    }
    let mut found = Vec::new();
    while let Some((&start, _)) = next.iter().next() {
        let (mut chain, mut at) = (Vec::new(), start);
        while let Some(on) = next.get_mut(&at) {
            chain.push(at);
            let to = on.pop();
            if on.is_empty() {
                next.remove(&at);
            }
            let Some(to) = to else { break };
            at = to;
        }
        found.push(chain);
    }
    found
}

/// Corners of loops on the sheet.
pub(crate) fn on_sheet(soil: &SoilPicture, loops: &[Vec<usize>], view: &View, scale: f64) -> Vec<Vec<Spot>> {
    loops.iter().map(|chain| chain.iter().map(|&k| view.spot(place(soil, k, scale))).collect()).collect()
}

/// The fill behind something: pale, with the lines between its regions.
pub(crate) fn pale(sheet: &mut Sheet, view: &View, picture: &Picture, scale: f64) {
    let Some(soil) = of(picture) else { return };
    sheet.open("soil");
    sheet
        .loops(&on_sheet(soil, &loops(soil, |_| true), view, scale), Pen::shape(PALE, RIM, HAIR).class("soil-outline"));
    sheet.close();
    sheet.open_drawn("soil-regions", Pen::line(RIM, HAIR));
    sheet.strokes(&seams(soil).map(|side| side.map(|k| view.spot(place(soil, k, scale)))).collect::<Vec<_>>(), HAIR);
    sheet.close();
}

/// Sides between triangles of different regions.
fn seams(soil: &SoilPicture) -> impl Iterator<Item = [usize; 2]> {
    let mut of_side: BTreeMap<[usize; 2], usize> = BTreeMap::new();
    for (&[a, b, c], &region) in soil.triangles.iter().zip(&soil.regions) {
        for side in [[a, b], [b, c], [c, a]] {
            of_side.insert(side, region);
        }
    }
    let between = |&[a, b]: &[usize; 2]| a < b && of_side.get(&[b, a]).is_some_and(|r| *r != of_side[&[a, b]]);
    of_side.keys().filter(|side| between(side)).copied().collect::<Vec<_>>().into_iter()
}

/// The outline of the fill as built, faint.
pub(crate) fn ghost(sheet: &mut Sheet, view: &View, picture: &Picture) {
    let Some(soil) = of(picture) else { return };
    sheet.loops(&on_sheet(soil, &loops(soil, |_| true), view, 0.0), Pen::line(draw::FAINT, HAIR).class("soil-ghost"));
}

/// Whether loads stand on the soil through plates.
pub(crate) fn loaded(picture: &Picture) -> bool {
    of(picture).is_some_and(|soil| !soil.plates.is_empty())
}

/// Whether loads stand on the blocks or on the soil.
pub(crate) fn any_load(picture: &Picture) -> bool {
    loaded(picture) || !picture.loads.is_empty()
}

/// Room above an elevation for the arrows and labels on it.
pub(crate) fn above(picture: &Picture) -> f64 {
    if loaded(picture) { draw::ARROW + 8.0 } else { 14.0 }
}

/// Plates under loads, each with its load above it.
pub(crate) fn plates(sheet: &mut Sheet, view: &View, picture: &Picture, scale: f64) {
    let Some(soil) = of(picture) else { return };
    sheet.open("plates");
    for plate in &soil.plates {
        let [a, b] = plate_ends(plate, scale).map(|p| view.spot(p));
        sheet.line(a, b, Pen::line(INK, THICK).class("plate"));
        draw::load_bar(sheet, [0.5 * (a[0] + b[0]), a[1].min(b[1]) - 0.5 * THICK], 0.5 * (b[0] - a[0]).abs());
    }
    sheet.close();
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square of two by two cells, each of two triangles.
    fn square() -> SoilPicture {
        let points = (0..9).map(|k| [f64::from(k % 3), f64::from(k / 3)]).collect();
        let cell = |k: usize| [[k, k + 1, k + 4], [k, k + 4, k + 3]];
        SoilPicture { points, triangles: [0, 1, 3, 4].into_iter().flat_map(cell).collect(), ..SoilPicture::default() }
    }

    fn area(soil: &SoilPicture, chain: &[usize]) -> f64 {
        let next = chain.iter().cycle().skip(1);
        let cross = |(a, b): (&usize, &usize)| {
            let (a, b) = (soil.points[*a], soil.points[*b]);
            a[0] * b[1] - a[1] * b[0]
        };
        0.5 * chain.iter().zip(next).map(cross).sum::<f64>()
    }

    #[test]
    fn loops_go_round_what_is_wanted_and_hold_its_area() {
        let soil = square();
        let whole = loops(&soil, |_| true);
        assert_eq!(whole.iter().map(Vec::len).collect::<Vec<_>>(), [8]);
        assert_eq!(area(&soil, &whole[0]), 4.0);
        // Two cells that touch at the corner in the middle.
        let two = loops(&soil, |t| [0, 1, 6, 7].contains(&t));
        assert_eq!(two.iter().map(|chain| area(&soil, chain)).sum::<f64>(), 2.0);
        assert!(loops(&soil, |_| false).is_empty());
    }

    #[test]
    fn regions_meet_along_their_seam() {
        let soil = SoilPicture { regions: vec![0, 0, 0, 0, 1, 1, 1, 1], ..square() };
        assert_eq!(seams(&soil).collect::<Vec<_>>(), [[3, 4], [4, 5]]);
    }

    #[test]
    fn triangles_without_their_corners_are_no_soil() {
        let soil = SoilPicture { triangles: vec![[0, 1, 99]], ..square() };
        assert!(of(&Picture { soil: Some(soil), ..Picture::default() }).is_none());
        assert!(of(&Picture { soil: Some(square()), ..Picture::default() }).is_some());
    }
}
