//! Bridges that were loaded to collapse, beside what several methods predict of them from one set of prior values.

use crate::published::{list, object};
use crate::wire::published;
use crate::words::words;

words! {
    /// What predicts the load of a test.
    pub enum Predictor {
        /// Limit analysis with fill as weight through which loads disperse.
        Weight = "weight",
        /// The same, where half of the passive pressure of the fill resists.
        Pressure = "pressure",
        /// Limit analysis with fill as a continuum that yields with its full strength and without dilation: the lower bound.
        Continuum = "continuum",
        /// The equilibrium path on deformable joints, with fill as weight.
        Path = "path",
        /// The same, where fill resists the more the further the ring moves against it.
        Movement = "movement",
        /// Discrete elements with fill as particles.
        Particles = "particles",
    }
}

impl Predictor {
    /// What it does, in a line.
    pub const fn about(self) -> &'static str {
        match self {
            Predictor::Weight => "limit analysis, fill as weight",
            Predictor::Pressure => "limit analysis, half of the passive pressure",
            Predictor::Continuum => "limit analysis, fill as a continuum, lower bound",
            Predictor::Path => "equilibrium path, fill as weight",
            Predictor::Movement => "equilibrium path, fill resists as the ring moves against it",
            Predictor::Particles => "discrete elements, fill as particles",
        }
    }
}

published! {
    /// Every test with its predictions, and what they come to.
    #[derive(Debug, Clone, PartialEq, Default)]
    pub struct Validation {
        /// In the order of their names.
        pub tests: Vec<Tested>,
        /// One for each method, in the order in which they were asked for.
        pub statistics: Vec<Bias>,
    }

    /// A bridge that was loaded to collapse.
    #[derive(Debug, Clone, PartialEq, Default)]
    pub struct Tested |test| {
        /// Name of its folder.
        pub name: String,
        /// What it was.
        pub title: String,
        /// Largest load of the test [N].
        pub carried: f64 [kN] as test,
        /// How certain that load is: a word.
        pub carried_mark: String as test_mark,
        /// How it failed.
        pub failed: String,
        /// Why it may be no fair test of the methods.
        pub doubt?: Option<String>,
        /// Dimensions that are remembered and not read.
        pub recalled: Vec<String> as from_memory,
        /// One for each method.
        pub predictions: Vec<Prediction> = list(&test.predictions, |one| one.object(test)),
    }

    /// What a method predicts of a test: loads on the whole width.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Prediction |one, test: &Tested| {
        /// The method.
        pub by: Predictor as method,
        /// How the analysis ended.
        pub ended: String,
        /// Load that is carried with the expected prior values [N], of particles the mean of all packings; none where the analysis found none.
        pub load: Option<f64> [kN] as prediction,
        /// The same over the load of the test, as all that is `over_test`.
        = prediction_over_test: Option<f64> = test.share(one.load),
        /// Least and largest load with all priors at their expected, their least and their largest values [N]. Zero where the bridge
        /// does not stand under its own weight.
        pub by_priors: Option<[f64; 2]> [kN] as interval,
        = interval_over_test: Option<[f64; 2]> = test.shares(one.by_priors),
        /// The same where remembered dimensions are at the ends of their intervals too [N]; none where all are read.
        pub by_dimensions: Option<[f64; 2]> [kN] as interval_with_dimensions,
        = interval_with_dimensions_over_test: Option<[f64; 2]> = test.shares(one.by_dimensions),
        /// Of particles: the least and the largest load of all packings [N].
        pub by_packings?: Option<[f64; 2]> [kN] as packings,
        = packings_over_test?: Option<[f64; 2]> = test.shares(one.by_packings),
        /// Runs at the ends of intervals, or with other packings, that gave no load, and how they ended.
        pub without: Vec<String> as without_a_number,
        /// The load with the expected prior values where joints never crush [N], of limit analysis.
        pub without_crushing: Option<f64> [kept],
        /// Of a continuum: the upper bound that belongs to the prediction [N]; the answer lies between them.
        pub upper_bound?: Option<f64> [kN],
        = upper_bound_over_test?: Option<f64> = test.share(one.upper_bound),
        /// Of a continuum: the lower bound with half of the soil's strength [N].
        pub half_strength?: Option<f64> [kN],
        = half_strength_over_test?: Option<f64> = test.share(one.half_strength),
        /// Of a continuum: the lower bound where soil dilates by its friction angle [N].
        pub dilating?: Option<f64> [kN],
        = dilating_over_test?: Option<f64> = test.share(one.dilating),
        /// Time of all runs [s].
        pub seconds: f64,
        /// The bridge file that was analysed, with the expected prior values.
        pub bridge_file: String,
    }

    /// What the predictions of one method come to.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Bias |of| {
        /// The method.
        pub by: Predictor as method,
        /// Tests with a prediction.
        pub tests: usize,
        /// Median of prediction over test, of its logarithm.
        pub median: Option<f64>,
        /// Standard deviation of the logarithm of prediction over test; none for a single test.
        pub scatter: Option<f64>,
        /// The tests that it predicts too high, the worst first: `test`, `prediction_over_test`.
        pub too_high: Vec<(String, f64)> =
            list(&of.too_high, |(test, over)| object! { test: test, prediction_over_test: over, }),
        /// Every test left out in turn.
        pub left_out: Vec<LeftOut>,
        /// Standard deviation of the logarithm after leaving out.
        pub left_out_scatter: Option<f64>,
    }

    /// One test, corrected by the bias of all the others.
    #[derive(Debug, Clone, PartialEq)]
    pub struct LeftOut {
        /// Its name.
        pub test: String,
        /// Median of prediction over test of all others.
        pub bias: f64 as bias_of_the_others,
        /// Prediction over test, divided by that bias.
        pub corrected: f64,
    }
}

impl Tested {
    /// A load over that of the test.
    pub fn over(&self, load: f64) -> f64 {
        load / self.carried
    }

    fn share(&self, load: Option<f64>) -> Option<f64> {
        load.map(|load| self.over(load))
    }

    fn shares(&self, ends: Option<[f64; 2]>) -> Option<[f64; 2]> {
        ends.map(|ends| ends.map(|load| self.over(load)))
    }

    /// What a method predicts of it.
    pub fn prediction(&self, by: Predictor) -> Option<&Prediction> {
        self.predictions.iter().find(|one| one.by == by)
    }
}
