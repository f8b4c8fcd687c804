//! An analysis over ranges of the file's quantities.

mod runs;
mod work;

use crate::choice::Choice;
use crate::means::Means;
use crate::project::Project;
use crate::refusal::Refusal;
use crate::shard::Shard;
use crate::watch::Watch;
use assess::vary::{self, Analysis};
use bridge::Bridge;
use bridge::vary::{Request, Slip, Varied, find, parse_setting, settle, twice};
use outcome::study::{self, Design, Outcome, Row, Study};
use runs::{Job, Runs, Source};
use work::{Finished, Work};

/// What is repeated, and how often at the most.
#[derive(Debug, Clone)]
pub struct VaryOptions {
    /// What takes the place of the file's plan.
    pub choice: Choice,
    /// A sweep is repeated, and not a collapse.
    pub sweep: bool,
    /// All values of all quantities against each other, and not one at a time.
    pub grid: bool,
    /// The number that the study is about; none for the one that the analysis is made for.
    pub outcome: Option<String>,
    /// More runs are refused.
    pub most_runs: usize,
}

impl Default for VaryOptions {
    fn default() -> Self {
        VaryOptions { choice: Choice::default(), sweep: false, grid: false, outcome: None, most_runs: 1000 }
    }
}

impl VaryOptions {
    /// The analysis that is repeated: a sweep where it is asked for, or where only a sweep finds the number that is.
    ///
    /// # Errors
    /// A sweep by another method than limit analysis (F107).
    pub fn analysis(&self) -> Result<Analysis, Refusal> {
        let asked = self.outcome.as_deref();
        let asked = asked.is_some_and(|name| vary::OF_SWEEPS.contains(&name) || name.starts_with(vary::OF_SWEEPS[0]));
        let sweeps = self.sweep || asked;
        if sweeps && self.choice.method.is_some_and(|method| method != bridge::Method::Limit) {
            let message = "a sweep is limit analysis: no other --method can make it";
            return Err(Refusal::new("F107", message, "leave --method out, or say --method limit"));
        }
        Ok(if sweeps { vary::SWEEP } else { vary::COLLAPSE })
    }
}

/// Runs that were checked: every value gives a bridge.
pub struct VaryPlan<'a> {
    source: Source<'a>,
    analysis: Analysis,
    varied: Vec<Varied>,
    outcome: Option<String>,
    most_runs: usize,
}

/// What came of a study.
#[derive(Debug)]
pub struct Studied {
    /// The study; none where the work was stopped.
    pub study: Option<Study>,
    /// Runs that are finished.
    pub finished: usize,
    /// Runs there are.
    pub runs: usize,
    /// What kept a finished run from being kept.
    pub trouble: Option<std::io::Error>,
}

/// What came of a shard of a study: finished runs on the shelf.
#[derive(Debug)]
pub struct Portion {
    /// The study that it belongs to, as [`VaryPlan::identity`] has it.
    pub identity: String,
    /// Names on the shelf of the runs that it made or found there.
    pub kept: Vec<String>,
    /// Those of them that were there already.
    pub taken_up: usize,
    /// Whether every run of the shard is finished: not where the work was stopped.
    pub finished: bool,
    /// What kept a finished run from being kept.
    pub trouble: Option<std::io::Error>,
}

/// Runs the analysis over the given ranges, or over those of the file where none are given.
///
/// # Errors
/// Everything that is wrong with ranges, values and the number of runs (B501 to B504, F113 to F117).
pub fn vary(
    project: &Project,
    requests: &[Request],
    options: &VaryOptions,
    means: &Means<'_>,
    watch: &mut dyn Watch,
) -> Result<Studied, Vec<Refusal>> {
    let requests = if requests.is_empty() { &project.meaning().vary[..] } else { requests };
    VaryPlan::new(project, requests, options)?.run(means, watch)
}

/// Ranges as the command line has them: `joint.friction_angle=30deg..40deg:5`.
///
/// # Errors
/// Every setting that is no range of a quantity of the file (B501 to B503).
pub fn settings<S: AsRef<str>>(project: &Project, texts: &[S]) -> Result<Vec<Request>, Vec<Refusal>> {
    let document = project.document_without_ranges()?;
    let mut refusals = Vec::new();
    let read = texts.iter().map(|text| parse_setting(&document, text.as_ref()));
    let requests = read.filter_map(|request| request.map_err(|slip| refusals.push(refused(slip))).ok()).collect();
    if refusals.is_empty() { Ok(requests) } else { Err(refusals) }
}

impl<'a> VaryPlan<'a> {
    /// Checks ranges, and every value by itself.
    ///
    /// # Errors
    /// Everything that is wrong with them.
    pub fn new(
        project: &'a Project,
        requests: &[Request],
        options: &VaryOptions,
    ) -> Result<VaryPlan<'a>, Vec<Refusal>> {
        let analysis = options.analysis()?;
        let own = project.bridge()?;
        let document = project.document_without_ranges()?;
        let mut refusals = Vec::new();
        if requests.is_empty() {
            let help =
                "add [[vary]] tables, or say --set joint.friction_angle=30deg..40deg:5; --list shows what there is";
            refusals.push(Refusal::new("F113", format!("{} says nothing of what to vary", project.name()), help));
        }
        let mut varied = Vec::new();
        for request in requests {
            match find(&document, &request.quantity).and_then(|quantity| settle(&quantity, &request.spread)) {
                Ok(one) => varied.push(one),
                Err(slip) => refusals.push(refused(slip)),
            }
        }
        let paths = varied.iter().enumerate().map(|(at, one)| (at, one.path.to_string()));
        refusals.extend(twice(&paths.collect::<Vec<_>>()).into_iter().map(|(_, slip)| refused(slip)));
        if !refusals.is_empty() {
            return Err(refusals);
        }
        let design = if options.grid { Design::Grid } else { Design::OneAtATime };
        let source = Source { project, own, document, choice: options.choice, design };
        source.check(&varied)?;
        Ok(VaryPlan { source, analysis, varied, outcome: options.outcome.clone(), most_runs: options.most_runs })
    }

    /// The bridge as its file has it, with what was chosen in place of its plan.
    pub fn own(&self) -> Bridge {
        self.source.chosen(self.source.own.clone())
    }

    /// What is repeated.
    pub fn analysis(&self) -> &Analysis {
        &self.analysis
    }

    /// How many runs there are; none where they cannot be counted.
    pub fn count(&self) -> Option<usize> {
        let values: Vec<usize> = self.varied.iter().map(|one| one.values.len()).collect();
        study::count(self.source.design, &values)
    }

    /// Makes the runs that are not on the shelf yet, several at once.
    ///
    /// # Errors
    /// Too many runs (F115), values that only go together badly (F114), a bridge that the analysis cannot be made of (F108), a number
    /// that no run found (F117).
    pub fn run(self, means: &Means<'_>, watch: &mut dyn Watch) -> Result<Studied, Vec<Refusal>> {
        let runs = self.runs(means, watch)?;
        let (rows, found) = Work { analysis: &self.analysis, means }.all(&runs, watch)?;
        Ok(Studied { study: rows.map(|rows| self.study(runs, rows)).transpose()?, ..found })
    }

    /// Makes the runs of a shard that are not on the shelf yet. When all shards are there, [`run`](Self::run) finds every run on the shelf.
    ///
    /// # Errors
    /// Too many runs (F115), values that only go together badly (F114).
    pub fn share(&self, shard: Shard, means: &Means<'_>, watch: &mut dyn Watch) -> Result<Portion, Vec<Refusal>> {
        let runs = self.runs(means, watch)?;
        let work = Work { analysis: &self.analysis, means };
        let jobs: Vec<&Job> =
            runs.jobs.iter().enumerate().filter(|(place, _)| shard.makes(*place)).map(|(_, job)| job).collect();
        let (made, trouble) = work.some(&jobs, watch);
        let identity = self.identity_of(&runs, means);
        let finished = made.iter().all(Option::is_some);
        // What cannot be analysed is on no shelf: it is found out again.
        let kept = jobs.iter().zip(made).filter_map(|(job, one)| Some((job.key.clone(), one?)));
        let kept: Vec<_> = kept.filter(|(_, one)| one.outcome.message.is_none()).collect();
        let taken_up = kept.iter().filter(|(_, one)| one.cached).count();
        let kept = kept.into_iter().map(|(key, _)| key).collect();
        Ok(Portion { identity, kept, taken_up, finished, trouble })
    }

    /// A hash of everything that the study follows from: every run with its bridge and its plan, what is asked of them, the build.
    ///
    /// # Errors
    /// Values that only go together badly (F114).
    pub fn identity(&self, means: &Means<'_>) -> Result<String, Vec<Refusal>> {
        Ok(self.identity_of(&self.source.runs(&self.varied, &self.analysis, means)?, means))
    }

    fn identity_of(&self, runs: &Runs, means: &Means<'_>) -> String {
        let keys: Vec<&str> = runs.job_of.iter().map(|job| runs.jobs[*job].key.as_str()).collect();
        means.key("study", &(self.analysis.command.word(), &self.outcome, self.source.design, &self.varied, keys))
    }

    /// Every run, where there are not too many.
    fn runs(&self, means: &Means<'_>, watch: &mut dyn Watch) -> Result<Runs, Vec<Refusal>> {
        let count = self.count().unwrap_or(usize::MAX);
        if count > self.most_runs {
            let own = self.source.alone(&self.analysis, means);
            let (rows, _) = Work { analysis: &self.analysis, means }.all(&own, watch)?;
            let seconds = rows.and_then(|rows| rows.first().map(|row| row.seconds));
            return Err(vec![too_many(count, self.most_runs, seconds.filter(|seconds| *seconds > 0.0))]);
        }
        self.source.runs(&self.varied, &self.analysis, means)
    }

    fn study(self, runs: Runs, finished: Vec<Finished>) -> Result<Study, Refusal> {
        let rows = runs.list.iter().zip(&runs.new_warnings).zip(finished);
        let rows = rows.map(|((run, new), mut found)| {
            found.outcome.warnings.extend(new.iter().map(|code| (*code).to_owned()));
            Row { run: run.clone(), outcome: found.outcome, seconds: found.seconds, cached: found.cached }
        });
        let own = self.own();
        let mut study = Study {
            bridge: own.name.clone(),
            command: self.analysis.command,
            analysis: own.plan.analysis,
            method: own.plan.method,
            design: self.source.design,
            outcome: String::new(),
            resolution: 0.0,
            rows: rows.collect(),
            quantities: self.varied,
        };
        study.outcome = outcome(self.outcome, &self.analysis, &study)?;
        study.resolution = vary::resolution(&self.analysis, &study);
        Ok(study)
    }
}

/// The number that a study is about: the one asked for, or the one that the analysis is made for.
fn outcome(asked: Option<String>, analysis: &Analysis, study: &Study) -> Result<String, Refusal> {
    let names = study.numbers();
    match asked {
        Some(name) if names.contains(&name.as_str()) => Ok(name),
        Some(name) => {
            let message = format!("no run found a number `{name}`");
            Err(Refusal::new("F117", message, format!("the runs found {}", names.join(", "))))
        }
        None => {
            let outcomes: Vec<&Outcome> = study.rows.iter().map(|row| &row.outcome).collect();
            let leading = vary::leading(analysis, &outcomes);
            Ok(leading.or(analysis.leading.last().copied()).unwrap_or_default().to_owned())
        }
    }
}

/// Refuses a number of runs, with the time they would take going by the bridge as its file has it.
fn too_many(runs: usize, most: usize, seconds: Option<f64>) -> Refusal {
    let threads = rayon::current_num_threads();
    let time = seconds.map_or(String::new(), |seconds| {
        let all = seconds * runs as f64 / threads as f64;
        let plural = if threads == 1 { "" } else { "s" };
        format!(": at {} each, some {} on {threads} thread{plural}", duration(seconds), duration(all))
    });
    let message = format!("{runs} runs are more than {most}{time}");
    let help = match runs <= 100_000 {
        true => format!("--most-runs {runs} allows them; fewer values, or no --grid, need less"),
        false => "give fewer values, or leave --grid away: more than 100000 runs are never started".to_owned(),
    };
    Refusal::new("F115", message, help)
}

/// A time in the unit that people would use.
fn duration(seconds: f64) -> String {
    match seconds {
        _ if seconds < 1.0 => format!("{:.0} ms", (1e3 * seconds).max(1.0)),
        _ if seconds < 120.0 => format!("{seconds:.1} s"),
        _ if seconds < 7200.0 => format!("{:.0} min", seconds / 60.0),
        _ if seconds < 172_800.0 => format!("{:.1} h", seconds / 3600.0),
        _ => format!("{:.0} days", seconds / 86_400.0),
    }
}

/// A slip as a refusal, without a place to point at.
fn refused(slip: Slip) -> Refusal {
    let message = match slip.label.as_str() {
        "" => slip.message,
        label => format!("{}: {label}", slip.message),
    };
    Refusal::new(slip.code, message, slip.help)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn durations_are_in_a_unit_of_their_size() {
        let words: Vec<String> = [0.0002, 0.25, 5.0, 600.0, 9000.0, 1e6].into_iter().map(duration).collect();
        assert_eq!(words, ["1 ms", "250 ms", "5.0 s", "10 min", "2.5 h", "12 days"]);
    }
}
