//! One drawing for a first page: the bridge as built, the load that governs in its place, and where its mechanism turns and slides.

use crate::elevation::{self as draw, Sign};
use crate::geometry::View;
use crate::sheet::place::Room;
use crate::sheet::{Area, MARGIN, Sheet, WIDTH};
use crate::{across, cover, defects, edges, mechanism, sliding};
use outcome::ground::GroundPlan;
use outcome::picture::{Hinge, Picture, Point};

/// Tallest drawing: the first page has other things to say.
const TALLEST: f64 = 250.0;

/// Tallest cross-section below it, and where it begins: the scale bar stands beside it.
const ACROSS: [f64; 2] = [84.0, 300.0];

/// The bridge as built with its governing load; every hinge and every sliding joint of its mechanism marked where it acts, defects, and what stands
/// at the edges and on the road; below it the cross-section at the crown. None without blocks.
pub fn sketch(picture: &Picture, ground: &GroundPlan) -> Option<String> {
    let extent = edges::extent(picture, draw::extent(picture)?);
    let (mut sheet, top) =
        draw::heading("governing", picture, "The worst load at collapse in its place, and the mechanism");
    let (frame, view) = draw::fit(extent, top + draw::ARROW, TALLEST);
    let built = |k: usize| picture.shapes[k].outline.clone();
    edges::behind(&mut sheet, &view, picture);
    cover::bands(&mut sheet, &view, picture);
    draw::blocks(&mut sheet, &view, &picture.shapes, built);
    draw::avoid_blocks(&mut sheet, &view, &picture.shapes, built);
    draw::surface(&mut sheet, &view, picture, draw::SURFACE);
    defects::lines(&mut sheet, &view, picture);
    edges::over(&mut sheet, &view, picture);
    let on_surface = !picture.surface_loads.is_empty();
    match on_surface {
        true => draw::surface_loads(&mut sheet, &view, picture),
        false => draw::load_arrows(&mut sheet, &view, picture, None),
    }
    if let Some(motions) = picture.mechanism.as_deref().filter(|all| all.len() == picture.shapes.len()) {
        sliding::mark(&mut sheet, &picture.shapes, motions, &picture.sliding, &view, 0.0);
    }
    let hinges: Vec<(Hinge, Point)> = picture.hinges.iter().map(|hinge| (*hinge, hinge.point)).collect();
    let middle = [0.5 * (extent.low[0] + extent.high[0]), 0.5 * (extent.low[1] + extent.high[1])];
    let room = Room::between(top, frame.bottom + 12.0);
    mechanism::mark_hinges(&mut sheet, &picture.shapes, &view, &hinges, middle, room);
    let y = draw::scale_bar(&mut sheet, &view, frame.bottom + 8.0);
    let y = across(&mut sheet, frame.bottom + 8.0, ground).max(y);
    let load = if on_surface { "load on the surface" } else { "load, as it reaches the blocks" };
    let entries = [
        (Sign::Hinge, "hinge", !hinges.is_empty()),
        (Sign::Sliding, "sliding joint", !picture.sliding.is_empty()),
        (Sign::Load, load, on_surface || !picture.loads.is_empty()),
    ];
    let y = draw::key(&mut sheet, y + 2.0, &entries);
    let y = edges::key(&mut sheet, y, picture);
    let y = defects::key(&mut sheet, y, picture);
    Some(sheet.finish(y))
}

/// The cross-section at the crown of the first span, small; returns the y below.
fn across(sheet: &mut Sheet, top: f64, ground: &GroundPlan) -> f64 {
    // The vehicle stands on the elevation.
    let ground = GroundPlan { vehicle: None, ..ground.clone() };
    let Some(extent) = across::extent(&ground) else { return top };
    let room = Area { left: ACROSS[1], right: WIDTH - MARGIN, top, bottom: top + ACROSS[0] };
    let view = View::fit(extent, room);
    across::draw(sheet, &view, &ground, extent) + 20.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use outcome::ground::Edges;
    use outcome::picture::{DefectMark, HingeAt, LoadArrow, Motion, Shape};

    #[test]
    fn every_hinge_is_marked_where_it_acts() {
        let block = |k: usize| {
            let left = k as f64;
            let outline = vec![[left, 0.0], [left + 1.0, 0.0], [left + 1.0, 1.0], [left, 1.0]];
            Shape { outline, role: "voussoir".into(), held: k == 0 || k == 4 }
        };
        let hinge = |k: usize| {
            let (edge, y) = if k.is_multiple_of(2) { (HingeAt::Extrados, 1.0) } else { (HingeAt::Intrados, 0.0) };
            Hinge { point: [k as f64, y], edge, between: [k - 1, k], rotation: 1.0 }
        };
        let picture = Picture {
            shapes: (0..5).map(block).collect(),
            mechanism: Some(vec![Motion::default(); 5]),
            hinges: (1..5).map(hinge).collect(),
            loads: vec![LoadArrow { at: [1.5, 1.0], force: [0.0, -1.0] }],
            ..Picture::default()
        };
        let drawing = sketch(&picture, &GroundPlan::default()).expect("a drawing");
        assert_eq!(drawing.matches("class=\"hinge\"").count(), 4, "{drawing}");
        for label in ["1 intrados", "2 extrados", "3 intrados", "4 extrados"] {
            assert!(drawing.contains(label), "{label}: {drawing}");
        }
        assert!(sketch(&Picture::default(), &GroundPlan::default()).is_none());
    }

    /// Walls, parapets, kerbs, tracks and defects from the side, and the cross-section with its sizes.
    #[test]
    fn the_edges_and_the_cross_section_are_drawn() {
        let outline = vec![[0.0, 0.0], [6.0, 0.0], [6.0, 1.0], [0.0, 1.0]];
        let edges = Edges { parapet: Some([1.0, 0.3]), kerb: Some([0.8, 0.12]), tracks: vec![2.5], gauge: 1.435 };
        let picture = Picture {
            shapes: vec![Shape { outline, role: "voussoir".into(), held: false }],
            surface: vec![[0.0, 1.5], [6.0, 1.5]],
            wall_top: vec![[0.0, 1.8], [6.0, 1.8]],
            edges: edges.clone(),
            defects: vec![DefectMark { words: "mortar lost".into(), line: vec![[1.0, 0.0], [2.0, 0.0]] }],
            ..Picture::default()
        };
        let rings = vec![1.0];
        let ground = GroundPlan { bridge: "B".into(), width: 5.0, rings, edges, ..GroundPlan::default() };
        let drawing = sketch(&picture, &ground).expect("a drawing");
        for class in ["parapet", "wall-top", "kerb", "track", "defects", "rings", "tracks"] {
            assert!(drawing.contains(&format!("class=\"{class}\"")), "{class}: {drawing}");
        }
        for words in
            ["parapet 1 m high, 0.3 m", "upper edge of the spandrel walls", "mortar lost", "rails 1.435 m apart"]
        {
            assert!(drawing.contains(words), "{words}: {drawing}");
        }
    }
}
