//! The misfit of a model (railway paper, section 3.4): errors of peaks by eq. 3, weights from shapes by eq. 4, and the
//! weighted root mean square norm; beside them whole histories and errors in units of the measurement.

use crate::channel::{Channel, shape_correlation};
use crate::forward::Response;
use crate::problem::Problem;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// What is compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Compare {
    /// Peaks, as the paper does.
    #[default]
    Peaks,
    /// Every value of the histories, by root mean square.
    Histories,
}

/// What a difference is divided by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Scaling {
    /// The measured peak, as eq. 3 does.
    #[default]
    MeasuredPeak,
    /// The standard deviation of one measured value.
    Uncertainty,
}

/// Where weights come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Weights {
    /// Squares of the shape correlation factors at the start model, held from then on.
    #[default]
    ShapeCorrelation,
    /// Those of the channels.
    Given,
    /// All alike.
    Equal,
}

/// Which of the model's values is its peak.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Sense {
    /// The largest in the sense in which the measured channel peaks: it does not jump where two excursions of opposite
    /// sign are about equal.
    #[default]
    Measured,
    /// The one of largest magnitude, whatever its sign.
    Largest,
}

/// How misfit is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Misfit {
    /// What is compared.
    pub compare: Compare,
    /// What differences are divided by.
    pub scaling: Scaling,
    /// Where weights come from.
    pub weights: Weights,
    /// Which of the model's values is its peak.
    pub sense: Sense,
    /// Whether peaks are looked for at the places of a full passage's peaks and their neighbours alone.
    pub slices: bool,
}

/// What is found once, at the start model, and held.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Held {
    /// Weight by channel; zero for those left out.
    pub weights: Vec<f64>,
    /// Shape correlation factor by channel, where there are two shapes to compare.
    pub shape_correlations: Vec<Option<f64>>,
    /// By channel, what a full passage is known to give beyond the model's slices [unit of the channel]; it is added to every value that
    /// is compared. Empty where slices count as they are.
    pub beyond: Vec<f64>,
}

impl Held {
    fn beyond(&self, channel: usize) -> f64 {
        self.beyond.get(channel).copied().unwrap_or(0.0)
    }
}

/// What one channel says of a model.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ChannelError {
    /// The model's signed peak [unit of the channel].
    pub peak: f64,
    /// Its error: eq. 3, or in standard deviations, or the root mean square over the history in either unit.
    pub error: f64,
}

/// What a model's response amounts to.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Fit {
    /// Weighted root mean square norm.
    pub norm: f64,
    /// By channel, left-out ones included.
    pub channels: Vec<ChannelError>,
}

/// Shape correlation factors of a full passage, by channel.
pub fn shape_correlations(problem: &Problem, response: &Response) -> Vec<Option<f64>> {
    let pairs = problem.channels().iter().zip(&response.values);
    pairs.map(|(channel, values)| channel.history.as_ref().and_then(|h| shape_correlation(values, h))).collect()
}

/// Weights and factors of a full passage of the start model. A channel whose shape says nothing weighs nothing; one of readings weighs as many
/// times as it has.
pub fn hold(problem: &Problem, response: &Response) -> Held {
    let shape_correlations = shape_correlations(problem, response);
    let readings = |k: usize| match &problem.channels()[k] {
        Channel { readings: true, history: Some(history), .. } => history.len() as f64,
        _ => 1.0,
    };
    let weight = |k: usize| match problem.misfit().weights {
        _ if !problem.channels()[k].counts() => 0.0,
        Weights::Given => readings(k) * problem.channels()[k].weight.unwrap_or(0.0),
        _ if problem.channels()[k].readings => readings(k),
        Weights::ShapeCorrelation => shape_correlations[k].map_or(0.0, |factor| factor * factor),
        Weights::Equal => 1.0,
    };
    let weights = (0..problem.channels().len()).map(weight).collect();
    Held { weights, shape_correlations, beyond: Vec::new() }
}

/// Place of the model's peak among the values of a channel; none where there is no value.
pub fn peak_place(problem: &Problem, channel: usize, values: &[f64]) -> Option<usize> {
    let measured = problem.channels()[channel].measured_peak().unwrap_or(0.0);
    let size = |value: f64| match problem.misfit().sense {
        Sense::Measured if measured > 0.0 => value,
        Sense::Measured if measured < 0.0 => -value,
        _ => value.abs(),
    };
    (0..values.len()).reduce(|best, k| if size(values[k]) > size(values[best]) { k } else { best })
}

/// Uncertainty of a channel that states none, as a share of its measured peak.
pub(crate) const UNSTATED: f64 = 0.01;

/// What one value of a channel that states no uncertainty is taken to be known to [unit of the channel].
pub(crate) fn unstated(channel: &Channel) -> Option<f64> {
    channel.measured_peak().map(|peak| UNSTATED * peak.abs())
}

/// What a channel's differences are divided by; negative where the measured peak is, as eq. 3 has it.
fn divisor(problem: &Problem, channel: usize) -> f64 {
    let scaling = problem.scaling(channel);
    let channel = &problem.channels()[channel];
    let divisor = match scaling {
        Scaling::MeasuredPeak => channel.measured_peak(),
        Scaling::Uncertainty => channel.uncertainty.or_else(|| unstated(channel).filter(|_| channel.readings)),
    };
    divisor.filter(|d| *d != 0.0).unwrap_or(f64::NAN)
}

/// Differences of one channel that enter its error, each with the place of the model's value.
type Differences = Vec<(usize, f64)>;

fn differences(problem: &Problem, held: &Held, channel: usize, values: &[f64]) -> Differences {
    let (beyond, divisor, record) = (held.beyond(channel), divisor(problem, channel), record(problem, channel));
    let pairs = places(problem, channel, values).into_iter().zip(record.iter());
    pairs.map(|(place, v)| (place, (values[place] + beyond - v) / divisor)).collect()
}

/// The norm of a response, and what each channel says.
pub fn fit(problem: &Problem, held: &Held, response: &Response) -> Fit {
    let (mut sum, mut total) = (0.0, 0.0);
    let mut channels = Vec::with_capacity(response.values.len());
    for (k, values) in response.values.iter().enumerate() {
        let all = differences(problem, held, k, values);
        let error = match problem.compare(k) {
            Compare::Peaks => all.first().map_or(f64::NAN, |(_, difference)| *difference),
            Compare::Histories => (all.iter().map(|(_, d)| d * d).sum::<f64>() / all.len() as f64).sqrt(),
        };
        if held.weights[k] > 0.0 {
            sum += held.weights[k] * error * error;
            total += held.weights[k];
        }
        channels.push(ChannelError { peak: peak_place(problem, k, values).map_or(f64::NAN, |p| values[p]), error });
    }
    Fit { norm: (sum / total).sqrt(), channels }
}

/// Differences of each channel with a weight in turn, and the factor that makes residuals of them.
fn weighted(problem: &Problem, held: &Held, response: &Response) -> Vec<(usize, f64, Differences)> {
    let total: f64 = held.weights.iter().sum();
    let counting = response.values.iter().enumerate().filter(|(k, _)| held.weights[*k] > 0.0);
    let of = |(k, values): (usize, &Vec<f64>)| {
        let all = differences(problem, held, k, values);
        (k, (held.weights[k] / total / all.len() as f64).sqrt(), all)
    };
    counting.map(of).collect()
}

/// Residuals whose sum of squares is the square of the norm: of each channel with a weight in turn.
pub fn residuals(problem: &Problem, held: &Held, response: &Response) -> Vec<f64> {
    let of = |(_, factor, all): (usize, f64, Differences)| all.into_iter().map(move |(_, d)| factor * d);
    weighted(problem, held, response).into_iter().flat_map(of).collect()
}

/// How many residuals there are, from the lengths of the channels' histories.
pub fn residual_count(problem: &Problem, held: &Held, length: impl Fn(usize) -> usize) -> usize {
    let counting = (0..held.weights.len()).filter(|k| held.weights[*k] > 0.0);
    let measured = |k: usize| problem.channels()[k].history.as_ref().map(Vec::len);
    let of = |k: usize| match problem.compare(k) {
        Compare::Peaks => 1,
        Compare::Histories => measured(k).unwrap_or_else(|| length(k)),
    };
    counting.map(of).sum()
}

/// What the model gives of each channel that is compared [unit of the channel]: its peak, or its whole history.
pub fn compared(problem: &Problem, held: &Held, response: &Response) -> Vec<Vec<f64>> {
    response.values.iter().enumerate().map(|(k, values)| compared_of(problem, held, k, values)).collect()
}

/// The same of one channel.
pub(crate) fn compared_of(problem: &Problem, held: &Held, channel: usize, values: &[f64]) -> Vec<f64> {
    let beyond = held.beyond(channel);
    places(problem, channel, values).into_iter().map(|place| values[place] + beyond).collect()
}

/// What was measured of a channel that is compared: its peak, or its whole history; empty where it has none.
pub(crate) fn record(problem: &Problem, channel: usize) -> Cow<'_, [f64]> {
    let measured = &problem.channels()[channel];
    match problem.compare(channel) {
        Compare::Peaks => measured.measured_peak().into_iter().collect(),
        Compare::Histories => measured.history.as_deref().unwrap_or_default().into(),
    }
}

/// Derivatives of [`compared`] with respect to each parameter, from those of the response: by parameter and channel.
pub fn compared_derivatives(problem: &Problem, response: &Response) -> Vec<Vec<Vec<f64>>> {
    let of = |derivatives: &Vec<Vec<f64>>| {
        let channel = |(k, values): (usize, &Vec<f64>)| -> Vec<f64> {
            places(problem, k, values).into_iter().map(|place| derivatives[k][place]).collect()
        };
        response.values.iter().enumerate().map(channel).collect()
    };
    response.derivatives.iter().map(of).collect()
}

/// Places of the values of a channel that are compared.
fn places(problem: &Problem, channel: usize, values: &[f64]) -> Vec<usize> {
    match problem.compare(channel) {
        Compare::Peaks => peak_place(problem, channel, values).into_iter().collect(),
        Compare::Histories => (0..values.len()).collect(),
    }
}

/// Derivatives of the residuals with respect to each parameter, from those of the response: by parameter, in the order of [`residuals`].
pub fn residual_derivatives(problem: &Problem, held: &Held, response: &Response) -> Vec<Vec<f64>> {
    let weighted = weighted(problem, held, response);
    let by_parameter = |derivatives: &Vec<Vec<f64>>| {
        let mut column = Vec::new();
        for (k, factor, all) in &weighted {
            let factor = factor / divisor(problem, *k);
            column.extend(all.iter().map(|(place, _)| factor * derivatives[*k][*place]));
        }
        column
    };
    response.derivatives.iter().map(by_parameter).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parameter::Parameter;

    fn response(values: Vec<Vec<f64>>) -> Response {
        Response { values, derivatives: Vec::new() }
    }

    #[test]
    fn the_norm_is_the_definition_by_hand() {
        let mut channels = vec![
            Channel::history("crown", "mm", vec![0.0, -0.2, -0.1]),
            Channel::history("pier", "mm", vec![0.0, 0.1, 0.3]),
            Channel::history("abutment", "mm", vec![0.0, -0.04, 0.0]),
        ];
        channels[2].left_out = Some("close to the least count".to_owned());
        let parameters = vec![Parameter::new("E", "GPa", 1.0, 0.0, 2.0)];
        let problem = Problem::new(parameters, channels, Misfit::default()).unwrap();
        let model = response(vec![vec![0.0, -0.25, -0.1], vec![0.1, 0.1, 0.24], vec![0.0, 1.0, 0.0]]);
        let held = hold(&problem, &model);
        let scf = |a: f64, b: f64, c: f64| a / (b.sqrt() * c.sqrt());
        let crown = scf(0.2 * 0.25 + 0.1 * 0.1, 0.25 * 0.25 + 0.01, 0.05);
        let pier = scf(0.01 + 0.3 * 0.24, 0.02 + 0.24 * 0.24, 0.1);
        assert!((held.weights[0] - crown * crown).abs() < 1e-15, "rounding");
        assert_eq!(held.weights[2], 0.0);
        // Errors by eq. 3: (-0.25 + 0.2) / -0.2 = 0.25 and (0.24 - 0.3) / 0.3 = -0.2.
        let by_hand = ((crown * crown * 0.0625 + pier * pier * 0.04) / (crown * crown + pier * pier)).sqrt();
        let fit = fit(&problem, &held, &model);
        assert!((fit.norm - by_hand).abs() < 1e-15, "{} {by_hand}", fit.norm);
        assert!((fit.channels[1].error + 0.2).abs() < 1e-15);
        let squares: f64 = residuals(&problem, &held, &model).iter().map(|r| r * r).sum();
        assert!((squares.sqrt() - fit.norm).abs() < 1e-15);
    }

    #[test]
    fn the_peak_lies_in_the_measured_sense() {
        let channels = vec![Channel::peak("crown", "mm", -0.3)];
        let parameters = vec![Parameter::new("E", "GPa", 1.0, 0.0, 2.0)];
        let misfit = Misfit { weights: Weights::Equal, ..Misfit::default() };
        let problem = Problem::new(parameters.clone(), channels.clone(), misfit).unwrap();
        assert_eq!(peak_place(&problem, 0, &[0.5, -0.2, 0.1]), Some(1));
        let largest = Problem::new(parameters, channels, Misfit { sense: Sense::Largest, ..misfit }).unwrap();
        assert_eq!(peak_place(&largest, 0, &[0.5, -0.2, 0.1]), Some(0));
    }

    /// Readings are compared one by one beside a peak, each as much as that, over what one is known to.
    #[test]
    fn readings_count_one_by_one_in_units_of_their_uncertainty() {
        let crown = Channel { uncertainty: Some(0.02), ..Channel::readings("crown", "mm", vec![-0.3, 0.0, -0.1]) };
        let silent = Channel::readings("strain", "microstrain", vec![-20.0, 10.0]);
        let passed = Channel { uncertainty: Some(0.01), ..Channel::peak("passed", "mm", -0.5) };
        let misfit = Misfit { scaling: Scaling::Uncertainty, weights: Weights::Equal, ..Misfit::default() };
        let parameters = vec![Parameter::new("E", "GPa", 1.0, 0.0, 2.0)];
        let problem = Problem::new(parameters.clone(), vec![crown, silent.clone(), passed], misfit).unwrap();
        let model = response(vec![vec![-0.32, 0.01, -0.1], vec![-20.2, 10.4], vec![0.0, -0.53, 0.2]]);
        let held = hold(&problem, &model);
        assert_eq!(held.weights, [3.0, 2.0, 1.0]);
        let by_hand: [f64; 6] = [-1.0, 0.5, 0.0, -1.0, 2.0, -3.0];
        let found = residuals(&problem, &held, &model);
        assert_eq!((found.len(), residual_count(&problem, &held, |_| 0)), (6, 6));
        for (residual, wanted) in found.iter().zip(by_hand) {
            assert!((residual - wanted / 6.0_f64.sqrt()).abs() < 1e-12, "{found:?}");
        }
        let norm = (by_hand.iter().map(|d| d * d).sum::<f64>() / 6.0).sqrt();
        assert!((fit(&problem, &held, &model).norm - norm).abs() < 1e-12, "rounding");
        // Nothing but zeros and no uncertainty: there is no unit to compare in.
        let zeros = Channel { history: Some(vec![0.0]), ..silent };
        assert!(Problem::new(parameters, vec![zeros], misfit).is_err());
    }
}
