use super::*;
use outcome::validation::Bias;

fn prediction(by: Predictor, load: Option<f64>) -> Prediction {
    Prediction {
        by,
        load,
        ended: "unstable-under-self-weight".into(),
        by_priors: load.map(|load| [0.0, 1.5 * load]),
        by_dimensions: load.map(|load| [0.0, 2.0 * load]),
        by_packings: None,
        without: Vec::new(),
        without_crushing: None,
        upper_bound: None,
        half_strength: None,
        dilating: load.map(|load| 1.2 * load),
        seconds: 0.0,
        bridge_file: String::new(),
    }
}

fn found(loads: &[Option<f64>]) -> Validation {
    let one = |load: &Option<f64>| Tested {
        name: "arch".into(),
        carried: 100e3,
        doubt: Some("not fair".into()),
        recalled: vec!["span.0.rise".into()],
        predictions: vec![prediction(Predictor::Weight, *load), prediction(Predictor::Continuum, *load)],
        ..Tested::default()
    };
    let statistics = [Predictor::Weight, Predictor::Continuum].map(|by| Bias {
        by,
        tests: loads.len(),
        median: loads.iter().flatten().next().map(|load| load / 100e3),
        scatter: Some(0.3),
        too_high: Vec::new(),
        left_out: Vec::new(),
        left_out_scatter: None,
    });
    Validation { tests: loads.iter().map(one).collect(), statistics: statistics.into() }
}

#[test]
fn a_prediction_stands_at_its_place_and_what_carries_nothing_goes_beyond_the_axis() {
    let svg = validation(&found(&[Some(60e3), Some(150e3), None])).unwrap();
    roxmltree::Document::parse(&svg).unwrap();
    // Two tests with two methods, both medians, and two marks in the key.
    assert_eq!(svg.matches("class=\"prediction\"").count(), 4 + 2 + 2);
    assert_eq!(svg.matches("class=\"test\"").count(), 1);
    assert!(svg.contains(">0.60<") && svg.contains(">1.50<") && svg.contains("arch†‡"), "{svg}");
    assert!(svg.contains("unstable"), "an end without a number is named");
}

#[test]
fn without_a_number_there_is_no_figure() {
    assert_eq!(validation(&found(&[None])), None);
    assert_eq!(validation(&Validation::default()), None);
}
