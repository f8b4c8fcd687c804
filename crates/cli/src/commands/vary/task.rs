//! From quantities and values to bridges: each value is put into the file's text and read by the file's own reader.

use super::Refusals;
use crate::args::Choice;
use crate::cache::{Cache, Key};
use crate::commands::Source;
use crate::failure::Failure;
use assess::vary::{Analysis, Design, Run, runs};
use bridge::edit::Document;
use bridge::vary::Varied;
use bridge::{Bridge, Diagnostic, Severity};
use std::collections::BTreeMap;

/// Refusals shown at once; who has more starts with the first ones.
const MOST_REFUSALS: usize = 50;

/// What every run starts from.
pub struct Plan<'a> {
    /// The file, with what other files gave it.
    pub source: &'a Source,
    /// The bridge as its file has it.
    pub own: &'a Bridge,
    /// The file's text.
    pub document: &'a Document,
    /// What the command line says in place of the file.
    pub choice: &'a Choice,
    /// All against all.
    pub grid: bool,
}

/// Every run, with the bridge that it computes. Runs that mean the same bridge share a job.
pub struct Task {
    /// What is varied.
    pub varied: Vec<Varied>,
    /// The runs, the file's own bridge first.
    pub runs: Vec<Run>,
    /// For each run, its job.
    pub job_of: Vec<usize>,
    /// What there is to compute.
    pub jobs: Vec<Job>,
    /// For each run, codes of doubts that the file's own bridge does not raise.
    pub new_warnings: Vec<Vec<&'static str>>,
}

/// A bridge to analyse.
pub struct Job {
    /// The bridge with its plan.
    pub bridge: Bridge,
    /// What the answer is kept by.
    pub key: Key,
}

impl Plan<'_> {
    /// One at a time, or all against all.
    pub fn design(&self) -> Design {
        if self.grid { Design::Grid } else { Design::OneAtATime }
    }

    /// Whether every value of every quantity gives a bridge by itself, and whether each quantity says something that the
    /// command line does not overrule.
    pub fn check(&self, varied: &[Varied]) -> Result<(), Refusals> {
        let mut refusals = Vec::new();
        let own = self.chosen(self.own.clone()).map_err(|failure| vec![failure])?;
        for quantity in varied {
            let (mut means_something, mut is_overruled) = (false, true);
            for setting in &quantity.values {
                match self.read(&[(quantity, setting.literal.as_str())]) {
                    Ok((bridge, _)) => {
                        means_something |= bridge != *self.own;
                        match self.chosen(bridge) {
                            Ok(chosen) => is_overruled &= chosen == own,
                            Err(failure) => refusals.push(failure),
                        }
                    }
                    Err(found) => {
                        refusals.extend(found);
                        is_overruled = false;
                    }
                }
            }
            if means_something && is_overruled {
                let message = format!("a flag of the command line overrules every value of `{}`", quantity.path);
                refusals.push(Failure::input("F116", message, "leave the flag or the quantity away"));
            }
        }
        no_more(refusals)
    }

    /// Every run and its bridge, or what is wrong with values that only go together badly.
    pub fn task(&self, varied: Vec<Varied>, analysis: &Analysis, cache: &Cache) -> Result<Task, Refusals> {
        let counts: Vec<usize> = varied.iter().map(|one| one.values.len()).collect();
        let runs = runs(self.design(), &counts);
        let mut refusals = Vec::new();
        let mut jobs = Jobs { analysis, cache, known: BTreeMap::new(), list: Vec::new() };
        let (mut job_of, mut warnings) = (Vec::new(), Vec::new());
        for run in &runs {
            let values = varied.iter().zip(&run.choice);
            let values: Vec<(&Varied, &str)> =
                values.filter_map(|(one, choice)| Some((one, one.values.get((*choice)?)?.literal.as_str()))).collect();
            let read = self.read(&values).and_then(|(bridge, doubts)| {
                self.chosen(bridge).map(|bridge| (bridge, doubts)).map_err(|failure| vec![failure])
            });
            match read {
                Ok((bridge, doubts)) => {
                    job_of.push(jobs.number_of(bridge));
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
        Ok(Task { varied, runs, job_of, jobs: jobs.list, new_warnings })
    }

    /// The bridge as its file has it, alone.
    pub fn own_task(&self, analysis: &Analysis, cache: &Cache) -> Result<Task, Failure> {
        let bridge = self.chosen(self.own.clone())?;
        let key = cache.key(analysis.name, &bridge);
        Ok(Task {
            varied: Vec::new(),
            runs: runs(Design::OneAtATime, &[]),
            job_of: vec![0],
            jobs: vec![Job { bridge, key }],
            new_warnings: vec![Vec::new()],
        })
    }

    /// The file with these values, read again; doubts are codes of its warnings.
    fn read(&self, values: &[(&Varied, &str)]) -> Result<(Bridge, Vec<&'static str>), Refusals> {
        let mut document = self.document.clone();
        let shown: Vec<String> = values.iter().map(|(one, literal)| format!("{} = {literal}", one.path)).collect();
        let shown = shown.join(", ");
        for (one, literal) in values {
            if document.set(&one.path, literal).is_err() {
                let message = format!("{shown}: the file has no place for it");
                return Err(vec![Failure::input("F114", message, "extrados vary FILE --list shows what the file has")]);
            }
        }
        let read = self.source.read_again(document.text().as_bytes()).map_err(|failure| vec![failure])?;
        let codes = |list: &[Diagnostic]| list.iter().map(|finding| finding.code).collect();
        match read.bridge {
            Some(bridge) => Ok((bridge, codes(&read.diagnostics))),
            None => {
                let errors = read.diagnostics.iter().filter(|finding| finding.severity == Severity::Error);
                Err(errors.map(|finding| refused(&shown, finding)).collect())
            }
        }
    }

    /// With what the command line says in place of the file.
    pub fn chosen(&self, mut bridge: Bridge) -> Result<Bridge, Failure> {
        let width = bridge.width;
        self.choice.apply(&mut bridge.plan, width)?;
        Ok(bridge)
    }
}

fn no_more(mut refusals: Refusals) -> Result<(), Refusals> {
    refusals.dedup();
    refusals.truncate(MOST_REFUSALS);
    if refusals.is_empty() { Ok(()) } else { Err(refusals) }
}

/// What the reader says about a value.
fn refused(shown: &str, finding: &Diagnostic) -> Failure {
    let message = format!("{shown}: {} ({}; {})", finding.message, finding.label, finding.code);
    let help = finding.help.clone().unwrap_or_else(|| format!("extrados explain {}", finding.code));
    Failure::input("F114", message, help)
}

/// Jobs by their keys.
struct Jobs<'a> {
    analysis: &'a Analysis,
    cache: &'a Cache,
    known: BTreeMap<Key, usize>,
    list: Vec<Job>,
}

impl Jobs<'_> {
    fn number_of(&mut self, bridge: Bridge) -> usize {
        let key = self.cache.key(self.analysis.name, &bridge);
        let next = self.list.len();
        let number = *self.known.entry(key.clone()).or_insert(next);
        if number == next {
            self.list.push(Job { bridge, key });
        }
        number
    }
}
