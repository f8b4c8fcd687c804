//! Sliding without dilation, followed from blocks at rest to their collapse.
//!
//! Friction without dilation has no theorem of a largest load: what blocks carry depends on the self-stress that they have come to. Here it comes
//! about as it does in blocks: between joints that are a little elastic, and bonded at first, the weight is carried while the bond is let go, then the
//! load grows. As stiffness multiplies displacements alone, and geometry is that of the blocks as built, the load at which they move without end is
//! one of rigid blocks: its forces are in equilibrium and keep to the true law, its mechanism slides level, and how stiff joints are to one another
//! decides only between states of self-stress (the analysis of Livesley 1978 with the flow rule of Drucker 1954 given up; as a complementarity problem Ferris and
//! Tin-Loi 2001).
//!
//! `element` has the law of a joint with the polygon of its compressions in `shape`, `system` puts blocks together, `rates` solves, `way` follows.

mod element;
mod rates;
mod shape;
mod system;
mod way;

use super::equilibrium::Equilibrium;
use super::program::Solution;
use crate::watch::CancelToken;
use element::Piece;
use rates::{Tangent, largest};
use system::System;
use way::{End, Load, State, Way, follow};

/// By how much bond is stronger than it has to be at first, relative.
const MORE: f64 = 1e-3;
/// Scaled forces that nothing has to hold.
const ROUND_OFF: f64 = 1e-14;

/// Blocks under their permanent loads.
#[derive(Debug)]
pub(super) struct Stood {
    system: System,
    state: State,
    /// Displacement of elastic blocks whose joints open nowhere.
    elastic: f64,
}

/// What is carried where sliding does not dilate.
pub(super) enum WithoutDilation {
    /// A load: the mechanism in which blocks give way, the scaled factors there and of the largest load on the way to it, and whether it comes and goes:
    /// the load is then the largest, the motion that which leads on from it, and the first of both factors the least since.
    Load { solution: Solution, spread: [f64; 2], comes_and_goes: bool },
    /// Every load, as far as blocks are followed.
    Locks,
    /// What blocks carry depends on how hard they are jammed, which no way tells.
    Jammed,
    /// The way has no end.
    Unsettled,
}

/// Puts the permanent loads on; none where blocks move without end under them, or where the way to rest has no end.
pub(super) fn stood(equilibrium: &Equilibrium) -> Option<Stood> {
    let system = System::new(equilibrium);
    let weight = system.ordered(&equilibrium.permanent);
    let displacements = elastic(&system, &weight);
    let unit = largest(&displacements);
    if !unit.is_finite() {
        return None;
    }
    let (state, bond) = bonded(&system, displacements);
    // Forces hold what bond does not, and are let go with it.
    let without = bond.iter().map(|bond| bond.map(|b| -b));
    let mut held = system.unbalanced(&state.pieces, &state.elastic, &weight);
    system.add_forces(without, &mut held);
    held.iter_mut().for_each(|force| *force = if force.abs() > ROUND_OFF { -*force } else { 0.0 });
    let load = Load {
        constant: &weight,
        growing: &held,
        bond: &bond,
        direction: -1.0,
        goal: Some(0.0),
        elastic: [unit, unit],
    };
    let way = follow(&system, state, &load, &CancelToken::default());
    (way.end == End::Reached).then_some(Stood { state: State { factor: 0.0, ..way.state }, system, elastic: unit })
}

impl Stood {
    /// Lets the variable loads grow.
    pub(super) fn under(&self, equilibrium: &Equilibrium, carried: f64) -> WithoutDilation {
        let system = &self.system;
        let weight = system.ordered(&equilibrium.permanent);
        let growing = system.ordered(&equilibrium.variable);
        let unit = largest(&elastic(system, &growing));
        let load = Load {
            constant: &weight,
            growing: &growing,
            bond: &[],
            direction: 1.0,
            goal: None,
            elastic: [self.elastic, unit],
        };
        let way = follow(system, self.state.clone(), &load, &equilibrium.token);
        match way.end {
            End::Far if way.state.factor > carried => WithoutDilation::Locks,
            End::Mechanism | End::Far | End::Wanders => {
                let comes_and_goes = way.end == End::Wanders;
                let spread = [if comes_and_goes { way.least } else { way.state.factor }, way.most];
                WithoutDilation::Load { solution: self.solution(equilibrium, &way), spread, comes_and_goes }
            }
            End::Reached | End::Lost => WithoutDilation::Unsettled,
        }
    }

    fn solution(&self, equilibrium: &Equilibrium, way: &Way) -> Solution {
        debug_assert_eq!(way.velocities.len(), equilibrium.rows, "one velocity for each equation");
        Solution {
            solved: true,
            forces: self.system.columns(&way.state.pieces, &way.state.elastic),
            factor: way.state.factor,
            velocities: self.system.velocities(&way.velocities),
            iterations: way.steps as u32,
        }
    }
}

/// Displacements of blocks whose joints open, crush and slide nowhere.
fn elastic(system: &System, loads: &[f64]) -> Vec<f64> {
    let bonded: Vec<_> = system.elements.iter().map(|_| Piece::BONDED).collect();
    Tangent::new(system, &bonded, loads, &[]).rate(&bonded).displacements
}

/// Elastic blocks, and a bond of all joints that lets them be so.
fn bonded(system: &System, displacements: Vec<f64>) -> (State, Vec<[f64; 3]>) {
    let mut elastic = system.elastic(&displacements);
    let each = system.elements.iter().zip(&elastic).map(|(element, elastic)| element.bond(*elastic));
    let bond = (1.0 + MORE) * each.fold(0.0, f64::max);
    let bonds: Vec<[f64; 3]> = system.elements.iter().map(|element| element.bound_by(bond)).collect();
    for (elastic, bond) in elastic.iter_mut().zip(&bonds) {
        elastic.iter_mut().zip(bond).for_each(|(y, b)| *y += b);
    }
    let pieces = system.elements.iter().zip(&elastic).map(|(e, y)| e.piece(&system.shapes, *y)).collect();
    (State { displacements, elastic, pieces, factor: 1.0 }, bonds)
}
