//! Two parameters over their ranges (railway paper, section 3.6): the norm as a surface, its least point, and whether
//! that is a trough.

use crate::basis::{Basis, Halt};
use crate::evaluator::Evaluator;
use crate::parameter::Parameter;
use serde::{Deserialize, Serialize};

/// A trough is decided where, from the minimum, the norm rises on each side that has points by at least this share of the least norm; on a
/// surface this is asked of the profile, the least norm over the other parameter.
const SHARE: f64 = 0.05;

/// And by at least this norm: a tenth of a per cent of the peaks, less than a least count shows.
const RISE: f64 = 0.001;

/// Least point of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Minimum {
    /// Its place among the values.
    pub place: usize,
    /// The norm there.
    pub norm: f64,
    /// Whether it is the first or the last place.
    pub at_bound: bool,
    /// The smaller of the rises on its two sides, or the one rise where it stands at a bound.
    pub rise: f64,
    /// Whether the trough, or the descent to the bound, is decided.
    pub decided: bool,
}

impl Minimum {
    /// The least point of a curve with its verdict; none where no point has a norm.
    pub fn of(norms: &[Option<f64>]) -> Option<Self> {
        let known = norms.iter().enumerate().filter_map(|(k, norm)| norm.map(|norm| (k, norm)));
        let (place, norm) = known.reduce(|best, next| if next.1 < best.1 { next } else { best })?;
        let rise = |side: &[Option<f64>]| side.iter().flatten().map(|other| other - norm).reduce(f64::max);
        let rises = [rise(&norms[..place]), rise(&norms[place + 1..])];
        let rise = rises.into_iter().flatten().reduce(f64::min).unwrap_or(0.0);
        let decided = rise >= (SHARE * norm).max(RISE);
        Some(Self { place, norm, at_bound: place == 0 || place + 1 == norms.len(), rise, decided })
    }
}

/// Where the least point of a surface lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Case {
    /// Inside for both parameters.
    Interior,
    /// On a bound for one of them.
    OneAtBound,
    /// On a bound for both.
    BothAtBound,
}

impl Case {
    /// As results write it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Interior => "interior",
            Self::OneAtBound => "one-at-bound",
            Self::BothAtBound => "both-at-bound",
        }
    }
}

/// Two parameters varied together, all others as in `model`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Surface {
    /// The primary and the secondary parameter.
    pub parameters: [usize; 2],
    /// The model about which they were varied.
    pub model: Vec<f64>,
    /// Values of each.
    pub values: [Vec<f64>; 2],
    /// Norms, the secondary parameter changing fastest; none where the model failed.
    pub norms: Vec<Option<f64>>,
    /// Least point of the profile of each parameter, at the same point of the surface.
    pub minima: [Minimum; 2],
    /// Where the least point lies.
    pub case: Case,
}

impl Surface {
    /// The model at the least point.
    pub fn best(&self) -> Vec<f64> {
        let mut point = self.model.clone();
        for side in 0..2 {
            point[self.parameters[side]] = self.values[side][self.minima[side].place];
        }
        point
    }

    /// Least norm.
    pub fn norm(&self) -> f64 {
        self.minima[0].norm
    }
}

/// Evaluates the surface of two parameters (their places in the problem) in one batch; none where the model failed everywhere.
///
/// # Errors
/// A stop by the onlooker.
pub fn surface(
    evaluator: &mut Evaluator,
    basis: &Basis,
    (ranges, model): (&[Parameter], &[f64]),
    parameters: [usize; 2],
    count: usize,
) -> Result<Option<Surface>, Halt> {
    let values = parameters.map(|parameter| ranges[parameter].grid(count));
    let (rows, columns) = (values[0].len(), values[1].len());
    let point = |k: usize| {
        let mut point = model.to_vec();
        point[parameters[0]] = values[0][k / columns];
        point[parameters[1]] = values[1][k % columns];
        point
    };
    let points: Vec<Vec<f64>> = (0..rows * columns).map(point).collect();
    let fits = basis.fits(evaluator, &points)?;
    let norms: Vec<Option<f64>> =
        fits.iter().map(|fit| fit.as_ref().map(|fit| fit.norm).filter(|norm| norm.is_finite())).collect();
    let least = |places: &mut dyn Iterator<Item = usize>| places.filter_map(|k| norms[k]).reduce(f64::min);
    let along_first: Vec<_> = (0..rows).map(|i| least(&mut (0..columns).map(|j| i * columns + j))).collect();
    let along_second: Vec<_> = (0..columns).map(|j| least(&mut (0..rows).map(|i| i * columns + j))).collect();
    let Some((first, second)) = Minimum::of(&along_first).zip(Minimum::of(&along_second)) else {
        return Ok(None);
    };
    let case = match (first.at_bound, second.at_bound) {
        (false, false) => Case::Interior,
        (true, true) => Case::BothAtBound,
        _ => Case::OneAtBound,
    };
    Ok(Some(Surface { parameters, model: model.to_vec(), values, norms, minima: [first, second], case }))
}
