//! How displacements change with the load factor within a piece of the law: one factorisation, and changes of rank one for the elements that have
//! passed into other pieces since.

use super::element::Piece;
use super::system::System;
use crate::banded::Banded;

/// Elements that may change before the whole is factorised anew.
const CHANGES: usize = 24;
/// What rates may leave of the equations: relative to the loads, and to the rates times the stiffness of one.
const LEFT: [f64; 2] = [1e-12, 1e-14];
/// Diagonal where a matrix has no inverse: blocks that nothing holds.
const SHIFT: f64 = 1e-13;

/// Displacements for each unit of the load factor.
pub(super) struct Rate {
    pub displacements: Vec<f64>,
    /// The largest of them.
    pub speed: f64,
    /// Elastic forces of each element with them, without bond.
    pub elastic: Vec<[f64; 3]>,
    /// Sign of the determinant.
    pub sign: f64,
}

/// `K + sum a b^T` of one change after the other.
pub(super) struct Change {
    /// `K^-1 a`.
    solved: Vec<f64>,
    /// `b`, over the equations of an element.
    element: usize,
    by: [f64; 6],
}

/// The factorised tangent.
pub(super) struct Tangent<'a> {
    system: &'a System,
    /// Loads of a factor of one.
    loads: &'a [f64],
    /// Bond of a factor of one.
    bond: &'a [[f64; 3]],
    /// What grows: the loads, and what bond adds to the forces of elements beside their limits.
    growing: Vec<f64>,
    /// How forces change with elastic ones, element by element.
    slopes: Vec<[[f64; 3]; 3]>,
    factors: Banded,
    shifted: bool,
    /// Since the whole was factorised.
    pub changes: Vec<Change>,
    /// `I + b^T K^-1 a`, row by row.
    coupling: Vec<Vec<f64>>,
    /// `K^-1` of the loads.
    plain: Vec<f64>,
}

impl<'a> Tangent<'a> {
    pub(super) fn new(system: &'a System, pieces: &[Piece], loads: &'a [f64], bond: &'a [[f64; 3]]) -> Tangent<'a> {
        let mut this = Tangent {
            system,
            loads,
            bond,
            plain: Vec::new(),
            growing: Vec::new(),
            slopes: Vec::new(),
            factors: Banded::new(system.last.clone()),
            shifted: false,
            changes: Vec::new(),
            coupling: Vec::new(),
        };
        this.anew(pieces);
        this
    }

    /// Factorises the whole.
    pub(super) fn anew(&mut self, pieces: &[Piece]) {
        self.changes.clear();
        self.coupling.clear();
        self.shifted = false;
        self.slopes.clear();
        let each = self.system.elements.iter().zip(pieces);
        self.slopes.extend(each.map(|(element, piece)| element.slope(&self.system.shapes, *piece)));
        for shift in [0.0, SHIFT] {
            self.factors.clear();
            for (element, slope) in self.system.elements.iter().zip(&self.slopes) {
                let count = element.equations.len();
                // D k B^T, then B in front of it.
                let mut inner = [[0.0; 6]; 3];
                for (row, slope) in inner.iter_mut().zip(slope) {
                    for k in 0..3 {
                        let value = slope[k] * element.stiffness[k];
                        if value != 0.0 {
                            row.iter_mut().zip(&element.parts[k]).for_each(|(to, part)| *to += value * part);
                        }
                    }
                }
                for i in 0..count {
                    for j in 0..count {
                        let value = (0..3).map(|k| element.parts[k][i] * inner[k][j]).sum::<f64>();
                        if value != 0.0 {
                            self.factors.add(element.equations[i] as usize, element.equations[j] as usize, value);
                        }
                    }
                }
            }
            if shift > 0.0 {
                (0..self.system.size).for_each(|k| self.factors.add(k, k, shift));
                self.shifted = true;
            }
            if self.factors.factorise() {
                break;
            }
        }
        self.growing.clear();
        self.growing.extend(self.loads);
        let each = self.slopes.iter().zip(self.bond);
        let each = each.map(|(slope, bond)| std::array::from_fn(|k| dot(slope[k], *bond) - bond[k]));
        self.system.add_forces(each, &mut self.growing);
        self.plain.clone_from(&self.growing);
        self.factors.solve(&mut self.plain);
    }

    /// Tells that an element passes from one piece to another, whose tangents differ by a matrix of rank one.
    pub(super) fn pass(&mut self, pieces: &[Piece], k: usize) {
        if self.changes.len() >= CHANGES || self.shifted {
            return self.anew(pieces);
        }
        let element = &self.system.elements[k];
        let after = element.slope(&self.system.shapes, pieces[k]);
        let before = std::mem::replace(&mut self.slopes[k], after);
        let more: [[f64; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|j| after[i][j] - before[i][j]));
        // The largest entry's row and column span the rest.
        let (mut row, mut column) = (0, 0);
        for i in 0..3 {
            for j in 0..3 {
                if more[i][j].abs() > more[row][column].abs() {
                    (row, column) = (i, j);
                }
            }
        }
        let pivot = more[row][column];
        if pivot == 0.0 {
            return;
        }
        let a: [f64; 3] = std::array::from_fn(|i| more[i][column] / pivot);
        let b = more[row];
        let rest = (0..3).flat_map(|i| (0..3).map(move |j| (i, j))).map(|(i, j)| (more[i][j] - a[i] * b[j]).abs());
        if rest.fold(0.0, f64::max) > 1e-12 * pivot.abs() {
            return self.anew(pieces);
        }
        let mut solved = vec![0.0; self.system.size];
        for (i, equation) in element.equations.iter().enumerate() {
            solved[*equation as usize] = (0..3).map(|k| element.parts[k][i] * a[k]).sum();
        }
        if let Some(bond) = self.bond.get(k) {
            let more = dot(b, *bond);
            self.growing.iter_mut().zip(&solved).for_each(|(to, from)| *to += more * from);
            self.factors.solve(&mut solved);
            self.plain.iter_mut().zip(&solved).for_each(|(to, from)| *to += more * from);
        } else {
            self.factors.solve(&mut solved);
        }
        let by = std::array::from_fn(|i| (0..3).map(|k| element.parts[k][i] * element.stiffness[k] * b[k]).sum());
        for (row, change) in self.coupling.iter_mut().zip(&self.changes) {
            row.push(over(self.system, change, &solved));
        }
        self.changes.push(Change { solved, element: k, by });
        let newest = &self.changes[self.changes.len() - 1];
        let mut row: Vec<f64> = self.changes.iter().map(|change| over(self.system, newest, &change.solved)).collect();
        *row.last_mut().expect("the newest") += 1.0;
        self.coupling.push(row);
    }

    /// The rate within these pieces.
    pub(super) fn rate(&mut self, pieces: &[Piece]) -> Rate {
        for attempt in 0..2 {
            let mut displacements = self.plain.clone();
            let sign = self.corrected(&mut displacements);
            for _ in 0..4 {
                let elastic = self.system.elastic(&displacements);
                let left = self.left(&elastic);
                let speed = largest(&displacements);
                if !(largest(&left) > LEFT[0] * largest(&self.growing) + LEFT[1] * speed) {
                    return Rate { displacements, speed, elastic, sign };
                }
                let mut more = left;
                self.factors.solve(&mut more);
                self.corrected(&mut more);
                displacements.iter_mut().zip(more).for_each(|(to, more)| *to += more);
            }
            if attempt == 1 || self.changes.is_empty() {
                let speed = largest(&displacements);
                return Rate { elastic: self.system.elastic(&displacements), displacements, speed, sign };
            }
            self.anew(pieces);
        }
        unreachable!("the second attempt returns")
    }

    /// What the loads leave beside the rates of elastic forces.
    fn left(&self, elastic: &[[f64; 3]]) -> Vec<f64> {
        let mut left = self.growing.clone();
        let each = self.slopes.iter().zip(elastic);
        self.system.add_forces(each.map(|(slope, elastic)| slope.map(|row| dot(row, *elastic))), &mut left);
        left
    }

    /// Turns `K^-1 r` into that of the changed matrix; the sign of its determinant.
    fn corrected(&self, solved: &mut [f64]) -> f64 {
        let count = self.changes.len();
        let mut right: Vec<f64> = self.changes.iter().map(|change| over(self.system, change, solved)).collect();
        let mut rows = [[0.0; CHANGES]; CHANGES];
        rows.iter_mut().zip(&self.coupling).for_each(|(row, of)| row[..count].copy_from_slice(of));
        let mut sign = f64::from(self.factors.sign);
        for k in 0..count {
            let pivot = (k..count).max_by(|a, b| rows[*a][k].abs().total_cmp(&rows[*b][k].abs())).unwrap_or(k);
            if pivot != k {
                rows.swap(k, pivot);
                right.swap(k, pivot);
                sign = -sign;
            }
            let diagonal = match rows[k][k] {
                0.0 => f64::EPSILON,
                value => value,
            };
            rows[k][k] = diagonal;
            sign *= diagonal.signum();
            let (upper, lower) = rows.split_at_mut(k + 1);
            for (row, below) in lower.iter_mut().zip(k + 1..) {
                let share = row[k] / diagonal;
                if share != 0.0 {
                    row[k..count].iter_mut().zip(&upper[k][k..count]).for_each(|(to, from)| *to -= share * from);
                    right[below] -= share * right[k];
                }
            }
        }
        for k in (0..count).rev() {
            let sum: f64 = (k + 1..count).map(|j| rows[k][j] * right[j]).sum();
            right[k] = (right[k] - sum) / rows[k][k];
        }
        for (change, by) in self.changes.iter().zip(&right) {
            solved.iter_mut().zip(&change.solved).for_each(|(to, from)| *to -= by * from);
        }
        sign
    }

    /// Displacements that balance what is out of balance, to first order.
    pub(super) fn balanced(&self, unbalanced: &[f64]) -> Vec<f64> {
        let mut solved = unbalanced.to_vec();
        self.factors.solve(&mut solved);
        self.corrected(&mut solved);
        solved
    }
}

/// Largest size; infinite where one is no number. Eight at once: one by one each waits for the last, a tenth of the time of five rings.
pub(super) fn largest(values: &[f64]) -> f64 {
    let mut most = [0.0f64; 8];
    for some in values.chunks(8) {
        for (most, value) in most.iter_mut().zip(some) {
            let size = if value.is_finite() { value.abs() } else { f64::INFINITY };
            *most = if size > *most { size } else { *most };
        }
    }
    most.into_iter().fold(0.0, f64::max)
}

/// The sum of products.
pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn over(system: &System, change: &Change, vector: &[f64]) -> f64 {
    let equations = &system.elements[change.element].equations;
    equations.iter().zip(change.by).map(|(equation, by)| by * vector[*equation as usize]).sum()
}
