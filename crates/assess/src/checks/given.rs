//! By what the verdict is given: the rule of `[sweep]`, or the file's own factor; and what of it stands beside the verdict.

use crate::coverage::{self, Coverage};
use crate::evidence::Evidence;
use crate::record;
use crate::vehicles::chosen;
use findings::words::counted;
use outcome::given::{Doubt, Given, ModelFactor, Taken};
use outcome::vehicles::Graded;

/// Reads it off the evidence; none of it changes the rung.
pub(super) fn given(a: &Evidence) -> Given {
    let limits = &a.asked.limits;
    let coverage = coverage::of(a);
    let named = match (&coverage, limits.adequacy_factor) {
        (Some(found), _) => Some((found.code.clone(), found.name.clone())),
        (None, Some(factor)) => Some(("file".to_owned(), by_file(factor, limits.adequacy_source.as_deref()))),
        (None, None) => None,
    };
    let (by, name) = named.map_or((None, String::new()), |(by, name)| (Some(by), name));
    Given {
        name,
        level: coverage.as_ref().and_then(|found| found.level.clone()),
        carried: carried(a),
        to_confirm: coverage.as_ref().map_or_else(Vec::new, |found| found.to_confirm.clone()),
        skipped: a.facts.left_out(),
        load_cases_left_out: coverage.as_ref().map_or_else(Vec::new, |found| found.left_out.clone()),
        doubtful: doubtful(a),
        assumed: a.assumed.clone(),
        changed_factors: a.facts.vehicles.made().map_or_else(Vec::new, |facts| facts.safety.changed_factors.clone()),
        taken: taken(a),
        model_factor: by.as_ref().and_then(|_| in_force(a, coverage.as_ref())),
        record: by.as_ref().and_then(|_| record::record()),
        by,
    }
}

/// The file's own factor, with the source that it names.
fn by_file(factor: f64, source: Option<&str>) -> String {
    match source {
        Some(source) => format!("the file's factor {factor} ({source})"),
        None => format!("the file's factor {factor} (no source named)"),
    }
}

/// The model factor in force: what the file sets, or that of the tests where its factors are the engineer's own.
pub(super) fn in_force(a: &Evidence, coverage: Option<&Coverage>) -> Option<ModelFactor> {
    let limits = &a.asked.limits;
    let of_tests = || ModelFactor { value: record::model_factor(), source: record::words() };
    let of_file = |value| ModelFactor {
        value,
        source: limits
            .adequacy_source
            .clone()
            .unwrap_or_else(|| "model_factor of the file, which names no source".into()),
    };
    if limits.model_factor_of_tests {
        return Some(of_tests());
    }
    // The factor of [assess] and its model factor act on the loads of the file; a standard's own covers its method.
    if limits.adequacy_factor.is_some() {
        return Some(limits.model_factor.map_or_else(of_tests, of_file));
    }
    let own = coverage.filter(|rule| !rule.library)?;
    (!own.model_is_sourced).then(of_tests)
}

/// Doubtful values of the bridge file, and of the files of its vehicles and of its rule.
fn doubtful(a: &Evidence) -> Vec<Doubt> {
    let of_files = a.facts.vehicles.made().into_iter().flat_map(|facts| &facts.doubtful);
    let told = of_files
        .map(|one| Doubt { code: one.code.clone(), message: format!("{} of {}: {}", one.at, one.file, one.told) });
    a.doubts.iter().cloned().chain(told).collect()
}

/// What is carried of the grades that were asked for, where one is not: of several scales with what each is of.
fn carried(a: &Evidence) -> Option<String> {
    let graded = &a.facts.vehicles.made()?.graded;
    let short = |one: &&Graded| !one.not_carried.is_empty() && one.unanswered.is_empty();
    let told = graded.iter().filter(short).map(|one| match graded.len() {
        1 => one.told(),
        _ => format!("{} of {}", one.told(), one.of),
    });
    let told: Vec<String> = told.collect();
    (!told.is_empty()).then(|| told.join(", "))
}

/// Whether the bridge is taken as square because nobody says that it is.
pub(super) fn square(a: &Evidence) -> bool {
    let carriageway = a.bridge.carriageway.as_ref();
    a.bridge.spans.iter().all(|span| span.skew == 0.0) && carriageway.is_none_or(|asked| asked.skew.is_none())
}

/// What the file does not give and was taken, or takes otherwise than the rule.
fn taken(a: &Evidence) -> Vec<Taken> {
    let told = |what: String, how: &str| Taken { what, how: how.to_owned(), ..Taken::default() };
    let mut list = Vec::new();
    let carriageway = a.bridge.carriageway.as_ref();
    if square(a) {
        list.push(Taken {
            what: "skew not given, taken as square".to_owned(),
            how: "the verdict holds for a square barrel alone: a skew one carries otherwise, and may carry less"
                .to_owned(),
            write: "skew in [carriageway], or in each [[span]]; 0 for a square bridge".to_owned(),
            open: true,
        });
    }
    if a.bridge.sweep.is_some() {
        let given = |of: fn(&bridge::Carriageway) -> bool| carriageway.is_some_and(of);
        let lanes = given(|asked| asked.lanes.is_some());
        let edge = given(|asked| asked.edge_distance.is_some());
        let missing = match (lanes, edge) {
            (true, true) => None,
            (false, true) => Some(("how many stand abreast", "lanes")),
            (true, false) => Some(("distance from the edge", "edge_distance")),
            (false, false) => Some(("place across", "lanes and edge_distance")),
        };
        if let Some((what, keys)) = missing {
            list.push(Taken {
                what: format!("{what} not given, taken as usual"),
                how: "vehicles that stand nearer to the edge, or more of them abreast, have less width to carry them (A182)".to_owned(),
                write: format!("{keys} in [carriageway]"),
                open: true,
            });
        }
        list.extend(coverage::lanes_apart(&a.bridge));
        list.extend(coverage::less_braking(a));
    }
    list.extend(condition(a));
    if !a.bridge.from_library.is_empty() {
        let how = format!("its usual values, none of them measured: {}", a.bridge.from_library.join(", "));
        list.push(told("materials of the library".to_owned(), &how));
    }
    let included = a.asked.limits.load_factor_included;
    if a.asked.limits.adequacy_factor.is_some() && included != 1.0 {
        list.push(told(format!("loads of the file carry a factor of {included}"), "by load_factor_included"));
    }
    if a.asked.limits.adequacy_factor.is_some() {
        let whole = a.bridge.loads.iter().filter(|load| load.whole_length);
        list.extend(
            whole.map(|load| {
                told(format!("{} on its whole length", load.name), "not shortened where that does more harm")
            }),
        );
    }
    if let Some(source) = &a.asked.limits.skew_source {
        list.push(told(format!("skew confirmed by {source}"), "the model is square"));
    }
    list
}

/// A condition factor of 1 on a barrel of which the file tells cracks or defects: what of them counts in another way.
fn condition(a: &Evidence) -> Option<Taken> {
    let cracks = a.bridge.carriageway.as_ref().map_or(0, |asked| asked.cracks.len());
    let defects = a.bridge.spans.iter().map(|span| span.defects.len()).sum();
    let rule = a.bridge.sweep.as_ref().and_then(|plan| chosen(&a.bridge, plan).ok());
    let whole: Vec<&str> = [
        (rule.is_some_and(|(rule, _)| rule.factors.condition.value >= 1.0), "the rule"),
        (a.asked.mexe.as_ref().is_some_and(|mexe| mexe.condition_factor >= 1.0), "MEXE"),
    ]
    .into_iter()
    .filter_map(|(is_one, what)| is_one.then_some(what))
    .collect();
    if whole.is_empty() || cracks + defects == 0 {
        return None;
    }
    let found = [(cracks, "longitudinal crack"), (defects, "ring defect")].into_iter().filter(|(count, _)| *count > 0);
    let found: Vec<String> = found.map(|(count, what)| counted(count, what)).collect();
    let how = format!(
        "the file tells of {}; cracks bound the width that carries a vehicle and defects are taken out of the rings, and nothing else is taken off",
        found.join(" and ")
    );
    Some(Taken { what: format!("condition factor 1 by {}", whole.join(" and ")), how, ..Taken::default() })
}
