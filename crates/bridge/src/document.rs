//! What identifies an assessment and who signs for it: the report's own data, no part of the bridge.

/// The document.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct ReportDocument {
    /// Number of the structure in the owner's list.
    pub structure_number: Option<String>,
    /// Line or road that it carries.
    pub route: Option<String>,
    /// Where it is: mileage, grid reference.
    pub location: Option<String>,
    /// Who owns it.
    pub owner: Option<String>,
    /// What the assessment is for.
    pub purpose: Option<String>,
    /// Number of the document.
    pub number: Option<String>,
    /// Who prepared it.
    pub prepared_by: Option<String>,
    /// Who checks it.
    pub checked_by: Option<String>,
    /// Who approves it.
    pub approved_by: Option<String>,
    /// Category of the check: "I", "II", "III".
    pub check_category: Option<String>,
    /// Versions, the newest last.
    pub revisions: Vec<Revision>,
    /// What is to be confirmed on site.
    pub confirm: Vec<String>,
    /// What inspections found.
    pub inspections: Vec<Inspection>,
}

/// A version of the document.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Revision {
    /// Its letter or number.
    pub revision: String,
    /// Its day.
    pub date: String,
    /// What changed.
    pub change: String,
}

/// What an inspection found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Inspection {
    /// Its day.
    pub date: Option<String>,
    /// Which part of the bridge.
    pub part: String,
    /// What was found.
    pub finding: String,
    /// A photograph, relative to the bridge file.
    pub photograph: Option<String>,
}
