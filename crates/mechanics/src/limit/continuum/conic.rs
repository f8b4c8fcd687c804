//! Conic programs in standard form, and Clarabel's interior-point method that solves them.
//!
//! Stresses, contact forces and the load factor are the variables, equilibrium the equations. They are handed to the solver as its dual
//! problem: the velocities are then what it seeks, and there are fewer of them than stresses.

use crate::limit::interior_point::{Accuracy, compressed, minimise};
use crate::watch::CancelToken;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{NonnegativeConeT, SecondOrderConeT, SolverStatus, SupportedConeT, ZeroConeT};
use std::ops::Range;

#[cfg(test)]
mod polygons;

/// Minimises `cost z` subject to `A z = b`, where each variable is free, not negative, or one of three in a cone.
#[derive(Debug, Clone, Default)]
pub(super) struct Conic {
    /// The right side, an entry for each equation.
    right: Vec<f64>,
    /// Entries of each variable: equation and coefficient.
    columns: Vec<Vec<(usize, f64)>>,
    kinds: Vec<Kind>,
    cost: Vec<f64>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Free,
    Positive,
    /// `z0 >= |(z1, z2)|`, at the first of the three.
    Cone,
    /// The second and third.
    Member,
}

/// A number that depends on the variables in a straight line.
#[derive(Debug, Clone, Default)]
pub(super) struct Affine {
    /// Variables and their coefficients.
    pub terms: Vec<(usize, f64)>,
    /// What is there without them.
    pub constant: f64,
}

impl Affine {
    /// One variable.
    pub(super) fn of(variable: usize) -> Affine {
        Affine { terms: vec![(variable, 1.0)], constant: 0.0 }
    }
    /// `coefficient` times this added to `sum`.
    pub(super) fn add_to(&self, sum: &mut Affine, coefficient: f64) {
        sum.terms.extend(self.terms.iter().map(|&(i, v)| (i, v * coefficient)));
        sum.constant += coefficient * self.constant;
    }
    /// So many times this.
    pub(super) fn times(&self, coefficient: f64) -> Affine {
        Affine::sum(&[(coefficient, self)])
    }
    /// The sum of several, each times its coefficient.
    pub(super) fn sum(parts: &[(f64, &Affine)]) -> Affine {
        let mut sum = Affine::default();
        parts.iter().for_each(|(c, part)| part.add_to(&mut sum, *c));
        sum
    }
    /// Its value.
    pub(super) fn at(&self, variables: &[f64]) -> f64 {
        self.terms.iter().fold(self.constant, |sum, &(i, v)| sum + v * variables[i])
    }
}

/// How a program ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Ending {
    /// To its tolerance, or nearly.
    Solved,
    /// At rest before that: whether it is an answer is for the checks of what it returned to say.
    Early,
    /// The cost falls without end.
    Endless,
    /// Without an answer.
    Unknown,
    /// Stopped on the way.
    Cancelled,
}

/// What a program returned.
#[derive(Debug, Clone)]
pub(super) struct Solved {
    pub ending: Ending,
    /// All variables.
    pub variables: Vec<f64>,
    /// A multiplier for each equation.
    pub multipliers: Vec<f64>,
    /// By how much the least cost may be missed for what the equations leave unbalanced, and for what the multipliers price wrongly: each
    /// residual times its multiplier, to first order.
    pub errors: [f64; 2],
    pub iterations: u32,
}

/// How many times the [errors](Solved::errors) count. The load is a concave function of what is left unbalanced, and the multiplier its slope
/// there: where it grows with a power of that, of no less than a third as with the tension of a cut, three times the slope covers all that
/// was gained.
pub(super) const WORTH: f64 = 3.0;

/// How programs are solved: first the quick way, and where what it returns is no answer, the careful one. What answers is for the checks of its
/// certificate to say. At Bridgemill the quick way takes two thirds of the time of the careful one.
pub(super) const EFFORTS: [Accuracy; 2] = [
    Accuracy { tolerance: 1e-8, nearly: 1e-5, iterations: 200, refinements: 0 },
    Accuracy { tolerance: 1e-10, nearly: 1e-5, iterations: 200, refinements: 10 },
];

impl Conic {
    /// A new equation with its right side.
    pub(super) fn equation(&mut self, right: f64) -> usize {
        self.right.push(right);
        self.right.len() - 1
    }
    /// A new variable of any sign.
    pub(super) fn free(&mut self) -> usize {
        self.variable(Kind::Free)
    }
    /// A new variable that is not negative.
    pub(super) fn positive(&mut self) -> usize {
        self.variable(Kind::Positive)
    }
    /// Three new variables, the first no less than the length of the others.
    pub(super) fn cone(&mut self) -> usize {
        let first = self.variable(Kind::Cone);
        self.variable(Kind::Member);
        self.variable(Kind::Member);
        first
    }
    fn variable(&mut self, kind: Kind) -> usize {
        self.kinds.push(kind);
        self.columns.push(Vec::new());
        self.cost.push(0.0);
        self.kinds.len() - 1
    }
    /// Adds to an equation what depends on the variables.
    pub(super) fn add(&mut self, equation: usize, coefficient: f64, what: &Affine) {
        if coefficient == 0.0 {
            return;
        }
        for &(variable, v) in &what.terms {
            self.columns[variable].push((equation, v * coefficient));
        }
        self.right[equation] -= coefficient * what.constant;
    }
    /// How many variables and equations there are.
    pub(super) fn size(&self) -> [usize; 2] {
        [self.kinds.len(), self.right.len()]
    }
    /// What some variables put into equations, each times its multiplier, but for equations that are their own.
    pub(super) fn power(&self, variables: &Range<usize>, own: &Range<usize>, found: &Solved) -> f64 {
        let of = |j: usize| self.columns[j].iter().filter(|(i, _)| !own.contains(i)).map(move |&(i, v)| (i, v, j));
        variables.clone().flat_map(of).map(|(i, v, j)| v * found.variables[j] * found.multipliers[i]).sum::<f64>().abs()
    }
    /// Demands that a number is not negative. Gives the equation.
    pub(super) fn at_least_zero(&mut self, what: &Affine) -> usize {
        let slack = self.positive();
        let equation = self.equation(0.0);
        self.add(equation, 1.0, what);
        self.add(equation, -1.0, &Affine::of(slack));
        equation
    }
    /// Demands that a number is zero.
    pub(super) fn zero(&mut self, what: &Affine) {
        let equation = self.equation(0.0);
        self.add(equation, 1.0, what);
    }
    /// What a variable costs.
    pub(super) fn cost(&mut self, variable: usize, cost: f64) {
        self.cost[variable] = cost;
    }

    /// Solves it until what is made of the solution is an answer.
    pub(super) fn answer<T>(&self, token: &CancelToken, of: impl Fn(Solved) -> Result<T, Ending>) -> Result<T, Ending> {
        let mut found = Err(Ending::Unknown);
        for accuracy in EFFORTS {
            found = of(self.solve(accuracy, token));
            if !matches!(found, Err(Ending::Unknown | Ending::Early)) {
                break;
            }
        }
        found
    }

    /// Solves it.
    fn solve(&self, accuracy: Accuracy, token: &CancelToken) -> Solved {
        let failed = |ending| Solved {
            ending,
            variables: vec![0.0; self.kinds.len()],
            multipliers: vec![0.0; self.right.len()],
            errors: [f64::INFINITY; 2],
            iterations: 0,
        };
        let (order, cones) = self.order();
        let (a, b) = self.transposed(&order);
        let q: Vec<f64> = self.right.iter().map(|r| -r).collect();
        if token.is_cancelled() {
            return failed(Ending::Cancelled);
        }
        let p = CscMatrix::zeros((q.len(), q.len()));
        let Some(found) = minimise((&p, &q), (&a, &b), &cones, accuracy, token) else {
            return failed(Ending::Unknown);
        };
        let mut variables = vec![0.0; self.kinds.len()];
        for (&variable, &value) in order.iter().zip(&found.z) {
            variables[variable] = value;
        }
        let ending = match found.status {
            SolverStatus::Solved | SolverStatus::AlmostSolved => Ending::Solved,
            SolverStatus::CallbackTerminated => Ending::Cancelled,
            // What the solver seeks are the multipliers: none are feasible.
            SolverStatus::PrimalInfeasible => Ending::Endless,
            SolverStatus::InsufficientProgress | SolverStatus::MaxIterations | SolverStatus::NumericalError => {
                Ending::Early
            }
            _ => Ending::Unknown,
        };
        let multipliers = found.x.clone();
        let errors = [self.unbalanced(&variables, &multipliers), self.mispriced(&variables, &multipliers)];
        Solved { ending, variables, multipliers, errors, iterations: found.iterations }
    }

    /// What the equations leave, each times its multiplier.
    fn unbalanced(&self, variables: &[f64], multipliers: &[f64]) -> f64 {
        let mut left: Vec<f64> = self.right.iter().map(|r| -r).collect();
        for (column, z) in self.columns.iter().zip(variables) {
            column.iter().for_each(|&(i, v)| left[i] += v * z);
        }
        left.iter().zip(multipliers).map(|(r, x)| (r * x).abs()).sum()
    }

    /// How far the prices of variables lie outside of what their kind allows, each times the variable.
    fn mispriced(&self, variables: &[f64], multipliers: &[f64]) -> f64 {
        let price = |j: usize| self.cost[j] - self.columns[j].iter().map(|&(i, v)| v * multipliers[i]).sum::<f64>();
        let of = |j: usize| match self.kinds[j] {
            Kind::Free => (price(j) * variables[j]).abs(),
            Kind::Positive => (-price(j)).max(0.0) * variables[j].abs(),
            // The first of three is no less than the others together.
            Kind::Cone => (price(j + 1).hypot(price(j + 2)) - price(j)).max(0.0) * variables[j].abs(),
            Kind::Member => 0.0,
        };
        (0..self.kinds.len()).map(of).sum()
    }

    /// Free variables, then those that are not negative, then cones.
    fn order(&self) -> (Vec<usize>, Vec<SupportedConeT<f64>>) {
        let of =
            |wanted: &[Kind]| (0..self.kinds.len()).filter(|&i| wanted.contains(&self.kinds[i])).collect::<Vec<_>>();
        let (free, positive, in_cones) = (of(&[Kind::Free]), of(&[Kind::Positive]), of(&[Kind::Cone, Kind::Member]));
        let mut cones = vec![ZeroConeT(free.len()), NonnegativeConeT(positive.len())];
        cones.extend((0..in_cones.len() / 3).map(|_| SecondOrderConeT(3)));
        ([free, positive, in_cones].concat(), cones)
    }

    /// The matrix with a row for each variable, in the given order, and a column for each equation.
    fn transposed(&self, order: &[usize]) -> (CscMatrix<f64>, Vec<f64>) {
        let mut by_equation: Vec<Vec<(usize, f64)>> = vec![Vec::new(); self.right.len()];
        for (row, &variable) in order.iter().enumerate() {
            for &(equation, v) in &self.columns[variable] {
                match by_equation[equation].last_mut() {
                    Some(last) if last.0 == row => last.1 += v,
                    _ => by_equation[equation].push((row, v)),
                }
            }
        }
        by_equation.iter_mut().for_each(|column| column.retain(|(_, v)| *v != 0.0));
        (compressed(order.len(), &by_equation), order.iter().map(|&i| self.cost[i]).collect())
    }
}
