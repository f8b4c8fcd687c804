//! Bridge, spans, rings, piers, abutments.

use toml::de::DeValue;

use crate::diagnostic::TextRange;
use crate::findings::Findings;
use crate::model::{Abutment, Pier, Ring, Span};
use crate::quantity::Dimension;
use crate::ring::{Intrados, Misfit, Profile};
use crate::tree::{At, Table, wrong_type};
use crate::values::measure;

/// Name, width and gravity.
pub(super) struct General {
    pub(super) name: String,
    pub(super) width: f64,
    pub(super) gravity: f64,
}

/// A span and where its parts stand in the file.
#[derive(Debug, Clone)]
pub(crate) struct PlacedSpan {
    pub(crate) span: Span,
    /// Where the shape is described.
    pub(crate) shape: TextRange,
    /// Where each ring's thickness is described, and its voussoirs.
    pub(crate) rings: Vec<(TextRange, TextRange)>,
}

/// Spans that are analysed as one structure; the longest masonry viaducts have a few hundred.
const MOST_SPANS: u64 = 200;

/// Voussoirs that are analysed as one structure: as many as 200 spans of 500.
const MOST_VOUSSOIRS: usize = 100_000;

/// Standard value in bridge practice; the default of the field's card.
const GRAVITY: f64 = 9.81;

pub(super) fn general(file: &Table<'_>, findings: &mut Findings) -> Option<General> {
    let table = file.table("bridge", findings)?;
    let name = table.text("name", findings);
    let width = table.quantity("width", findings);
    let gravity =
        if table.has("gravity") { table.quantity("gravity", findings).map(|at| at.value) } else { Some(GRAVITY) };
    Some(General { name: name?.value.to_owned(), width: width?.value, gravity: gravity? })
}

pub(super) fn spans(file: &Table<'_>, findings: &mut Findings) -> Option<Vec<PlacedSpan>> {
    if !file.has("span") {
        return None;
    }
    let mut spans: Vec<PlacedSpan> = Vec::new();
    let mut complete = true;
    for table in file.tables("span", findings) {
        let repeat = if table.has("repeat") { table.count("repeat", findings).map(|at| at.value) } else { Some(1) };
        let span = span(&table, findings);
        match span.zip(repeat) {
            Some((_, repeat)) if spans.len() as u64 + repeat > MOST_SPANS => {
                findings.error(
                    "B212",
                    table.range,
                    format!("the bridge has more than {MOST_SPANS} spans"),
                    "too many to analyse as one structure",
                    "describe the part of the viaduct that acts together: a few spans on each side of the load",
                );
                return None;
            }
            Some((span, repeat)) => spans.extend((0..repeat).map(|_| span.clone())),
            None => complete = false,
        }
    }
    let blocks: usize = spans.iter().flat_map(|placed| &placed.span.rings).map(|ring| ring.voussoirs).sum();
    if blocks > MOST_VOUSSOIRS {
        findings.error(
            "B212",
            file.place("span"),
            format!("the bridge has {blocks} voussoirs"),
            format!("more than {MOST_VOUSSOIRS} are too many to analyse as one structure"),
            "describe fewer spans, rings or voussoirs; 30 to 100 voussoirs describe a ring well",
        );
        return None;
    }
    (complete && !spans.is_empty()).then_some(spans)
}

fn span(table: &Table<'_>, findings: &mut Findings) -> Option<PlacedSpan> {
    let profile = table.word("profile", findings);
    let span = table.quantity("span", findings);
    let rise = table.quantity("rise", findings);
    let haunch_radius = table.quantity("haunch_radius", findings);
    let points = points(table, findings);
    let rings = rings(table, findings);

    let mut places = Vec::new();
    let (profile, span, rise) = match profile?.value {
        "measured" => {
            let points = points?;
            let origin = points.value.first().map_or([0.0; 2], |first| first.value);
            let moved = |point: &At<[f64; 2]>| [point.value[0] - origin[0], point.value[1] - origin[1]];
            let moved: Vec<[f64; 2]> = points.value.iter().map(moved).collect();
            places = points.value.iter().map(|point| point.range).collect();
            let span = moved.last().map_or(0.0, |last| last[0]);
            let rise = moved.iter().map(|point| point[1]).fold(0.0, f64::max);
            (Profile::Measured(moved), At { value: span, range: points.range }, At { value: rise, range: points.range })
        }
        "three-centred" => (Profile::ThreeCentred { haunch_radius: haunch_radius?.value }, span?, rise?),
        "semicircular" => {
            let span = span?;
            (Profile::Semicircular, span, At { value: 0.5 * span.value, range: span.range })
        }
        "parabolic" => (Profile::Parabolic, span?, rise?),
        "elliptical" => (Profile::Elliptical, span?, rise?),
        "pointed" => (Profile::Pointed, span?, rise?),
        _ => (Profile::Segmental, span?, rise?),
    };
    if let Err(misfit) = Intrados::new(&profile, span.value, rise.value) {
        report(misfit, table, span, rise, &places, findings);
        return None;
    }
    let (rings, places) = rings?.into_iter().unzip();
    let span = Span { profile, span: span.value, rise: rise.value, rings };
    Some(PlacedSpan { span, shape: table.range, rings: places })
}

/// Says what is impossible about a profile, and where.
fn report(
    misfit: Misfit,
    table: &Table<'_>,
    span: At<f64>,
    rise: At<f64>,
    places: &[TextRange],
    findings: &mut Findings,
) {
    let nth = |index: usize| places.get(index).copied().unwrap_or(table.place("points"));
    let half = 0.5 * span.value;
    let points = table.place("points");
    let (range, code, message, label, help) = match misfit {
        Misfit::RiseAboveHalfSpan => (
            rise.range,
            "B201",
            "the rise of a segment is more than half its span".to_owned(),
            format!("half the span is {half} m"),
            "check span and rise, or use profile = \"pointed\" or \"elliptical\"".to_owned(),
        ),
        Misfit::NotHalfSpan => (
            rise.range,
            "B201",
            "the rise of a semicircle is not half its span".to_owned(),
            format!("half the span is {half} m"),
            "remove the rise, or use profile = \"segmental\"".to_owned(),
        ),
        Misfit::ThreeCentredTooHigh => (
            rise.range,
            "B201",
            "the rise of a three-centred arch is more than half its span".to_owned(),
            format!("half the span is {half} m"),
            "check span and rise, or use profile = \"elliptical\"".to_owned(),
        ),
        Misfit::HaunchRadiusTooLarge => (
            table.place("haunch_radius"),
            "B202",
            "the haunch circles leave no room for the crown circle".to_owned(),
            format!("must be less than the rise, {} m", rise.value),
            "give a haunch radius below the rise; around half the rise is common".to_owned(),
        ),
        Misfit::NoPoint => (
            rise.range,
            "B203",
            "a pointed arch rises by more than half its span".to_owned(),
            format!("half the span is {half} m"),
            "check span and rise, or use profile = \"segmental\"".to_owned(),
        ),
        Misfit::TooFewPoints => (
            points,
            "B204",
            "a measured profile needs at least three points".to_owned(),
            "left springing, one or more in between, right springing".to_owned(),
            "add points of the survey; ten or more give a good curve".to_owned(),
        ),
        Misfit::NotLeftToRight(index) => (
            nth(index),
            "B204",
            format!("measured point {} does not lie to the right of the one before", index + 1),
            "points run from the left to the right springing".to_owned(),
            "sort the points by their first coordinate and remove duplicates".to_owned(),
        ),
        Misfit::NotLevel => (
            places.last().copied().unwrap_or(points),
            "B204",
            "the two springings of a measured profile are not level".to_owned(),
            "first and last point must differ by no more than 1 mm in height".to_owned(),
            "end the survey at equal levels, or correct the heights for the slope of the levelling line".to_owned(),
        ),
        Misfit::BelowSpringing(index) => (
            nth(index),
            "B204",
            format!("measured point {} is not above the springings", index + 1),
            "an intrados lies above the line between its springings".to_owned(),
            "check the sign of the heights: up is positive".to_owned(),
        ),
        Misfit::Folded(index) => (
            nth(index),
            "B204",
            format!("no smooth curve leads to measured point {}", index + 1),
            "the points turn too sharply here".to_owned(),
            "check this point, or add points around it".to_owned(),
        ),
        Misfit::NotPositive => (
            span.range,
            "B204",
            "span and rise must be positive".to_owned(),
            "not a shape".to_owned(),
            "give positive lengths".to_owned(),
        ),
    };
    findings.error(code, range, message, label, help);
}

/// Surveyed points [m].
fn points(table: &Table<'_>, findings: &mut Findings) -> Option<At<Vec<At<[f64; 2]>>>> {
    let (field, raw) = table.entry("points")?;
    let DeValue::Array(items) = raw.get_ref() else { return wrong_type(field, raw, findings) };
    let mut points = Vec::new();
    let mut complete = true;
    for item in items.iter() {
        let pair: Vec<_> = match item.get_ref() {
            DeValue::Array(pair) => pair.iter().collect(),
            _ => Vec::new(),
        };
        let [x, y] = pair[..] else {
            complete = false;
            findings.error(
                "B012",
                item.span().into(),
                "a point is a pair of lengths",
                "point",
                "write [\"2.0 m\", \"1.1 m\"]: distance from the left springing, height",
            );
            continue;
        };
        let x = measure(field, x, &[Dimension::Length], findings);
        let y = measure(field, y, &[Dimension::Length], findings);
        match x.zip(y) {
            Some(((x, _), (y, _))) => points.push(At { value: [x.si(), y.si()], range: item.span().into() }),
            None => complete = false,
        }
    }
    complete.then_some(At { value: points, range: raw.span().into() })
}

type PlacedRing = (Ring, (TextRange, TextRange));

/// The rings of a span: its own keys, or [[span.ring]].
fn rings(table: &Table<'_>, findings: &mut Findings) -> Option<Vec<PlacedRing>> {
    if !table.has("ring") {
        return ring(table, findings).map(|ring| vec![ring]);
    }
    for key in ["thickness", "crown_thickness", "springing_thickness", "voussoirs"] {
        if table.has(key) {
            exclude(table, key, "[[span.ring]]", findings);
        }
    }
    let tables = table.tables("ring", findings);
    let rings: Vec<Option<PlacedRing>> = tables.iter().map(|table| ring(table, findings)).collect();
    let rings = rings.into_iter().collect::<Option<Vec<PlacedRing>>>()?;
    (!rings.is_empty()).then_some(rings)
}

/// One ring: a thickness, or one at the crown and one at the springings.
fn ring(table: &Table<'_>, findings: &mut Findings) -> Option<PlacedRing> {
    let voussoirs = table.count("voussoirs", findings);
    if !table.has("voussoirs") && table.section.path == "span" {
        need(table, "voussoirs", findings);
    }
    let thickness = table.quantity("thickness", findings);
    let crown = table.quantity("crown_thickness", findings);
    let springing = table.quantity("springing_thickness", findings);
    let (crown, springing) = if table.has("thickness") {
        for key in ["crown_thickness", "springing_thickness"] {
            if table.has(key) {
                exclude(table, key, "`thickness`", findings);
            }
        }
        (thickness?, thickness?)
    } else {
        match (table.has("crown_thickness"), table.has("springing_thickness")) {
            (false, false) => need(table, "thickness", findings),
            (true, false) => need(table, "springing_thickness", findings),
            (false, true) => need(table, "crown_thickness", findings),
            (true, true) => {}
        }
        (crown?, springing?)
    };
    let voussoirs = voussoirs?;
    let ring = Ring {
        crown_thickness: crown.value,
        springing_thickness: springing.value,
        voussoirs: usize::try_from(voussoirs.value).ok()?,
    };
    Some((ring, (crown.range, voussoirs.range)))
}

pub(super) fn need(table: &Table<'_>, key: &str, findings: &mut Findings) {
    if let Some(field) = table.section.field(key) {
        table.missing(field, findings);
    }
}

/// Two keys that say the same thing.
pub(super) fn exclude(table: &Table<'_>, key: &str, other: &str, findings: &mut Findings) {
    findings.error(
        "B016",
        table.place(key),
        format!("`{key}` and {other} exclude one another"),
        format!("{other} is given as well"),
        format!("keep `{key}` or {other}, not both"),
    );
}

/// The piers as written; how many there must be is for the geometry.
pub(super) fn piers(file: &Table<'_>, findings: &mut Findings) -> Option<Vec<Pier>> {
    let mut piers = Vec::new();
    let mut complete = true;
    for table in file.tables("pier", findings) {
        let width = table.quantity("width", findings);
        let base_width = if table.has("base_width") { table.quantity("base_width", findings) } else { width };
        let height = table.quantity("height", findings);
        let courses = table.count("courses", findings);
        let pier = || {
            Some(Pier {
                width: width?.value,
                base_width: base_width?.value,
                height: height?.value,
                courses: usize::try_from(courses?.value).ok()?,
            })
        };
        match pier() {
            Some(pier) => piers.push(pier),
            None => complete = false,
        }
    }
    complete.then_some(piers)
}

/// Size of an abutment that the file does not describe [m]; the defaults of the fields' cards.
const ABUTMENT: Abutment = Abutment { top_width: 2.0, height: 2.0 };

pub(super) fn abutments(file: &Table<'_>, findings: &mut Findings) -> Option<[Abutment; 2]> {
    if !file.has("abutment") {
        return Some([ABUTMENT; 2]);
    }
    let table = file.table("abutment", findings)?;
    let both = abutment(&table, ABUTMENT, findings);
    let mut side = |key| match table.has(key) {
        true => abutment(&table.table(key, findings)?, both.unwrap_or(ABUTMENT), findings),
        false => both,
    };
    let (left, right) = (side("left"), side("right"));
    Some([left?, right?])
}

fn abutment(table: &Table<'_>, otherwise: Abutment, findings: &mut Findings) -> Option<Abutment> {
    let mut read = |key, value| match table.has(key) {
        true => table.quantity(key, findings).map(|at| at.value),
        false => Some(value),
    };
    let (top_width, height) = (read("top_width", otherwise.top_width), read("height", otherwise.height));
    Some(Abutment { top_width: top_width?, height: height? })
}
