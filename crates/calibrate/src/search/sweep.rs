//! One parameter over its range (railway paper, section 3.5): the norm, every channel's error, and what they rank.

use crate::basis::{Basis, Halt};
use crate::evaluator::Evaluator;
use crate::parameter::Parameter;
use crate::search::surface::Minimum;
use serde::{Deserialize, Serialize};

/// A parameter varied alone, all others as in `model`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Sweep {
    /// Which parameter.
    pub parameter: usize,
    /// The model about which it was varied.
    pub model: Vec<f64>,
    /// Its values, both bounds included.
    pub values: Vec<f64>,
    /// Norm at each value; none where the model failed.
    pub norms: Vec<Option<f64>>,
    /// Errors by value and channel; empty where the model failed.
    pub errors: Vec<Vec<f64>>,
    /// Where the norm is least and how decided its trough is; none where the model failed everywhere.
    pub minimum: Option<Minimum>,
}

impl Sweep {
    /// Value at the least norm, or the model's where there is none.
    pub fn best(&self) -> f64 {
        self.minimum.map_or(self.model[self.parameter], |minimum| self.values[minimum.place])
    }

    /// Least norm.
    pub fn least(&self) -> f64 {
        self.norms.iter().flatten().copied().fold(f64::INFINITY, f64::min)
    }

    /// Largest norm.
    pub fn most(&self) -> f64 {
        self.norms.iter().flatten().copied().fold(f64::NEG_INFINITY, f64::max)
    }

    /// Error range: largest norm less the least; zero where there is none.
    pub fn range(&self) -> f64 {
        (self.most() - self.least()).max(0.0)
    }

    /// Range of one channel's error over the sweep (the paper's Table 5).
    pub fn error_range(&self, channel: usize) -> f64 {
        let errors = self.errors.iter().filter_map(|errors| errors.get(channel)).filter(|error| error.is_finite());
        let (low, high) = errors.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), e| (l.min(*e), h.max(*e)));
        (high - low).max(0.0)
    }

    /// Mean of the error ranges of the channels that count (last row of Table 5); `weights` are by channel.
    pub fn mean_error_range(&self, weights: &[f64]) -> f64 {
        let counting: Vec<usize> = (0..weights.len()).filter(|k| weights[*k] > 0.0).collect();
        counting.iter().map(|k| self.error_range(*k)).sum::<f64>() / counting.len().max(1) as f64
    }
}

/// Points of a sweep.
fn points(ranges: &[Parameter], model: &[f64], parameter: usize, count: usize) -> Vec<Vec<f64>> {
    let with = |value| {
        let mut point = model.to_vec();
        point[parameter] = value;
        point
    };
    ranges[parameter].grid(count).into_iter().map(with).collect()
}

/// Varies several parameters (their places in the problem), each alone, about one model; all points are evaluated in one batch.
///
/// # Errors
/// A stop by the onlooker.
pub fn sweeps(
    evaluator: &mut Evaluator,
    basis: &Basis,
    (ranges, model): (&[Parameter], &[f64]),
    parameters: &[usize],
    count: usize,
) -> Result<Vec<Sweep>, Halt> {
    let all: Vec<Vec<Vec<f64>>> = parameters.iter().map(|p| points(ranges, model, *p, count)).collect();
    let fits = basis.fits(evaluator, &all.concat())?;
    let sweep = |(k, fits): (usize, &[Option<crate::misfit::Fit>])| {
        let parameter = parameters[k];
        let norms: Vec<Option<f64>> =
            fits.iter().map(|fit| fit.as_ref().map(|fit| fit.norm).filter(|norm| norm.is_finite())).collect();
        let errors = |fit: &Option<crate::misfit::Fit>| {
            fit.as_ref().map_or_else(Vec::new, |fit| fit.channels.iter().map(|channel| channel.error).collect())
        };
        Sweep {
            parameter,
            model: model.to_vec(),
            values: all[k].iter().map(|point| point[parameter]).collect(),
            minimum: Minimum::of(&norms),
            errors: fits.iter().map(errors).collect(),
            norms,
        }
    };
    let count = all.first().map_or(1, Vec::len).max(1);
    Ok(fits.chunks(count).enumerate().map(sweep).collect())
}

/// Parameters in the order of a figure of their sweeps, largest first; the order of the parameters decides between equals.
pub fn ranking(sweeps: &[Sweep], figure: impl Fn(&Sweep) -> f64) -> Vec<usize> {
    let mut order: Vec<&Sweep> = sweeps.iter().collect();
    order.sort_by(|a, b| figure(b).total_cmp(&figure(a)));
    order.into_iter().map(|sweep| sweep.parameter).collect()
}
