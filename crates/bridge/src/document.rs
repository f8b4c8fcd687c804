//! What identifies an assessment and who signs for it: the report's own data, no part of the bridge.

use crate::card::{Section, joined};
use crate::cards::*;
use crate::findings::Findings;
use crate::tree::Table;
use crate::values::{bare_words, of_keys};

of_keys! {
    /// The document.
    #[derive(Debug, Clone, PartialEq, Default)]
    pub struct ReportDocument {
        pub structure_number: Option<String> =
            text("number of the structure in the owner's list", "ABC1/0123").optional("left blank"),
        pub route: Option<String> =
            text("line or road that the bridge carries", "Settle to Carlisle, up and down main").optional("left blank"),
        pub location: Option<String> =
            text("mileage, chainage, grid reference", "12 m 34 ch, SD 765 795").optional("left blank"),
        pub latitude: Option<f64> = number("geographic latitude in degrees (WGS 84), north positive, for the map of a folder of bridges", "54.0689")
            .between(-90.0, 90.0)
            .optional("the bridge has no place on the map"),
        pub longitude: Option<f64> = number("geographic longitude in degrees (WGS 84), east positive", "-2.2836")
            .between(-180.0, 180.0)
            .optional("the bridge has no place on the map"),
        pub owner: Option<String> = text("who owns the bridge", "County Council").optional("left blank"),
        pub purpose: Option<String> =
            text("what the assessment is for", "quantitative assessment, level 1").optional("left blank"),
        pub number: Option<String> = text("number of the document", "ABC1-0123-CAL-001").optional("left blank"),
        pub prepared_by: Option<String> =
            text("who prepared the assessment", "A. Engineer").optional("left blank to sign"),
        pub checked_by: Option<String> = text("who checks it", "B. Checker").optional("left blank to sign"),
        pub approved_by: Option<String> = text("who approves it", "C. Approver").optional("left blank to sign"),
        pub check_category: Option<String> =
            text("category of the check, as the owner's procedure names it", "II").optional("left blank"),
    } and {
        /// Versions, the newest last.
        pub revisions: Vec<Revision> => revisions,
        /// What is to be confirmed on site.
        pub confirm: Vec<String> => confirm,
        /// What inspections found.
        pub inspections: Vec<Inspection> => inspections,
    }
}

of_keys! {
    /// A version of the document.
    #[derive(Debug, Clone, PartialEq, Eq)]
    pub struct Revision {
        pub revision: String = text("letter or number", "P02"),
        pub date: String = text("its day", "2026-03-14"),
        pub change: String = text("what changed", "ring thickness measured by coring"),
    }
}

of_keys! {
    /// What an inspection found.
    #[derive(Debug, Clone, PartialEq, Eq)]
    pub struct Inspection {
        pub date: Option<String> = text("its day", "2025-09-02").optional("left blank"),
        pub part: String = text("which part of the bridge", "span 1, barrel, east edge"),
        pub finding: String = text("what was found", "mortar lost to 60 mm over 2 m"),
        pub photograph: Option<String> =
            text("a photograph (.jpg, .png), relative to the bridge file", "photo-12.jpg").optional("none"),
    }
}

pub(crate) static DOCUMENT: Section = Section {
    path: "document",
    doc: "Identification, revisions and signatures of the report of `extrados assess`. No analysis reads it.",
    fields: &joined::<15>(&[
        ReportDocument::CARDS,
        &[
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
    ]),
};

static REVISION: Section =
    Section { path: "document.revision", doc: "A version of the document.", fields: Revision::CARDS };

static INSPECTION: Section =
    Section { path: "document.inspection", doc: "What an inspection found.", fields: Inspection::CARDS };

/// The document that the file describes; none where it says nothing.
pub(crate) fn document(file: &Table<'_>, findings: &mut Findings) -> Option<ReportDocument> {
    if !file.has("document") {
        return None;
    }
    let table = file.table("document", findings)?;
    let found = ReportDocument::of(&table, findings)?;
    let [given, missing] = match (found.latitude, found.longitude) {
        (Some(_), None) => ["latitude", "longitude"],
        (None, Some(_)) => ["longitude", "latitude"],
        _ => return Some(found),
    };
    let message = format!("`{given}` without `{missing}` is no place");
    findings.error(
        "B107",
        table.place(given),
        message,
        "both, in degrees",
        format!("write `{missing}` as well, or none of both"),
    );
    Some(found)
}

fn revisions(table: &Table<'_>, findings: &mut Findings) -> Option<Vec<Revision>> {
    table.all("revision", findings, Revision::of)
}

fn confirm(table: &Table<'_>, findings: &mut Findings) -> Option<Vec<String>> {
    bare_words(table, "confirm", findings)
}

fn inspections(table: &Table<'_>, findings: &mut Findings) -> Option<Vec<Inspection>> {
    table.all("inspection", findings, Inspection::of)
}
