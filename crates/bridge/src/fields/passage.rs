//! A train's passage.

use super::structure::PlacedSpan;
use super::train;
use crate::card::{Field, Kind, Section};
use crate::cards::*;
use crate::findings::Findings;
use crate::passage::{MOST_POSITIONS, Passage, PassageAnalysis, PassageKinematics, PassagePath, PassagePlan, Rayleigh};
use crate::quantity::Dimension::Time;
use crate::resolve::Layout;
use crate::tree::{At, Table};
use crate::values::read;

pub(super) static PASSAGE: Section = Section {
    path: "passage",
    doc: "How the train crosses, and how that is analysed. Self-weight is applied first and subtracted afterwards.",
    fields: &[
        speed("speed", "speed of the train", "45 km/h").at_least(0.01),
        Field::new("time_step", Kind::Quantity(Time), "time from one position to the next", "0.005 s")
            .at_least(1e-5)
            .default("0.005 s"),
        length("from", "position of the first axle at the start, from the left springing of the first span", "-10 m")
            .optional("where the mesh begins"),
        length("to", "position of the first axle at the end", "60 m").optional("where the last axle leaves the mesh"),
        word::<PassageAnalysis>("analysis", "whether inertia is included", "static")
            .default(PassageAnalysis::Static.word()),
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
        number(
            "numerical_damping",
            "numerical damping of time integration: 0 is Newmark's average acceleration, larger values are the method \
             of Hilber, Hughes and Taylor",
            "0.05",
        )
        .between(0.0, 1.0 / 3.0)
        .default("0.0"),
        word::<PassageKinematics>("kinematics", "whether displacements and rotations are large", "small")
            .default(PassageKinematics::Small.word()),
        count("load_steps", "load steps in which the self-weight is applied", "10")
            .between(1.0, 10_000.0)
            .default("10"),
        count("iterations", "most iterations of one step", "100").between(1.0, 100_000.0).default("100"),
        number(
            "tolerance",
            "out-of-balance force of a step that has converged, relative to the applied forces",
            "1e-6",
        )
        .between(1e-12, 0.1)
        .default("1e-6"),
        word::<PassagePath>("path", "how positions are solved", "condensed").default(PassagePath::Condensed.word()),
        lengths("pictures", "positions of the first axle for which pictures are made", r#"["3.0 m", "9.5 m"]"#)
            .optional("the peak of every channel"),
    ],
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
    let damping = damping(table, findings);
    let plan = read!(
        table,
        findings,
        PassagePlan {
            speed,
            time_step,
            from,
            to,
            analysis,
            numerical_damping,
            kinematics,
            load_steps,
            iterations,
            tolerance,
            path,
            pictures;
            damping: damping?,
        }
    )?;
    check(table, &plan, findings).map(|()| plan)
}

/// Rayleigh damping: a ratio, and the two frequencies at which it holds.
fn damping(table: &Table<'_>, findings: &mut Findings) -> Option<Option<Rayleigh>> {
    let ratio: Option<Option<f64>> = table.read("damping_ratio", findings);
    let frequencies: Option<Option<At<Vec<f64>>>> = table.read("damping_frequencies", findings);
    if table.has("damping_ratio") != table.has("damping_frequencies") {
        return table.need(if table.has("damping_ratio") { "damping_frequencies" } else { "damping_ratio" }, findings);
    }
    let Some(ratio) = ratio? else { return Some(None) };
    let frequencies = frequencies??;
    match frequencies.value[..] {
        [low, high] if low < high => Some(Some(Rayleigh { ratio, frequencies: [low, high] })),
        _ => findings.refuse(
            "B654",
            frequencies.range,
            "Rayleigh damping takes two frequencies, the lower first",
            "the damping ratio holds at both, is less in between and more outside",
            r#"write damping_frequencies = ["8 Hz", "40 Hz"]: about the lowest, and the highest that matters"#,
        ),
    }
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
