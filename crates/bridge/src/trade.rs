//! Words that people write for keys: the trade's own names, symbols, and keys where another program has them.

/// What a word means in a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Meant {
    /// A key of the same table.
    Key(&'static str),
    /// Something that is written elsewhere or otherwise: how.
    Elsewhere(&'static str),
}

use Meant::{Elsewhere, Key};

/// Words for a key of the table that has it, in whichever table they stand.
const SYNONYMS: [(&str, &[&str]); 15] = [
    ("density", &["unit_weight", "weight", "specific_weight", "bulk_density", "gamma", "rho"]),
    ("friction_angle", &["phi", "angle_of_friction", "friction", "internal_friction_angle"]),
    ("cohesion", &["c"]),
    ("elastic_modulus", &["e", "e_modulus", "young", "youngs_modulus", "young_modulus", "modulus"]),
    ("poisson_ratio", &["nu", "poisson"]),
    ("compressive_strength", &["strength", "crushing_strength", "fc", "f_c", "fk", "f_k", "sigma_c"]),
    ("thickness", &["ring_thickness", "arch_thickness", "barrel_thickness", "layer_thickness", "depth", "t"]),
    ("voussoirs", &["blocks", "number_of_blocks", "segments", "stones", "number_of_voussoirs"]),
    ("profile", &["shape", "arch_shape", "geometry", "type"]),
    ("span", &["clear_span", "square_span_length", "opening"]),
    ("rise", &["rise_at_crown", "rise_at_midspan", "crown_rise"]),
    ("at", &["place", "location", "x", "where"]),
    ("height", &["level", "backing_height"]),
    ("vehicles", &["vehicle", "train", "trains", "load_model"]),
    ("rule", &["code", "standard", "norm"]),
];

/// Words that mean something else in a table, or belong to another one; a table without a name is the file.
const ELSEWHERE: [(&str, &[&str], &str); 21] = [
    (
        "",
        &["arch", "arches", "barrel", "ring", "rings", "geometry"],
        "rings are described by [[span]], several rings by [[span.ring]]",
    ),
    (
        "",
        &["surfacing", "surface", "ballast", "soil", "layer", "layers"],
        "what lies above the ring is [[cover]], a table for each layer",
    ),
    ("", &["vehicles", "traffic", "train_load"], "vehicles are named in [sweep] vehicles = [\"…\"]"),
    ("", &["material", "materials"], "materials stand in [masonry], [joint], [[cover]] and [backing]"),
    ("", &["settings", "options", "solver"], "how to analyse is said in [analysis]"),
    (
        "",
        &["spandrel", "spandrels", "walls"],
        "walls that stand on the ring are [spandrel_wall]; `extrados explain spandrel`",
    ),
    ("", &["parapets"], "parapets at both edges are one table, [parapet]"),
    ("", &["kerbs", "footway", "footpath", "verge"], "a kerb and what is raised behind it are one table, [kerb]"),
    ("bridge", &["number", "structure_number", "id"], "write it as structure_number in [document]"),
    ("bridge", &["skew"], "write it as skew in each [[span]]"),
    ("bridge", &["lanes", "tracks"], "write lanes in [carriageway]"),
    ("span", &["backing", "backing_height"], "backing is a table of its own: [backing] height = \"…\""),
    (
        "span",
        &["cover", "fill", "fill_depth", "depth_of_fill", "cover_depth"],
        "cover is a table of its own: [[cover]] thickness = \"…\"",
    ),
    (
        "span",
        &["rings", "number_of_rings", "n_rings"],
        "write a [[span.ring]] with thickness and voussoirs for each ring, the lowest first",
    ),
    ("span", &["radius", "r"], "give span and rise: the radius of a segment is (span²/4 + rise²)/(2 rise)"),
    ("masonry", &["tensile_strength", "tension", "ft"], "joints open, not stones: write tensile_strength in [joint]"),
    (
        "joint",
        &["mu", "coefficient_of_friction", "friction_coefficient"],
        "write friction_angle, the arctangent of the coefficient: 0.6 is \"31 deg\"",
    ),
    (
        "fill",
        &["depth", "height", "thickness", "cover"],
        "[fill] has the soil; its depth above the crown is [[cover]] thickness = \"…\"",
    ),
    (
        "fill",
        &["unit_weight", "weight"],
        "weight of fill is density of its [[cover]] layer; [fill] density only where `respond` takes another",
    ),
    (
        "load",
        &["vehicle", "vehicles"],
        "vehicles of the library move in [sweep] vehicles = [\"…\"]; a load has axle_force, force or pressure",
    ),
    ("analysis", &["rule", "code", "standard", "vehicles", "vehicle"], "rule and vehicles stand in [sweep]"),
];

/// What a word means that is no key of a table, where `knows` says which keys the table has.
pub(crate) fn meant(table: &str, word: &str, knows: impl Fn(&str) -> bool) -> Option<Meant> {
    let word = word.to_lowercase().replace(['-', ' '], "_");
    let elsewhere = ELSEWHERE.iter().find(|(of, words, _)| *of == table && words.contains(&word.as_str()));
    let synonym = || SYNONYMS.iter().find(|(key, words)| words.contains(&word.as_str()) && knows(key));
    elsewhere.map(|(.., how)| Elsewhere(how)).or_else(|| synonym().map(|(key, _)| Key(key)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fields::{FILE, sections_of};

    #[test]
    fn a_word_of_the_trade_leads_to_a_key_that_there_is() {
        let sections = sections_of(&FILE);
        let of = |path: &str| sections.iter().find(|section| section.path == path).copied().unwrap_or(&FILE);
        for (key, words) in SYNONYMS {
            assert!(sections.iter().any(|section| section.field(key).is_some()), "{key}");
            let twice = words.iter().find(|word| SYNONYMS.iter().filter(|(_, words)| words.contains(word)).count() > 1);
            assert_eq!(twice, None, "{key}");
        }
        for (table, words, how) in ELSEWHERE {
            assert_eq!(of(table).path, table, "{how}");
            let known = words.iter().find(|word| of(table).field(word).is_some());
            assert_eq!(known, None, "[{table}] knows it: {how}");
        }
        let masonry = |word| meant("masonry", word, |key| of("masonry").field(key).is_some());
        assert_eq!(masonry("Unit weight"), Some(Key("density")));
        assert_eq!(masonry("phi"), None, "masonry has no angle of friction");
        assert!(matches!(masonry("tensile-strength"), Some(Elsewhere(how)) if how.contains("[joint]")));
        assert_eq!(masonry("colour"), None);
    }
}
