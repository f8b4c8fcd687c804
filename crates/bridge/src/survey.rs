//! From the numbers of a survey sheet to a bridge file: spans with their rings and piers, fill, road, an axle at the quarter point, and the rule
//! and vehicles that the bridge is judged by. What a sheet does not say is written into the file as an assumption, in words, to be replaced.

mod answers;
mod page;

use answers::{Answer, Answers};
use page::Sheet;

pub use answers::Unusable;

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

/// The ten numbers. The first three are those of a span: a further one has its own as `span_2`, `rise_2`, `thickness_2`, or those of the first.
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

/// How many spans stand in a row: the only question that is about the whole of a viaduct.
pub const SPANS: Question =
    Question { assumed: "1", ..question("spans", "Arches in a row; one where nothing is written.", "", "1") };

/// What several spans need of their piers; a further one has its own as `pier_width_2`, `pier_height_2`, or those of the first. Nothing is
/// assumed of the first: who sees the bridge sees its piers, and a stout or short pier that is not there would flatter it.
pub const PIER: [Question; 2] = [
    question("pier_width", "Width of a pier along the road, at its top.", "m", "1.50 m"),
    question("pier_height", "Height of a pier, from the springings down to the ground that carries it.", "m", "4.00 m"),
];

/// Most spans that a sheet may have.
const MOST_SPANS: usize = 20;

/// The bridge file of these answers, each as `"6.00 m"` or a bare number in the unit of its question; `rule` and `vehicles` are codes of the
/// library, several vehicles with commas between them. What is possible is for the reader of bridge files to say; here a number must be one.
///
/// # Errors
/// Every answer that is missing or no number.
pub fn file(name: &str, answers: &dyn Fn(&str) -> Option<String>) -> Result<String, Vec<Unusable>> {
    let mut answers = Answers::new(answers);
    let [span, rise, thickness, width, cover, unit, backing, density, strength, axle] =
        QUESTIONS.each_ref().map(|question| answers.of(question));
    let count = answers.count(&SPANS, MOST_SPANS);
    let ring = [span, rise, thickness];
    let spans: Vec<[Answer; 3]> =
        (1..=count).map(|k| std::array::from_fn(|n| answers.of_each(&QUESTIONS[n], &ring[n], k))).collect();
    let pier = if count > 1 { PIER.each_ref().map(|question| answers.of(question)) } else { Default::default() };
    let piers: Vec<[Answer; 2]> =
        (1..count).map(|k| std::array::from_fn(|n| answers.of_each(&PIER[n], &pier[n], k))).collect();
    let judged = answers.judged();
    let sheet = Sheet { spans, piers, width, cover, unit, backing, density, strength, axle, judged };
    answers.done()?;
    Ok(page::written(name, &sheet))
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
        let keys: Vec<&str> = wrong.iter().map(|one| one.key.as_str()).collect();
        assert_eq!(keys, ["span", "rise", "width", "cover"]);
        let hostile =
            file("\"]\n[x]\\", &|key| feet.iter().find(|one| one.0 == key).map(|one| one.1.to_owned())).unwrap();
        assert!(crate::read(hostile.as_bytes()).bridge.is_some(), "{hostile}");
    }

    const VIADUCT: [(&str, &str); 9] = [
        ("span", "9.14 m"),
        ("rise", "2.44 m"),
        ("thickness", "0.46 m"),
        ("width", "8.2 m"),
        ("cover", "0.6 m"),
        ("spans", "3"),
        ("pier_width", "1.5 m"),
        ("pier_height", "5 m"),
        ("rise_3", "2.1 m"),
    ];

    #[test]
    fn spans_have_piers_between_them_and_what_nobody_measured_of_the_others_is_assumed() {
        let text = of(&VIADUCT).unwrap();
        let read = crate::read(text.as_bytes());
        let errors: Vec<_> = read.diagnostics.iter().filter(|one| one.severity == Severity::Error).collect();
        let bridge = read.bridge.unwrap_or_else(|| panic!("{errors:?}\n{text}"));
        assert_eq!((bridge.spans.len(), bridge.piers.len()), (3, 2), "{text}");
        assert_eq!(text.matches("rise = \"2.44 m\"  # assumed: as span 1").count(), 1, "{text}");
        assert!(text.contains("rise = \"2.1 m\"\n"), "{text}");
        assert_eq!(text.matches("height = \"5 m\"  # assumed: as pier 1").count(), 1, "{text}");
    }

    #[test]
    fn nothing_is_assumed_of_the_first_pier_and_one_span_asks_for_none() {
        let of_one: Vec<_> = VIADUCT.into_iter().filter(|one| one.0 != "spans").collect();
        assert!(!of(&of_one).unwrap().contains("[[pier]]"));
        let no_pier: Vec<_> = VIADUCT.into_iter().filter(|one| !one.0.starts_with("pier")).collect();
        let keys: Vec<String> = of(&no_pier).unwrap_err().into_iter().map(|one| one.key).collect();
        assert_eq!(keys, ["pier_width", "pier_height"]);
        for (key, answer) in [("spans", "0"), ("spans", "21"), ("spans", "two"), ("rise_3", "high")] {
            let slip: Vec<_> = VIADUCT.into_iter().filter(|one| one.0 != key).chain([(key, answer)]).collect();
            let wrong = of(&slip).unwrap_err();
            assert_eq!((wrong.len(), wrong[0].key.as_str()), (1, key), "{answer}");
        }
    }

    #[test]
    fn a_rule_and_its_vehicles_are_written_together_or_not_at_all() {
        let five: Vec<(&str, &str)> = QUESTIONS[..5].iter().map(|one| (one.key, one.example)).collect();
        let with = |more: &[(&'static str, &'static str)]| of(&[&five[..], more].concat());
        assert!(!with(&[]).unwrap().contains("[sweep]"));
        let text = with(&[("rule", "cs-454"), ("vehicles", "cs454-single, hb-45")]).unwrap();
        let plan = crate::read(text.as_bytes()).bridge.and_then(|bridge| bridge.sweep).unwrap();
        assert_eq!(
            (plan.rule.as_str(), &plan.vehicles[..]),
            ("cs-454", &["cs454-single".to_owned(), "hb-45".to_owned()][..])
        );
        assert_eq!(with(&[("rule", "cs-454")]).unwrap_err()[0].key, "vehicles");
        assert_eq!(with(&[("vehicles", "hb-45")]).unwrap_err()[0].key, "rule");
    }
}
