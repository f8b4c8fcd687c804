//! A train's passage.

use super::structure::PlacedSpan;
use super::train;
use crate::card::{Section, joined};
use crate::cards::*;
use crate::findings::Findings;
use crate::passage::{MOST_POSITIONS, Passage, PassagePlan};
use crate::resolve::Layout;
use crate::tree::Table;

pub(super) static PASSAGE: Section = Section {
    path: "passage",
    doc: "How the train crosses, and how that is analysed. Self-weight is applied first and subtracted afterwards.",
    fields: &joined::<14>(&[
        PassagePlan::CARDS.split_at(5).0,
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
        PassagePlan::CARDS.split_at(5).1,
    ]),
};

/// The passage; `None` inside where no train crosses.
pub(crate) fn passage(
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
        file.need::<()>(key, findings);
    }
    let train = train::train(file, findings);
    let track = train::track(file, width, findings);
    let plan = plan(file, findings);
    let sensors = crate::sensor::sensors(file, spans, layout, findings);
    Some(Some(Passage { train: train?, track: track?, plan: plan?, sensors: sensors? }))
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
        if from >= to {
            return findings.refuse(
                "B655",
                table.place("to"),
                "the train does not travel to the right",
                format!("the first axle starts at {from} m"),
                "give a larger `to`, or leave both out",
            );
        }
        if to - from > most {
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
