//! The answer of model updating in an engineer's words.

use findings::words::counted;
use outcome::update::{UncertaintyFrom, Update, UpdateStatus};
use std::fmt::Write;

/// Parameters, channels, searches beside one another, what the records tell, what was found in them.
pub(crate) fn update(found: &Update, out: &str) -> String {
    let crossed = (!found.times.is_empty()).then(|| format!("the passage of {}", found.train));
    let stood = (!found.read_at_rest.is_empty()).then(|| "readings of loads at rest".to_owned());
    let by: Vec<String> = crossed.into_iter().chain(stood).collect();
    let mut page = format!("{}: updated by {}\n\n", found.bridge, by.join(" and "));
    if found.status == UpdateStatus::NotConverged {
        let _ = writeln!(page, "  NOT CONVERGED: {}\n", found.reason.as_deref().unwrap_or("a search found no end"));
    }
    for run in found.records.runs.iter().filter(|run| run.synthetic.is_some()) {
        let _ = writeln!(page, "  SYNTHETIC RECORDS, computed and not measured: run {}\n", run.name);
    }
    parameters(&mut page, found);
    channels(&mut page, found);
    searches(&mut page, found);
    sweeps(&mut page, found);
    told(&mut page, found);
    list(&mut page, "Found in the records", found.records.findings.iter().map(outcome::records::Finding::words));
    let done = found.records.done.iter().map(|done| format!("{} {}: {}", done.run, done.channel, done.what));
    list(&mut page, "Done to the records", done);
    list(&mut page, "This assumes", found.assumptions.iter().map(ToString::to_string));
    let _ = writeln!(page, "\nResults are in {out}");
    page
}

fn parameters(page: &mut String, found: &Update) {
    let Some(best) = found.found() else { return };
    let start = found.basis.as_ref().map_or(f64::NAN, |basis| basis.start.norm);
    let _ = writeln!(
        page,
        "  norm {:.4}, from {start:.4} at the start; {}\n",
        best.norm,
        counted(found.evaluations, "evaluation")
    );
    let _ = writeln!(page, "  {:<24} {:>11} {:>11}   {:<19}", "parameter", "start", "found", "range");
    for (k, (parameter, value)) in found.problem.parameters().iter().zip(&best.parameters).enumerate() {
        let mut remark = match (value.at_bound, value.converged) {
            (true, _) => "on its bound: not converged".to_owned(),
            (_, true) => String::new(),
            _ => "not converged".to_owned(),
        };
        if let Some([low, high]) = found.summary(k).map(|summary| summary.interval_95) {
            let _ = write!(remark, "  95 % within {low:.4} to {high:.4}");
        }
        if found.limited_by_gain(k) {
            remark += "; told no better than the loads are known";
        } else if found.identifiable(k) == Some(false) {
            remark += "; the records hardly tell it";
        }
        let range = format!("{} to {} {}", parameter.lower, parameter.upper, parameter.unit);
        let _ = writeln!(
            page,
            "  {:<24} {:>11.5} {:>11.5}   {range:<19}  {remark}",
            parameter.name, parameter.start, value.value
        );
    }
    if found.uncertainty_from() == Some(UncertaintyFrom::Linearised) {
        let error = found.linearised.as_ref().map_or(0.0, |line| line.left.model_error);
        let _ = writeln!(
            page,
            "  intervals are those of the model as a straight line about what was found, with an error of the model of {:.1} % of its \
             response and a gain common to all channels of {} %; posterior = true samples the model itself",
            100.0 * error,
            (1e5 * found.common_gain().map_or(0.0, |gain| gain.prior_deviation)).round() / 1e3
        );
    }
    page.push('\n');
}

fn channels(page: &mut String, found: &Update) {
    let (Some(best), Some(basis)) = (found.found(), &found.basis) else { return };
    let head = ["measured", "model", "error", "shape", "weight"];
    let _ = writeln!(
        page,
        "  {:<34} {:>10} {:>10} {:>8} {:>7} {:>7}",
        "channel", head[0], head[1], head[2], head[3], head[4]
    );
    for ((channel, end), weight) in found.problem.channels().iter().zip(&best.channels).zip(&basis.held.weights) {
        let number = |value: Option<f64>| value.map_or("-".to_owned(), |value| format!("{value:.4}"));
        let _ = writeln!(
            page,
            "  {:<34} {:>10} {:>10.4} {:>8.4} {:>7} {:>7.4}  {}{}",
            channel.name,
            number(channel.measured_peak()),
            end.model_peak,
            end.error,
            number(end.shape_correlation),
            weight,
            channel.unit,
            channel.left_out.as_ref().map_or(String::new(), |why| format!(", left out: {why}"))
        );
    }
    page.push('\n');
}

fn searches(page: &mut String, found: &Update) {
    let _ = writeln!(page, "  {:<44} {:>8} {:>12} {:>9}  ended", "search", "norm", "evaluations", "seconds");
    for (k, line) in found.searches.iter().enumerate() {
        let mark = if found.answer == Some(k) { "*" } else { " " };
        let name = format!("{mark}{} {}", line.search.word(), line.variant);
        let norm = line.found.as_ref().map_or("-".to_owned(), |found| format!("{:.4}", found.norm));
        let count = line.found.as_ref().map_or(line.computed, |found| found.evaluations);
        let _ = writeln!(page, "  {name:<44} {norm:>8} {count:>12} {:>9.1}  {}", line.seconds, line.status);
        if let Some(end) = &line.found {
            let value = |p: &outcome::calibrate::FoundParameter| {
                format!("{} {:.4}{}", p.name, p.value, if p.at_bound { " (bound)" } else { "" })
            };
            let values: Vec<String> = end.parameters.iter().map(value).collect();
            let _ = writeln!(page, "     {}", values.join(", "));
        }
    }
    page.push('\n');
}

/// Table 4 of the railway paper, of the first search by its method.
fn sweeps(page: &mut String, found: &Update) {
    let Some(pass) = found.paper.first().and_then(|paper| paper.outcome.passes.first()) else { return };
    let _ = writeln!(page, "  {:<24} {:>9} {:>9} {:>9} {:>12}", "single sweep", "least", "most", "range", "at");
    for k in &pass.ranking {
        let Some(sweep) = pass.sweeps.iter().find(|sweep| sweep.parameter == *k) else { continue };
        let parameter = &found.problem.parameters()[*k];
        let _ = writeln!(
            page,
            "  {:<24} {:>9.4} {:>9.4} {:>9.4} {:>12.4} {}",
            parameter.name,
            sweep.least(),
            sweep.most(),
            sweep.range(),
            sweep.best(),
            parameter.unit
        );
    }
    if let Some(norm) = pass.naive_norm {
        let _ = writeln!(page, "  all at the minimum of their own sweep: norm {norm:.4}");
    }
    page.push('\n');
}

fn told(page: &mut String, found: &Update) {
    let local = outcome::published::told(found).into_iter();
    let left = found
        .posterior
        .iter()
        .flat_map(|report| std::iter::once(report.surrogate.clone()).chain(report.posterior.words.iter().cloned()));
    list(page, "What the records tell", local.chain(left));
}

pub(super) fn list(page: &mut String, title: &str, lines: impl Iterator<Item = String>) {
    let lines: Vec<String> = lines.collect();
    if !lines.is_empty() {
        let _ = writeln!(page, "\n{title}:");
        lines.iter().for_each(|line| {
            let _ = writeln!(page, "  - {line}");
        });
    }
}
