//! From the numbers of a survey sheet to a bridge file: spans with their rings and piers, fill, road, an axle at the quarter point, and the rule
//! and vehicles that the bridge is judged by. What a sheet does not say is written into the file as an assumption, in words, to be replaced.

mod answers;
mod changed;
mod kept;
mod names;
mod page;
mod questions;
mod rows;

use crate::Severity;
use crate::quantity;
use answers::{Answer, Answers};
use page::{Barrel, Others, Sheet};
use questions::{FILL_COHESION, OTHERS};

pub use answers::Unusable;
pub use changed::{Changed, changed};
pub use kept::{answers, is_survey};
pub use questions::{MORE, PIER, QUESTIONS, Question, SPANS, WORDS};
pub use rows::{Left, Rows, Taken, is_table, rows};

/// Most spans that a sheet may have, most rings of each, and most stones of a ring.
const MOST_SPANS: usize = 20;
const MOST_RINGS: usize = 12;
const MOST_STONES: usize = 400;

/// The bridge file of these answers, each as `"6.00 m"` or a bare number in the unit of its question; `rule` and `vehicles` are codes of the
/// library, several vehicles with commas between them, none for all that go with the rule.
///
/// # Errors
/// Every answer that is missing, no number, or not possible.
pub fn file(name: &str, answers: &dyn Fn(&str) -> Option<String>) -> Result<String, Vec<Unusable>> {
    let (text, mut found) = checked(name, answers, false);
    found.retain(|one| one.severity == Severity::Error);
    text.filter(|_| found.is_empty()).ok_or(found)
}

/// Everything that is wrong with answers or doubtful: what is missing, no number, or not what a bridge can have.
pub fn findings(name: &str, answers: &dyn Fn(&str) -> Option<String>) -> Vec<Unusable> {
    checked(name, answers, false).1
}

/// The file to begin a survey with: every answer is assumed, what must be measured by its example, and the file says so.
pub fn start(name: &str) -> String {
    checked(name, &|_| None, true).0.unwrap_or_default()
}

/// The file, where every answer is one, and what the reader of bridge files finds in the lines of the answers. In a survey that has only
/// `begun` the first span and its width and cover are examples until they are answered.
fn checked(name: &str, answers: &dyn Fn(&str) -> Option<String>, begun: bool) -> (Option<String>, Vec<Unusable>) {
    let mut answers = Answers::new(answers, begun);
    let [span, rise, thickness, width, cover, unit, backing, density, strength, axle] =
        QUESTIONS.each_ref().map(|question| answers.of(question));
    let count = answers.count(&SPANS, MOST_SPANS);
    let ring = [span, rise, thickness];
    let spans: Vec<[Answer; 3]> =
        (1..=count).map(|k| std::array::from_fn(|n| answers.of_each(&QUESTIONS[n], &ring[n], k))).collect();
    let pier = if count > 1 { PIER.each_ref().map(|question| answers.measured(question)) } else { Default::default() };
    let piers: Vec<[Answer; 2]> =
        (1..count).map(|k| std::array::from_fn(|n| answers.of_each(&PIER[n], &pier[n], k))).collect();
    let [rings, bond, fill_density, skew, lost_mortar] = &MORE;
    let barrel = Barrel {
        rings: answers.count(rings, MOST_RINGS),
        bond: answers.of(bond),
        skew: answers.maybe(skew),
        lost_mortar: answers.of(lost_mortar),
        fill: answers.fill(),
        fill_density: answers.of(fill_density),
        reference: answers.words("reference"),
        condition: answers.words("condition"),
    };
    let judged = answers.judged();
    let (others, nothing) = (others(&mut answers), answers.nothing());
    let sheet =
        Sheet { spans, piers, width, cover, unit, backing, density, strength, axle, barrel, others, judged, nothing };
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

/// What tables of other programs may say beyond that.
fn others(answers: &mut Answers<'_>) -> Others {
    let [voussoirs, surfacing, surfacing_density, backing_density, friction, ring_friction, fill_friction] = &OTHERS;
    let stones = answers.said(voussoirs.key).is_some();
    let surfacing = answers.maybe(surfacing);
    let fill_friction = answers.maybe(fill_friction);
    Others {
        profile: answers.words("profile").unwrap_or_else(|| "segmental".to_owned()),
        voussoirs: stones.then(|| answers.count(voussoirs, MOST_STONES)),
        surfacing: surfacing.map(|depth| [depth, answers.of(surfacing_density)]),
        backing_density: answers.maybe(backing_density),
        friction: answers.maybe(friction),
        ring_friction: answers.of(ring_friction),
        fill_friction: fill_friction.map(|angle| [angle, answers.of(&FILL_COHESION)]),
    }
}

/// What is said of an answer that is not possible.
fn out_of_range(answer: &Answer, help: String) -> Unusable {
    let message = format!("{}: \"{}\" is out of its possible range", answer.key, answer.text);
    // A number of millimetres that was taken for metres.
    let millimetres =
        quantity::parse(&answer.text).ok().filter(|found| found.unit.symbol == "m" && found.number >= 50.0);
    let help = match millimetres {
        Some(found) => format!("{help}; did you mean \"{} mm\"?", found.number),
        None => help,
    };
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
mod tests;
