//! What the rings stand on: piers with their footings, abutments.

use crate::card::{Field, Section, each_optional, joined};
use crate::cards::*;
use crate::findings::Findings;
use crate::model::{Abutment, AbutmentBody, AbutmentKind, Cutwater, Cutwaters, Footing, Pier};
use crate::tree::Table;
use crate::values::{of_keys, read};

pub(super) static PIER: Section = Section {
    path: "pier",
    doc: "A pier between two spans. Widths are those along the road; what it measures across the bridge comes into a plane model as weight \
          per metre of the barrel, docs/theory/supports.md.",
    fields: &[
        length("width", "width at the top, between the springings of its two spans", "1.20 m").positive(),
        length("base_width", "width at the bottom, above the footing", "1.60 m")
            .positive()
            .optional("as wide as the top, or given by the batter of its faces"),
        number("left_batter", "how far the left face moves outwards per unit of depth: 1 in 24 is 0.0417", "0.0417")
            .between(0.0, 1.0)
            .optional("plumb, or as `base_width` says"),
        number("right_batter", "the same for the right face", "0.0417")
            .between(0.0, 1.0)
            .optional("plumb, or as `base_width` says"),
        length(
            "height",
            "height from the bottom to the springings, the lower one where they differ; footings lie below",
            "4.0 m",
        )
        .positive(),
        count("courses", "number of courses of blocks", "8").between(1.0, 1000.0),
        length("step", "level of the springing of the span on its right above that of the span on its left", "0.10 m")
            .between(-50.0, 50.0)
            .default("0 m"),
        length("across", "width across the bridge at the top, without cutwaters", "9.0 m")
            .positive_up_to(200.0)
            .optional("as wide as the barrel"),
        length("base_across", "the same at the bottom", "9.6 m").positive_up_to(200.0).optional("as at the top"),
        length("cutwater_length", "how far each cutwater reaches beyond that width, over the whole height", "1.2 m")
            .positive_up_to(50.0)
            .optional("no cutwaters"),
        word::<Cutwater>("cutwater_shape", "form of the cutwaters in plan", "pointed")
            .default(Cutwater::Pointed.word()),
        count("cutwaters", "how many: one upstream, or both", "2").between(1.0, 2.0).default("2"),
        tables("footing", &FOOTING, "Steps of the footing, from the pier down.")
            .at_most(50.0)
            .optional("the pier stands on the ground with its bottom"),
    ],
};

pub(super) static FOOTING: Section = Section {
    path: "pier.footing",
    doc: "A step of a footing under a pier, centred under its bottom: a course of its own that can slide and tilt.",
    fields: Footing::CARDS,
};

pub(super) static ABUTMENT: Section = Section {
    path: "abutment",
    doc: "Both abutments: what holds the outer springings. Fixed, their size is used for drawings and limits what can rest on them; as blocks \
          they stand on the ground by friction, with the soil behind them, and can slide and overturn: docs/theory/supports.md.",
    fields: &joined::<10>(&[
        &[
            Written::CARDS[0].default("2 m"),
            Written::CARDS[1].default("2 m"),
            Written::CARDS[2].default(AbutmentKind::Fixed.word()),
        ],
        Written::CARDS.split_at(3).1,
        &[
            table("left", &ABUTMENT_LEFT, "Where the left abutment differs.").optional("like the other"),
            table("right", &ABUTMENT_RIGHT, "Where the right abutment differs.").optional("like the other"),
        ],
    ]),
};

/// Those of one side, which are as for both where they are left out.
const SIDE: &[Field] = &each_optional::<8>(Written::CARDS, "as [abutment] says");

static ABUTMENT_LEFT: Section =
    Section { path: "abutment.left", doc: "The left abutment, where it differs.", fields: SIDE };
static ABUTMENT_RIGHT: Section =
    Section { path: "abutment.right", doc: "The right abutment, where it differs.", fields: SIDE };

/// A pier as written; how many there must be is for the geometry. The width is that of the barrel [m].
pub(crate) fn pier(table: &Table<'_>, barrel: Option<f64>, findings: &mut Findings) -> Option<Pier> {
    let batters = ["left_batter", "right_batter"].map(|key| table.read::<Option<f64>>(key, findings));
    let [base_width, across, base_across, length] =
        ["base_width", "across", "base_across", "cutwater_length"].map(|key| table.read::<Option<f64>>(key, findings));
    let shape: Option<Cutwater> = table.read("cutwater_shape", findings);
    let ends: Option<u64> = table.read("cutwaters", findings);
    let footings = table.all("footing", findings, Footing::of);
    let pier = read!(table, findings, Pier {
        width, height, courses, step;
        base_width: width, base_offset: 0.0, across: None, cutwaters: None, footings: Vec::new()
    })?;
    let [left, right] = batters;
    let (left, right) = (left?, right?);
    let (base_width, base_offset) = match (base_width?, left.or(right)) {
        (Some(_), Some(_)) => return table.exclude("base_width", "the batter of a face", findings),
        (Some(width), None) => (width, 0.0),
        (None, _) => {
            let [left, right] = [left, right].map(|batter| batter.unwrap_or(0.0) * pier.height);
            (pier.width + left + right, 0.5 * (right - left))
        }
    };
    let (length, shape, ends) = (length?, shape?, ends?);
    let footings = footings?;
    let (across, base_across) = (across?, base_across?);
    let top = across.or(barrel);
    let cutwaters = length.zip(top).map(|(length, between)| Cutwaters { shape, length, ends: ends as usize, between });
    let reach = cutwaters.map_or(0.0, Cutwaters::mean);
    let is_plain = across.is_none() && base_across.is_none() && reach == 0.0;
    let wide = match (is_plain, top) {
        (false, Some(top)) => Some([top + reach, base_across.unwrap_or(top) + reach]),
        _ => None,
    };
    Some(Pier { base_width, base_offset, across: wide, cutwaters, footings, ..pier })
}

pub(crate) fn abutments(file: &Table<'_>, findings: &mut Findings) -> Option<[Abutment; 2]> {
    file.part("abutment", findings, |both, findings| {
        // What is wrong with the table of both is said once, here: its sides look it up without a word.
        let fits = Written::of(both, findings);
        let mut missing: Vec<&str> = Vec::new();
        let sides = ["left", "right"]
            .map(|key| both.part(key, findings, |side, findings| abutment(&side.over(both), &mut missing, findings)));
        missing.sort_unstable();
        missing.dedup();
        for key in missing {
            both.need::<()>(key, findings);
        }
        fits.and(Some([sides[0]?, sides[1]?]))
    })
}

of_keys! {
    /// What a table says of an abutment: its size, whether it can move, and what it needs then.
    struct Written {
        top_width: f64 = length("length of the upper face behind the springing", "2.0 m").positive(),
        height: f64 = length("height of the block, from its springing down", "2.0 m").positive(),
        kind ("as"): AbutmentKind = word::<AbutmentKind>("whether it is fixed or can move", "blocks"),
        base_width: Option<f64> = length("as blocks: width of the bottom, from the plumb front face back", "3.0 m")
            .positive_up_to(200.0)
            .optional("as wide as the top: the back is plumb"),
        courses: Option<usize> = count("as blocks: number of courses", "4").between(1.0, 1000.0).optional("one block"),
        friction ("ground_friction_angle"): Option<f64> =
            angle("as blocks: angle of friction between the bottom and the ground", "30 deg")
                .between(0.0, 1.5)
                .optional("needed as blocks"),
        coefficient ("earth_coefficient"): Option<f64> = number(
            "as blocks: horizontal over vertical stress of the soil behind it; 1 - sin phi at rest, (1 - sin phi) / (1 + sin phi) active",
            "0.33",
        )
        .between(0.0, 1.0)
        .optional("needed as blocks; 0 where nothing may be counted on"),
        earth_density: Option<f64> = density("as blocks: mass density of that soil", "1900 kg/m^3")
            .positive()
            .optional("as the lowest layer of the cover"),
    }
}

/// One abutment; notes which keys it misses.
fn abutment(table: &Table<'_>, missing: &mut Vec<&'static str>, findings: &mut Findings) -> Option<Abutment> {
    let written = Written::of(table, findings)?;
    let Written { top_width, height, .. } = written;
    if written.kind == AbutmentKind::Fixed {
        return Some(Abutment { top_width, height, body: None });
    }
    let needed = [("ground_friction_angle", written.friction), ("earth_coefficient", written.coefficient)];
    missing.extend(needed.iter().filter(|(_, value)| value.is_none()).map(|(key, _)| *key));
    let body = AbutmentBody {
        base_width: written.base_width,
        courses: written.courses.unwrap_or(1),
        ground_friction_angle: written.friction?,
        earth_coefficient: written.coefficient?,
        earth_density: written.earth_density,
    };
    Some(Abutment { top_width, height, body: Some(body) })
}
