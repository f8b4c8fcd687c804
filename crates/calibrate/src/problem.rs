//! Parameters, channels and misfit as one checked whole.

use crate::channel::Channel;
use crate::forward::Response;
use crate::misfit::{Compare, Misfit, Scaling, Weights};
use crate::parameter::{Parameter, Scale, Start};
use crate::posterior::{Likelihood, ModelError};
use serde::{Deserialize, Serialize};

/// Something that keeps a problem from being posed: where, what, and what to write instead.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Flaw {
    /// The parameter or channel.
    pub place: String,
    /// What is wrong.
    pub message: String,
    /// What would be right.
    pub help: String,
}

/// What is to be fitted to what. Fixed once built.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Problem {
    parameters: Vec<Parameter>,
    channels: Vec<Channel>,
    misfit: Misfit,
}

impl Problem {
    /// Poses the problem, or says everything that is wrong with it.
    ///
    /// # Errors
    /// All that is wrong with parameters and channels.
    pub fn new(parameters: Vec<Parameter>, channels: Vec<Channel>, misfit: Misfit) -> Result<Self, Vec<Flaw>> {
        let mut findings = Vec::new();
        check_parameters(&parameters, &mut findings);
        check_channels(&channels, &misfit, &mut findings);
        if findings.is_empty() { Ok(Self { parameters, channels, misfit }) } else { Err(findings) }
    }

    /// The parameters, in order.
    pub fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    /// The channels, in order.
    pub fn channels(&self) -> &[Channel] {
        &self.channels
    }

    /// How misfit is measured.
    pub fn misfit(&self) -> &Misfit {
        &self.misfit
    }

    /// What is compared of a channel.
    pub fn compare(&self, channel: usize) -> Compare {
        if self.channels[channel].readings { Compare::Histories } else { self.misfit.compare }
    }

    /// What its differences are divided by.
    pub fn scaling(&self, channel: usize) -> Scaling {
        if self.channels[channel].readings { Scaling::Uncertainty } else { self.misfit.scaling }
    }

    /// The same problem with other uncertainties of the channels, in their order; those that are not above zero stay.
    pub fn with_uncertainties(&self, uncertainties: &[f64]) -> Self {
        let mut problem = self.clone();
        for (channel, uncertainty) in problem.channels.iter_mut().zip(uncertainties) {
            if uncertainty.is_finite() && *uncertainty > 0.0 {
                channel.uncertainty = Some(*uncertainty);
            }
        }
        problem
    }

    /// The same problem with noise that is no smaller than what a response leaves of the histories ([`Channel::with_noise_of`]) after the
    /// gains that the likelihood allows it; channels of which the peak is compared stay.
    pub fn with_noise_of(&self, response: &Response, likelihood: &Likelihood) -> Self {
        let mut problem = self.clone();
        let common = if likelihood.common_gain > 0.0 { self.common_gain(response) } else { 1.0 };
        let own = likelihood.model_error != ModelError::None;
        let pairs = problem.channels.iter_mut().zip(&response.values).enumerate();
        for (_, (channel, values)) in pairs.filter(|(k, _)| self.compare(*k) == Compare::Histories) {
            let gain = if own { channel.gain_over(values) } else { common };
            *channel = channel.with_noise_of(values, gain);
        }
        problem
    }

    /// The factor on a whole response that suits the histories best, each channel in units of its peak.
    fn common_gain(&self, response: &Response) -> f64 {
        let (mut along, mut square) = (0.0, 0.0);
        for (channel, values) in self.channels.iter().zip(&response.values).filter(|(channel, _)| channel.counts()) {
            let peak = channel.measured_peak().unwrap_or(0.0);
            let products = channel.products(values).map(|product| product / (peak * peak));
            if products.iter().all(|product| product.is_finite()) {
                along += products[0];
                square += products[1];
            }
        }
        if square > 0.0 { along / square } else { 1.0 }
    }

    /// The start model: a value for each parameter.
    pub fn start(&self) -> Vec<f64> {
        Start::Stated.point(&self.parameters)
    }
}

fn check_parameters(parameters: &[Parameter], findings: &mut Vec<Flaw>) {
    let mut say = |place: &str, message: String, help: &str| {
        findings.push(Flaw { place: place.to_owned(), message, help: help.to_owned() });
    };
    if parameters.is_empty() {
        say("parameters", "there is none".to_owned(), "state at least one parameter with a range");
    }
    for (k, parameter) in parameters.iter().enumerate() {
        let Parameter { name, start, lower, upper, .. } = parameter;
        if parameters[..k].iter().any(|other| other.name == *name) {
            say(name, "the name is given twice".to_owned(), "name every parameter once");
        }
        if !(lower.is_finite() && upper.is_finite() && lower < upper) {
            say(name, format!("the range {lower} to {upper} is empty"), "write a lower bound below the upper one");
        } else if !(lower <= start && start <= upper) {
            say(name, format!("the start {start} lies outside {lower} to {upper}"), "start inside the range");
        }
        if parameter.scale == Scale::Logarithmic && !(*lower > 0.0) {
            say(name, format!("a logarithmic range cannot begin at {lower}"), "raise the bound or use a linear scale");
        }
        if let Some(message) = parameter.prior.complaint() {
            say(name, message, "give the prior a finite mean and a positive standard deviation");
        }
    }
}

fn check_channels(channels: &[Channel], misfit: &Misfit, findings: &mut Vec<Flaw>) {
    let mut say = |place: &str, message: &str, help: &str| {
        let (place, message, help) = (place.to_owned(), message.to_owned(), help.to_owned());
        findings.push(Flaw { place, message, help });
    };
    if !channels.iter().any(Channel::counts) {
        say("channels", "none takes part in the norm", "keep at least one channel");
    }
    for (k, channel) in channels.iter().enumerate() {
        let name = &channel.name;
        if channels[..k].iter().any(|other| other.name == *name) {
            say(name, "the name is given twice", "name every channel once");
        }
        let values = channel.history.iter().flatten().chain(&channel.peak);
        if values.clone().any(|value| !value.is_finite()) {
            say(name, "a measured value is no finite number", "repair the record or leave the channel out");
        }
        if !channel.counts() {
            continue;
        }
        if channel.readings {
            check_readings(channel, misfit, &mut say);
            continue;
        }
        match channel.measured_peak() {
            None => say(name, "nothing was measured", "give a peak or a history, or leave the channel out"),
            Some(peak) if peak == 0.0 && misfit.scaling == Scaling::MeasuredPeak => say(
                name,
                "its measured peak is zero, so that eq. (3) divides by zero",
                "state an uncertainty and scale by it, or leave the channel out",
            ),
            Some(_) => {}
        }
        if channel.history.as_ref().is_none_or(|history| history.is_empty()) {
            if misfit.weights == Weights::ShapeCorrelation {
                say(name, "a shape correlation needs a history", "give weights, or weigh all channels alike");
            }
            if misfit.compare == Compare::Histories {
                say(name, "it has no history to compare", "compare peaks, or leave the channel out");
            }
        }
        if misfit.weights == Weights::Given && !channel.weight.is_some_and(|w| w.is_finite() && w > 0.0) {
            say(name, "it has no weight above zero", "give one, or leave the channel out");
        }
        let wanted = misfit.scaling == Scaling::Uncertainty || channel.uncertainty.is_some();
        if wanted && !channel.uncertainty.is_some_and(|u| u.is_finite() && u > 0.0) {
            say(name, "it has no uncertainty above zero", "give the standard deviation of one value");
        }
    }
}

/// A list of readings needs one at least, and a unit to compare them in.
fn check_readings(channel: &Channel, misfit: &Misfit, say: &mut impl FnMut(&str, &str, &str)) {
    let name = &channel.name;
    let largest = channel.history.iter().flatten().fold(0.0_f64, |most, reading| most.max(reading.abs()));
    if channel.history.as_ref().is_none_or(Vec::is_empty) {
        say(name, "nothing was read", "give a reading, or leave the channel out");
    }
    match channel.uncertainty {
        Some(uncertainty) if uncertainty.is_finite() && uncertainty > 0.0 => {}
        None if largest > 0.0 => {}
        _ => say(name, "it has no uncertainty above zero", "give the standard deviation of one reading"),
    }
    if misfit.weights == Weights::Given && !channel.weight.is_some_and(|w| w.is_finite() && w > 0.0) {
        say(name, "it has no weight above zero", "give one, or leave the channel out");
    }
}
