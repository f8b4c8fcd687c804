//! Quadrilaterals of which one look at the centre says that none of the four points flows.
//!
//! Displacements of a quadrilateral without modes are an affine field and an hourglass (Flanagan, Belytschko 1981): the strain of point `g` is the
//! centre's and that of the hourglass, `h_x` and `h_y` along either axis. As `√J2` is a norm, all four points lie within their cone where
//!
//! ```text
//! √J2(centre) + α I1(centre) + A_x |h_x| + A_y |h_y| < k,   A = max over g of √J2 + |α I1| of an hourglass of one
//! ```
//!
//! That is a quarter of the operations that four points take, and no root is drawn. Where this cannot tell, [`Quiet`] looks at the points.

use super::quiet::{Quiet, TOGETHER, solution};
use crate::fem::element::Sample;
use crate::fem::factor::Block;
use crate::fem::law::{DruckerPrager, Four, Material, Plane};

/// Share of the strength that has to be left: far above the rounding of stresses.
const MARGIN: f64 = 1e-9;

/// Displacements [m] up to which the rounding of strains is allowed for. Small displacements do not come near.
const REACH: f64 = 10.0;

/// A quadrilateral on a cone, as it was at a time. Strains are times the shear modulus [Pa].
#[derive(Debug)]
pub(super) struct Hourglass {
    equations: [u32; 8],
    /// Gradients at the centre of the first two corners; those of the others are their opposites.
    dx: [f64; 2],
    dy: [f64; 2],
    /// What displacements of the corners are of the hourglass.
    pattern: [f64; 4],
    /// Strains xx, yy and xy at the centre when the run began, plastic strain taken off.
    start: [f64; 3],
    /// Hourglasses when the run began [m].
    start_bent: [f64; 2],
    /// Twice the plastic strain across.
    across: f64,
    /// `α I1` of a sum of strains xx and yy of one.
    pressed: f64,
    /// `A_x`, `A_y` [Pa/m].
    bent: [f64; 2],
    /// What of the strength is left for these [Pa].
    limit: f64,
}

/// Strain of displacements `u` at gradients.
fn strain(dx: &[f64; 4], dy: &[f64; 4], u: &[f64; 8]) -> Four {
    let mut strain = [0.0; 4];
    for a in 0..4 {
        strain[0] += dx[a] * u[2 * a];
        strain[1] += dy[a] * u[2 * a + 1];
        strain[3] += dy[a] * u[2 * a] + dx[a] * u[2 * a + 1];
    }
    strain
}

fn first_four(sample: &Sample) -> [[f64; 4]; 2] {
    [&sample.dx, &sample.dy].map(|d| [d[0], d[1], d[2], d[3]])
}

/// √J2 + |α I1| of a strain.
fn size(law: &DruckerPrager, [x, y, z, xy]: &Four) -> f64 {
    let (d, s) = (x - y, x + y - 2.0 * z);
    let volume = 3.0 * law.elastic.bulk() * (x + y + z);
    law.elastic.shear() * (d * d + s * s / 3.0 + xy * xy).sqrt() + (law.alpha * volume).abs()
}

impl Hourglass {
    /// Of a quadrilateral whose law knows a bound.
    pub fn new(quad: &Quiet<'_>) -> Option<Hourglass> {
        let law = match (&quad.solid.material, quad.solid.plane) {
            (Material::DruckerPrager(law), Plane::Strain) if law.tension_cutoff.is_none() => law,
            _ => return None,
        };
        // Gradients at the centre are the mean of all.
        let area: f64 = quad.samples.iter().map(|sample| sample.area).sum();
        let mut centre = [[0.0; 4]; 2];
        for sample in quad.samples {
            for (centre, d) in centre.iter_mut().flatten().zip(first_four(sample).as_flattened()) {
                *centre += sample.area * d / area;
            }
        }
        let [[bx, cx, ..], [by, cy, ..]] = centre;
        let [dx, dy] = [[bx, cx, -bx, -cx], [by, cy, -by, -cy]];
        // What is left of the gradients at the points are multiples of one pattern.
        let rests = quad.samples.each_ref().map(|sample| {
            let d = first_four(sample);
            [std::array::from_fn(|a| d[0][a] - dx[a]), std::array::from_fn(|a| d[1][a] - dy[a])]
        });
        let largest = |rest: &[f64; 4]| rest.iter().fold(0.0_f64, |most, r| most.max(r.abs()));
        let pattern = rests.iter().flatten().max_by(|a, b| largest(a).total_cmp(&largest(b)))?;
        let pattern = pattern.map(|p| p / largest(pattern));
        let dot = |a: &[f64; 4]| a.iter().zip(&pattern).map(|(a, b)| a * b).sum::<f64>();
        let square = dot(&pattern);
        let shares = rests.map(|rest| rest.map(|rest| dot(&rest) / square));

        let plastic: Four = std::array::from_fn(|i| quad.points.iter().map(|p| 0.25 * p.memory.plastic[i]).sum());
        let (mut bent, mut uneven, mut missed, mut steep) = ([0.0_f64; 2], 0.0_f64, 0.0_f64, 0.0_f64);
        for (k, [x, y]) in shares.into_iter().enumerate() {
            bent[0] = bent[0].max(size(law, &[x, 0.0, 0.0, y]));
            bent[1] = bent[1].max(size(law, &[0.0, y, 0.0, x]));
            let other: Four = std::array::from_fn(|i| quad.points[k].memory.plastic[i] - plastic[i]);
            uneven = uneven.max(size(law, &other));
            let mut terms = 0.0;
            for a in 0..4 {
                missed += (rests[k][0][a] - x * pattern[a]).abs() + (rests[k][1][a] - y * pattern[a]).abs();
                terms += dx[a].abs() + dy[a].abs() + (x.abs() + y.abs()) * pattern[a].abs();
            }
            steep = steep.max(terms);
        }
        // Rounding of strains: some twenty operations on displacements times gradients, here and where the law is asked.
        let rounding = (missed + 64.0 * f64::EPSILON * steep) * REACH * size(law, &[1.0, 1.0, -1.0, 1.0]);
        let shear = law.elastic.shear();
        let pressed = 3.0 * law.alpha * law.elastic.bulk() / shear;
        let begun = strain(&dx, &dy, quad.base);
        let hourglass = |axis: usize| (0..4).map(|a| pattern[a] * quad.base[2 * a + axis]).sum();
        let limit = (1.0 - MARGIN) * law.strength + pressed * shear * plastic[2] - uneven - rounding;
        Some(Hourglass {
            equations: *quad.equations,
            dx: [shear * bx, shear * cx],
            dy: [shear * by, shear * cy],
            pattern,
            start: [0, 1, 3].map(|i| shear * (begun[i] - plastic[i])),
            start_bent: [hourglass(0), hourglass(1)],
            across: 2.0 * shear * plastic[2],
            pressed,
            bent,
            limit,
        })
    }

    /// Whether it surely flows in none of the first solutions.
    #[inline(always)]
    pub fn holds<const FUSED: bool>(&self, block: &Block, lanes: usize) -> bool {
        let mut u = [solution(block, self.equations[0]); 8];
        for i in 1..8 {
            u[i] = solution(block, self.equations[i]);
        }
        let mut inside = true;
        for k in 0..lanes.div_ceil(TOGETHER) {
            let u = [&u[0][k], &u[1][k], &u[2][k], &u[3][k], &u[4][k], &u[5][k], &u[6][k], &u[7][k]];
            inside &= self.holds_in::<FUSED>(u);
        }
        inside
    }

    #[inline(always)]
    fn holds_in<const FUSED: bool>(&self, u: [&[f64; TOGETHER]; 8]) -> bool {
        let ([ax, bx], [ay, by]) = (self.dx, self.dy);
        let [p0, p1, p2, p3] = self.pattern;
        let mut inside = true;
        for lane in 0..TOGETHER {
            let plus = |a: f64, b: f64, c: f64| if FUSED { a.mul_add(b, c) } else { a * b + c };
            let (x02, x13) = (u[0][lane] - u[4][lane], u[2][lane] - u[6][lane]);
            let (y02, y13) = (u[1][lane] - u[5][lane], u[3][lane] - u[7][lane]);
            let xx = plus(ax, x02, plus(bx, x13, self.start[0]));
            let yy = plus(ay, y02, plus(by, y13, self.start[1]));
            let xy = plus(ay, x02, plus(by, x13, plus(ax, y02, plus(bx, y13, self.start[2]))));
            let hx = plus(p0, u[0][lane], plus(p1, u[2][lane], self.start_bent[0]));
            let hx = plus(p2, u[4][lane], plus(p3, u[6][lane], hx));
            let hy = plus(p0, u[1][lane], plus(p1, u[3][lane], self.start_bent[1]));
            let hy = plus(p2, u[5][lane], plus(p3, u[7][lane], hy));
            let (sum, apart) = (xx + yy, xx - yy);
            let across = sum + self.across;
            let square = plus(apart, apart, plus(across * (1.0 / 3.0), across, xy * xy));
            let left =
                plus(-self.bent[0], hx.abs(), plus(-self.bent[1], hy.abs(), plus(-self.pressed, sum, self.limit)));
            inside &= (left > 0.0) & (square < (1.0 - 2.0 * MARGIN) * left * left);
        }
        inside
    }
}
