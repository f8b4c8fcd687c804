//! Named cases, as far as they can be read: loads by their names, changes settled on the file itself.

use crate::case::Case;
use crate::edit::Document;
use crate::findings::Findings;
use crate::model::Load;
use crate::tree::{At, Table};
use crate::vary::{Request, Spread, find, settle};

/// What finds the errors of another text of the file, in a line each.
type Errors = fn(&str) -> Vec<String>;

/// Most cases of a file.
const MOST: usize = 200;

/// The cases of a file that can be read; `errors` are those of another text of the file.
pub(crate) fn cases(
    text: &str,
    file: &Table<'_>,
    loads: Option<&[Load]>,
    errors: Errors,
    findings: &mut Findings,
) -> Vec<Case> {
    if !file.has("case") {
        return Vec::new();
    }
    let mut names: Vec<String> = Vec::new();
    let tables = file.tables("case", findings);
    if tables.len() > MOST {
        let help = "write what many cases differ by as [[vary]]";
        findings.error(
            "B227",
            tables[MOST].range,
            format!("there are more than {MOST} cases"),
            "too many to compare",
            help,
        );
        return Vec::new();
    }
    let document = Document::parse(text);
    let mut read = |table: &Table<'_>, findings: &mut Findings| {
        let name: Option<At<String>> = table.read("name", findings);
        if let Some(At { value, range }) = &name {
            if value.trim().is_empty() || names.contains(value) {
                let help = "give every case a name of its own";
                findings.error(
                    "B227",
                    *range,
                    "two cases have the same name, or one has none",
                    "taken already, or empty",
                    help,
                );
            }
            names.push(value.clone());
        }
        case(table, name, loads, document.as_ref().map(|document| (document, errors)), findings)
    };
    tables.iter().filter_map(|table| read(table, findings)).collect()
}

fn case(
    table: &Table<'_>,
    name: Option<At<String>>,
    loads: Option<&[Load]>,
    whole: Option<(&Document, Errors)>,
    findings: &mut Findings,
) -> Option<Case> {
    let [masonry_weight, fill_weight, surfacing_weight] =
        ["masonry_weight", "fill_weight", "surfacing_weight"].map(|key| table.read::<f64>(key, findings));
    let acting = acting(table, loads, findings);
    let changes = table.all("change", findings, change);
    if let (Some((document, errors)), Some(changes)) = (whole, &changes) {
        super::vary::check(document, changes, findings);
        reads(document, changes, errors, findings);
    }
    Some(Case {
        name: name?.value,
        loads: acting?,
        masonry_weight: masonry_weight?,
        fill_weight: fill_weight?,
        surfacing_weight: surfacing_weight?,
        changes: changes?,
    })
}

/// Reports a case whose changed file cannot be used.
fn reads(document: &Document, changes: &[Request], errors: Errors, findings: &mut Findings) {
    let mut changed = document.clone();
    changed.remove("case");
    let Some(places) = changes.last().and_then(|change| change.places) else { return };
    for change in changes {
        let settled = find(&changed, &change.quantity).and_then(|quantity| settle(&quantity, &change.spread));
        // What cannot be settled has been reported.
        let Ok(settled) = settled else { return };
        let Some(value) = settled.values.first() else { return };
        if changed.set(&settled.path, &value.literal).is_err() {
            return;
        }
    }
    let errors = errors(&changed.text());
    if !errors.is_empty() && !findings.any_error() {
        let message = format!("the file cannot be used with what this case changes: {}", errors.join("; "));
        let help = "write the value as the quantity itself is written, or relative to it";
        findings.error("B227", places[1], message, "with this value", help);
    }
}

/// The loads that act; all of them where the case names none.
fn acting(table: &Table<'_>, loads: Option<&[Load]>, findings: &mut Findings) -> Option<Vec<(usize, f64)>> {
    if !table.has("load") {
        return Some((0..loads?.len()).map(|load| (load, 1.0)).collect());
    }
    let mut known: Vec<usize> = Vec::new();
    table.all("load", findings, |table, findings| {
        let name: Option<At<String>> = table.read("name", findings);
        let factor: Option<f64> = table.read("factor", findings);
        let (At { value, range }, factor, loads) = (name?, factor?, loads?);
        let of_the_name: Vec<usize> = (0..loads.len()).filter(|load| loads[*load].name == value).collect();
        match of_the_name[..] {
            [load] if !known.contains(&load) => {
                known.push(load);
                Some((load, factor))
            }
            [_] => findings.refuse(
                "B227",
                range,
                format!("the load `{value}` acts twice"),
                "named above",
                "give its factor once",
            ),
            _ => {
                let names: Vec<String> = loads.iter().map(|load| format!("\"{}\"", load.name)).collect();
                let message = format!("{} loads are called \"{value}\"", of_the_name.len());
                let help = format!("give each [[load]] a `name` of its own; the file has {}", names.join(", "));
                findings.refuse("B227", range, message, "one [[load]] of this name", help)
            }
        }
    })
}

fn change(table: &Table<'_>, findings: &mut Findings) -> Option<Request> {
    let quantity: Option<String> = table.read("quantity", findings);
    let value: Option<String> = table.read("value", findings);
    let places = Some([table.place("quantity"), table.place("value")]);
    Some(Request { quantity: quantity?, spread: Spread::List(vec![value?]), places })
}
