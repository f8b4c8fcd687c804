//! Contact laws of particles, by pair of groups.

use crate::blocks::{ContactLaw, LawTable};
use crate::ids::{GroupId, Id};
use serde::Serialize;

/// What a step needs of the law between two groups of particles.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(in crate::dem) struct PairLaw {
    /// Coefficient of friction.
    pub friction: f64,
    /// Shear that a closed contact carries without compression [N/m]: cohesion times length, the length being
    /// `length + share * (r1 + r2)`.
    pub cohesion: f64,
    pub cohesion_share: f64,
}

/// Stiffness of a contact [Pa]: stiffness per unit area times length, times `share` for the shear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::dem) struct ContactStiffness {
    pub normal: f64,
    pub shear: f64,
    /// Length that the contact stands for [m].
    pub length: f64,
}

/// Stiffness of a contact of two bodies whose centres stand `distance` [m] apart along the normal when they touch and
/// whose contact stands for `length` [m] unless the law fixes it.
pub(in crate::dem) fn stiffness(law: &ContactLaw, distance: f64, length: f64) -> ContactStiffness {
    let length = law.fixed_length.unwrap_or(length);
    ContactStiffness { normal: law.normal.at(distance) * length, shear: law.shear.at(distance) * length, length }
}

/// The laws between the groups that have particles.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub(in crate::dem) struct PairLaws {
    /// Groups of particles, and the number that each particle carries in place of its group.
    pub groups: Vec<GroupId>,
    pub pairs: Vec<PairLaw>,
}

impl PairLaws {
    /// Laws between `groups`.
    pub(super) fn new(groups: Vec<GroupId>, laws: &LawTable) -> PairLaws {
        let pair = |a: GroupId, b: GroupId| {
            let law = laws.between(a, b);
            let (cohesion, cohesion_share) = match law.fixed_length {
                Some(length) => (law.cohesion * length, 0.0),
                None => (0.0, law.cohesion),
            };
            PairLaw { friction: law.friction, cohesion, cohesion_share }
        };
        let pairs = groups.iter().flat_map(|&a| groups.iter().map(move |&b| (a, b))).map(|(a, b)| pair(a, b)).collect();
        PairLaws { groups, pairs }
    }
    /// The number of the law between two kinds of particles.
    pub(super) fn index(&self, a: u8, b: u8) -> u8 {
        a * self.groups.len() as u8 + b
    }
    /// The number of a group.
    pub(super) fn kind(&self, group: GroupId) -> Option<u8> {
        self.groups.iter().position(|g| g.index() == group.index()).map(|k| k as u8)
    }
}
