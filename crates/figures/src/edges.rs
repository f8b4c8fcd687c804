//! What stands at the edges of the road and on it, from the side: parapets, upper edges of spandrel walls, kerbs, tracks.

use crate::chart::Key;
use crate::elevation::INK;
use crate::geometry::{Extent, View};
use crate::sheet::{Area, HAIR, MEDIUM, Pen, Sheet, THIN};
use crate::words::metres;
use outcome::picture::{Picture, Point};

pub(crate) const PARAPET: &str = "#e9e4da";
const KERB: &str = "#7a7a7a";
const RAIL: &str = "#303030";
/// Upper edge of a spandrel wall, behind which the fill is drawn.
const WALL: Pen<'static> = Pen::line("#7a5c2e", MEDIUM).dashed("7 3");
/// Height of a sleeper and of a rail, and what sleepers take of the track's length [m].
pub(crate) const SLEEPER: f64 = 0.15;
pub(crate) const RAIL_HEIGHT: f64 = 0.15;
const SPACING: f64 = 0.65;
const BREADTH: f64 = 0.25;

fn raised(line: &[Point], by: f64) -> Vec<Point> {
    line.iter().map(|[x, y]| [*x, y + by]).collect()
}

/// The extent with what stands above the road.
pub(crate) fn extent(picture: &Picture, extent: Extent) -> Extent {
    let high = picture.edges.parapet.map_or(0.0, |parapet| parapet[0]);
    let above = raised(&picture.surface, high).into_iter().chain(picture.wall_top.iter().copied());
    Extent::of(above).map_or(extent, |above| extent.with(above))
}

/// Parapets, which stand behind all that is cut.
pub(crate) fn behind(sheet: &mut Sheet, view: &View, picture: &Picture) {
    let Some([height, _]) = picture.edges.parapet.filter(|_| picture.surface.len() > 1) else { return };
    sheet.open("parapet");
    let outline: Vec<Point> =
        picture.surface.iter().copied().chain(raised(&picture.surface, height).into_iter().rev()).collect();
    sheet.polygon(&view.spots(&outline), Pen::shape(PARAPET, "#777777", THIN));
    sheet.close();
}

/// Upper edges of walls, kerbs and tracks, over what is cut.
pub(crate) fn over(sheet: &mut Sheet, view: &View, picture: &Picture) {
    if picture.wall_top.len() > 1 {
        sheet.open("wall-top");
        sheet.polyline(&view.spots(&picture.wall_top), WALL);
        sheet.close();
    }
    if picture.surface.len() < 2 {
        return;
    }
    if let Some([_, upstand]) = picture.edges.kerb {
        sheet.open("kerb");
        sheet.polyline(&view.spots(&raised(&picture.surface, upstand)), Pen::line(KERB, MEDIUM));
        sheet.close();
    }
    if !picture.edges.tracks.is_empty() {
        track(sheet, view, &picture.surface);
    }
}

/// Sleepers and rails on a line.
fn track(sheet: &mut Sheet, view: &View, line: &[Point]) {
    sheet.open("track");
    for pair in line.windows(2) {
        let ([x, y], [to, end]) = (pair[0], pair[1]);
        let count = ((to - x) / SPACING).floor().max(0.0) as usize;
        for k in 0..=count.min(2000) {
            let at = x + SPACING * k as f64;
            let level = y + (end - y) * (at - x) / (to - x).max(1e-9);
            let [low, high] = [view.spot([at, level]), view.spot([(at + BREADTH).min(to), level + SLEEPER])];
            let area = Area { left: low[0], right: high[0], top: high[1], bottom: low[1] };
            sheet.rectangle(area, Pen::shape("#9a9a9a", "none", 0.0));
        }
    }
    sheet.polyline(&view.spots(&raised(line, SLEEPER + 0.5 * RAIL_HEIGHT)), Pen::line(RAIL, MEDIUM));
    sheet.close();
}

/// What is there, with its sizes; returns the y below.
pub(crate) fn key(sheet: &mut Sheet, top: f64, picture: &Picture) -> f64 {
    let edges = &picture.edges;
    let [wall, track] = [picture.wall_top.len() > 1, !edges.tracks.is_empty()];
    let entries = [
        edges.parapet.map(|[height, thick]| (0, format!("parapet {} high, {}", metres(height), metres(thick)))),
        wall.then(|| (1, "upper edge of the spandrel walls".to_owned())),
        edges
            .kerb
            .map(|[distance, upstand]| (2, format!("kerb {}, {} from the edge", metres(upstand), metres(distance)))),
        track.then(|| (3, "track".to_owned())),
    ];
    let there: Vec<(usize, String)> = entries.into_iter().flatten().collect();
    if there.is_empty() {
        return top;
    }
    Key { class: "edges-key", ..Key::ELEVATION }.draw(sheet, top, there, |sheet, [x, y], kind| {
        let line = |pen| ([x + 1.0, y - 4.0], [x + 21.0, y - 4.0], pen);
        let (from, to, pen) = match kind {
            1 => line(WALL),
            2 => line(Pen::line(KERB, MEDIUM)),
            _ => line(Pen::line(RAIL, MEDIUM)),
        };
        let swatch = Area { left: x + 1.0, right: x + 21.0, top: y - 9.0, bottom: y + 1.0 };
        match kind {
            0 => sheet.rectangle(swatch, Pen::shape(PARAPET, INK, HAIR)),
            _ => sheet.line(from, to, pen),
        }
    })
}
