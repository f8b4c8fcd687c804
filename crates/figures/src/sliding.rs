//! Joints that slide: a pair of arrows along the joint, each on its own block and in the sense of its motion.

use crate::elevation::SLIDING;
use crate::geometry::{Extent, Turn, View, centroid, displacement, distance, exaggerated, sides};
use crate::sheet::{Area, Pen, Sheet};
use outcome::picture::{Motion, Point, Shape};

/// Blocks within this share of their own smaller dimension touch a point.
const NEAR: f64 = 0.05;
/// More sliding joints than this are many.
const MANY: usize = 12;

/// Marks the joints of a mechanism that slide at `points`.
pub(crate) fn mark(sheet: &mut Sheet, shapes: &[Shape], motions: &[Motion], points: &[Point], view: &View, scale: f64) {
    // Many arrows are drawn small, or they would hide the blocks.
    let size = if points.len() > MANY { 0.6 } else { 1.0 };
    sheet.open("sliding-joints");
    for &point in points {
        let Some(slide) = slide(shapes, motions, point) else { continue };
        let place = |k: usize| exaggerated(point, centroid(&shapes[k].outline), motions[k], scale, Turn::Small);
        let (p, q) = (view.spot(place(slide.blocks[0])), view.spot(place(slide.blocks[1])));
        let at = [0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])];
        let along = [slide.along[0], -slide.along[1]];
        let across = [-along[1], along[0]];
        let c = view.spot(centroid(&shapes[slide.blocks[1]].outline));
        let b = view.spot(point);
        let side = if (c[0] - b[0]) * across[0] + (c[1] - b[1]) * across[1] < 0.0 { -1.0 } else { 1.0 };
        // The second block moves along, the first one against.
        for sense in [1.0, -1.0] {
            let offset = |by: f64| {
                let (t, n) = (sense * by, sense * side * 3.4 * size);
                [at[0] + t * along[0] + n * across[0], at[1] + t * along[1] + n * across[1]]
            };
            sheet.arrow(offset(-8.0 * size), offset(8.0 * size), Pen::line(SLIDING, 1.5 * size).class("sliding"));
        }
        sheet.avoid(Area::about(at, 9.0));
    }
    sheet.close();
}

struct Slide {
    blocks: [usize; 2],
    along: Point,
}

/// The two blocks at a point that move most against each other along a common edge, and that edge's direction in
/// the sense in which the second slides on the first.
fn slide(shapes: &[Shape], motions: &[Motion], point: Point) -> Option<Slide> {
    let reach = |s: &Shape| {
        let [w, h] = Extent::of(s.outline.iter().copied()).map_or([0.0, 0.0], |e| e.size());
        NEAR * w.min(h)
    };
    let near: Vec<usize> = (0..shapes.len().min(motions.len()))
        .filter(|&k| distance(point, &shapes[k].outline) <= reach(&shapes[k]))
        .collect();
    let mut best: Option<(f64, Slide)> = None;
    for (n, &a) in near.iter().enumerate() {
        for &b in &near[n + 1..] {
            let of = |k: usize| displacement(point, centroid(&shapes[k].outline), motions[k], Turn::Small);
            let (u, v) = (of(a), of(b));
            let relative = [v[0] - u[0], v[1] - u[1]];
            for k in [a, b] {
                for [p, q] in sides(&shapes[k].outline) {
                    let length = (q[0] - p[0]).hypot(q[1] - p[1]);
                    if length == 0.0 || distance(point, &[p, q]) > reach(&shapes[k]) {
                        continue;
                    }
                    let unit = [(q[0] - p[0]) / length, (q[1] - p[1]) / length];
                    let slip = relative[0] * unit[0] + relative[1] * unit[1];
                    if best.as_ref().is_none_or(|b| slip.abs() > b.0 * (1.0 + 1e-9)) {
                        let along = unit.map(|c| c * if slip < 0.0 { -1.0 } else { 1.0 });
                        best = Some((slip.abs(), Slide { blocks: [a, b], along }));
                    }
                }
            }
        }
    }
    best.map(|b| b.1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrows_follow_the_joint_and_the_sense_of_the_motion_in_spite_of_dilation() {
        let rectangle = |l: f64, r: f64, b: f64, t: f64| Shape {
            outline: vec![[l, b], [r, b], [r, t], [l, t]],
            role: "block".into(),
            held: false,
        };
        let shapes = [rectangle(0.0, 1.0, 0.0, 0.5), rectangle(0.0, 1.0, 0.5, 1.0)];
        // Friction of 35 degrees lifts the upper block while it slides to the left.
        let lift = 35f64.to_radians().tan();
        let motions = [Motion::default(), Motion { translation: [-1.0, lift], rotation: 0.0 }];
        let found = slide(&shapes, &motions, [0.98, 0.5]).unwrap();
        assert_eq!(found.blocks, [0, 1]);
        assert!((found.along[0] + 1.0).abs() < 1e-12 && found.along[1].abs() < 1e-12);
        assert!(slide(&shapes, &motions, [5.0, 5.0]).is_none());
    }
}
