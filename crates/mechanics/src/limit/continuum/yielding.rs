//! Strength of soil and of its contacts with bodies, for the programs and for checks of what they return.
//!
//! In plane strain every limit has the same form. With `P = sx + sy` and `R = sqrt((sx - sy)^2 + 4 txy^2)`, twice the
//! centre and the radius of Mohr's circle, Mohr-Coulomb is `R <= 2 c cos(phi) - P sin(phi)`, a tension cut-off `R <= 2 t - P`, a
//! compressive strength `R <= 2 f + P`: `R <= k - m P` each. Stresses are effective: water in the pores carries none of `R`.

use super::conic::{Affine, Conic};
use super::model::{Contact, Soil};
use super::sideways::Sideways;

/// `R <= k - m P`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Limit {
    pub k: f64,
    pub m: f64,
}

/// Slopes of a limit from which on the mean stress is eliminated by it.
const STEEP: f64 = 0.05;

impl Soil {
    /// All limits that are not implied by the others.
    pub(super) fn limits(&self) -> Vec<Limit> {
        let (sin, cos) = self.friction_angle.sin_cos();
        let mut limits = vec![Limit { k: 2.0 * self.cohesion * cos, m: sin }];
        // The tip of the surface lies at cohesion over tan(phi).
        if self.tension * sin < self.cohesion * cos * (1.0 - 1e-9) {
            limits.push(Limit { k: 2.0 * self.tension, m: 1.0 });
        }
        if self.crushing.is_finite() {
            limits.push(Limit { k: 2.0 * self.crushing, m: -1.0 });
        }
        limits
    }

    /// By how much a stress (xx, yy, xy) [Pa] exceeds the strength; negative inside. `pore` is the pore pressure.
    pub(super) fn excess(&self, [xx, yy, xy]: [f64; 3], pore: f64) -> f64 {
        let (p, r) = (xx + yy + 2.0 * pore, (xx - yy).hypot(2.0 * xy));
        self.limits().iter().map(|l| r + l.m * p - l.k).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Largest power [Pa/s] of any stress within strength at strain rates (xx, yy, shear angle), and the rate that the flow rule does not allow.
    pub(super) fn dissipation(&self, [xx, yy, xy]: [f64; 3], pore: f64) -> (f64, f64) {
        let (e, g) = (xx + yy, (xx - yy).hypot(xy));
        let limits = self.limits();
        // With R at its largest, P e / 2 + min(k - m P) g / 2 is concave in P and straight between its corners.
        let [flattest, steepest] = slopes(&limits);
        let radius = |p: f64| limits.iter().map(|l| l.k - l.m * p).fold(f64::INFINITY, f64::min);
        let at = |p: f64| 0.5 * (p * e + radius(p).max(0.0) * g);
        let mut corners = corners(&limits);
        // Corners within strength, but for round-off of the tip itself.
        let size = limits.iter().map(|l| l.k.abs()).fold(0.0, f64::max);
        corners.retain(|&p| radius(p) >= -1e-12 * size);
        let power = corners.iter().map(|&p| at(p)).fold(f64::NEG_INFINITY, f64::max);
        let power = if corners.is_empty() { 0.5 * limits[0].k * g } else { power };
        // Without compressive strength P may fall without end: the rate must grow with the distortion. The flattest limit rules there.
        let violation = if flattest < 0.0 { 0.0 } else { (flattest * g - e).max(0.0) };
        // Without friction and cut-off P may grow without end as well.
        let violation = if steepest == 0.0 { e.abs() } else { violation };
        (power - pore * e, violation)
    }

    /// A stress within strength, (xx, yy, xy) as numbers that depend on the program's variables. `unit` is the unit of stress [Pa], in which the
    /// pore pressure is given; `beside` is what holds the soil out of the plane, and the variable of the pressure there.
    pub(super) fn stress(
        &self,
        program: &mut Conic,
        pore: &Affine,
        unit: f64,
        beside: Option<(Sideways, usize)>,
    ) -> [Affine; 3] {
        let limits: Vec<Limit> = self.limits().iter().map(|l| Limit { k: l.k / unit, ..*l }).collect();
        if limits.iter().any(|l| l.k == 0.0 && l.m == 0.0) {
            // A fluid: pressure alone.
            let p = Affine::of(program.free());
            return [p.clone(), p, Affine::default()];
        }
        let several = limits.len() > 1 || beside.is_some();
        let first = program.cone();
        let [r, x, y] = [first, first + 1, first + 2];
        let steepest = (0..limits.len()).max_by(|&a, &b| limits[a].m.total_cmp(&limits[b].m)).unwrap_or(0);
        // Twice the centre of Mohr's circle, effective.
        let p = if limits[steepest].m >= STEEP {
            let Limit { k, m } = limits[steepest];
            let mut p = Affine { terms: vec![(r, -1.0 / m)], constant: k / m };
            if several {
                p.terms.push((program.positive(), -1.0 / m));
            }
            p
        } else {
            Affine::of(program.free())
        };
        for (i, limit) in limits.iter().enumerate() {
            if i == steepest && limit.m >= STEEP {
                continue;
            }
            let mut room = Affine { terms: vec![(r, -1.0)], constant: limit.k };
            p.add_to(&mut room, -limit.m);
            if several {
                program.at_least_zero(&room);
            } else {
                program.zero(&room);
            }
        }
        if let Some((sideways, pressure)) = beside {
            let terms = vec![(r, -1.0), (pressure, 2.0 * sideways.ratio)];
            let mut room = Affine { terms, constant: 2.0 * sideways.cohesive / unit };
            p.add_to(&mut room, 1.0);
            program.at_least_zero(&room);
        }
        let total = |sign: f64| {
            let mut s = Affine { terms: vec![(x, 0.5 * sign)], constant: 0.0 };
            p.add_to(&mut s, 0.5);
            pore.add_to(&mut s, -1.0);
            s
        };
        [total(1.0), total(-1.0), Affine { terms: vec![(y, 0.5)], constant: 0.0 }]
    }
}

/// The least and the greatest slope of limits.
pub(super) fn slopes(limits: &[Limit]) -> [f64; 2] {
    limits.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], l| [low.min(l.m), high.max(l.m)])
}

/// Mean stresses `P` at which limits leave no radius, and at which two of them meet.
pub(super) fn corners(limits: &[Limit]) -> Vec<f64> {
    let mut corners = Vec::new();
    for (i, a) in limits.iter().enumerate() {
        if a.m != 0.0 {
            corners.push(a.k / a.m);
        }
        corners.extend(limits[i + 1..].iter().filter(|b| b.m != a.m).map(|b| (a.k - b.k) / (a.m - b.m)));
    }
    corners
}

impl Contact {
    /// Whether the tensile strength is reached before the tip of Coulomb's law.
    fn is_cut(&self) -> bool {
        self.tension * self.friction < self.cohesion * (1.0 - 1e-9)
    }

    /// By how much a pressure and a shear stress [Pa] exceed the strength. `pore` is the pore pressure.
    pub(super) fn excess(&self, pressure: f64, shear: f64, pore: f64) -> f64 {
        let effective = pressure - pore;
        let sliding = shear.abs() - self.cohesion - self.friction * effective;
        if self.is_cut() || self.friction == 0.0 { sliding.max(-effective - self.tension) } else { sliding }
    }

    /// Largest power [Pa m/s] at a closing and a sliding velocity of the soil against the body (closing positive), and the velocity that the
    /// flow rule does not allow.
    pub(super) fn dissipation(&self, closing: f64, sliding: f64, pore: f64) -> (f64, f64) {
        // Power of the soil's traction on the body: pressure times opening is lost, shear resists sliding.
        let (opening, slide) = (-closing, sliding.abs());
        if self.friction == 0.0 && !self.tension.is_finite() {
            // Held in both directions.
            return (self.cohesion * slide - pore * opening, opening.abs());
        }
        let violation = (self.friction * slide - opening).max(0.0);
        let tip = if self.is_cut() || self.friction == 0.0 { self.tension } else { self.cohesion / self.friction };
        let shear = (self.cohesion - self.friction * tip).max(0.0);
        // Tension at the tip against the opening, and what shear is left there.
        let tip_power = if tip > 0.0 { tip * opening.max(0.0) } else { 0.0 };
        (tip_power + shear * slide - pore * opening, violation)
    }

    /// Demands of a pressure and a shear stress that they lie within strength. All in the unit of stress.
    pub(super) fn limit(&self, program: &mut Conic, pressure: &Affine, shear: &Affine, pore: &Affine, unit: f64) {
        let mut effective = Affine::sum(&[(1.0, pressure), (-1.0, pore)]);
        let cohesion = self.cohesion / unit;
        if self.friction == 0.0 && cohesion == 0.0 {
            program.zero(shear);
        } else {
            for sign in [1.0, -1.0] {
                let mut room = Affine { terms: Vec::new(), constant: cohesion };
                effective.add_to(&mut room, self.friction);
                shear.add_to(&mut room, sign);
                program.at_least_zero(&room);
            }
        }
        if (self.is_cut() || self.friction == 0.0) && self.tension.is_finite() {
            effective.constant += self.tension / unit;
            program.at_least_zero(&effective);
        }
    }

    /// A pressure and a shear stress within strength, as numbers that depend on the program's variables.
    pub(super) fn stress(&self, program: &mut Conic, pore: &Affine, unit: f64) -> [Affine; 2] {
        let cohesion = self.cohesion / unit;
        if self.friction < STEEP {
            let (pressure, shear) = (Affine::of(program.free()), Affine::of(program.free()));
            self.limit(program, &pressure, &shear, pore, unit);
            return [pressure, shear];
        }
        // What is left to either limit of Coulomb's law.
        let (a, b) = (program.positive(), program.positive());
        let half = 0.5 / self.friction;
        let mut pressure = Affine { terms: vec![(a, half), (b, half)], constant: -cohesion / self.friction };
        if self.is_cut() {
            let mut room = pressure.clone();
            room.constant += self.tension / unit;
            program.at_least_zero(&room);
        }
        pore.add_to(&mut pressure, 1.0);
        [pressure, Affine { terms: vec![(a, 0.5), (b, -0.5)], constant: 0.0 }]
    }
}
