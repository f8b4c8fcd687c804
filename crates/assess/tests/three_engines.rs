//! One ring, three engines: limit analysis, discrete elements and finite elements on Bridgemill case 1 (`docs/verification/three-engines.md`).

use assess::analysis::{Collapse, Status, collapse_by_dem, collapse_by_fe, collapse_by_limit};
use assess::discretise::{Discretised, discretise};
use assess::outcome::Point;
use bridge::{Bridge, ContactPoints, JointStiffness};
use mechanics::limit::{self, thrust_zone};
use mechanics::plane::{Vec2, vec2};
use mechanics::watch::Unwatched;
use std::path::Path;

/// Limit load of the full ring [N/m].
const LIMIT: f64 = 231.46e3;

/// Bridgemill case 1 with contacts at the very edges of the ring and joints `stiffer` times as stiff, analysed with `springs` a joint.
fn ring(stiffer: f64, springs: usize) -> Bridge {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/bridgemill/case-1.toml");
    let read = bridge::read(&std::fs::read(file).expect("the example is there"));
    let mut b = read.bridge.expect("the example is sound");
    b.masonry.rounding = 0.0;
    b.joint.fixed_length = Some(0.5 * b.spans[0].rings[0].crown_thickness);
    for stiffness in [&mut b.joint.normal_stiffness, &mut b.joint.shear_stiffness] {
        if let Some(JointStiffness::Contact(k)) = stiffness {
            *k *= stiffer;
        }
    }
    b.plan.contact_points = ContactPoints::FullRing;
    b.service.mesh.ring_nodes = springs;
    b
}

fn fe(stiffer: f64, springs: usize) -> Collapse {
    collapse_by_fe(&ring(stiffer, springs), &mut Unwatched).expect("it can be set up")
}

/// The same, loaded to half the limit load and no further.
fn at_half(mut b: Bridge) -> Bridge {
    b.plan.load_step = Some(LIMIT / 20.0);
    b.plan.load_limit = Some(LIMIT / 2.0);
    b
}

/// Where a point lies in the joint that it is nearest to, on the ring as built: distance from the intrados [m] and the joint.
fn in_joint(d: &Discretised, joint: usize, at: Vec2) -> f64 {
    let [bed, back] = joint_line(d, joint);
    (at - bed).dot((back - bed).unit())
}

/// Intrados and extrados of a joint, counted from the left springing.
fn joint_line(d: &Discretised, joint: usize) -> [Vec2; 2] {
    let faces: Vec<_> = d.faces.iter().flatten().collect();
    match faces.get(joint) {
        Some(faces) => [faces.bed[0], faces.back[0]],
        None => [faces[joint - 1].bed[1], faces[joint - 1].back[1]],
    }
}

fn line(c: &Collapse) -> Vec<Vec2> {
    c.picture.thrust_lines[0].iter().map(|t| vec2(t.point[0], t.point[1])).collect()
}

fn heights(d: &Discretised, points: &[Vec2]) -> Vec<f64> {
    points.iter().enumerate().map(|(joint, at)| in_joint(d, joint, *at)).collect()
}

#[test]
fn probe() {
    for (k, n) in [(1.0, 2), (1.0, 7), (10.0, 7), (100.0, 2), (100.0, 3), (100.0, 7)] {
        let c = fe(k, n);
        let d = discretise(&ring(k, n)).unwrap();
        let h = heights(&d, &line(&c));
        println!("k {k} n {n}: {:?} {:.2} -> {:?}", c.status, c.last_stable_load.unwrap() / 1e3, c.collapse_load.map(|l| l / 1e3));
        println!("   {:?}", c.finite);
        println!("   {:?}", c.hinges.iter().map(|h| (h.point[0], h.edge)).collect::<Vec<_>>());
        println!("   0 {:.4} 15 {:.4} 39 {:.4} 62 {:.4}", h[0], 0.711 - h[15], h[39], 0.711 - h[62]);
        println!("   {:?}", h.iter().map(|x| (x * 1000.0).round() as i64).collect::<Vec<_>>());
    }
    let d = discretise(&ring(1.0, 2)).unwrap();
    let settings = limit::Settings { contact_points: limit::ContactPoints::FullRing, ..limit::Settings::default() };
    let zone = thrust_zone(&d.model, &d.loading, 0.5 * LIMIT / d.reference_load, &settings).unwrap();
    let l = collapse_by_limit(&ring(1.0, 2)).unwrap();
    println!("limit {:.3} {:?}", l.collapse_load.unwrap(), l.hinges);
    let dem = collapse_by_dem(&at_half(ring(1.0, 2)), None, &mut Unwatched).unwrap();
    let dh = heights(&d, &line(&dem));
    println!("{:?}", dem.status);
    for n in [2, 7, 13] {
        let f = collapse_by_fe(&at_half(ring(1.0, n)), &mut Unwatched).unwrap();
        let fh = heights(&d, &line(&f));
        let worst = fh.iter().zip(&dh).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        println!("n {n} {:?} {} worst {worst:.5}", f.status, f.last_stable_load.unwrap());
        println!("   {:?}", fh.iter().map(|x| (x * 1000.0).round() as i64).collect::<Vec<_>>());
    }
    println!("   {:?}", dh.iter().map(|x| (x * 1000.0).round() as i64).collect::<Vec<_>>());
    for (j, (r, i)) in zone.reach.iter().zip(&zone.interfaces).enumerate() { let [a, b] = r.unwrap(); print!("{}/{}:{:.3}..{:.3} ", i.first.0, i.second.0, in_joint(&d, 0, a).min(9.0), in_joint(&d, 0, b)); if j > 3 { break; } }
    let _: Option<(Point, Status)> = None;
}
