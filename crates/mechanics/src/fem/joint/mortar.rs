//! A bed of mortar between two stones: springs across, a panel along.

use super::{PairLaw, PairMemory, PairResponse, PairState};

/// How much tension a mortar spring takes before it lets go.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LiftOff {
    /// A force of each pair [N per metre of width].
    Force(f64),
    /// A stress [Pa].
    Stress(f64),
}

impl LiftOff {
    /// As a stress [Pa] over an area [m].
    #[must_use]
    pub fn stress(self, area: f64) -> f64 {
        match self {
            LiftOff::Stress(stress) => stress,
            LiftOff::Force(force) if area > 0.0 => force / area,
            LiftOff::Force(_) => 0.0,
        }
    }
}

/// Springs across the bed that lift off and may crush, and a shear panel with a strength along it.
///
/// A pair that is broken carries no tension. One that is whole and has a strength holds, whatever the tension: [`super::JointLaw::overstress`] tells how far that is
/// beyond the strength, and whoever seeks balance breaks the pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mortar {
    /// Normal stiffness per area [Pa/m]: modulus over thickness.
    pub normal: f64,
    /// Tangential stiffness per area [Pa/m].
    pub tangential: f64,
    /// Tension at which it lifts off.
    pub lift_off: LiftOff,
    /// Compressive strength [Pa], beyond which the bed is crushed for good.
    pub compressive_strength: Option<f64>,
    /// Shear strength [Pa]; elastic, perfectly plastic.
    pub shear_strength: f64,
    /// Whether the panel still carries shear where the springs have lifted off, as separate panels of stone would.
    /// If not, shear vanishes there and the pair starts unstressed where it closes again.
    pub shear_when_open: bool,
}

impl Mortar {
    /// A bed of a modulus [Pa], a Poisson's ratio and a thickness [m], without strength in tension and of a shear strength [Pa].
    #[must_use]
    pub fn bed(modulus: f64, ratio: f64, thickness: f64, shear_strength: f64) -> Mortar {
        let normal = modulus / thickness;
        Mortar {
            normal,
            tangential: normal / (2.0 * (1.0 + ratio)),
            lift_off: LiftOff::Stress(0.0),
            compressive_strength: None,
            shear_strength,
            shear_when_open: false,
        }
    }

    /// Tension [Pa] at which a pair breaks; none where it is broken.
    #[inline(always)]
    fn tensile_strength(&self, area: f64, old: &PairMemory) -> f64 {
        if old.broken { 0.0 } else { self.lift_off.stress(area) }
    }

    /// Tension over the strength of a pair that is whole; nothing for one that is broken.
    pub(super) fn overstress(&self, tension: f64, area: f64, old: &PairMemory) -> f64 {
        let strength = self.tensile_strength(area, old);
        if strength > 0.0 { tension / strength } else { 0.0 }
    }

    /// Normal stress [Pa], its stiffness [Pa/m], where the compression would vanish [m], and whether the pair has lifted off.
    fn across(&self, opening: f64, area: f64, old: &PairMemory) -> (f64, f64, f64, bool) {
        let stress = self.normal * (opening - old.crush);
        if stress > 0.0 && self.tensile_strength(area, old) <= 0.0 {
            return (0.0, 0.0, old.crush, true);
        }
        match self.compressive_strength {
            Some(strength) if stress < -strength => (-strength, 0.0, opening + strength / self.normal, false),
            _ => (stress, self.normal, old.crush, false),
        }
    }

    /// Shear stress [Pa], its stiffness [Pa/m], the slip [m], and whether the panel is at its strength.
    fn along(&self, opening: f64, old: &PairMemory) -> (f64, f64, f64, bool) {
        let shear = self.tangential * (opening - old.slip);
        if shear.abs() <= self.shear_strength {
            return (shear, self.tangential, old.slip, false);
        }
        let shear = self.shear_strength.copysign(shear);
        (shear, 0.0, opening - shear / self.tangential, true)
    }

    /// Whether all of many openings are within its strengths.
    #[inline(always)]
    pub(super) fn surely_holds<const L: usize>(&self, opening: &[[f64; L]; 2], area: f64, old: &PairMemory) -> bool {
        let tension = self.tensile_strength(area, old);
        let crushed = self.compressive_strength.map_or(f64::NEG_INFINITY, |strength| -strength);
        let mut holds = true;
        for lane in 0..L {
            let stress = self.normal * (opening[0][lane] - old.crush);
            let shear = self.tangential * (opening[1][lane] - old.slip);
            holds &= (stress <= tension) & (stress >= crushed) & (shear.abs() <= self.shear_strength);
        }
        holds
    }
}

impl PairLaw for Mortar {
    fn respond(&self, opening: [f64; 2], area: f64, old: &PairMemory) -> PairResponse {
        let (normal, across, crush, open) = self.across(opening[0], area, old);
        let (shear, along, slip, slides) =
            if open && !self.shear_when_open { (0.0, 0.0, opening[1], false) } else { self.along(opening[1], old) };
        let state = match (open, slides) {
            (true, _) => PairState::Open,
            (false, true) => PairState::Sliding,
            (false, false) => PairState::Closed,
        };
        PairResponse {
            traction: [normal, shear],
            tangent: [[across, 0.0], [0.0, along]],
            memory: PairMemory { slip, crush, broken: old.broken || open, state },
            state,
        }
    }
}
