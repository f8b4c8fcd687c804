//! Stress in the blocks and at the joints.

use crate::bar::Scale;
use crate::colour::dark_for_much;
use crate::discs;
use crate::elevation::{self as draw, INK, Sign};
use crate::geometry::{
    Extent, Turn, View, as_built, back, centroid, exaggerated, largest_displacement, moved, round_down,
};
use crate::sheet::{Area, MARGIN, Pen, Sheet, WIDTH};
use crate::words;
use outcome::picture::{Picture, Point, Snapshot};

/// Share of the larger dimension of the bridge that displacements are drawn with, at most.
const SHARE: f64 = 0.012;
/// Length of the bar of the largest contact stress on the sheet.
const BAR: f64 = 30.0;

/// Most compressive principal stress [Pa], compression positive, of a plane stress (tension positive: xx, yy, xy).
pub fn most_compressive([xx, yy, xy]: [f64; 3]) -> f64 {
    // Adding zero takes the sign off a negative zero.
    (0.5 * (xx - yy)).hypot(xy) - 0.5 * (xx + yy) + 0.0
}

/// One snapshot: blocks coloured by their most compressive principal stress, contact stresses as bars that stand
/// out of the joints, displacements exaggerated as stated. None where that snapshot or its stresses do not exist.
pub fn stress(picture: &Picture, snapshot: usize) -> Option<String> {
    let state = picture.snapshots.get(snapshot)?;
    let count = picture.shapes.len();
    if count == 0 || state.stresses.len() != count || state.motions.len() != count {
        return None;
    }
    let extent = as_built(&picture.shapes)?;
    let scale = exaggeration(picture, state, extent);
    let place = |k: usize| moved(&picture.shapes[k], state.motions[k], scale, Turn::Finite);

    let at = if picture.moves_supports {
        format!("a support movement of {}", words::metres(state.load))
    } else {
        words::force(state.load)
    };
    let collapses = draw::collapse_load(picture).is_some_and(|c| state.load >= c * (1.0 - 1e-9));
    let which = match () {
        () if collapses => ", collapse",
        () if picture.last_stable == Some(snapshot) => ", last stable",
        () => "",
    };
    let (mut sheet, top) =
        draw::heading(&format!("stress-{snapshot}"), picture, &format!("Compressive stress at {at}{which}"));
    let deformed = Extent::of((0..count).flat_map(&place)).unwrap_or(extent);
    let roomy = extent.grown(0.5 * extent.size()[0].max(extent.size()[1]));
    let shown = extent.with(deformed.within(roomy));
    // Room for the bars.
    let shown = shown.grown(BAR / WIDTH * shown.size()[0].max(shown.size()[1]));
    let (frame, view) = draw::fit(shown, top, draw::TALLEST);

    let compression = |k: usize| most_compressive(state.stresses[k]);
    let free = || (0..count).filter(|&k| !picture.shapes[k].held);
    let largest = free().map(compression).filter(|s| s.is_finite()).fold(0.0, f64::max);
    let name = "most compressive principal stress, average of each block [MPa]";
    let scale_of_stress = Scale::upto(name, [largest / 1e6, 0.0], 6, dark_for_much);

    sheet.open_clipped("blocks", "room", frame);
    discs::pale(&mut sheet, &view, picture, Some(state));
    let width = draw::outline_width(&picture.shapes, &view);
    for (k, _) in picture.shapes.iter().enumerate().filter(|(_, s)| s.held) {
        sheet.hatched(&view.spots(&place(k)), Pen::line(INK, 0.75).class("support"));
    }
    for k in free() {
        let colour = scale_of_stress.of(compression(k) / 1e6);
        // White joints can be told from light and from dark blocks.
        sheet.polygon(&view.spots(&place(k)), Pen::shape(&colour, "white", width).class("block"));
    }
    sheet.close();
    let highest = contact_bars(&mut sheet, picture, state, &view, scale, frame);

    let mut y = draw::scale_bar(&mut sheet, &view, frame.bottom + 8.0);
    y = scale_of_stress.draw(&mut sheet, MARGIN, MARGIN + 444.0, y + 6.0);
    let entries = [
        (Sign::Contact, "contact stress, as a bar out of the joint", highest > 0.0),
        (Sign::Support, "support", picture.shapes.iter().any(|s| s.held)),
    ];
    y = draw::key(&mut sheet, y, &entries);
    let mut caption = format!(
        "Displacements {}.",
        if scale == 1.0 { "drawn at true scale".into() } else { format!("exaggerated {}", words::times(scale)) }
    );
    if highest > 0.0 {
        caption += &format!(" Longest bar: {} MPa.", words::four_digits(highest / 1e6));
    }
    caption += &format!(" Largest average stress of a block: {} MPa.", words::four_digits(largest / 1e6));
    Some(sheet.end(y, &caption))
}

/// The last stable state, or the last of all.
pub(crate) fn last_stress(picture: &Picture) -> Option<String> {
    stress(picture, picture.last_stable.or_else(|| picture.snapshots.len().checked_sub(1))?)
}

/// How many times larger displacements are drawn: a round number.
pub(crate) fn exaggeration(picture: &Picture, state: &Snapshot, extent: Extent) -> f64 {
    // Particles would overlap.
    if !picture.particles.is_empty() {
        return 1.0;
    }
    let size = extent.size()[0].max(extent.size()[1]);
    let largest = largest_displacement(&picture.shapes, &state.motions, Turn::Finite);
    if largest <= 1e-12 * size { 1.0 } else { round_down(SHARE * size / largest).max(1.0) }
}

/// Bars at the closed contacts; returns the largest stress [Pa].
fn contact_bars(sheet: &mut Sheet, picture: &Picture, state: &Snapshot, view: &View, scale: f64, clip: Area) -> f64 {
    let usable = |s: f64| s.is_finite() && s > 0.0;
    let highest = state.contacts.iter().map(|c| c.stress).filter(|&s| usable(s)).fold(0.0, f64::max);
    if highest <= 0.0 {
        return 0.0;
    }
    sheet.open_clipped("contacts", "room-of-contacts", clip);
    for contact in state.contacts.iter().filter(|c| usable(c.stress)) {
        let at = view.spot(drawn(picture, state, contact.blocks[0], contact.point, scale));
        let length = BAR * contact.stress / highest;
        // Along the joint, away from the middle of the block.
        let along = [-contact.normal[1], contact.normal[0]];
        let free = |b: &&usize| picture.shapes.get(**b).is_some_and(|s| !s.held);
        let middle = contact.blocks.iter().find(free).and_then(|&b| now(picture, state, b));
        let off = middle.map_or([0.0, 0.0], |c| [contact.point[0] - c[0], contact.point[1] - c[1]]);
        let side = if off[0] * along[0] + off[1] * along[1] < 0.0 { -1.0 } else { 1.0 };
        let end = [at[0] + side * length * along[0], at[1] - side * length * along[1]];
        if length > 0.4 {
            sheet.line(at, end, Pen::line(INK, 1.6).class("contact"));
        }
    }
    sheet.close();
    highest
}

/// Where the centroid of a block is now [m].
fn now(picture: &Picture, state: &Snapshot, block: usize) -> Option<Point> {
    let (centre, motion) = (centroid(&picture.shapes.get(block)?.outline), state.motions.get(block)?);
    Some([centre[0] + motion.translation[0], centre[1] + motion.translation[1]])
}

/// A point where the blocks are now, moved to where they are drawn.
fn drawn(picture: &Picture, state: &Snapshot, block: usize, point: Point, scale: f64) -> Point {
    match (picture.shapes.get(block), state.motions.get(block)) {
        (Some(shape), Some(&motion)) => {
            let centre = centroid(&shape.outline);
            exaggerated(back(point, centre, motion), centre, motion, scale, Turn::Finite)
        }
        _ => point,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn principal_stresses_of_known_states() {
        assert_eq!(most_compressive([-3.0, 1.0, 0.0]), 3.0);
        assert_eq!(most_compressive([0.0, 0.0, 2.0]), 2.0);
        assert_eq!(most_compressive([4.0, 4.0, 0.0]), -4.0);
    }
}
