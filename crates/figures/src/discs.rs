//! Particles as discs, coloured by layer.

use crate::chart::Key;
use crate::elevation::INK;
use crate::geometry::View;
use crate::sheet::{Area, HAIR, Pen, Sheet, Spot};
use outcome::picture::{Picture, Point, Snapshot};
use outcome::warning::Command;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// More particles than this are not drawn: the files would be too large to be opened by what shows drawings.
pub(crate) const MOST: usize = 200_000;
/// From so many particles on they are drawn as dots without outline, which keeps files small.
const MANY: usize = 5_000;
/// Radii of dots are rounded to this on the sheet, a fiftieth of a millimetre on paper.
const STEP: f64 = 0.1;
/// Discs smaller than this on the sheet have no outline, which would hide their colour.
const OUTLINED: f64 = 1.4;
/// Outline of a particle.
const RIM: &str = "#6b5f4d";
/// Colours of the layers from the extrados up: sand, stone, asphalt, and again; each with a second tone for bands.
const LAYERS: [[&str; 2]; 4] =
    [["#e3c898", "#c9a469"], ["#b9c4b0", "#95a48b"], ["#8f98a3", "#6f7985"], ["#d3b0a8", "#b58b82"]];
/// Width of the bands that show how the fill deforms [m].
pub(crate) const BAND: f64 = 1.0;

/// Whether there are particles, and not too many to be drawn.
pub(crate) fn drawable(picture: &Picture) -> bool {
    (1..=MOST).contains(&picture.particles.len())
}

/// What is not drawn, and why; nothing where all is.
pub fn left_out(picture: &Picture) -> Option<Command> {
    let particles = picture.particles.len();
    (particles > MOST).then_some(Command::NotDrawn { particles, most: MOST })
}

/// The colour of a particle in bands that were upright when the fill was packed.
pub(crate) fn band_colour(picture: &Picture, particle: usize) -> &'static str {
    let disc = &picture.particles[particle];
    let band = (disc.centre[0] / BAND).floor().rem_euclid(2.0) as usize;
    LAYERS[disc.layer % LAYERS.len()][band.min(1)]
}

/// Draws every particle where it is in a state, or as packed, in a colour.
pub(crate) fn draw<'c>(
    sheet: &mut Sheet,
    view: &View,
    picture: &Picture,
    state: Option<&Snapshot>,
    colour: impl Fn(usize) -> Cow<'c, str>,
) {
    if !drawable(picture) {
        return;
    }
    if picture.particles.len() > MANY {
        return dots(sheet, view, picture, state, colour);
    }
    let mean = mean_radius(picture) * view.scale;
    let rim = if mean < OUTLINED { Pen::line("none", 0.0) } else { Pen::line(RIM, (0.06 * mean).clamp(0.15, 0.5)) };
    sheet.open_drawn("particles", rim);
    for (k, disc) in picture.particles.iter().enumerate() {
        sheet.disc(view.spot(place(picture, state, k)), disc.radius * view.scale, &colour(k));
    }
    sheet.close();
}

/// Draws every particle as a dot, those of one colour and size together.
fn dots<'c>(
    sheet: &mut Sheet,
    view: &View,
    picture: &Picture,
    state: Option<&Snapshot>,
    colour: impl Fn(usize) -> Cow<'c, str>,
) {
    let mut alike: BTreeMap<(Cow<'c, str>, u64), Vec<Spot>> = BTreeMap::new();
    for (k, disc) in picture.particles.iter().enumerate() {
        let steps = (disc.radius * view.scale / STEP).round().max(1.0) as u64;
        alike.entry((colour(k), steps)).or_default().push(view.spot(place(picture, state, k)));
    }
    sheet.open("particles");
    for ((colour, steps), spots) in &alike {
        sheet.dots(spots, *steps as f64 * STEP, colour);
    }
    sheet.close();
}

/// Draws every particle as packed or where a state has it, coloured by layer.
pub(crate) fn by_layer(sheet: &mut Sheet, view: &View, picture: &Picture, state: Option<&Snapshot>) {
    draw(sheet, view, picture, state, |k| LAYERS[picture.particles[k].layer % LAYERS.len()][0].into());
}

/// Pale particles behind something.
pub(crate) fn pale(sheet: &mut Sheet, view: &View, picture: &Picture, state: Option<&Snapshot>) {
    if picture.particles.len() > MANY && drawable(picture) {
        dots(sheet, view, picture, state, |_| "#efece4".into());
    } else if drawable(picture) {
        sheet.open_drawn("pale-particles", Pen::line("#d5d0c6", 0.3));
        for (k, disc) in picture.particles.iter().enumerate() {
            sheet.disc(view.spot(place(picture, state, k)), disc.radius * view.scale, "#faf8f4");
        }
        sheet.close();
    }
}

/// Where a particle is in a state, or as packed.
pub(crate) fn place(picture: &Picture, state: Option<&Snapshot>, particle: usize) -> Point {
    state.and_then(|s| s.particles.get(particle)).map_or(picture.particles[particle].centre, |now| now.centre)
}

/// Mean radius [m].
pub(crate) fn mean_radius(picture: &Picture) -> f64 {
    picture.particles.iter().map(|d| d.radius).sum::<f64>() / picture.particles.len().max(1) as f64
}

/// Layers that have particles, each with its name.
fn layers(picture: &Picture) -> Vec<(usize, String)> {
    let last = picture.particles.iter().map(|d| d.layer).max().unwrap_or(0).min(64);
    let used = (0..=last).filter(|&layer| picture.particles.iter().any(|d| d.layer == layer));
    let named = used.map(|layer| {
        let count = picture.particles.iter().filter(|d| d.layer == layer).count();
        let name = picture.layers.get(layer).map_or("fill", |name| name);
        (layer, format!("{name} ({count} particles)"))
    });
    named.collect()
}

/// A row of layers with their colours; returns the y below it.
pub(crate) fn key(sheet: &mut Sheet, top: f64, picture: &Picture, banded: bool) -> f64 {
    if !drawable(picture) {
        return top;
    }
    Key { class: "layers", ..Key::ELEVATION }.draw(sheet, top, layers(picture), |sheet, [x, y], layer| {
        let [first, second] = LAYERS[layer % LAYERS.len()];
        let swatch = |a: f64, b: f64| Area { left: x + a, right: x + b, top: y - 9.0, bottom: y + 1.0 };
        sheet.rectangle(swatch(1.0, 21.0), Pen::shape(first, INK, HAIR));
        if banded {
            sheet.rectangle(swatch(11.0, 21.0), Pen::shape(second, INK, HAIR));
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use outcome::picture::Disc;

    #[test]
    fn too_many_particles_are_told_and_not_drawn() {
        let disc = Disc { centre: [0.0, 0.0], radius: 0.1, layer: 0 };
        let picture = Picture { particles: vec![disc; MOST + 1], ..Picture::default() };
        assert!(!drawable(&picture));
        assert_eq!(left_out(&picture), Some(Command::NotDrawn { particles: 200_001, most: MOST }));
        let few = Picture { particles: picture.particles[..5].to_vec(), ..Picture::default() };
        assert!(drawable(&few) && left_out(&few).is_none());
    }

    #[test]
    fn bands_alternate_every_metre() {
        let at = |x: f64| Disc { centre: [x, 0.0], radius: 0.1, layer: 1 };
        let picture = Picture { particles: vec![at(-0.5), at(0.5), at(1.5)], ..Picture::default() };
        assert_eq!(band_colour(&picture, 0), band_colour(&picture, 2));
        assert_ne!(band_colour(&picture, 0), band_colour(&picture, 1));
    }
}
