//! Bias and scatter of a method over tests, and what they would have been without each test.

use outcome::validation::{Bias, LeftOut, Predictor, Tested};

/// What the predictions of a method come to.
pub fn bias(by: Predictor, tests: &[Tested]) -> Bias {
    let found: Vec<(&str, f64)> = tests
        .iter()
        .filter_map(|test| {
            let load = test.prediction(by)?.load.filter(|load| *load > 0.0)?;
            Some((test.name.as_str(), test.over(load)))
        })
        .collect();
    let logs: Vec<f64> = found.iter().map(|(_, over)| over.ln()).collect();
    let mut too_high: Vec<(String, f64)> =
        found.iter().filter(|(_, over)| *over > 1.0).map(|(name, over)| ((*name).to_owned(), *over)).collect();
    too_high.sort_by(|a, b| b.1.total_cmp(&a.1));
    let left_out: Vec<LeftOut> = found
        .iter()
        .enumerate()
        .filter_map(|(number, (name, over))| {
            let others: Vec<f64> = logs.iter().enumerate().filter(|(k, _)| *k != number).map(|(_, log)| *log).collect();
            let bias = median(&others)?.exp();
            Some(LeftOut { test: (*name).to_owned(), bias, corrected: over / bias })
        })
        .collect();
    let corrected: Vec<f64> = left_out.iter().map(|one| one.corrected.ln()).collect();
    Bias {
        by,
        tests: found.len(),
        median: median(&logs).map(f64::exp),
        scatter: deviation(&logs),
        too_high,
        left_out,
        left_out_scatter: deviation(&corrected),
    }
}

/// The middle one; of an even number the mean of both middle ones.
fn median(of: &[f64]) -> Option<f64> {
    let mut sorted = of.to_vec();
    sorted.sort_by(f64::total_cmp);
    let middle = sorted.len() / 2;
    match sorted.len() {
        0 => None,
        n if n % 2 == 1 => Some(sorted[middle]),
        _ => Some(0.5 * (sorted[middle - 1] + sorted[middle])),
    }
}

/// Standard deviation of a sample; none for fewer than two.
fn deviation(of: &[f64]) -> Option<f64> {
    let count = of.len() as f64;
    let mean = of.iter().sum::<f64>() / count;
    let squares = of.iter().map(|one| (one - mean).powi(2)).sum::<f64>();
    (of.len() > 1).then(|| (squares / (count - 1.0)).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use outcome::validation::Prediction;

    fn tests(overs: &[Option<f64>]) -> Vec<Tested> {
        let one = |(number, over): (usize, &Option<f64>)| {
            let prediction = Prediction {
                by: Predictor::Weight,
                load: over.map(|over| 200e3 * over),
                ended: "collapsed".into(),
                by_priors: None,
                by_dimensions: None,
                by_packings: None,
                without: Vec::new(),
                without_crushing: None,
                upper_bound: None,
                half_strength: None,
                dilating: None,
                seconds: 0.0,
                bridge_file: String::new(),
            };
            let name = ["a", "b", "c", "d", "e"][number].to_owned();
            Tested { name, carried: 200e3, predictions: vec![prediction], ..Tested::default() }
        };
        overs.iter().enumerate().map(one).collect()
    }

    /// By hand: ratios 0.5, 1, 2, 4 and none. Logarithms in units of ln 2: -1, 0, 1, 2; median 0.5, so sqrt 2. Deviation: mean 0.5,
    /// squares 2.25 + 0.25 + 0.25 + 2.25 = 5 over 3, root 1.29099, times ln 2 = 0.89485. Left out: a has 1 of (0, 1, 2), so bias 2 and
    /// 0.5 / 2 = 0.25; b has 1, 0.5; c has 0, 2; d has 0, 4. Logarithms -2, -1, 1, 2: mean 0, 10 over 3, root 1.82574, 1.26551.
    #[test]
    fn leaving_one_out_is_as_by_hand() {
        let found = bias(Predictor::Weight, &tests(&[Some(0.5), Some(1.0), Some(2.0), Some(4.0), None]));
        assert_eq!(found.tests, 4);
        let close = |a: Option<f64>, b: f64| assert!((a.unwrap() - b).abs() < 1e-5, "{a:?} {b}");
        close(found.median, 2f64.sqrt());
        close(found.scatter, 0.89485);
        close(found.left_out_scatter, 1.26551);
        for (one, (name, bias, corrected)) in
            found.left_out.iter().zip([("a", 2.0, 0.25), ("b", 2.0, 0.5), ("c", 1.0, 2.0), ("d", 1.0, 4.0)])
        {
            assert_eq!(one.test, name);
            close(Some(one.bias), bias);
            close(Some(one.corrected), corrected);
        }
        let names: Vec<&str> = found.too_high.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["d", "c"], "the worst first, and what is met is not too high");
    }

    #[test]
    fn few_tests_give_no_more_than_they_hold() {
        let none = bias(Predictor::Weight, &tests(&[None]));
        assert_eq!((none.tests, none.median, none.scatter), (0, None, None));
        let one = bias(Predictor::Weight, &tests(&[Some(0.8)]));
        assert_eq!((one.tests, one.scatter, one.left_out.len()), (1, None, 0));
        assert!((one.median.unwrap() - 0.8).abs() < 1e-12);
    }

    #[test]
    fn other_methods_do_not_count() {
        assert_eq!(bias(Predictor::Path, &tests(&[Some(0.5)])).tests, 0);
    }
}
