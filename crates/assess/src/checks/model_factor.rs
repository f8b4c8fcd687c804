//! The model factor of limit analysis with fill by its weight alone, from tests to collapse at full scale. The page
//! `docs/verification/model-factor.md` says where the numbers are from.

/// A bridge that was loaded to collapse, beside what limit analysis predicts from its description.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FieldTest {
    /// Name of the bridge.
    pub bridge: &'static str,
    /// Largest load of the test [kN].
    pub carried: f64,
    /// Limit load with fill by its weight alone and without crushing [kN].
    pub predicted: f64,
}

/// Every test with a prediction in the verification tables.
pub const TESTS: [FieldTest; 4] = [
    FieldTest { bridge: "Bridgemill", carried: 3100.0, predicted: 3527.0 },
    FieldTest { bridge: "Prestwood", carried: 228.0, predicted: 115.0 },
    FieldTest { bridge: "Torksey", carried: 1080.0, predicted: 923.0 },
    FieldTest { bridge: "Shinafoot", carried: 2524.0, predicted: 1599.0 },
];

/// Student's t with three degrees of freedom: 95 % lie below it.
const STUDENT: f64 = 2.353;

/// Statistics of the tests over their predictions, of logarithms.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Statistics {
    /// Median of test over prediction: the mean bias.
    pub median: f64,
    /// Standard deviation of its logarithm.
    pub scatter: f64,
    /// What 95 % of further bridges carry of their prediction: EN 1990, Annex D7.2, scatter unknown beforehand.
    pub fractile: f64,
}

/// Statistics of [`TESTS`].
pub fn statistics() -> Statistics {
    let n = TESTS.len() as f64;
    let logs = TESTS.map(|test| (test.carried / test.predicted).ln());
    let mean = logs.iter().sum::<f64>() / n;
    let scatter = (logs.iter().map(|log| (log - mean).powi(2)).sum::<f64>() / (n - 1.0)).sqrt();
    let fractile = (mean - STUDENT * (1.0 + 1.0 / n).sqrt() * scatter).exp();
    Statistics { median: mean.exp(), scatter, fractile }
}

/// What a load factor of limit analysis is divided by where no rule says so: the reciprocal of the fractile, rounded up to a tenth.
pub fn model_factor() -> f64 {
    (10.0 / statistics().fractile).ceil() / 10.0
}

/// Where it is from, in words.
pub fn words() -> String {
    let found = statistics();
    format!(
        "model factor {} of limit analysis with fill by its weight alone: {} tests to collapse carried {:.2} times their predictions in the \
         median, with a scatter of {:.2} of the logarithm; 95 % of bridges are expected to carry {:.2} times or more",
        model_factor(),
        TESTS.len(),
        found.median,
        found.scatter,
        found.fractile
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Logarithms by hand: -0.1291, 0.6845, 0.1571, 0.4565; mean 0.2923, deviation 0.3541; 0.2923 - 2.353 x 1.118 x 0.3541 = -0.639.
    #[test]
    fn the_model_factor_is_that_of_the_tests() {
        let found = statistics();
        assert!((found.median - 1.339).abs() < 2e-3 && (found.scatter - 0.354).abs() < 2e-3, "{found:?}");
        assert!((found.fractile - 0.528).abs() < 2e-3, "{found:?}");
        assert_eq!(model_factor(), 1.9);
        // It covers every test that it is from, the over-predicted one by weight alone with room.
        assert!(TESTS.iter().all(|test| test.predicted / model_factor() < test.carried));
    }

    #[test]
    fn the_page_of_the_manual_has_these_numbers() {
        let page = include_str!("../../../../docs/verification/model-factor.md");
        for test in TESTS {
            let row = format!(
                "| {} | {:.0} | {:.0} | {:.2} |",
                test.bridge,
                test.carried,
                test.predicted,
                test.carried / test.predicted
            );
            assert!(page.contains(&row), "{row}");
        }
        let found = statistics();
        for number in [found.median, found.scatter, found.fractile, model_factor()] {
            let words = if number == model_factor() { format!("**{number}**") } else { format!("{number:.2}") };
            assert!(page.contains(&words), "{words}");
        }
    }
}
