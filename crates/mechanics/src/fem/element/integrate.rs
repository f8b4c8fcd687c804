//! Forces and tangent of one quadrilateral, its incompatible modes condensed.

use super::shape::Sample;
use crate::fem::gmres::norm;
use crate::fem::law::{Four, Law, Material, Memory, Plane, Solid};
use crate::fem::state::Point;

/// Iterations for the amplitudes of the modes before the rest is left to the next iteration of the whole (few need ten, an element
/// that yields at all points may need a hundred), and the part of the stresses' own forces to which they are balanced.
const LOCAL_LIMIT: usize = 20;
const LOCAL_TOLERANCE: f64 = 1e-11;

/// Times in one attempt that the modes of an element whose flow is not associated find no balance before they are held where the step
/// found them. Such flow has no potential, and for given displacements of the corners there may be no balance of the modes at all: Newton's
/// method then goes to and fro between faces of the law for ever. Held, the element answers its corners as a plain one does.
const MISSES: u8 = 3;

/// Whether modes that so often found no balance are held.
pub(in crate::fem) fn held(misses: u8) -> bool {
    misses >= MISSES
}

/// Forces of an element on its corners, and their derivatives.
#[derive(Debug, Clone, Copy)]
pub(in crate::fem) struct Answer {
    /// Internal forces [N/m].
    pub force: [f64; 8],
    /// `d force[i] / d displacement[j]` [Pa].
    pub tangent: [[f64; 8]; 8],
    /// Force on the modes that is not balanced yet [N/m], nothing where they are balanced to rounding. The forces have its part, too: with
    /// it they lead Newton's method on.
    pub loose: f64,
}

/// What an element would remember.
pub(in crate::fem) struct Kept<'a> {
    /// Its four points.
    pub points: &'a mut [Point],
    /// Amplitudes of its modes: where the search for them starts, and where it ended.
    pub modes: &'a mut [f64; 4],
    /// Amplitudes when the step began.
    pub from: [f64; 4],
    /// How often in this attempt the modes found no balance.
    pub misses: &'a mut u8,
}

/// Whether an element without modes, displaced by `u` [m], is linear: no point yields and no memory changes. Its points are
/// written to `new` if so.
pub(in crate::fem) fn is_linear(
    solid: &Solid,
    samples: &[Sample; 4],
    u: &[f64; 8],
    old: &[Point],
    new: &mut [Point],
) -> bool {
    samples.iter().zip(old).zip(new).all(|((sample, old), new)| {
        let answer = answer(solid, &strain(sample, u), &old.memory);
        *new = Point { memory: answer.memory, stress: answer.stress, yields: answer.yields };
        !answer.yields && answer.memory == old.memory
    })
}

/// Strain of `M / 2` functions of two components.
#[inline(always)]
fn strain<const M: usize>(sample: &Sample, u: &[f64; M]) -> Four {
    let mut strain = [0.0; 4];
    for a in 0..M / 2 {
        strain[0] += sample.dx[a] * u[2 * a];
        strain[1] += sample.dy[a] * u[2 * a + 1];
        strain[3] += sample.dy[a] * u[2 * a] + sample.dx[a] * u[2 * a + 1];
    }
    strain
}

/// The answer of an element to displacements `u` of its corners; `None` where nothing resists its modes.
pub(in crate::fem) fn respond(
    solid: &Solid,
    incompatible: bool,
    samples: &[Sample; 4],
    u: &[f64; 8],
    old: &[Point],
    kept: Kept<'_>,
) -> Option<Answer> {
    if !incompatible {
        let (force, tangent, _) = integrate::<8>(solid, samples, u, old, kept.points);
        return Some(Answer { force, tangent, loose: 0.0 });
    }
    if held(*kept.misses) {
        return Some(plain(solid, samples, u, old, kept));
    }
    let mut all = [0.0; 12];
    all[..8].copy_from_slice(u);
    all[8..].copy_from_slice(kept.modes);
    let stiffness = modes_stiffness(solid, samples);
    let mut at = |all: &[f64; 12]| integrate::<12>(solid, samples, all, old, &mut *kept.points);
    let mut now = at(&all);
    let mut last = f64::INFINITY;
    for tries in 0.. {
        let (force, tangent, size) = &now;
        let left = largest(force);
        // Linear laws are balanced but for rounding; a stall next to the tolerance is rounding too.
        let balanced = left <= LOCAL_TOLERANCE * size || (left >= last && left <= 1e3 * LOCAL_TOLERANCE * size);
        if balanced || tries == LOCAL_LIMIT {
            break;
        }
        let (_, step) = condense(force, tangent, stiffness)?;
        last = left;
        now = step_modes(&mut all, &step, &now.0, &mut at);
    }
    let (force, tangent, size) = &now;
    let loose = if largest(force) <= 1e3 * LOCAL_TOLERANCE * size { 0.0 } else { norm(&force[8..]) };
    if loose > 0.0 && !solid.material.symmetric() {
        *kept.misses += 1;
        if held(*kept.misses) {
            return Some(plain(solid, samples, u, old, kept));
        }
    }
    let (answer, _) = condense(force, tangent, stiffness)?;
    kept.modes.copy_from_slice(&all[8..]);
    Some(Answer { loose, ..answer })
}

/// The answer of an element whose modes are held where the step found them.
fn plain(solid: &Solid, samples: &[Sample; 4], u: &[f64; 8], old: &[Point], kept: Kept<'_>) -> Answer {
    *kept.modes = kept.from;
    let mut all = [0.0; 12];
    all[..8].copy_from_slice(u);
    all[8..].copy_from_slice(&kept.from);
    let (force, tangent, _) = integrate::<12>(solid, samples, &all, old, kept.points);
    Answer {
        force: std::array::from_fn(|i| force[i]),
        tangent: std::array::from_fn(|i| std::array::from_fn(|j| tangent[i][j])),
        loose: 0.0,
    }
}

/// Largest force on a mode [N/m].
fn largest(force: &[f64; 12]) -> f64 {
    force[8..].iter().fold(0.0, |most: f64, f| most.max(f.abs()))
}

/// Forces and tangent of corners and modes, and the size of the sums' terms.
type Whole = ([f64; 12], [[f64; 12]; 12], f64);

/// Moves the amplitudes by the step of Newton's method, or by the part of it after which the force along it is small: flow that
/// sets in on the way makes the whole step too long.
fn step_modes(
    all: &mut [f64; 12],
    step: &[f64; 4],
    force: &[f64; 12],
    at: &mut impl FnMut(&[f64; 12]) -> Whole,
) -> Whole {
    const TRIES: usize = 12;
    const LEFT: f64 = 0.9;
    let from = *all;
    let along = |force: &[f64; 12]| force[8..].iter().zip(step).map(|(force, step)| force * step).sum::<f64>();
    let start = along(force);
    let mut share = 1.0;
    let mut tries = 0;
    loop {
        for i in 0..4 {
            all[8 + i] = from[8 + i] - share * step[i];
        }
        let now = at(all);
        let end = along(&now.0);
        tries += 1;
        // Short of balance along the step is as good as close to it: what resists grows with the amplitudes.
        if end.abs() <= LEFT * start.abs() || end * start >= 0.0 || tries == TRIES {
            return now;
        }
        let part = if end.is_finite() { start.abs() / (start.abs() + end.abs()) } else { 0.5 };
        share *= part.clamp(0.1, 0.9);
    }
}

/// A measure of what the modes resist while nothing flows [Pa].
fn modes_stiffness(solid: &Solid, samples: &[Sample; 4]) -> f64 {
    let square = |s: &Sample| s.area * (s.dx[4].powi(2) + s.dy[4].powi(2) + s.dx[5].powi(2) + s.dy[5].powi(2));
    solid.material.elastic().modulus * samples.iter().map(square).sum::<f64>()
}

/// Sums over the points: forces and tangent of `M / 2` functions of two components (equation 3), and the size of the sum's terms.
fn integrate<const M: usize>(
    solid: &Solid,
    samples: &[Sample; 4],
    u: &[f64; M],
    old: &[Point],
    new: &mut [Point],
) -> ([f64; M], [[f64; M]; M], f64) {
    let mut force = [0.0; M];
    let mut tangent = [[0.0; M]; M];
    let mut size = 0.0;
    for ((sample, old), new) in samples.iter().zip(old).zip(new) {
        let strain = strain(sample, u);
        let answer = answer(solid, &strain, &old.memory);
        *new = Point { memory: answer.memory, stress: answer.stress, yields: answer.yields };
        let d = &answer.tangent;
        let s = answer.stress;
        let area = sample.area;
        let mut db = [[0.0; M]; 3];
        for (row, from) in [0, 1, 3].into_iter().enumerate() {
            let [xx, yy, xy] = [area * d[from][0], area * d[from][1], area * d[from][3]];
            for a in 0..M / 2 {
                db[row][2 * a] = xx * sample.dx[a] + xy * sample.dy[a];
                db[row][2 * a + 1] = yy * sample.dy[a] + xy * sample.dx[a];
            }
        }
        for a in 0..M / 2 {
            let (bx, by) = (sample.dx[a], sample.dy[a]);
            force[2 * a] += area * (bx * s[0] + by * s[3]);
            force[2 * a + 1] += area * (by * s[1] + bx * s[3]);
            for c in 0..M {
                tangent[2 * a][c] += bx * db[0][c] + by * db[2][c];
                tangent[2 * a + 1][c] += by * db[1][c] + bx * db[2][c];
            }
        }
        // Where a law leaves next to no stress, what is left is the rounding of the trial stress that it came from.
        let trial = solid.material.elastic().shear() * strain.iter().fold(0.0, |most: f64, e| most.max(e.abs()));
        let stress = s[0].abs().max(s[1].abs()).max(s[3].abs()).max(1e-2 * trial);
        size += area * stress * (sample.dx[M / 2 - 1].abs() + sample.dy[M / 2 - 1].abs());
    }
    (force, tangent, size)
}

/// The law, without a detour where it is linear.
#[inline]
fn answer(solid: &Solid, strain: &Four, old: &Memory) -> crate::fem::law::Response {
    match (&solid.material, solid.plane) {
        (Material::Elastic(law), Plane::Strain) => law.respond(strain, old),
        _ => solid.respond(strain, old),
    }
}

/// Takes the modes out of forces and tangent (equation 6); the second part is what Newton's method takes off their amplitudes.
///
/// Modes that nothing resists, because all points are at the end of their strength, are given a trace of their elastic stiffness.
fn condense(force: &[f64; 12], tangent: &[[f64; 12]; 12], stiffness: f64) -> Option<(Answer, [f64; 4])> {
    condensed(force, tangent, stiffness, 0.0).or_else(|| condensed(force, tangent, stiffness, 1e-8))
}

fn condensed(force: &[f64; 12], tangent: &[[f64; 12]; 12], stiffness: f64, trace: f64) -> Option<(Answer, [f64; 4])> {
    // Columns: d modes / d displacements, then the force on the modes.
    let mut a = [[0.0; 4]; 4];
    let mut b = [[0.0; 9]; 4];
    for i in 0..4 {
        a[i].copy_from_slice(&tangent[8 + i][8..]);
        b[i][..8].copy_from_slice(&tangent[8 + i][..8]);
        b[i][8] = force[8 + i];
        a[i][i] += trace * stiffness;
    }
    solve(&mut a, &mut b, 1e-12 * stiffness)?;
    let mut answer = Answer { force: [0.0; 8], tangent: [[0.0; 8]; 8], loose: 0.0 };
    for i in 0..8 {
        let mut row = [0.0; 9];
        row[..8].copy_from_slice(&tangent[i][..8]);
        row[8] = force[i];
        for (m, solved) in b.iter().enumerate() {
            let k = tangent[i][8 + m];
            for (r, s) in row.iter_mut().zip(solved) {
                *r -= k * s;
            }
        }
        answer.tangent[i].copy_from_slice(&row[..8]);
        answer.force[i] = row[8];
    }
    Some((answer, [b[0][8], b[1][8], b[2][8], b[3][8]]))
}

/// Gaussian elimination with row exchanges; `None` where a pivot vanishes.
fn solve(a: &mut [[f64; 4]; 4], b: &mut [[f64; 9]; 4], least: f64) -> Option<()> {
    for k in 0..4 {
        let pivot = (k..4).fold(k, |best, i| if a[i][k].abs() > a[best][k].abs() { i } else { best });
        if !(a[pivot][k].abs() > least) {
            return None;
        }
        a.swap(k, pivot);
        b.swap(k, pivot);
        let inverse = 1.0 / a[k][k];
        for i in k + 1..4 {
            let factor = a[i][k] * inverse;
            for j in k..4 {
                a[i][j] -= factor * a[k][j];
            }
            for j in 0..9 {
                b[i][j] -= factor * b[k][j];
            }
        }
    }
    for k in (0..4).rev() {
        for j in 0..9 {
            let mut sum = b[k][j];
            for i in k + 1..4 {
                sum -= a[k][i] * b[i][j];
            }
            b[k][j] = sum / a[k][k];
        }
    }
    Some(())
}
