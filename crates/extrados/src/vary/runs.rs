//! From quantities and values to bridges: each value is put into the file's text and read by the file's own reader.

use crate::choice::Choice;
use crate::means::Means;
use crate::project::Project;
use crate::refusal::Refusal;
use assess::vary::Analysis;
use bridge::edit::Document;
use bridge::vary::Varied;
use bridge::{Bridge, Diagnostic, Severity};
use outcome::study::{Design, Variation, runs};
use std::collections::BTreeMap;

/// Refusals shown at once; who has more starts with the first ones.
const MOST_REFUSALS: usize = 50;

/// What every run starts from.
pub(super) struct Source<'a> {
    /// The file, with what other files gave it.
    pub project: &'a Project,
    /// The bridge as its file has it.
    pub own: &'a Bridge,
    /// The file's text without its ranges.
    pub document: Document,
    /// What takes the place of the file's plan.
    pub choice: Choice,
    /// One at a time, or all against all.
    pub design: Design,
}

/// Every run, with the bridge that it computes. Runs that mean the same bridge share a job.
pub(super) struct Runs {
    /// The runs, the file's own bridge first.
    pub list: Vec<Variation>,
    /// For each run, its job.
    pub job_of: Vec<usize>,
    /// What there is to compute.
    pub jobs: Vec<Job>,
    /// For each run, codes of doubts that the file's own bridge does not raise.
    pub new_warnings: Vec<Vec<&'static str>>,
}

/// A bridge to analyse.
pub(super) struct Job {
    /// The bridge with its plan.
    pub bridge: Bridge,
    /// What the answer is kept by.
    pub key: String,
}

impl Job {
    /// Kept by its numbers: comments, order and units of the file do not enter; every number does to its last bit.
    fn of(bridge: Bridge, analysis: &Analysis, means: &Means<'_>) -> Job {
        Job { key: format!("runs/{}", means.key(analysis.command.word(), &bridge)), bridge }
    }
}

impl Source<'_> {
    /// Whether every value of every quantity gives a bridge by itself, and whether each quantity says something that the
    /// choice does not overrule.
    pub(super) fn check(&self, varied: &[Varied]) -> Result<(), Vec<Refusal>> {
        let mut refusals = Vec::new();
        let own = self.chosen(self.own.clone());
        for quantity in varied {
            let (mut means_something, mut is_overruled) = (false, true);
            for setting in &quantity.values {
                match self.read(&[(quantity, setting.literal.as_str())]) {
                    Ok((bridge, _)) => {
                        means_something |= bridge != *self.own;
                        is_overruled &= self.chosen(bridge) == own;
                    }
                    Err(found) => {
                        refusals.extend(found);
                        is_overruled = false;
                    }
                }
            }
            if means_something && is_overruled {
                let message = format!("a flag of the command line overrules every value of `{}`", quantity.path);
                refusals.push(Refusal::new("F116", message, "leave the flag or the quantity away"));
            }
        }
        no_more(refusals)
    }

    /// Every run and its bridge, or what is wrong with values that only go together badly.
    pub(super) fn runs(&self, varied: &[Varied], analysis: &Analysis, means: &Means<'_>) -> Result<Runs, Vec<Refusal>> {
        let counts: Vec<usize> = varied.iter().map(|one| one.values.len()).collect();
        let list = runs(self.design, &counts);
        let mut refusals = Vec::new();
        let mut known: BTreeMap<String, usize> = BTreeMap::new();
        let (mut jobs, mut job_of, mut warnings) = (Vec::new(), Vec::new(), Vec::new());
        for run in &list {
            let values = varied.iter().zip(&run.choice);
            let values: Vec<(&Varied, &str)> =
                values.filter_map(|(one, choice)| Some((one, one.values.get((*choice)?)?.literal.as_str()))).collect();
            match self.read(&values) {
                Ok((bridge, doubts)) => {
                    let job = Job::of(self.chosen(bridge), analysis, means);
                    let number = *known.entry(job.key.clone()).or_insert(jobs.len());
                    if number == jobs.len() {
                        jobs.push(job);
                    }
                    job_of.push(number);
                    warnings.push(doubts);
                }
                Err(found) => refusals.extend(found),
            }
            if refusals.len() >= MOST_REFUSALS {
                break;
            }
        }
        no_more(refusals)?;
        let own: Vec<&'static str> = warnings.first().cloned().unwrap_or_default();
        let new = |doubts: Vec<&'static str>| doubts.into_iter().filter(|code| !own.contains(code)).collect();
        let new_warnings = warnings.into_iter().map(new).collect();
        Ok(Runs { list, job_of, jobs, new_warnings })
    }

    /// The bridge as its file has it, alone.
    pub(super) fn alone(&self, analysis: &Analysis, means: &Means<'_>) -> Runs {
        let job = Job::of(self.chosen(self.own.clone()), analysis, means);
        let list = runs(Design::OneAtATime, &[]);
        Runs { list, job_of: vec![0], jobs: vec![job], new_warnings: vec![Vec::new()] }
    }

    /// The file with these values, read again; doubts are codes of its warnings.
    fn read(&self, values: &[(&Varied, &str)]) -> Result<(Bridge, Vec<&'static str>), Vec<Refusal>> {
        let mut document = self.document.clone();
        let shown: Vec<String> = values.iter().map(|(one, literal)| format!("{} = {literal}", one.path)).collect();
        let shown = shown.join(", ");
        for (one, literal) in values {
            if document.set(&one.path, literal).is_err() {
                let message = format!("{shown}: the file has no place for it");
                return Err(vec![Refusal::new("F114", message, "extrados vary FILE --list shows what the file has")]);
            }
        }
        let read = self.project.read_again(document.text().as_bytes());
        let codes = |list: &[Diagnostic]| list.iter().map(|finding| finding.code).collect();
        match read.bridge {
            Some(bridge) => Ok((bridge, codes(&read.diagnostics))),
            None => {
                let errors = read.diagnostics.iter().filter(|finding| finding.severity == Severity::Error);
                Err(errors.map(|finding| refused(&shown, finding)).collect())
            }
        }
    }

    /// With what was chosen in place of the file's plan.
    pub(super) fn chosen(&self, mut bridge: Bridge) -> Bridge {
        self.choice.apply(&mut bridge.plan);
        bridge
    }
}

fn no_more(mut refusals: Vec<Refusal>) -> Result<(), Vec<Refusal>> {
    refusals.dedup();
    refusals.truncate(MOST_REFUSALS);
    if refusals.is_empty() { Ok(()) } else { Err(refusals) }
}

/// What the reader says about a value.
fn refused(shown: &str, finding: &Diagnostic) -> Refusal {
    let message = format!("{shown}: {} ({}; {})", finding.message, finding.label, finding.code);
    let help = finding.help.clone().unwrap_or_else(|| format!("extrados explain {}", finding.code));
    Refusal::new("F114", message, help)
}
