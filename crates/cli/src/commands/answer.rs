//! What a command answers, and how that is shown.

use crate::desk::Desk;
use crate::failure::Failure;
use crate::render::{self, Paint};
use crate::report::Report;
use crate::status::Status;
use extrados::Refusal;
use serde_json::json;

/// What a command answers.
pub(super) enum Answer {
    /// An object for scripts, or its summary for people.
    Report(Box<Report>),
    /// A text that is the same for both: the JSON Schema.
    Text(String),
}

impl From<Report> for Answer {
    fn from(report: Report) -> Answer {
        Answer::Report(Box::new(report))
    }
}

/// Shows the answer; gives the exit code.
pub(super) fn speak(desk: &mut Desk, answer: Answer) -> u8 {
    match answer {
        Answer::Text(text) => {
            desk.screen.result(&text);
            Status::Completed.exit_code()
        }
        Answer::Report(report) => {
            let text = match desk.screen.json {
                true => ::outcome::published::json(&report.object(&desk.schema, desk.clock)),
                false => report.summary.clone(),
            };
            desk.screen.result(&text);
            report.exit_code()
        }
    }
}

/// The object of a command that could not do its work.
pub(super) fn failed(failure: &Failure) -> Report {
    let mut report = Report::new(failure.status);
    report.errors.push(json!({ "code": failure.code, "message": failure.message, "help": failure.help }));
    report
}

/// Everything that is wrong, shown and listed.
pub(super) fn refused(desk: &mut Desk, mut report: Report, refusals: Vec<Refusal>) -> Report {
    report.status = Status::UnusableInput;
    for failure in refusals.into_iter().map(Failure::from) {
        desk.screen.remark(&render::failure(&failure, &Paint::for_stderr()));
        report.errors.push(json!({ "code": failure.code, "message": failure.message, "help": failure.help }));
    }
    report
}
