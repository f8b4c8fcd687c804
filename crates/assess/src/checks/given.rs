//! By what the verdict is given: the rule of `[sweep]`, or the file's own factor; and what of it stands beside the verdict.

use crate::coverage::{self, Coverage};
use crate::evidence::Evidence;
use crate::record;
use outcome::given::{Doubt, Given, ModelFactor, Taken};

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
        to_confirm: coverage.as_ref().map_or_else(Vec::new, |found| found.to_confirm.clone()),
        skipped: a.facts.left_out(),
        load_cases_left_out: coverage.as_ref().map_or_else(Vec::new, |found| found.left_out.clone()),
        doubtful: doubtful(a),
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

/// What the file does not give and was taken, or takes otherwise than the rule.
fn taken(a: &Evidence) -> Vec<Taken> {
    let told = |what: String, how: &str, open| Taken { what, how: how.to_owned(), open };
    let mut list = Vec::new();
    let carriageway = a.bridge.carriageway.as_ref();
    let skewed = a.bridge.spans.iter().any(|span| span.skew != 0.0);
    if !skewed && carriageway.is_none_or(|asked| asked.skew.is_none()) {
        list.push(told("skew not given".to_owned(), "the bridge is taken as square", true));
    }
    if a.bridge.sweep.is_some() {
        let missing: Vec<&str> = [
            ("lanes", carriageway.is_some_and(|asked| asked.lanes.is_some())),
            ("edge_distance", carriageway.is_some_and(|asked| asked.edge_distance.is_some())),
        ]
        .into_iter()
        .filter(|(_, given)| !given)
        .map(|(key, _)| key)
        .collect();
        if !missing.is_empty() {
            let what = format!("{} not given", missing.join(" and "));
            list.push(told(what, "vehicles stand across the bridge as is usual (A182)", true));
        }
        list.extend(coverage::lanes_apart(&a.bridge));
        list.extend(coverage::less_braking(a));
    }
    if !a.bridge.from_library.is_empty() {
        let how = format!("its usual values, none of them measured: {}", a.bridge.from_library.join(", "));
        list.push(Taken { what: "materials of the library".to_owned(), how, open: false });
    }
    let included = a.asked.limits.load_factor_included;
    if a.asked.limits.adequacy_factor.is_some() && included != 1.0 {
        list.push(told(format!("loads of the file carry a factor of {included}"), "by load_factor_included", false));
    }
    if a.asked.limits.adequacy_factor.is_some() {
        let whole = a.bridge.loads.iter().filter(|load| load.whole_length);
        list.extend(whole.map(|load| {
            told(format!("{} on its whole length", load.name), "not shortened where that does more harm", false)
        }));
    }
    if let Some(source) = &a.asked.limits.skew_source {
        list.push(told(format!("skew confirmed by {source}"), "the model is square", false));
    }
    list
}
