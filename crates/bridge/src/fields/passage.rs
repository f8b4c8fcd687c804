//! The passage of a train or of a road vehicle.

use super::structure::PlacedSpan;
use super::{train, vehicle};
use crate::card::{Section, joined};
use crate::cards::*;
use crate::findings::Findings;
use crate::passage::{Heading, MOST_POSITIONS, Passage, PassagePlan, Way};
use crate::resolve::Layout;
use crate::tree::Table;

pub(super) static PASSAGE: Section = Section {
    path: "passage",
    doc: "How the train or the vehicle crosses, and how that is analysed. Self-weight is applied first and subtracted afterwards.",
    fields: &joined::<15>(&[
        PassagePlan::CARDS.split_at(6).0,
        &[
            number("damping_ratio", "share of critical damping at `damping_frequencies`", "0.03")
                .between(0.0, 0.5)
                .optional("no damping except by friction and yielding"),
            frequencies(
                "damping_frequencies",
                "the two frequencies of Rayleigh damping, the lower first",
                r#"["8 Hz", "40 Hz"]"#,
            )
            .positive()
            .optional("possible only without `damping_ratio`"),
        ],
        PassagePlan::CARDS.split_at(6).1,
    ]),
};

/// The passage; `None` inside where nothing crosses.
pub(crate) fn passage(
    file: &Table<'_>,
    width: Option<f64>,
    spans: Option<&[PlacedSpan]>,
    layout: Option<&Layout>,
    findings: &mut Findings,
) -> Option<Option<Passage>> {
    // What else there is then belongs to loads at rest.
    if file.has("load_test") && !file.has("passage") {
        return Some(None);
    }
    let on_road = file.has("vehicle");
    let keys: &[&str] = if on_road { &["vehicle", "passage"] } else { &["train", "track", "passage"] };
    if !keys.iter().chain(&["sensor"]).any(|key| file.has(key)) {
        return Some(None);
    }
    if let Some(other) = ["train", "track"].into_iter().find(|key| on_road && file.has(key)) {
        return file.exclude(other, "[vehicle]", findings);
    }
    for key in keys.iter().filter(|key| !file.has(key)) {
        file.need::<()>(key, findings);
    }
    let (train, way) = match on_road {
        true => vehicle::vehicle(file, width, findings),
        false => (train::train(file, findings), train::track(file, width, findings).map(Way::Rails)),
    };
    let plan = plan(file, findings);
    let sensors = crate::sensor::sensors(file, spans, layout, findings);
    Some(Some(Passage { train: train?, way: way?, plan: plan?, sensors: sensors? }))
}

fn plan(file: &Table<'_>, findings: &mut Findings) -> Option<PassagePlan> {
    let table = &file.table("passage", findings)?;
    let plan = PassagePlan::of(table, findings)?;
    check(table, &plan, findings).map(|()| plan)
}

/// Whether the range of positions is one.
fn check(table: &Table<'_>, plan: &PassagePlan, findings: &mut Findings) -> Option<()> {
    let step = plan.speed * plan.time_step;
    let most = MOST_POSITIONS as f64 * step;
    if let (Some(from), Some(to)) = (plan.from, plan.to) {
        let way = plan.direction.sign() * (to - from);
        if way <= 0.0 {
            let (word, larger) = match plan.direction {
                Heading::Right => ("right", "larger"),
                Heading::Left => ("left", "smaller"),
            };
            return findings.refuse(
                "B655",
                table.place("to"),
                format!("the first axle does not travel to the {word}"),
                format!("it starts at {from} m"),
                format!("give a {larger} `to`, another `direction`, or leave both out"),
            );
        }
        if way > most {
            return findings.refuse(
                "B655",
                table.place("to"),
                format!("more than {MOST_POSITIONS} positions"),
                format!("a position every {step:.2e} m"),
                "give a larger `time_step`, or a shorter distance",
            );
        }
    }
    Some(())
}
