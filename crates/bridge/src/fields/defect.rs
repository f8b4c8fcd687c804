//! Defects of rings: read, and whether there is a ring at their place of which something is left.

use super::structure::PlacedSpan;
use crate::card::Section;
use crate::cards::*;
use crate::choice::choice;
use crate::defect::{Defect, DefectKind, Face, raked, thinned};
use crate::findings::Findings;
use crate::model::Span;
use crate::tree::{At, Table};

choice! {
    /// The kinds of defects.
    enum Word {
        /// joints without mortar to a `depth`: they touch from there on
        LostMortar = "lost-mortar",
        /// stones that have lost a `depth` of their face
        ThinRing = "thin-ring",
        /// a ring that has come off the one above it: friction alone is left between them
        RingSeparation = "ring-separation",
        /// stones and joints with less strength
        WeakMasonry = "weak-masonry",
        /// stones that have fallen out of the lowest of several rings
        MissingStones = "missing-stones",
        /// one joint that stands open to a `depth`: a hinge that has formed
        OpenJoint = "open-joint",
        /// stones of a single ring that have slid down by a `depth`: their joints bear on what overlaps
        DroppedStones = "dropped-stones",
    }
}

/// Kinds that lie along a stretch.
const STRETCHES: &[&str] =
    &["lost-mortar", "thin-ring", "ring-separation", "weak-masonry", "missing-stones", "dropped-stones"];

pub(super) static DEFECT: Section = Section {
    path: "defect",
    doc: "What is wrong with a ring, and over which stretch of a span. Every method that divides the bridge into blocks feels it.",
    fields: &[
        word::<Word>("kind", "what is wrong", "lost-mortar"),
        count("span", "number of the span, from the left", "1").at_least(1.0).default("1"),
        length("from", "where it begins, horizontally from the span's left springing", "3.0 m")
            .at_least(0.0)
            .only("kind", STRETCHES)
            .optional("the left springing"),
        length("to", "where it ends, horizontally from the span's left springing", "5.5 m")
            .at_least(0.0)
            .only("kind", STRETCHES)
            .optional("the right springing"),
        length("at", "where the open joint is, horizontally from the span's left springing", "2.4 m")
            .at_least(0.0)
            .only("kind", &["open-joint"]),
        word::<Face>("face", "the face from which it is lost or open", "intrados")
            .only("kind", &["lost-mortar", "thin-ring", "open-joint"])
            .default(Face::Intrados.word()),
        length(
            "depth",
            "how deep it is lost or open, from the face as it is now; how far stones have dropped",
            "50 mm",
        )
        .positive()
        .only("kind", &["lost-mortar", "thin-ring", "open-joint", "dropped-stones"]),
        count("ring", "number of the ring, from the intrados up; of two separated rings the lower one", "1")
            .at_least(1.0)
            .only("kind", &["ring-separation", "weak-masonry"])
            .optional("ring-separation: 1; weak-masonry: all rings"),
        angle("friction_angle", "angle of friction that is left", "28 deg")
            .between(0.0, 1.5)
            .only("kind", &["ring-separation", "weak-masonry"])
            .optional("as the joint has it"),
        stress("compressive_strength", "compressive strength that is left", "3 MPa")
            .positive()
            .only("kind", &["weak-masonry"])
            .optional("as [masonry] has it"),
    ],
};

/// Least depth of a ring that may be left [m]: what is thinner is no ring any more.
const LEAST_LEFT: f64 = 0.02;

/// Shares of the arc at which the depth that is left is looked at.
const STATIONS: usize = 200;

/// Reads defects into the spans that have them.
pub(crate) fn defects(file: &Table<'_>, spans: &mut [PlacedSpan], findings: &mut Findings) -> Option<()> {
    file.all("defect", findings, |table, findings| {
        let (number, defect) = defect(table, spans, findings)?;
        let span = &mut spans[number].span;
        let had = least_left(span);
        span.defects.push(defect);
        if had.1 >= LEAST_LEFT && least_left(span).1 < LEAST_LEFT {
            let (share, left) = least_left(span);
            let x = 100.0 * share;
            return findings.refuse(
                "B225",
                table.place("depth"),
                format!("nothing is left of the ring: {:.0} mm at {x:.0} % of its length", 1e3 * left.max(0.0)),
                format!("defects leave at least {:.0} mm", 1e3 * LEAST_LEFT),
                "give the depth that was measured; of several rings, mortar and stones are lost from the outer ones",
            );
        }
        Some(())
    })
    .map(|_| ())
}

/// What defects leave of the outermost rings, where it is least: the share of the arc, and the depth [m].
fn least_left(span: &Span) -> (f64, f64) {
    let left = |step: usize| {
        let share = step as f64 / STATIONS as f64;
        let last = span.rings.len() - 1;
        let lost = |face: Face, ring: usize| {
            let n = span.rings[ring].voussoirs;
            thinned(&span.defects, face, share, n) + raked(&span.defects, face, share, n)
        };
        let (below, above) = (lost(Face::Intrados, 0), lost(Face::Extrados, last));
        let thickness = |ring: usize| span.rings[ring].thickness(share);
        let least =
            if last == 0 { thickness(0) - below - above } else { (thickness(0) - below).min(thickness(last) - above) };
        (share, least)
    };
    (0..=STATIONS).map(left).min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((0.0, f64::INFINITY))
}

fn defect(table: &Table<'_>, spans: &[PlacedSpan], findings: &mut Findings) -> Option<(usize, Defect)> {
    let kind: Option<Word> = table.read("kind", findings);
    let number: Option<At<usize>> = table.read("span", findings);
    let ends = ["from", "to"].map(|key| table.read::<Option<f64>>(key, findings));
    let at: Option<Option<At<f64>>> = table.read("at", findings);
    let face: Option<Face> = table.read("face", findings);
    let ring: Option<Option<At<usize>>> = table.read("ring", findings);
    let [depth, friction_angle, compressive_strength] =
        ["depth", "friction_angle", "compressive_strength"].map(|key| table.read::<Option<f64>>(key, findings));
    let number = number?;
    let Some(span) = number.value.checked_sub(1).and_then(|index| spans.get(index)).map(|placed| &placed.span) else {
        let count = spans.len();
        let message = format!("there is no span {}: the bridge has {count}", number.value);
        return findings.refuse(
            "B224",
            number.range,
            message,
            "counted from the left",
            format!("write a number from 1 to {count}"),
        );
    };
    let at = at?;
    let place = at.as_ref().map(|at| at.value);
    if let Some(At { value, range }) = at
        && value > span.span * (1.0 + 1e-9)
    {
        return findings.refuse(
            "B224",
            range,
            format!("the joint at {value} m lies beyond the span"),
            format!("the span is {} m long", span.span),
            format!("write a place between \"0 m\" and \"{} m\"", span.span),
        );
    }
    let [from, to] = match place {
        Some(at) => [at, at],
        None => [ends[0]?.unwrap_or(0.0), ends[1]?.unwrap_or(span.span)],
    };
    if place.is_none() && !(from < to && to <= span.span * (1.0 + 1e-9)) {
        return findings.refuse(
            "B224",
            if table.has("to") { table.place("to") } else { table.place("from") },
            format!("no stretch of the span lies between {from} m and {to} m"),
            format!("the span is {} m long", span.span),
            format!("write `from` and `to` in this order, between \"0 m\" and \"{} m\"", span.span),
        );
    }
    let rings = span.rings.len();
    let counted = |ring: Option<At<usize>>, most: usize, findings: &mut Findings| match ring {
        Some(At { value, range }) if value > most => {
            let what = if most + 1 == rings { "the lower one of two rings" } else { "a ring of the span" };
            let help = match most {
                0 => "leave the defect out, or describe the rings of the span with [[span.ring]]".to_owned(),
                _ => format!("write a number from 1 to {most}"),
            };
            findings.refuse(
                "B224",
                range,
                format!("ring {value} is not {what}: it has {rings}"),
                "from the intrados up",
                help,
            )
        }
        other => Some(other.map(|at| at.value - 1)),
    };
    let kind = match kind? {
        Word::LostMortar => DefectKind::LostMortar { face: face?, depth: depth?? },
        Word::ThinRing => DefectKind::ThinRing { face: face?, depth: depth?? },
        Word::RingSeparation if rings == 1 => return single(table, "two rings can separate", findings),
        Word::RingSeparation => {
            let ring = counted(ring?, rings - 1, findings)?.unwrap_or(0);
            DefectKind::RingSeparation { ring, friction_angle: friction_angle? }
        }
        Word::WeakMasonry => {
            let (compressive_strength, friction_angle) = (compressive_strength?, friction_angle?);
            if compressive_strength.is_none() && friction_angle.is_none() {
                return table.need("compressive_strength", findings);
            }
            DefectKind::WeakMasonry { ring: counted(ring?, rings, findings)?, compressive_strength, friction_angle }
        }
        Word::MissingStones if rings == 1 => {
            return single(table, "a ring stands without some of its stones", findings);
        }
        Word::MissingStones => DefectKind::MissingStones,
        Word::OpenJoint => DefectKind::OpenJoint { face: face?, depth: depth?? },
        Word::DroppedStones if rings > 1 => {
            return findings.refuse(
                "B224",
                table.place("kind"),
                "the span has several rings",
                "stones of the lowest of several rings that have dropped bear on no ring above",
                "write kind = \"missing-stones\" for the same stretch",
            );
        }
        Word::DroppedStones => DefectKind::DroppedStones { depth: depth?? },
    };
    let shares = shares(span, [from, to])?;
    Some((number.value - 1, Defect { kind, from_to: [from, to], shares }))
}

/// A defect of several rings, in a span that has one.
fn single<T>(table: &Table<'_>, what: &str, findings: &mut Findings) -> Option<T> {
    findings.refuse(
        "B224",
        table.place("kind"),
        "the span has a single ring",
        format!("only in a span of several {what}"),
        "describe the rings with [[span.ring]]; stones that lost part of their depth are a \"thin-ring\"",
    )
}

/// Horizontal places from the left springing [m] as shares of the arc length.
fn shares(span: &Span, places: [f64; 2]) -> Option<[f64; 2]> {
    let intrados = span.intrados().ok()?;
    Some(places.map(|x| {
        if x <= 0.0 || x >= span.span * (1.0 - 1e-12) {
            return if x <= 0.0 { 0.0 } else { 1.0 };
        }
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if intrados.at(middle).point[0] < x { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }))
}
