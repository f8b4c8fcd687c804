//! What came of model updating: figures, summary and the wire format are made from this alone. Values of channels and of
//! parameters carry the units that they are shown in, named beside them.

use crate::note::Note;
use crate::passage::{Measurand, PassageStatus};
use crate::published::object;
use crate::published::update::{channels, parameters, positions, records, sensitivity, stages, told};
use crate::warning::Warning;
use crate::wire::published;
use crate::words::words;
use calibrate::identify::Identifiability;
use calibrate::linearised::Left;
use calibrate::posterior::{CommonGain, Posterior, Summary};
use calibrate::search::hierarchical;
use calibrate::search::hierarchical::Variant;
use calibrate::search::sweep::Sweep;
use calibrate::{Basis, Found, Problem, Start};
use serde::{Deserialize, Serialize};

/// How an update ended, in the words of passages: completed where every search that was asked for came to its end; where a search, or the start
/// model, found no end, the reason says which and why; the log holds what was done before somebody asked to stop.
pub type UpdateStatus = PassageStatus;

/// A channel's histories over the passage at `Update::times`, self-weight taken off [unit of the channel].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Histories {
    /// Name of the sensor.
    pub name: String,
    /// What it records.
    pub quantity: Measurand,
    /// As measured, brought to the model's times; empty where nothing was.
    pub measured: Vec<f64>,
    /// Of the start model.
    pub start: Vec<f64>,
    /// Of the updated model; empty where no search found an end.
    pub updated: Vec<f64>,
    /// Why it takes no part, if it does not.
    pub left_out: Option<String>,
}

/// What a sensor read in the positions of a load test, and what the model gives there [unit of the channel].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReadAtRest {
    /// Name of the sensor.
    pub sensor: String,
    /// What it records.
    pub quantity: Measurand,
    /// Names of the positions in which it was read.
    pub positions: Vec<String>,
    /// What it read there.
    pub measured: Vec<f64>,
    /// The start model there.
    pub start: Vec<f64>,
    /// The updated model there; empty where no search found an end.
    pub updated: Vec<f64>,
}

/// The paper's search by one reading of its rules, from one start.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PaperSearch {
    /// Which reading of its rules.
    pub variant: Variant,
    /// Where it starts.
    pub start: Start,
    /// Sweeps, surfaces, stages and the path taken.
    pub outcome: hierarchical::Outcome,
}

words! {
    /// A search.
    pub enum Search {
        /// The railway paper's, by single sweeps and surfaces of two.
        Hierarchical = "hierarchical",
        /// Trust-region least squares from many starts.
        Modern = "modern",
        /// Evolution over the whole ranges.
        Referee = "referee",
        /// A plain gradient search from one start.
        Gradient = "gradient",
    }
}

published! {
    /// One line of the table of searches.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct SearchLine |line| {
        /// Which.
        pub search: Search,
        /// Which reading and which start, in words; empty where there is one only.
        pub variant: String,
        /// How it ended, in a few words.
        pub status: String as ended,
        /// Error norm where it ended, of a full passage.
        = error_norm: Option<f64> = line.found.as_ref().map(|found| found.norm),
        /// The same as the search saw it, from its slices.
        = error_norm_in_search: Option<f64> = line.found.as_ref().map(|found| found.norm_in_search),
        /// Evaluations, each point once.
        = evaluations: Option<usize> = line.found.as_ref().map(|found| found.evaluations),
        /// Evaluations that the model did for it in this run; what the log knew is not counted.
        pub computed: usize as evaluations_computed,
        /// How long it took [s].
        pub seconds: f64,
        /// Values of the parameters where it ended.
        = values: Vec<f64> = line.found.as_ref().map_or_else(Vec::new, Found::point),
        /// Parameters that it does not call converged.
        = unconverged: Vec<String> = line.unconverged(),
        /// Where it ended.
        pub found: Option<Found> [kept],
    }
}

impl SearchLine {
    fn unconverged(&self) -> Vec<&str> {
        let all = self.found.iter().flat_map(|found| &found.parameters);
        all.filter(|parameter| !parameter.converged).map(|parameter| parameter.name.as_str()).collect()
    }
}

/// The posterior and what it was sampled from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PosteriorReport {
    /// The posterior; parameters in their units.
    pub posterior: Posterior,
    /// Which surrogate stood for the model, its degree, its points and its error, in words.
    pub surrogate: String,
    /// How long it took [s].
    pub seconds: f64,
}

/// What the records leave open, with the model as a straight line about the answer.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LinearReport {
    /// Parameters with their intervals.
    pub left: Left,
    /// Each parameter varied alone over its range, about the answer.
    pub sweeps: Vec<Sweep>,
    /// Parameters by the range of the norm in their sweeps, largest first.
    pub ranking: Vec<usize>,
}

words! {
    /// Where intervals and correlations come from.
    pub enum UncertaintyFrom {
        /// The model as a straight line about the answer.
        Linearised = "linearised",
        /// The sampled posterior.
        Posterior = "posterior",
    }
}

published! {
    /// A run of records.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct RunUsed {
        /// Its name.
        pub name: String,
        /// Its file, as the bridge file has it.
        pub file: String,
        /// Speed of the train [m/s].
        pub speed: Option<f64> [km/h],
        /// Channels that were used.
        pub channels: usize,
        /// What the file says where it was computed and not measured.
        pub synthetic: Option<String>,
    }
}

/// The records that were compared with.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct RecordsUsed {
    /// Runs.
    pub runs: Vec<RunUsed>,
    /// Everything that was done to them, in order.
    pub done: Vec<records::Done>,
    /// Everything that was found in them.
    pub findings: Vec<records::Finding>,
    /// The file that each finding is about, in their order; empty where it is about all of them.
    pub places: Vec<String>,
    /// What their peaks tell; none where no channel can be used.
    pub verdict: Option<Verdict>,
}

impl RecordsUsed {
    /// Whether somebody should look at them: something was repaired, removed or doubted.
    pub fn doubted(&self) -> bool {
        self.findings.iter().any(|finding| finding.severity > records::Severity::Note)
    }

    /// What was done to them, each with its place.
    pub fn done_words(&self) -> impl Iterator<Item = String> {
        self.done.iter().map(|done| format!("{}: {}", format!("{} {}", done.run, done.channel).trim(), done.what))
    }
}

/// What the peaks of all runs and lines tell.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Verdict {
    /// Peaks by run and line.
    pub peaks: records::PeakTable,
    /// Whether they depend on the speed of the train.
    pub dynamics: records::Dynamics,
    /// Whether lines across the barrel differ.
    pub plane_strain: records::PlaneStrain,
}

published! {
    /// From records to a calibrated bridge; its status is published as that of the command.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Update |update| {
        /// Name of the bridge.
        pub bridge: String,
        /// Name of the train.
        pub train: String,
        /// How it ended.
        pub status: UpdateStatus [kept],
        /// The search whose end is the answer; none where none came to an end.
        = search: Option<Search> = update.answer.map(|k| update.searches[k].search),
        /// The search whose end is the answer: the one with the least norm of a full passage. An index into `searches`.
        pub answer: Option<usize> [kept],
        /// Why, where it did not complete.
        pub reason?: Option<String>,
        /// Every parameter: `name`, `value`, `unit`, `interval_95`, `identifiable` and so on.
        = parameters: Vec<Object> = parameters(update),
        /// Paths of the parameters in the bridge file, in the order of `problem`.
        pub paths: Vec<String> [kept],
        /// Parameters with ranges, channels as measured, and how misfit is measured.
        pub problem: Problem [kept],
        /// Where standard deviations, intervals and correlations come from: the linearised problem or the sampled posterior.
        = uncertainty_from: Option<UncertaintyFrom> = update.uncertainty_from(),
        /// Correlation of the parameters; empty where it is not known.
        = correlation: Vec<Vec<f64>> = update.correlation(),
        /// Error norm of the answer, of a full passage.
        = error_norm: Option<f64> = update.found().map(|found| found.norm),
        /// The same as the search saw it, from its slices.
        = error_norm_in_search: Option<f64> = update.found().map(|found| found.norm_in_search),
        /// Error norm of the start model.
        = initial_error_norm: Option<f64> = update.basis.as_ref().map(|basis| basis.start.norm),
        /// Weights held at the start model, and the start model's fit.
        pub basis: Option<Basis> [kept],
        /// Times of the passage [s].
        pub times: Vec<f64> [kept],
        /// Places of the first axle at these times [m].
        pub positions: Vec<f64> [kept],
        /// Evaluations of the model that the answers rest on, each point once.
        pub evaluations: usize,
        /// Of these, evaluations that this run did itself.
        pub computed: usize as evaluations_computed,
        /// Every channel: `name`, `unit`, `measured_peak`, `model_peak`, `shape_correlation`, `weight`, `error` and so on.
        = channels: Vec<Object> = channels(update),
        /// Histories by channel, in the order of `problem`, whose last channels are those of `read_at_rest`.
        pub channels: Vec<Histories> [kept],
        /// Positions of the load test: `name`, and `channels` with what each sensor read (`measured`) and the model gives (`start`, `updated`).
        = positions: Vec<Object> = positions(update),
        /// Readings of the load test by sensor.
        pub read_at_rest: Vec<ReadAtRest> [kept],
        /// All searches, in the order in which they were made.
        pub searches: Vec<SearchLine>,
        /// Sweeps of the model about the start, or of its straight line about the answer: `parameter`, `range`, `rank` and so on.
        = sensitivity: Vec<Object> = sensitivity(update),
        /// Stages of the paper's search: `parameters`, `case`, `frozen` and so on.
        = stages: Vec<Object> = stages(update),
        /// Error norm of the values that single sweeps give, of the paper's search.
        = naive_error_norm: Option<f64> = update.first_pass().and_then(|pass| pass.naive_norm),
        /// The paper's search, by reading and start.
        pub paper: Vec<PaperSearch> [kept],
        /// Rank of the scaled derivatives at the answer.
        = rank: Option<usize> = update.identifiability.as_ref().map(|told| told.rank),
        /// Their condition number.
        = condition: Option<f64> = update.identifiability.as_ref().map(|told| told.condition),
        /// What the data can tell at the answer.
        pub identifiability: Option<Identifiability> [kept],
        /// What the records tell at the answer, in words.
        = told: Vec<String> = told(update),
        /// The model's error as a share of the response, by the linearised problem.
        = model_error: Option<f64> = update.linearised.as_ref().map(|line| line.left.model_error),
        /// What they leave open, with the model as a straight line about the answer.
        pub linearised: Option<LinearReport> [kept],
        /// Standard deviation of the gain that all channels share (axle loads, width) before the records.
        = common_gain_deviation: Option<f64> =
            update.uncertainty_from().map(|_| update.common_gain().map_or(0.0, |gain| gain.prior_deviation)),
        /// That gain as the records leave it: `mean`, `standard_deviation`.
        = common_gain?: Option<Object> = update.common_gain().map(|gain| object! {
            mean: gain.mean,
            standard_deviation: gain.standard_deviation,
        }),
        /// What the sampled posterior says of itself: `model_error`, `log_evidence`, `r_hat` and so on.
        pub posterior?: Option<PosteriorReport> = update.posterior.as_ref().map(|report| object! {
            model_error: report.posterior.model_error.as_ref().map(|s| [s.mean, s.interval_95[0], s.interval_95[1]]),
            log_evidence: report.posterior.log_evidence.map(|(log, _)| log),
            effective_samples: report.posterior.effective_samples,
            r_hat: report.posterior.r_hat,
            surrogate: report.surrogate,
            seconds: report.seconds,
            told: report.posterior.words,
        }),
        /// The records: `runs`, `done`, `findings`, `peaks` and so on.
        pub records: RecordsUsed = records(&update.records),
        /// Positions of the train.
        = load_positions: usize = update.times.len(),
        /// What was assumed, in words.
        pub assumptions: Vec<Note>,
        /// Warnings.
        pub warnings: Vec<Warning> [kept],
    }
}

impl Update {
    /// Where the answer stands: parameters, norm and channels, verified by a full passage.
    pub fn found(&self) -> Option<&Found> {
        self.searches.get(self.answer?)?.found.as_ref()
    }

    /// The first pass of the paper's search.
    pub(crate) fn first_pass(&self) -> Option<&hierarchical::Pass> {
        self.paper.first()?.outcome.passes.first()
    }

    /// Where intervals and correlations come from; none where there are none.
    pub fn uncertainty_from(&self) -> Option<UncertaintyFrom> {
        match (&self.posterior, &self.linearised) {
            (Some(report), _) if !report.posterior.parameters.is_empty() => Some(UncertaintyFrom::Posterior),
            (_, Some(_)) => Some(UncertaintyFrom::Linearised),
            _ => None,
        }
    }

    /// What is left open of a parameter: the posterior's, or the straight line's.
    pub fn summary(&self, parameter: usize) -> Option<Summary> {
        let sampled = self.posterior.as_ref().and_then(|report| report.posterior.parameters.get(parameter));
        let line = || self.linearised.as_ref()?.left.parameters.get(parameter).copied();
        sampled.map(|marginal| marginal.summary).or_else(line)
    }

    /// Whether the records tell a parameter: it shows, it acts neither like another one nor like a gain of all channels, and its interval is
    /// narrow beside its range and ends on no bound of it.
    pub fn identifiable(&self, parameter: usize) -> Option<bool> {
        let local = self.identifiability.as_ref().and_then(|told| told.identifiable.get(parameter).copied());
        let sampled = self.posterior.as_ref().and_then(|report| report.posterior.parameters.get(parameter));
        let line = || self.linearised.as_ref()?.left.told.get(parameter).copied();
        match sampled.map(|marginal| marginal.identifiable).or_else(line) {
            Some(told) => Some(told && local.unwrap_or(true)),
            None => local,
        }
    }

    /// The gain that all channels share, where it is uncertain and intervals are known.
    pub fn common_gain(&self) -> Option<&CommonGain> {
        match self.uncertainty_from()? {
            UncertaintyFrom::Posterior => self.posterior.as_ref()?.posterior.common_gain.as_ref(),
            UncertaintyFrom::Linearised => self.linearised.as_ref()?.left.common_gain.as_ref(),
        }
    }

    /// Whether the records tell a parameter no better than the loads are known.
    pub fn limited_by_gain(&self, parameter: usize) -> bool {
        self.common_gain().is_some_and(|gain| !gain.told_apart(parameter))
    }

    /// Correlation of the parameters, a row for each; empty where it is not known.
    pub fn correlation(&self) -> Vec<Vec<f64>> {
        match self.uncertainty_from() {
            Some(UncertaintyFrom::Posterior) => {
                self.posterior.as_ref().map(|report| report.posterior.correlation.clone())
            }
            _ => self.linearised.as_ref().map(|report| report.left.correlation.clone()),
        }
        .unwrap_or_default()
    }
}
