//! What stands at the edges of the road, and whether it fits the width.

use crate::card::Section;
use crate::findings::Findings;
use crate::model::{Kerb, Parapet};
use crate::tree::Table;

pub(super) static PARAPET: Section = Section {
    path: "parapet",
    doc: "Parapets, one at each edge of the barrel. Drawings show them and the report weighs them beside the dead loads; they stand on the edges, and no \
          analysis loads the arch with them.",
    fields: Parapet::CARDS,
};

pub(super) static KERB: Section = Section {
    path: "kerb",
    doc: "Kerbs, one at each edge of the barrel, with a footway or a verge raised behind them. Drawn and weighed as parapets are; where vehicles may stand \
          is said in [carriageway].",
    fields: Kerb::CARDS,
};

/// Parapets and kerbs; none inside where the file has none.
pub(crate) fn edges(
    file: &Table<'_>,
    width: Option<f64>,
    findings: &mut Findings,
) -> Option<(Option<Parapet>, Option<Kerb>)> {
    let half = width.map_or(f64::INFINITY, |width| 0.5 * width);
    let fits = |table: &Table<'_>, key: &str, reach: f64, findings: &mut Findings| {
        if reach >= half {
            findings.error(
                "B213",
                table.place(key),
                "both edges of the bridge leave no road between them",
                format!("{reach} m from each edge, and the barrel is {} m wide", 2.0 * half),
                "give the thickness of one parapet, and distances from the edge of the barrel",
            );
        }
    };
    let parapet = file.optional("parapet", findings, |table, findings| {
        let found = Parapet::of(table, findings)?;
        fits(table, "thickness", found.thickness, findings);
        Some(found)
    });
    let kerb = file.optional("kerb", findings, |table, findings| {
        let found = Kerb::of(table, findings)?;
        fits(table, "distance", found.distance, findings);
        Some(found)
    });
    Some((parapet?, kerb?))
}
