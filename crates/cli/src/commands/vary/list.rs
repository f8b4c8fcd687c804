//! Every quantity of a file that can be varied.

use crate::commands::source::Source;
use crate::report::Report;
use crate::status::Status;
use bridge::vary::known;
use extrados::Refusal;
use serde_json::json;
use std::fmt::Write;

/// Path, value and meaning of every quantity.
pub(super) fn list(source: &Source) -> Result<Report, Refusal> {
    let all = known(&source.project.document_without_ranges()?);
    let width = |of: fn(&bridge::vary::Known) -> &str| all.iter().map(|one| of(one).chars().count()).max().unwrap_or(0);
    let (paths, values) = (width(|one| &one.path), width(|one| &one.value).min(40));
    let mut page = String::new();
    for one in &all {
        let default = if one.by_default { " (by default)" } else { "" };
        let _ = writeln!(page, "{:<paths$}  {:<values$}  {}{default}", one.path, one.value, one.doc);
    }
    let objects: Vec<_> = all
        .iter()
        .map(
            |one| json!({ "quantity": one.path, "value": one.value, "by_default": one.by_default, "meaning": one.doc }),
        )
        .collect();
    Ok(source.report(Status::Completed).with("quantities", objects).saying(page))
}
