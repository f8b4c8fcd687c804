//! From the numbers of a survey sheet to a bridge file: spans with their rings and piers, fill, road, an axle at the quarter point, and the rule
//! and vehicles that the bridge is judged by. What a sheet does not say is written into the file as an assumption, in words, to be replaced.

mod answers;
mod names;
mod page;
mod rows;

use crate::Severity;
use answers::{Answer, Answers};
use page::{More, Sheet};

pub use answers::Unusable;
pub use rows::{Left, Rows, Taken, is_table, rows};

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
    /// What is usual, in words to follow "usually"; empty where nothing is known. The reader of files asks about what lies well outside.
    pub usual: &'static str,
}

const fn question(key: &'static str, doc: &'static str, unit: &'static str, example: &'static str) -> Question {
    Question { key, doc, unit, example, assumed: "", usual: "" }
}

impl Question {
    const fn usual(mut self, words: &'static str) -> Question {
        self.usual = words;
        self
    }

    const fn assumed(mut self, value: &'static str) -> Question {
        self.assumed = value;
        self
    }
}

/// The ten numbers. The first three are those of a span: a further one has its own as `span_2`, `rise_2`, `thickness_2`, or those of the first.
pub const QUESTIONS: [Question; 10] = [
    question("span", "Clear span between the springings, at the intrados.", "m", "6.00 m"),
    question("rise", "Rise of the crown's intrados above the springings.", "m", "1.50 m")
        .usual("1/12 to 1/2 of the span"),
    question("thickness", "Thickness of the ring.", "m", "0.45 m").usual("1/40 to 1/10 of the span"),
    question("width", "Width of the barrel that carries the road, between the parapets.", "m", "5.00 m")
        .usual("1 m to 40 m"),
    question("cover", "Depth of fill and surfacing over the crown, from its extrados to the road.", "m", "0.50 m")
        .usual("at most 3 m"),
    question("unit", "Length of a stone or brick along the ring.", "m", "0.30 m")
        .assumed("0.30 m")
        .usual("so short that seven or more make a ring"),
    question("backing", "Height of solid backing above the springings; 0 where there is none.", "m", "0 m")
        .assumed("0 m"),
    question("density", "Density of the masonry, or its weight per volume.", "kg/m^3", "2200 kg/m^3")
        .assumed("2200 kg/m^3")
        .usual("1500 kg/m^3 to 3000 kg/m^3"),
    question("strength", "Compressive strength of the masonry.", "MPa", "5 MPa")
        .assumed("5 MPa")
        .usual("0.5 MPa to 400 MPa"),
    question("axle", "Force of the axle whose multiple is sought, or the mass on it.", "kN", "100 kN")
        .assumed("100 kN")
        .usual("10 kN to 450 kN"),
];

/// How many spans stand in a row: the only question that is about the whole of a viaduct.
pub const SPANS: Question = question("spans", "Arches in a row; one where nothing is written.", "", "1").assumed("1");

/// What several spans need of their piers; a further one has its own as `pier_width_2`, `pier_height_2`, or those of the first. Nothing is
/// assumed of the first: who sees the bridge sees its piers, and a stout or short pier that is not there would flatter it.
pub const PIER: [Question; 2] = [
    question("pier_width", "Width of a pier along the road, at its top.", "m", "1.50 m"),
    question("pier_height", "Height of a pier, from the springings down to the ground that carries it.", "m", "4.00 m")
        .usual("1 to 12 times its width"),
];

/// What a sheet may say beyond that, as other programs have it; the file has no line of what it does not say, or the value that it assumes anyway.
pub const MORE: [Question; 11] = [
    question("profile", "Shape of the intrados: segmental, parabolic, elliptical, pointed.", "", "segmental"),
    question("rings", "Rings that the thickness is made of; several may slide on one another.", "", "1"),
    question("voussoirs", "Stones or bricks of a ring, in place of their length.", "", "40"),
    question("skew", "Angle of skew.", "deg", "15 deg"),
    question("fill_density", "Density of the fill, or its weight per volume.", "kg/m^3", "1900 kg/m^3"),
    question("surfacing", "Depth of surfacing or ballast above the fill, at the crown.", "m", "0.10 m"),
    question(
        "surfacing_density",
        "Density of the surfacing or ballast, or its weight per volume.",
        "kg/m^3",
        "2300 kg/m^3",
    )
    .assumed("2300 kg/m^3"),
    question("backing_density", "Density of the backing, or its weight per volume.", "kg/m^3", "2200 kg/m^3"),
    question("friction", "Angle of friction in the joints of a ring.", "deg", "30 deg"),
    question("ring_friction", "Angle of friction between rings.", "deg", "30 deg").assumed("30 deg"),
    question("fill_friction", "Angle of friction of the fill, which then presses on the ring's back.", "deg", "30 deg"),
];

/// Cohesion of the fill, where it has an angle of friction.
const FILL_COHESION: Question = question("fill_cohesion", "Cohesion of the fill.", "kPa", "0 kPa").assumed("0 kPa");

/// Most rings of a span, and most stones of a ring.
const MOST_OF_A_RING: [usize; 2] = [10, 400];

/// Most spans that a sheet may have.
const MOST_SPANS: usize = 20;

/// The bridge file of these answers, each as `"6.00 m"` or a bare number in the unit of its question; `rule` and `vehicles` are codes of the
/// library, several vehicles with commas between them, none for all that go with the rule.
///
/// # Errors
/// Every answer that is missing, no number, or not possible.
pub fn file(name: &str, answers: &dyn Fn(&str) -> Option<String>) -> Result<String, Vec<Unusable>> {
    let (text, mut found) = checked(name, answers);
    found.retain(|one| one.severity == Severity::Error);
    text.filter(|_| found.is_empty()).ok_or(found)
}

/// Everything that is wrong with answers or doubtful: what is missing, no number, or not what a bridge can have.
pub fn findings(name: &str, answers: &dyn Fn(&str) -> Option<String>) -> Vec<Unusable> {
    checked(name, answers).1
}

/// The file, where every answer is one, and what the reader of bridge files finds in the lines of the answers.
fn checked(name: &str, answers: &dyn Fn(&str) -> Option<String>) -> (Option<String>, Vec<Unusable>) {
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
    let more = more(&mut answers);
    let sheet = Sheet { spans, piers, width, cover, unit, backing, density, strength, axle, judged, more };
    let mut found = answers.wrong();
    if !found.is_empty() {
        return (None, found);
    }
    let (text, lines) = page::written(name, &sheet);
    found.extend(read_in(&text, &lines, &sheet.unit));
    // The only answer that the file has not as it is: stones are counted with it, along rings that are possible.
    let shortest = sheet.spans.iter().map(|[span, rise, _]| page::arc(span.si, rise.si)).fold(f64::INFINITY, f64::min);
    let most = if found.iter().any(|one| one.severity == Severity::Error) { f64::INFINITY } else { 0.5 * shortest };
    if !(sheet.unit.si > 0.0 && sheet.unit.si <= most) {
        let help = format!("it must be more than 0 m, and at most half of a ring, {:.2} m", 0.5 * shortest);
        found.retain(|one| one.key != sheet.unit.key);
        found.push(out_of_range(&sheet.unit, help));
    }
    (Some(text), found)
}

/// What the sheet says beyond the ten numbers.
fn more(answers: &mut Answers<'_>) -> More {
    let [
        _,
        rings,
        voussoirs,
        skew,
        fill_density,
        surfacing,
        surfacing_density,
        backing_density,
        friction,
        ring_friction,
        fill_friction,
    ] = &MORE;
    let surfacing = answers.optional(surfacing);
    let fill_friction = answers.optional(fill_friction);
    let rings = if answers.said("rings").is_some() { answers.count(rings, MOST_OF_A_RING[0]) } else { 1 };
    More {
        number: answers.said("number").unwrap_or_default(),
        profile: answers.said("profile").unwrap_or_else(|| "segmental".to_owned()),
        voussoirs: answers.said("voussoirs").map(|_| answers.count(voussoirs, MOST_OF_A_RING[1])),
        skew: answers.optional(skew),
        fill_density: answers.optional(fill_density),
        surfacing: surfacing.map(|depth| [depth, answers.of(surfacing_density)]),
        backing_density: answers.optional(backing_density),
        friction: answers.optional(friction),
        ring_friction: if rings > 1 { answers.of(ring_friction) } else { Answer::default() },
        fill_friction: fill_friction.map(|angle| [angle, answers.of(&FILL_COHESION)]),
        rings,
    }
}

/// What is said of an answer that is not possible.
fn out_of_range(answer: &Answer, help: String) -> Unusable {
    let message = format!("{}: \"{}\" is out of its possible range", answer.key, answer.text);
    Unusable { key: answer.key.clone(), severity: Severity::Error, message, help }
}

/// What the reader of bridge files finds in the lines of the answers, the errors before the doubts: one of each answer.
fn read_in(text: &str, lines: &page::Lines, stone: &Answer) -> Vec<Unusable> {
    let mut diagnostics = crate::read(text.as_bytes()).diagnostics;
    diagnostics.sort_by_key(|one| one.severity != Severity::Error);
    let mut found: Vec<Unusable> = Vec::new();
    for one in &diagnostics {
        let at = text.as_bytes()[..one.range.start.min(text.len())].iter().filter(|byte| **byte == b'\n').count();
        let Some((_, answer)) = lines.iter().find(|(line, _)| *line == at) else { continue };
        // Rings of few voussoirs: they are counted with the length of a stone.
        let answer = if one.code == "P026" { stone } else { answer };
        if found.iter().any(|known| known.key == answer.key) {
            continue;
        }
        let help = one.help.clone().unwrap_or_default();
        found.push(match one.code {
            "B107" => out_of_range(answer, help),
            _ => Unusable {
                key: answer.key.clone(),
                severity: one.severity,
                message: format!("{}: {}", answer.key, [&one.message[..], &one.label].join("; ")),
                help,
            },
        });
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantity;

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
        let text = of(&feet).unwrap();
        let read = crate::read(text.as_bytes());
        assert!(read.bridge.is_some());
        // What is assumed beside them is in feet as well: nobody is asked about a mixture.
        assert!(read.diagnostics.iter().all(|one| one.code != "P033"), "{:?}\n{text}", read.diagnostics);
        assert!(text.contains("width = \"16.5 ft\"\n") && text.contains("contact_length = \"0.984 ft\""), "{text}");
        let wrong = of(&[("span", "six"), ("rise", "3 kN"), ("thickness", "0.4"), ("width", "")]).unwrap_err();
        let keys: Vec<&str> = wrong.iter().map(|one| one.key.as_str()).collect();
        assert_eq!(keys, ["span", "rise", "width", "cover"]);
        let hostile =
            file("\"]\n[x]\\", &|key| feet.iter().find(|one| one.0 == key).map(|one| one.1.to_owned())).unwrap();
        assert!(crate::read(hostile.as_bytes()).bridge.is_some(), "{hostile}");
    }

    /// Every answer, of one span and of several, with every kind of number that no bridge has.
    #[test]
    fn a_value_out_of_range_is_a_finding_at_its_answer() {
        let of_all = |more: &[(&str, &str)], key: &str| {
            let piers = [("spans", "2"), ("pier_width", "1.5 m"), ("pier_height", "4 m")];
            let usual = QUESTIONS.iter().map(|one| (one.key, one.example)).chain(piers);
            more.iter().copied().chain(usual).find(|one| one.0 == key).map(|one| one.1.to_owned())
        };
        assert!(findings("x", &|asked| of_all(&[], asked)).is_empty());
        let keys: Vec<&str> =
            QUESTIONS.iter().chain(&PIER).map(|one| one.key).chain(["span_2", "rise_2", "thickness_2"]).collect();
        for key in keys {
            for wrong in ["-1", "-0.001", "1e9", "1e300"] {
                let found = findings("x", &|asked| of_all(&[(key, wrong)], asked));
                // What is as the first is wrong with it, and no second finding.
                assert!(!found.is_empty() && found.iter().all(|one| one.key == key), "{key} = {wrong}: {found:?}");
                assert!(found[0].message.starts_with(&format!("{key}: ")), "{found:?}");
                let is_error = found[0].severity == Severity::Error;
                assert_eq!(is_error, file("x", &|asked| of_all(&[(key, wrong)], asked)).is_err());
                assert!(is_error || !wrong.starts_with('-'), "{key} = {wrong}: {found:?}");
            }
            // Depths that a bridge may lack are left out of its file, and all others are a finding.
            let lacks = ["cover", "backing"].contains(&key);
            assert_eq!(file("x", &|asked| of_all(&[(key, "0")], asked)).is_ok(), lacks, "{key} = 0");
        }
        for (key, rare, severity) in [("density", "22", Severity::Warning), ("unit", "2 m", Severity::Warning)] {
            let found = findings("x", &|asked| of_all(&[(key, rare)], asked));
            assert_eq!(found.len(), 1, "{found:?}");
            assert!(found[0].key == key && found[0].severity == severity, "{found:?}");
        }
    }

    /// What is said to be usual is what the reader takes without a question, from one end to the other.
    #[test]
    fn both_ends_of_what_is_usual_are_taken_without_a_question() {
        let piers = [("spans", "2"), ("pier_width", "1.5 m"), ("pier_height", "4 m")];
        let found = |key: &str, value: &str| {
            let usual = QUESTIONS.iter().map(|one| (one.key, one.example)).chain(piers);
            let given: Vec<(&str, &str)> = std::iter::once((key, value)).chain(usual).collect();
            findings("x", &|asked| given.iter().find(|one| one.0 == asked).map(|one| one.1.to_owned()))
        };
        // Shares of the span of 6 m, times of the width of 1.5 m, seven stones of its ring of 6.95 m.
        let ends = [
            ("rise", ["0.5 m", "3 m"]),
            ("thickness", ["0.15 m", "0.6 m"]),
            ("width", ["1 m", "40 m"]),
            ("cover", ["0 m", "3 m"]),
            ("unit", ["0.1 m", "0.99 m"]),
            ("density", ["1500 kg/m^3", "3000 kg/m^3"]),
            ("strength", ["0.5 MPa", "400 MPa"]),
            ("axle", ["10 kN", "450 kN"]),
            ("pier_height", ["1.5 m", "18 m"]),
        ];
        for question in QUESTIONS.iter().chain(&PIER).filter(|one| !one.usual.is_empty()) {
            let (_, both) = ends.iter().find(|one| one.0 == question.key).unwrap();
            for end in both {
                assert_eq!(found(question.key, end), [], "{} = {end}", question.key);
            }
            let written: Vec<&str> = question.usual.split(" to ").filter(|end| quantity::parse(end).is_ok()).collect();
            assert!(written.is_empty() || written == both, "{}: {written:?}", question.usual);
        }
    }

    #[test]
    fn weights_per_volume_and_tonnes_are_taken_as_they_are_written() {
        let five: Vec<(&str, &str)> = QUESTIONS[..5].iter().map(|one| (one.key, one.example)).collect();
        let text = of(&[&five[..], &[("density", "22 kN/m3"), ("axle", "11.5 t")]].concat()).unwrap();
        let bridge = crate::read(text.as_bytes()).bridge.unwrap_or_else(|| panic!("{text}"));
        assert!((bridge.masonry.density - 22e3 / 9.81).abs() < 1e-9, "{text}");
        assert!(text.contains("axle_force = \"11.5 t\"\n"), "{text}");
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
    fn a_rule_goes_with_its_vehicles_or_with_all_and_no_vehicle_without_a_rule() {
        let five: Vec<(&str, &str)> = QUESTIONS[..5].iter().map(|one| (one.key, one.example)).collect();
        let with = |more: &[(&'static str, &'static str)]| of(&[&five[..], more].concat());
        assert!(!with(&[]).unwrap().contains("[sweep]"));
        let text = with(&[("rule", "cs-454"), ("vehicles", "cs454-single, hb-45")]).unwrap();
        let plan = crate::read(text.as_bytes()).bridge.and_then(|bridge| bridge.sweep).unwrap();
        assert_eq!(
            (plan.rule.as_str(), &plan.vehicles[..]),
            ("cs-454", &["cs454-single".to_owned(), "hb-45".to_owned()][..])
        );
        let all = crate::read(with(&[("rule", "cs-454")]).unwrap().as_bytes()).bridge.and_then(|bridge| bridge.sweep);
        assert_eq!(all.map(|plan| (plan.rule, plan.vehicles)), Some(("cs-454".to_owned(), Vec::new())));
        assert_eq!(with(&[("vehicles", "hb-45")]).unwrap_err()[0].key, "rule");
    }
}
