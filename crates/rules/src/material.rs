//! Materials: what is usual of each, between which ends, and where that is from. Values are texts with units as a bridge file has them;
//! whoever reads bridge files converts them.

use crate::source::Source;
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
    pub source: Source,
}

impl MaterialValue {
    /// The remark that stands beside the value in a bridge file: that it is not measured, between which ends it lies, and where it is from.
    pub fn remark(&self, material: &Material) -> String {
        let Source { text, date, confidence, .. } = &self.source;
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_material_has_its_own_name_and_every_value_a_source() {
        let all = toml::from_str::<File>(MATERIALS).unwrap().material;
        assert!(all.len() >= 12);
        for (k, one) in all.iter().enumerate() {
            assert!(all[..k].iter().all(|other| other.code != one.code), "{}", one.code);
            assert!(!one.tables.is_empty() && !one.values.is_empty() && !one.title.is_empty(), "{}", one.code);
            for (k, value) in one.values.iter().enumerate() {
                assert!(one.values[..k].iter().all(|other| other.key != value.key), "{} {}", one.code, value.key);
                let Source { text, date, .. } = &value.source;
                assert!(text.len() > 8 && date.len() == 4, "{} {}", one.code, value.key);
                // A remark is one line of a bridge file.
                let remark = value.remark(one);
                assert!(!remark.contains(['\n', '#']) && remark.contains(value.source.confidence.word()), "{remark}");
            }
        }
    }

    /// Materials that the field tests are predicted with have the numbers of their priors; the modulus of sandstone alone is another, that of
    /// stones that were measured.
    #[test]
    fn materials_agree_with_the_priors_of_the_field_tests() {
        let priors: toml::Table = toml::from_str(include_str!("../../../validation/priors.toml")).unwrap();
        let same = [
            ("sandstone", &["masonry", "sandstone"][..]),
            ("brick-in-lime", &["masonry", "brick-in-lime"]),
            ("rubble", &["masonry", "rubble"]),
            ("old-joints", &["joint"]),
            ("old-fill", &["fill", "old"]),
            ("crushed-stone", &["fill", "crushed-stone"]),
            ("rubble-backing", &["backing_material"]),
        ];
        let all = materials();
        let mut compared = 0;
        for (code, path) in same {
            let table = path.iter().try_fold(&priors, |table, name| table.get(*name)?.as_table()).unwrap();
            for value in &all.iter().find(|one| one.code == code).unwrap().values {
                let Some(prior) = table.get(&value.key).and_then(toml::Value::as_table) else { continue };
                if (code, value.key.as_str()) != ("sandstone", "elastic_modulus") {
                    let theirs = ["least", "expected", "most"].map(|end| prior[end].as_str().unwrap());
                    assert_eq!([&value.least, &value.usual, &value.most], theirs, "{code} {}", value.key);
                    compared += 1;
                }
            }
        }
        assert!(compared >= 14, "{compared}");
    }
}
