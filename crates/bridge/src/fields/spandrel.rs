//! What is hollow between the outer spandrel walls: internal walls, and voids over piers and haunches.

use crate::card::Section;
use crate::cards::*;
use crate::findings::Findings;
use crate::model::{InternalWalls, Void};
use crate::tree::Table;
use crate::values::of_keys;

pub(super) static INTERNAL_WALLS: Section = Section {
    path: "internal_walls",
    doc: "Internal spandrel walls: walls along the bridge between the outer ones, up to a level, with voids or fill between them. In a plane model \
          they are weight with their mean density over the width, docs/theory/spandrels.md.",
    fields: Written::CARDS,
};

of_keys! {
    /// What a table says of internal walls.
    struct Written {
        thickness: f64 = length("thickness of all of them together across the bridge", "1.4 m").positive_up_to(100.0),
        height: f64 = length("level of their tops above the springings", "2.4 m").positive_up_to(200.0),
        density: f64 = density("mass density of the walls", "2100 kg/m^3").positive(),
        between_density: f64 = density("mass density of what lies between them; 0 for voids", "0 kg/m^3")
            .at_least(0.0)
            .default("0 kg/m^3"),
    }
}

pub(super) static VOID: Section = Section {
    path: "void",
    doc: "A void above the extrados: a relieving arch over a pier or a haunch. Nothing in it weighs; what lies above its roof, and loads that \
          would disperse into it, are carried to two places beside it as by a beam, docs/theory/spandrels.md.",
    fields: &[
        length("from", "left end, from the left springing of the first span", "9.6 m").between(-200.0, 20_000.0),
        length("to", "right end", "11.4 m").between(-200.0, 20_000.0),
        length(
            "floor",
            "level of its floor above the left springing of the first span; below the extrados it lies on this",
            "1.0 m",
        )
        .between(-200.0, 200.0),
        length("roof", "level of its roof, above the same springing", "2.6 m").between(-200.0, 200.0),
        lengths("carried_to", "the two places that carry its roof, one on each side of it", "[\"9.4 m\", \"11.6 m\"]")
            .between(-200.0, 20_000.0)
            .optional("its two ends"),
    ],
};

pub(crate) fn internal_walls(table: &Table<'_>, width: Option<f64>, findings: &mut Findings) -> Option<InternalWalls> {
    let Written { thickness, height, density, between_density } = Written::of(table, findings)?;
    let width = width?;
    if thickness > width {
        return findings.refuse(
            "B232",
            table.place("thickness"),
            "the internal walls are thicker than the bridge is wide",
            format!("[bridge] width is {width} m"),
            "give the thickness of all internal walls together, without the outer ones",
        );
    }
    let share = thickness / width;
    Some(InternalWalls { height, density: share * density + (1.0 - share) * between_density, share })
}

pub(crate) fn voids(file: &Table<'_>, findings: &mut Findings) -> Option<Vec<Void>> {
    let mut placed = file.all("void", findings, |table, findings| Some((void(table, findings)?, table.range)))?;
    placed.sort_by(|a, b| a.0.range[0].total_cmp(&b.0.range[0]));
    for pair in placed.windows(2) {
        let ([_, end], [start, _]) = (pair[0].0.range, pair[1].0.range);
        if start < end {
            return findings.refuse(
                "B231",
                pair[1].1,
                "two voids lie over one another",
                format!("another one ends at {end:.3} m"),
                "write one void for what is hollow over one place, from its floor to the roof that carries the fill",
            );
        }
    }
    Some(placed.into_iter().map(|(void, _)| void).collect())
}

fn void(table: &Table<'_>, findings: &mut Findings) -> Option<Void> {
    let [from, to, floor, roof] = ["from", "to", "floor", "roof"].map(|key| table.read::<f64>(key, findings));
    let carried: Option<Option<Vec<f64>>> = table.read("carried_to", findings);
    let (from, to, floor, roof) = (from?, to?, floor?, roof?);
    let carried = carried?.unwrap_or_else(|| vec![from, to]);
    let mut wrong = |key: &str, message: &str, label: String, help: &str| {
        findings.refuse("B231", table.place(key), message, label, help)
    };
    if !(from < to) {
        return wrong(
            "to",
            "a void ends before it begins",
            format!("it begins at {from} m"),
            "give `from` on the left and `to` on the right",
        );
    }
    if !(floor < roof) {
        return wrong(
            "roof",
            "the roof of a void lies below its floor",
            format!("the floor is at {floor} m"),
            "give both above the same springing",
        );
    }
    match carried[..] {
        [left, right] if left <= from && right >= to => {
            Some(Void { range: [from, to], levels: [floor, roof], carried_to: [left, right] })
        }
        _ => wrong(
            "carried_to",
            "the roof of a void is carried by one place on each side of it",
            format!("one at {from} m or left of it, one at {to} m or right of it"),
            "write [\"… m\", \"… m\"]: where the walls or haunches stand that carry it",
        ),
    }
}
