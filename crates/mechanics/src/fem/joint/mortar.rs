//! A bed of mortar between two stones: springs across, a panel along.

use super::{PairMemory, PairResponse, PairState};

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

/// What a bed carries along itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shear {
    /// A panel of a strength that knows no pressure; elastic, perfectly plastic.
    Panel {
        /// Shear strength [Pa].
        strength: f64,
        /// Whether the panel still carries shear where the springs have lifted off, as separate panels of stone would.
        /// If not, shear vanishes there and the pair starts unstressed where it closes again.
        when_open: bool,
    },
    /// Coulomb's law: cohesion and friction on what presses, less what pulls, and nothing where the springs have lifted off.
    /// Cohesion is a bond: a pair that has once opened keeps its friction alone.
    Friction {
        /// Coefficient of friction.
        coefficient: f64,
        /// Cohesion [Pa].
        cohesion: f64,
    },
}

impl Shear {
    /// Strength [Pa] under a normal stress, and its derivative.
    #[inline(always)]
    fn strength(&self, normal: f64, broken: bool) -> (f64, f64) {
        match *self {
            Shear::Panel { strength, .. } => (strength, 0.0),
            Shear::Friction { coefficient, cohesion } => {
                let strength = if broken { 0.0 } else { cohesion } - coefficient * normal;
                if strength > 0.0 { (strength, -coefficient) } else { (0.0, 0.0) }
            }
        }
    }

    /// Whether strength depends on what presses.
    #[must_use]
    pub fn frictional(&self) -> bool {
        matches!(self, Shear::Friction { coefficient, .. } if *coefficient > 0.0)
    }
}

/// Tension over cohesion up to which a pair holds that has a bond and no strength in tension: the bond is lost in one event, as a strength in
/// tension is, so that the state that is found does not depend on the way there.
const BOND: f64 = 1e-6;

/// Springs across the bed that lift off and may crush, and what resists shear along it.
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
    /// What resists shear.
    pub shear: Shear,
}

impl Mortar {
    /// Tension [Pa] at which a pair breaks; none where it is broken.
    #[inline(always)]
    fn tensile_strength(&self, area: f64, old: &PairMemory) -> f64 {
        if old.broken {
            return 0.0;
        }
        let bond = match self.shear {
            Shear::Friction { cohesion, .. } => BOND * cohesion,
            Shear::Panel { .. } => 0.0,
        };
        self.lift_off.stress(area).max(bond)
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

    /// Shear stress [Pa] under a normal stress and its stiffness [Pa/m], its stiffnesses along normal and tangential opening [Pa/m], the slip
    /// [m], and whether it is at its strength.
    fn along(&self, opening: f64, (normal, across): (f64, f64), old: &PairMemory) -> (f64, [f64; 2], f64, bool) {
        let shear = self.tangential * (opening - old.slip);
        let (strength, slope) = self.shear.strength(normal, old.broken);
        if shear.abs() <= strength {
            return (shear, [0.0, self.tangential], old.slip, false);
        }
        let way = 1.0_f64.copysign(shear);
        let shear = way * strength;
        (shear, [way * slope * across, 0.0], opening - shear / self.tangential, true)
    }

    /// Whether all `L` openings [m] keep the stresses within the strengths of the joint.
    #[inline(always)]
    pub(super) fn provably_linear<const L: usize>(&self, opening: &[[f64; L]; 2], area: f64, old: &PairMemory) -> bool {
        let tension = self.tensile_strength(area, old);
        let crushed = self.compressive_strength.map_or(f64::NEG_INFINITY, |strength| -strength);
        let mut holds = true;
        for lane in 0..L {
            let stress = self.normal * (opening[0][lane] - old.crush);
            let shear = self.tangential * (opening[1][lane] - old.slip);
            let (strength, _) = self.shear.strength(stress, old.broken);
            holds &= (stress <= tension) & (stress >= crushed) & (shear.abs() <= strength);
        }
        holds
    }

    /// Answers an opening [m] of a pair that stands for an area [m² per metre of width, so m].
    #[must_use]
    pub fn respond(&self, opening: [f64; 2], area: f64, old: &PairMemory) -> PairResponse {
        let (normal, across, crush, open) = self.across(opening[0], area, old);
        let carries = !open || matches!(self.shear, Shear::Panel { when_open: true, .. });
        let (shear, along, slip, slides) =
            if !carries { (0.0, [0.0; 2], opening[1], false) } else { self.along(opening[1], (normal, across), old) };
        let state = match (open, slides) {
            (true, _) => PairState::Open,
            (false, true) => PairState::Sliding,
            (false, false) => PairState::Closed,
        };
        PairResponse {
            traction: [normal, shear],
            tangent: [[across, 0.0], along],
            memory: PairMemory { slip, crush, broken: old.broken || open, state },
            state,
        }
    }
}
