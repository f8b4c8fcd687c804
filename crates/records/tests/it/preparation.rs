//! Zero, drift, filter, clock, alignment and cut: each does what it says, and says what it did.

use crate::train::{self, AXLES, arrival};
use crate::{judged, the};
use records::{Align, Cut, Detrend, Preparation, Recording, Reference, Series, Zero, prepare};

fn prepared(runs: Vec<Recording>, preparation: &Preparation) -> Series {
    prepare(judged(runs), preparation)
}

/// Whether something was done, in words.
fn did<'a>(series: &'a Series, words: &str) -> &'a str {
    let done = series.done.iter().find(|done| done.what.contains(words));
    &done.unwrap_or_else(|| panic!("nobody did `{words}`: {:#?}", series.done)).what
}

fn shifted(mut run: Recording, by: f64) -> Recording {
    run.channels.iter_mut().flat_map(|channel| &mut channel.values).for_each(|value| *value += by);
    run
}

#[test]
fn zero_is_the_quiet_start() {
    let series = prepared(vec![shifted(train::good(), 5e-6)], &Preparation::default());
    let (run, good) = (&series.runs[0], train::good());
    for (one, two) in run.channels.iter().zip(&good.channels) {
        let worst = one.values.iter().zip(&two.values).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        // The median of the quiet start is one of its values, which are noise of one least count of 0.05 microstrain.
        assert!(worst <= 0.051e-6, "{}: {worst}", one.name);
    }
    assert!(did(&series, "set to zero").contains("5.000 microstrain") || did(&series, "set to zero").contains("mm"));
    let as_recorded = Preparation { zero: Zero::AsRecorded, ..Preparation::default() };
    assert_eq!(prepared(vec![train::good()], &as_recorded).runs[0].channels, good.channels);
    // A record that begins under the train has no quiet start, which is said.
    let mut late = train::good();
    late.times.drain(..300);
    late.channels.iter_mut().for_each(|channel| drop(channel.values.drain(..300)));
    let series = prepared(vec![late], &Preparation::default());
    assert!(the(&series.findings, "R060").message.contains("quiet start"));
}

#[test]
fn a_level_that_stays_in_a_record_is_named() {
    let as_recorded = Preparation { zero: Zero::AsRecorded, ..Preparation::default() };
    let named = |by: f64, preparation: &Preparation| {
        let mut run = train::good();
        run.channels[2].values.iter_mut().for_each(|value| *value += by);
        let found = prepared(vec![run], preparation).findings;
        found.into_iter().filter(|finding| finding.code == "R067").collect::<Vec<_>>()
    };
    // A warm morning: 2 of about 22 microstrain. Small levels, and those that are taken off, are in no peak that matters.
    let found = named(2e-6, &as_recorded);
    assert!(found.len() == 1 && found[0].place.channel.contains("crown strain"), "{found:?}");
    assert!(found[0].message.contains("2.000 microstrain"), "{found:?}");
    assert!(named(0.1e-6, &as_recorded).is_empty() && named(2e-6, &Preparation::default()).is_empty());
}

#[test]
fn a_line_between_quiet_ends_takes_drift_off() {
    let mut drifting = train::good();
    let times = drifting.times.clone();
    for (value, time) in drifting.channels[2].values.iter_mut().zip(&times) {
        // A fifteenth of the range over the run: below the limit.
        *value += 1.4e-6 / times[times.len() - 1] * time;
    }
    let preparation = Preparation { detrend: Detrend::QuietEnds, ..Preparation::default() };
    let series = prepared(vec![drifting], &preparation);
    let (one, two) = (&series.runs[0].channels[2], &train::good().channels[2]);
    let worst = one.values.iter().zip(&two.values).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    // Medians of rounded values at either end are off by a least count at most, the line by as much.
    assert!(worst < 2.0 * 0.05e-6, "{worst}");
    did(&series, "through the quiet start and end");
}

#[test]
fn a_regular_clock_and_a_filter_change_peaks_little_and_say_how_much() {
    let mut jittered = train::good();
    let exact = train::exact(20.0 / 3.6, &jittered.times, &[""], |_, _| 1.0);
    for (k, time) in jittered.times.iter_mut().enumerate() {
        *time += 1e-3 * ((k * 37) % 7) as f64;
    }
    // Values at the times as jittered, from exact ones on a fine clock.
    let again = train::exact(20.0 / 3.6, &jittered.times, &[""], |_, _| 1.0);
    for (channel, history) in jittered.channels.iter_mut().zip(&again) {
        channel.values = history.values.clone();
    }
    let preparation =
        Preparation { zero: Zero::AsRecorded, low_pass: Some(15.0), rate: Some(200.0), ..Preparation::default() };
    let series = prepared(vec![jittered], &preparation);
    did(&series, "its steps differed");
    did(&series, "to 200.0000 Hz");
    assert!(did(&series, "low pass at 15 Hz").contains("the peak goes from"));
    let run = &series.runs[0];
    assert!((run.interval() - 0.005).abs() < 1e-9);
    for (channel, history) in run.channels.iter().zip(&exact) {
        let peak = channel.values[channel.peak().unwrap()];
        let expected = history.values.iter().fold(0.0_f64, |a, b| if b.abs() > a.abs() { *b } else { a });
        // At 20 km/h nothing here is faster than 2 Hz, where this filter takes 0.01 %; lines between samples take as little.
        assert!((peak / expected - 1.0).abs() < 2e-3, "{}: {peak} {expected}", channel.name);
    }
    let wrong = prepared(vec![train::good()], &Preparation { low_pass: Some(60.0), ..Preparation::default() });
    assert!(the(&wrong.findings, "R062").message.contains("60 Hz"));
}

#[test]
fn a_slower_clock_is_filtered_first() {
    let mut humming = train::good();
    let times = humming.times.clone();
    for (value, time) in humming.channels[0].values.iter_mut().zip(&times) {
        *value += 2e-5 * (2.0 * std::f64::consts::PI * 45.0 * time).sin();
    }
    let series = prepared(vec![humming], &Preparation { rate: Some(40.0), ..Preparation::default() });
    did(&series, "so that nothing above half the new rate folds back");
    // Before the train nothing is left of the hum, which would have come back as 5 Hz.
    let quiet = &series.runs[0].channels[0].values[5..50];
    assert!(quiet.iter().all(|value| value.abs() < 2e-6), "{quiet:?}");
}

#[test]
fn runs_are_aligned_by_a_reference_to_a_thousandth_of_a_second() {
    let speed = 20.0 / 3.6;
    let times = train::times(speed, 200.0);
    let exact = &train::exact(speed, &times, &[""], |_, _| 1.0)[2];
    let reference = |scale: f64| Reference {
        name: "crown strain".to_owned(),
        line: String::new(),
        // The model's clock starts when the first axle is at the springing.
        times: times.iter().map(|time| time - arrival(speed)).collect(),
        values: exact.values.iter().map(|value| scale * value).collect(),
        speed: None,
    };
    for late in [0.0, 3.217, -0.4] {
        let mut run = train::good();
        run.times.iter_mut().for_each(|time| *time += late);
        let preparation = Preparation { align: Align::Reference(reference(0.6)), ..Preparation::default() };
        let series = prepared(vec![run], &preparation);
        // The first sample stood at `late`; on the reference's clock it is at minus the arrival.
        let off = series.runs[0].times[0] + arrival(speed);
        assert!(off.abs() < 1e-3, "{late}: {off}");
        let words = did(&series, "clock shifted");
        assert!(words.contains("correlation 0.99") || words.contains("correlation 1.00"), "{words}");
    }
    let wrong = Preparation { align: Align::Reference(reference(-1.0)), ..Preparation::default() };
    let series = prepared(vec![train::good()], &wrong);
    assert_eq!(series.runs[0].times[0], 0.0);
    the(&series.findings, "R065");
}

#[test]
fn runs_are_aligned_by_axle_times() {
    let speed = 20.0 / 3.6;
    // Axles over the crown, 3 m behind the springing, on a clock that starts with the first axle at the springing.
    let align = Align::Axles {
        name: "crown displacement".to_owned(),
        line: String::new(),
        times: AXLES.iter().map(|axle| (3.0 + axle) / speed).collect(),
        felt: 3.0 / speed,
        speed: Some(speed),
    };
    let series = prepared(vec![train::good()], &Preparation { align, ..Preparation::default() });
    let off = series.runs[0].times[0] + arrival(speed);
    // A comb of triangles is no influence line, but both are even about the axle.
    assert!(off.abs() < 0.01, "{off}");
}

/// Axles of a goods train over the crown, on a clock that starts with the first axle at the springing.
fn comb(speed: f64) -> Align {
    Align::Axles {
        name: "crown displacement".to_owned(),
        line: String::new(),
        times: train::LONG.iter().map(|axle| (3.0 + axle) / speed).collect(),
        felt: 3.0 / speed,
        speed: Some(speed),
    }
}

#[test]
fn a_run_is_aligned_at_its_own_speed_and_on_whichever_line_it_has() {
    for (kmh, late) in [(20.0, 4.0), (45.0, -1.5), (65.0, 0.0)] {
        let mut run = train::goods("goods", kmh, &["centre"], 3);
        run.times.iter_mut().for_each(|time| *time += late);
        // Times of axles are those at 45 km/h, whatever the run's speed.
        let series = prepared(vec![run], &Preparation { align: comb(45.0 / 3.6), ..Preparation::default() });
        let off = series.runs[0].times[0] + arrival(kmh / 3.6);
        // A sample of 100 Hz on a comb that is no influence line.
        assert!(off.abs() < 0.015, "{kmh}: {off}");
        assert!(did(&series, "clock shifted").contains("to the passing of 20 axles"));
        assert!(series.findings.iter().all(|finding| finding.code != "R066"), "{:?}", series.findings);
    }
}

#[test]
fn a_speed_that_axle_timing_contradicts_is_named() {
    for (stated, true_speed) in [(45.0, 60.0), (60.0, 45.0), (20.0, 45.0)] {
        let mut run = train::goods("goods", true_speed, &[""], 3);
        run.speed = Some(stated / 3.6);
        let series = prepared(vec![run], &Preparation { align: comb(45.0 / 3.6), ..Preparation::default() });
        let finding = the(&series.findings, "R066");
        let words = finding.message.split("a speed of ").nth(1).and_then(|rest| rest.split(' ').next()).unwrap();
        let told: f64 = words.parse().unwrap();
        // A comb of triangles is no influence line: three in a hundred, as against the third that is wrong.
        assert!((told / true_speed - 1.0).abs() < 0.03, "{}", finding.words());
        assert!(finding.message.contains(&format!("states {stated:.1} km/h")), "{}", finding.words());
    }
    // What a clock that is a few per cent off tells is not worth a word.
    let mut run = train::goods("goods", 46.0, &[""], 3);
    run.speed = Some(45.0 / 3.6);
    let series = prepared(vec![run], &Preparation { align: comb(45.0 / 3.6), ..Preparation::default() });
    assert!(series.findings.iter().all(|finding| finding.code != "R066"), "{:?}", series.findings);
}

#[test]
fn the_time_on_the_span_is_kept() {
    let preparation = Preparation { cut: Cut::Answering { share: 0.05, margin: 0.2 }, ..Preparation::default() };
    let series = prepared(vec![train::good()], &preparation);
    let run = &series.runs[0];
    let [first, last] = [run.times[0], run.times[run.times.len() - 1]];
    let speed = 20.0 / 3.6;
    let [enters, leaves] = [arrival(speed), arrival(speed) + (6.0 + AXLES[5]) / speed];
    assert!(first < enters && leaves < last, "{first} {last} against {enters} {leaves}");
    // What is cut off is as small as was said.
    let whole = &prepared(vec![train::good()], &Preparation::default()).runs[0];
    for channel in &whole.channels {
        let range = |f: fn(f64, f64) -> f64| channel.values.iter().copied().fold(0.0, f);
        let limit = 0.05 * (range(f64::max) - range(f64::min));
        let off = whole.times.iter().zip(&channel.values).filter(|(time, _)| **time < first || **time > last);
        off.for_each(|(time, value)| assert!(value.abs() <= limit, "{} at {time}", channel.name));
    }
    assert_eq!(run.times.len(), run.channels[0].values.len());
    let words = did(&series, "cut to");
    assert!(words.contains("5.0 % of its range") && words.contains("off the start"), "{words}");

    let between = Preparation { cut: Cut::Between([2.0, 3.0]), ..Preparation::default() };
    assert_eq!(prepared(vec![train::good()], &between).runs[0].times.len(), 101);
    let nothing = Preparation { cut: Cut::Between([200.0, 300.0]), ..Preparation::default() };
    let series = prepared(vec![train::good()], &nothing);
    assert_eq!(series.runs[0].times.len(), train::good().times.len());
    the(&series.findings, "R064");
}
