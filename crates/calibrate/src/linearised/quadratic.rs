//! The logarithm of the likelihood of a straight line: a quadratic in the shares for every size of the model's error.

use super::Linearised;
use crate::misfit::record;
use crate::parameter::Parameter;
use crate::posterior::gain::{Gain, Sums};
use crate::posterior::likelihood::Noise;
use crate::problem::Problem;

/// A vector and a symmetric matrix over the parameters, with a constant: $\frac12 x^T P x - h^T x + c$.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Quadratic {
    pub matrix: Vec<Vec<f64>>,
    pub vector: Vec<f64>,
    pub constant: f64,
}

impl Quadratic {
    fn zero(n: usize) -> Self {
        Self { matrix: vec![vec![0.0; n]; n], vector: vec![0.0; n], constant: 0.0 }
    }

    /// Adds half a square of `constant + row x`, times a factor.
    fn add_square(&mut self, row: &[f64], constant: f64, factor: f64) {
        for (i, a) in row.iter().enumerate() {
            for (j, b) in row.iter().enumerate() {
                self.matrix[i][j] += factor * a * b;
            }
            self.vector[i] -= factor * a * constant;
        }
        self.constant += 0.5 * factor * constant * constant;
    }

    /// Adds another, times a factor.
    fn add(&mut self, other: &Self, factor: f64) {
        for (mine, other) in self.matrix.iter_mut().zip(&other.matrix) {
            mine.iter_mut().zip(other).for_each(|(mine, other)| *mine += factor * other);
        }
        self.vector.iter_mut().zip(&other.vector).for_each(|(mine, other)| *mine += factor * other);
        self.constant += factor * other.constant;
    }

    /// Its value.
    pub(super) fn at(&self, x: &[f64]) -> f64 {
        let row = |(row, x_i): (&Vec<f64>, &f64)| x_i * row.iter().zip(x).map(|(a, x)| a * x).sum::<f64>();
        let square: f64 = self.matrix.iter().zip(x).map(row).sum();
        0.5 * square - self.vector.iter().zip(x).map(|(h, x)| h * x).sum::<f64>() + self.constant
    }

    /// What it falls by along each axis.
    pub(super) fn fall(&self, x: &[f64]) -> Vec<f64> {
        let row = |(row, h): (&Vec<f64>, &f64)| h - row.iter().zip(x).map(|(a, x)| a * x).sum::<f64>();
        self.matrix.iter().zip(&self.vector).map(row).collect()
    }
}

/// A number that is a straight line over the parameters: $\mathbf r^T x + c$.
#[derive(Debug, Clone, PartialEq)]
struct Line {
    row: Vec<f64>,
    constant: f64,
}

impl Line {
    fn zero(n: usize) -> Self {
        Self { row: vec![0.0; n], constant: 0.0 }
    }

    fn add(&mut self, row: &[f64], constant: f64, factor: f64) {
        self.row.iter_mut().zip(row).for_each(|(mine, other)| *mine += factor * other);
        self.constant += factor * constant;
    }

    fn at(&self, x: &[f64]) -> f64 {
        self.row.iter().zip(x).map(|(a, x)| a * x).sum::<f64>() + self.constant
    }
}

/// One channel, over the variance of its noise: half the squares of its differences, their product with the response, and the square of
/// the response.
struct Channel {
    squares: Quadratic,
    along: Line,
    response: f64,
}

/// The common gain at places of the straight line, for one size of the model's error.
pub(super) struct GainLine {
    along: Line,
    response: f64,
    deviation: f64,
}

impl GainLine {
    /// What the records leave of it.
    pub(super) fn at(&self, x: &[f64]) -> Gain {
        Sums { along: self.along.at(x), response: self.response, ..Sums::default() }.gain(self.deviation)
    }
}

/// All channels that count, and priors.
pub(super) struct Likelihoods {
    channels: Vec<Channel>,
    prior: Quadratic,
}

impl Likelihoods {
    pub(super) fn new(model: &Linearised, problem: &Problem) -> Self {
        let n = model.parameters.len();
        let mut prior = Quadratic::zero(n);
        for (k, parameter) in model.parameters.iter().enumerate() {
            if let Some((away, rate)) = parameter.prior.linear(parameter, model.at[k]) {
                let mut row = vec![0.0; n];
                row[k] = rate;
                prior.add_square(&row, away, 1.0);
            }
        }
        let counting = (0..problem.channels().len()).filter(|k| problem.channels()[*k].counts());
        Self { channels: counting.filter_map(|k| channel(model, problem, k)).collect(), prior }
    }

    /// Minus the logarithm of the density for one size of the model's error, but for a constant, with a common gain of this standard
    /// deviation; and that gain.
    pub(super) fn with_gains(&self, own: f64, common: f64) -> (Quadratic, GainLine) {
        let mut sum = self.prior.clone();
        let (mut along, mut response) = (Line::zero(sum.vector.len()), 0.0);
        for channel in &self.channels {
            // (C + g² u uᵀ)^-1 by Sherman and Morrison, its determinant by Sylvester.
            let answered = 1.0 + own * own * channel.response;
            sum.add(&channel.squares, 1.0);
            sum.add_square(&channel.along.row, channel.along.constant, -own * own / answered);
            sum.constant += 0.5 * answered.ln();
            along.add(&channel.along.row, channel.along.constant, 1.0 / answered);
            response += channel.response / answered;
        }
        let answered = 1.0 + common * common * response;
        sum.add_square(&along.row, along.constant, -common * common / answered);
        sum.constant += 0.5 * answered.ln();
        (sum, GainLine { along, response, deviation: common })
    }
}

fn channel(model: &Linearised, problem: &Problem, k: usize) -> Option<Channel> {
    let (n, factor) = (model.parameters.len(), 1.0 / Noise::of(problem, k).each());
    if !factor.is_finite() {
        return None;
    }
    let (mut squares, mut response) = (Quadratic::zero(n), 0.0);
    let mut along = Line::zero(n);
    for (place, (value, record)) in model.values[k].iter().zip(&*record(problem, k)).enumerate() {
        let row: Vec<f64> = model.derivatives.iter().map(|derivatives| derivatives[k][place]).collect();
        squares.add_square(&row, value - record, factor);
        along.add(&row, value - record, factor * value);
        response += factor * value * value;
    }
    Some(Channel { squares, along, response })
}

impl crate::posterior::Prior {
    /// A normal prior as a straight line over the share: how many standard deviations the value at a share lies off its mean, and how that grows
    /// with the share; none where the prior is even.
    fn linear(&self, parameter: &Parameter, share: f64) -> Option<(f64, f64)> {
        let (value, slope) = (parameter.at(share), parameter.slope(share));
        match *self {
            Self::Uniform => None,
            Self::Normal { mean, standard_deviation } => {
                Some(((value - mean) / standard_deviation, slope / standard_deviation))
            }
            Self::LogNormal { mean, standard_deviation } => {
                let away = (value.ln() - mean) / standard_deviation;
                away.is_finite().then_some((away, slope / value / standard_deviation))
            }
        }
    }
}
