//! The linear stiffness system of the contacts: its largest and smallest frequency.
//!
//! Each closed point is a normal and a shear spring between two bodies; the matrix is never formed. The largest
//! eigenvalue of the mass-scaled system bounds the time step (Bathe 1982), the smallest sets viscous damping.

use super::model::Model;
use super::state::State;

/// One spring: the work-conjugate displacement of a body motion is `row . motion`.
struct Spring {
    one: usize,
    two: usize,
    /// Rows scaled by the square roots of stiffness and inverse mass.
    row_one: [f64; 3],
    row_two: [f64; 3],
}

/// Springs of all points of close pairs, or only of those that touch.
fn springs(model: &Model, state: &State, touching_only: bool) -> Vec<Spring> {
    let mut springs = Vec::new();
    for t in &state.touches {
        let (one, two) = (t.one as usize, t.two as usize);
        let (p1, p2) = (&state.poses[one], &state.poses[two]);
        let points = t.points(p1, p2);
        for k in 0..t.count as usize {
            if touching_only && points.overlap[k] < -1e-6 * model.block_size {
                continue;
            }
            let at = points.at(k, p1.position);
            let (a1, a2) = (at - p1.position, at - p2.position);
            for (direction, stiffness) in [(points.normal(), t.normal_stiffness), (points.direction, t.shear_stiffness)]
            {
                let root = (stiffness * t.memory[k].length.max(t.half_joint)).sqrt();
                let scaled = |sign: f64, arm: f64, i: usize| {
                    let m = &model.inverse_mass[i];
                    [
                        sign * direction.x * root * m[0].sqrt(),
                        sign * direction.y * root * m[1].sqrt(),
                        sign * arm * root * m[2].sqrt(),
                    ]
                };
                springs.push(Spring {
                    one,
                    two,
                    row_one: scaled(-1.0, a1.cross(direction), one),
                    row_two: scaled(1.0, a2.cross(direction), two),
                });
            }
        }
    }
    springs
}

fn apply(springs: &[Spring], x: &[[f64; 3]], y: &mut [[f64; 3]]) {
    y.fill([0.0; 3]);
    let dot = |a: &[f64; 3], b: &[f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    for s in springs {
        let stretch = dot(&s.row_one, &x[s.one]) + dot(&s.row_two, &x[s.two]);
        for c in 0..3 {
            y[s.one][c] += s.row_one[c] * stretch;
            y[s.two][c] += s.row_two[c] * stretch;
        }
    }
}

fn inner(a: &[[f64; 3]], b: &[[f64; 3]]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a[0] * b[0] + a[1] * b[1] + a[2] * b[2]).sum()
}

/// A start vector without symmetry, the same in every run.
fn start_vector(model: &Model) -> Vec<[f64; 3]> {
    let mut seed: u64 = 0x9E37_79B9_7F4A_7C15;
    (0..model.len())
        .map(|i| {
            std::array::from_fn(|c| {
                seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                let unit = (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5;
                if model.inverse_mass[i][c] > 0.0 { unit } else { 0.0 }
            })
        })
        .collect()
}

/// Largest angular frequency [rad/s] with every near point closed, by power iteration to a relative change of 1e-6
/// (at most 2,000 products); raised by one percent because power iteration approaches it from below.
pub(super) fn largest_frequency(model: &Model, state: &State) -> f64 {
    let springs = springs(model, state, false);
    let mut x = start_vector(model);
    let mut y = x.clone();
    let mut eigenvalue = 0.0;
    for _ in 0..2_000 {
        let norm = inner(&x, &x).sqrt();
        if norm == 0.0 {
            return 0.0;
        }
        for v in &mut x {
            v.iter_mut().for_each(|c| *c /= norm);
        }
        apply(&springs, &x, &mut y);
        let next = inner(&x, &y);
        std::mem::swap(&mut x, &mut y);
        let settled = (next - eigenvalue).abs() <= 1e-6 * next;
        eigenvalue = next;
        if settled {
            break;
        }
    }
    1.01 * eigenvalue.max(0.0).sqrt()
}

/// Smallest angular frequency [rad/s] of the contacts that touch, by inverse iteration with conjugate gradients. An
/// estimate is enough: it sets a damping coefficient.
pub(super) fn smallest_frequency(model: &Model, state: &State) -> f64 {
    let springs = springs(model, state, true);
    let mut x = start_vector(model);
    let mut eigenvalue = 0.0;
    for _ in 0..8 {
        let norm = inner(&x, &x).sqrt();
        if !(norm > 0.0 && norm.is_finite()) {
            break;
        }
        for v in &mut x {
            v.iter_mut().for_each(|c| *c /= norm);
        }
        let z = conjugate_gradients(&springs, &x, 20 * model.len() + 100);
        let zz = inner(&z, &z);
        if !(zz > 0.0) {
            break;
        }
        eigenvalue = inner(&z, &x) / zz;
        x = z;
    }
    eigenvalue.max(0.0).sqrt()
}

fn conjugate_gradients(springs: &[Spring], b: &[[f64; 3]], most: usize) -> Vec<[f64; 3]> {
    let mut x = vec![[0.0; 3]; b.len()];
    let mut r = b.to_vec();
    let mut p = r.clone();
    let mut q = r.clone();
    let mut rr = inner(&r, &r);
    let target = 1e-16 * rr;
    for _ in 0..most {
        apply(springs, &p, &mut q);
        let pq = inner(&p, &q);
        if !(pq > 0.0) || rr <= target {
            break;
        }
        let step = rr / pq;
        for i in 0..b.len() {
            for c in 0..3 {
                x[i][c] += step * p[i][c];
                r[i][c] -= step * q[i][c];
            }
        }
        let next = inner(&r, &r);
        let ratio = next / rr;
        rr = next;
        for i in 0..b.len() {
            for c in 0..3 {
                p[i][c] = r[i][c] + ratio * p[i][c];
            }
        }
    }
    x
}

/// Critical time step of the stiffest single body on all its springs, the others held [s]: `2 sqrt(m / k)` over the
/// three motions of every block (after Morikawa and others 1993). Not a bound; the eigenvalue is.
pub(super) fn single_mass_time_step(model: &Model, state: &State) -> f64 {
    let springs = springs(model, state, false);
    let mut sums = vec![[0.0; 3]; model.len()];
    for s in &springs {
        for c in 0..3 {
            sums[s.one][c] += s.row_one[c] * s.row_one[c];
            sums[s.two][c] += s.row_two[c] * s.row_two[c];
        }
    }
    let largest = sums.iter().flatten().copied().fold(0.0, f64::max);
    if largest > 0.0 { 2.0 / largest.sqrt() } else { f64::INFINITY }
}
