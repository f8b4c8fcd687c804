//! The record of limit analysis with fill as weight: what bridges tested to collapse carried of its predictions, and the model factor that
//! follows. The numbers are those that `extrados validate` computes from `validation/`; a test holds `crates/assess/data/record.json`
//! against it. The page `docs/verification/model-factor.md` says what they are.

use outcome::given::{FieldTest, Record};
use std::sync::LazyLock;

/// Every test of `validation/`.
pub fn tests() -> &'static [FieldTest] {
    // The text is part of the program, and a test reads it.
    static TESTS: LazyLock<Vec<FieldTest>> = LazyLock::new(|| FieldTest::all(include_str!("../data/record.json")));
    &TESTS
}

/// What the tests carried of their predictions.
pub fn record() -> Option<Record> {
    let mut shares: Vec<f64> = tests().iter().map(|test| test.carried_kn / test.predicted_kn).collect();
    shares.sort_by(f64::total_cmp);
    let (least, most) = (*shares.first()?, *shares.last()?);
    let n = shares.len();
    Some(Record {
        tests: n,
        with_read_dimensions: tests().iter().filter(|test| test.read).count(),
        carried_share_least: least,
        carried_share_median: 0.5 * (shares[(n - 1) / 2] + shares[n / 2]),
        carried_share_most: most,
    })
}

/// Student's t by degrees of freedom, from one: 95 % lie below it.
const STUDENT: [f64; 12] = [6.314, 2.920, 2.353, 2.132, 2.015, 1.943, 1.895, 1.860, 1.833, 1.812, 1.796, 1.782];

/// Statistics of fair tests over their predictions without crushing, of logarithms.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Statistics {
    /// How many tests.
    pub tests: usize,
    /// Median of test over prediction: the mean bias.
    pub median: f64,
    /// Standard deviation of its logarithm.
    pub scatter: f64,
    /// What 95 % of further bridges carry of their prediction: EN 1990, Annex D7.2, scatter unknown beforehand.
    pub fractile: f64,
}

/// Statistics of the tests that are not doubted.
pub fn statistics() -> Statistics {
    let fair = tests().iter().filter(|test| !test.doubted);
    let logs: Vec<f64> = fair.map(|test| (test.carried_kn / test.without_crushing_kn).ln()).collect();
    let n = logs.len() as f64;
    let mean = logs.iter().sum::<f64>() / n;
    let scatter = (logs.iter().map(|log| (log - mean).powi(2)).sum::<f64>() / (n - 1.0)).sqrt();
    let student = STUDENT[logs.len().saturating_sub(2).min(STUDENT.len() - 1)];
    let fractile = (mean - student * (1.0 + 1.0 / n).sqrt() * scatter).exp();
    Statistics { tests: logs.len(), median: mean.exp(), scatter, fractile }
}

/// What a load factor of limit analysis is divided by where the factors are the engineer's own: the reciprocal of the fractile, rounded
/// up to a tenth.
pub fn model_factor() -> f64 {
    (10.0 / statistics().fractile).ceil() / 10.0
}

/// Where it is from, in words.
pub fn words() -> String {
    let found = statistics();
    format!(
        "of {} tests to collapse: they carried {:.2} times the prediction of limit analysis with fill as weight in the median, with a scatter \
         of {:.2} of the logarithm, so that 95 % of bridges are expected to carry {:.2} times or more",
        found.tests, found.median, found.scatter, found.fractile
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Logarithms of test over prediction by hand: mean and deviation of six numbers, t of five degrees of freedom.
    #[test]
    fn the_model_factor_covers_every_test_that_it_is_from() {
        let found = statistics();
        assert_eq!((tests().len(), found.tests), (7, 6));
        assert!(tests().iter().all(|test| test.without_crushing_kn / model_factor() < test.carried_kn));
        let by_hand = (found.median.ln() - 2.015 * (7.0_f64 / 6.0).sqrt() * found.scatter).exp();
        assert!((found.fractile - by_hand).abs() < 1e-12, "{found:?}");
        let record = record().unwrap();
        assert!(record.carried_share_least <= record.carried_share_median);
        assert!(record.carried_share_median <= record.carried_share_most);
        assert_eq!((record.tests, record.with_read_dimensions), (7, 1));
    }

    #[test]
    fn the_page_of_the_manual_has_these_numbers() {
        let page = include_str!("../../../docs/verification/model-factor.md");
        for test in super::tests() {
            let [carried, predicted, without] = [test.carried_kn, test.predicted_kn, test.without_crushing_kn];
            let row = format!(
                "| {} | {carried:.0} | {predicted:.0} | {:.2} | {without:.0} | {:.2} |",
                test.name,
                carried / predicted,
                carried / without
            );
            assert!(page.contains(&row), "{row}");
        }
        let found = statistics();
        for number in [found.median, found.scatter, found.fractile] {
            assert!(page.contains(&format!("{number:.2}")), "{number}");
        }
        assert!(page.contains(&format!("**{}**", model_factor())));
    }
}
