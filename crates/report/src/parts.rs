//! Sections of a report that are words and tables alone: what identifies it, what is to be confirmed, what the bridge weighs, how widths
//! were found, and the sheets to check and sign. Every typesetter sets them in one loop.

use crate::numbers::{digits, maybe, percent};
use crate::page::{Appendix, Photograph};
use crate::springings::{lies, pressure};
use crate::standing::standing;
use bridge::document::{Inspection, ReportDocument, Revision};
use bridge::inputs::Input;
use outcome::assessment::Assessment;
use outcome::facts::ServiceFacts;
use outcome::statics::{Reaction, Seat, Statics};
use serde::{Serialize, Serializer};

/// A section: a title, words, and a table.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub(crate) struct Part {
    /// Name of its place on the page; none for a table that goes on with the section before it.
    #[serde(rename = "opens", serialize_with = "is_there")]
    pub id: Option<&'static str>,
    /// Its title.
    pub title: &'static str,
    /// What is said above the table.
    pub words: Vec<String>,
    /// Heads of its columns; a table without heads names its rows in the first column.
    pub heads: Vec<&'static str>,
    /// Which columns are numbers.
    pub numbers: Vec<bool>,
    /// Its rows.
    pub rows: Vec<Vec<String>>,
    /// Where the bridge file says what stands in a row, row by row as far as they go; empty where it does not.
    #[serde(skip)]
    pub paths: Vec<String>,
}

/// Whether a section begins one of its own.
fn is_there<S: Serializer>(id: &Option<&'static str>, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_bool(id.is_some())
}

impl Part {
    /// Cells of a row with the heads of their columns, and their class: a number, or a resultant outside its joint.
    pub(crate) fn cells<'a>(&'a self, row: &'a [String]) -> Vec<(&'static str, &'static str, &'a str)> {
        let head = |k: usize| self.heads.get(k).copied().unwrap_or("");
        let class = |k: usize, cell: &str| match self.numbers.get(k) {
            Some(true) => "number",
            _ if cell == OUTSIDE => "broken",
            _ => "",
        };
        let cell = |(k, cell): (usize, &'a String)| (head(k), class(k, cell), cell.as_str());
        row.iter().enumerate().map(cell).collect()
    }

    /// Where the bridge file says what stands in a row; empty where it does not.
    pub(crate) fn path(&self, row: &usize) -> &str {
        self.paths.get(*row).map_or("", String::as_str)
    }

    /// Heads with whether their columns are numbers.
    pub(crate) fn columns(&self) -> Vec<(&'static str, bool)> {
        self.heads.iter().enumerate().map(|(k, head)| (*head, self.numbers.get(k).copied().unwrap_or(false))).collect()
    }
}

fn row<const N: usize>(cells: [&str; N]) -> Vec<String> {
    cells.map(str::to_owned).to_vec()
}

/// A resultant that its joint does not hold without tension.
pub(crate) const OUTSIDE: &str = "OUTSIDE the joint";

/// What an empty field shows: room to write on.
const BLANK: &str = "";

/// Identification and revisions.
pub(crate) fn control(document: &ReportDocument, bridge: &str, appendix: &Appendix) -> Vec<Part> {
    let text = |value: &Option<String>| value.clone().unwrap_or_default();
    let rows = vec![
        row(["structure", bridge]),
        vec!["structure number".into(), text(&document.structure_number)],
        vec!["route".into(), text(&document.route)],
        vec!["location".into(), text(&document.location)],
        vec!["owner".into(), text(&document.owner)],
        vec!["purpose".into(), text(&document.purpose)],
        vec!["document number".into(), text(&document.number)],
        vec!["category of check".into(), text(&document.check_category)],
        row(["computed", &appendix.day]),
    ];
    let table = Part { id: Some("document"), title: "Document control", rows, ..Part::default() };
    let mut parts = vec![table];
    if !document.revisions.is_empty() {
        let revision = |one: &Revision| vec![one.revision.clone(), one.date.clone(), one.change.clone()];
        let rows = document.revisions.iter().map(revision).collect();
        let heads = vec!["revision", "date", "what changed"];
        parts.push(Part { title: "Revisions", heads, rows, ..Part::default() });
    }
    parts
}

/// Words by which remarks of a file say that a value was not measured.
const UNSURE: [&str; 8] =
    ["assum", "estimat", "typical", "unknown", "guess", "to be confirmed", "not measured", "as drawn"];

/// What is to be confirmed on site: what the file asks, and every value whose remark says that it was not measured.
pub(crate) fn to_confirm(document: &ReportDocument, inputs: &[Input], a: &Assessment) -> Part {
    let mut part = Part { id: Some("confirm"), title: "To be confirmed on site", ..Part::default() };
    part.heads = vec!["what", "as assessed", "why", "found on site", "initials, date"];
    let blank = || BLANK.to_owned();
    for words in &document.confirm {
        part.rows.push(vec![words.clone(), blank(), "asked for by the assessor".into(), blank(), blank()]);
    }
    for input in inputs {
        let remark = input.remark.to_lowercase();
        if UNSURE.iter().any(|word| remark.contains(word)) {
            part.paths.resize(part.rows.len(), String::new());
            part.paths.push(input.path());
            part.rows.push(vec![input.path(), input.value.clone(), input.remark.clone(), blank(), blank()]);
        }
    }
    for one in a.verdict.given.taken.iter().filter(|one| one.open) {
        part.rows.push(vec![one.to_string(), blank(), "not given by the file".into(), blank(), blank()]);
    }
    for (stage, warning) in a.facts.warnings_once() {
        if SITE.contains(&warning.code()) {
            part.rows.push(vec![warning.message(), blank(), format!("{}, {stage}", warning.code()), blank(), blank()]);
        }
    }
    if part.rows.is_empty() {
        part.heads.clear();
        part.words.push("The file asks for nothing, and no remark of it calls a value assumed or estimated.".into());
    } else {
        part.words.push(
            "What the assessor asks for, and every value whose remark in the file calls it assumed, estimated, typical or as drawn.".into(),
        );
    }
    part
}

/// Warnings that a visit can settle.
const SITE: [&str; 1] = [outcome::warning::ACROSS_ASSUMED];

/// What to do next, with the fact and the rule that each step follows from.
pub(crate) fn next_steps(a: &Assessment) -> Part {
    let mut part = Part { id: Some("next"), title: "What to do next", ..Part::default() };
    if a.next.is_empty() {
        part.words.push("No rule asks for anything: no strength is short, nothing that can grow is in the file, no warning points further.".into());
        return part;
    }
    part.words.push("By rule, each from the fact beside it; whoever signs decides.".into());
    part.heads = vec!["kind", "what", "because", "rule"];
    part.rows = a
        .next
        .iter()
        .map(|one| vec![one.action.to_string(), one.what.clone(), one.because.clone(), one.rule.clone()])
        .collect();
    part
}

/// Findings of inspections; a photograph that was not read is named.
pub(crate) fn inspections(list: &[Inspection], photographs: &[Photograph]) -> Option<Part> {
    if list.is_empty() {
        return None;
    }
    let mut part = Part { id: Some("inspection"), title: "Inspection findings", ..Part::default() };
    part.heads = vec!["date", "part", "finding", "photograph"];
    part.rows = list
        .iter()
        .map(|one| {
            let shown = match &one.photograph {
                None => "–".to_owned(),
                Some(name) => match photographs.iter().find(|photo| photo.file == *name) {
                    Some(Photograph { source: Ok(_), .. }) => name.clone(),
                    Some(Photograph { source: Err(why), .. }) => format!("{name}: {why}"),
                    None => format!("{name}: not read"),
                },
            };
            vec![one.date.clone().unwrap_or_else(|| "–".into()), one.part.clone(), one.finding.clone(), shown]
        })
        .collect();
    Some(part)
}

fn kilonewtons(value: f64) -> String {
    digits(1e-3 * value)
}

/// Dead-load totals, and reactions at rest.
pub(crate) fn statics(statics: &Statics) -> Vec<Part> {
    let mut weights = Part { id: Some("statics"), title: "Dead loads and reactions at rest", ..Part::default() };
    weights.words = outcome::note::words(&statics.assumptions);
    weights.heads = vec!["part", "per metre of width [kN/m]", "whole width [kN]"];
    weights.numbers = vec![false, true, true];
    let weight = |name: &str, force: f64| vec![name.to_owned(), kilonewtons(force), kilonewtons(force * statics.width)];
    weights.rows = statics.weights.iter().map(|one| weight(&one.part, one.force)).collect();
    weights.rows.push(weight("total", statics.total()));
    let mut apart = Part { title: "Not in the loads", ..Part::default() };
    apart.words.push(
        "What stands on the bridge, or may, and loads no strip of it: whoever signs decides whether that matters."
            .into(),
    );
    apart.heads = vec!["part", "whole bridge [kN]", "why not"];
    apart.numbers = vec![false, true, false];
    apart.rows = statics
        .apart
        .iter()
        .map(|one| vec![one.part.clone(), one.weight.map_or("not known".to_owned(), kilonewtons), one.why.clone()])
        .collect();
    let mut reactions = Part { title: "Springings and feet of piers at rest", ..Part::default() };
    reactions.heads = vec![
        "place",
        "vertical [kN/m]",
        "thrust [kN/m]",
        "vertical, whole width [kN]",
        "thrust, whole width [kN]",
        "eccentricity [mm]",
        "of the joint's depth [m]",
        "pressure [MPa]",
    ];
    reactions.numbers = vec![false, true, true, true, true, true, true, true];
    reactions.words.push(
        "Thrust is positive outwards from the span, at feet of piers to the right. Pressure is that of the part of the joint that is centred \
         on the resultant (depth less twice the eccentricity)."
            .into(),
    );
    reactions.rows = statics.reactions.iter().map(|one| reaction(one, statics.width)).collect();
    [weights, apart, reactions].into_iter().filter(|part| !part.rows.is_empty()).collect()
}

fn reaction(one: &Reaction, width: f64) -> Vec<String> {
    let scaled = |value: Option<f64>, scale: f64| maybe(value.map(|value| scale * value));
    vec![
        one.place.clone(),
        kilonewtons(one.vertical),
        kilonewtons(one.horizontal),
        kilonewtons(one.vertical * width),
        kilonewtons(one.horizontal * width),
        scaled(one.eccentricity, 1e3),
        scaled(one.depth, 1.0),
        scaled(one.pressure, 1e-6),
    ]
}

/// Where the train stands when the bridge answers most.
pub(crate) fn stands(facts: &ServiceFacts) -> Option<Part> {
    let mut part = Part { title: "Where the train stands", rows: standing(facts), ..Part::default() };
    part.words.push(
        "Where the first axle of the train stands when a place answers most, along the bridge from the left springing of the first span. At rest, \
         without dynamic augment, self-weight taken off; of several spans and faces the one that answers most."
            .into(),
    );
    part.heads = vec!["load", "place", "value", "first axle at [m]"];
    part.numbers = vec![false, false, true, true];
    (!part.rows.is_empty()).then_some(part)
}

/// Named cases side by side.
pub(crate) fn cases(a: &Assessment) -> Option<Part> {
    let facts = a.facts.cases.made()?;
    let mut part = Part { id: Some("cases"), title: "Named cases", ..Part::default() };
    part.words.push(
        "What all loads of a case may be multiplied by, where they stand, with its own factors on loads and weights."
            .into(),
    );
    part.heads = vec!["case", "factor", "ended", "method", "acts"];
    part.numbers = vec![false, true, false, false, false];
    part.rows = facts
        .cases
        .iter()
        .map(|one| {
            vec![one.name.clone(), maybe(one.load_factor), one.status.to_string(), one.method.clone(), one.acts.clone()]
        })
        .collect();
    Some(part)
}

/// How the width that carries each vehicle was found, and what springings and feet of piers carry under the governing one.
pub(crate) fn vehicles(a: &Assessment) -> Vec<Part> {
    let Some(facts) = a.facts.vehicles.made() else { return Vec::new() };
    let mut widths = Part { id: Some("widths"), title: "Effective widths", ..Part::default() };
    widths.heads = vec!["vehicles", "stand", "width that carries an axle [m]", "found as"];
    widths.numbers = vec![false, false, true, false];
    for one in &facts.vehicles {
        let told = [one.stands.clone(), digits(one.effective_width_m), one.effective_width_derivation.clone()];
        match widths.rows.iter_mut().find(|row| row[1..] == told) {
            Some(row) => row[0] += &format!(", {}", one.code),
            None => widths.rows.push([vec![one.code.clone()], told.to_vec()].concat()),
        }
    }
    let mut thrusts = Part { title: "Largest thrusts under the governing vehicle", ..Part::default() };
    thrusts.words.push(
        "Of elastic blocks whose joints open nowhere, with the rule's factors on loads and weights, each with the values that go with it. A \
         resultant outside its joint means that joints open there before. Pressure is that of the part of the joint that is centred on the \
         resultant: below a pier, what its foundation bears on."
            .into(),
    );
    thrusts.heads =
        vec!["joint", "thrust [kN/m]", "shear [kN/m]", "eccentricity [mm]", "depth [m]", "pressure [MPa]", "resultant"];
    thrusts.numbers = vec![false, true, true, true, true, true, false];
    thrusts.rows = facts
        .worst()
        .into_iter()
        .flat_map(|one| &one.thrusts)
        .map(|one| {
            let place = lies(one.eccentricity_m, one.depth_m, one.outside);
            let numbers = [one.thrust_kn_per_m, one.shear_kn_per_m, 1e3 * one.eccentricity_m, one.depth_m].map(digits);
            let pressure = pressure(a, one);
            [vec![one.place.clone()], numbers.to_vec(), vec![pressure, place.to_owned()]].concat()
        })
        .collect();
    [widths, thrusts].into_iter().filter(|part| !part.rows.is_empty()).collect()
}

/// Items for whoever checks this assessment, each with what it says and room for another number. A check of category III is made without
/// these numbers: they follow on a sheet of their own.
pub(crate) fn check_sheet(document: &ReportDocument, a: &Assessment, statics: Option<&Statics>) -> Vec<Part> {
    let mut part = Part { id: Some("check-sheet"), title: "Check sheet", ..Part::default() };
    let asked = document.check_category.as_deref().map(str::trim);
    let (category, who) = match asked {
        None => (
            String::new(),
            "For the checker: what this assessment says, and room for the number found independently, by hand or by another method.",
        ),
        Some("III" | "3") => (
            " Category of check: III.".to_owned(),
            "For a checker of another organisation, who has the survey and not these numbers: room for each number found independently. The numbers of \
             this assessment are on the sheet after this one, to be compared at the end.",
        ),
        Some(category) => (
            format!(" Category of check: {category}."),
            "For a checker who did not prepare it: what this assessment says, and room for the number found independently, by hand or by another method.",
        ),
    };
    part.words.push(format!("{who}{category}"));
    part.heads = vec!["no.", "item", "this assessment", "independent value", "method", "initials, date"];
    let items = items(a, statics);
    let withheld = matches!(asked, Some("III" | "3"));
    let numbered = |k: usize| (k + 1).to_string();
    let shown = |value: &str| if withheld { BLANK.to_owned() } else { value.to_owned() };
    part.rows = items
        .iter()
        .enumerate()
        .map(|(k, (item, value))| {
            vec![numbered(k), item.clone(), shown(value), BLANK.into(), BLANK.into(), BLANK.into()]
        })
        .collect();
    let mut parts = vec![part];
    if withheld {
        let mut numbers = Part { id: Some("check-numbers"), title: "Numbers of this assessment", ..Part::default() };
        numbers
            .words
            .push("For comparison after the independent check; of items that are lists, the report has them.".into());
        numbers.heads = vec!["no.", "item", "this assessment"];
        numbers.rows = items.into_iter().enumerate().map(|(k, (item, value))| vec![numbered(k), item, value]).collect();
        parts.push(numbers);
    }
    parts
}

/// What is to be checked, and what this assessment says of it.
fn items(a: &Assessment, statics: Option<&Statics>) -> Vec<(String, String)> {
    let mut items: Vec<(String, String)> = Vec::new();
    let mut put = |item: &str, value: String| items.push((item.to_owned(), value));
    put("dimensions and materials against survey and tests (Inputs)", "all values of the file".into());
    put("drawing against the site (The bridge as drawn)", "figures".into());
    if let Some(statics) = statics {
        put("dead load, by hand from areas and densities", format!("{} kN/m", kilonewtons(statics.total())));
        let up: f64 = statics.reactions.iter().filter(|one| one.seat != Seat::Carried).map(|one| one.vertical).sum();
        if up > 0.0 {
            put("sum of vertical reactions on the ground = dead load", format!("{} kN/m", kilonewtons(up)));
        }
    }
    let known = |factor: Option<f64>| factor.map_or_else(|| "not known".to_owned(), digits);
    if let Some(facts) = a.facts.vehicles.made() {
        put("rule, factors and their sources", facts.rule.clone());
        if let Some(one) = facts.worst() {
            put(&format!("axle loads and distances of {}", one.code), one.title.clone());
            let width = format!("{} m: {}", digits(one.effective_width_m), one.effective_width_derivation);
            put(&format!("effective width of {}", one.code), width);
            let factor = format!("{}, first axle at {} m", known(one.adequacy), maybe(one.position_m));
            put(&format!("least adequacy factor, {}", one.code), factor);
        }
    }
    if let Some(facts) = a.facts.ultimate.made() {
        put("factor on the loads of the file at collapse", known(facts.load_factor));
        let limit = facts.collapse.as_deref().and_then(|found| found.limit());
        if let Some((lower, upper)) = limit.and_then(|found| found.lower_bound.zip(found.upper_bound)) {
            put(
                "the same by two theorems: work of the mechanism as drawn, and equilibrium of the line of thrust as drawn",
                format!("at most {} kN/m, at least {} kN/m", kilonewtons(upper), kilonewtons(lower)),
            );
        }
    }
    for check in &a.checked {
        let worst = check.outcome.iter().flatten().map(|one| one.utilisation).fold(f64::NEG_INFINITY, f64::max);
        if worst.is_finite() {
            put(&format!("{} {}", check.code, check.title), format!("{} of the limit", percent(worst)));
        }
    }
    let mut codes: Vec<&str> = Vec::new();
    for (_, warning) in a.facts.warnings() {
        if !codes.contains(&warning.code()) {
            codes.push(warning.code());
        }
    }
    let codes = if codes.is_empty() { "none".into() } else { codes.join(", ") };
    put("each warning considered, and answered in writing", codes);
    put("assumptions agreed with the owner (Assumptions)", "list".into());
    put("verdict", a.verdict.head());
    items
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    #[test]
    fn blank_fields_are_there_to_write_on() {
        let parts = control(&ReportDocument::default(), "Bridge", &Appendix::default());
        assert_eq!(parts.len(), 1, "no revisions, and signatures stand on the first page");
        assert_eq!(parts[0].rows[1], ["structure number", ""]);
    }

    /// An assessment of which nothing was made.
    pub(crate) fn nothing() -> Assessment {
        use outcome::assessment::Facts;
        use outcome::checked::{Judgement, Rung, Strength, Verdict};
        let facts = Facts::default();
        let verdict = Verdict {
            status: Judgement::Undetermined,
            headline: Rung::NothingCompared,
            words: String::new(),
            finished: true,
            strength: Strength::default(),
            given: Default::default(),
            broken_by_rule: false,
            open: Vec::new(),
        };
        Assessment {
            bridge: "Bridge".into(),
            limits_source: None,
            facts,
            checked: Vec::new(),
            verdict,
            condition: Vec::new(),
            statics: None,
            next: Vec::new(),
        }
    }

    /// What follows is told with its fact and its rule, or that nothing does.
    #[test]
    fn next_steps_are_told_with_their_rule() {
        use outcome::assessment::{Action, Step};
        let mut a = nothing();
        assert!(next_steps(&a).rows.is_empty() && next_steps(&a).words[0].contains("No rule asks"));
        let step = Step { action: Action::Monitor, what: "cracks".into(), because: "two".into(), rule: "CIRIA".into() };
        a.next.push(step);
        assert_eq!(next_steps(&a).rows, [["monitor", "cracks", "two", "CIRIA"].map(str::to_owned).to_vec()]);
    }

    /// A checker of category III finds no number of ours on the sheet; they follow on one of their own.
    #[test]
    fn a_check_of_category_three_is_made_without_our_numbers() {
        let statics = Statics {
            weights: vec![outcome::statics::Weight { part: "rings".into(), force: 1e5 }],
            ..Statics::default()
        };
        let a = nothing();
        let of = |category: &str| {
            let document = ReportDocument { check_category: Some(category.into()), ..ReportDocument::default() };
            check_sheet(&document, &a, Some(&statics))
        };
        let (two, three) = (of("II"), of("III"));
        assert_eq!((two.len(), three.len()), (1, 2));
        assert!(two[0].rows.iter().any(|row| row[2].contains("100")), "{two:?}");
        assert!(three[0].rows.iter().all(|row| row[2].is_empty()));
        assert!(three[1].rows.iter().any(|row| row[2].contains("100")), "{three:?}");
    }

    #[test]
    fn a_photograph_is_shown_or_named() {
        let one = |file: &str| Inspection {
            date: None,
            part: "barrel".into(),
            finding: "crack".into(),
            photograph: Some(file.into()),
        };
        let list = [one("a.png"), one("b.gif"), one("c.jpg")];
        let photographs = [
            Photograph::new("a.png", "barrel: crack", b"\x89PNG\r\n"),
            Photograph::new("b.gif", "barrel: crack", b"GIF89a"),
        ];
        assert_eq!(photographs[0].source.as_deref(), Ok("data:image/png;base64,iVBORw0K"));
        let rows = inspections(&list, &photographs).unwrap().rows;
        let shown: Vec<&str> = rows.iter().map(|row| row[3].as_str()).collect();
        assert_eq!(shown, ["a.png", "b.gif: neither JPEG nor PNG", "c.jpg: not read"]);
        assert!(inspections(&[], &photographs).is_none());
    }
}
