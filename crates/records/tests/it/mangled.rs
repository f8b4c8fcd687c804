//! A good file mangled in ten thousand ways: nothing panics, and what is removed or altered is named.

use crate::{judged, read_text, train};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use records::{Finding, Preparation, Read, Recording, dynamics, peaks, plane_strain, prepare};
use std::sync::LazyLock;

/// The start of the good table: short enough to be mangled often.
static GOOD: LazyLock<Vec<u8>> = LazyLock::new(|| {
    let mut run = train::good();
    let kept = 180..260;
    run.times = run.times[kept.clone()].to_vec();
    run.channels.iter_mut().for_each(|channel| channel.values = channel.values[kept.clone()].to_vec());
    records::write(&run).into_bytes()
});

#[derive(Debug, Clone)]
enum Mangle {
    Replace(usize, u8),
    Insert(usize, Vec<u8>),
    Remove(usize, usize),
    Repeat(usize, usize),
    Swap(usize, usize),
    Cut(usize),
}

fn mangle() -> impl Strategy<Value = Mangle> {
    let at = || 0..100_000_usize;
    let byte = prop_oneof![3 => prop::sample::select(b"0123456789.,;-+eE\n\r\t\"#% @[]xNa".to_vec()), 1 => any::<u8>()];
    prop_oneof![
        4 => (at(), byte.clone()).prop_map(|(k, b)| Mangle::Replace(k, b)),
        3 => (at(), prop::collection::vec(byte, 1..6)).prop_map(|(k, b)| Mangle::Insert(k, b)),
        3 => (at(), 1..300_usize).prop_map(|(k, n)| Mangle::Remove(k, n)),
        2 => (at(), 1..300_usize).prop_map(|(k, n)| Mangle::Repeat(k, n)),
        1 => (at(), at()).prop_map(|(a, b)| Mangle::Swap(a, b)),
        1 => at().prop_map(Mangle::Cut),
    ]
}

fn apply(mut bytes: Vec<u8>, mangles: &[Mangle]) -> Vec<u8> {
    for mangle in mangles {
        let n = bytes.len();
        if n == 0 {
            return bytes;
        }
        match mangle {
            Mangle::Replace(k, byte) => bytes[k % n] = *byte,
            Mangle::Insert(k, more) => drop(bytes.splice(k % n..k % n, more.iter().copied())),
            Mangle::Remove(k, length) => drop(bytes.drain(k % n..(k % n + length).min(n))),
            Mangle::Repeat(k, length) => {
                let part = bytes[k % n..(k % n + length).min(n)].to_vec();
                drop(bytes.splice(k % n..k % n, part));
            }
            Mangle::Swap(a, b) => bytes.swap(a % n, b % n),
            Mangle::Cut(k) => bytes.truncate(k % n),
        }
    }
    bytes
}

/// Whether a finding speaks of a line, and of a column where it has one.
fn named(findings: &[Finding], line: usize, column: usize) -> bool {
    let inside = |finding: &&Finding| finding.place.lines.is_some_and(|[first, last]| first <= line && line <= last);
    findings.iter().filter(inside).any(|finding| finding.place.column.is_none_or(|c| c == column || column == 0))
}

/// Every line of the text is in the run with the numbers that stand in it, or is named. The check splits and parses by itself,
/// as plainly as can be.
fn nothing_is_silent(bytes: &[u8], read: &Read) -> Result<(), TestCaseError> {
    let Some(run) = &read.run else {
        prop_assert!(read.findings.iter().any(|finding| finding.severity == records::Severity::Error));
        return Ok(());
    };
    let Ok(text) = std::str::from_utf8(bytes) else { return Ok(()) };
    let end = if text.contains('\n') { '\n' } else { '\r' };
    let lines: Vec<&str> = text.split(end).collect();
    // The line of the headings is known where something was said of it; otherwise it is the good file's.
    let said =
        |codes: &str| read.findings.iter().find(|finding| finding.code.starts_with(codes)).and_then(|f| f.place.lines);
    let is_head = |line: &str| {
        let folded = line.to_lowercase();
        !folded.trim_start().starts_with(['#', '%']) && (folded.contains("time") || folded.starts_with('t'))
    };
    let plain = lines.iter().position(|line| is_head(line)).unwrap_or(0);
    let head = said("R004").map(|[_, last]| last).or(said("R01").map(|[line, _]| line - 1)).unwrap_or(plain);
    let mut kept = 0;
    for (k, line) in lines.iter().enumerate().skip(head + 1) {
        let (number, bare) = (k + 1, line.trim());
        if bare.is_empty() {
            continue;
        }
        if run.lines.get(kept) != Some(&(number as u32)) {
            prop_assert!(named(&read.findings, number, 0), "line {number} is gone: {line}\n{:?}", read.findings);
            continue;
        }
        let rows = || lines.iter().filter(|line| !line.trim_start().starts_with(['#', '%']) && !line.trim().is_empty());
        let with = |mark: char| rows().filter(|line| line.contains(mark)).count();
        let separator = [';', '\t'].into_iter().find(|mark| 2 * with(*mark) >= rows().count()).unwrap_or(',');
        let cells: Vec<&str> = line.split(separator).map(str::trim).collect();
        for channel in run.channels.iter().filter(|_| !line.contains('"')) {
            let value = channel.values[kept];
            if value.is_nan() {
                prop_assert!(named(&read.findings, number, channel.column), "line {number}: {line}");
            } else if let Some(Ok(cell)) = cells.get(channel.column - 1).map(|cell| cell.parse::<f64>()) {
                prop_assert_eq!(channel.unit.to_si(cell), value, "line {}: {}", number, line);
            }
        }
        kept += 1;
    }
    prop_assert_eq!(kept, run.lines.len());
    Ok(())
}

/// What was judged differs from what was read by what is named alone.
fn nothing_is_altered_in_silence(read: &Recording) -> Result<(), TestCaseError> {
    let series = judged(vec![read.clone()]);
    let run = &series.runs[0];
    for line in &read.lines {
        let gone = !run.lines.contains(line);
        prop_assert!(!gone || named(&series.findings, *line as usize, 0), "line {line}: {:?}", series.findings);
    }
    for (one, two) in run.channels.iter().zip(&read.channels) {
        if !one.used() {
            let reason = one.left_out.as_deref().unwrap_or_default();
            prop_assert!(
                two.left_out.is_some() || series.findings.iter().any(|f| reason.starts_with(f.code)),
                "{reason}"
            );
            continue;
        }
        for (k, line) in run.lines.iter().enumerate() {
            let at = read.lines.iter().position(|other| other == line).expect("a line of the file");
            let (after, before) = (one.values[k], two.values[at]);
            prop_assert!(after.is_finite());
            if before.is_finite() && before != after {
                prop_assert!(named(&series.findings, *line as usize, one.column), "{}: line {line}", one.name);
            }
            if before != after {
                prop_assert!(series.done.iter().any(|done| done.channel == one.title()), "{}", one.name);
            }
        }
    }
    // The rest of the way must not fall over either.
    let preparation = Preparation {
        detrend: records::Detrend::QuietEnds,
        low_pass: Some(20.0),
        rate: Some(50.0),
        cut: records::Cut::Answering { share: 0.05, margin: 0.1 },
        ..Preparation::default()
    };
    let series = prepare(series, &preparation);
    let table = peaks(&series);
    let verdict = (dynamics(&table), plane_strain(&table, Some(&series)));
    prop_assert!(!verdict.0.words.is_empty() && !verdict.1.words.is_empty());
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 10_000, rng_seed: RngSeed::Fixed(1934), failure_persistence: None, ..ProptestConfig::default() })]
    #[test]
    fn whatever_happens_to_a_file(mangles in prop::collection::vec(mangle(), 1..5)) {
        let bytes = apply(GOOD.clone(), &mangles);
        let read = read_text(&bytes, "mangled");
        nothing_is_silent(&bytes, &read)?;
        if let Some(run) = &read.run {
            nothing_is_altered_in_silence(run)?;
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2_000, rng_seed: RngSeed::Fixed(1934), failure_persistence: None, ..ProptestConfig::default() })]
    #[test]
    fn any_bytes_are_read(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        let read = read_text(&bytes, "bytes");
        prop_assert!(read.run.is_some() || !read.findings.is_empty());
    }
}
