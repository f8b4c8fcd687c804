//! Names that engineers and other programs give to what a survey asks.

use crate::quantity::{self, Unreadable};

/// Spellings, and the words that stand for them here. Longer ones come first.
const WORDS: [(&str, &[&str]); 22] = [
    ("coefficient friction", &["coefficient of friction", "friction coefficient", "mu", "µ", "μ"]),
    ("friction", &["angle of internal friction", "internal friction angle", "angle of shearing resistance"]),
    ("friction", &["angle of friction", "friction angle", "angle friction", "phi", "φ", "ϕ"]),
    ("density", &["unit weight", "specific weight", "weight density", "weight per volume", "bulk density"]),
    ("density", &["mass density", "gamma", "γ", "rho", "ρ", "bulk weight"]),
    ("strength", &["compressive strength", "crushing strength", "crushing stress", "strength in compression"]),
    ("strength", &["fc", "fk", "f c", "f k"]),
    ("surfacing", &["surface fill", "road surfacing", "road surface", "surface", "ballast", "pavement", "asphalt"]),
    ("fill", &["backfill", "back fill", "infill", "in fill", "soil"]),
    ("backing", &["solid backing", "masonry backing", "haunching"]),
    ("number", &["number of", "no. of", "no of", "nr of", "nr. of", "num", "no.", "no", "nr", "count"]),
    ("spans", &["arches"]),
    ("arch", &["arch ring", "arch barrel", "barrel", "vault", "ring"]),
    ("blocks", &["voussoirs", "stones", "bricks", "units"]),
    ("block", &["voussoir", "stone or brick", "stone", "brick"]),
    ("shape", &["profile", "geometry", "intrados type", "arch type"]),
    ("thickness", &["thk", "thk.", "depth arch"]),
    ("springing", &["springings", "springers", "springing level"]),
    ("pier", &["piers"]),
    ("vehicles", &["vehicle", "load models", "load model"]),
    ("rule", &["code", "standard"]),
    ("skew", &["skew angle", "angle of skew"]),
];

/// Words that tell nothing apart.
const SMALL: &[&str] = &[
    "of", "the", "a", "an", "at", "to", "in", "its", "per", "over", "above", "between", "for", "from", "along", "and",
];

/// Words of every question, in any order; a word in brackets may be missing.
const NAMES: [(&str, &[&str]); 25] = [
    ("name", &["(bridge) (structure) name", "bridge", "structure"]),
    ("reference", &["(bridge) (structure) reference", "bridge number", "structure number", "asset number"]),
    ("spans", &["(number) spans"]),
    ("span", &["(clear) (arch) (square) (length) (intrados) (skew) span"]),
    ("rise", &["(clear) (arch) (crown) (midspan) (intrados) rise"]),
    ("thickness", &["(arch) (overall) (total) thickness", "arch depth"]),
    ("width", &["(arch) (bridge) (overall) (parapets) width"]),
    (
        "cover",
        &[
            "(crown) (fill) (depth) (thickness) (extrados) cover",
            "(crown) (height) fill",
            "(crown) (extrados) fill depth",
        ],
    ),
    ("cover", &["(crown) (extrados) fill thickness"]),
    ("unit", &["(arch) block length"]),
    ("voussoirs", &["(number) (arch) blocks"]),
    ("rings", &["(number) (arch) rings"]),
    ("backing", &["(height) (springing) backing", "backing level"]),
    ("backing_density", &["backing density"]),
    ("density", &["(masonry) (arch) (block) density"]),
    ("strength", &["(masonry) (arch) (block) strength"]),
    ("friction", &["(coefficient) (radial) (masonry) (joint) (joints) (mortar) (arch) friction"]),
    (
        "ring_friction",
        &["(coefficient) (joint) (joints) (masonry) tangential friction", "(coefficient) rings friction"],
    ),
    ("fill_density", &["fill density"]),
    ("fill_friction", &["(coefficient) fill friction"]),
    ("fill_cohesion", &["fill cohesion"]),
    ("surfacing", &["(depth) (thickness) (crown) surfacing"]),
    ("surfacing_density", &["surfacing density"]),
    ("skew", &["(bridge) (arch) skew"]),
    ("axle", &["axle (force) (load) (weight)"]),
];

/// Names of words and codes, and of piers.
const MORE: [(&str, &[&str]); 5] = [
    ("pier_width", &["(top) pier width", "pier thickness"]),
    ("pier_height", &["pier height"]),
    ("profile", &["(arch) (intrados) shape"]),
    ("rule", &["(assessment) rule"]),
    ("vehicles", &["vehicles"]),
];

/// Those that every span or pier may have.
const EACH: [&str; 5] = ["span", "rise", "thickness", "pier_width", "pier_height"];

/// What is written into the bridge file itself, by words that a name has, all of them.
const ELSEWHERE: [(&str, &str); 27] = [
    ("mortar loss", "a [[defect]] with kind = \"mortar-loss\""),
    ("condition", "the condition factor of the rule: docs/theory/load-rules.md"),
    ("coefficient passive", "[fill_pressure] mobilisation, a share of Rankine's passive pressure"),
    ("passive", "[fill_pressure] mobilisation, a share of Rankine's passive pressure"),
    ("mobilisation", "[fill_pressure] mobilisation, a share of Rankine's passive pressure"),
    ("dispersal", "[dispersal] rule and slope"),
    ("dispersion", "[dispersal] rule and slope"),
    ("spread", "[dispersal] rule and slope"),
    ("cut", "[dispersal] rule and slope"),
    (
        "crown thickness",
        "crown_thickness and springing_thickness in [[span]]; where it is the same all along, call it ring thickness",
    ),
    ("springing thickness", "crown_thickness and springing_thickness in [[span]], in place of thickness"),
    ("quarter rise", "profile = \"measured\" with points in [[span]]: shape by surveyed points"),
    ("arch thickness", "thickness as that of all rings together, or a [[span.ring]] for each"),
    ("effective width", "nothing: it follows from the rule of [sweep], or is effective_width of a [[load]]"),
    ("parapet", "[spandrel_wall] with its height, thickness and density"),
    ("spandrel", "[spandrel_wall] with its height, thickness and density"),
    ("tensile", "[joint] tensile_strength"),
    ("cohesion", "[joint] cohesion"),
    ("modulus", "[masonry] elastic_modulus"),
    ("base pier", "[[pier]] base_width"),
    ("pier", "[[pier]]: its keys are in docs/input/reference.md"),
    ("abutment", "[abutment]: its keys are in docs/input/reference.md"),
    ("partial factor", "nothing: partial factors are those of the rule; others go into a rule_file"),
    ("factor", "nothing: factors are those of the rule; others go into a rule_file"),
    ("lanes", "[carriageway] lanes"),
    ("gravity", "[bridge] gravity"),
    ("water", "[water] level and saturated_density"),
];

/// What a name means.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Named {
    /// A question of the survey: `span`, `rise_2`; and whether a coefficient of friction is meant, and a span square to the springings.
    Question { key: String, coefficient: bool, square: bool },
    /// Something that the bridge file has, and how.
    Elsewhere(&'static str),
    /// Nothing that is known.
    Unknown,
}

/// What a name means, written with units in brackets or without.
pub(super) fn named(name: &str) -> Named {
    let mut words = plain(name);
    let number = words.iter().position(|word| word.parse().is_ok_and(|k: usize| (1..=20).contains(&k)));
    let index: Option<usize> = number.and_then(|at| words.remove(at).parse().ok());
    // "Ring 2": one of several rings, and none of several spans.
    let part = number.and_then(|at| at.checked_sub(1)).and_then(|at| words.get(at)).cloned().unwrap_or_default();
    let without: Vec<String> = words.iter().filter(|word| **word != part).cloned().collect();
    let known = |words: &[String]| {
        let all = NAMES.iter().chain(&MORE);
        all.flat_map(|(key, names)| names.iter().map(move |name| (*key, name)))
            .find(|(_, name)| is(words, name))
            .map(|one| one.0)
    };
    let key = known(&words).or_else(|| known(&without).filter(|_| ["span", "pier"].contains(&&part[..])));
    let key = match (key, index) {
        (Some(key), None | Some(1)) if part != "arch" || index.is_none() => Some(key.to_owned()),
        (Some(key), Some(k)) if EACH.contains(&key) && part != "arch" => Some(format!("{key}_{k}")),
        _ => None,
    };
    let has = |word: &str| words.iter().any(|one| one == word);
    match key {
        Some(key) => Named::Question { key, coefficient: has("coefficient"), square: has("square") },
        None => {
            let elsewhere = ELSEWHERE.iter().find(|(wanted, _)| wanted.split(' ').all(has));
            elsewhere.map_or(Named::Unknown, |(_, how)| Named::Elsewhere(how))
        }
    }
}

/// Whether these are the words of a name, each once, without some of those in brackets.
fn is(words: &[String], name: &str) -> bool {
    let wanted = || name.split(' ').map(|word| (word.trim_matches(['(', ')']), !word.starts_with('(')));
    !words.is_empty()
        && words.iter().all(|word| wanted().any(|(one, _)| one == word))
        && wanted().all(|(one, must)| !must || words.iter().any(|word| word == one))
}

/// Whether a text is a unit, in whatever letters.
pub(super) fn is_unit(text: &str) -> bool {
    let lower = |text: &str| text.to_lowercase().replace(['^', ' '], "").replace('\u{b2}', "2").replace('\u{b3}', "3");
    match quantity::parse(&format!("1 {text}")) {
        Ok(_) => true,
        Err(Unreadable::UnknownUnit(_, written, Some(near))) => lower(&written) == lower(near.symbol),
        Err(_) => false,
    }
}

/// The words of a name, in small letters and one spelling, without units in brackets.
fn plain(name: &str) -> Vec<String> {
    let marks = ['(', ')', '[', ']', '{', '}'];
    let parts = name.split(marks).filter(|part| !is_unit(part.trim()));
    let kept = parts.collect::<Vec<_>>().join(" ").replace(['_', '-', ':', '=', ',', ';', '"', '\'', '/'], " ");
    let mut text = format!(" {} ", kept.to_lowercase().split_whitespace().collect::<Vec<_>>().join(" "));
    for (word, spellings) in WORDS {
        for spelling in spellings {
            text = text.replace(&format!(" {spelling} "), &format!(" {word} "));
        }
    }
    let mut words: Vec<String> = Vec::new();
    for word in text.split_whitespace().filter(|word| !SMALL.contains(word)) {
        if !words.iter().any(|known| known == word) {
            words.push(word.to_owned());
        }
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    fn key(name: &str) -> String {
        match named(name) {
            Named::Question { key, .. } => key,
            Named::Elsewhere(how) => format!("-> {how}"),
            Named::Unknown => "?".to_owned(),
        }
    }

    #[test]
    fn names_of_the_trade_are_known_in_many_spellings() {
        let cases = [
            ("Span", "span"),
            ("Clear span (m)", "span"),
            ("Span of arch [mm]", "span"),
            ("Span 2", "span_2"),
            ("Rise, span 2", "rise_2"),
            ("Rise at crown", "rise"),
            ("rise_3", "rise_3"),
            ("Ring thickness", "thickness"),
            ("Thickness of arch barrel", "thickness"),
            ("Depth of arch ring", "thickness"),
            ("Number of rings", "rings"),
            ("No. of arch rings", "rings"),
            ("Number of spans", "spans"),
            ("Bridge width", "width"),
            ("Width between parapets", "width"),
            ("Depth of fill at crown", "cover"),
            ("Fill depth (crown)", "cover"),
            ("Cover over crown", "cover"),
            ("Masonry unit weight", "density"),
            ("Unit weight of masonry (kN/m3)", "density"),
            ("γ masonry", "density"),
            ("Backfill unit weight", "fill_density"),
            ("Fill: angle of friction", "fill_friction"),
            ("Soil cohesion", "fill_cohesion"),
            ("Surface fill depth", "surfacing"),
            ("Unit weight of ballast", "surfacing_density"),
            ("Masonry crushing strength", "strength"),
            ("Compressive strength", "strength"),
            ("Coefficient of friction (radial)", "friction"),
            ("Coefficient of friction (tangential) (-)", "ring_friction"),
            ("Joint friction angle", "friction"),
            ("Tangential coefficient of friction", "ring_friction"),
            ("Backing height above springings", "backing"),
            ("Unit weight of backing", "backing_density"),
            ("Number of voussoirs", "voussoirs"),
            ("Length of stone", "unit"),
            ("Skew angle", "skew"),
            ("Axle load", "axle"),
            ("Pier 2 height", "pier_height_2"),
            ("Pier width", "pier_width"),
            ("Arch shape", "profile"),
            ("Intrados profile", "profile"),
            ("Structure No.", "reference"),
            ("Bridge name", "name"),
            ("Code", "rule"),
            ("Vehicle", "vehicles"),
        ];
        for (name, wanted) in cases {
            assert_eq!(key(name), wanted, "{name}");
        }
    }

    #[test]
    fn what_a_bridge_file_has_otherwise_is_told_and_the_rest_is_unknown() {
        for (name, word) in [
            ("Mortar loss", "[[defect]]"),
            ("Thickness at springing", "springing_thickness"),
            ("Ring 2 thickness", "[[span.ring]]"),
            ("Rise at quarter point", "measured"),
            ("Passive pressure coefficient", "mobilisation"),
            ("Partial factor for dead load", "rule_file"),
            ("Pier width at base", "base_width"),
        ] {
            assert!(key(name).starts_with("-> ") && key(name).contains(word), "{name}: {}", key(name));
        }
        for name in ["Colour", "", "Temperature", "Assessor"] {
            assert_eq!(key(name), "?", "{name}");
        }
    }

    #[test]
    fn every_name_is_a_question_and_means_one_thing() {
        let mut seen: Vec<(Vec<String>, &str)> = Vec::new();
        for (key, names) in NAMES.iter().chain(&MORE) {
            for name in *names {
                let mut words: Vec<String> =
                    name.split(' ').filter(|word| !word.starts_with('(')).map(str::to_owned).collect();
                words.sort();
                assert!(!seen.iter().any(|(known, other)| *known == words && other != key), "{name} of {key}");
                seen.push((words, key));
            }
        }
    }
}
