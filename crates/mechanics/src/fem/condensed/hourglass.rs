//! Proof that a quadrilateral does not yield, from the stress at its centre and a bound on its hourglass.
//!
//! Displacements of a quadrilateral without incompatible modes are an affine field and an hourglass (Flanagan, Belytschko 1981):
//! the strain of point `g` is that of the centre and that of the hourglass, `h_x` and `h_y` along either axis. As `√J2` is a
//! norm, all four points lie within their cone where
//!
//! ```text
//! √J2(centre) + α I1(centre) + A_x |h_x| + A_y |h_y| < k,   A = max over g of √J2 + |α I1| of an hourglass of one
//! ```
//!
//! This takes a quarter of the operations of the test at four points, and no root. Where it proves nothing, [`QuadCheck`] tests
//! the points.

use super::quad_check::{LANES, QuadCheck, equation_values};
use crate::fem::element::Sample;
use crate::fem::factor::Block;
use crate::fem::law::{DruckerPrager, Four, Material, Plane};

/// Share of the strength that the test leaves unused: far above the rounding of stresses.
const MARGIN: f64 = 1e-9;

/// Displacements [m] up to which rounding of strains is allowed for; small displacements stay far below.
const REACH: f64 = 10.0;

/// The bound for a quadrilateral on a Drucker-Prager cone with a given memory. Strains are multiplied by the shear modulus [Pa].
#[derive(Debug)]
pub(super) struct HourglassBound {
    equations: [u32; 8],
    /// Gradients at the centre of the first two corners, times the shear modulus [Pa/m]; those of the other two are their
    /// opposites.
    dx: [f64; 2],
    dy: [f64; 2],
    /// Hourglass amplitude by displacements of the corners along one axis.
    pattern: [f64; 4],
    /// Strains xx, yy and xy at the centre when the run began, less plastic strain [Pa].
    initial_strain: [f64; 3],
    /// Hourglass amplitudes `h_x`, `h_y` when the run began [m].
    initial_hourglass: [f64; 2],
    /// Twice the plastic strain out of plane [Pa].
    across: f64,
    /// `α I1` of strains xx and yy whose sum is one, over the shear modulus.
    volumetric: f64,
    /// `A_x`, `A_y` [Pa/m].
    bound: [f64; 2],
    /// Strength that is left for these terms [Pa].
    strength: f64,
}

/// Strain at displacements `u` of the corners [m] with gradients `dx`, `dy` [1/m].
fn strain(dx: &[f64; 4], dy: &[f64; 4], u: &[f64; 8]) -> Four {
    let mut strain = [0.0; 4];
    for a in 0..4 {
        strain[0] += dx[a] * u[2 * a];
        strain[1] += dy[a] * u[2 * a + 1];
        strain[3] += dy[a] * u[2 * a] + dx[a] * u[2 * a + 1];
    }
    strain
}

/// Gradients of the four corner functions [1/m].
fn corner_gradients(sample: &Sample) -> [[f64; 4]; 2] {
    [&sample.dx, &sample.dy].map(|d| [d[0], d[1], d[2], d[3]])
}

/// √J2 + |α I1| of an elastic strain [Pa].
fn stress_norm(law: &DruckerPrager, [x, y, z, xy]: &Four) -> f64 {
    let (d, s) = (x - y, x + y - 2.0 * z);
    let volume = 3.0 * law.elastic.bulk() * (x + y + z);
    law.elastic.shear() * (d * d + s * s / 3.0 + xy * xy).sqrt() + (law.alpha * volume).abs()
}

impl HourglassBound {
    /// Finds the bound of a quadrilateral; `None` for laws other than Drucker-Prager in plane strain without a tension cut-off.
    pub(super) fn new(quad: &QuadCheck<'_>) -> Option<HourglassBound> {
        let law = match (&quad.solid.material, quad.solid.plane) {
            (Material::DruckerPrager(law), Plane::Strain) if law.tension_cutoff.is_none() => law,
            _ => return None,
        };
        // The gradients at the centre are the mean of those at the points.
        let area: f64 = quad.samples.iter().map(|sample| sample.area).sum();
        let mut centre = [[0.0; 4]; 2];
        for sample in quad.samples {
            for (centre, d) in centre.iter_mut().flatten().zip(corner_gradients(sample).as_flattened()) {
                *centre += sample.area * d / area;
            }
        }
        let [[bx, cx, ..], [by, cy, ..]] = centre;
        let [dx, dy] = [[bx, cx, -bx, -cx], [by, cy, -by, -cy]];
        // What remains of the gradients at the points is a multiple of one pattern.
        let remainders = quad.samples.each_ref().map(|sample| {
            let d = corner_gradients(sample);
            [std::array::from_fn(|a| d[0][a] - dx[a]), std::array::from_fn(|a| d[1][a] - dy[a])]
        });
        let largest = |rest: &[f64; 4]| rest.iter().fold(0.0_f64, |most, r| most.max(r.abs()));
        let pattern = remainders.iter().flatten().max_by(|a, b| largest(a).total_cmp(&largest(b)))?;
        let pattern = pattern.map(|p| p / largest(pattern));
        let dot = |a: &[f64; 4]| a.iter().zip(&pattern).map(|(a, b)| a * b).sum::<f64>();
        let square = dot(&pattern);
        let amplitudes = remainders.map(|rest| rest.map(|rest| dot(&rest) / square));

        let plastic: Four = std::array::from_fn(|i| quad.points.iter().map(|p| 0.25 * p.memory.plastic[i]).sum());
        let (mut bound, mut uneven, mut misfit, mut gradient_sum) = ([0.0_f64; 2], 0.0_f64, 0.0_f64, 0.0_f64);
        for (k, [x, y]) in amplitudes.into_iter().enumerate() {
            bound[0] = bound[0].max(stress_norm(law, &[x, 0.0, 0.0, y]));
            bound[1] = bound[1].max(stress_norm(law, &[0.0, y, 0.0, x]));
            let other: Four = std::array::from_fn(|i| quad.points[k].memory.plastic[i] - plastic[i]);
            uneven = uneven.max(stress_norm(law, &other));
            let mut terms = 0.0;
            for a in 0..4 {
                misfit += (remainders[k][0][a] - x * pattern[a]).abs() + (remainders[k][1][a] - y * pattern[a]).abs();
                terms += dx[a].abs() + dy[a].abs() + (x.abs() + y.abs()) * pattern[a].abs();
            }
            gradient_sum = gradient_sum.max(terms);
        }
        // Rounding of strains: some twenty operations on displacements times gradients, here and in the law.
        let rounding = (misfit + 64.0 * f64::EPSILON * gradient_sum) * REACH * stress_norm(law, &[1.0, 1.0, -1.0, 1.0]);
        let shear = law.elastic.shear();
        let volumetric = 3.0 * law.alpha * law.elastic.bulk() / shear;
        let initial = strain(&dx, &dy, quad.base);
        let hourglass = |axis: usize| (0..4).map(|a| pattern[a] * quad.base[2 * a + axis]).sum();
        let strength = (1.0 - MARGIN) * law.strength + volumetric * shear * plastic[2] - uneven - rounding;
        Some(HourglassBound {
            equations: *quad.equations,
            dx: [shear * bx, shear * cx],
            dy: [shear * by, shear * cy],
            pattern,
            initial_strain: [0, 1, 3].map(|i| shear * (initial[i] - plastic[i])),
            initial_hourglass: [hourglass(0), hourglass(1)],
            across: 2.0 * shear * plastic[2],
            volumetric,
            bound,
            strength,
        })
    }

    /// Whether no point yields in any of the first solutions of `block`. `false` proves nothing.
    #[inline(always)]
    pub(super) fn proves_linear<const FUSED: bool>(&self, block: &Block, solutions: usize) -> bool {
        let mut u = [equation_values(block, self.equations[0]); 8];
        for i in 1..8 {
            u[i] = equation_values(block, self.equations[i]);
        }
        let mut inside = true;
        for k in 0..solutions.div_ceil(LANES) {
            let u = [&u[0][k], &u[1][k], &u[2][k], &u[3][k], &u[4][k], &u[5][k], &u[6][k], &u[7][k]];
            inside &= self.proves_group_linear::<FUSED>(u);
        }
        inside
    }

    #[inline(always)]
    fn proves_group_linear<const FUSED: bool>(&self, u: [&[f64; LANES]; 8]) -> bool {
        let ([ax, bx], [ay, by]) = (self.dx, self.dy);
        let [p0, p1, p2, p3] = self.pattern;
        let mut inside = true;
        for lane in 0..LANES {
            let plus = |a: f64, b: f64, c: f64| if FUSED { a.mul_add(b, c) } else { a * b + c };
            let (x02, x13) = (u[0][lane] - u[4][lane], u[2][lane] - u[6][lane]);
            let (y02, y13) = (u[1][lane] - u[5][lane], u[3][lane] - u[7][lane]);
            let xx = plus(ax, x02, plus(bx, x13, self.initial_strain[0]));
            let yy = plus(ay, y02, plus(by, y13, self.initial_strain[1]));
            let xy = plus(ay, x02, plus(by, x13, plus(ax, y02, plus(bx, y13, self.initial_strain[2]))));
            let hx = plus(p0, u[0][lane], plus(p1, u[2][lane], self.initial_hourglass[0]));
            let hx = plus(p2, u[4][lane], plus(p3, u[6][lane], hx));
            let hy = plus(p0, u[1][lane], plus(p1, u[3][lane], self.initial_hourglass[1]));
            let hy = plus(p2, u[5][lane], plus(p3, u[7][lane], hy));
            let (sum, apart) = (xx + yy, xx - yy);
            let across = sum + self.across;
            let square = plus(apart, apart, plus(across * (1.0 / 3.0), across, xy * xy));
            let left = plus(
                -self.bound[0],
                hx.abs(),
                plus(-self.bound[1], hy.abs(), plus(-self.volumetric, sum, self.strength)),
            );
            inside &= (left > 0.0) & (square < (1.0 - 2.0 * MARGIN) * left * left);
        }
        inside
    }
}
