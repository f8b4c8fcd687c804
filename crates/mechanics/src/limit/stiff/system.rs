//! Blocks between stiff elastic joints: elements, and the order of the equations.

use super::element::{Element, Normal, Piece};
use super::shape::Shape;
use crate::ids::Id;
use crate::limit::equilibrium::Equilibrium;
use crate::limit::joints::Joint;
use crate::numbering::{HELD, numbered};

/// Shear stiffness of a joint over its normal stiffness. From 0.01 to 1 loads of fourteen bridges of two and three rings (`verification/profiles`) change by
/// 1 % at most.
const SHEAR: f64 = 0.01;
/// Stiffness of a force that answers movement, where a joint as long as its blocks are deep has one of one.
const ANSWERING: f64 = 0.01;
/// Most that the length of a joint over the depth of its blocks counts, and one over the least.
const SLENDER: f64 = 10.0;
/// By how much stiffnesses differ from joint to joint: blocks that are alike would reach their limits at once, and no one would be first. Rings that snap
/// to and fro magnify it: with 1e-3 the load of `examples/defects` lay anywhere within 8e-4, with 1e-6 it is one from either side to 1e-8.
const UNLIKE: f64 = 1e-6;
/// The same of loads, over the largest of them.
const SWAY: f64 = 1e-9;

/// Elements between blocks.
#[derive(Debug)]
pub(super) struct System {
    pub elements: Vec<Element>,
    pub shapes: Vec<Shape>,
    /// Number of equations.
    pub size: usize,
    /// The last equation that each one acts with.
    pub last: Vec<u32>,
    /// Where each equation of equilibrium stands here.
    place: Vec<usize>,
    /// Number of forces.
    forces: usize,
}

/// A number between -1 and 1 that looks like none in particular.
fn drawn(seed: usize) -> f64 {
    let mut state = (seed as u64).wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    state = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    state = (state ^ (state >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((state ^ (state >> 31)) >> 11) as f64 / (1u64 << 52) as f64 - 1.0
}

impl System {
    /// Sets elements up for joints and answers to movement.
    pub(super) fn new(equilibrium: &Equilibrium) -> System {
        let joints = &equilibrium.joints;
        let held: Vec<[bool; 3]> = equilibrium.row.iter().map(|row| row.map(|r| r.is_none())).collect();
        let mut block_of = vec![0; equilibrium.rows];
        for (id, row) in equilibrium.row.pairs() {
            row.iter().flatten().for_each(|&r| block_of[r] = id.index());
        }
        let joined = joints.iter().map(|joint| [joint.first.index(), joint.second.index()]);
        let answered = equilibrium.restraints.iter().filter_map(|r| {
            let blocks = equilibrium.columns[r.column].iter().map(|&(row, _)| block_of[row]);
            let (first, last) = (blocks.clone().min()?, blocks.max()?);
            (first != last).then_some([first, last])
        });
        let pairs: Vec<[usize; 2]> = joined.chain(answered).collect();
        let (equation, last) = numbered(&held, &pairs);
        let size = last.len();
        let mut place = vec![0; equilibrium.rows];
        for (row, equation) in equilibrium.row.iter().zip(&equation) {
            for (row, equation) in row.iter().zip(equation) {
                if let Some(row) = row
                    && *equation != HELD
                {
                    place[*row] = *equation as usize;
                }
            }
        }
        let mut this =
            System { elements: Vec::new(), shapes: Vec::new(), size, last, place, forces: equilibrium.columns.len() };
        for (k, joint) in joints.iter().enumerate() {
            let element = this.joint(equilibrium, k, joint);
            this.elements.push(element);
        }
        for (k, r) in equilibrium.restraints.iter().enumerate() {
            let mut element = this.element(equilibrium, r.column, 1, [ANSWERING * unlike(joints.len() + k), 0.0, 0.0]);
            element.normal = Normal::One([0.0, r.most]);
            this.elements.push(element);
        }
        this
    }

    fn joint(&mut self, equilibrium: &Equilibrium, k: usize, joint: &Joint) -> Element {
        let Joint { column, strength, .. } = *joint;
        let count = joint.points.len();
        // The moment of shear about a block's centroid is its depth towards the joint, in units of length.
        let shear = &equilibrium.columns[column + count];
        let turns = |row: usize| equilibrium.row.iter().any(|rows| rows[2] == Some(row));
        let depth = shear.iter().filter(|(row, _)| turns(*row)).map(|(_, v)| v.abs()).sum::<f64>() * equilibrium.length;
        let slender = match joint.length > 0.0 && depth > 0.0 {
            true => (joint.length / depth).clamp(1.0 / SLENDER, SLENDER),
            false => 1.0,
        };
        let normal = slender * unlike(k) / count as f64;
        let mut element = self.element(equilibrium, column, count + 1, [normal, normal, SHEAR * slender * unlike(k)]);
        let scaled = |force: f64| force / equilibrium.force;
        let tension = scaled(strength.tension);
        element.friction = strength.friction;
        element.cohesion = scaled(strength.cohesion);
        // Where compressions sum to less than this, friction and cohesion leave no shear at all.
        let least = match strength.friction {
            friction if friction.is_finite() && friction > 0.0 => element.cohesion / friction,
            _ => f64::INFINITY,
        };
        let crushes = strength.curvature(count) > 0.0;
        element.normal = match count {
            1 => Normal::One([-tension.min(least), f64::INFINITY]),
            _ => {
                let unit = match crushes {
                    true => scaled(strength.crushing) + 2.0 * tension,
                    false if tension > 0.0 => tension,
                    false => 1.0,
                };
                let shape = match crushes {
                    true => Shape::of_crushing(tension / unit, least / unit),
                    false => Shape::of_tension(tension / unit, least / unit),
                };
                let known = self.shapes.iter().position(|known| *known == shape);
                let shape = known.unwrap_or_else(|| {
                    self.shapes.push(shape);
                    self.shapes.len() - 1
                });
                Normal::Two { shape, unit }
            }
        };
        element
    }

    /// An element of so many forces from this column on; with three at most two of which are compressions.
    fn element(&self, equilibrium: &Equilibrium, column: usize, forces: usize, stiffness: [f64; 3]) -> Element {
        let (mut equations, mut parts) = ([0; 6], [[0.0; 6]; 3]);
        for (at, (row, own)) in equilibrium.parts(column..column + forces).into_iter().enumerate() {
            equations[at] = self.place[row] as u32;
            (0..forces).for_each(|k| parts[place(k, forces)][at] = own[k]);
        }
        let stiffness = [stiffness[0], if forces == 3 { stiffness[1] } else { 0.0 }, stiffness[2]];
        Element {
            column,
            forces,
            equations,
            parts,
            stiffness,
            normal: Normal::One([0.0, f64::INFINITY]),
            friction: f64::INFINITY,
            cohesion: 0.0,
        }
    }

    /// Loads of equilibrium in the order of the equations, each a little off.
    pub(super) fn ordered(&self, loads: &[f64]) -> Vec<f64> {
        let largest = loads.iter().fold(0.0f64, |most, load| most.max(load.abs()));
        let mut ordered = vec![0.0; self.size];
        for (row, load) in loads.iter().enumerate() {
            ordered[self.place[row]] = load + SWAY * largest * drawn(row);
        }
        ordered
    }

    /// Displacements as velocities of equilibrium.
    pub(super) fn velocities(&self, displacements: &[f64]) -> Vec<f64> {
        self.place.iter().map(|place| displacements[*place]).collect()
    }

    /// Elastic forces of displacements, element by element.
    pub(super) fn elastic(&self, displacements: &[f64]) -> Vec<[f64; 3]> {
        self.elements.iter().map(|element| element.elastic(displacements)).collect()
    }

    /// Forces in the columns of equilibrium.
    pub(super) fn columns(&self, pieces: &[Piece], elastic: &[[f64; 3]]) -> Vec<f64> {
        let mut forces = vec![0.0; self.forces];
        for ((element, piece), elastic) in self.elements.iter().zip(pieces).zip(elastic) {
            let carried = element.carried(&self.shapes, *piece, *elastic);
            for k in 0..element.forces {
                forces[element.column + k] = carried[place(k, element.forces)];
            }
        }
        forces
    }

    /// Adds the forces of elements, so many times, to the equations.
    pub(super) fn add_forces(&self, forces: impl Iterator<Item = [f64; 3]>, to: &mut [f64]) {
        forces.enumerate().for_each(|(k, forces)| self.add_force(k, forces, to));
    }

    /// Adds forces of one element.
    pub(super) fn add_force(&self, k: usize, forces: [f64; 3], to: &mut [f64]) {
        let element = &self.elements[k];
        for (part, force) in element.parts.iter().zip(forces).filter(|(_, force)| *force != 0.0) {
            for (equation, value) in element.equations.iter().zip(part) {
                to[*equation as usize] += value * force;
            }
        }
    }

    /// What is out of balance under loads in the order of the equations.
    pub(super) fn unbalanced(&self, pieces: &[Piece], elastic: &[[f64; 3]], loads: &[f64]) -> Vec<f64> {
        let mut left = loads.to_vec();
        let each = self.elements.iter().zip(pieces).zip(elastic);
        self.add_forces(
            each.map(|((element, piece), elastic)| element.carried(&self.shapes, *piece, *elastic)),
            &mut left,
        );
        left
    }
}

/// Where one of so many forces stands: shear in the third place, also beside one compression.
fn place(k: usize, forces: usize) -> usize {
    if forces > 1 && k + 1 == forces { 2 } else { k }
}

fn unlike(seed: usize) -> f64 {
    1.0 + UNLIKE * drawn(seed)
}
