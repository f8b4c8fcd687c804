//! Sensors: what, where, and whether the bridge has such a place.

use super::geometry::Layout;
use super::loading::share;
use super::materials::maybe;
use super::structure::{PlacedSpan, exclude, need};
use crate::findings::Findings;
use crate::passage::{Direction, Face, GAUGE_LENGTH, Place, Sensor, SensorKind};
use crate::ring::Intrados;
use crate::tree::Table;

/// Most channels of a record.
const MOST: usize = 1000;

/// The sensors of the file; none where it leaves them to the defaults.
pub(super) fn sensors(
    file: &Table<'_>,
    spans: Option<&[PlacedSpan]>,
    layout: Option<&Layout>,
    findings: &mut Findings,
) -> Option<Vec<Sensor>> {
    let tables = file.tables("sensor", findings);
    if file.has("sensor") && tables.is_empty() {
        return None;
    }
    if let Some(beyond) = tables.get(MOST) {
        findings.error(
            "B657",
            beyond.range,
            format!("there are {} sensors", tables.len()),
            "a record has a thousand channels at most",
            "remove some",
        );
        return None;
    }
    let list: Vec<Option<Sensor>> = tables.iter().map(|table| sensor(table, spans, layout, findings)).collect();
    let list: Vec<Sensor> = list.into_iter().collect::<Option<_>>()?;
    for (k, sensor) in list.iter().enumerate() {
        if list[..k].iter().any(|other| other.name == sensor.name) {
            findings.error(
                "B657",
                tables[k].place("name"),
                "two sensors have the same name",
                "name of a channel in the record",
                "give each a name of its own",
            );
        }
    }
    Some(list)
}

fn sensor(
    table: &Table<'_>,
    spans: Option<&[PlacedSpan]>,
    layout: Option<&Layout>,
    findings: &mut Findings,
) -> Option<Sensor> {
    let name = table.text("name", findings);
    let kind = table.word("kind", findings);
    let direction = table.word("direction", findings);
    let gauge_length = table.quantity("gauge_length", findings);
    let face = table.word("face", findings);
    let place = place(table, layout, findings);
    let kind = match kind?.value {
        "strain" => {
            SensorKind::Strain { gauge_length: maybe(table, "gauge_length", gauge_length)?.unwrap_or(GAUGE_LENGTH) }
        }
        "joint-opening" => SensorKind::JointOpening,
        "joint-sliding" => SensorKind::JointSliding,
        "stress" => SensorKind::Stress,
        _ => SensorKind::Displacement(match direction?.value {
            "horizontal" => Direction::Horizontal,
            "lateral" => Direction::Lateral,
            _ => Direction::Vertical,
        }),
    };
    let face = if maybe(table, "face", face)? == Some("extrados") { Face::Extrados } else { Face::Intrados };
    let name = name?;
    let proper =
        !name.value.trim().is_empty() && !name.value.contains([',', '"']) && !name.value.contains(char::is_control);
    if !proper {
        findings.error(
            "B657",
            name.range,
            "this is not a valid name for a channel",
            "it heads a column of channels.csv",
            "write one or more words, without commas, quotes and line ends",
        );
        return None;
    }
    let sensor = Sensor { name: name.value.trim().to_owned(), kind, place: place?, face };
    stone(table, &sensor, spans?, findings).then_some(sensor)
}

/// Where the sensor sits: one of three ways to say it.
fn place(table: &Table<'_>, layout: Option<&Layout>, findings: &mut Findings) -> Option<Place> {
    let number = table.count("span", findings);
    let word = table.word("place", findings);
    let at = share(table, layout, findings);
    let (x, y) = (table.quantity("x", findings), table.quantity("y", findings));
    let by_point = table.has("x") || table.has("y");
    if table.has("place") && (table.has("at") || by_point) {
        exclude(table, "place", if by_point { "`x` and `y`" } else { "`at`" }, findings);
        return None;
    }
    if table.has("at") && by_point {
        exclude(table, "at", "`x` and `y`", findings);
        return None;
    }
    if table.has("span") && !table.has("place") {
        exclude(table, "span", "`at` (or `x` and `y`)", findings);
        return None;
    }
    if by_point {
        for key in ["x", "y"].into_iter().filter(|key| !table.has(key)) {
            need(table, key, findings);
        }
        return Some(Place::Point([x?.value, y?.value]));
    }
    let layout = layout?;
    if table.has("at") {
        let at = at?.value;
        let span = layout.spans.iter().position(|&(start, end)| (start..=end).contains(&at))?;
        let (start, end) = layout.spans[span];
        return Some(Place::Span { span, share: (at - start) / (end - start) });
    }
    if !table.has("place") {
        need(table, "place", findings);
        return None;
    }
    let word = word?;
    let count = layout.spans.len();
    let span = maybe(table, "span", number)?.map_or(0, |number| number as usize - 1);
    if span >= count {
        findings.error(
            "B656",
            table.place("span"),
            "there is no such span",
            format!("the bridge has {count}"),
            format!("name a span from 1 to {count}, counted from the left"),
        );
        return None;
    }
    let share = match (word.value, span == 0, span + 1 == count) {
        ("crown", ..) => Some(0.5),
        ("left-springing", ..) | ("abutment-springing", true, false) | ("pier-springing", false, true) => Some(0.0),
        ("right-springing", ..) | ("abutment-springing", false, true) | ("pier-springing", true, false) => Some(1.0),
        _ => None,
    };
    if share.is_none() {
        let both = if count == 1 { "both springings rest on abutments" } else { "both springings rest on piers" };
        findings.error(
            "B656",
            word.range,
            format!("span {} has not one \"{}\"", span + 1, word.value),
            both,
            "write \"left-springing\" or \"right-springing\"",
        );
    }
    Some(Place::Span { span, share: share? })
}

/// A strain gauge sits on one stone: at the intrados that is checked here, elsewhere with the mesh.
fn stone(table: &Table<'_>, sensor: &Sensor, spans: &[PlacedSpan], findings: &mut Findings) -> bool {
    let (SensorKind::Strain { gauge_length }, Place::Span { span, .. }) = (sensor.kind, sensor.place) else {
        return true;
    };
    if sensor.face == Face::Extrados {
        return true;
    }
    let Some(span) = spans.get(span).map(|placed| &placed.span) else { return true };
    let Ok(intrados) = Intrados::new(&span.profile, span.span, span.rise) else { return true };
    let Some(count) = span.rings.first().map(|ring| ring.voussoirs) else { return true };
    let stone = intrados.length() / count as f64;
    if gauge_length <= stone {
        return true;
    }
    findings
        .error(
            "B656",
            table.place("gauge_length"),
            format!("a gauge of {:.0} mm is longer than its voussoir", 1e3 * gauge_length),
            format!("voussoirs are {:.0} mm long at the intrados", 1e3 * stone),
            "give a shorter `gauge_length`, or fewer voussoirs; a gauge across a joint measures its opening",
        )
        .because(
            "strain measured across a joint is mostly movement of its two voussoirs (the railway paper, section 3.2)",
        );
    false
}
