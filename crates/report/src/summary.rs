//! The first page: the verdict, what governs, what each vehicle comes to, and what could turn it.

use crate::assessed::Assessed;
use crate::figure::Figure;
use crate::numbers::percent;
use crate::rows::{self, ChangeRow, CheckRow, VehicleRow};
use findings::words::counted;
use outcome::assessment::Assessment;
use outcome::checked::worst;
use serde::Serialize;

/// Most vehicles on the first page.
const MOST_VEHICLES: usize = 8;
/// Most checks beside vehicles, and without them.
const MOST_CHECKS: [usize; 2] = [3, 9];
/// Most things that could turn the verdict, and the length of each.
const MOST_DOUBTS: usize = 7;
const MOST_LETTERS: usize = 170;
/// The same of places and cases.
const MOST_OF_PLACE: usize = 150;

/// What stands on the first page.
#[derive(Serialize)]
pub(crate) struct Summary {
    /// What governs, in a sentence; empty where nothing was compared.
    pub governs: String,
    /// Where and how.
    pub place: String,
    /// What the mechanism of the governing load does, where the drawing does not say it.
    pub mechanism: String,
    /// The bridge with its governing load.
    #[serde(skip)]
    pub figure: Option<Figure>,
    /// Vehicles, worst first.
    pub vehicles: Vec<VehicleRow>,
    /// How many more there are and what of them.
    pub more_vehicles: String,
    /// Grades: what they are of, and the highest.
    pub grades: Vec<String>,
    /// Checks other than those of vehicles.
    pub checks: Vec<CheckRow>,
    /// How many more there are.
    pub more_checks: String,
    /// Why a rule of thumb that is met does not count beside a mechanism that is not; empty where both say the same.
    pub rule_of_thumb: String,
    /// The first thing to do.
    pub next: String,
    /// What is missing or assumed that could turn the verdict.
    pub doubts: Vec<String>,
    /// How many more there are.
    pub more_doubts: String,
    /// Who signs: what for, and the name where it is given.
    pub signatures: [[String; 2]; 3],
}

/// The first page of an assessment; `changes` are its sensitivities.
pub(crate) fn summary(material: &Assessed, changes: &[ChangeRow]) -> Summary {
    let a = &material.assessment;
    let mut vehicles = a.facts.vehicles.made().map(rows::vehicles).unwrap_or_default();
    let left = vehicles.split_off(vehicles.len().min(MOST_VEHICLES));
    let short = left.iter().filter(|row| row.class == "broken").count();
    let more_vehicles = match (left.len(), short) {
        (0, _) => String::new(),
        (all, 0) => format!("and {} more, all carried", all),
        (all, some) => format!("and {all} more, {some} of them not carried"),
    };
    let mut checks = rows::worst(&a.checked);
    checks.retain(|row| vehicles.is_empty() || row.code != "C204");
    checks.sort_by(|one, other| other.utilisation.total_cmp(&one.utilisation));
    let most = MOST_CHECKS[usize::from(vehicles.is_empty())];
    let more = checks.split_off(checks.len().min(most));
    let broken = more.iter().filter(|row| !row.met).count();
    let more_checks = match (more.len(), broken) {
        (0, _) => String::new(),
        (all, 0) => format!("and {} more, all met", counted(all, "check")),
        (all, some) => format!("and {} more, {some} of them not met", counted(all, "check")),
    };
    let (governs, place) = match worst(&a.checked) {
        None => (String::new(), String::new()),
        Some((check, one)) => {
            let [value, limit] = outcome::checked::told_apart(one.value, one.limit);
            let unit = match one.unit.word() {
                "" => String::new(),
                unit => format!(" {unit}"),
            };
            let told = format!(
                "{} {}, {}: {value} where the limit is {limit}{unit}, {} of the limit used",
                check.code,
                check.title,
                one.load_model,
                percent(one.utilisation)
            );
            (told, clipped(&one.basis, MOST_OF_PLACE))
        }
    };
    let mut doubts = doubts(a, changes);
    let left = doubts.split_off(doubts.len().min(MOST_DOUBTS));
    let more_doubts =
        if left.is_empty() { String::new() } else { format!("and {} more, in the next sections", left.len()) };
    let figure = drawing(material);
    let name = |name: &Option<String>| name.clone().unwrap_or_default();
    let document = &material.document;
    let grade = |[what, highest, _]: &[String; 3]| format!("{what}: {highest}");
    Summary {
        governs,
        place,
        mechanism: figure
            .as_ref()
            .filter(|figure| figure.name == Figure::GOVERNING)
            .map(|figure| figure.caption.clone())
            .unwrap_or_default(),
        figure,
        vehicles,
        more_vehicles,
        grades: a.facts.vehicles.made().map(|facts| facts.grades.iter().map(grade).collect()).unwrap_or_default(),
        checks,
        more_checks,
        rule_of_thumb: rule_of_thumb(a),
        next: a.next.first().map(|one| format!("{}: {}", one.action, one.what)).unwrap_or_default(),
        doubts: doubts.iter().map(|words| clipped(words, MOST_LETTERS)).collect(),
        more_doubts,
        signatures: [
            ["assessed".to_owned(), name(&document.prepared_by)],
            ["checked".to_owned(), name(&document.checked_by)],
            ["approved".to_owned(), name(&document.approved_by)],
        ],
    }
}

/// Checks of a mechanism at collapse.
const OF_MECHANISMS: [&str; 2] = ["C201", "C204"];

/// Modified MEXE that is met beside a mechanism that carries too little.
fn rule_of_thumb(a: &Assessment) -> String {
    let of = |code: &'static str| {
        a.checked.iter().filter(move |check| check.code == code).flat_map(|check| check.outcome.iter().flatten())
    };
    let Some(mexe) = of("C301").find(|one| one.met()) else { return String::new() };
    let short = OF_MECHANISMS.iter().flat_map(|code| of(code)).filter(|one| !one.met());
    let Some(least) = short.max_by(|one, other| one.utilisation.total_cmp(&other.utilisation)) else {
        return String::new();
    };
    format!(
        "Modified MEXE is met ({} of its limit) where {} is not carried (factor {:.2}, {} is asked for): MEXE is a rule of thumb for the span, the \
         ring and the fill. It knows no vehicle, no defect, no separated ring and no skew, and allows too much on short spans. It does not count against \
         a mechanism.",
        percent(mexe.utilisation),
        least.load_model,
        least.value,
        least.limit
    )
}

/// The drawing of the load that governs at collapse; without one, the bridge as its file describes it.
fn drawing(material: &Assessed) -> Option<Figure> {
    let stage = match material.assessment.governing_stage() {
        Some("collapse") => "ultimate",
        Some(stage) => stage,
        None => "",
    };
    let find =
        |stage: &str, name: &str| material.figures.iter().find(|figure| figure.stage == stage && figure.name == name);
    // Where a limit in service governs, the mechanism at collapse is still what there is to see.
    let any = || ["vehicles", "ultimate"].iter().find_map(|stage| find(stage, Figure::GOVERNING));
    let governing = find(stage, Figure::GOVERNING).or_else(any);
    governing.cloned().or_else(|| {
        let built = find("built", "bridge")?;
        Some(Figure { stage: "summary".into(), ..built.clone() })
    })
}

/// What is missing or assumed that could turn the verdict, most important first.
fn doubts(a: &Assessment, changes: &[ChangeRow]) -> Vec<String> {
    let mut all: Vec<String> = a.verdict.strength.missing.iter().map(|words| format!("missing: {words}")).collect();
    let turns: Vec<String> = changes
        .iter()
        .filter(|row| row.turns)
        .map(|row| format!("{} ({}): {} to {}", row.path, row.value, row.less, row.more))
        .collect();
    if let (false, Some(facts)) = (turns.is_empty(), a.facts.sensitivity.made()) {
        let share = 100.0 * facts.share;
        all.push(format!("{share:.0} % less or more turns the verdict; limit used with {}", turns.join(", ")));
    } else if let (Some(row), Some(facts)) = (changes.first(), a.facts.sensitivity.made()) {
        let share = 100.0 * facts.share;
        let told = format!("{} ({}): {} to {}", row.path, row.value, row.less, row.more);
        all.push(format!(
            "no quantity turns it by {share:.0} % less or more; limit used with the most telling, {told}"
        ));
    }
    all.extend(a.verdict.beside().into_iter().filter(|words| !words.starts_with("record:")));
    if !a.verdict.strength.qualifications.is_empty() {
        all.push(format!("the analyses warn of: {}", a.verdict.strength.qualifications.join(", ")));
    }
    all
}

/// Words of at most so many letters, cut between two words.
fn clipped(words: &str, most: usize) -> String {
    if words.chars().count() <= most {
        return words.to_owned();
    }
    let cut: String = words.chars().take(most).collect();
    let end = cut.rfind(' ').unwrap_or(cut.len());
    format!("{} …", cut[..end].trim_end_matches([',', ';', ':']))
}
