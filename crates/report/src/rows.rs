//! Rows of the report's tables, made of text.

use crate::numbers::{digits, maybe, percent, with_unit};
use bridge::inputs::{Input, table_with};
use outcome::assessment::{Assessment, once};
use outcome::calibrate::misfit::Scaling;
use outcome::checked::{Checked, Columns};
use outcome::collapse::Status;
use outcome::condition::{Condition, Standing};
use outcome::facts::{ChangeFacts, Reading, SensitivityFacts, ServiceFacts, SweptFacts, VehicleFacts};
use outcome::note::{self, Note};
use outcome::update::{Histories, ReadAtRest, Update};
use outcome::warning::Warning;
use serde::Serialize;

/// A comparison.
#[derive(Serialize)]
pub(crate) struct CheckRow {
    pub code: String,
    pub title: String,
    pub load: String,
    pub value: String,
    pub limit: String,
    pub unit: &'static str,
    pub used: String,
    /// Width of the bar in per cent, at most 100.
    pub bar: u32,
    pub met: bool,
    pub governs: bool,
    pub basis: String,
    /// How many comparisons it stands for, in words.
    pub of: String,
    /// Where the bridge file says for what the value is computed, and where its limit is.
    #[serde(skip)]
    pub keys: [String; 2],
    /// How much of the limit is used.
    #[serde(skip)]
    pub utilisation: f64,
}

/// A check with all its comparisons.
pub(crate) struct EveryRow {
    pub code: String,
    pub title: String,
    pub rows: Vec<CheckRow>,
}

/// Every comparison under the check that it belongs to. Of a vehicle that does not govern, the table of vehicles has the case already.
pub(crate) fn by_check(rows: Vec<CheckRow>, vehicles: &[VehicleRow]) -> Vec<EveryRow> {
    let mut all: Vec<EveryRow> = Vec::new();
    for mut row in rows {
        if row.code == "C204" && !row.governs {
            let told = vehicles.iter().any(|one| one.code == row.load && row.basis.contains(&one.case));
            if told {
                "as in the table of vehicles".clone_into(&mut row.basis);
            }
        }
        match all.iter_mut().find(|one| one.code == row.code) {
            Some(one) => one.rows.push(row),
            None => all.push(EveryRow { code: row.code.clone(), title: row.title.clone(), rows: vec![row] }),
        }
    }
    all
}

/// A check that was not made.
#[derive(Serialize)]
pub(crate) struct OpenRow {
    pub code: String,
    pub title: String,
    pub why: String,
    pub failed: bool,
}

/// Every comparison, worst of each check first within it as made.
pub(crate) fn checks(checked: &[Checked]) -> Vec<CheckRow> {
    let most = outcome::checked::worst(checked);
    let mut rows = Vec::new();
    for check in checked {
        for finding in check.outcome.iter().flatten() {
            rows.push(CheckRow {
                code: check.code.clone(),
                title: check.title.clone(),
                load: finding.load_model.clone(),
                value: digits(finding.value),
                limit: digits(finding.limit),
                unit: finding.unit.word(),
                used: percent(finding.utilisation),
                bar: (100.0 * finding.utilisation).clamp(0.0, 100.0) as u32,
                met: finding.met(),
                governs: most.is_some_and(|(_, most)| std::ptr::eq(most, finding)),
                basis: finding.basis.clone(),
                of: String::new(),
                keys: check.keys.clone(),
                utilisation: finding.utilisation,
            });
        }
    }
    rows
}

/// Of each check the comparison that uses most of its limit.
pub(crate) fn worst(checked: &[Checked]) -> Vec<CheckRow> {
    let one = |check: &Checked| {
        let list = check.outcome.as_ref().ok()?;
        let most = list.iter().reduce(|worst, next| if next.utilisation > worst.utilisation { next } else { worst })?;
        Some(Checked { outcome: Ok(vec![most.clone()]), ..check.clone() })
    };
    let mut rows = checks(&checked.iter().filter_map(one).collect::<Vec<_>>());
    let broken = |code: &str| {
        let of = checked.iter().filter(|check| check.code == code);
        let all: Vec<bool> = of.flat_map(|check| check.outcome.iter().flatten()).map(|finding| finding.met()).collect();
        (all.iter().filter(|met| !**met).count(), all.len())
    };
    for row in &mut rows {
        row.of = match broken(&row.code) {
            (_, 1) => String::new(),
            (0, all) => format!("worst of {all}, all met"),
            (some, all) => format!("worst of {all}, {some} not met"),
        };
    }
    rows
}

/// Every check without a comparison.
pub(crate) fn open(checked: &[Checked]) -> Vec<OpenRow> {
    let row = |check: &Checked| {
        let why = check.outcome.as_ref().err()?;
        Some(OpenRow { code: check.code.clone(), title: check.title.clone(), why: why.why.clone(), failed: why.failed })
    };
    checked.iter().filter_map(row).collect()
}

/// A row of the table of responses: self-weight, live load with design augment, sum, with total augment, sum, allowable.
#[derive(Serialize)]
pub(crate) struct ColumnRow {
    pub what: String,
    pub cells: [String; 5],
    pub limit: String,
    pub unit: &'static str,
    pub place: String,
}

/// Rows with columns: those with the total augment, whose place they are taken at.
pub(crate) fn columns(checked: &[Checked]) -> Vec<ColumnRow> {
    let mut rows = Vec::new();
    for check in checked {
        for finding in check.outcome.iter().flatten() {
            let Some(Columns { load, reading: Reading::Total, values }) = &finding.columns else { continue };
            rows.push(ColumnRow {
                what: format!("{}, {load}", check.title),
                cells: values.map(digits),
                limit: digits(finding.limit),
                unit: finding.unit.word(),
                place: finding.basis.clone(),
            });
        }
    }
    rows
}

/// A parameter before and after.
#[derive(Serialize)]
pub(crate) struct ConditionRow {
    pub parameter: String,
    pub before: String,
    pub after: String,
    pub interval: String,
    pub expected: String,
    pub standing: String,
    pub class: &'static str,
    pub words: String,
    pub source: String,
    /// Its table in the bridge file.
    #[serde(skip)]
    pub input: String,
}

/// Rows of the table of condition.
pub(crate) fn condition(list: &[Condition], update: Option<&Update>, inputs: &[Input]) -> Vec<ConditionRow> {
    let row = |one: &Condition| {
        let interval = update.and_then(|update| {
            let known = update.problem.parameters().iter().position(|known| known.name == one.parameter);
            Some(update.summary(known?)?.interval_95)
        });
        ConditionRow {
            parameter: one.parameter.clone(),
            before: with_unit(one.before, &one.unit),
            after: one.after.map_or("–".to_owned(), |value| with_unit(value, &one.unit)),
            interval: interval
                .map_or("not sampled".to_owned(), |[low, high]| format!("{} to {}", digits(low), digits(high))),
            expected: one
                .expected
                .map_or("–".to_owned(), |[low, high]| format!("{} to {} {}", digits(low), digits(high), one.unit)),
            standing: one.standing.word().replace('-', " "),
            class: match one.standing {
                Standing::AsExpected => "met",
                Standing::Lower => "broken",
                _ => "open",
            },
            words: one.words.clone(),
            source: one.source.clone().unwrap_or_else(|| "the file names no source".to_owned()),
            input: table_with(inputs, "parameter", "name", &one.parameter),
        }
    };
    list.iter().map(row).collect()
}

/// What an update came to, what it could tell, and what was done to its records and found in them.
pub(crate) fn updated(update: &Update) -> Vec<String> {
    let of = match update.problem.misfit().scaling {
        Scaling::MeasuredPeak => "relative errors of peaks",
        Scaling::Uncertainty => {
            "errors in multiples of their uncertainty: about one where the model and the uncertainties are right"
        }
    };
    let norm = format!(
        "Misfit before the update {}, after it {} (weighted root mean square of {of}).",
        maybe(update.basis.as_ref().map(|basis| basis.start.norm)),
        maybe(update.found().map(|found| found.norm))
    );
    let sampled = update.posterior.iter().flat_map(|report| report.posterior.words.iter().cloned());
    let told = outcome::published::told(update).into_iter().chain(sampled);
    let found = update.records.findings.iter().map(outcome::records::Finding::words);
    std::iter::once(norm).chain(told).chain(update.records.done_words()).chain(found).collect()
}

/// A channel of the records.
#[derive(Serialize)]
pub(crate) struct FitRow {
    pub name: String,
    pub unit: String,
    pub measured: String,
    pub start: String,
    pub updated: String,
    pub shape: String,
    pub remark: String,
    /// Its sensor in the bridge file.
    #[serde(skip)]
    pub input: String,
}

/// Fit per channel.
pub(crate) fn fit(update: &Update, inputs: &[Input]) -> Vec<FitRow> {
    let largest = |values: &[f64]| {
        values.iter().copied().reduce(|best, value| if value.abs() > best.abs() { value } else { best })
    };
    let row = |(k, one): (usize, &Histories)| {
        let end = update.found().and_then(|found| found.channels.get(k));
        let shape = end.and_then(|end| end.shape_correlation);
        FitRow {
            name: one.name.clone(),
            unit: one.quantity.unit().to_owned(),
            measured: maybe(
                end.and_then(|_| update.problem.channels()[k].measured_peak()).or_else(|| largest(&one.measured)),
            ),
            start: maybe(largest(&one.start)),
            updated: maybe(end.map(|end| end.model_peak)),
            shape: shape.map_or("–".to_owned(), |shape| format!("{shape:.3}")),
            remark: one.left_out.as_ref().map_or(String::new(), |why| format!("left out: {why}")),
            input: table_with(inputs, "sensor", "name", &one.name),
        }
    };
    update.channels.iter().enumerate().map(row).collect()
}

/// A reading of a load test.
#[derive(Serialize)]
pub(crate) struct ReadingRow {
    pub position: String,
    pub sensor: String,
    pub unit: String,
    pub read: String,
    pub start: String,
    pub updated: String,
    /// Its sensor in the bridge file.
    #[serde(skip)]
    pub input: String,
}

/// What sensors read in the positions of a load test, beside the model.
pub(crate) fn readings(update: &Update, inputs: &[Input]) -> Vec<ReadingRow> {
    let of = |one: &ReadAtRest| {
        let cell = |values: &[f64], k: usize| maybe(values.get(k).copied());
        let row = |(k, position): (usize, &String)| ReadingRow {
            position: position.clone(),
            sensor: one.sensor.clone(),
            unit: one.quantity.unit().to_owned(),
            read: cell(&one.measured, k),
            start: cell(&one.start, k),
            updated: cell(&one.updated, k),
            input: table_with(inputs, "sensor", "name", &one.sensor),
        };
        one.positions.iter().enumerate().map(row).collect::<Vec<_>>()
    };
    update.read_at_rest.iter().flat_map(of).collect()
}

/// A sensor under one load.
#[derive(Serialize)]
pub(crate) struct ChannelRow {
    pub load: String,
    pub name: String,
    pub unit: String,
    pub cells: [String; 4],
    /// Its sensor in the bridge file.
    #[serde(skip)]
    pub input: String,
}

/// The file's sensors under every load.
pub(crate) fn channels(service: &ServiceFacts, inputs: &[Input]) -> Vec<ChannelRow> {
    let rows = service.loads.iter().flat_map(|load| {
        load.channels.iter().map(|channel| ChannelRow {
            load: load.name.clone(),
            name: channel.name.clone(),
            unit: channel.unit.clone(),
            cells: [channel.self_weight, channel.minimum, channel.maximum, channel.peak].map(digits),
            input: table_with(inputs, "sensor", "name", &channel.name),
        })
    });
    rows.collect()
}

/// A quantity that was changed.
#[derive(Serialize)]
pub(crate) struct ChangeRow {
    pub path: String,
    pub value: String,
    pub less: String,
    pub more: String,
    pub turns: bool,
}

/// What would change the verdict; the least telling quantities are left out.
pub(crate) fn changes(facts: &SensitivityFacts) -> Vec<ChangeRow> {
    let row = |one: &ChangeFacts| {
        let crosses = |value: Option<f64>| value.is_some_and(|value| (value > 1.0) != (facts.utilisation > 1.0));
        ChangeRow {
            path: one.path.clone(),
            value: short(&one.value),
            less: one.less.map_or("no answer".to_owned(), percent),
            more: one.more.map_or("no answer".to_owned(), percent),
            turns: crosses(one.less) || crosses(one.more),
        }
    };
    facts.quantities.iter().map(row).collect()
}

/// Warnings and assumptions, each once: which stages say it, and what.
pub(crate) fn said(a: &Assessment) -> (Vec<[String; 3]>, Vec<[String; 2]>) {
    let facts = &a.facts;
    let warning = |(stages, one): (String, &Warning)| [stages, one.code().to_owned(), one.message()];
    let warnings = told_once(facts.warnings_once().into_iter().map(warning).collect());
    let said: [(&'static str, &[Note]); 5] = [
        ("update", facts.update.made().map_or(&[], |facts| &facts.assumptions)),
        ("service", facts.service.made().map_or(&[], |facts| &facts.assumptions)),
        ("collapse", facts.ultimate.made().map_or(&[], |facts| &facts.assumptions)),
        ("vehicles", facts.vehicles.made().map_or(&[], |facts| &facts.assumptions)),
        ("cases", facts.cases.made().map_or(&[], |facts| &facts.assumptions)),
    ];
    let said = said.map(|(stage, list)| (stage, note::words(list)));
    let all = said.iter().flat_map(|(stage, list)| list.iter().map(move |words| (*stage, words)));
    let mut assumptions: Vec<[String; 2]> =
        once(all).into_iter().map(|(stages, words)| [stages, words.clone()]).collect();
    let mut order: Vec<String> = Vec::new();
    for [stages, _] in &assumptions {
        if !order.contains(stages) {
            order.push(stages.clone());
        }
    }
    assumptions.sort_by_key(|[stages, _]| order.iter().position(|known| known == stages));
    (warnings, alike(assumptions))
}

/// Assumptions of one stage that differ in a name or a number, as of several vehicles, told once with what differs.
fn alike(all: Vec<[String; 2]>) -> Vec<[String; 2]> {
    let mut told: Vec<([String; 2], String)> = Vec::new();
    for [stages, words] in all {
        let known = told.iter_mut().find_map(|(row, first)| {
            let differs =
                otherwise(first, &words).filter(|differs| 5 * differs.split(' ').count() <= words.split(' ').count());
            differs.filter(|_| row[0] == stages).map(|differs| (row, differs))
        });
        match known {
            Some((row, differs)) => row[1] = format!("{}; likewise {differs}.", row[1].trim_end_matches('.')),
            None => told.push(([stages, words.clone()], words)),
        }
    }
    told.into_iter().map(|(row, _)| row).collect()
}

/// What was found in the file, once with all places where it was found.
pub(crate) fn found(all: &[[String; 3]]) -> Vec<[String; 3]> {
    let mut told: Vec<[String; 3]> = Vec::new();
    for one in all {
        match told.iter_mut().find(|known| known[..2] == one[..2]) {
            Some(known) => known[2] += &format!(", {}", one[2]),
            None => told.push(one.clone()),
        }
    }
    told
}

/// Warnings of one code, told once: of those that say the same of other places or vehicles, what they say otherwise.
fn told_once(all: Vec<[String; 3]>) -> Vec<[String; 3]> {
    let mut told: Vec<([String; 3], String)> = Vec::new();
    for [stages, code, message] in all {
        let Some((row, first)) = told.iter_mut().find(|(row, _)| row[1] == code) else {
            told.push(([stages, code, message.clone()], message));
            continue;
        };
        let other = match otherwise(first, &message) {
            Some(words) => format!("; likewise {words}"),
            None => format!("; and: {message}"),
        };
        row[2] += &other;
        if !row[0].split(", ").any(|stage| stage == stages) {
            row[0] += &format!(", {stages}");
        }
    }
    told.into_iter().map(|(row, _)| row).collect()
}

/// The words in which one message differs from another of the same form; none where half of it or more differs.
fn otherwise(first: &str, other: &str) -> Option<String> {
    let (a, b): (Vec<&str>, Vec<&str>) = (first.split(' ').collect(), other.split(' ').collect());
    let start = a.iter().zip(&b).take_while(|(x, y)| x == y).count();
    let end = a[start..].iter().rev().zip(b[start..].iter().rev()).take_while(|(x, y)| x == y).count();
    let differs = b.len() - start - end;
    if a.len() == b.len() {
        let words: Vec<String> = a
            .iter()
            .zip(&b)
            .enumerate()
            .filter(|(_, (x, y))| x != y)
            .map(|(k, (_, y))| match b.get(k + 1) {
                // A number goes with its unit.
                Some(unit) if y.ends_with(|c: char| c.is_ascii_digit()) && unit.len() <= 4 && a[k + 1] == *unit => {
                    format!("{y} {}", unit.trim_end_matches([',', ';', ':']))
                }
                _ => y.trim_end_matches([',', ';', ':']).to_owned(),
            })
            .collect();
        return (2 * words.len() < b.len()).then(|| words.join(", "));
    }
    (2 * differs < b.len() && differs > 0).then(|| b[start..b.len() - end].join(" "))
}

/// A vehicle that was moved over the bridge.
#[derive(Serialize)]
pub(crate) struct VehicleRow {
    pub code: String,
    pub title: String,
    pub adequacy: String,
    pub class: &'static str,
    pub width: String,
    pub factor: String,
    pub position: String,
    pub case: String,
}

/// Vehicles, the least adequacy factor first.
pub(crate) fn vehicles(facts: &VehicleFacts) -> Vec<VehicleRow> {
    let mut list: Vec<&SweptFacts> = facts.vehicles.iter().collect();
    let size = |one: &SweptFacts| one.adequacy.or(one.adequacy_at_most).unwrap_or(f64::INFINITY);
    list.sort_by(|a, b| size(a).total_cmp(&size(b)).then(a.code.cmp(&b.code)));
    let row = |one: &SweptFacts| VehicleRow {
        code: one.code.clone(),
        title: one.title.clone(),
        adequacy: one.adequacy.map_or_else(|| unanswered(one), digits) + &both(one),
        class: match one.adequacy {
            Some(factor) if factor >= 1.0 => "met",
            None if one.status == Status::Locks => "met",
            _ => "broken",
        },
        width: digits(one.effective_width_m),
        factor: digits(one.load_factor),
        position: maybe(one.position_m),
        case: one.case.clone(),
    };
    list.into_iter().map(row).collect()
}

/// The factors of both methods, where deformable joints were followed.
fn both(one: &SweptFacts) -> String {
    match (one.rigid, one.deformable) {
        (Some(rigid), Some(gives)) => format!(" (rigid blocks {}, deformable joints {})", digits(rigid), digits(gives)),
        _ => String::new(),
    }
}

/// What stands in the place of an adequacy factor that is not known.
fn unanswered(one: &SweptFacts) -> String {
    let most = one.adequacy_at_most.map_or(String::new(), |most| format!(", at most {}", digits(most)));
    match one.positions_not_converged {
        0 => format!("{}{most}", one.status),
        open => format!("{}{most}: {open} of {} positions without an answer", one.status, one.positions),
    }
}

/// A value of a file with no more digits than people read.
fn short(value: &str) -> String {
    let (number, unit) = value.split_once(' ').unwrap_or((value, ""));
    match number.parse::<f64>() {
        Ok(parsed) if number.len() > 8 => with_unit(parsed, unit),
        _ => value.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn warnings_of_one_kind_are_told_once_with_what_differs() {
        let row = |stage: &str, code: &str, words: &str| [stage, code, words].map(str::to_owned);
        let told = told_once(vec![
            row("collapse", "A102", "the resultant of the load at 1.479 m moves by -129.3 mm"),
            row("collapse", "A194", "a ring of 0.450 m is modelled in one piece"),
            row("vehicles", "A102", "the resultant of the load at 1.530 m moves by -120.7 mm"),
            row("vehicles", "A102", "other words altogether here"),
        ]);
        assert_eq!(told.len(), 2);
        let words = "the resultant of the load at 1.479 m moves by -129.3 mm; likewise 1.530 m, -120.7 mm; and: other words altogether here";
        assert_eq!(told[0], row("collapse, vehicles", "A102", words));
        let places =
            found(&[row("P060", "skew", "line 12"), row("P001", "thin", "line 3"), row("P060", "skew", "line 34")]);
        assert_eq!(places, [row("P060", "skew", "line 12, line 34"), row("P001", "thin", "line 3")]);
    }

    #[test]
    fn every_comparison_stands_under_its_check() {
        let check = |code: &str, load: &str| CheckRow {
            code: code.into(),
            title: "title".into(),
            load: load.into(),
            value: "1".into(),
            limit: "1".into(),
            unit: "",
            used: "100 %".into(),
            bar: 100,
            met: true,
            governs: false,
            basis: "limit analysis; axle 1".into(),
            of: String::new(),
            keys: Default::default(),
            utilisation: 1.0,
        };
        let all = by_check(vec![check("C101", "a"), check("C204", "a"), check("C101", "b")], &[]);
        let groups: Vec<(&str, usize)> = all.iter().map(|one| (one.code.as_str(), one.rows.len())).collect();
        assert_eq!(groups, [("C101", 2), ("C204", 1)]);
        assert_eq!(all[1].rows[0].basis, "limit analysis; axle 1");
    }
}
