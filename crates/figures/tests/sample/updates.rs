//! Updates of a made-up bridge, searched in earnest: the model is a formula, the searches are those of the program.

use outcome::calibrate::posterior;
use outcome::calibrate::search::hierarchical;
use outcome::calibrate::search::hierarchical::Variant;
use outcome::calibrate::search::jacobian;
use outcome::calibrate::{
    Basis, Channel, Evaluation, Evaluator, Failure, Forward, Log, Misfit, Parameter, Problem, Request, Response,
    Samples, Serial, Start, Unwatched, identify,
};
use outcome::passage::Measurand;
use outcome::update::{
    Histories, PaperSearch, PosteriorReport, RecordsUsed, RunUsed, Search, SearchLine, Update, UpdateStatus,
};
use std::sync::LazyLock;

const SAMPLES: usize = 800;
const STEP: f64 = 0.016;

type Sensor = (&'static str, &'static str, Measurand, f64, f64, [f64; 5]);

/// Name, unit, quantity, size, place [m], and what share of it each parameter's flexibility makes.
const CHANNELS: [Sensor; 6] = [
    ("crown displacement", "mm", Measurand::Displacement, -0.30, 3.0, [0.35, 0.10, 0.40, 0.10, 0.05]),
    ("pier springing displacement", "mm", Measurand::Displacement, 0.12, 6.0, [0.10, 0.05, 0.35, 0.45, 0.05]),
    ("abutment springing displacement", "mm", Measurand::Displacement, -0.05, 0.0, [0.05, 0.05, 0.20, 0.05, 0.65]),
    ("crown strain", "microstrain", Measurand::Strain, 6.0, 3.0, [0.60, 0.15, 0.15, 0.05, 0.05]),
    ("pier springing strain", "microstrain", Measurand::Strain, -34.0, 6.0, [0.50, 0.10, 0.20, 0.20, 0.00]),
    ("abutment springing strain", "microstrain", Measurand::Strain, -29.0, 0.0, [0.45, 0.12, 0.18, 0.00, 0.25]),
];

/// A formula in the place of a bridge: flexibilities add up, and the softer the fill, the narrower the wave.
struct Formula {
    reference: Vec<f64>,
    /// Stiffnesses, as shares of the reference, from which on it has no answer: of the first and of the third parameter.
    fails: Option<[f64; 2]>,
}

impl Formula {
    fn value(&self, channel: usize, stiffness: &[f64], time: f64) -> f64 {
        let (_, _, _, size, at, shares) = CHANNELS[channel];
        let flexibility: f64 = shares.iter().zip(stiffness).map(|(share, s)| share / s).sum();
        let narrow = 1.0 + 0.15 / stiffness[2];
        // Four bogies at 12.5 m/s; a beam's wave sinks under the axle and rises beside it.
        let wave = |bogie: f64| {
            let x = (12.5 * (time - 2.0) - bogie - at) * narrow / 2.4;
            (1.0 - 0.35 * x * x) * (-0.5 * x * x).exp()
        };
        let train: f64 =
            [(0.0, 1.0), (14.0, 1.0), (26.0, 0.8), (38.0, 0.95)].iter().map(|(b, load)| load * wave(*b)).sum();
        size * flexibility * train
    }
}

impl Forward for Formula {
    fn evaluate(&self, point: &[f64], request: &Request) -> Evaluation {
        let stiffness: Vec<f64> =
            point.iter().zip(&self.reference).map(|(value, reference)| value / reference).collect();
        if self.fails.is_some_and(|[one, three]| stiffness[0] > one && stiffness[2] < three) {
            return Err(Failure::new("not-converged", "made up"));
        }
        let values = (0..CHANNELS.len()).map(|channel| {
            let at = |k: usize| self.value(channel, &stiffness, STEP * k as f64);
            match &request.samples {
                Samples::All => (0..SAMPLES).map(at).collect(),
                Samples::At(places) => places[channel].iter().map(|k| at(*k)).collect(),
            }
        });
        Ok(Response { values: values.collect(), derivatives: Vec::new() })
    }

    fn length(&self, _: usize) -> usize {
        SAMPLES
    }
}

fn parameters() -> Vec<Parameter> {
    vec![
        Parameter::new("voussoirs", "GPa", 12.0, 6.0, 18.0),
        Parameter::new("mortar", "GPa", 1.25, 0.5, 2.0),
        Parameter::new("fill", "MPa", 75.0, 15.0, 135.0),
        Parameter::new("backing", "GPa", 6.5, 2.0, 11.0),
        Parameter::new("abutment fill", "MPa", 530.0, 210.0, 850.0),
    ]
}

/// An update by the paper's search, with a posterior.
pub(crate) fn twin() -> Update {
    // The last truth lies beyond its range.
    static TWIN: LazyLock<Update> = LazyLock::new(|| made(parameters(), [14.4, 1.1, 39.0, 7.4, 1200.0], None, true));
    TWIN.clone()
}

/// Measured records, ranges by their logarithms, points without an answer, long names, no posterior.
pub(crate) fn hard() -> Update {
    let mut parameters = parameters();
    parameters[2] =
        Parameter::new("spandrel fill between the haunches, above the backing", "MPa", 60.0, 5.0, 700.0).logarithmic();
    parameters[0].name = "voussoirs of the first and of the last span".into();
    let mut update = made(parameters, [14.4, 1.1, 39.0, 7.4, 600.0], Some([1.3, 0.15]), false);
    update.bridge =
        "A bridge with a fairly long name, so that its title needs all the width there is and a little more".into();
    for run in &mut update.records.runs {
        run.synthetic = None;
    }
    for channel in update.channels.iter_mut().take(1) {
        channel.measured[200..230].fill(f64::NAN);
    }
    update
}

fn made(parameters: Vec<Parameter>, truth: [f64; 5], fails: Option<[f64; 2]>, posterior: bool) -> Update {
    let reference = vec![12.0, 1.25, 60.0, 6.5, 530.0];
    let forward = Formula { reference, fails };
    let exact =
        Formula { fails: None, reference: forward.reference.clone() }.evaluate(&truth, &Request::all()).unwrap().values;
    let channels: Vec<Channel> = (0..CHANNELS.len()).map(|k| channel(k, &exact[k])).collect();
    let misfit = Misfit { slices: true, ..Misfit::default() };
    let problem = Problem::new(parameters, channels, misfit).unwrap();
    let mut watch = Unwatched;
    let mut evaluator = Evaluator::new(&problem, &forward, &Serial, &mut watch, Log::new("sample"));
    let start = problem.start();
    let basis = Basis::at(&mut evaluator, &start).unwrap();
    let settings = hierarchical::Settings { start: Start::Stated, ..Default::default() };
    let outcome = hierarchical::search(&mut evaluator, &basis, &settings);
    let found = outcome.found.clone();
    let end = found.as_ref().map(|found| found.point());
    let identifiability =
        end.as_ref().and_then(|end| identify::identify(&mut evaluator, &basis, end, jacobian::STEP).ok());
    let posterior = posterior.then(|| {
        let settings =
            posterior::Settings { effective_samples: 100.0, particles: 60, moves: 2, steps: 100, ..Default::default() };
        let posterior = posterior::sample(&mut evaluator, &basis, &settings).unwrap();
        let surrogate =
            "sampled from a polynomial of degree 3 through 126 points of the model; its error is 0.4 % of the peaks";
        PosteriorReport { posterior, surrogate: surrogate.into(), seconds: 1.0 }
    });
    let evaluations = evaluator.done;
    let full =
        |point: &[f64]| forward.evaluate(point, &Request::all()).map(|response| response.values).unwrap_or_default();
    let (begun, ended) = (full(&start), end.map(|end| full(&end)).unwrap_or_default());
    let histories = (0..CHANNELS.len()).map(|k| Histories {
        name: CHANNELS[k].0.into(),
        quantity: CHANNELS[k].2,
        measured: problem.channels()[k].history.clone().unwrap_or_default(),
        start: begun.get(k).cloned().unwrap_or_default(),
        updated: ended.get(k).cloned().unwrap_or_default(),
        left_out: problem.channels()[k].left_out.clone(),
    });
    let line = SearchLine {
        search: Search::Hierarchical,
        variant: String::new(),
        status: "resolved".into(),
        found,
        computed: evaluations,
        seconds: 1.0,
    };
    Update {
        bridge: "Railway arch, four spans of 6 m".into(),
        train: "paper-short".into(),
        status: UpdateStatus::Completed,
        reason: None,
        answer: Some(0),
        paths: problem.parameters().iter().map(|_| String::new()).collect(),
        basis: Some(basis.clone()),
        times: (0..SAMPLES).map(|k| STEP * k as f64).collect(),
        positions: (0..SAMPLES).map(|k| 12.5 * STEP * k as f64).collect(),
        channels: histories.collect(),
        read_at_rest: Vec::new(),
        searches: vec![line],
        paper: vec![PaperSearch { variant: Variant::Printed, start: Start::Stated, outcome }],
        identifiability,
        linearised: None,
        posterior,
        evaluations,
        computed: evaluations,
        records: RecordsUsed { runs: vec![run()], ..RecordsUsed::default() },
        assumptions: Vec::new(),
        warnings: Vec::new(),
        problem: problem.clone(),
    }
}

/// A channel as measured: rounded, with a ripple of a least count in place of noise.
fn channel(k: usize, exact: &[f64]) -> Channel {
    let (name, unit, quantity, ..) = CHANNELS[k];
    let least_count = if quantity == Measurand::Strain { 0.05 } else { 0.01 };
    let ripple = |at: usize| least_count * ((at * at % 97) as f64 / 48.5 - 1.0);
    let measured =
        exact.iter().enumerate().map(|(at, value)| ((value + ripple(at)) / least_count).round() * least_count);
    let mut channel = Channel::history(name, unit, measured.collect());
    channel.uncertainty = Some(least_count);
    if k == 3 {
        channel.left_out = Some("a gauge on one stone cannot show the strain of the ring".into());
    }
    channel
}

fn run() -> RunUsed {
    RunUsed {
        name: "slow".into(),
        file: "records/slow.csv".into(),
        speed: Some(12.5),
        synthetic: Some("computed, not measured".into()),
        channels: 6,
    }
}
