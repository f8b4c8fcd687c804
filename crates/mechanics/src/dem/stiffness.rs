//! The linear stiffness system of the contacts: its largest and smallest frequency.
//!
//! Each closed point is a normal and a shear spring between two bodies; the matrix is never formed. The largest
//! eigenvalue of the mass-scaled system bounds the time step (Bathe 1982), the smallest sets viscous damping.

use super::model::Model;
use super::particles::Disc;
use super::state::State;
use crate::plane::Vec2;

/// One spring: the work-conjugate displacement of a body motion is `row . motion`. Bodies are counted blocks first,
/// then particles; the third motion of a particle is that of its rim.
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
    each_spring(model, state, touching_only, |spring| springs.push(spring));
    springs
}

/// Calls `each` with every spring.
fn each_spring(model: &Model, state: &State, touching_only: bool, mut each: impl FnMut(Spring)) {
    let tolerance = 1e-6 * model.block_size;
    let of_block = |i: usize, sign: f64, direction: Vec2, arm: Vec2, root: f64| {
        let m = &model.inverse_mass[i];
        [
            sign * direction.x * root * m[0].sqrt(),
            sign * direction.y * root * m[1].sqrt(),
            sign * arm.cross(direction) * root * m[2].sqrt(),
        ]
    };
    for t in &state.touches {
        let (one, two) = (t.one as usize, t.two as usize);
        let (p1, p2) = (&state.poses[one], &state.poses[two]);
        let points = t.points(p1, p2);
        for k in 0..t.count as usize {
            if touching_only && points.overlap[k] < -tolerance {
                continue;
            }
            let at = points.at(k, p1.position);
            let (a1, a2) = (at - p1.position, at - p2.position);
            for (direction, stiffness) in [(points.normal(), t.normal_stiffness), (points.direction, t.shear_stiffness)]
            {
                let root = (stiffness * t.memory[k].length.max(t.half_joint)).sqrt();
                each(Spring {
                    one,
                    two,
                    row_one: of_block(one, -1.0, direction, a1, root),
                    row_two: of_block(two, 1.0, direction, a2, root),
                });
            }
        }
    }
    let blocks = model.len();
    // A rim weighs half of the disc: its moment of inertia over the square of the radius.
    let of_disc = |disc: &Disc, direction: Vec2, rim: f64, root: f64| {
        let m = disc.inverse_mass.sqrt() * root;
        [direction.x * m, direction.y * m, rim * m * std::f64::consts::SQRT_2]
    };
    let discs = &state.particles.discs;
    for chunk in &state.particles.chunks {
        for c in &chunk.contacts {
            let (i, j) = (chunk.first as usize + c.one as usize, c.other());
            let (a, b) = (&discs[i], &discs[j]);
            let apart = b.centre() - a.centre();
            if touching_only && apart.norm() > a.radius + b.radius + tolerance {
                continue;
            }
            let normal = apart.unit();
            for (direction, stiffness, rim) in
                [(normal, c.normal_stiffness, 0.0), (normal.left(), c.shear_stiffness, -1.0)]
            {
                let root = stiffness.sqrt();
                each(Spring {
                    one: blocks + i,
                    two: blocks + j,
                    row_one: of_disc(a, -direction, rim, root),
                    row_two: of_disc(b, direction, rim, root),
                });
            }
        }
        for lean in &chunk.leans {
            let i = (chunk.first + lean.local) as usize;
            let (disc, block) = (&discs[i], lean.block as usize);
            let at = { *lean }.look(disc, &model.cores.as_slice()[block], &state.poses[block]);
            if touching_only && at.overlap < -tolerance {
                continue;
            }
            let arm = disc.centre() - at.normal * disc.radius - state.poses[block].position;
            for (direction, stiffness, rim) in
                [(at.normal, lean.normal_stiffness, 0.0), (at.normal.left(), lean.shear_stiffness, -1.0)]
            {
                let root = stiffness.sqrt();
                each(Spring {
                    one: block,
                    two: blocks + i,
                    row_one: of_block(block, -1.0, direction, arm, root),
                    row_two: of_disc(disc, direction, rim, root),
                });
            }
        }
    }
}

/// Share of a spring between block and particle that the block bears where the particle's inertia is scaled: particles
/// can be given more of it, blocks cannot. `1 + t` for the block, `1 + 1/t` for the particle.
const LEAN_SHARE: f64 = 1.25;

/// A bound on the squares of the angular frequencies [1/s^2] body by body, blocks first, then particles, with every near pair closed: from
/// one pass over the springs.
///
/// A spring's energy between two bodies is at most `(1 + t) a^2 + (1 + 1/t) b^2` for any `t`. The ratio of the two inverse
/// masses is exact for two bodies alone and for regular packings; its root shares better between a light particle with few
/// contacts and a heavy block with many. What is left is one small matrix for each body, whose largest eigenvalue is bounded by its translation,
/// its rotation and their coupling. In random packings, size ratios 1 to 4, with and without a block, the step that follows
/// is 0.89 to 0.97 of the critical one.
pub(super) fn squares(model: &Model, state: &State, scaled_inertia: bool) -> Vec<f64> {
    let bodies = model.len() + state.particles.discs.len();
    // xx, xy, yy, rotation, coupling of rotation with x and y.
    let mut sums = vec![[0.0_f64; 6]; bodies];
    each_spring(model, state, false, |s| {
        let weight = |row: &[f64; 3]| row[0] * row[0] + row[1] * row[1];
        let (a, b) = (weight(&s.row_one), weight(&s.row_two));
        for (i, row, own, other) in [(s.one, &s.row_one, a, b), (s.two, &s.row_two, b, a)] {
            if own + row[2].abs() > 0.0 {
                // A body that can only turn gets the even share; beside a held one there is nothing to share.
                let lean = s.one < model.len() && s.two >= model.len();
                let share = match (scaled_inertia && lean, own > 0.0) {
                    _ if other == 0.0 => 1.0,
                    (true, _) if i < model.len() => LEAN_SHARE,
                    (true, _) => LEAN_SHARE / (LEAN_SHARE - 1.0),
                    (false, true) if lean => 1.0 + (other / own).sqrt(),
                    (false, true) => 1.0 + other / own,
                    (false, false) => 2.0,
                };
                let [x, y, turn] = *row;
                for (sum, more) in sums[i].iter_mut().zip([x * x, x * y, y * y, turn * turn, x * turn, y * turn]) {
                    *sum += share * more;
                }
            }
        }
    });
    let larger = |a: f64, b: f64, c: f64| 0.5 * (a + b + ((a - b) * (a - b) + 4.0 * c * c).sqrt());
    // A particle that is near to nothing may yet meet its like, at the latest before the next search.
    let discs = &state.particles.discs;
    let like = discs.iter().enumerate().map(|(i, disc)| model.particles.of_its_like(&model.laws, i as u32, disc));
    let of_body = |&[xx, xy, yy, turn, cx, cy]: &[f64; 6]| larger(larger(xx, yy, xy), turn, cx.hypot(cy));
    let mut squares: Vec<f64> = sums.iter().map(of_body).collect();
    squares[model.len()..].iter_mut().zip(like).for_each(|(square, like)| *square = square.max(like));
    squares
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
    (0..model.len() + model.particles.len())
        .map(|i| {
            std::array::from_fn(|c| {
                seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                let unit = (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5;
                if i >= model.len() || model.inverse_mass[i][c] > 0.0 { unit } else { 0.0 }
            })
        })
        .collect()
}

/// Power iteration approaches the largest frequency from below: what it ends at is raised by this, so that the step that
/// follows lies one per cent below the critical one and never above. `docs/theory/block-engine.md` names it.
const FROM_BELOW: f64 = 1.01;

/// Largest angular frequency [rad/s] with every near point closed, by power iteration to a relative change of 1e-6
/// (at most 2,000 products), times [`FROM_BELOW`].
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
    FROM_BELOW * eigenvalue.max(0.0).sqrt()
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
        let z = conjugate_gradients(&springs, &x, 20 * x.len() + 100);
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
    let mut sums = vec![[0.0; 3]; model.len() + model.particles.len()];
    each_spring(model, state, false, |s| {
        for c in 0..3 {
            sums[s.one][c] += s.row_one[c] * s.row_one[c];
            sums[s.two][c] += s.row_two[c] * s.row_two[c];
        }
    });
    let largest = sums.iter().flatten().copied().fold(0.0, f64::max);
    if largest > 0.0 { 2.0 / largest.sqrt() } else { f64::INFINITY }
}
