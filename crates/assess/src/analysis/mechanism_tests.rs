//! What a mechanism and a fall under self-weight look like by every method of rigid or elastic blocks.

use super::*;
use crate::samples;
use bridge::{JointStiffness, Ring, Span};
use mechanics::watch::Unwatched;
use outcome::collapse::Status;
use outcome::picture::{Motion, Point, Shape};

/// A short ring that any method makes collapse in a moment.
fn short(method: Method, thickness: f64) -> Bridge {
    let mut b = samples::bridgemill();
    let ring = Ring { crown_thickness: thickness, springing_thickness: thickness, voussoirs: 15 };
    b.spans[0] = Span { span: 5.0, rise: 1.25, rings: vec![ring], ..b.spans[0].clone() };
    b.loads[0].position = 1.25;
    b.masonry.rounding = 0.002;
    b.dispersal.rule = bridge::DispersalRule::Uniform;
    for joint in [&mut b.joint, &mut b.ring_joint] {
        joint.normal_stiffness = Some(JointStiffness::Contact(40e9));
        joint.shear_stiffness = Some(JointStiffness::Contact(15e9));
        (joint.fixed_length, joint.least_length) = (None, None);
    }
    (b.plan.load_step, b.plan.load_limit, b.plan.method) = (None, None, method);
    b
}

/// The middle of a shape's corners: near enough to its centroid for a sign.
fn middle(shape: &Shape) -> Point {
    let n = shape.outline.len() as f64;
    let sum = shape.outline.iter().fold([0.0, 0.0], |sum, p| [sum[0] + p[0], sum[1] + p[1]]);
    [sum[0] / n, sum[1] / n]
}

/// How a point of a shape moves.
fn moves(shape: &Shape, motion: &Motion, at: Point) -> Point {
    let [x, y] = middle(shape);
    [motion.translation[0] - motion.rotation * (at[1] - y), motion.translation[1] + motion.rotation * (at[0] - x)]
}

/// The load that makes a bridge fall does work on the motion that is drawn: the loaded haunch sinks, whichever side it is on.
#[test]
fn the_load_does_work_on_its_mechanism() {
    for method in [Method::Limit, Method::Dem, Method::Path, Method::Fe] {
        for position in [1.25, 3.75] {
            let mut b = short(method, 0.4);
            b.loads[0].position = position;
            let c = collapse(&b, None, &mut Unwatched).unwrap();
            assert_eq!(c.status, Status::Collapsed, "{method:?}");
            let motions = c.picture.mechanism.as_ref().unwrap();
            assert!(!c.picture.loads.is_empty());
            let work: f64 = (c.picture.loads.iter())
                .map(|arrow| {
                    let far = |shape: &Shape| (middle(shape)[0] - arrow.at[0]).hypot(middle(shape)[1] - arrow.at[1]);
                    let near = (0..motions.len())
                        .min_by(|&a, &b| far(&c.picture.shapes[a]).total_cmp(&far(&c.picture.shapes[b])));
                    let near = near.unwrap();
                    let [x, y] = moves(&c.picture.shapes[near], &motions[near], arrow.at);
                    arrow.force[0] * x + arrow.force[1] * y
                })
                .sum();
            let force: f64 = c.picture.loads.iter().map(|arrow| arrow.force[0].hypot(arrow.force[1])).sum();
            assert!(work > 0.05 * force, "{method:?} at {position}: {work} of {force}");
        }
    }
}

/// A ring too thin for its own weight is told so by every method, without a load step or limit of the file.
#[test]
fn a_ring_that_does_not_stand_is_told_so() {
    for method in [Method::Limit, Method::Dem, Method::Path, Method::Fe] {
        let mut b = short(method, 0.12);
        (b.spans[0].rise, b.spans[0].profile, b.cover.depth) = (2.5, bridge::ring::Profile::Semicircular, 0.0);
        b.cover.layers.clear();
        let c = collapse(&b, None, &mut Unwatched).unwrap();
        assert_eq!(c.status, Status::UnstableUnderSelfWeight, "{method:?}");
        assert_eq!((c.collapse_load, c.last_stable_load), (None, None), "{method:?}");
    }
}
