//! A file for each of ten defects: each is named with its place, and nothing is silently used.

use crate::data::{CROWN, PIER, PIER_STRAIN, STRAIN};
use crate::{judged, read_file, run_of, the, train};
use records::{Accept, Expected, Finding, LeaveOut, Recording, Scrutiny, Series, Severity, Unit, examine};

/// First line of data in the committed tables.
const FIRST: usize = 5;

/// A committed table read and judged beside two good runs of the same train; findings of reading come first.
fn findings_of(name: &str) -> (Series, Vec<Finding>) {
    let read = read_file(name);
    let mut findings = read.findings.clone();
    let sisters = ["twenty", "twenty-two"].map(|name| train::run(name, 20.0, &[""], 7, |_, _| 1.0));
    let mut runs = vec![Recording { name: name.to_owned(), ..run_of(read) }];
    runs.extend(sisters);
    let series = judged(runs);
    findings.extend(series.findings.clone());
    (series, findings)
}

/// Titles of the channels of the first run that are left out.
fn out(series: &Series) -> Vec<String> {
    series.runs[0].channels.iter().filter(|channel| !channel.used()).map(records::Channel::title).collect()
}

/// Every channel of the first run.
fn all(series: &Series) -> usize {
    series.runs[0].channels.len()
}

fn place(finding: &Finding) -> ([usize; 2], Option<usize>, f64) {
    (finding.place.lines.expect("lines"), finding.place.column, finding.place.time.expect("time"))
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-9
}

#[test]
fn the_good_file_has_nothing_to_name() {
    let (series, findings) = findings_of("good.csv");
    let words: Vec<String> = findings.iter().map(Finding::words).collect();
    assert!(findings.is_empty(), "{words:#?}");
    assert!(series.left_out().is_empty() && series.done.is_empty());
}

#[test]
fn text_in_a_number() {
    let (series, findings) = findings_of("text-in-a-number.csv");
    let finding = the(&findings, "R020");
    assert_eq!((finding.place.lines, finding.place.column), (Some([FIRST + 200; 2]), Some(CROWN + 1)));
    assert!(near(finding.place.time.unwrap(), 2.0) && finding.message.contains("`-0.1O`"), "{}", finding.words());
    assert!(out(&series).is_empty());
    assert!(series.done.iter().any(|done| done.channel == "crown displacement" && done.what.contains("1 missing")));
    assert!(series.runs[0].channels[CROWN - 1].values.iter().all(|value| value.is_finite()));
}

#[test]
fn gap() {
    let (series, findings) = findings_of("gap.csv");
    let finding = the(&findings, "R035");
    assert_eq!(finding.severity, Severity::Error);
    assert_eq!(finding.place.lines, Some([FIRST + 299, FIRST + 300]));
    assert!(near(finding.place.time.unwrap(), 2.99) && finding.message.contains("40 samples"), "{}", finding.words());
    assert_eq!(out(&series).len(), all(&series), "a clock belongs to all channels");
}

#[test]
fn repeated_time() {
    let (series, findings) = findings_of("repeated-time.csv");
    let finding = the(&findings, "R033");
    assert_eq!(finding.place.lines, Some([FIRST + 251; 2]));
    assert!(near(finding.place.time.unwrap(), 2.5) && finding.message.contains("other values"), "{}", finding.words());
    // The row is gone, which leaves a gap of one sample, named too.
    assert_eq!(the(&findings, "R035").severity, Severity::Warning);
    assert!(!series.runs[0].lines.contains(&(FIRST as u32 + 251)) && out(&series).is_empty());
}

#[test]
fn two_clocks() {
    let (series, findings) = findings_of("two-clocks.csv");
    let finding = the(&findings, "R032");
    let (lines, _, time) = place(finding);
    assert_eq!(finding.severity, Severity::Error);
    // The change stands at row 380; where exactly is blurred by no more than a few samples of either clock.
    assert!(lines[0].abs_diff(FIRST + 380) <= 2 && (time - 3.8).abs() < 0.03, "{}", finding.words());
    assert!(finding.message.contains("0.010000 s to 0.004000 s"), "{}", finding.words());
    assert_eq!(out(&series).len(), all(&series));

    let mut back = train::good();
    back.times[400..].iter_mut().for_each(|time| *time -= 0.5);
    let series = judged(vec![back]);
    assert!(the(&series.findings, "R031").message.contains("3.9900 s to 3.5000 s"));
    assert_eq!(out(&series).len(), all(&series));
}

#[test]
fn unit_slip_by_1000() {
    let (series, findings) = findings_of("unit-slip.csv");
    let finding = the(&findings, "R044");
    assert_eq!((finding.severity, finding.place.column), (Severity::Error, Some(PIER + 1)));
    assert!(finding.message.contains("1000") && finding.place.lines.is_some(), "{}", finding.words());
    assert_eq!(out(&series), ["pier displacement"]);

    // Without sisters, against the peak that is expected; it need not be near.
    let scrutiny = Scrutiny { expected: vec![expected("pier displacement", 1e-4)], ..Scrutiny::default() };
    let alone = examine(vec![run_of(read_file("unit-slip.csv"))], &scrutiny);
    assert_eq!(out(&alone), ["pier displacement"]);
}

fn expected(name: &str, peak: f64) -> Expected {
    Expected { name: name.to_owned(), line: None, peak }
}

#[test]
fn flat_channel() {
    let (series, findings) = findings_of("flat-channel.csv");
    let finding = the(&findings, "R040");
    assert_eq!((finding.severity, finding.place.column), (Severity::Error, Some(STRAIN + 1)));
    assert!(finding.message.contains("3.150 microstrain throughout"), "{}", finding.words());
    assert_eq!(out(&series), ["crown strain"]);

    // Dead but noisy: it moves under the train no more than before it.
    let mut noisy = train::good();
    for (k, value) in noisy.channels[STRAIN - 1].values.iter_mut().enumerate() {
        *value = 1e-7 * ((k * 7919) % 13) as f64;
    }
    let noisy = judged(vec![noisy]);
    assert_eq!(out(&noisy), ["crown strain"], "{:?}", noisy.findings);
}

#[test]
fn spike() {
    let (series, findings) = findings_of("spike.csv");
    let finding = the(&findings, "R042");
    assert_eq!(place(finding).0, [FIRST + 333; 2]);
    assert!(near(place(finding).2, 3.33) && finding.message.contains("9.990 mm"), "{}", finding.words());
    // Taken out and bridged, both listed; the peak is that of the bridge again.
    assert!(out(&series).is_empty() && series.done.iter().any(|done| done.what == "1 spike taken out"));
    let pier = &series.runs[0].channels[PIER - 1];
    assert!(pier.values[pier.peak().unwrap()] < 0.3e-3);

    let mut loose = train::good();
    (0..8).for_each(|k| loose.channels[PIER - 1].values[300 + 9 * k] = 1e-3);
    assert_eq!(out(&judged(vec![loose])), ["pier displacement"]);
}

#[test]
fn drift() {
    let (series, findings) = findings_of("drift.csv");
    let finding = the(&findings, "R041");
    assert_eq!((finding.severity, finding.place.column), (Severity::Error, Some(STRAIN + 1)));
    assert!(finding.message.contains("before the train and"), "{}", finding.words());
    assert_eq!(out(&series), ["crown strain"]);

    // Accepted with a reason it is used, and still named.
    let accept = Accept {
        code: "R041".to_owned(),
        run: None,
        name: Some("crown strain".to_owned()),
        line: None,
        reason: "the sun; taken off by a line".to_owned(),
    };
    let scrutiny = Scrutiny { accept: vec![accept], ..Scrutiny::default() };
    let accepted = examine(vec![run_of(read_file("drift.csv"))], &scrutiny);
    assert!(out(&accepted).is_empty());
    assert!(the(&accepted.findings, "R041").message.contains("used all the same: the sun"));
}

#[test]
fn a_level_that_changes_under_the_train_alone_is_named_and_used() {
    let mut slid = train::good();
    let from = slid.times.partition_point(|time| *time < 4.0);
    slid.channels[STRAIN - 1].values[from..].iter_mut().for_each(|value| *value += 4e-6);
    let series = judged(vec![slid]);
    assert_eq!(the(&series.findings, "R046").severity, Severity::Warning);
    assert!(series.left_out().is_empty());
}

#[test]
fn a_record_cut_on_a_slope_ends_in_no_spike() {
    for n in 200..560 {
        let mut cut = train::run("fast", 65.0, &[""], 1, |_, _| 1.0);
        cut.times.truncate(n);
        cut.channels.iter_mut().for_each(|channel| channel.values.truncate(n));
        let series = judged(vec![cut]);
        assert!(series.findings.iter().all(|finding| finding.code != "R042"), "{n}: {:?}", series.findings);
    }
}

#[test]
fn wrong_sign() {
    let (series, findings) = findings_of("wrong-sign.csv");
    let finding = the(&findings, "R045");
    assert_eq!((finding.severity, finding.place.column), (Severity::Error, Some(PIER_STRAIN + 1)));
    assert!(finding.message.contains("2 of its 2 sisters"), "{}", finding.words());
    assert_eq!(out(&series), ["pier strain"]);

    let strain = Unit::named("microstrain").unwrap();
    let scrutiny = Scrutiny { expected: vec![expected("pier strain", strain.to_si(-24.0))], ..Scrutiny::default() };
    let alone = examine(vec![run_of(read_file("wrong-sign.csv"))], &scrutiny);
    assert_eq!(out(&alone), ["pier strain"]);

    // Of two that disagree nobody knows which is right: neither is used.
    let two = judged(vec![run_of(read_file("wrong-sign.csv")), train::run("other", 20.0, &[""], 3, |_, _| 1.0)]);
    assert_eq!(two.left_out().len(), 2);
}

#[test]
fn truncated_last_line() {
    let (series, findings) = findings_of("truncated.csv");
    let finding = the(&findings, "R028");
    let last = FIRST + train::good().times.len() - 1;
    assert_eq!(finding.place.lines, Some([last; 2]), "{}", finding.words());
    assert!(finding.message.contains(",0.00,0.00,0`"), "{}", finding.words());
    assert_eq!(series.runs[0].times.len(), train::good().times.len() - 1);
}

#[test]
fn a_drop_out_that_holds_its_value() {
    let mut held = train::good();
    let stuck = held.channels[CROWN - 1].values[400];
    let from = (400..500).find(|k| held.channels[CROWN - 1].values[*k].abs() > 1.5e-4).expect("an axle");
    let value = held.channels[CROWN - 1].values[from];
    assert!(stuck.is_finite());
    held.channels[CROWN - 1].values[from..from + 150].fill(value);
    let series = judged(vec![held]);
    let finding = the(&series.findings, "R043");
    assert!(finding.message.contains("holds") && out(&series) == ["crown displacement"], "{}", finding.words());
}

#[test]
fn channels_are_left_out_by_hand_with_a_reason() {
    let entry =
        |name: &str, reason: &str| LeaveOut { run: None, name: name.to_owned(), line: None, reason: reason.to_owned() };
    let leave_out =
        vec![entry("crown strain", "no tension can be there"), entry("pier strain", " "), entry("pier stain", "typo")];
    let series = examine(vec![train::good()], &Scrutiny { leave_out, ..Scrutiny::default() });
    assert_eq!(series.left_out(), [("slow", "crown strain".to_owned(), "by hand: no tension can be there")]);
    assert!(the(&series.findings, "R051").message.contains("`pier strain` is left out without a reason"));
    assert!(the(&series.findings, "R052").help.contains("pier strain"));
}
