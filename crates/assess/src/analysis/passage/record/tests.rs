//! Records of a made-up passage, written and read back.

use super::super::tests::railway;
use super::*;
use crate::analysis::passage::{self, Solution};
use outcome::passage::PassageStatus;

/// A bump in all channels, each as large as its sensor would see it; before and after it nothing moves.
fn bump() -> Passage {
    let bridge = railway();
    let setup = passage::setup(&bridge).unwrap();
    let sizes = [-3e-4, -2e-4, -1e-4, 2e-5, -3e-5, -3e-5];
    let count = setup.times.len();
    let wave = |k: usize| {
        let share = (k as f64 / count as f64 - 0.2) / 0.6;
        if (0.0..=1.0).contains(&share) { (std::f64::consts::PI * share).sin().powi(2) } else { 0.0 }
    };
    let solution = Solution {
        status: PassageStatus::Completed,
        reason: None,
        self_weight: vec![0.0; 6],
        values: sizes.iter().map(|size| (0..count).map(|k| size * wave(k)).collect()).collect(),
        derivatives: Vec::new(),
        degrees_of_freedom: 7,
        condensed_degrees_of_freedom: None,
        taking_part: Vec::new(),
        log: Vec::new(),
        moments: Vec::new(),
        influence: None,
        no_influence_at: None,
        assumptions: Vec::new(),
    };
    passage::report(&bridge, &setup, solution)
}

fn read_back(run: &records::Recording) -> records::Recording {
    let options = records::ReadOptions { name: "other".into(), ..records::ReadOptions::default() };
    let read = records::read(records::write(run).as_bytes(), &options);
    assert!(read.findings.is_empty(), "{:?}", read.findings);
    read.run.unwrap()
}

#[test]
fn a_record_comes_back_as_it_was_written_and_says_that_it_is_synthetic() {
    let passage = bump();
    let run = record(&passage, "slow", "extrados respond", &Logger::default());
    let back = read_back(&run);
    let label = back.synthetic.as_deref().unwrap();
    for words in [
        "not measured",
        "extrados respond",
        "paper-short",
        "static analysis",
        "200 Hz",
        "seed 1",
        "rounded to 0.01 mm after normal noise of 0.01 mm",
        "rounded to 0.05 microstrain after normal noise of 0.05 microstrain",
    ] {
        assert!(label.contains(words), "{words} is not in {label}");
    }
    assert_eq!((back.name.as_str(), back.speed), ("slow", Some(12.5)));
    assert_eq!(back.times, run.times);
    for (read, written) in back.channels.iter().zip(&run.channels) {
        assert_eq!((&read.name, read.unit, &read.values), (&written.name, written.unit, &written.values));
    }
    // The noise is what the label says: half of the samples stand still. A sample of 2000 knows a deviation to 2 %; five times that.
    let rest = |k: &usize| passage.channels[0].values[*k] == 0.0;
    let quiet: Vec<f64> = (0..back.times.len()).filter(rest).map(|k| back.channels[0].values[k]).collect();
    let deviation = (quiet.iter().map(|v| v * v).sum::<f64>() / quiet.len() as f64).sqrt();
    let expected = 1e-5 * (1.0 + 1.0 / 12.0_f64).sqrt();
    assert!(
        (deviation / expected - 1.0).abs() < 5.0 / (2.0 * quiet.len() as f64).sqrt(),
        "{deviation} {}",
        quiet.len()
    );
    // What examines records finds nothing to leave out in it.
    let series = records::examine(vec![back], &records::Scrutiny::default());
    assert!(series.left_out().is_empty(), "{:?}", series.left_out());
}

#[test]
fn a_record_without_noise_is_the_passage() {
    let passage = bump();
    let back = read_back(&record(&passage, "", "extrados respond", &Logger::NONE));
    assert_eq!(back.times, passage.times);
    for (read, exact) in back.channels.iter().zip(&passage.channels) {
        // A number is printed so that it reads back to the last bit but one.
        let same = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-15 * b.abs();
        assert!(read.values.iter().zip(&exact.values).all(same), "{}", exact.name);
    }
    let another = Logger { seed: 2, ..Logger::default() };
    let [one, two] = [Logger::default(), another].map(|logger| record(&passage, "", "", &logger));
    assert_ne!(one.channels[0].values, two.channels[0].values, "another seed is another record");
}
