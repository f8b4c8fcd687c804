//! Stress in the fill and in the blocks, side by side in two scales.

use crate::bar::{Scale, quantile};
use crate::colour::{blue_for_much, red_for_much};
use crate::discs;
use crate::elevation as draw;
use crate::geometry::sides;
use crate::near::means;
use crate::panels::{coloured, load, panel, shown};
use crate::sheet::{MARGIN, Sheet, WIDTH};
use crate::stress::most_compressive;
use crate::words;
use outcome::picture::{Picture, Point, Snapshot};
use std::f64::consts::PI;

/// Stresses of particles are averaged over neighbours within so many mean diameters.
const REACH: f64 = 3.0;
/// A scale of colours ends where this share of its values lies below.
const SHARE: f64 = 0.99;

/// Mean stress and most compressive principal stress at the last stable load: particles averaged over their
/// neighbours, blocks each by itself. None without particles or stresses.
pub fn fill_stress(picture: &Picture) -> Option<String> {
    let at = shown(picture).filter(|_| discs::drawable(picture))?;
    let state = &picture.snapshots[at];
    let extent = draw::extent(picture).filter(|_| state.stresses.len() == picture.shapes.len())?;
    let radius = REACH * 2.0 * discs::mean_radius(picture);
    let share = solid_share(picture).unwrap_or(1.0);
    let fill = averaged(picture, state, radius, share);

    let second = format!("Stress in fill and masonry at {}, compression positive", load(picture, at));
    let (mut sheet, mut y) = Sheet::titled("fill-stress", &picture.title, &second);
    type Measure = fn([f64; 3]) -> f64;
    let kinds: [(&str, &str, Measure); 2] =
        [("a", "mean stress", mean_compression), ("b", "most compressive principal stress", most_compressive)];
    for (letter, name, measure) in kinds {
        let of_fill: Vec<f64> = fill.iter().map(|&s| measure(s) / 1e3).collect();
        let of_blocks: Vec<f64> = state.stresses.iter().map(|&s| measure(s) / 1e6).collect();
        let free = of_blocks.iter().zip(&picture.shapes).filter(|(_, shape)| !shape.held).map(|(s, _)| *s);
        let soil = scale("fill [kPa]", of_fill.iter().copied(), blue_for_much);
        let stone = scale("masonry [MPa]", free, red_for_much);
        y = panel(&mut sheet, extent, y, &format!("panel-{letter}"), &format!("({letter}) {name}"), |sheet, view| {
            discs::draw(sheet, view, picture, Some(state), |p| soil.of(of_fill[p]).into());
            let width = draw::outline_width(&picture.shapes, view);
            coloured(sheet, view, picture, state, width, |k| stone.of(of_blocks[k]));
        });
        let middle = 0.5 * WIDTH;
        soil.draw(&mut sheet, MARGIN, middle - 10.0, y - 4.0);
        y = stone.draw(&mut sheet, middle + 10.0, WIDTH - MARGIN, y - 4.0) + 14.0;
    }
    let caption = format!(
        "Fill: the stress of a particle times the share of the region that particles cover ({:.3}), which is the stress of the soil with its voids, averaged by area over all particles within {} (three mean diameters). Masonry: average of each block, not smoothed. Values above the end of a scale ({} of a hundred, at most) take its last colour.",
        share,
        words::metres(radius),
        words::three_digits(100.0 * (1.0 - SHARE)),
    );
    Some(sheet.end(y - 4.0, &caption))
}

/// Mean of the principal stresses in the plane [Pa], compression positive.
fn mean_compression([xx, yy, _]: [f64; 3]) -> f64 {
    // Adding zero takes the sign off a negative zero.
    -0.5 * (xx + yy) + 0.0
}

/// From zero to what nearly all values stay below.
fn scale(title: &'static str, values: impl Iterator<Item = f64> + Clone, colour: fn(f64) -> String) -> Scale<'static> {
    let end = quantile(values.clone(), SHARE);
    let largest = values.filter(|v| v.is_finite()).fold(0.0, f64::max);
    Scale::upto(title, [end, largest], 5, colour)
}

/// Share of the region that particles cover as packed; none where the region is not known.
fn solid_share(picture: &Picture) -> Option<f64> {
    let region: f64 = 0.5 * sides(&picture.fill).map(|[a, b]| a[0] * b[1] - a[1] * b[0]).sum::<f64>();
    let solid: f64 = picture.particles.iter().map(|d| PI * d.radius * d.radius).sum();
    (region > 0.0).then(|| solid / region)
}

/// Stress of the soil at each particle [Pa], tension positive.
fn averaged(picture: &Picture, state: &Snapshot, radius: f64, share: f64) -> Vec<[f64; 3]> {
    let places: Vec<Point> = state.particles.iter().map(|p| p.centre).collect();
    let areas: Vec<f64> = picture.particles.iter().map(|d| PI * d.radius * d.radius).collect();
    let values: Vec<[f64; 3]> = state.particles.iter().map(|p| p.stress.map(|s| share * s)).collect();
    means(&places, &areas, &values, radius)
}

#[cfg(test)]
mod tests {
    use super::*;
    use outcome::picture::{Disc, DiscState};

    #[test]
    fn even_stress_stays_even_and_voids_share_it() {
        let at = |k: usize| [0.2 * (k % 10) as f64, 0.2 * (k / 10) as f64];
        let particles: Vec<Disc> = (0..100).map(|k| Disc { centre: at(k), radius: 0.1, layer: 0 }).collect();
        let states = (0..100).map(|k| DiscState { centre: at(k), stress: [-1e3, -4e3, 0.0], ..DiscState::default() });
        let fill = vec![[-0.1, -0.1], [1.9, -0.1], [1.9, 1.9], [-0.1, 1.9]];
        let picture = Picture { particles, fill, ..Picture::default() };
        let state = Snapshot { particles: states.collect(), ..Snapshot::default() };
        // Discs on a square grid cover pi/4 of it.
        let share = solid_share(&picture).unwrap();
        assert!((share - 0.25 * PI).abs() < 1e-12);
        for s in averaged(&picture, &state, 0.6, share) {
            assert!(
                (mean_compression(s) - share * 2.5e3).abs() < 1e-9 && (most_compressive(s) - share * 4e3).abs() < 1e-9
            );
        }
    }
}
