//! How displacements change with the load factor within a piece of the law: one factorisation, and changes of rank one for the elements that have
//! passed into other pieces since.

use super::element::Piece;
use super::system::System;
use crate::banded::Banded;

/// Most columns that are solved for before the whole is factorised anew; one for so many equations, and some.
const COLUMNS: usize = 32;
const EQUATIONS: usize = 48;
const SOME: usize = 12;
/// Forces through which an element changes that are one: relative.
const ALIKE: f64 = 1e-10;
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

/// An element whose piece has changed since the whole was factorised. All its changes `D` of slope act through a few forces `w` on its blocks, for
/// which the equations are solved once: from chord to chord of crushing one or two of them serve as long as the factors do.
struct Changed {
    element: usize,
    /// How its slope differs from what was factorised.
    more: [[f64; 3]; 3],
    /// Orthonormal `w`, and which column of [`Tangent::solved`] belongs to each.
    through: Vec<[f64; 3]>,
    columns: Vec<usize>,
    /// Its elastic forces with each of the columns.
    elastic: Vec<[f64; 3]>,
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
    changed: Vec<Changed>,
    /// `K^-1 B w`, column by column.
    solved: Vec<Vec<f64>>,
    /// Most of them.
    most_columns: usize,
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
            changed: Vec::new(),
            solved: Vec::new(),
            most_columns: (system.size / EQUATIONS).clamp(SOME, COLUMNS),
        };
        this.anew(pieces);
        this
    }

    /// Factorises the whole.
    pub(super) fn anew(&mut self, pieces: &[Piece]) {
        self.changed.clear();
        self.solved.clear();
        self.shifted = false;
        self.slopes.clear();
        let each = self.system.elements.iter().zip(pieces);
        self.slopes.extend(each.map(|(element, piece)| element.slope(&self.system.shapes, *piece)));
        for shift in [0.0, SHIFT] {
            self.factors.clear();
            for (element, slope) in self.system.elements.iter().zip(&self.slopes) {
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
                for i in 0..6 {
                    for j in 0..6 {
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

    /// Whether elements have changed since the whole was factorised.
    pub(super) fn is_changed(&self) -> bool {
        !self.changed.is_empty()
    }

    /// Tells that an element passes from one piece to another.
    pub(super) fn pass(&mut self, pieces: &[Piece], k: usize) {
        let element = &self.system.elements[k];
        let after = element.slope(&self.system.shapes, pieces[k]);
        let more: [[f64; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|j| after[i][j] - self.slopes[k][i][j]));
        let at = self.changed.iter().position(|changed| changed.element == k).unwrap_or_else(|| {
            let elastic = self.solved.iter().map(|solved| element.elastic(solved)).collect();
            let (through, columns) = (Vec::new(), Vec::new());
            self.changed.push(Changed { element: k, more: [[0.0; 3]; 3], through, columns, elastic });
            self.changed.len() - 1
        });
        for column in 0..3 {
            let force = more.map(|row| row[column]);
            let mut rest = force;
            for w in &self.changed[at].through {
                let share = dot(*w, rest);
                (0..3).for_each(|i| rest[i] -= share * w[i]);
            }
            let (size, left) = (dot(force, force).sqrt(), dot(rest, rest).sqrt());
            if left <= ALIKE * size.max(1.0) {
                continue;
            }
            if self.shifted || self.solved.len() == self.most_columns {
                return self.anew(pieces);
            }
            let w = rest.map(|r| r / left);
            let mut solved = vec![0.0; self.system.size];
            for (i, equation) in element.equations.iter().enumerate() {
                solved[*equation as usize] += (0..3).map(|k| element.parts[k][i] * w[k]).sum::<f64>();
            }
            self.factors.solve(&mut solved);
            self.changed[at].through.push(w);
            self.changed[at].columns.push(self.solved.len());
            for changed in &mut self.changed {
                changed.elastic.push(self.system.elements[changed.element].elastic(&solved));
            }
            self.solved.push(solved);
        }
        self.slopes[k] = after;
        let changed = &mut self.changed[at];
        (0..3).for_each(|i| (0..3).for_each(|j| changed.more[i][j] += more[i][j]));
        if let Some(bond) = self.bond.get(k) {
            let force: [f64; 3] = more.map(|row| dot(row, *bond));
            self.system.add_force(k, force, &mut self.growing);
            for (w, column) in changed.through.iter().zip(&changed.columns) {
                let share = dot(*w, force);
                self.plain.iter_mut().zip(&self.solved[*column]).for_each(|(to, from)| *to += share * from);
            }
        }
    }

    /// The rate within these pieces.
    pub(super) fn rate(&mut self, pieces: &[Piece]) -> Rate {
        let mut displacements = self.plain.clone();
        let mut sign = self.corrected(&mut displacements);
        for attempt in 0..2 {
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
            if attempt == 1 || self.changed.is_empty() {
                let speed = largest(&displacements);
                return Rate { elastic: self.system.elastic(&displacements), displacements, speed, sign };
            }
            self.anew(pieces);
            displacements.clone_from(&self.plain);
            sign = self.corrected(&mut displacements);
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

    /// Turns `K^-1 r` into that of the changed matrix `K + sum B w w^T D B^T` (Woodbury); the sign of its determinant.
    fn corrected(&self, solved: &mut [f64]) -> f64 {
        let count = self.solved.len();
        let mut rows = [[0.0; COLUMNS]; COLUMNS];
        let mut right = [0.0; COLUMNS];
        for changed in &self.changed {
            let element = &self.system.elements[changed.element];
            let own = element.elastic(solved);
            for (w, row) in changed.through.iter().zip(&changed.columns) {
                // Elastic forces are those of closing.
                let by: [f64; 3] = std::array::from_fn(|j| -(0..3).map(|i| w[i] * changed.more[i][j]).sum::<f64>());
                right[*row] = dot(by, own);
                for (to, column) in rows[*row].iter_mut().zip(&changed.elastic) {
                    *to = dot(by, *column);
                }
                rows[*row][*row] += 1.0;
            }
        }
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
            for (row, below) in lower[..count - k - 1].iter_mut().zip(k + 1..) {
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
        for (column, by) in self.solved.iter().zip(&right) {
            solved.iter_mut().zip(column).for_each(|(to, from)| *to -= by * from);
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
