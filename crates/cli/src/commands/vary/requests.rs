//! What is asked to vary: the command line's words, another file's tables, or the bridge file's own.

use super::Arguments;
use crate::commands::source::{Source, read_file};
use crate::desk::Desk;
use crate::render::{self, Paint};
use crate::report::Report;
use bridge::vary::Request;
use extrados::Refusal;
use extrados::files::LONGEST_TEXT;

/// The ranges, or everything that is wrong with them. Findings about another file of ranges are shown with their places and stand in
/// the report.
pub(super) fn gather(
    desk: &mut Desk,
    arguments: &Arguments,
    source: &Source,
    report: &mut Report,
) -> Result<Result<Vec<Request>, Vec<Refusal>>, Refusal> {
    let Some(path) = &arguments.ranges else {
        return Ok(match arguments.set.is_empty() {
            true => Ok(source.project.meaning().vary.clone()),
            false => extrados::settings(&source.project, &arguments.set),
        });
    };
    let text = read_file(path, LONGEST_TEXT)?;
    let (requests, findings) = bridge::read_ranges(&text, &source.project.document_without_ranges()?);
    let name = path.display().to_string();
    desk.screen.remark(&render::findings(&name, &text, &findings, &Paint::for_stderr()));
    report.add_findings(&name, &text, &findings);
    Ok(if findings.is_empty() { Ok(requests) } else { Err(Vec::new()) })
}
