//! The mechanism of collapse.

use crate::discs;
use crate::elevation::{self as draw, INK, Sign};
use crate::geometry::{Extent, Turn, View, as_built, centroid, largest_displacement, moved};
use crate::sheet::place::Room;
use crate::sheet::{Area, Pen, Sheet, Spot, Style};
use crate::{soil, words};
use outcome::picture::{Hinge, HingeAt, Picture, Point, Shape};
use outcome::soil::SoilPicture;

/// Share of the larger dimension of the bridge that the largest displacement is drawn with.
const SHARE: f64 = 0.05;
/// The same where a loading block sinks into particles, which stand as packed.
const SHARE_IN_FILL: f64 = 0.02;

/// The same where fill moves as a continuum: more would turn its triangles inside out.
const SHARE_IN_SOIL: f64 = 0.03;

/// With more hinges than this they are drawn small and without labels, which would hide the drawing; the place of
/// the circle tells the edge.
const MANY: usize = 12;

/// The mechanism, exaggerated, over the faint bridge as built; hinges, sliding joints and loads marked. None where
/// the analysis found no mechanism.
pub fn mechanism(picture: &Picture) -> Option<String> {
    drawn(picture, None)
}

/// The mechanism with its fill pale behind the blocks, or coloured by the power that it dissipates.
pub(crate) fn drawn(picture: &Picture, coloured: Option<&SoilPicture>) -> Option<String> {
    let motions = picture.mechanism.as_deref().filter(|m| m.len() == picture.shapes.len())?;
    let built = as_built(&picture.shapes)?;
    let size = built.size()[0].max(built.size()[1]);
    let of_blocks = largest_displacement(&picture.shapes, motions, Turn::Small);
    let largest = of_blocks.max(soil::largest_motion(picture));
    let share = match soil::of(picture) {
        Some(_) => SHARE_IN_SOIL,
        None if picture.particles.is_empty() => SHARE,
        None => SHARE_IN_FILL,
    };
    let scale = if largest > 0.0 { share * size / largest } else { 0.0 };
    let place = |k: usize| moved(&picture.shapes[k], motions[k], scale, Turn::Small);

    let (name, what) = match coloured {
        Some(_) => ("soil-mechanism", "Mechanism of blocks and fill"),
        None => ("mechanism", "Mechanism"),
    };
    let second = match draw::collapse_load(picture) {
        Some(load) if picture.moves_supports => format!("{what} at a support movement of {}", words::metres(load)),
        Some(load) => format!("{what} at collapse, {}", words::force(load)),
        None => what.to_string(),
    };
    let (mut sheet, top) = draw::heading(name, picture, &second);
    let deformed = Extent::of((0..motions.len()).flat_map(&place)).unwrap_or(built);
    let extent = draw::extent(picture).map_or(deformed, |e| e.with(deformed));
    let extent = soil::around(extent, picture, scale);
    // Labels of hinges and tails of arrows stand above and below the blocks.
    let (frame, view) = draw::fit(extent, top + soil::above(picture), draw::TALLEST);
    draw::surface(&mut sheet, &view, picture, draw::FAINT);
    discs::pale(&mut sheet, &view, picture, None);
    if soil::of(picture).is_some() {
        soil::open(&mut sheet, &view, extent);
        soil::ghost(&mut sheet, &view, picture);
        soil::pale(&mut sheet, &view, picture, scale);
        if let Some(soil) = coloured {
            soil::mechanism::dissipating(&mut sheet, &view, soil, scale);
        }
        sheet.close();
    }
    draw::ghost(&mut sheet, &view, &picture.shapes);
    draw::blocks(&mut sheet, &view, &picture.shapes, place);
    draw::avoid_blocks(&mut sheet, &view, &picture.shapes, place);
    for shape in picture.shapes.iter().filter(|s| !s.held) {
        if let Some(area) = Area::around(&view.spots(&shape.outline)) {
            sheet.avoid_lightly(area);
        }
    }
    draw::load_arrows(&mut sheet, &view, picture, Some((motions, scale)));
    soil::plates(&mut sheet, &view, picture, scale);

    let middle = [0.5 * (built.low[0] + built.high[0]), 0.5 * (built.low[1] + built.high[1])];
    let room = Room::between(top, frame.bottom + 20.0);
    crate::sliding::mark(&mut sheet, &picture.shapes, motions, &picture.sliding, &view, scale);
    let hinges: Vec<(Hinge, Point)> = picture
        .hinges
        .iter()
        .map(|h| (*h, draw::carried(&picture.shapes, motions, scale, h.point)))
        .filter(|(_, p)| p[0].is_finite() && p[1].is_finite())
        .collect();
    mark_hinges(&mut sheet, &picture.shapes, &view, &hinges, middle, room);

    let mut y = draw::scale_bar(&mut sheet, &view, frame.bottom + 26.0);
    let hinge = if hinges.len() <= MANY { "hinge, named after the edge about which it turns" } else { "hinge" };
    let built = if picture.surface.len() > 1 { "as built, and road surface" } else { "as built" };
    let entries = [
        (Sign::Hinge, hinge, !hinges.is_empty()),
        (Sign::Sliding, "sliding joint", !picture.sliding.is_empty()),
        (Sign::Load, "load", soil::any_load(picture)),
        (Sign::AsBuilt, built, true),
    ];
    y = draw::key(&mut sheet, y + 2.0, &entries);
    if coloured.is_some() {
        y = soil::mechanism::key(&mut sheet, y + 6.0);
    }
    let shown = words::metres(scale * largest);
    let mut caption = if picture.moves_supports {
        format!("The largest displacement is drawn as {shown} at the scale of the bar.")
    } else {
        format!(
            "A mechanism has a shape but no size: exaggerated here to a largest displacement of {shown} at the scale of the bar."
        )
    };
    if !picture.particles.is_empty() {
        caption += " Particles are drawn as packed.";
    } else if coloured.is_some() {
        caption += " Dark bands in the fill are slip lines.";
    } else if !picture.loads.is_empty() {
        caption = format!("{caption} {}", draw::LOAD_WORDS);
    }
    Some(sheet.end(y, &caption))
}

/// Open circles with number and edge, the labels outside the ring on the hinge's own side.
pub(crate) fn mark_hinges(
    sheet: &mut Sheet,
    shapes: &[Shape],
    view: &View,
    hinges: &[(Hinge, Point)],
    middle: Point,
    room: Room,
) {
    sheet.open("hinges");
    // Among many, those of walls and piers stand back behind those of the rings.
    let many = hinges.len() > MANY;
    let behind = |hinge: &Hinge| many && hinge.edge == HingeAt::Other;
    for (hinge, point) in hinges.iter().filter(|h| behind(&h.0)).chain(hinges.iter().filter(|h| !behind(&h.0))) {
        let (radius, pen) = match (many, behind(hinge)) {
            (_, true) => (1.4, 0.8),
            (true, false) => (2.8, 1.6),
            (false, false) => (4.2, 1.6),
        };
        let at = view.spot(*point);
        sheet.circle(at, radius, Pen::shape("white", INK, pen).class("hinge"));
        sheet.avoid(Area::about(at, 6.0));
    }
    sheet.close();
    let labelled = if hinges.len() > MANY { &[] } else { hinges };
    for (k, (hinge, point)) in labelled.iter().enumerate() {
        let number = (k + 1).to_string();
        let text = if hinge.edge == HingeAt::Other { number } else { format!("{number} {}", hinge.edge) };
        let towards = label_side(shapes, *hinge, middle);
        sheet.label(view.spot(*point), &text, Style::on_drawing(), room.towards(towards));
    }
}

/// From the middle of the hinge's block towards the hinge: the side on which there is no masonry.
fn label_side(shapes: &[Shape], hinge: Hinge, middle: Point) -> Spot {
    let centre = crate::geometry::block_at(shapes, hinge.point).map_or(middle, |k| centroid(&shapes[k].outline));
    let d = [hinge.point[0] - centre[0], -(hinge.point[1] - centre[1])];
    let length = d[0].hypot(d[1]);
    if length > 0.0 { [d[0] / length, d[1] / length] } else { [0.0, -1.0] }
}
