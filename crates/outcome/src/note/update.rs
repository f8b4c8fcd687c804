//! Model updating.

use crate::sentences::{listed, notes};

notes! {
    /// What an update assumes.
    InUpdate {
        Histories => "Whole histories are compared, by full passages.";
        /// Peaks, by slices.
        PeaksBySlices => "Peaks are compared. Searches look for the model's at the places where a full passage has them, and at both \
                          neighbours, by static slices; where a search ends is verified by a full passage.";
        Readings => "Readings of loads at rest are compared one by one, each over its uncertainty, and each counts as much as the peak of a record.";
        /// Sensors of a load test of which nobody says how well they are known.
        UnstatedReadings { sensors: Vec<String> } =>
            "No uncertainty is stated for the readings of {}: a hundredth of the largest is taken in the norm, and what the model leaves of them in \
             intervals.",
            listed(sensors);
        /// Peaks, by full passages.
        Peaks => "Peaks are compared, by full passages throughout.";
        Weights => "Weights are found once, at the start model, and held. A parameter on a bound is never called converged.";
        Width { width [m]: f64 } => "An axle is carried by {width:.3} m of the bridge's width; every peak goes with it.";
        NoCommonGain => "Axle loads and that width count as exact (`common_gain_deviation = 0`): no interval holds an error of theirs.";
        CommonGain { deviation: f64 } =>
            "What is found goes with the axle loads of the file and that width. Both together are taken to be known to {} % (standard \
             deviation, `common_gain_deviation`): one gain for all channels and all runs, which every interval holds.",
            (1e5 * deviation).round() / 1e3;
        /// What readings would tell: models beside that of the file; shares of the response for the common gain and for the model's error.
        Planned { models: usize, common_gain: f64, model_error: f64 } =>
            "Information is the mean over the model of the file and {models} from all over the ranges, each as a straight line; intervals lie about the \
             values of the file. Readings are as uncertain as stated, axle loads and the width that carries them are known to {} % and the model \
             to {} % of each sensor (`common_gain_deviation` and `model_error` of [update]).",
            (1e5 * common_gain).round() / 1e3, (1e5 * model_error).round() / 1e3;
        /// Sensors of a planned load test of which nobody says how well they are known.
        PlannedUnstated { sensors: Vec<String> } =>
            "No uncertainty is stated for {}: a hundredth of the largest reading that is expected is taken for one reading.",
            listed(sensors);
        MadeAnew => "A parameter moves mesh or loads: both are made anew for every evaluation.";
    }
}
