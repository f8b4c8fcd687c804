//! What every elevation is drawn from: blocks, supports, the road surface, load arrows, the scale bar.

use crate::chart::Key;
use crate::geometry::{Extent, View, as_built, block_at, centroid, exaggerated};
use crate::sheet::{Area, HAIR, MARGIN, MEDIUM, Pen, Sheet, Style, THIN, WIDTH};
use crate::{geometry::Turn, words};
use outcome::picture::{LoadArrow, Motion, Picture, Point, Shape};

/// Colour of lines.
pub(crate) const INK: &str = "#1a1a1a";
/// Colour of loads; dark enough to print.
pub(crate) const LOAD: &str = "#a02020";
/// Outline of the bridge as built, behind something.
pub(crate) const FAINT: &str = "#b0b0b0";

/// Fill of a block by its role: all light, and told apart by their grey.
fn fill(shape: &Shape) -> &'static str {
    match shape.role.as_str() {
        "voussoir" => "#f2e8d5",
        "pier" => "#e2dccd",
        "backing" => "#d9d9d2",
        "wall" => "#e7ded2",
        _ => "#ece6da",
    }
}

/// Line width that suits blocks of this size on the sheet: thinner where there are many.
pub(crate) fn outline_width(shapes: &[Shape], view: &View) -> f64 {
    let mut sizes: Vec<f64> = shapes
        .iter()
        .filter(|s| !s.held)
        .filter_map(|s| Extent::of(s.outline.iter().copied()))
        .map(|e| view.scale * e.size()[0].min(e.size()[1]))
        .collect();
    sizes.sort_by(f64::total_cmp);
    let middle = sizes.get(sizes.len() / 2).copied().unwrap_or(20.0);
    (0.09 * middle).clamp(0.15, THIN)
}

/// The blocks, filled by role, at their exaggerated places; supports first so that moving blocks lie over them.
pub(crate) fn blocks(sheet: &mut Sheet, view: &View, shapes: &[Shape], place: impl Fn(usize) -> Vec<Point>) {
    let width = outline_width(shapes, view);
    sheet.open("blocks");
    for held in [true, false] {
        for (k, shape) in shapes.iter().enumerate().filter(|(_, s)| s.held == held) {
            let spots = view.spots(&place(k));
            match held {
                true => sheet.hatched(&spots, Pen::line(INK, THIN).class("support")),
                false => sheet.polygon(&spots, Pen::shape(fill(shape), INK, width).class("block")),
            }
        }
    }
    sheet.close();
}

/// Outlines of the free blocks as built, faint.
pub(crate) fn ghost(sheet: &mut Sheet, view: &View, shapes: &[Shape]) {
    sheet.open("as-built");
    for shape in shapes.iter().filter(|s| !s.held) {
        sheet.polygon(&view.spots(&shape.outline), Pen::line(FAINT, HAIR).class("ghost"));
    }
    sheet.close();
}

/// Colour of the road surface.
pub(crate) const SURFACE: &str = "#404040";

/// The road surface, [`FAINT`] behind something.
pub(crate) fn surface(sheet: &mut Sheet, view: &View, picture: &Picture, colour: &str) {
    if picture.surface.len() > 1 {
        let spots = view.spots(&picture.surface);
        sheet.polyline(&spots, Pen::line(colour, MEDIUM).class("surface"));
        sheet.avoid_line(&spots);
    }
}

/// Labels avoid the blocks.
pub(crate) fn avoid_blocks(sheet: &mut Sheet, view: &View, shapes: &[Shape], place: impl Fn(usize) -> Vec<Point>) {
    for k in 0..shapes.len() {
        if let Some(area) = Area::around(&view.spots(&place(k))) {
            sheet.avoid(area);
        }
    }
}

/// Extents of the free blocks of a role over and under a place along the bridge [m].
pub(crate) fn blocks_at(picture: &Picture, role: &str, x: f64) -> impl Iterator<Item = Extent> {
    let blocks = picture.shapes.iter().filter(move |s| s.role == role && !s.held);
    let extents = blocks.filter_map(|s| Extent::of(s.outline.iter().copied()));
    extents.filter(move |e| e.low[0] <= x && x <= e.high[0])
}

/// Loads as they touch the surface or their loading block: a bar of their length under a row of arrows.
pub(crate) fn surface_loads(sheet: &mut Sheet, view: &View, picture: &Picture) {
    sheet.open("surface-loads");
    for &(middle, length) in &picture.surface_loads {
        // Loads stand on the loading block at their place, or on the surface.
        let foot = blocks_at(picture, "block", middle[0]).map(|block| block.high[1]).fold(middle[1], f64::max);
        load_bar(sheet, view.spot([middle[0], foot]), 0.5 * length.max(0.0) * view.scale);
    }
    sheet.close();
}

/// A load on the sheet: a bar of twice `half` over a row of arrows that end at a level.
pub(crate) fn load_bar(sheet: &mut Sheet, [x, y]: [f64; 2], half: f64) {
    let half = half.max(2.0);
    let gaps = ((2.0 * half / 9.0).round() as usize).clamp(0, 24);
    let (top, tip) = (y - ARROW, y - 1.5);
    let pen = Pen::line(LOAD, MEDIUM).class("load");
    for k in 0..=gaps {
        let at = if gaps == 0 { x } else { x - half + 2.0 * half * k as f64 / gaps as f64 };
        sheet.arrow([at, top], [at, tip], pen);
    }
    if gaps > 0 {
        sheet.line([x - half, top], [x + half, top], pen);
    }
    sheet.avoid(Area { left: x - half - 3.0, right: x + half + 3.0, top, bottom: y });
}

/// Length of the longest load arrow on the sheet.
pub(crate) const ARROW: f64 = 30.0;

/// Forces on the blocks, the longest [`ARROW`] long, moved along with the blocks that carry them.
pub(crate) fn load_arrows(sheet: &mut Sheet, view: &View, picture: &Picture, motion: Option<(&[Motion], f64)>) {
    let size = |l: &LoadArrow| l.force[0].hypot(l.force[1]);
    let largest = picture.loads.iter().map(size).filter(|f| f.is_finite()).fold(0.0, f64::max);
    if largest <= 0.0 {
        return;
    }
    sheet.open("load-arrows");
    for load in picture.loads.iter().filter(|l| size(l) > 0.02 * largest) {
        let at = match motion {
            Some((motions, scale)) => carried(&picture.shapes, motions, scale, load.at),
            None => load.at,
        };
        let tip = view.spot(at);
        let length = ARROW * size(load) / largest;
        let unit = [load.force[0] / size(load), -load.force[1] / size(load)];
        let tail = [tip[0] - length * unit[0], tip[1] - length * unit[1]];
        let width = if picture.loads.len() > 12 { THIN } else { MEDIUM };
        sheet.arrow(tail, tip, Pen::line(LOAD, width).class("load"));
        if let Some(area) = Area::around(&[tail, tip]) {
            sheet.avoid(area.grown(2.0));
        }
    }
    sheet.close();
}

/// Where a point as built is drawn when the block under it moves.
pub(crate) fn carried(shapes: &[Shape], motions: &[Motion], scale: f64, point: Point) -> Point {
    match block_at(shapes, point) {
        Some(k) if k < motions.len() => {
            exaggerated(point, centroid(&shapes[k].outline), motions[k], scale, Turn::Small)
        }
        _ => point,
    }
}

/// A bar of a round length at the left end of a line; returns the y below it.
pub(crate) fn scale_bar(sheet: &mut Sheet, view: &View, top: f64) -> f64 {
    let length = crate::geometry::round_down(0.25 * (WIDTH - 2.0 * MARGIN) / view.scale);
    let (left, right, y) = (MARGIN, MARGIN + length * view.scale, top + 6.0);
    sheet.open("scale-bar");
    let middle = 0.5 * (left + right);
    let bar = |a: f64, b: f64| Area { left: a, right: b, top: y, bottom: y + 5.0 };
    sheet.rectangle(bar(left, middle), Pen::shape(INK, INK, HAIR));
    sheet.rectangle(bar(middle, right), Pen::shape("white", INK, HAIR));
    sheet.text([right + 6.0, y + 7.0], &words::metres(length), Style::small());
    sheet.close();
    y + 12.0
}

/// The room that a drawing takes on the sheet, the whole width and a height that follows from the extent, and the view of the extent in
/// it.
pub(crate) fn fit(extent: Extent, top: f64, tallest: f64) -> (Area, View) {
    let [w, h] = extent.size().map(|d| d.max(1e-9));
    let wide = WIDTH - 2.0 * MARGIN;
    let area = Area { left: MARGIN, right: WIDTH - MARGIN, top, bottom: top + (wide * h / w).min(tallest) };
    (area, View::fit(extent, area))
}

/// Tallest drawing on one sheet.
pub(crate) const TALLEST: f64 = 470.0;

/// Blocks, fill, surface and load points; none without blocks.
pub(crate) fn extent(picture: &Picture) -> Option<Extent> {
    let blocks = as_built(&picture.shapes)?;
    let loads = picture.surface_loads.iter().map(|l| l.0);
    let above = picture.surface.iter().chain(&picture.fill).copied().chain(loads);
    let whole = Extent::of(above).map_or(blocks, |e| blocks.with(e));
    // A single tiny block or a line still needs a sheet that is not degenerate.
    let size = whole.size()[0].max(whole.size()[1]).max(1e-6);
    Some(whole.grown(0.01 * size))
}

/// What the arrows mean: their common size is arbitrary.
pub(crate) const LOAD_WORDS: &str = "Arrows show how the variable load is shared among the blocks.";

/// The load at collapse: as the analysis gives it, or the first step that did not come to rest. A run that stalled has none.
pub(crate) fn collapse_load(picture: &Picture) -> Option<f64> {
    if picture.stalls {
        return None;
    }
    picture.collapse_load.or_else(|| picture.path.iter().find(|s| !s.at_rest).map(|s| s.load)).filter(|l| l.is_finite())
}

/// A sheet with title and second line, and below them which case is drawn where it is one of many; and the y below.
pub(crate) fn heading(name: &str, picture: &Picture, second: &str) -> (Sheet, f64) {
    let (mut sheet, top) = Sheet::titled(name, &picture.title, second);
    let below = picture.case.as_ref().map_or(top, |case| sheet.caption(top, case));
    (sheet, below)
}

/// A small row of signs and what they mean, those that are there; returns the y below it.
pub(crate) fn key(sheet: &mut Sheet, top: f64, entries: &[(Sign, &str, bool)]) -> f64 {
    let mut there = entries.iter().filter(|entry| entry.2).map(|entry| (entry.0, entry.1)).peekable();
    if there.peek().is_none() {
        return top;
    }
    Key::ELEVATION.draw(sheet, top, there, |sheet, [x, y], sign| sign.draw(sheet, [x + 11.0, y - 4.0]))
}

/// The signs of a key, and of the drawing it belongs to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Sign {
    Hinge,
    /// A joint that slides.
    Sliding,
    Load,
    /// The bridge as built.
    AsBuilt,
    Support,
    /// The line of thrust.
    Thrust,
    /// A contact stress.
    Contact,
    /// A principal stress that presses, and one that pulls.
    Compression,
    Tension,
    /// Pressure on the backs of blocks, and shear along them.
    Pressure,
    Shear,
}

/// Colour of principal stresses that pull.
pub(crate) const TENSION: &str = "#b35900";
/// Colours of pressures on the backs: area and line.
pub(crate) const PRESSURE: [&str; 2] = ["#bcd4ea", "#1f5fa8"];

/// Colour of sliding joints.
pub(crate) const SLIDING: &str = "#0b5394";
/// Colour of the line of thrust.
pub(crate) const THRUST: &str = "#0b5394";

impl Sign {
    /// Draws it at its middle.
    pub(crate) fn draw(self, sheet: &mut Sheet, at: [f64; 2]) {
        let [x, y] = at;
        match self {
            Sign::Hinge => sheet.circle(at, 4.2, Pen::shape("white", INK, 1.6)),
            Sign::Sliding => {
                for side in [-1.0, 1.0] {
                    let (tail, tip) = ([x - side * 6.5, y + side * 3.0], [x + side * 6.5, y + side * 3.0]);
                    sheet.arrow(tail, tip, Pen::line(SLIDING, MEDIUM));
                }
            }
            Sign::Load => sheet.arrow([x, y - 7.0], [x, y + 6.0], Pen::line(LOAD, MEDIUM)),
            Sign::AsBuilt => sheet.line([x - 10.0, y], [x + 10.0, y], Pen::line(FAINT, MEDIUM)),
            Sign::Support => {
                let (left, right, top, bottom) = (x - 10.0, x + 10.0, y - 5.0, y + 5.0);
                sheet.hatched(&[[left, top], [right, top], [right, bottom], [left, bottom]], Pen::line(INK, HAIR));
            }
            Sign::Thrust => sheet.line([x - 10.0, y], [x + 10.0, y], Pen::line(THRUST, crate::sheet::THICK)),
            Sign::Compression => sheet.line([x - 10.0, y], [x + 10.0, y], Pen::line(INK, 1.1)),
            Sign::Tension => {
                sheet.line([x - 8.0, y], [x + 8.0, y], Pen::line(TENSION, 0.9));
                for end in [x - 8.0, x + 8.0] {
                    sheet.line([end, y - 2.5], [end, y + 2.5], Pen::line(TENSION, 0.9));
                }
            }
            Sign::Pressure => {
                let area = Area { left: x - 10.0, right: x + 10.0, top: y - 5.0, bottom: y + 5.0 };
                sheet.rectangle(area, Pen::shape(PRESSURE[0], PRESSURE[1], THIN));
            }
            Sign::Shear => sheet.arrow([x - 8.0, y], [x + 8.0, y], Pen::line(INK, THIN)),
            Sign::Contact => sheet.line([x, y - 7.0], [x, y + 7.0], Pen::line(INK, 1.6)),
        }
    }
}
