//! A sensor: what it may measure and where, its card, and whether the bridge has such a place.

use crate::card::{Field, Kind, Section};
use crate::cards::*;
use crate::choice::choice;
use crate::fields::{loading::share, structure::PlacedSpan};
use crate::findings::Findings;
use crate::resolve::Layout;
use crate::tree::{At, Table};

/// A sensor.
#[derive(Debug, Clone, PartialEq)]
pub struct Sensor {
    /// Name of its channel.
    pub name: String,
    /// What it measures.
    pub kind: SensorKind,
    /// Where.
    pub place: SensorPosition,
    /// On which face of the ring.
    pub face: Face,
}

/// What a sensor measures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SensorKind {
    /// Displacement [m].
    Displacement(Direction),
    /// Mean strain of one stone along the ring over a gauge length [m]; tension positive. Never across a joint.
    Strain {
        /// Gauge length [m].
        gauge_length: f64,
    },
    /// Opening of a joint at a face [m]; apart is positive.
    JointOpening,
    /// Sliding of a joint at a face [m]; positive where the stone on the right moves outwards, from intrados to extrados.
    JointSliding,
    /// Stress along the ring [Pa]; tension positive.
    Stress,
}

choice! {
    /// Direction of a displacement.
    pub enum Direction {
        /// up is positive
        Vertical = "vertical",
        /// to the right is positive
        Horizontal = "horizontal",
        /// horizontal, away from the middle of its span is positive
        Lateral = "lateral",
    }
}

/// Where a sensor sits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SensorPosition {
    /// At a share of a span's length between its springings: 0 left, 0.5 crown, 1 right.
    Span {
        /// The span, counted from 0 on the left.
        span: usize,
        /// The share.
        share: f64,
    },
    /// At a point [m], from the left springing of the first span.
    Point([f64; 2]),
}

choice! {
    /// A face of the ring.
    pub enum Face {
        /// the lower face of the ring
        Intrados = "intrados",
        /// its upper face
        Extrados = "extrados",
    }
}

impl Default for Face {
    /// The face that gauges reach.
    fn default() -> Face {
        Face::Intrados
    }
}

choice! {
    /// What a sensor measures.
    enum Gauge {
        /// movement of a point
        Displacement = "displacement",
        /// mean strain of one voussoir along the ring over a gauge length; tension is positive
        Strain = "strain",
        /// how far a joint opens at a face; apart is positive
        JointOpening = "joint-opening",
        /// how far a joint slides; positive where its right side moves from intrados to extrados
        JointSliding = "joint-sliding",
        /// stress along the ring; tension is positive
        Stress = "stress",
    }
}

choice! {
    /// Places of a span that have a name.
    enum NamedPlace {
        /// the middle of the span
        Crown = "crown",
        /// the left springing of the span
        LeftSpringing = "left-springing",
        /// the right springing of the span
        RightSpringing = "right-springing",
        /// that springing of an end span which rests on a pier
        PierSpringing = "pier-springing",
        /// that springing of an end span which rests on an abutment
        AbutmentSpringing = "abutment-springing",
    }
}

pub(crate) static SENSOR: Section = Section {
    path: "sensor",
    doc: "A sensor: one channel of the record. Place it by `span` and `place`, by `at`, or by `x` and `y`.",
    fields: &[
        text("name", "name of the channel", "crown displacement"),
        word::<Gauge>("kind", "what it measures", "displacement"),
        word::<Direction>("direction", "direction of the movement, and its sign", "vertical")
            .only("kind", &[Gauge::Displacement.word()]),
        length("gauge_length", "length over which strain is measured, within one voussoir", "120 mm")
            .positive()
            .only("kind", &[Gauge::Strain.word()])
            .default("120 mm"),
        count("span", "which span, counted from 1 on the left", "1").between(1.0, 200.0).optional("the first"),
        word::<NamedPlace>("place", "position on the span, by name", "crown").optional("given by `at`, or `x` and `y`"),
        Field::new("at", Kind::Share, "position as a share of a span", "1/4 of span 1")
            .optional("given by `place`, or `x` and `y`"),
        length("x", "distance from the left springing of the first span", "3.0 m").optional("given by `place` or `at`"),
        length("y", "height above the left springing of the first span", "1.5 m").optional("given by `place` or `at`"),
        word::<Face>("face", "on which face of the ring", "intrados").default(Face::Intrados.word()),
    ],
};

/// Most channels of a record.
const MOST: usize = 1000;

/// The sensors of the file; none where it leaves them to the defaults.
pub(crate) fn sensors(
    file: &Table<'_>,
    spans: Option<&[PlacedSpan]>,
    layout: Option<&Layout>,
    findings: &mut Findings,
) -> Option<Vec<Sensor>> {
    let tables = file.tables("sensor", findings);
    if let Some(beyond) = tables.get(MOST) {
        return findings.refuse(
            "B657",
            beyond.range,
            format!("there are {} sensors", tables.len()),
            "a record has a thousand channels at most",
            "remove some",
        );
    }
    let list = file.all("sensor", findings, |table, findings| sensor(table, spans, layout, findings))?;
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
    let name: Option<At<String>> = table.read("name", findings);
    let gauge = table.read("kind", findings);
    let direction = table.read::<Option<Direction>>("direction", findings);
    let gauge_length = table.read("gauge_length", findings);
    let face = table.read("face", findings);
    let place = place(table, layout, findings);
    let kind = match gauge? {
        Gauge::Displacement => SensorKind::Displacement(direction??),
        Gauge::Strain => SensorKind::Strain { gauge_length: gauge_length? },
        Gauge::JointOpening => SensorKind::JointOpening,
        Gauge::JointSliding => SensorKind::JointSliding,
        Gauge::Stress => SensorKind::Stress,
    };
    let (face, name) = (face?, name?);
    let proper =
        !name.value.trim().is_empty() && !name.value.contains([',', '"']) && !name.value.contains(char::is_control);
    if !proper {
        return findings.refuse(
            "B657",
            name.range,
            "this is no name for a channel",
            "it heads a column of channels.csv",
            "write a word or some, without commas, quotes and line ends",
        );
    }
    let sensor = Sensor { name: name.value.trim().to_owned(), kind, place: place?, face };
    stone(table, &sensor, spans?, findings).then_some(sensor)
}

/// Where the sensor sits: one of three ways to say it.
fn place(table: &Table<'_>, layout: Option<&Layout>, findings: &mut Findings) -> Option<SensorPosition> {
    let number: Option<Option<usize>> = table.read("span", findings);
    let word: Option<Option<NamedPlace>> = table.read("place", findings);
    let at = share(table, layout, findings);
    let [x, y] = ["x", "y"].map(|key| table.read::<Option<f64>>(key, findings));
    let by_point = table.has("x") || table.has("y");
    if table.has("place") && (table.has("at") || by_point) {
        return table.exclude("place", if by_point { "`x` and `y`" } else { "`at`" }, findings);
    }
    if table.has("at") && by_point {
        return table.exclude("at", "`x` and `y`", findings);
    }
    if table.has("span") && !table.has("place") {
        return table.exclude("span", "`at` (or `x` and `y`)", findings);
    }
    if by_point {
        for key in ["x", "y"].into_iter().filter(|key| !table.has(key)) {
            table.need::<()>(key, findings);
        }
        return Some(SensorPosition::Point([x??, y??]));
    }
    let layout = layout?;
    if table.has("at") {
        let at = at?;
        let span = layout.spans.iter().position(|&(start, end)| (start..=end).contains(&at))?;
        let (start, end) = layout.spans[span];
        return Some(SensorPosition::Span { span, share: (at - start) / (end - start) });
    }
    if !table.has("place") {
        return table.need("place", findings);
    }
    let word = word??;
    let count = layout.spans.len();
    let span = number?.map_or(0, |number| number - 1);
    if span >= count {
        return findings.refuse(
            "B656",
            table.place("span"),
            "there is no such span",
            format!("the bridge has {count}"),
            format!("name a span from 1 to {count}, counted from the left"),
        );
    }
    let (first, last) = (span == 0, span + 1 == count);
    let share = match word {
        NamedPlace::Crown => Some(0.5),
        NamedPlace::LeftSpringing => Some(0.0),
        NamedPlace::RightSpringing => Some(1.0),
        NamedPlace::AbutmentSpringing if first != last => Some(if first { 0.0 } else { 1.0 }),
        NamedPlace::PierSpringing if first != last => Some(if first { 1.0 } else { 0.0 }),
        NamedPlace::AbutmentSpringing | NamedPlace::PierSpringing => None,
    };
    let Some(share) = share else {
        let both = if count == 1 { "both springings rest on abutments" } else { "both springings rest on piers" };
        let message = format!("span {} has not one \"{}\"", span + 1, word.word());
        let help = "write \"left-springing\" or \"right-springing\"";
        return findings.refuse("B656", table.place("place"), message, both, help);
    };
    Some(SensorPosition::Span { span, share })
}

/// A strain gauge sits on one stone: at the intrados that is checked here, elsewhere with the mesh.
fn stone(table: &Table<'_>, sensor: &Sensor, spans: &[PlacedSpan], findings: &mut Findings) -> bool {
    let (SensorKind::Strain { gauge_length }, SensorPosition::Span { span, .. }) = (sensor.kind, sensor.place) else {
        return true;
    };
    if sensor.face == Face::Extrados {
        return true;
    }
    let Some(span) = spans.get(span).map(|placed| &placed.span) else { return true };
    let Ok(intrados) = span.intrados() else { return true };
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

/// Gauge length of the railway paper's strain gauges [m], section 3.2.
pub const GAUGE_LENGTH: f64 = 0.120;

/// The channels of the railway paper's Table 1, on the first span: vertical displacement of the crown, lateral displacement of
/// the springings, strain on the stones at the same three places. The first span's left springing rests on the abutment,
/// its right springing on a pier where there is another span.
pub fn default_sensors(spans: usize) -> Vec<Sensor> {
    let right = if spans > 1 { "pier springing" } else { "right springing" };
    let left = if spans > 1 { "abutment springing" } else { "left springing" };
    let places = [("crown", 0.5), (right, 1.0), (left, 0.0)];
    let sensor = |name: String, kind, share| Sensor {
        name,
        kind,
        place: SensorPosition::Span { span: 0, share },
        face: Face::Intrados,
    };
    let displacements = places.into_iter().map(|(name, share)| {
        let direction = if share == 0.5 { Direction::Vertical } else { Direction::Lateral };
        sensor(format!("{name} displacement"), SensorKind::Displacement(direction), share)
    });
    let strains = places.into_iter().map(|(name, share)| {
        sensor(format!("{name} strain"), SensorKind::Strain { gauge_length: GAUGE_LENGTH }, share)
    });
    displacements.chain(strains).collect()
}
