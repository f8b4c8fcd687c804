//! What a command answers, and how that is shown.

use crate::desk::Desk;
use crate::failure::status;
use crate::render::{self, Paint};
use crate::report::Report;
use crate::status::Status;
use extrados::Refusal;
use serde_json::json;

/// Shows the answer; gives the exit code.
pub(super) fn speak(desk: &mut Desk, report: &Report) -> u8 {
    let text = match desk.screen.json && !report.is_text {
        true => ::outcome::published::json(&report.object(&desk.schema, desk.clock)),
        false => report.summary.clone(),
    };
    desk.screen.result(&text);
    report.exit_code()
}

/// The object of a command that could not do its work.
pub(super) fn failed(failure: &Refusal) -> Report {
    let mut report = Report::new(status(failure));
    report.errors.push(json!(failure));
    report
}

/// Everything that is wrong, shown and listed.
pub(super) fn refused(desk: &mut Desk, mut report: Report, refusals: Vec<Refusal>) -> Report {
    report.status = Status::UnusableInput;
    for failure in refusals {
        desk.screen.remark(&render::failure(&failure, &Paint::for_stderr()));
        report.errors.push(json!(failure));
    }
    report
}
