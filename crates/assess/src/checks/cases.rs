//! Named cases at ultimate.

use super::by_file;
use super::check::{Check, Probe, limit, of, unless_empty};
use crate::evidence::Evidence;
use outcome::checked::{Comparison, NotMade};

/// The check.
pub(super) const CHECK: Check = Check {
    code: "C206",
    keys: ["case", "assess.adequacy_factor"],
    title: "named cases",
    clause: "factor on the loads of each [[case]] at collapse",
    text: "Each [[case]] of the file is analysed as the file plans, with its loads where they stand, its factors on loads and weights and \
           its changed values. What all its loads may be multiplied by is compared with adequacy_factor of [assess]. Factors of a case \
           are the file's own: the check assesses strength as C201 does, with the source of the factor and the model factor, never by \
           the factors that a case names for itself. Loads are not moved: a case that is worse elsewhere is another case.",
    source: "combinations of actions: EN 1990, 6.4; the factor: plastic theory of masonry arches, Heyman (1969)",
    probe: Probe::Whole,
    run,
};

fn run(a: &Evidence) -> Result<Vec<Comparison>, NotMade> {
    let limit = limit(a.asked.limits.adequacy_factor, "adequacy_factor = …", "from the rule that you assess by")?;
    let facts = of(&a.facts.cases)?;
    let mut list = Vec::new();
    for case in &facts.cases {
        let made = (case.load_factor, case.status);
        let found = by_file::compared(a, limit, &case.name, made, &format!("case {}", case.name))?;
        list.extend(found.map(|found| Comparison { basis: format!("{}; {}", case.method, case.acts), ..found }));
    }
    unless_empty(list, "no case becomes a mechanism: every factor is unbounded")
}
