//! The report of one bridge.

use crate::assessed::Assessed;
use crate::figure::Figure;
use crate::left_out;
use crate::numbers::{digits, percent, with_unit};
use crate::parts::{self, Part};
use crate::rows::{
    self, ChangeRow, ChannelRow, CheckRow, ColumnRow, ConditionRow, EveryRow, FitRow, OpenRow, ReadingRow, VehicleRow,
};
use crate::springings::springings;
use crate::summary::{self, Summary};
use askama::Template;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use bridge::inputs::Input;
use outcome::assessment::Assessment;
use outcome::checked::worst;
use outcome::collapse::Collapse;
use serde::{Serialize, Serializer};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fmt;

/// A photograph of an inspection.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Photograph {
    /// Its file, as the bridge file names it.
    pub file: String,
    /// What it shows.
    pub caption: String,
    /// The picture as a data address; or why it cannot be shown.
    pub source: Result<String, String>,
}

impl Photograph {
    /// A photograph from its bytes: JPEG or PNG.
    pub fn new(file: &str, caption: &str, bytes: &[u8]) -> Photograph {
        let media = match bytes {
            [0xff, 0xd8, 0xff, ..] => Ok("image/jpeg"),
            [0x89, b'P', b'N', b'G', ..] => Ok("image/png"),
            _ => Err("neither JPEG nor PNG".to_owned()),
        };
        let source = media.map(|media| format!("data:{media};base64,{}", STANDARD.encode(bytes)));
        Photograph { file: file.to_owned(), caption: caption.to_owned(), source }
    }
}

/// How every number can be made again.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
pub struct Appendix {
    /// Version of the program.
    pub version: String,
    /// Hash of the program's bytes.
    pub program: String,
    /// The bridge file.
    pub file: String,
    /// Hash of its bytes.
    pub input: String,
    /// The command line.
    pub command: String,
    /// The day, as year-month-day.
    pub day: String,
    /// Stages.
    pub stages: Vec<StageLine>,
}

/// A stage in the appendix.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
pub struct StageLine {
    /// Its name.
    pub name: String,
    /// What became of it.
    pub state: StageState,
    /// How long it took when it was made.
    pub seconds: String,
    /// Hash of its inputs.
    pub key: String,
}

/// What became of a stage.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub enum StageState {
    /// It was made.
    #[default]
    Made,
    /// An earlier run had made it.
    TakenUp,
    /// It was asked for and has no result.
    Failed(String),
    /// The file does not ask for it.
    NotAsked(String),
    /// The file asks for it and the command leaves it out.
    LeftOut(String),
}

impl fmt::Display for StageState {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            StageState::Made => write!(f, "made"),
            StageState::TakenUp => write!(f, "taken from an earlier run"),
            StageState::Failed(why) => write!(f, "failed: {why}"),
            StageState::NotAsked(why) => write!(f, "not asked for: {why}"),
            StageState::LeftOut(why) => write!(f, "{why}"),
        }
    }
}

impl Serialize for StageState {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_str(self)
    }
}

/// Every string of a report, by section.
#[derive(Template, Serialize)]
#[template(path = "report.html")]
pub(crate) struct Page<'a> {
    #[serde(skip)]
    pub style: &'static str,
    /// The bridge's name as a string of a style sheet.
    #[serde(skip)]
    pub running: String,
    pub summary: Summary,
    pub left_out: Vec<Part>,
    pub bridge: &'a str,
    pub status: &'static str,
    pub headline: String,
    pub whole: String,
    pub missing: &'a [String],
    pub beside: Vec<String>,
    pub qualifications: &'a [String],
    pub checks: Vec<CheckRow>,
    pub every: Vec<CheckRow>,
    #[serde(skip)]
    pub by_check: Vec<EveryRow>,
    pub open: Vec<OpenRow>,
    pub columns: Vec<ColumnRow>,
    pub augment: String,
    pub limits_source: String,
    pub condition: Vec<ConditionRow>,
    pub update_words: Vec<String>,
    pub fit: Vec<FitRow>,
    pub readings: Vec<ReadingRow>,
    pub runs: Vec<String>,
    pub channels: Vec<ChannelRow>,
    pub stands: Vec<Part>,
    pub loads: Vec<[String; 4]>,
    pub collapse: Vec<[String; 2]>,
    pub vehicles: Vec<VehicleRow>,
    pub grades: Vec<[String; 3]>,
    pub rule: String,
    pub factors: Vec<[String; 3]>,
    pub discrete_elements: String,
    pub movement: Vec<[String; 2]>,
    pub changes: Vec<ChangeRow>,
    pub changes_words: String,
    pub findings: Vec<[String; 3]>,
    pub warnings: Vec<[String; 3]>,
    pub assumptions: Vec<[String; 2]>,
    pub inputs: &'a [Input],
    pub inputs_words: String,
    pub appendix: &'a Appendix,
    pub front: Vec<Part>,
    pub cases: Vec<Part>,
    pub numbers: Vec<Part>,
    pub back: Vec<Part>,
    #[serde(skip)]
    pub photographs: &'a [Photograph],
    #[serde(skip)]
    pub figures: &'a [Figure],
}

/// Sections with drawings; those of a stage without a section stand in the one of collapse, "ultimate".
const DRAWN: [&str; 7] = ["built", "update", "service", "ultimate", "vehicles", "movement", "cases"];

impl Page<'_> {
    /// Assumptions under the stages that make them.
    fn assumed(&self) -> Vec<(&str, Vec<&str>)> {
        let same = self.assumptions.chunk_by(|one, next| one[0] == next[0]);
        same.filter_map(|list| Some((list.first()?[0].as_str(), list.iter().map(|one| one[1].as_str()).collect())))
            .collect()
    }

    /// Whether there is a chapter of collapse.
    fn has_collapse(&self) -> bool {
        !(self.collapse.is_empty() && self.vehicles.is_empty() && self.movement.is_empty())
    }

    /// The drawings of a section.
    fn drawn(&self, section: &str) -> Vec<&Figure> {
        let of = |figure: &Figure| DRAWN.iter().find(|known| **known == figure.stage).unwrap_or(&DRAWN[3]);
        self.figures.iter().filter(|figure| *of(figure) == section && figure.name != Figure::GOVERNING).collect()
    }
}

impl Assessed {
    /// The report as one self-contained page.
    pub fn html(&self) -> String {
        // Writing to a text never fails.
        page(self).render().unwrap_or_default()
    }

    /// Every string of the page as data, by the names that the page has for them, and its drawings as they were made: for typesetters other
    /// than a browser.
    pub fn data(&self) -> Value {
        let page = page(self);
        let mut data = json!(page);
        data["figures"] =
            json!(DRAWN.iter().map(|section| (*section, page.drawn(section))).collect::<BTreeMap<_, _>>());
        data["figures"]["summary"] = json!(page.summary.figure.iter().collect::<Vec<_>>());
        data
    }
}

/// Every string of the page.
fn page(material: &Assessed) -> Page<'_> {
    let a = &material.assessment;
    let (warnings, assumptions) = rows::said(a);
    let update = a.facts.update.made();
    let sensitivity = a.facts.sensitivity.made();
    let changes = sensitivity.map(rows::changes).unwrap_or_default();
    let open = rows::open(&a.checked);
    let vehicles = a.facts.vehicles.made().map(rows::vehicles).unwrap_or_default();
    Page {
        style: include_str!("../templates/style.css"),
        running: in_style(&a.bridge),
        summary: summary::summary(material, &changes),
        left_out: left_out::left_out(a, &open),
        bridge: &a.bridge,
        status: a.verdict.status.word(),
        headline: a.verdict.head(),
        // A number and its sign of per cent stay on one line.
        whole: a.verdict.words.replace(" %", "\u{a0}%"),
        missing: &a.verdict.strength.missing,
        beside: a.verdict.beside(),
        qualifications: &a.verdict.strength.qualifications,
        checks: rows::worst(&a.checked),
        every: rows::checks(&a.checked),
        by_check: rows::by_check(rows::checks(&a.checked), &vehicles),
        open,
        columns: rows::columns(&a.checked),
        augment: augment(a),
        limits_source: a.limits_source.clone().unwrap_or_else(|| "those of the rule; for others that the file sets it names no source.".to_owned()),
        condition: rows::condition(&a.condition, update, &material.inputs),
        update_words: update.map(rows::updated).unwrap_or_default(),
        fit: update.map(|update| rows::fit(update, &material.inputs)).unwrap_or_default(),
        readings: update.map(|update| rows::readings(update, &material.inputs)).unwrap_or_default(),
        runs: update.map(|update| update.records.runs.iter().map(|run| match run.synthetic {
            Some(_) => format!("{}: SYNTHETIC, computed and not measured", run.name),
            None => format!("{}: measured", run.name),
        }).collect()).unwrap_or_default(),
        channels: a.facts.service.made().map(|facts| rows::channels(facts, &material.inputs)).unwrap_or_default(),
        stands: a.facts.service.made().and_then(parts::stands).into_iter().collect(),
        loads: a.facts.service.made().map(|facts| facts.loads.iter().map(|load| [
            load.name.clone(),
            format!("{} t", digits(load.heaviest_axle_t)),
            load.status.to_string(),
            load.source.clone().unwrap_or_else(|| "the file names no source".to_owned()),
        ]).collect()).unwrap_or_default(),
        collapse: collapse(a),
        vehicles,
        grades: a.facts.vehicles.made().map(|facts| facts.grades.clone()).unwrap_or_default(),
        rule: a.facts.vehicles.made().map(|facts| facts.rule.clone()).unwrap_or_default(),
        factors: a.facts.vehicles.made().map(|facts| facts.factors.clone()).unwrap_or_default(),
        discrete_elements: a.facts.vehicles.made().and_then(|facts| facts.discrete_elements.clone()).unwrap_or_default(),
        movement: movement(a),
        changes,
        changes_words: sensitivity.map(|facts| format!(
            "Utilisation of the governing check ({}) with {:.0} % less and {:.0} % more of each quantity, by {}. All rows are of the same \
             analysis at the same positions; with the file's own values it gives {}, the check itself {}. Where the two differ, the check \
             {}: compare the rows with the first of the two.",
            facts.code, 100.0 * facts.share, 100.0 * facts.share, facts.how, percent(facts.utilisation),
            worst(&a.checked).map_or_else(|| "nothing".to_owned(), |(_, finding)| percent(finding.utilisation)),
            match facts.code.as_str() {
                "C204" => "counts discrete elements, which carry less than limit analysis",
                _ => "saw what the shortened analysis leaves out (earlier axles, other positions)",
            }
        )).unwrap_or_default(),
        findings: rows::found(&material.findings),
        warnings,
        assumptions,
        inputs: &material.inputs,
        inputs_words: inputs_words(&material.inputs),
        appendix: &material.appendix,
        front: parts::control(&material.document, &a.bridge, &material.appendix)
            .into_iter()
            .chain([parts::next_steps(a), parts::to_confirm(&material.document, &material.inputs, a)])
            .chain(parts::inspections(&material.document.inspections, &material.photographs))
            .collect(),
        cases: parts::cases(a).into_iter().collect(),
        numbers: springings(a).into_iter().chain(a.statics.iter().flat_map(parts::statics)).chain(parts::vehicles(a)).collect(),
        back: parts::check_sheet(&material.document, a, a.statics.as_ref()),
        photographs: &material.photographs,
        figures: &material.figures,
    }
}

/// What the table of inputs is, and how many of its values have no source.
fn inputs_words(inputs: &[Input]) -> String {
    let without = inputs.iter().filter(|input| input.remark.is_empty()).count();
    let told = match without {
        0 => "Each has one.".to_owned(),
        n => format!("{n} of {} have none.", inputs.len()),
    };
    format!(
        "Every value that the file gives, with the source or remark that stands beside it there. {told} What the file leaves out has the default of \
         the input reference."
    )
}

/// Coefficients of spans that differ from those of the longest.
fn of_spans(augment: &outcome::facts::AugmentFacts) -> String {
    let others = augment.spans.iter().filter(|one| one.loaded_length_m != augment.loaded_length_m);
    let told: Vec<String> = others
        .map(|one| {
            format!("span {} ({} m): {:.3} and {:.3}", one.span, digits(one.loaded_length_m), one.total, one.design)
        })
        .collect();
    if told.is_empty() { String::new() } else { format!("; {}", told.join(", ")) }
}

fn augment(a: &Assessment) -> String {
    let Some(facts) = a.facts.service.made() else { return String::new() };
    let augment = &facts.augment;
    format!(
        "Train: {}. Live load is increased by the coefficient of dynamic augment (CDA): {:.3} in total for a loaded length of {} m, {:.3} \
         by design with a cushion of {} m{}. Source: {}.",
        facts.train,
        augment.total,
        digits(augment.loaded_length_m),
        augment.design,
        digits(augment.cushion_m),
        of_spans(augment),
        augment.source
    )
}

fn collapse(a: &Assessment) -> Vec<[String; 2]> {
    let Some(facts) = a.facts.ultimate.made() else { return Vec::new() };
    let mut rows = vec![
        ["loads".to_owned(), facts.load.clone()],
        ["method".to_owned(), facts.method.clone()],
        ["ended".to_owned(), facts.status.to_string()],
    ];
    let mut put = |what: &str, value: Option<f64>, unit: &str| rows.extend(measured(what, value, unit));
    put("factor on the loads of the file", facts.load_factor, "");
    put("factor on the loads of the file, at most", facts.load_factor_at_most, "");
    if facts.positions_not_converged > 0 {
        put("positions without a result", Some(facts.positions_not_converged as f64), "");
    }
    put("worst position of the first load or axle", facts.position_m, "m");
    let load = |of: fn(&Collapse) -> Option<f64>| Some(of(facts.collapse.as_deref()?)? / 1e3);
    put("load carried there, per metre of width", load(|found| found.last_stable_load), "kN/m");
    put("load at collapse there, per metre of width", load(|found| found.collapse_load), "kN/m");
    put("loads of the file, per metre of width", Some(facts.reference_load_kn_per_m), "kN/m");
    rows
}

fn movement(a: &Assessment) -> Vec<[String; 2]> {
    let Some(facts) = a.facts.movement.made() else { return Vec::new() };
    let told = [["support".to_owned(), facts.support.clone()], ["ended".to_owned(), facts.status.to_string()]];
    let stood = measured("last movement at which the bridge stood", facts.last_stable_mm, "mm");
    let fell = a.facts.moved().and_then(|found| found.support()?.collapse).map(|moved| 1e3 * moved);
    let fell = measured("movement at which it fell", fell, "mm");
    told.into_iter().chain(stood).chain(fell).collect()
}

/// A value by its name, where there is one.
fn measured(what: &str, value: Option<f64>, unit: &str) -> Option<[String; 2]> {
    value.map(|value| [what.to_owned(), with_unit(value, unit)])
}

/// A text inside a string of a style sheet: what is no letter, digit or space is written by its number.
fn in_style(text: &str) -> String {
    let one = |c: char| match c {
        c if c.is_ascii_alphanumeric() || c == ' ' => c.to_string(),
        c => format!("\\{:x} ", u32::from(c)),
    };
    text.chars().map(one).collect()
}
