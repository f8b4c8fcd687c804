//! The report's own data: identification, revisions, signatures, inspection.

use crate::card::Section;
use crate::cards::*;
use crate::document::{Inspection, ReportDocument, Revision};
use crate::findings::Findings;
use crate::tree::Table;
use crate::values::read;

pub(super) static DOCUMENT: Section = Section {
    path: "document",
    doc: "Identification, revisions and signatures of the report of `extrados assess`. No analysis reads it.",
    fields: &[
        text("structure_number", "number of the structure in the owner's list", "ABC1/0123").optional("left blank"),
        text("route", "line or road that the bridge carries", "Settle to Carlisle, up and down main")
            .optional("left blank"),
        text("location", "mileage, chainage, grid reference", "12 m 34 ch, SD 765 795").optional("left blank"),
        text("owner", "who owns the bridge", "County Council").optional("left blank"),
        text("purpose", "what the assessment is for", "quantitative assessment, level 1").optional("left blank"),
        text("number", "number of the document", "ABC1-0123-CAL-001").optional("left blank"),
        text("prepared_by", "who prepared the assessment", "A. Engineer").optional("left blank to sign"),
        text("checked_by", "who checks it", "B. Checker").optional("left blank to sign"),
        text("approved_by", "who approves it", "C. Approver").optional("left blank to sign"),
        text("check_category", "category of the check, as the owner's procedure names it", "II").optional("left blank"),
        tables("revision", &REVISION, "Versions of the document, the newest last.")
            .at_most(100.0)
            .optional("the document has no revisions"),
        values(
            "confirm",
            "what the assessor wants confirmed on site, beside what the results themselves ask",
            "[\"depth of backing over the pier\"]",
        )
        .optional("only what the results ask"),
        tables("inspection", &INSPECTION, "What inspections found.").at_most(200.0).optional("none is reported"),
    ],
};

static REVISION: Section = Section {
    path: "document.revision",
    doc: "A version of the document.",
    fields: &[
        text("revision", "letter or number", "P02"),
        text("date", "its day", "2026-03-14"),
        text("change", "what changed", "ring thickness measured by coring"),
    ],
};

static INSPECTION: Section = Section {
    path: "document.inspection",
    doc: "What an inspection found.",
    fields: &[
        text("date", "its day", "2025-09-02").optional("left blank"),
        text("part", "which part of the bridge", "span 1, barrel, east edge"),
        text("finding", "what was found", "mortar lost to 60 mm over 2 m"),
        text("photograph", "a photograph (.jpg, .png), relative to the bridge file", "photo-12.jpg").optional("none"),
    ],
};

/// The document that the file describes; none where it says nothing.
pub(crate) fn document(file: &Table<'_>, findings: &mut Findings) -> Option<ReportDocument> {
    if !file.has("document") {
        return None;
    }
    let table = file.table("document", findings)?;
    let bare = |word: String| word.trim_matches(['"', '\'']).to_owned();
    let confirm: Option<Vec<String>> = table.read("confirm", findings);
    let revisions =
        table.all("revision", findings, |table, findings| read!(table, findings, Revision { revision, date, change }));
    let inspections = table.all("inspection", findings, |table, findings| {
        read!(table, findings, Inspection { date, part, finding, photograph })
    });
    read!(
        &table,
        findings,
        ReportDocument {
            structure_number,
            route,
            location,
            owner,
            purpose,
            number,
            prepared_by,
            checked_by,
            approved_by,
            check_category;
            revisions: revisions?,
            confirm: confirm?.into_iter().map(bare).collect(),
            inspections: inspections?,
        }
    )
}
