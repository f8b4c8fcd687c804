//! The structure: bridge, spans, rings.

use super::sweep;
use crate::card::{Field, Section, joined, total};
use crate::cards::*;
use crate::diagnostic::TextRange;
use crate::findings::Findings;
use crate::model::{Pier, Ring, Span};
use crate::ring;
use crate::ring::{Intrados, OWN_KEYS, Shape, Size, WITH_RISE, WITH_SPAN};
use crate::tree::{At, Table};
use crate::values::of_keys;

pub(super) static BRIDGE: Section = Section { path: "bridge", doc: "The bridge as a whole.", fields: General::CARDS };

pub(super) static SPAN: Section = Section {
    path: "span",
    doc: "One span. Span and rise are always measured at the intrados.",
    fields: &joined::<{ total(SPAN_KEYS) }>(SPAN_KEYS),
};

/// Keys of every span, with those of its profile between.
const SPAN_KEYS: &[&[Field]] = &[
    &[
        word::<Shape>("profile", "shape of the intrados", "segmental"),
        length("span", "horizontal distance between the springings, at the intrados, along the road", "18.30 m")
            .positive_up_to(500.0)
            .only("profile", &WITH_SPAN)
            .optional("given by `square_span`; the points of a measured profile have theirs"),
        length("rise", "rise is measured from springing to crown, on the intrados", "2.85 m")
            .positive_up_to(500.0)
            .only("profile", &WITH_RISE),
        length(
            "right_springing",
            "level of the right springing above the left one, at the intrados; negative where it lies lower. `rise` is then that of the middle of the span above the line between both",
            "0.25 m",
        )
        .between(-500.0, 500.0)
        .only("profile", &WITH_SPAN)
        .default("0 m"),
    ],
    &joined::<{ total(OWN_KEYS) }>(OWN_KEYS),
    &[
        length("thickness", "thickness of the ring, constant", "0.711 m")
            .positive_up_to(50.0)
            .optional("given by `crown_thickness` and `springing_thickness`, or by [[span.ring]]"),
        length("crown_thickness", "thickness of the ring at the crown", "0.60 m")
            .positive_up_to(50.0)
            .optional("given by `thickness`, or by [[span.ring]]"),
        length(
            "springing_thickness",
            "thickness of the ring at the springings; linear in arc length to the crown",
            "0.80 m",
        )
        .positive_up_to(50.0)
        .optional("given by `thickness`, or by [[span.ring]]"),
        count("voussoirs", "number of voussoirs of the ring, equal in length", "62")
            .between(3.0, 5000.0)
            .optional("given by [[span.ring]]"),
        tables("ring", &RING, "Several rings of one span, from the intrados up.")
            .at_most(20.0)
            .optional("one ring, described in the span itself"),
        angle("skew", "angle of skew of this span: between the road and the normal of its springings", "25 deg")
            .between(0.0, 1.31)
            .optional("as [carriageway] says; square where it says nothing"),
        length(
            "square_span",
            "span square to the springings, in place of `span`; with `skew` the profile is stretched to what it is along the road",
            "7.80 m",
        )
        .positive_up_to(500.0)
        .only("profile", &WITH_SPAN)
        .optional("given by `span`"),
        count("repeat", "how many spans like this follow one another", "3").between(1.0, 1000.0).default("1"),
    ],
];

pub(super) static RING: Section = Section {
    path: "span.ring",
    doc: "One ring of a span with several, from the intrados up.",
    fields: &[
        length("thickness", "thickness of the ring, constant", "0.225 m")
            .positive_up_to(50.0)
            .optional("given by `crown_thickness` and `springing_thickness`"),
        length("crown_thickness", "thickness of the ring at the crown", "0.225 m")
            .positive_up_to(50.0)
            .optional("given by `thickness`"),
        length(
            "springing_thickness",
            "thickness of the ring at the springings; linear in arc length to the crown",
            "0.338 m",
        )
        .positive_up_to(50.0)
        .optional("given by `thickness`"),
        count("voussoirs", "number of voussoirs of the ring, equal in length", "40").between(3.0, 5000.0),
    ],
};

of_keys! {
    /// Name, width and gravity.
    pub(crate) struct General {
        pub(crate) name: String = text("name of the bridge, for titles", "Bridgemill"),
        pub(crate) width: f64 = length("width of the barrel, which carries the loads", "8.30 m").positive_up_to(100.0),
        pub(crate) gravity: f64 =
            acceleration("acceleration of gravity", "9.81 m/s^2").positive_up_to(30.0).default("9.81 m/s^2"),
    }
}

/// A span and where its parts stand in the file.
#[derive(Debug, Clone)]
pub(crate) struct PlacedSpan {
    pub(crate) span: Span,
    /// Its own skew [rad].
    pub(crate) skew: Option<f64>,
    /// Where the shape is described.
    pub(crate) shape: TextRange,
    /// Where each ring's thickness is described, and its voussoirs.
    pub(crate) rings: Vec<(TextRange, TextRange)>,
}

/// Spans that are analysed as one structure; the longest masonry viaducts have a few hundred.
const MOST_SPANS: u64 = 200;

/// Voussoirs, and courses of piers and abutments, that are analysed as one structure: as many as 200 spans of 500.
const MOST_BLOCKS: usize = 100_000;

pub(crate) fn general(file: &Table<'_>, findings: &mut Findings) -> Option<General> {
    General::of(&file.table("bridge", findings)?, findings)
}

pub(crate) fn spans(file: &Table<'_>, findings: &mut Findings) -> Option<Vec<PlacedSpan>> {
    if !file.has("span") {
        return None;
    }
    let mut spans: Vec<PlacedSpan> = Vec::new();
    let mut complete = true;
    for table in file.tables("span", findings) {
        let repeat: Option<u64> = table.read("repeat", findings);
        let span = span(&table, findings);
        match span.zip(repeat) {
            Some((_, repeat)) if spans.len() as u64 + repeat > MOST_SPANS => {
                return findings.refuse(
                    "B212",
                    table.range,
                    format!("the bridge has more than {MOST_SPANS} spans"),
                    "too many to analyse as one structure",
                    "describe the part of the viaduct that acts together: a few spans on each side of the load",
                );
            }
            Some((span, repeat)) => spans.extend((0..repeat).map(|_| span.clone())),
            None => complete = false,
        }
    }
    let voussoirs: usize = spans.iter().flat_map(|placed| &placed.span.rings).map(|ring| ring.voussoirs).sum();
    if voussoirs > MOST_BLOCKS {
        return findings.refuse(
            "B212",
            file.place("span"),
            format!("the bridge has {voussoirs} voussoirs"),
            format!("more than {MOST_BLOCKS} are too many to analyse as one structure"),
            "describe fewer spans, rings or voussoirs; 30 to 100 voussoirs describe a ring well",
        );
    }
    (complete && !spans.is_empty()).then_some(spans)
}

/// Refuses piers whose courses are more blocks than can be analysed as one structure beside the voussoirs.
pub(crate) fn count_blocks(file: &Table<'_>, spans: &[PlacedSpan], piers: &[Pier], findings: &mut Findings) {
    let voussoirs: usize = spans.iter().flat_map(|placed| &placed.span.rings).map(|ring| ring.voussoirs).sum();
    let courses = match piers {
        [one] => one.courses * spans.len().saturating_sub(1),
        many => many.iter().map(|pier| pier.courses).sum(),
    };
    if voussoirs + courses > MOST_BLOCKS {
        findings.error(
            "B212",
            file.place("pier"),
            format!(
                "the bridge has {} blocks: {voussoirs} voussoirs and {courses} courses of piers",
                voussoirs + courses
            ),
            format!("more than {MOST_BLOCKS} are too many to analyse as one structure"),
            "describe fewer courses; 5 to 20 describe a pier well",
        );
    }
}

fn span(table: &Table<'_>, findings: &mut Findings) -> Option<PlacedSpan> {
    let profile = ring::read(table, findings);
    let rings = rings(table, findings);
    let skew: Option<Option<At<f64>>> = table.read("skew", &mut Findings::default());
    if let Some(At { value, range }) = skew.flatten() {
        sweep::doubt(value, range, findings);
    }
    let (profile, Size { span, rise, right }) = profile?;
    if let Err(misfit) = Intrados::between(&profile, span, rise, right) {
        let entries = table.entry(misfit.key).and_then(|(_, raw)| raw.get_ref().as_array());
        let entry = misfit.entry.and_then(|index| entries?.get(index));
        let place = entry.map_or(table.place(misfit.key), |entry| entry.span().into());
        return findings.refuse(misfit.code, place, misfit.message, misfit.label, misfit.help);
    }
    let (rings, places) = rings?.into_iter().unzip();
    Some(PlacedSpan {
        span: Span { profile, span, rise, right_springing: right, rings, defects: Vec::new(), skew: 0.0 },
        skew: skew.flatten().map(|skew| skew.value),
        shape: table.range,
        rings: places,
    })
}

type PlacedRing = (Ring, (TextRange, TextRange));

/// The rings of a span: its own keys, or [[span.ring]].
fn rings(table: &Table<'_>, findings: &mut Findings) -> Option<Vec<PlacedRing>> {
    if !table.has("ring") {
        return ring(table, findings).map(|ring| vec![ring]);
    }
    for key in ["thickness", "crown_thickness", "springing_thickness", "voussoirs"] {
        if table.has(key) {
            table.exclude::<()>(key, "[[span.ring]]", findings);
        }
    }
    table.all("ring", findings, ring)
}

/// One ring: a thickness, or one at the crown and one at the springings.
fn ring(table: &Table<'_>, findings: &mut Findings) -> Option<PlacedRing> {
    let voussoirs: Option<Option<At<usize>>> = table.read("voussoirs", findings);
    if !table.has("voussoirs") && table.section.path == "span" {
        table.need::<()>("voussoirs", findings);
    }
    let [thickness, crown, springing] = ["thickness", "crown_thickness", "springing_thickness"]
        .map(|key| table.read::<Option<At<f64>>>(key, findings).flatten());
    let (crown, springing) = if table.has("thickness") {
        for key in ["crown_thickness", "springing_thickness"] {
            if table.has(key) {
                table.exclude::<()>(key, "`thickness`", findings);
            }
        }
        (thickness?, thickness?)
    } else {
        match (table.has("crown_thickness"), table.has("springing_thickness")) {
            (false, false) => table.need("thickness", findings),
            (true, false) => table.need("springing_thickness", findings),
            (false, true) => table.need("crown_thickness", findings),
            (true, true) => Some(()),
        }?;
        (crown?, springing?)
    };
    let At { value: voussoirs, range } = voussoirs??;
    let ring = Ring { crown_thickness: crown.value, springing_thickness: springing.value, voussoirs };
    Some((ring, (crown.range, range)))
}
