//! From the numbers of a survey sheet to a bridge file: one span, one ring, fill, road and an axle at the quarter point. What a sheet does
//! not say is written into the file as an assumption, in words, to be replaced.

use crate::quantity::{self, Dimension};
use std::fmt::Write;

/// A number that a survey finds.
#[derive(Debug, Clone, Copy)]
pub struct Question {
    /// Its name.
    pub key: &'static str,
    /// What is measured, in a line.
    pub doc: &'static str,
    /// Unit in which a bare number is taken; empty for counts.
    pub unit: &'static str,
    /// A value to begin with, as text.
    pub example: &'static str,
    /// What is assumed where the sheet says nothing; empty where it must.
    pub assumed: &'static str,
}

const fn question(key: &'static str, doc: &'static str, unit: &'static str, example: &'static str) -> Question {
    Question { key, doc, unit, example, assumed: "" }
}

/// The ten numbers.
pub const QUESTIONS: [Question; 10] = [
    question("span", "Clear span between the springings, at the intrados.", "m", "6.00 m"),
    question("rise", "Rise of the crown's intrados above the springings.", "m", "1.50 m"),
    question("thickness", "Thickness of the ring.", "m", "0.45 m"),
    question("width", "Width of the barrel that carries the road, between the parapets.", "m", "5.00 m"),
    question("cover", "Depth of fill and surfacing over the crown, from its extrados to the road.", "m", "0.50 m"),
    Question { assumed: "0.30 m", ..question("unit", "Length of a stone or brick along the ring.", "m", "0.30 m") },
    Question {
        assumed: "0 m",
        ..question("backing", "Height of solid backing above the springings; 0 where there is none.", "m", "0 m")
    },
    Question { assumed: "2200 kg/m^3", ..question("density", "Density of the masonry.", "kg/m^3", "2200 kg/m^3") },
    Question { assumed: "5 MPa", ..question("strength", "Compressive strength of the masonry.", "MPa", "5 MPa") },
    Question { assumed: "100 kN", ..question("axle", "Force of the axle whose multiple is sought.", "kN", "100 kN") },
];

/// Why numbers make no file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unusable {
    /// Which of the numbers.
    pub key: &'static str,
    /// What is wrong with it.
    pub message: String,
    /// What to write instead.
    pub help: String,
}

/// Most voussoirs that a file made here has.
const MOST_VOUSSOIRS: f64 = 400.0;

/// The bridge file of these answers, each as `"6.00 m"` or a bare number in the unit of its question. What is possible is for the reader of
/// bridge files to say; here a number must be one.
///
/// # Errors
/// Every answer that is missing or no number.
pub fn file(name: &str, answers: &dyn Fn(&str) -> Option<String>) -> Result<String, Vec<Unusable>> {
    let mut wrong = Vec::new();
    let mut said: Vec<(String, f64, bool)> = Vec::new();
    for question in &QUESTIONS {
        match answer(question, answers(question.key)) {
            Ok(found) => said.push(found),
            Err(unusable) => wrong.push(unusable),
        }
    }
    let Ok([span, rise, thickness, width, cover, unit, backing, density, strength, axle]) =
        <[(String, f64, bool); 10]>::try_from(said)
    else {
        return Err(wrong);
    };
    let count = (arc(span.1, rise.1) / unit.1.max(1e-3)).round().clamp(5.0, MOST_VOUSSOIRS) as u64;
    let literal: String = name.chars().filter(|c| !c.is_control() && *c != '"' && *c != '\\').take(80).collect();
    let remark = |one: &(String, f64, bool)| if one.2 { "  # assumed: the survey says nothing" } else { "" };
    let mut page = format!(
        "# From a survey sheet. Lines with \"assumed\" are to be replaced by what is known of this bridge.\n\n\
         [bridge]\nname = \"{literal}\"\nwidth = \"{}\"\n\n\
         [[span]]\nprofile = \"segmental\"\nspan = \"{}\"\nrise = \"{}\"\nthickness = \"{}\"\nvoussoirs = {count}{}\n\n",
        width.0,
        span.0,
        rise.0,
        thickness.0,
        if unit.2 { "  # assumed: stones of 0.30 m" } else { "" },
    );
    if cover.1 > 0.0 {
        let _ = write!(
            page,
            "[[cover]]\nlayer = \"fill\"\nthickness = \"{}\"\ndensity = \"1900 kg/m^3\"  # assumed: fill and surfacing as one layer\n\n",
            cover.0
        );
    }
    if backing.1 > 0.0 {
        let _ = write!(
            page,
            "[backing]\nheight = \"{}\"  # above the springings\ndensity = \"2200 kg/m^3\"  # assumed\n\n",
            backing.0
        );
    }
    let _ = write!(
        page,
        "[masonry]\ndensity = \"{}\"{}\ncompressive_strength = \"{}\"{}\n\n\
         [joint]\nfriction_angle = \"30 deg\"  # assumed\ncohesion = \"0 kPa\"  # assumed: mortar carries no tension\n\n\
         [dispersal]\nrule = \"uniform\"\nslope = \"2:1\"\n\n\
         [[load]]\nname = \"axle\"\nkind = \"axle\"\naxle_force = \"{}\"{}\ncontact_length = \"0.30 m\"  # assumed\n\
         effective_width = \"{:.3} m\"  # assumed: a track of 1.8 m, spread 1:2 through the cover, not wider than the barrel\n\
         at = \"1/4 of span 1\"\n\n[analysis]\nmethod = \"limit\"\n",
        density.0,
        remark(&density),
        strength.0,
        remark(&strength),
        axle.0,
        remark(&axle),
        (1.8 + cover.1.max(0.0)).min(width.1),
    );
    Ok(page)
}

/// An answer as the file has it, in SI, and whether it is assumed.
fn answer(question: &'static Question, said: Option<String>) -> Result<(String, f64, bool), Unusable> {
    let written = said.map(|text| text.trim().to_owned()).filter(|text| !text.is_empty());
    let unusable = |message: String| {
        let help = format!("write {} with its unit, such as {}", question.key, question.example);
        Unusable { key: question.key, message, help }
    };
    let (text, assumed) = match written {
        Some(text) => (text, false),
        None if question.assumed.is_empty() => return Err(unusable(format!("{} is missing", question.key))),
        None => (question.assumed.to_owned(), true),
    };
    let text = match text.parse::<f64>() {
        Ok(_) => format!("{text} {}", question.unit),
        Err(_) => text,
    };
    let wanted = quantity::parse(question.example).map(|example| example.unit.dimension).unwrap_or(Dimension::Length);
    match quantity::parse(&text) {
        Ok(found) if found.unit.dimension == wanted && found.si().is_finite() => {
            // Feet and inches are written with marks that end a text in the file.
            let marked = text.contains(['"', '\\']);
            let written = if marked { format!("{} m", found.si()) } else { text };
            Ok((written, found.si(), assumed))
        }
        Ok(found) => {
            let (is, want) = (found.unit.dimension.name(), wanted.name());
            Err(unusable(format!("{}: \"{text}\" is {is} and not {want}", question.key)))
        }
        Err(_) => Err(unusable(format!("{}: \"{text}\" is no number with a unit", question.key))),
    }
}

/// Length of a segmental arc [m].
fn arc(span: f64, rise: f64) -> f64 {
    if !(span > 0.0 && rise > 0.0) {
        return span.abs();
    }
    let radius = 0.5 * (0.25 * span * span / rise + rise);
    let half = (0.5 * span / radius).min(1.0).asin();
    let half = if rise > radius { std::f64::consts::PI - half } else { half };
    2.0 * radius * half
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Severity;

    fn of(answers: &[(&str, &str)]) -> Result<String, Vec<Unusable>> {
        let of = |key: &str| answers.iter().find(|(name, _)| *name == key).map(|(_, text)| (*text).to_owned());
        file("Mill Lane", &of)
    }

    #[test]
    fn the_examples_make_a_file_without_errors_that_says_what_is_assumed() {
        let all: Vec<(&str, &str)> = QUESTIONS.iter().map(|one| (one.key, one.example)).collect();
        let five = &all[..5];
        for answers in [&all[..], five, &[five, &[("backing", "0.8 m"), ("axle", "11.5")][..]].concat()] {
            let text = of(answers).unwrap();
            let read = crate::read(text.as_bytes());
            let errors: Vec<_> = read.diagnostics.iter().filter(|one| one.severity == Severity::Error).collect();
            assert!(read.bridge.is_some() && errors.is_empty(), "{errors:?}\n{text}");
            assert_eq!(text.contains("assumed: the survey says nothing"), answers.len() < 10, "{text}");
        }
    }

    #[test]
    fn feet_are_taken_and_slips_are_named() {
        let feet =
            [("span", "20 ft"), ("rise", "5 ft"), ("thickness", "18 in"), ("width", "16' 6\""), ("cover", "1.5 ft")];
        assert!(crate::read(of(&feet).unwrap().as_bytes()).bridge.is_some());
        let wrong = of(&[("span", "six"), ("rise", "3 kN"), ("thickness", "0.4"), ("width", "")]).unwrap_err();
        let keys: Vec<&str> = wrong.iter().map(|one| one.key).collect();
        assert_eq!(keys, ["span", "rise", "width", "cover"]);
        let hostile =
            file("\"]\n[x]\\", &|key| feet.iter().find(|one| one.0 == key).map(|one| one.1.to_owned())).unwrap();
        assert!(crate::read(hostile.as_bytes()).bridge.is_some(), "{hostile}");
    }

    #[test]
    fn stones_are_counted_along_the_arc() {
        assert!((arc(2.0, 1.0) - std::f64::consts::PI).abs() < 1e-12);
        assert!((arc(10.0, 1e-6) - 10.0).abs() < 1e-6);
    }
}
