//! The table of `extrados.validate/1`, and the record.

use super::objects::{Object, kilo, object};
use super::rows::{each, row};
use crate::validation::{Predictor, Tested, Validation};

/// The record of limit analysis with fill as weight, as `crates/assess/data/record.json` holds it: of every test what it carried, and what is
/// predicted with the expected prior values, with and without crushing [kN]; none where a test has no such prediction.
pub fn record(found: &Validation) -> Option<String> {
    let row = |test: &Tested| {
        let one = test.prediction(Predictor::Weight)?;
        Some(object! {
            name: test.name,
            carried_kn: kilo(test.carried),
            predicted_kn: kilo(one.load?),
            without_crushing_kn: kilo(one.without_crushing?),
            read: test.recalled.is_empty(),
            doubted: test.doubt.is_some(),
        })
    };
    let rows: Vec<Object> = found.tests.iter().map(row).collect::<Option<_>>()?;
    serde_json::to_string_pretty(&rows).ok().map(|text| text + "\n")
}

/// One line for each test and method; in what time stands in the object, so that a table is the same from run to run.
pub fn validation_table(found: &Validation) -> String {
    let mut table = String::from(
        "test,test_kn,method,ended,prediction_kn,prediction_over_test,least_kn,most_kn,least_with_dimensions_kn,\
         most_with_dimensions_kn,upper_bound_kn,half_strength_kn,dilating_kn,bias_of_the_others,corrected\n",
    );
    for test in &found.tests {
        for one in &test.predictions {
            let of_method = found.statistics.iter().find(|of| of.by == one.by);
            let left_out = of_method.and_then(|of| of.left_out.iter().find(|left| left.test == test.name));
            row!(
                &mut table,
                test.name,
                kilo(test.carried),
                one.by.word(),
                one.ended,
                one.load.map(kilo),
                one.load.map(|load| test.over(load)),
                each(one.by_priors).map(|load| load.map(kilo)),
                each(one.by_dimensions).map(|load| load.map(kilo)),
                one.upper_bound.map(kilo),
                one.half_strength.map(kilo),
                one.dilating.map(kilo),
                left_out.map(|left| left.bias),
                left_out.map(|left| left.corrected),
            );
        }
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validation::Prediction;

    #[test]
    fn loads_are_kilonewtons_and_what_is_not_known_is_left_empty() {
        let one = Prediction {
            by: Predictor::Weight,
            load: Some(150e3),
            ended: "collapsed".into(),
            by_priors: Some([100e3, 200e3]),
            by_dimensions: None,
            by_packings: None,
            without: Vec::new(),
            without_crushing: None,
            upper_bound: None,
            half_strength: None,
            dilating: None,
            seconds: 0.5,
            bridge_file: String::new(),
        };
        let test = Tested { name: "a".into(), carried: 300e3, predictions: vec![one], ..Tested::default() };
        let found = Validation { tests: vec![test], statistics: Vec::new() };
        let table = validation_table(&found);
        assert_eq!(table.lines().nth(1), Some("a,300,weight,collapsed,150,0.5,100,200,,,,,,,"));
        let object = found.object();
        assert_eq!(object["tests"][0]["predictions"][0]["interval_kn"][1], 200.0);
        assert_eq!(object["tests"][0]["predictions"][0]["method"], "weight");
    }
}
