//! The ranges over which `extrados vary` repeats an analysis; the paths are checked against the file itself.

use super::{Field, Kind, Section};
use crate::choice::{Choice, choice};
use crate::edit::Document;
use crate::findings::Findings;
use crate::tree::Table;
use crate::vary::{Request, Slip, Spread, find, settle, twice};

choice! {
    /// How the values of a range lie.
    enum Spacing {
        /// equal differences
        Linear = "linear",
        /// equal ratios; both ends of the same sign
        Geometric = "geometric",
    }
}

pub(crate) static VARY: Section = Section {
    path: "vary",
    doc: "A quantity of this file and the values that `extrados vary` gives it, one quantity at a time or in a grid. \
          Values are written as the quantity itself is, or relative to its own value: \"-5 %\", \"x0.5\".",
    fields: &[
        Field::new(
            "quantity",
            Kind::Text,
            "path of the quantity: sections and key with dots, [1] for the first of several",
            "joint.friction_angle",
        ),
        Field::new("values", Kind::Values, "the values, one after the other", "[\"30 deg\", \"35.6 deg\", \"40 deg\"]")
            .optional("given by `from`, `to` and `points`"),
        Field::new("from", Kind::Value, "first value of a range", "30 deg").optional("given by `values`"),
        Field::new("to", Kind::Value, "last value of a range", "40 deg").optional("given by `values`"),
        Field::new("points", Kind::Count, "number of values in a range, both ends included", "5")
            .at_least(2.0)
            .at_most(1000.0)
            .optional("given by `values`"),
        Field::new("spacing", Kind::Word(Spacing::WORDS), "how the values of a range are spaced", "linear")
            .default(Spacing::Linear.word()),
    ],
};

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
        (true, Some(key)) => {
            table.exclude(key, "`values`", findings);
            None
        }
        (true, None) => values?.map(Spread::List),
        (false, None) => {
            table.need("values", findings);
            None
        }
        (false, Some(_)) => {
            for key in ["from", "to", "points"].into_iter().filter(|key| !table.has(key)) {
                table.need(key, findings);
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
