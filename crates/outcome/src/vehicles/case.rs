//! What stands where: a case of a vehicle, and the worst one at each of its places.

use super::weights::Weights;
use crate::published::said;
use crate::wire::published;
use crate::words::words;
use serde::{Deserialize, Serialize};

words! {
    /// Which way a vehicle drives.
    pub enum Direction {
        /// To the right.
        Right = "right",
        /// To the left.
        Left = "left",
    }
}

published! {
    /// What stands where.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Case |case| {
        /// Position of the vehicle's first axle, from the left springing of the first span [m].
        pub position: f64 [m],
        /// Which way it drives.
        pub direction: Direction,
        /// Which arrangement: distances and lift-off; empty where there is only one.
        pub arrangement?: String = said(&case.arrangement),
        /// First axle that stands on the bridge, counted from 1 from the front of the vehicle; none where uniform loads stand alone.
        = first_axle: Option<usize> = case.axles.map(|axles| axles[0] + 1),
        /// Last axle that stands on the bridge.
        = last_axle: Option<usize> = case.axles.map(|axles| axles[1] + 1),
        /// First and last axle that stands on the bridge, counted from 0 from the front of the vehicle; none where uniform
        /// loads stand alone.
        pub axles: Option<[usize; 2]> [kept],
        /// The axle with the rule's factor for the critical one.
        pub critical_axle?: Option<usize> = case.critical_axle.map(|axle| axle + 1),
        /// From where to where uniform loads stand [m].
        pub uniform?: Option<[f64; 2]> [m] as uniform_load,
        /// Force along the bridge as a share of all loads, to the right positive: braking or traction.
        pub horizontal: f64 as horizontal_share,
        /// Sum of the loads with their factors on the effective width [N/m].
        pub load: f64 [kN/m],
        /// Factors on the weights of the bridge meanwhile.
        pub weights: Weights as weight_factors,
    }

    /// The least adequacy factor with a vehicle at a place.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct EnvelopePoint |point| {
        /// Position of the vehicle's first axle [m].
        = position: f64 [m] = point.case.position,
        /// Which way it drives.
        = direction: Direction = point.case.direction,
        /// Which arrangement; empty where there is only one.
        = arrangement?: String = said(&point.case.arrangement),
        /// What governs, without its load.
        pub case: Case [kept],
        /// Whether every case there was answered.
        pub converged: bool [kept],
        /// Least adequacy factor over what may stand there; none where a case was not answered or nothing collapses.
        pub adequacy: Option<f64> as adequacy_factor,
        /// Factors on the weights of what governs; none where nothing does.
        pub weights: Option<Weights> [kept],
        /// Least adequacy factor of rigid blocks, where deformable joints were followed too: the adequacy factor is the smaller one then.
        pub rigid: Option<f64> as rigid_factor,
        /// Adequacy factor in balance on deformable joints.
        pub deformable: Option<f64> as deformable_factor,
    }
}

impl EnvelopePoint {
    /// A point that is answered by one case, without its factor.
    pub fn at(case: Case) -> EnvelopePoint {
        let weights = Some(case.weights);
        EnvelopePoint { case, converged: true, adequacy: None, weights, rigid: None, deformable: None }
    }

    /// Whether it is of the same arrangement that drives the same way, at the same place.
    pub(super) fn stands_at(&self, other: &EnvelopePoint) -> bool {
        let place = |of: &EnvelopePoint| (of.case.position, of.case.direction);
        place(self) == place(other) && self.case.arrangement == other.case.arrangement
    }

    /// Takes the factor of a case on deformable joints: where it is the smaller one, it counts, unless a case was not answered.
    pub fn deforms(&mut self, factor: f64, case: &Case) {
        self.deformable = Some(factor);
        if self.converged && self.adequacy.is_none_or(|rigid| factor < rigid) {
            (self.adequacy, self.weights) = (Some(factor), Some(case.weights));
            self.case.clone_from(case);
        }
    }
}
