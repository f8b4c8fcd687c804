//! Results as drawings for a CAD program: the model as built, moved, and coloured by stress. Layers carry what a
//! picture's legend would say; lengths are in metres.

use crate::geometry::{Turn, as_built, block_at, centroid, exaggerated, largest_displacement, moved};
use crate::stress::{exaggeration, most_compressive};
use crate::ticks::Ticks;
use crate::{File, words};
use drawing::{Item, Sheet};
use outcome::picture::{ContactForce, Motion, Picture, Point, Shape, Snapshot};

/// The longest arrow or force line, as a share of the larger dimension of the model.
const LONGEST: f64 = 0.05;
/// The largest displacement of a mechanism, likewise: as in its figure.
const MECHANISM: f64 = 0.05;
/// Radius of the circle that marks a hinge, likewise.
const HINGE: f64 = 0.004;

/// AutoCAD colour indices of the stress bands, from little to much.
const BANDS: [u8; 8] = [5, 4, 3, 2, 30, 1, 6, 12];
const GREY: u8 = 8;
const BLACK: u8 = 7;
const BROWN: u8 = 34;
const RED: u8 = 1;

/// The drawings that the picture has material for: `model.dxf`, `deformed.dxf` and `stress.dxf`. Displacements are drawn
/// `scale` times larger, or as much larger as in the figures.
pub fn drawings(picture: &Picture, scale: Option<f64>) -> Vec<File> {
    let all = [("model", Some(model(picture))), ("deformed", deformed(picture, scale)), ("stress", stress(picture))];
    let file = |(name, sheet): (&str, Option<Sheet>)| Some(File { name: format!("{name}.dxf"), bytes: sheet?.dxf() });
    all.into_iter().filter_map(file).collect()
}

/// The layer of a block by its role, and its colour.
fn role(shape: &Shape) -> (String, u8) {
    match (shape.held, shape.role.as_str()) {
        (true, "block") => ("SUPPORT".to_owned(), GREY),
        (true, role) => (role.to_uppercase(), GREY),
        (false, role) => (role.to_uppercase(), BLACK),
    }
}

fn size(picture: &Picture) -> f64 {
    as_built(&picture.shapes).map_or(1.0, |extent| extent.size()[0].max(extent.size()[1]))
}

fn outline(sheet: &mut Sheet, layer: &str, colour: u8, points: Vec<Point>) {
    sheet.layer(layer, colour);
    sheet.items.push(Item::Line { layer: layer.to_owned(), points, closed: true });
}

fn circle(sheet: &mut Sheet, layer: &str, colour: u8, centre: Point, radius: f64) {
    sheet.layer(layer, colour);
    sheet.items.push(Item::Circle { layer: layer.to_owned(), centre, radius });
}

fn line(sheet: &mut Sheet, layer: &str, colour: u8, points: Vec<Point>) {
    if points.len() > 1 {
        sheet.layer(layer, colour);
        sheet.items.push(Item::Line { layer: layer.to_owned(), points, closed: false });
    }
}

/// Blocks on layers of their roles, particles on one for each of their layers, the road surface, and the variable loads as arrows.
pub fn model(picture: &Picture) -> Sheet {
    let mut sheet = Sheet::default();
    for shape in &picture.shapes {
        let (layer, colour) = role(shape);
        outline(&mut sheet, &layer, colour, shape.outline.clone());
    }
    for disc in &picture.particles {
        circle(&mut sheet, &format!("PARTICLES-{}", disc.layer + 1), BROWN, disc.centre, disc.radius);
    }
    line(&mut sheet, "SURFACE", GREY, picture.surface.clone());
    let largest = picture.loads.iter().map(|load| load.force[0].hypot(load.force[1])).fold(0.0, f64::max);
    for load in picture.loads.iter().filter(|_| largest > 0.0) {
        let length = LONGEST * size(picture) / largest;
        let tail = [load.at[0] - length * load.force[0], load.at[1] - length * load.force[1]];
        line(&mut sheet, "LOADS", RED, arrow(tail, load.at));
    }
    sheet
}

/// A shaft and two barbs, as one line.
fn arrow(tail: Point, head: Point) -> Vec<Point> {
    let (dx, dy) = (0.15 * (tail[0] - head[0]), 0.15 * (tail[1] - head[1]));
    let barb = |side: f64| [head[0] + dx - side * 0.5 * dy, head[1] + dy + side * 0.5 * dx];
    vec![tail, head, barb(1.0), head, barb(-1.0)]
}

/// The model as built in grey, at the last stable load, and as it collapses, with its hinges. None where nothing is
/// known to move.
pub fn deformed(picture: &Picture, scale: Option<f64>) -> Option<Sheet> {
    let fits = |motions: &&[Motion]| motions.len() == picture.shapes.len();
    let stable = picture.last_stable.and_then(|k| picture.snapshots.get(k)).filter(|s| fits(&&s.motions[..]));
    let mechanism = picture.mechanism.as_deref().filter(fits);
    if stable.is_none() && mechanism.is_none() {
        return None;
    }
    let extent = as_built(&picture.shapes)?;
    let mut sheet = Sheet::default();
    for shape in &picture.shapes {
        outline(&mut sheet, "AS-BUILT", GREY, shape.outline.clone());
    }
    for disc in &picture.particles {
        circle(&mut sheet, &format!("AS-BUILT-PARTICLES-{}", disc.layer + 1), GREY, disc.centre, disc.radius);
    }
    // Limit analysis knows no displacements before collapse.
    let displaced = |state: &&Snapshot| largest_displacement(&picture.shapes, &state.motions, Turn::Finite) > 0.0;
    // A support that stays is drawn once, as built.
    let moves = |(shape, motion): &(&Shape, &Motion)| !shape.held || **motion != Motion::default();
    if let Some(state) = stable.filter(displaced) {
        let scale = scale.unwrap_or_else(|| exaggeration(picture, state, extent));
        let layer = format!("LAST-STABLE-X{scale}");
        for (shape, &motion) in picture.shapes.iter().zip(&state.motions).filter(moves) {
            outline(&mut sheet, &layer, 5, moved(shape, motion, scale, Turn::Finite));
        }
        for (disc, now) in picture.particles.iter().zip(&state.particles) {
            let centre = [0, 1].map(|k| disc.centre[k] + scale * (now.centre[k] - disc.centre[k]));
            circle(&mut sheet, &format!("{layer}-PARTICLES-{}", disc.layer + 1), 5, centre, disc.radius);
        }
    }
    if let Some(motions) = mechanism {
        let largest = largest_displacement(&picture.shapes, motions, Turn::Small);
        let scale = if largest > 0.0 { MECHANISM * size(picture) / largest } else { 0.0 };
        for (shape, &motion) in picture.shapes.iter().zip(motions).filter(moves) {
            outline(&mut sheet, "COLLAPSE", RED, moved(shape, motion, scale, Turn::Small));
        }
        for hinge in &picture.hinges {
            let Some(block) = block_at(&picture.shapes, hinge.point) else { continue };
            let centre = centroid(&picture.shapes[block].outline);
            let place = exaggerated(hinge.point, centre, motions[block], scale, Turn::Small);
            circle(&mut sheet, "HINGES", 6, place, HINGE * size(picture));
        }
    }
    Some(sheet)
}

/// The last stable state: blocks on a layer for each band of compressive stress, contact forces as lines as long as the
/// forces are large, and the line of thrust. None where no stresses are known.
pub fn stress(picture: &Picture) -> Option<Sheet> {
    let shown = picture.last_stable.or_else(|| picture.snapshots.len().checked_sub(1))?;
    let state = picture.snapshots.get(shown).filter(|s| s.stresses.len() == picture.shapes.len())?;
    let compression = |k: usize| most_compressive(state.stresses[k]) / 1e6;
    let free = || (0..picture.shapes.len()).filter(|&k| !picture.shapes[k].held);
    let largest = free().map(compression).filter(|s| s.is_finite()).fold(0.0, f64::max);
    let ticks = Ticks::over(0.0, if largest > 0.0 { largest } else { 1.0 }, 5);
    let mut sheet = Sheet::default();
    for shape in picture.shapes.iter().filter(|shape| shape.held) {
        outline(&mut sheet, &role(shape).0, GREY, shape.outline.clone());
    }
    for k in free() {
        // Blocks in tension all around belong to the lowest band.
        let above = ticks.values.iter().skip(1).take_while(|&&tick| compression(k) > tick).count();
        let band = above.min(ticks.values.len().saturating_sub(2));
        let (low, high) = (ticks.words(ticks.values[band]), ticks.words(ticks.values[band + 1]));
        let colour = BANDS[(band * BANDS.len() / ticks.values.len().saturating_sub(1).max(1)).min(BANDS.len() - 1)];
        outline(&mut sheet, &format!("STRESS-{low}-{high}-MPA"), colour, picture.shapes[k].outline.clone());
    }
    let force = |c: &ContactForce| {
        let tangent = [-c.normal[1], c.normal[0]];
        [0, 1].map(|k| c.compression * c.normal[k] + c.shear * tangent[k])
    };
    let strongest = state.contacts.iter().map(|c| force(c)[0].hypot(force(c)[1])).fold(0.0, f64::max);
    if strongest > 0.0 {
        let half = 0.5 * LONGEST * size(picture) / strongest;
        // The scale is read off the layer: how many kilonewtons a metre of line stands for.
        let layer =
            format!("CONTACT-FORCES-1M-IS-{}-KN", words::four_digits(strongest / 1e3 / (LONGEST * size(picture))));
        for c in &state.contacts {
            let [fx, fy] = force(c);
            let (dx, dy) = (half * fx, half * fy);
            let at = c.point;
            line(&mut sheet, &layer, BLACK, vec![[at[0] - dx, at[1] - dy], [at[0] + dx, at[1] + dy]]);
        }
    }
    for thrust in &picture.thrust_lines {
        line(&mut sheet, "THRUST-LINE", RED, thrust.iter().map(|p| p.point).collect());
    }
    Some(sheet)
}
