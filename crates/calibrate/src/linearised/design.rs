//! What readings would tell before anyone takes them: which of them narrow the parameters most.
//!
//! With the model as a straight line, and noise, gains and model error normal, what readings leave of the parameters is a normal distribution whose
//! covariance does not depend on what is read: it is known beforehand (Chaloner and Verdinelli 1995, Statistical Science 10(3), 273-304). A range counts as
//! the normal distribution of its variance, a twelfth of its square. Information is the fall of entropy: half the binary logarithm of the ratio of
//! the determinants (Lindley 1956, Annals of Mathematical Statistics 27(4), 986-1005). As a model is no straight line, it is taken in the mean of
//! models from all over the ranges.

use super::{Linearised, stated};
use crate::parameter::{Parameter, values};
use crate::posterior::draw::latin_hypercube;
use crate::posterior::likelihood::{Likelihood, ModelError};
use crate::problem::Problem;
use faer::{Mat, Side};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

/// Variance of a share that may be anything from 0 to 1.
const RANGE: f64 = 1.0 / 12.0;

/// A reading: its channel, and its place among the values of the channel.
pub type Reading = (usize, usize);

/// Readings that may be taken, each a row over the unknowns and over its uncertainty. The unknowns: the gain that all channels share where it is
/// uncertain, a gain of each channel where the model has an error, then shares of the parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    rows: Vec<Vec<Vec<f64>>>,
    /// Variances of the unknowns before anything is read.
    prior: Vec<f64>,
    parameters: usize,
}

/// What some readings would tell.
#[derive(Debug, Clone, PartialEq)]
pub struct Expected {
    /// What they would tell of all parameters together [bit].
    pub information: f64,
    /// Standard deviations that they would leave, by parameter [shares of the ranges].
    pub deviations: Vec<f64>,
}

impl Linearised {
    /// The readings of a problem that count. Channels without an uncertainty take one in its place, as for [`Linearised::left`].
    pub fn design(&self, problem: &Problem, likelihood: &Likelihood) -> Design {
        let (problem, _) = stated(problem);
        let model_error = match likelihood.model_error {
            ModelError::None => 0.0,
            ModelError::Known(size) | ModelError::Sought(size) => size,
        };
        let channels = if model_error > 0.0 { self.values.len() } else { 0 };
        let common = usize::from(likelihood.common_gain > 0.0);
        let mut prior = vec![likelihood.common_gain.powi(2); common];
        prior.extend(vec![model_error.powi(2); channels]);
        prior.extend(vec![RANGE; self.parameters.len()]);
        let row = |channel: usize, place: usize, deviation: f64| {
            let mut row = vec![0.0; prior.len()];
            let over = |value: f64| value / deviation;
            let value = over(self.values[channel][place]);
            row[..common].fill(value);
            if channels > 0 {
                row[common + channel] = value;
            }
            let own = self.derivatives.iter().map(|derivatives| over(derivatives[channel][place]));
            row[common + channels..].iter_mut().zip(own).for_each(|(to, from)| *to = from);
            row
        };
        let rows = |(channel, values): (usize, &Vec<f64>)| {
            let own = &problem.channels()[channel];
            let deviation = own.uncertainty.filter(|deviation| own.counts() && *deviation > 0.0);
            deviation.map_or_else(Vec::new, |one| (0..values.len()).map(|place| row(channel, place, one)).collect())
        };
        let rows = self.values.iter().enumerate().map(rows).collect();
        Design { rows, prior, parameters: self.parameters.len() }
    }
}

impl Design {
    /// What these readings would tell; those of channels that do not count tell nothing.
    pub fn of(&self, readings: impl IntoIterator<Item = Reading>) -> Expected {
        let mut known = self.nothing();
        self.add(&mut known, readings);
        self.expected(&known)
    }

    /// Precisions of the unknowns before anything is read.
    fn nothing(&self) -> Mat<f64> {
        Mat::from_fn(self.prior.len(), self.prior.len(), |i, j| if i == j { 1.0 / self.prior[i] } else { 0.0 })
    }

    fn add(&self, known: &mut Mat<f64>, readings: impl IntoIterator<Item = Reading>) {
        for row in readings.into_iter().filter_map(|(channel, place)| self.rows.get(channel)?.get(place)) {
            for (j, right) in row.iter().enumerate().filter(|(_, right)| **right != 0.0) {
                for (i, left) in row.iter().enumerate() {
                    known[(i, j)] += left * right;
                }
            }
        }
    }

    /// The last block of the Cholesky factor is that of the parameters' own precision, whatever the gains are.
    fn expected(&self, known: &Mat<f64>) -> Expected {
        let (count, first) = (self.parameters, self.prior.len() - self.parameters);
        let Ok(factor) = known.llt(Side::Lower) else {
            return Expected { information: f64::NAN, deviations: vec![f64::NAN; count] };
        };
        let lower = factor.L();
        let at = |i: usize, j: usize| lower[(first + i, first + j)];
        let mut variances = vec![0.0; count];
        for (k, variance) in variances.iter_mut().enumerate() {
            // Column k of the factor's inverse.
            let mut column = vec![0.0; count];
            for i in k..count {
                let own = if i == k { 1.0 } else { 0.0 };
                column[i] = (own - (k..i).map(|j| at(i, j) * column[j]).sum::<f64>()) / at(i, i);
            }
            *variance = column.iter().map(|value| value * value).sum();
        }
        let information = (0..count).map(|i| at(i, i).log2() + 0.5 * RANGE.log2()).sum();
        Expected { information, deviations: variances.into_iter().map(f64::sqrt).collect() }
    }
}

/// So many points all over the ranges: every parameter has one in each of as many equal parts of its range.
pub fn models(parameters: &[Parameter], count: usize, seed: u64) -> Vec<Vec<f64>> {
    let drawn = latin_hypercube(&mut ChaCha8Rng::seed_from_u64(seed), count, parameters.len());
    drawn.iter().map(|shares| values(parameters, shares)).collect()
}

/// What some readings would tell by several models: information is its mean, deviations are those of the first.
pub fn of(designs: &[Design], readings: &[Reading]) -> Expected {
    mean(designs.iter().map(|design| design.of(readings.iter().copied())))
}

/// Groups of readings in the order in which each adds most to those before it in the mean of several models, up to so many, with what all up to
/// it would tell. The first of equals goes first; groups that add nothing are left out.
pub fn in_order(designs: &[Design], groups: &[Vec<Reading>], most: usize) -> Vec<(usize, Expected)> {
    let mut known: Vec<Mat<f64>> = designs.iter().map(Design::nothing).collect();
    let (mut left, mut order): (Vec<usize>, Vec<(usize, Expected)>) = ((0..groups.len()).collect(), Vec::new());
    while order.len() < most {
        let with = |group: &usize| {
            mean(designs.iter().zip(&known).map(|(design, known)| {
                let mut known = known.clone();
                design.add(&mut known, groups[*group].iter().copied());
                design.expected(&known)
            }))
        };
        let tried = left.iter().map(with).enumerate();
        let best = tried.reduce(|best, next| if next.1.information > best.1.information + EQUAL { next } else { best });
        let before = order.last().map_or(0.0, |(_, expected)| expected.information);
        let Some((k, expected)) = best.filter(|(_, expected)| expected.information > before + LEAST) else { break };
        let group = left.remove(k);
        for (design, known) in designs.iter().zip(&mut known) {
            design.add(known, groups[group].iter().copied());
        }
        order.push((group, expected));
    }
    order
}

fn mean(all: impl Iterator<Item = Expected>) -> Expected {
    let all: Vec<Expected> = all.collect();
    let information = all.iter().map(|one| one.information).sum::<f64>() / all.len().max(1) as f64;
    Expected { information, deviations: all.into_iter().next().map_or_else(Vec::new, |first| first.deviations) }
}

/// What a group must add to be told [bit].
const LEAST: f64 = 1e-3;
/// What two groups that tell the same may differ by in round-off [bit].
const EQUAL: f64 = 1e-6;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Channel, Misfit};

    /// Two parameters; a reading of each, and one of both.
    fn line(values: Vec<Vec<f64>>, derivatives: Vec<Vec<Vec<f64>>>) -> (Linearised, Problem) {
        let parameters = vec![Parameter::new("a", "", 0.5, 0.0, 1.0), Parameter::new("b", "", 0.5, 0.0, 1.0)];
        let channel =
            |values: &Vec<f64>| Channel { uncertainty: Some(0.1), ..Channel::readings("c", "mm", values.clone()) };
        let problem =
            Problem::new(parameters.clone(), values.iter().map(channel).collect(), Misfit::default()).unwrap();
        (Linearised { parameters, at: vec![0.5; 2], values, derivatives }, problem)
    }

    fn exact(common_gain: f64, model_error: ModelError) -> Likelihood {
        Likelihood { model_error, common_gain, ..Likelihood::default() }
    }

    #[test]
    fn readings_leave_what_precisions_that_add_up_leave() {
        let (line, problem) =
            line(vec![vec![1.0, 1.0, 1.0]], vec![vec![vec![1.0, 0.0, 1.0]], vec![vec![0.0, 2.0, 2.0]]]);
        let design = line.design(&problem, &exact(0.0, ModelError::None));
        // One reading with slope 1 over 0.1: precision 12 + 100, that of the other stays 12.
        let one = design.of([(0, 0)]);
        assert!((one.deviations[0] - 112.0_f64.powf(-0.5)).abs() < 1e-12);
        assert!((one.deviations[1] - 12.0_f64.powf(-0.5)).abs() < 1e-12);
        assert!((one.information - 0.5 * (112.0_f64 / 12.0).log2()).abs() < 1e-12);
        // All three: [[212, 200], [200, 812]].
        let all = design.of([(0, 0), (0, 1), (0, 2)]);
        let determinant = 212.0 * 812.0 - 200.0 * 200.0;
        assert!((all.deviations[0] - (812.0_f64 / determinant).sqrt()).abs() < 1e-12);
        assert!((all.deviations[1] - (212.0_f64 / determinant).sqrt()).abs() < 1e-12);
        assert!((all.information - 0.5 * (determinant / 144.0).log2()).abs() < 1e-12);
        assert!(design.of([]).information.abs() < 1e-12);
    }

    #[test]
    fn groups_come_in_the_order_in_which_they_tell_most() {
        let (line, problem) =
            line(vec![vec![1.0; 4]], vec![vec![vec![1.0, 1.1, 0.0, 0.0]], vec![vec![0.0, 0.0, 0.9, 0.0]]]);
        let design = line.design(&problem, &exact(0.0, ModelError::None));
        let groups: Vec<Vec<Reading>> = (0..4).map(|place| vec![(0, place)]).collect();
        let order: Vec<usize> =
            in_order(std::slice::from_ref(&design), &groups, 10).into_iter().map(|(group, _)| group).collect();
        // The second tells most; the first adds less to it than the third, though it tells more alone; the fourth tells nothing.
        assert_eq!(order, [1, 2, 0]);
        assert_eq!(in_order(std::slice::from_ref(&design), &groups, 1).len(), 1);
        let told: Vec<f64> = in_order(std::slice::from_ref(&design), &groups, 10)
            .into_iter()
            .map(|(_, expected)| expected.information)
            .collect();
        assert!((told[2] - design.of([(0, 0), (0, 1), (0, 2)]).information).abs() < 1e-12 && told.is_sorted());
    }

    /// Of two models each tells another reading better: in the mean of both the reading counts that tells something by either.
    #[test]
    fn groups_are_put_in_order_by_the_mean_of_models() {
        let of = |slopes: [f64; 3]| {
            let (line, problem) = line(vec![vec![1.0; 3]], vec![vec![slopes.to_vec()], vec![vec![0.0; 3]]]);
            line.design(&problem, &exact(0.0, ModelError::None))
        };
        let designs = [of([3.0, 0.0, 1.0]), of([0.0, 3.0, 2.0])];
        let groups: Vec<Vec<Reading>> = (0..3).map(|place| vec![(0, place)]).collect();
        let first = |designs: &[Design]| in_order(designs, &groups, 1)[0].0;
        assert_eq!([first(&designs[..1]), first(&designs[1..]), first(&designs)], [0, 1, 2]);
        let both = super::of(&designs, &groups.concat());
        let each = designs.each_ref().map(|design| design.of(groups.concat()).information);
        assert!((both.information - 0.5 * (each[0] + each[1])).abs() < 1e-12);
    }

    /// A parameter that scales all that is read is not told from a gain that all share: its variance goes to that of the gain over its slope.
    #[test]
    fn gains_hide_what_goes_with_all_readings() {
        let values: Vec<f64> = (1..=50).map(|k| 10.0 * f64::from(k)).collect();
        let slope: Vec<f64> = values.iter().map(|value| 2.0 * value).collect();
        let (line, problem) = line(vec![values], vec![vec![slope], vec![vec![0.0; 50]]]);
        let all = || (0..50).map(|place| (0, place));
        for (likelihood, gain) in [
            (exact(0.05, ModelError::None), 0.05),
            (exact(0.0, ModelError::Known(0.03)), 0.03),
            (exact(0.04, ModelError::Sought(0.03)), 0.05),
        ] {
            let found = line.design(&problem, &likelihood).of(all());
            let least = (12.0 + (2.0_f64 / gain).powi(2)).powf(-0.5);
            assert!((found.deviations[0] / least - 1.0).abs() < 1e-4, "{} {least}", found.deviations[0]);
        }
    }
}
