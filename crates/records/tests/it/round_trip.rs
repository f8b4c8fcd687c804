//! What is written is read back to the last bit, and says what it is.

use crate::{read_text, run_of, train};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use records::{Channel, Dimension, Exact, Noise, Recording, UNITS, Unit, synthesise, write};

/// Bits of every number of a run.
fn bits(run: &Recording) -> Vec<u64> {
    let values = run.channels.iter().flat_map(|channel| &channel.values);
    run.times.iter().chain(values).map(|value| value.to_bits()).collect()
}

#[test]
fn a_synthetic_run_comes_back_bit_for_bit_and_says_that_it_is_synthetic() {
    let run = train::run("three lines", 65.0, &["upstream", "centre", "downstream"], 5, |_, _| 1.0);
    let text = write(&run);
    let read = read_text(text.as_bytes(), "x.csv");
    assert!(read.findings.is_empty(), "{:?}", read.findings);
    let back = run_of(read);
    assert_eq!(bits(&back), bits(&run));
    assert_eq!((&back.name, back.speed, &back.synthetic), (&run.name, run.speed, &run.synthetic));
    let label = back.synthetic.clone().unwrap();
    for word in ["not measured", "100 Hz", "rounded to 0.01 mm", "0.05 microstrain", "seed 5"] {
        assert!(label.contains(word), "{label}");
    }
    assert_eq!(write(&back).replace(&label, ""), text.replace(&label, ""));
}

#[test]
fn the_same_seed_gives_the_same_record_and_another_one_another() {
    assert_eq!(bits(&train::run("a", 20.0, &[""], 1, |_, _| 1.0)), bits(&train::good()));
    assert_ne!(bits(&train::run("a", 20.0, &[""], 2, |_, _| 1.0)), bits(&train::good()));
    // Every channel has noise of its own: without the others it is the same.
    let times = train::times(5.0, 50.0);
    let exact = train::exact(5.0, &times, &[""], |_, _| 1.0);
    let noise = Noise { rate: None, seed: 3, origin: String::new() };
    let (all, one) = (synthesise("", None, &times, &exact, &noise), synthesise("", None, &times, &exact[..1], &noise));
    assert_eq!(all.channels[0], one.channels[0]);
}

#[test]
fn noise_is_as_stated() {
    let times: Vec<f64> = (0..100_000).map(|k| f64::from(k) / 200.0).collect();
    let unit = Unit::usual(Dimension::Strain);
    let flat = |deviation: f64, least_count: f64| Exact {
        name: "strain".to_owned(),
        line: String::new(),
        unit,
        values: vec![3e-6; times.len()],
        least_count,
        deviation,
    };
    let noise = Noise { rate: Some(200.0), seed: 1, origin: String::new() };
    let run = synthesise("", None, &times, &[flat(2e-7, 0.0), flat(2e-7, 5e-8)], &noise);
    for (channel, variance) in run.channels.iter().zip([4e-14, 4e-14 + 5e-8_f64.powi(2) / 12.0]) {
        let n = channel.values.len() as f64;
        let mean = channel.values.iter().sum::<f64>() / n;
        let found = channel.values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / n;
        // Five standard errors: of the mean 2e-7/√n, of the variance √(2/n).
        assert!((mean - 3e-6).abs() < 5.0 * 2e-7 / n.sqrt());
        assert!((found / variance - 1.0).abs() < 5.0 * (2.0 / n).sqrt(), "{found}");
    }
    let counts = run.channels[1].values.iter().map(|value| value / 5e-8);
    assert!(counts.into_iter().all(|count| (count - count.round()).abs() < 1e-6));
}

fn value() -> impl Strategy<Value = f64> {
    prop_oneof![4 => -1.0..1.0_f64, 1 => Just(f64::NAN), 1 => Just(0.0), 1 => -1e-12..1e-12_f64]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2_000, rng_seed: RngSeed::Fixed(1934), failure_persistence: None, ..ProptestConfig::default() })]
    #[test]
    fn any_run_comes_back(
        cells in prop::collection::vec((value(), value()), 1..40),
        units in (0..UNITS.len(), 0..UNITS.len()),
        names in ("[a-z][a-z ,;\"]{0,12}[a-z]", "[a-z]{1,8}"),
    ) {
        // Values that cells can hold: to SI from a number.
        let channel = |k: usize, unit: usize, name: &str, line: &str| {
            let pick = |pair: &(f64, f64)| UNITS[unit].to_si(if k == 0 { pair.0 } else { pair.1 });
            Channel {
                name: name.to_owned(), line: line.to_owned(), unit: UNITS[unit], column: k + 2,
                values: cells.iter().map(pick).collect(), decimals: None, left_out: None,
            }
        };
        let run = Recording {
            name: "any".to_owned(),
            times: (0..cells.len()).map(|k| k as f64 / 300.0).collect(),
            channels: vec![channel(0, units.0, &format!("x{}", names.0), ""), channel(1, units.1, "y", &names.1)],
            ..Recording::default()
        };
        let back = run_of(read_text(write(&run).as_bytes(), "any"));
        prop_assert_eq!(&back.times, &run.times);
        for (one, two) in back.channels.iter().zip(&run.channels) {
            prop_assert_eq!((&one.name, &one.line, one.unit), (&two.name, &two.line, two.unit));
            for (a, b) in one.values.iter().zip(&two.values) {
                prop_assert!(a == b || (a.is_nan() && b.is_nan()), "{} and {}", a, b);
            }
        }
    }
}
