//! `extrados assess`: the whole chain against the file's limits, with a report; on a folder, for every bridge file in it.

mod chain;
mod fleet;
mod kept;
mod pdf;
mod pictures;

use super::{Desk, Source};
use crate::args::Assess as Arguments;
use crate::failure::Failure;
use crate::folder::{self, Folder};
use crate::report::{self, Report};
use crate::results;
use crate::signs;
use crate::status::Status;
use crate::summary;
use ::assess::assessment::Assessment;
use ::assess::checks::{self, Checked, Verdict};
use ::assess::condition::{Condition, condition};
use ::assess::wire;
use ::report::{Appendix, Figure, Material, StageLine};
use bridge::inputs::Input;
use chain::Chain;
use kept::{Kept, Program};
use std::path::Path;
use std::time::{SystemTime, UNIX_EPOCH};

/// One bridge, or a folder of them.
pub fn run(desk: &mut Desk, arguments: &Arguments) -> Result<Report, Failure> {
    if arguments.file.is_dir() {
        return fleet::run(desk, arguments);
    }
    let source = Source::open(desk, &arguments.file)?;
    if source.read.bridge.is_none() {
        return Ok(source.report(Status::UnusableInput));
    }
    let out = arguments.out.clone().unwrap_or_else(|| folder::default_for(&arguments.file));
    let folder = source.folder(&out, "assess")?;
    let program = Program::running();
    signs::keeps("out", folder.path(), KEPT);
    let Some(done) = assessed(&source, &arguments.file, &folder, &program, arguments, desk.screen.quiet)? else {
        return Ok(source.report(Status::Cancelled).saying(format!("interrupted; {KEPT}\n")));
    };
    let mut report = done.report(&source);
    for [code, message] in done.warnings() {
        report.warn(&mut desk.screen, &code, &message);
    }
    if !done.verdict.strength.assessed {
        report.warn(&mut desk.screen, ::assess::warning::STRENGTH_OPEN, &done.verdict.strength.missing.join("; "));
    }
    for stage in &done.appendix.stages {
        if stage.state.starts_with("failed") {
            report.warn(
                &mut desk.screen,
                ::assess::warning::STAGE_FAILED,
                &format!("stage {}: {}", stage.name, stage.state),
            );
        }
    }
    let mut files = done.files();
    match pdf::pdf(&done.material()) {
        Ok(bytes) => files.push(figures::File { name: "report.pdf".to_owned(), bytes }),
        Err([code, message]) => report.warn(&mut desk.screen, &code, &message),
    }
    let both = files.iter().any(|file| file.name == "report.pdf");
    let named = if both { "report.html, report.pdf" } else { "report.html" };
    report.summary =
        summary::assessment(&done.assessment, &done.checked, &done.verdict, &done.condition, named, folder.path());
    results::publish(desk, report, &folder, &files)
}

/// What stays of an assessment that is interrupted.
const KEPT: &str = "finished stages are kept, and the same command takes them up";

/// A bridge that was judged.
pub struct Done {
    /// What is known of it.
    pub assessment: Assessment,
    /// Its checks.
    pub checked: Vec<Checked>,
    /// The verdict.
    pub verdict: Verdict,
    /// Its condition.
    pub condition: Vec<Condition>,
    /// Drawings of its stages.
    pub figures: Vec<Figure>,
    /// Its file, value by value.
    pub inputs: Vec<Input>,
    /// What was found in the file.
    pub findings: Vec<[String; 3]>,
    /// How it was made.
    pub appendix: Appendix,
}

impl Done {
    /// What its report is made of.
    fn material(&self) -> Material<'_> {
        Material {
            assessment: &self.assessment,
            checked: &self.checked,
            verdict: &self.verdict,
            condition: &self.condition,
            figures: &self.figures,
            inputs: &self.inputs,
            findings: &self.findings,
            appendix: &self.appendix,
        }
    }

    /// The answer for scripts.
    pub fn report(&self, source: &Source) -> Report {
        let mut report = source.report(Status::named(self.verdict.status).unwrap_or(Status::Undetermined));
        report.finished = self.verdict.finished;
        report.fields =
            report::fields_of(wire::AssessObject::new(&self.assessment, &self.checked, &self.verdict, &self.condition));
        let stages: Vec<serde_json::Value> = self
            .appendix
            .stages
            .iter()
            .map(|stage| serde_json::json!({ "name": stage.name, "state": stage.state, "key": stage.key }))
            .collect();
        report.with("stages", stages).with("input_hash", self.appendix.input.as_str())
    }

    /// Warnings of its stages, each once.
    fn warnings(&self) -> Vec<[String; 2]> {
        let a = &self.assessment;
        let lists = [
            a.update.made().map(|facts| &facts.warnings),
            a.service.made().map(|facts| &facts.warnings),
            a.ultimate.made().map(|facts| &facts.warnings),
            a.vehicles.made().map(|facts| &facts.warnings),
            a.movement.made().map(|facts| &facts.warnings),
        ];
        let mut all: Vec<[String; 2]> = Vec::new();
        for warning in lists.into_iter().flatten().flatten() {
            if !all.contains(warning) {
                all.push(warning.clone());
            }
        }
        all
    }

    /// Report and tables.
    pub fn files(&self) -> Vec<figures::File> {
        let mut files = vec![figures::File {
            name: "report.html".to_owned(),
            bytes: ::report::html(&self.material()).into_bytes(),
        }];
        files.extend(results::tables([("checks", wire::checks_table(&self.checked))]));
        files
    }
}

/// Makes the chain of one bridge; none where somebody asked to stop.
fn assessed(
    source: &Source,
    path: &Path,
    folder: &Folder,
    program: &Program,
    arguments: &Arguments,
    quiet: bool,
) -> Result<Option<Done>, Failure> {
    let kept = Kept::in_folder(folder, program);
    let chain = Chain { source, path, folder, kept: &kept, skip: &arguments.skip, quiet };
    let Some(linked) = chain.run()? else { return Ok(None) };
    let (assessment, checked, figures, stages) = linked;
    let verdict = checks::verdict(&assessment, &checked);
    let condition = condition(&assessment);
    let text = String::from_utf8_lossy(&source.text);
    let appendix = Appendix {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        program: program.hash().to_owned(),
        file: source.name.clone(),
        input: blake3::hash(&source.text).to_hex().to_string(),
        command: command(arguments, &source.name),
        day: today(),
        stages,
    };
    let findings: Vec<[String; 3]> = source
        .read
        .diagnostics
        .iter()
        .map(|finding| {
            let place = bridge::text::position(&source.text, finding.range.start);
            [finding.code.to_owned(), finding.message.clone(), format!("line {}", place.line)]
        })
        .collect();
    let inputs = bridge::inputs::inputs(&text);
    Ok(Some(Done { assessment, checked, verdict, condition, figures, inputs, findings, appendix }))
}

/// The command that makes this bridge's report by itself.
fn command(arguments: &Arguments, file: &str) -> String {
    let skipped: String = arguments.skip.iter().map(|stage| format!(" --skip {}", stage.word())).collect();
    format!("extrados assess {file}{skipped}")
}

/// The stages.
fn line(name: &str, state: String, seconds: Option<f64>, key: &str) -> StageLine {
    let seconds = seconds.map_or("–".to_owned(), |seconds| format!("{seconds:.1} s"));
    StageLine { name: name.to_owned(), state, seconds, key: key.to_owned() }
}

/// Today in universal time, as year-month-day; the rule for civil days is Hinnant's.
fn today() -> String {
    let days = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs() / 86_400) as i64;
    let [year, month, day] = civil(days);
    format!("{year:04}-{month:02}-{day:02}")
}

/// Year, month and day of a day counted from 1970-01-01.
fn civil(days: i64) -> [i64; 3] {
    let z = days + 719_468;
    let era = z.div_euclid(146_097);
    let day_of_era = z.rem_euclid(146_097);
    let year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let shifted = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * shifted + 2) / 5 + 1;
    let month = if shifted < 10 { shifted + 3 } else { shifted - 9 };
    [year_of_era + era * 400 + i64::from(month <= 2), month, day]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn days_are_counted_as_calendars_do() {
        assert_eq!(civil(0), [1970, 1, 1]);
        assert_eq!(civil(59), [1970, 3, 1]);
        assert_eq!(civil(11_016), [2000, 2, 29]);
        assert_eq!(civil(20_778), [2026, 11, 21]);
    }
}
