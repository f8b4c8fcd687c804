//! Materials of the library: what is usual of each, between which ends, and where that is from. Values are texts with units as a bridge
//! file has them.

use serde::{Deserialize, Serialize};

/// A material of the library.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Its name in commands.
    pub code: String,
    /// Its name for readers.
    pub title: String,
    /// Tables of a bridge file that it may fill.
    pub tables: Vec<String>,
    /// What is known of it, one entry a key.
    pub values: Vec<MaterialValue>,
}

/// A value of a material.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct MaterialValue {
    /// Key of the table.
    pub key: String,
    /// The weak or light end.
    pub least: String,
    /// What an assessment without measurements takes.
    pub usual: String,
    /// The strong or heavy end.
    pub most: String,
    /// Where the three are from.
    pub source: MaterialSource,
}

/// Where the numbers of a material are from.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct MaterialSource {
    /// Document and clause or table.
    pub text: String,
    /// Its year or edition.
    pub date: String,
    /// How sure the numbers are.
    pub confidence: Confidence,
    /// What else a reader should know.
    #[serde(default)]
    pub note: String,
}

/// How sure the numbers of a material are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Confidence {
    /// Printed in the source.
    Read,
    /// Remembered from the source: confirm it there before a verdict rests on it.
    Recalled,
    /// An engineer's choice.
    Assumed,
}

impl Confidence {
    /// The word of the file.
    pub fn word(self) -> &'static str {
        match self {
            Confidence::Read => "read",
            Confidence::Recalled => "recalled",
            Confidence::Assumed => "assumed",
        }
    }
}

impl Material {
    /// Whether it may fill a table.
    pub fn fills(&self, table: &str) -> bool {
        self.tables.iter().any(|one| one == table)
    }
}

impl MaterialValue {
    /// The remark that stands beside the value in a bridge file: that it is not measured, between which ends it lies, and where it is from.
    pub fn remark(&self, material: &Material) -> String {
        let MaterialSource { text, date, confidence, .. } = &self.source;
        format!(
            "not measured: library, {}, {} to {}; {}: {text}, {date}",
            material.code,
            self.least,
            self.most,
            confidence.word()
        )
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    material: Vec<Material>,
}

/// The text of the file.
pub const MATERIALS: &str = include_str!("../data/materials.toml");

/// Every material of the library; a test reads them, so that none is missing where the program runs.
pub fn materials() -> Vec<Material> {
    toml::from_str::<File>(MATERIALS).map_or_else(|_| Vec::new(), |file| file.material)
}
