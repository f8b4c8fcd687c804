//! `extrados materials`: what is usual of masonry, joints, fill and backing, and where that is from.

use crate::report::Report;
use crate::status::Status;
use extrados::Refusal;
use extrados::materials;
use serde_json::{Value, json};
use std::fmt::Write;

/// Lists the library, one material, or those of one table.
pub(super) fn run(name: Option<&str>) -> Result<Report, Refusal> {
    let asked = name.map(|name| name.trim_matches(['[', ']']));
    let mut listed = materials();
    listed.retain(|one| {
        asked.is_none_or(|name| one.code.eq_ignore_ascii_case(name) || one.tables.iter().any(|table| table == name))
    });
    if let Some(name) = asked.filter(|_| listed.is_empty()) {
        let message = format!("the library has no material \"{name}\", and no material of such a table");
        return Err(Refusal::new("F126", message, "extrados materials lists them all"));
    }
    let mut page = String::new();
    for one in &listed {
        let _ = writeln!(page, "{}: {}, for [{}]", one.code, one.title, one.tables.join("], ["));
        for value in &one.values {
            let source = &value.source;
            let _ = writeln!(page, "  {} {}, from {} to {}", value.key, value.usual, value.least, value.most);
            let _ = writeln!(page, "    {}: {}, {}", source.confidence.word(), source.text, source.date);
            if !source.note.is_empty() {
                let _ = writeln!(page, "    {}", source.note);
            }
        }
    }
    page += "\nNone of these is measured on your bridge: what you take from here, write with its source beside it.\n";
    let objects: Vec<Value> = listed.iter().map(|one| json!(one)).collect();
    Ok(Report::new(Status::Completed).with("materials", objects).saying(page))
}
