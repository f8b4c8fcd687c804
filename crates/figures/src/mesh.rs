//! The finite element mesh by zones: the whole bridge, and a part of it at a larger scale.

use crate::chart::Key;
use crate::elevation::{self as draw, INK};
use crate::geometry::{Extent, View};
use crate::sheet::{Area, HAIR, MARGIN, MEDIUM, Pen, Sheet, Style};
use outcome::mesh::{MadeOf, MeshPicture};
use outcome::picture::Point;

/// Colours of what zones are made of; all light, so that lines of elements show, and told apart in grey too.
fn colour(made_of: MadeOf) -> &'static str {
    match made_of {
        MadeOf::Voussoirs => "#f0c27b",
        MadeOf::Pier => "#d9b8a0",
        MadeOf::Abutment => "#c9a58e",
        MadeOf::Fill => "#e9e4c9",
        MadeOf::HaunchFill => "#b9cba6",
        MadeOf::Backing => "#a9b4be",
        MadeOf::AbutmentFill => "#d3dbe2",
    }
}

/// Colours of joints and contacts, and how they are named in the key.
const LINES: [(&str, &str, &str); 3] = [
    ("mortar joint", "#7a1f1f", "mortar joint"),
    ("ring joint", "#8a4a9a", "joint between rings"),
    ("fill contact", "#0b5394", "contact of fill with masonry"),
];

/// Elements narrower than this on the sheet are drawn without their sides.
const LEAST: f64 = 0.9;

/// The mesh of a bridge by zones, with its key; `title` names the bridge.
pub fn mesh(title: &str, picture: &MeshPicture) -> String {
    let (mut sheet, top) = Sheet::titled("mesh", title, "Finite element mesh by zones");
    let Some(whole) = Extent::of(picture.nodes.iter().copied()) else { return sheet.finish(top) };
    let whole = whole.grown(0.01 * whole.size()[0]);
    let (frame, view) = draw::fit(whole, top, 230.0);
    elements(&mut sheet, &view, picture, whole);
    base(&mut sheet, &view, picture);
    let close = close_up(picture, whole);
    let mut y = frame.bottom.min(top + whole.size()[1] * view.scale) + 10.0;
    if let Some(part) = close {
        let outline = |e: Extent| [e.low, [e.high[0], e.low[1]], e.high, [e.low[0], e.high[1]]];
        sheet.polygon(&view.spots(&outline(part)), Pen::line(INK, MEDIUM).dashed("4 2"));
        y = draw::scale_bar(&mut sheet, &view, y) + 12.0;
        sheet.text([MARGIN, y + 8.0], "The part within the dashed lines", Style::default());
        y += 16.0;
        let (_, near) = draw::fit(part, y, 430.0);
        let window = near.area(part);
        sheet.open_clipped("close-up", "close", window);
        elements(&mut sheet, &near, picture, part);
        base(&mut sheet, &near, picture);
        sheet.close();
        sheet.rectangle(window, Pen::line(INK, HAIR));
        y = draw::scale_bar(&mut sheet, &near, window.bottom + 6.0);
    } else {
        y = draw::scale_bar(&mut sheet, &view, y);
    }
    y = key(&mut sheet, y + 6.0, picture);
    sheet.end(y + 2.0, &format!("{}.", picture.remark))
}

/// Elements that touch a part, joints and contacts over them.
fn elements(sheet: &mut Sheet, view: &View, picture: &MeshPicture, part: Extent) {
    let inside = |p: Point| (0..2).all(|k| part.low[k] <= p[k] && p[k] <= part.high[k]);
    sheet.open("elements");
    for (quad, zone) in picture.quads.iter().zip(&picture.zone_of) {
        let corners = quad.map(|n| picture.nodes[n]);
        if !corners.iter().any(|p| inside(*p)) {
            continue;
        }
        let fill = colour(picture.zones[*zone].made_of);
        let spots = view.spots(&corners);
        let side = |a: usize, b: usize| (spots[a][0] - spots[b][0]).hypot(spots[a][1] - spots[b][1]);
        let narrow = side(0, 1).min(side(1, 2));
        let pen = if narrow < LEAST {
            Pen::shape(fill, fill, 0.2)
        } else {
            Pen::shape(fill, "#6b6b60", (0.03 * narrow).clamp(0.12, 0.5))
        };
        sheet.polygon(&spots, pen);
    }
    sheet.close();
    sheet.open("interfaces");
    for (nodes, kind) in &picture.interfaces {
        let points: Vec<Point> = nodes.iter().map(|n| picture.nodes[*n]).collect();
        if points.iter().any(|p| inside(*p)) {
            let stroke = LINES.iter().find(|(name, ..)| name == kind).map_or(INK, |(_, stroke, _)| stroke);
            let width = (0.02 * view.scale).clamp(0.35, 1.6);
            sheet.polyline(&view.spots(&points), Pen::line(stroke, width));
        }
    }
    sheet.close();
}

/// Short strokes below the fixed nodes.
fn base(sheet: &mut Sheet, view: &View, picture: &MeshPicture) {
    sheet.open("base");
    for node in &picture.base {
        let [x, y] = view.spot(picture.nodes[*node]);
        sheet.line([x, y], [x - 3.0, y + 5.0], Pen::line(INK, HAIR));
    }
    sheet.close();
}

/// A part of the bridge worth a closer look: the first half span and its springing, or that on the first pier.
fn close_up(picture: &MeshPicture, whole: Extent) -> Option<Extent> {
    let of = |made_of: MadeOf, nth: usize| {
        let zone = picture.zones.iter().enumerate().filter(|(_, z)| z.made_of == made_of).nth(nth)?.0;
        let quads = picture.quads.iter().zip(&picture.zone_of).filter(|(_, z)| **z == zone);
        Extent::of(quads.flat_map(|(quad, _)| quad.map(|n| picture.nodes[n])))
    };
    let span = of(MadeOf::Voussoirs, 0)?;
    let surface = picture.surface.first().map_or(whole.high[1], |point| point[1]);
    let reach = 0.62 * span.size()[0];
    let middle = of(MadeOf::Pier, 0).map_or(span.low[0] + 0.3 * reach, |pier| 0.5 * (pier.low[0] + pier.high[0]));
    let low = span.low[1] - 0.25 * (surface - span.low[1]);
    let part = Extent { low: [middle - reach, low], high: [middle + reach, surface + 0.03 * reach] };
    Some(part.within(whole))
}

/// Zones with their colours, and lines.
fn key(sheet: &mut Sheet, top: f64, picture: &MeshPicture) -> f64 {
    let mut entries: Vec<((&str, bool), String)> = Vec::new();
    for &made_of in MadeOf::ALL {
        let zones = picture.zones.iter().filter(|zone| zone.made_of == made_of);
        let count: usize = zones.map(|zone| zone.quads).sum();
        if count > 0 {
            entries.push(((colour(made_of), false), format!("{made_of} ({count})")));
        }
    }
    for (kind, stroke, words) in LINES {
        if picture.interfaces.iter().any(|(_, known)| known == kind) {
            entries.push(((stroke, true), words.to_owned()));
        }
    }
    let key = Key { words: 23.0, wide: 28.0, gap: 16.0, ..Key::ELEVATION };
    key.draw(sheet, top, entries, |sheet, [x, y], (ink, is_line)| match is_line {
        true => sheet.line([x, y - 4.0], [x + 18.0, y - 4.0], Pen::line(ink, 2.0)),
        false => {
            let area = Area { left: x, right: x + 18.0, top: y - 10.0, bottom: y + 1.0 };
            sheet.rectangle(area, Pen::shape(ink, INK, HAIR));
        }
    })
}
