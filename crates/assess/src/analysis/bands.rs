//! Layers of the cover and backing as areas of the elevation, with their depths in words.

use super::geometry::point;
use bridge::{BackingBody, Bridge, Void};
use mechanics::plane::Vec2;
use outcome::picture::{Band, Point};
use structure::discretise::cover::Surface;
use structure::discretise::extrados::Extrados;
use structure::discretise::{Discretised, cover};

/// Layers that are weight alone, and backing that is: particles, slabs and blocks are drawn as what they are. Backing comes last,
/// to lie over the fill.
pub(super) fn bands(bridge: &Bridge, d: &Discretised) -> Vec<Band> {
    let line = line(&d.extrados);
    let (Some(&first), Some(&last)) = (line.first(), line.last()) else { return Vec::new() };
    let tops = cover::tops(bridge, &d.extrados);
    let mut found = Vec::new();
    for (k, layer) in bridge.cover.layers.iter().enumerate() {
        if d.fill.is_some() && (layer.particles || layer.slabs.is_some()) {
            continue;
        }
        let outlines = match k.checked_sub(1) {
            None => below(&line, &tops[0]),
            Some(under) => {
                let [low, high] = [under, k].map(|k| tops[k].line(first.x, last.x));
                vec![low.into_iter().chain(high.into_iter().rev()).map(point).collect()]
            }
        };
        let over = match (k, &bridge.cover.road) {
            (0, Some(_)) => "over the crown, at least",
            (0, None) => "over the crown",
            _ => "thick",
        };
        let size = format!("{} m {over}", decimals(layer.thickness));
        found.push(Band { name: layer.name.word().to_string(), size, outlines });
    }
    if let Some(walls) = &bridge.cover.internal_walls {
        let share = 100.0 * walls.share;
        let size = format!("{share:.0} % of the width, to {} m above the springings", decimals(walls.height));
        let outlines = below(&line, &cover::above_springings(bridge, walls.height));
        found.push(Band { name: "internal walls".to_string(), size, outlines });
    }
    let band = |body| match body {
        BackingBody::Weight | BackingBody::Continuum => true,
        BackingBody::Particles => d.fill.is_none(),
        BackingBody::Blocks => false,
    };
    if let Some(backing) = bridge.cover.backing.filter(|b| band(b.body)) {
        let size = format!("to {} m above the springings", decimals(backing.height));
        found.push(Band {
            name: "backing".to_string(),
            size,
            outlines: below(&line, &cover::above_springings(bridge, backing.height)),
        });
    }
    for (k, void) in d.extrados.voids.iter().enumerate() {
        let [left, right] = void.carried_to.map(decimals);
        let size = format!("carried to {left} m and {right} m");
        let outlines = below(&over_floor(&line, void), &Surface::level(void.levels[1]));
        found.push(Band { name: format!("void {}", k + 1), size, outlines });
    }
    found.retain(|band| !band.outlines.is_empty());
    found
}

/// A length [m] to the millimetre, without trailing zeros.
fn decimals(x: f64) -> String {
    let text = format!("{x:.3}");
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}

/// The extrados from left to right, tops of piers and abutments among it.
fn line(extrados: &Extrados) -> Vec<Vec2> {
    let mut points: Vec<Vec2> = Vec::new();
    for p in extrados.stretches.iter().flat_map(|s| [s.left, s.right]) {
        if points.last().is_none_or(|last| (p - *last).norm() > 1e-9) {
            points.push(p);
        }
    }
    points
}

/// The floor of a void from end to end: its own level, or the extrados where that is higher.
fn over_floor(line: &[Vec2], void: &Void) -> Vec<Vec2> {
    let ([from, to], floor) = (void.range, void.levels[0]);
    let mut points: Vec<Vec2> = Vec::new();
    for pair in line.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        if b.x <= from || a.x >= to || b.x <= a.x {
            continue;
        }
        let at = |x: f64| a + (b - a) * ((x - a.x) / (b.x - a.x));
        let mut corners = vec![at(a.x.max(from)), at(b.x.min(to))];
        if (a.y - floor) * (b.y - floor) < 0.0 {
            let crossed = a + (b - a) * ((floor - a.y) / (b.y - a.y));
            if crossed.x > from && crossed.x < to {
                corners.insert(1, crossed);
            }
        }
        points.extend(corners.into_iter().map(|p| Vec2 { x: p.x, y: p.y.max(floor) }));
    }
    points.dedup_by(|a, b| (*a - *b).norm() < 1e-9);
    points
}

/// Areas between the line and a face above it, from left to right.
fn below(line: &[Vec2], face: &Surface) -> Vec<Vec<Point>> {
    let mut areas = Vec::new();
    let mut run: Vec<Vec2> = Vec::new();
    let mut finish = |run: &mut Vec<Vec2>| {
        if let [first, .., last] = run[..] {
            let lid = face.line(first.x, last.x).into_iter().rev();
            let mut outline: Vec<Point> = run.iter().copied().chain(lid).map(point).collect();
            outline.dedup_by(|a, b| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-9);
            areas.push(outline);
        }
        run.clear();
    };
    let mut before: Option<Vec2> = None;
    for p in with_kinks(line, face) {
        let level = face.at(p.x);
        if let Some(q) = before.filter(|q| (q.y - face.at(q.x)) * (p.y - level) < 0.0) {
            let from = face.at(q.x);
            run.push(q + (p - q) * ((from - q.y) / (p.y - q.y - (level - from))));
        }
        if p.y < level {
            run.push(p);
        } else {
            finish(&mut run);
        }
        before = Some(p);
    }
    finish(&mut run);
    areas
}

/// A line with corners also where the gradient of a face changes.
fn with_kinks(line: &[Vec2], face: &Surface) -> Vec<Vec2> {
    let mut points: Vec<Vec2> = line.first().copied().into_iter().collect();
    for pair in line.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        points.extend(face.kinks(a.x, b.x).map(|x| a + (b - a) * ((x - a.x) / (b.x - a.x))));
        points.push(b);
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use mechanics::plane::vec2;

    fn area(outline: &[Point]) -> f64 {
        let n = outline.len();
        let cross = |a: Point, b: Point| a[0] * b[1] - a[1] * b[0];
        (0..n).map(|k| 0.5 * cross(outline[k], outline[(k + 1) % n])).sum()
    }

    /// A void over a triangular back: the rectangle less the part of the back above its floor.
    #[test]
    fn a_void_is_drawn_over_the_back() {
        let line = [vec2(0.0, 0.0), vec2(2.0, 2.0), vec2(4.0, 0.0)];
        let void = Void { range: [0.5, 3.5], levels: [1.0, 3.0], carried_to: [0.5, 3.5] };
        let areas = below(&over_floor(&line, &void), &Surface::level(3.0));
        assert_eq!(areas.len(), 1);
        assert!((area(&areas[0]) - (3.0 * 2.0 - 1.0)).abs() < 1e-12, "{areas:?}");
    }

    /// A triangular back of height 2 over a base of 4, between flat ends of length 1.
    #[test]
    fn a_level_cuts_the_back_in_two_parts_of_the_same_area() {
        let line = [vec2(-1.0, 0.0), vec2(0.0, 0.0), vec2(2.0, 2.0), vec2(4.0, 0.0), vec2(5.0, 0.0)];
        let areas = below(&line, &Surface::level(1.0));
        assert_eq!(areas.len(), 2);
        // Each: a square beside the springing and half a square over the haunch.
        areas.iter().for_each(|outline| assert!((area(outline) - 1.5).abs() < 1e-12, "{outline:?}"));
        let over = below(&line, &Surface::level(3.0));
        assert_eq!(over.len(), 1);
        assert!((area(&over[0]) - (6.0 * 3.0 - 4.0)).abs() < 1e-12);
        assert!(below(&line, &Surface::level(-0.5)).is_empty());
    }
}
