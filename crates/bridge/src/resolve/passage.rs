//! A train's passage: train, track, plan and sensors.

use super::geometry::Layout;
use super::materials::maybe;
use super::structure::{PlacedSpan, need};
use super::{sensors, train};
use crate::findings::Findings;
use crate::passage::{MOST_POSITIONS, Passage, PassageAnalysis, PassageKinematics, PassagePath, PassagePlan, Rayleigh};
use crate::tree::Table;

/// The passage; `None` inside where no train crosses.
pub(super) fn passage(
    file: &Table<'_>,
    width: Option<f64>,
    spans: Option<&[PlacedSpan]>,
    layout: Option<&Layout>,
    findings: &mut Findings,
) -> Option<Option<Passage>> {
    let keys = ["train", "track", "passage"];
    if !keys.iter().chain(&["sensor"]).any(|key| file.has(key)) {
        return Some(None);
    }
    for key in keys.into_iter().filter(|key| !file.has(key)) {
        need(file, key, findings);
    }
    let train = train::train(file, findings);
    let track = train::track(file, width, findings);
    let plan = plan(file, findings);
    let sensors = sensors::sensors(file, spans, layout, findings);
    Some(Some(Passage { train: train?, track: track?, plan: plan?, sensors: sensors? }))
}

fn plan(file: &Table<'_>, findings: &mut Findings) -> Option<PassagePlan> {
    let table = file.table("passage", findings)?;
    let mut quantity = |key| {
        let value = table.quantity(key, findings);
        maybe(&table, key, value)
    };
    let (speed, time_step, from, to) = (quantity("speed"), quantity("time_step"), quantity("from"), quantity("to"));
    let mut word = |key| {
        let value = table.word(key, findings);
        maybe(&table, key, value)
    };
    let (analysis, kinematics, path) = (word("analysis"), word("kinematics"), word("path"));
    let mut number = |key| {
        let value = table.number(key, findings);
        maybe(&table, key, value)
    };
    let (ratio, numerical, tolerance) = (number("damping_ratio"), number("numerical_damping"), number("tolerance"));
    let mut count = |key| {
        let value = table.count(key, findings);
        maybe(&table, key, value)
    };
    let (load_steps, iterations) = (count("load_steps"), count("iterations"));
    let pictures = table.quantities("pictures", findings);
    let damping = damping(&table, ratio, findings);
    let plan = PassagePlan {
        speed: speed??,
        time_step: time_step?.unwrap_or(0.005),
        from: from?,
        to: to?,
        analysis: if analysis? == Some("transient") { PassageAnalysis::Transient } else { PassageAnalysis::Static },
        damping: damping?,
        numerical_damping: numerical?.unwrap_or(0.0),
        kinematics: if kinematics? == Some("large") { PassageKinematics::Large } else { PassageKinematics::Small },
        load_steps: load_steps?.map_or(10, |n| n as usize),
        iterations: iterations?.map_or(100, |n| n as usize),
        tolerance: tolerance?.unwrap_or(1e-6),
        path: if path? == Some("plain") { PassagePath::Plain } else { PassagePath::Condensed },
        pictures: maybe(&table, "pictures", pictures)?.unwrap_or_default(),
    };
    check(&table, &plan, findings).then_some(plan)
}

/// Rayleigh damping: a ratio, and the two frequencies at which it holds.
fn damping(table: &Table<'_>, ratio: Option<Option<f64>>, findings: &mut Findings) -> Option<Option<Rayleigh>> {
    let frequencies = table.quantities("damping_frequencies", findings);
    if table.has("damping_ratio") != table.has("damping_frequencies") {
        need(table, if table.has("damping_ratio") { "damping_frequencies" } else { "damping_ratio" }, findings);
        return None;
    }
    let Some(ratio) = ratio? else { return Some(None) };
    let frequencies = frequencies?;
    match frequencies.value[..] {
        [low, high] if low < high => Some(Some(Rayleigh { ratio, frequencies: [low, high] })),
        _ => {
            findings.error(
                "B654",
                frequencies.range,
                "Rayleigh damping takes two frequencies, the lower first",
                "the damping ratio holds at both, is less in between and more outside",
                r#"write damping_frequencies = ["8 Hz", "40 Hz"]: about the lowest, and the highest that matters"#,
            );
            None
        }
    }
}

/// Whether the range of positions is one.
fn check(table: &Table<'_>, plan: &PassagePlan, findings: &mut Findings) -> bool {
    let step = plan.speed * plan.time_step;
    let most = MOST_POSITIONS as f64 * step;
    if let (Some(from), Some(to)) = (plan.from, plan.to) {
        if from >= to {
            findings.error(
                "B655",
                table.place("to"),
                "the train does not travel to the right",
                format!("the first axle starts at {from} m"),
                "give a larger `to`, or leave both out",
            );
            return false;
        }
        if to - from > most {
            findings.error(
                "B655",
                table.place("to"),
                format!("more than {MOST_POSITIONS} positions"),
                format!("a position every {step:.2e} m"),
                "give a larger `time_step`, or a shorter distance",
            );
            return false;
        }
    }
    true
}
