//! Drucker-Prager: a cone about the hydrostatic axis.

use super::elastic::Elastic;
use super::principal::Principal;
use super::response::{Four, Law, Memory, Response};
use super::strength::{Cone, Strength};
use super::three::{Matrix, Three, dot, hooke, inverse};
use super::{cone, polyhedron};

/// Elastic, perfectly plastic on √J2 + α I1 ≤ k, with flow along √J2 + β I1; tension positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DruckerPrager {
    /// Elasticity.
    pub elastic: Elastic,
    /// Friction α, not below zero.
    pub alpha: f64,
    /// Dilatancy β, from 0 to α.
    pub beta: f64,
    /// Strength k at no pressure [Pa], not below zero.
    pub strength: f64,
    /// Greatest principal stress it takes in tension [Pa]; none leaves the cone up to its apex at k/3α.
    pub tension_cutoff: Option<f64>,
}

impl DruckerPrager {
    /// The cone that stands for a cohesion [Pa], an angle of friction and one of dilatancy [rad].
    #[must_use]
    pub fn matching(elastic: Elastic, cone: Cone, cohesion: f64, friction: f64, dilatancy: f64) -> DruckerPrager {
        let (alpha, strength) = cone.constants(friction, dilatancy);
        // Flow is that of the same cone drawn for the angle of dilatancy: associated where the two angles are the same.
        let (beta, _) = cone.constants(dilatancy, dilatancy);
        let beta = if friction.to_bits() == dilatancy.to_bits() { alpha } else { beta };
        DruckerPrager { elastic, alpha, beta, strength: strength * cohesion, tension_cutoff: None }
    }

    fn beyond(&self, principal: &Three) -> f64 {
        let (radius, _, sum) = parts(principal);
        radius + self.alpha * sum - self.strength
    }

    /// Whether all `L` strains stay inside the cone by at least a billionth of its strength. The test fails at zero stress where
    /// the strength is zero, and everywhere where tension is cut off.
    #[inline(always)]
    pub(super) fn provably_linear<const L: usize>(&self, strain: &[[f64; L]; 4], old: &Memory) -> bool {
        const MARGIN: f64 = 1e-9;
        let (bulk, shear) = (self.elastic.bulk(), self.elastic.shear());
        let mut inside = self.tension_cutoff.is_none();
        for lane in 0..L {
            let [x, y, z, xy] = [0, 1, 2, 3].map(|i| strain[i][lane] - old.plastic[i]);
            let (apart, across) = (x - y, x + y - 2.0 * z);
            // J2 over the square of the shear modulus: no root is drawn.
            let square = apart * apart + across * across * (1.0 / 3.0) + xy * xy;
            let left = (1.0 - MARGIN) * self.strength - 3.0 * self.alpha * bulk * (x + y + z);
            inside &= (left > 0.0) & (shear * shear * square < (1.0 - 2.0 * MARGIN) * left * left);
        }
        inside
    }
}

impl Law for DruckerPrager {
    fn of(elastic: Elastic, strength: &Strength) -> DruckerPrager {
        let Strength { cohesion, friction_angle, dilatancy_angle, tension_cutoff, cone } = *strength;
        let law = DruckerPrager::matching(elastic, cone, cohesion, friction_angle, dilatancy_angle);
        DruckerPrager { tension_cutoff, ..law }
    }

    fn elastic(&self) -> Elastic {
        self.elastic
    }

    fn symmetric(&self) -> bool {
        self.beta.to_bits() == self.alpha.to_bits()
    }

    fn respond(&self, strain: &Four, old: &Memory) -> Response {
        let trial = self.elastic.trial(strain, old);
        let on_cone = cone::back(&self.elastic, &trial, self.alpha, self.beta, self.strength);
        if let Some(cutoff) = self.tension_cutoff {
            let candidate = on_cone.map_or(trial, |(stress, _)| stress);
            let size = candidate.iter().fold(cutoff.abs(), |size, s| size.max(s.abs()));
            if Principal::of(&candidate).stress[0] > cutoff + cone::ROUNDING * size {
                let principal = Principal::of(&trial);
                let (stress, tangent) = self.cut_off(&principal.stress, cutoff);
                let (stress, tangent) = principal.back(&self.elastic, &stress, &tangent);
                return self.elastic.softened(strain, old, stress, tangent);
            }
        }
        match on_cone {
            None => self.elastic.holds(trial, old),
            // At the apex.
            Some((stress, tangent)) if tangent[3][3] == 0.0 => self.elastic.softened(strain, old, stress, tangent),
            Some((stress, tangent)) => self.elastic.flowed(strain, old, stress, tangent),
        }
    }
}

/// The way back where the cut-off in tension takes part, in principal stresses.
impl DruckerPrager {
    fn cut_off(&self, trial: &Three, cutoff: f64) -> (Three, Matrix) {
        let size = trial.iter().fold(cutoff.abs() + self.strength, |size, s| size.max(s.abs()));
        let rounding = 1e-12 * size;
        let faces = polyhedron::tension(cutoff);
        let tip = [cutoff.min(self.strength / (3.0 * self.alpha)); 3];
        if let Some(flat) = polyhedron::back(&self.elastic, trial, &faces)
            && self.beyond(&flat.stress) <= rounding
        {
            return (flat.stress, flat.tangent);
        }
        if let Some((stress, tangent)) = self.rim(trial, cutoff)
            && stress[1] <= cutoff + rounding
        {
            return (stress, tangent);
        }
        // Two directions at the cut-off, the third where the cone is met.
        let stress = self.rim_corner(cutoff).unwrap_or(tip);
        (stress, [[0.0; 3]; 3])
    }

    /// Where the cone meets the cut-off of the greatest stress. The flow of the cut-off is sought that leaves, once the cone
    /// has drawn in what remains, the greatest stress at the cut-off.
    fn rim(&self, trial: &Three, cutoff: f64) -> Option<(Three, Matrix)> {
        let hooke = hooke(&self.elastic);
        let push = [hooke[0][0], hooke[1][0], hooke[2][0]];
        let at = |amount: f64| {
            let pushed: Three = std::array::from_fn(|i| trial[i] - amount * push[i]);
            self.drawn_in(&pushed)
        };
        let beyond = |amount: f64| at(amount).0[0] - cutoff;
        let (mut low, mut low_value) = (0.0, beyond(0.0));
        let mut high = (trial[0] - cutoff).abs().max(cutoff.abs()) / push[0];
        let mut high_value = beyond(high);
        for _ in 0..60 {
            if high_value <= 0.0 {
                break;
            }
            (low, low_value) = (high, high_value);
            high *= 2.0;
            high_value = beyond(high);
        }
        if !(low_value > 0.0 && high_value <= 0.0) {
            return None;
        }
        // Illinois: false position that halves the weight of an end that stays.
        let mut side = 0;
        for _ in 0..200 {
            let middle = (low * high_value - high * low_value) / (high_value - low_value);
            let middle = if middle > low && middle < high { middle } else { 0.5 * (low + high) };
            if !(middle > low && middle < high) {
                break;
            }
            let value = beyond(middle);
            if value > 0.0 {
                (low, low_value) = (middle, value);
                high_value *= if side == 1 { 0.5 } else { 1.0 };
                side = 1;
            } else {
                (high, high_value) = (middle, value);
                low_value *= if side == -1 { 0.5 } else { 1.0 };
                side = -1;
                if value == 0.0 {
                    break;
                }
            }
        }
        let (mut stress, flow) = at(high);
        stress[0] = cutoff;
        Some((stress, self.rim_tangent(&hooke, &stress, flow)))
    }

    /// Back to the cone alone: stress, and the amount of flow.
    fn drawn_in(&self, stress: &Three) -> (Three, f64) {
        let (radius, deviator, sum) = parts(stress);
        let excess = radius + self.alpha * sum - self.strength;
        if excess <= 0.0 {
            return (*stress, 0.0);
        }
        let (bulk, shear) = (self.elastic.bulk(), self.elastic.shear());
        let flow = excess / (shear + 9.0 * bulk * self.alpha * self.beta);
        if shear * flow > radius {
            return ([self.strength / (3.0 * self.alpha); 3], flow);
        }
        let mean = sum / 3.0 - 3.0 * bulk * self.beta * flow;
        (deviator.map(|d| mean + d * (1.0 - shear * flow / radius)), flow)
    }

    /// Tangent at the rim: elasticity softened by the turning of the cone's flow, less what flow along both takes.
    fn rim_tangent(&self, hooke: &Matrix, stress: &Three, flow: f64) -> Matrix {
        let nothing = [[0.0; 3]; 3];
        let (radius, deviator, _) = parts(stress);
        if !(radius > 0.0) {
            return nothing;
        }
        let along = deviator.map(|d| d / (2.0 * radius));
        let Some(soft) = inverse(hooke) else { return nothing };
        let curvature = |i: usize, j: usize| {
            let unit = if i == j { 2.0 / 3.0 } else { -1.0 / 3.0 };
            (0.5 * unit - along[i] * along[j]) / radius
        };
        let soft: Matrix = std::array::from_fn(|i| std::array::from_fn(|j| soft[i][j] + flow * curvature(i, j)));
        let Some(stiff) = inverse(&soft) else { return nothing };
        let [normals, flows] = [self.alpha, self.beta].map(|slope| [along.map(|a| a + slope), [1.0, 0.0, 0.0]]);
        polyhedron::less_two(&stiff, &normals, &flows, 1e-14)
    }

    /// The stress with its two greatest at the cut-off, on the cone: with σ₃ = t − x, √J2 = x/√3 and I1 = 3t − x.
    fn rim_corner(&self, cutoff: f64) -> Option<Three> {
        let slope = 1.0 / 3.0_f64.sqrt() - self.alpha;
        let left = self.strength - 3.0 * self.alpha * cutoff;
        (slope > 0.0 && left >= 0.0).then(|| [cutoff, cutoff, cutoff - left / slope])
    }
}

/// √J2, deviator and sum of principal stresses.
fn parts(stress: &Three) -> (f64, Three, f64) {
    let sum: f64 = stress.iter().sum();
    let deviator = stress.map(|s| s - sum / 3.0);
    ((0.5 * dot(&deviator, &deviator)).sqrt(), deviator, sum)
}
