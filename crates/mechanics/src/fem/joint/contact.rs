//! Coulomb friction between two faces.

use super::{PairMemory, PairResponse, PairState};

/// Frictional contact by penalty: stiff, never quite rigid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Normal stiffness per area [Pa/m].
    pub normal: f64,
    /// Tangential stiffness per area [Pa/m].
    pub tangential: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// Cohesion [Pa]: shear that is carried without any pressure, as long as the faces touch.
    pub cohesion: f64,
    /// Whether the faces may come apart. If not, they hold together in tension, and slide as far as their friction, on
    /// compression alone, and their cohesion allow.
    pub separation: bool,
    /// Pressure [Pa] over which friction sets in where the faces hold together: the corner of the strength at no pressure is rounded
    /// by a hyperbola, and half the friction of this pressure remains there. Zero leaves the corner, at which Newton's method may go
    /// to and fro for ever.
    pub rounding: f64,
}

impl Contact {
    /// Strength in shear [Pa] under a normal traction, and its derivative.
    fn strength(&self, normal: f64) -> (f64, f64) {
        let length = if self.separation { 0.0 } else { normal.hypot(self.rounding) };
        if length > 0.0 && self.rounding > 0.0 {
            let pressure = 0.5 * (length - normal);
            (self.cohesion + self.friction * pressure, 0.5 * self.friction * (normal / length - 1.0))
        } else {
            let pressed = if normal < 0.0 { self.friction } else { 0.0 };
            (self.cohesion - pressed * normal, -pressed)
        }
    }

    /// Whether all `L` openings [m] leave the contact closed and its shear below its strength; where the strength is a root, by
    /// more than rounding.
    #[inline(always)]
    pub(super) fn provably_linear<const L: usize>(&self, opening: &[[f64; L]; 2], old: &PairMemory) -> bool {
        const ROUNDING: f64 = 1e-14;
        let most = if self.separation { 0.0 } else { f64::INFINITY };
        let rounds = !self.separation && self.rounding > 0.0;
        let mut holds = self.friction >= 0.0;
        for lane in 0..L {
            let normal = self.normal * opening[0][lane];
            let shear = self.tangential * (opening[1][lane] - old.slip);
            let length = (normal * normal + self.rounding * self.rounding).sqrt();
            // Where it overflows nothing is sure.
            let hyperbola =
                if length <= f64::MAX { 0.5 * ((1.0 - ROUNDING) * length - normal) } else { f64::NEG_INFINITY };
            let straight = if normal < 0.0 { -normal } else { 0.0 };
            let strength = self.cohesion + self.friction * if rounds { hyperbola } else { straight };
            holds &= (normal <= most) & (shear.abs() <= strength);
        }
        holds
    }

    /// Answers an opening [m] of a pair.
    #[must_use]
    pub fn respond(&self, opening: [f64; 2], old: &PairMemory) -> PairResponse {
        let normal = self.normal * opening[0];
        let shear = self.tangential * (opening[1] - old.slip);
        let (strength, slope) = self.strength(normal);
        let (state, traction, along, slip) = if self.separation && normal > 0.0 {
            (PairState::Open, [0.0; 2], [0.0; 2], opening[1])
        } else if shear.abs() <= strength {
            (PairState::Closed, [normal, shear], [0.0, self.tangential], old.slip)
        } else {
            let way = 1.0_f64.copysign(shear);
            let shear = way * strength;
            let by_pressure = way * slope * self.normal;
            (PairState::Sliding, [normal, shear], [by_pressure, 0.0], opening[1] - shear / self.tangential)
        };
        let open = state == PairState::Open;
        PairResponse {
            traction,
            tangent: [[if open { 0.0 } else { self.normal }, 0.0], along],
            memory: PairMemory { slip, broken: old.broken || open, state, ..*old },
            state,
        }
    }
}
