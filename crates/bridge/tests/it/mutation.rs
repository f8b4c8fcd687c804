//! Random and mutated files: reading never panics, and whatever is refused has a place, a reason and a remedy.

use bridge::{Severity, read};
use proptest::prelude::*;

use crate::files::GOOD;

/// A small reproducible generator (Steele, Lea and Flood, SplitMix64): a file is named by its number.
struct Dice(u64);

impl Dice {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, bound: usize) -> usize {
        (self.next() % bound.max(1) as u64) as usize
    }

    fn pick<'a>(&mut self, from: &[&'a str]) -> &'a str {
        from[self.below(from.len())]
    }
}

/// Pieces that have broken readers before.
const PIECES: &[&str] = &[
    "\"1e300 m\"",
    "\"-1 m\"",
    "\"0 m\"",
    "\"1e-300 m\"",
    "\"nan m\"",
    "\"inf m\"",
    "\"1 GPa\"",
    "\"\"",
    "\"m\"",
    "nan",
    "inf",
    "-inf",
    "1e400",
    "9223372036854775807",
    "-9223372036854775808",
    "99999999999999999999",
    "0",
    "-1",
    "1",
    "2",
    "3",
    "0x7f",
    "true",
    "[]",
    "{}",
    "[[]]",
    "[\"1 m\"]",
    "1979-05-27",
    "\"\\u0000\"",
    "\"°\"",
    "\"2:0\"",
    "\"0:0\"",
    "\"1/0 of span 1\"",
    "\"1/4 of span 18446744073709551616\"",
    "\"100% span\"",
    "\"pier 0\"",
    "\"measured\"",
    "\"three-centred\"",
    "\"pointed\"",
    "\"dem\"",
    "\"limit\"",
    "\"axles\"",
    "[[span]]",
    "[[span.ring]]",
    "[[pier]]",
    "[span]",
    "[load]",
    "[[load]]",
    "[[cover]]",
    "[analysis]",
    "[support_movement]",
    "=",
    "\n",
    "\"",
    "'''",
    "\"\"\"",
    "#",
    "\r\n",
    "\u{feff}",
    ".",
    "points",
    "ring",
    "repeat = 200",
    "voussoirs = 5000",
    "voussoirs = 3",
    "[[\"0 m\", \"0 m\"], [\"1e-9 m\", \"9 m\"], [\"1 m\", \"0 m\"]]",
];

/// The file of this number: a good file with a few accidents, or noise.
pub(crate) fn accident(number: u64) -> Vec<u8> {
    let mut dice = Dice(number);
    if dice.below(16) == 0 {
        return (0..dice.below(400)).map(|_| dice.next() as u8).collect();
    }
    let mut file = GOOD[dice.below(GOOD.len())].as_bytes().to_vec();
    for _ in 0..=dice.below(4) {
        let (a, b) = (dice.below(file.len() + 1), dice.below(file.len() + 1));
        let (start, end) = (a.min(b), a.max(b));
        match dice.below(9) {
            0 if !file.is_empty() => {
                let at = a.min(file.len() - 1);
                file[at] = dice.next() as u8;
            }
            1 => drop(file.drain(start..end.min(start + 40))),
            2 => {
                let copy = file[start..end.min(start + 200)].to_vec();
                file.splice(b..b, copy);
            }
            3 => drop(file.splice(a..a, dice.pick(PIECES).bytes())),
            4 => replace_line(&mut file, &mut dice),
            5 | 6 => replace_value(&mut file, &mut dice),
            7 => {
                if let Some(at) = file.iter().skip(a).position(u8::is_ascii_digit) {
                    file[a + at] = b"0123456789.-e"[dice.below(13)];
                }
            }
            _ => file.truncate(end),
        }
    }
    file
}

fn lines(file: &[u8]) -> Vec<Vec<u8>> {
    file.split(|byte| *byte == b'\n').map(<[u8]>::to_vec).collect()
}

/// A line goes, comes twice, or changes places.
fn replace_line(file: &mut Vec<u8>, dice: &mut Dice) {
    let mut lines = lines(file);
    let (a, b) = (dice.below(lines.len()), dice.below(lines.len()));
    match dice.below(3) {
        0 => drop(lines.remove(a)),
        1 => lines.insert(b, lines[a].clone()),
        _ => lines.swap(a, b),
    }
    *file = lines.join(&b'\n');
}

/// The value of a line becomes another, or that of another line.
fn replace_value(file: &mut Vec<u8>, dice: &mut Dice) {
    let mut lines = lines(file);
    let (a, b) = (dice.below(lines.len()), dice.below(lines.len()));
    let equals = |line: &[u8]| line.iter().position(|byte| *byte == b'=');
    let Some(at) = equals(&lines[a]) else { return };
    let value = match equals(&lines[b]) {
        Some(other) if dice.below(2) == 0 => lines[b][other + 1..].to_vec(),
        _ => dice.pick(PIECES).as_bytes().to_vec(),
    };
    lines[a].truncate(at + 1);
    lines[a].extend(value);
    *file = lines.join(&b'\n');
}

/// What must hold of any bytes.
fn judge(file: &[u8]) -> Result<(), String> {
    let read = read(file);
    let refused = read.diagnostics.iter().any(|finding| finding.severity == Severity::Error);
    if read.bridge.is_some() == refused {
        return Err(format!("a bridge: {}, refused: {refused}", read.bridge.is_some()));
    }
    for finding in &read.diagnostics {
        let place = finding.range.start <= finding.range.end && finding.range.end <= file.len();
        let reason = !finding.message.is_empty() && !finding.label.is_empty();
        let remedy = finding.help.as_ref().is_some_and(|help| !help.is_empty());
        let card = bridge::explain::explain(finding.code).is_some();
        if !(place && reason && remedy && card) {
            return Err(format!("{finding:?}"));
        }
        let _ = finding.range.position(file);
    }
    if let Some(mut bridge) = read.bridge {
        // Names may hold any word.
        bridge.name.clear();
        bridge.loads.iter_mut().for_each(|load| load.name.clear());
        if let Some(passage) = &mut bridge.passage {
            passage.train.name.clear();
            passage.train.file = None;
            passage.train.vehicles.iter_mut().for_each(|vehicle| vehicle.name.clear());
            passage.sensors.iter_mut().for_each(|sensor| sensor.name.clear());
        }
        if let Some(test) = &mut bridge.load_test {
            if let Some(train) = &mut test.train {
                train.name.clear();
                train.file = None;
            }
            let vehicles = test.train.iter_mut().flat_map(|train| &mut train.vehicles);
            vehicles.for_each(|vehicle| vehicle.name.clear());
            test.sensors.iter_mut().for_each(|sensor| sensor.name.clear());
            for position in &mut test.positions {
                position.name.clear();
                position.vehicles.iter_mut().for_each(|one| one.vehicle = None);
            }
            test.readings.file = None;
        }
        let numbers = format!("{bridge:?}");
        if numbers.contains("NaN") || numbers.contains("inf") {
            return Err(numbers);
        }
    }
    Ok(())
}

fn judge_many(numbers: std::ops::Range<u64>) -> u64 {
    let mut refused = 0;
    for number in numbers {
        let file = accident(number);
        if let Err(reason) = judge(&file) {
            panic!("file {number}: {reason}\n{}", String::from_utf8_lossy(&file));
        }
        refused += u64::from(read(&file).bridge.is_none());
    }
    refused
}

#[test]
fn ten_thousand_accidents_are_refused_with_reasons() {
    let refused = judge_many(0..10_000);
    // Most accidents break something, and not all do: otherwise this would test little.
    assert!((5_000..9_990).contains(&refused), "{refused}");
}

#[test]
#[ignore = "takes most of a minute; cargo test --release -p bridge -- --ignored accidents"]
fn hundred_thousand_accidents_are_refused_with_reasons() {
    judge_many(1_000_000..1_100_000);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_bytes_are_read(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        judge(&bytes).map_err(TestCaseError::fail)?;
    }

    #[test]
    fn any_text_is_read(text in "\\PC{0,200}") {
        judge(text.as_bytes()).map_err(TestCaseError::fail)?;
    }

    #[test]
    fn any_accident_is_survived(number in any::<u64>()) {
        judge(&accident(number)).map_err(TestCaseError::fail)?;
    }

    #[test]
    fn any_quantity_is_read_or_refused(text in "[-+0-9.eE, ]{0,12}[ a-zA-Z/^0-9°³²]{0,8}") {
        if let Ok(quantity) = bridge::quantity::parse(&text) {
            prop_assert!(quantity.si().is_finite());
        }
    }

    /// A number with any unit of a dimension is read back as it was written.
    #[test]
    fn lengths_in_any_unit_are_the_same_length(length in 0.5..400.0f64) {
        for unit in bridge::quantity::Dimension::Length.units() {
            let text = format!("{} {}", length / unit.size, unit.symbol);
            let back = bridge::quantity::parse(&text).unwrap().si();
            // One rounding each way.
            prop_assert!((back - length).abs() <= 2.0 * f64::EPSILON * length);
        }
    }

    /// Every circular segment passes through its crown and springings, whatever span and rise.
    #[test]
    fn every_profile_passes_through_its_crown(span in 0.5..300.0f64, flatness in 0.02..0.499f64) {
        use bridge::ring::{Intrados, Profile};
        let rise = span * flatness;
        for profile in [Profile::Segmental, Profile::Parabolic, Profile::Elliptical, Profile::ThreeCentred { haunch_radius: 0.5 * rise }] {
            let intrados = Intrados::between(&profile, span, rise, 0.0).unwrap();
            let crown = intrados.at(0.5).point;
            prop_assert!((crown[1] - rise).abs() <= 1e-12 * span, "{:?} {}", profile, crown[1] - rise);
            prop_assert!(intrados.length() > 2.0 * (0.5 * span).hypot(rise));
            prop_assert!(intrados.length() < span + 2.0 * rise);
        }
    }
}
