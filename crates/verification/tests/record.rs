//! The record that stands beside verdicts is what `validation/` gives today.

use assess::record;
use mechanics::watch::Unwatched;
use outcome::validation::Predictor;
use std::path::Path;
use verification::validation::{Corpus, Level, gather, jobs, predict};

/// Every test predicted by limit analysis with fill as weight and expected prior values, beside `crates/assess/data/record.json`. Round-off of
/// another machine stays far below a thousandth; a change of a thousandth is another prediction.
#[test]
fn the_record_is_what_the_field_tests_give() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation");
    let corpus = Corpus::read(&root, &[]).unwrap();
    let expected = jobs(&corpus, &[Predictor::Weight]).into_iter().filter(|job| job.at == (Level::Expected, None));
    let answers: Vec<_> = expected
        .map(|job| {
            let answer = predict(&corpus, &job, &mut Unwatched);
            (job, answer)
        })
        .collect();
    let found = gather(&corpus, &[Predictor::Weight], &answers);
    assert_eq!(found.tests.len(), record::tests().len());
    for (test, kept) in found.tests.iter().zip(record::tests()) {
        let one = test.prediction(Predictor::Weight).unwrap();
        let near = |now: f64, kept: f64| (now / 1e3 / kept - 1.0).abs() < 1e-3;
        assert_eq!(test.name, kept.name);
        assert!(near(test.carried, kept.carried_kn), "{}: {}", test.name, test.carried);
        assert!(near(one.load.unwrap(), kept.predicted_kn), "{}: {:?}", test.name, one.load);
        assert!(
            near(one.without_crushing.unwrap(), kept.without_crushing_kn),
            "{}: {:?}",
            test.name,
            one.without_crushing
        );
        assert_eq!((test.recalled.is_empty(), test.doubt.is_some()), (kept.read, kept.doubted), "{}", test.name);
    }
}
