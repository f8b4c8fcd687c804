//! One drawing for a first page: the bridge as built, the load that governs in its place, and where its mechanism turns and slides.

use crate::cover;
use crate::elevation::{self as draw, Sign};
use crate::sheet::place::Room;
use crate::{mechanism, sliding};
use outcome::picture::{Hinge, Picture, Point};

/// Tallest drawing: the first page has other things to say.
const TALLEST: f64 = 250.0;

/// The bridge as built with its governing load; every hinge and every sliding joint of its mechanism marked where it acts. None without blocks.
pub fn sketch(picture: &Picture) -> Option<String> {
    let extent = draw::extent(picture)?;
    let (mut sheet, top) =
        draw::heading("governing", picture, "The worst load at collapse in its place, and the mechanism");
    let (frame, view) = draw::fit(extent, top + draw::ARROW, TALLEST);
    let built = |k: usize| picture.shapes[k].outline.clone();
    cover::bands(&mut sheet, &view, picture);
    draw::blocks(&mut sheet, &view, &picture.shapes, built);
    draw::avoid_blocks(&mut sheet, &view, &picture.shapes, built);
    draw::surface(&mut sheet, &view, picture, draw::SURFACE);
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
    let load = if on_surface { "load on the surface" } else { "load, as it reaches the blocks" };
    let entries = [
        (Sign::Hinge, "hinge", !hinges.is_empty()),
        (Sign::Sliding, "sliding joint", !picture.sliding.is_empty()),
        (Sign::Load, load, on_surface || !picture.loads.is_empty()),
    ];
    let y = draw::key(&mut sheet, y + 2.0, &entries);
    Some(sheet.finish(y))
}

#[cfg(test)]
mod tests {
    use super::*;
    use outcome::picture::{HingeAt, LoadArrow, Motion, Shape};

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
        let drawing = sketch(&picture).expect("a drawing");
        assert_eq!(drawing.matches("class=\"hinge\"").count(), 4, "{drawing}");
        for label in ["1 intrados", "2 extrados", "3 intrados", "4 extrados"] {
            assert!(drawing.contains(label), "{label}: {drawing}");
        }
        assert!(sketch(&Picture::default()).is_none());
    }
}
