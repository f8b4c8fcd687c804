//! The ranges over which `extrados vary` repeats an analysis; the paths are checked against the file itself.

use crate::edit::Document;
use crate::fields::vary::Spacing;
use crate::findings::Findings;
use crate::tree::Table;
use crate::vary::{Request, Slip, Spread, find, settle, twice};

/// Requests whose paths are looked up while reading, which must end at once whatever the file is; `extrados vary` looks
/// at all of them.
const MOST_LOOKED_UP: usize = 200;

/// The requests of a file, as far as they can be read.
pub(crate) fn vary(file: &Table<'_>, findings: &mut Findings) -> Vec<Request> {
    file.tables("vary", findings).iter().filter_map(|table| request(table, findings)).collect()
}

fn request(table: &Table<'_>, findings: &mut Findings) -> Option<Request> {
    let quantity: Option<String> = table.read("quantity", findings);
    let values: Option<Option<Vec<String>>> = table.read("values", findings);
    let [from, to] = ["from", "to"].map(|key| table.read::<Option<String>>(key, findings));
    let points: Option<Option<u64>> = table.read("points", findings);
    let spacing = table.read("spacing", findings);
    let keys = ["from", "to", "points", "spacing"];
    let range = keys.into_iter().find(|key| table.has(key));
    let spread = match (table.has("values"), range) {
        (true, Some(key)) => table.exclude(key, "`values`", findings),
        (true, None) => values?.map(Spread::List),
        (false, None) => table.need("values", findings),
        (false, Some(_)) => {
            for key in ["from", "to", "points"].into_iter().filter(|key| !table.has(key)) {
                table.need::<()>(key, findings);
            }
            let geometric = match spacing? {
                Spacing::Linear => false,
                Spacing::Geometric => true,
            };
            Some(Spread::Range { from: from??, to: to??, points: points??, geometric })
        }
    };
    let values = if table.has("values") { "values" } else { "to" };
    let places = Some([table.place("quantity"), table.place(values)]);
    Some(Request { quantity: quantity?, spread: spread?, places })
}

/// Whether every request leads to a quantity of the file and to values of it.
pub(crate) fn check(document: &Document, requests: &[Request], findings: &mut Findings) {
    let mut paths = Vec::new();
    for (number, request) in requests.iter().enumerate().take(MOST_LOOKED_UP) {
        match find(document, &request.quantity) {
            Ok(quantity) => {
                paths.push((number, quantity.path.to_string()));
                if let Err(slip) = settle(&quantity, &request.spread) {
                    report(request, slip, findings);
                }
            }
            Err(slip) => report(request, slip, findings),
        }
    }
    for (number, slip) in twice(&paths) {
        report(&requests[number], slip, findings);
    }
}

fn report(request: &Request, slip: Slip, findings: &mut Findings) {
    let Some(places) = request.places else { return };
    findings.error(slip.code, places[usize::from(slip.of_values)], slip.message, slip.label, slip.help);
}
