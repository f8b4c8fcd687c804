//! What cannot be done, as exceptions of the package: their classes stand in `extrados/errors.py`, which chooses by the kind.

use crate::object;
use extrados::{Project, Refusal, finding_in_words};
use pyo3::prelude::*;
use serde_json::{Value, json};

/// An exception of a kind, made from findings and from what is printed.
pub(crate) fn exception(py: Python<'_>, kind: &str, findings: &[Value], text: &str) -> PyErr {
    let made = || -> PyResult<PyErr> {
        let listed = object::value(py, &Value::Array(findings.to_vec()))?;
        let class = py.import("extrados.errors")?.getattr("made")?;
        Ok(PyErr::from_value(class.call1((kind, listed, text))?))
    };
    made().unwrap_or_else(|error| error)
}

/// Refusals, with the kind that their first code tells.
pub(crate) fn refused(py: Python<'_>, refusals: &[Refusal]) -> PyErr {
    let kind = refusals.first().map_or("setup", |refusal| kind(refusal.code));
    of_kind(py, kind, refusals)
}

/// Refusals as an exception of this kind.
pub(crate) fn of_kind(py: Python<'_>, kind: &str, refusals: &[Refusal]) -> PyErr {
    let list: Vec<Value> = refusals
        .iter()
        .map(|one| json!({ "code": one.code, "severity": "error", "message": one.message, "help": one.help }))
        .collect();
    let lines = refusals.iter().map(|one| format!("error[{}]: {}\n  help: {}", one.code, one.message, one.help));
    exception(py, kind, &list, &lines.collect::<Vec<_>>().join("\n"))
}

/// An argument that cannot be used, by its name.
pub(crate) fn argument(py: Python<'_>, message: String, help: &str) -> PyErr {
    of_kind(py, "argument", &[Refusal::new("F107", message, help)])
}

fn kind(code: &str) -> &'static str {
    match code {
        "F101" => "file",
        "F107" | "F113" | "F115" | "F116" | "F117" => "argument",
        "F120" | "F121" => "file",
        "F130" => "records",
        _ if code.starts_with('B') || code == "F114" => "bridge",
        _ => "setup",
    }
}

/// Everything that was found in the file of a project.
pub(crate) fn findings(project: &Project) -> Vec<Value> {
    let all = project.findings().iter().map(|finding| {
        let place = bridge::text::position(project.text(), finding.range.start);
        json!({
            "code": finding.code,
            "severity": finding.severity.word(),
            "message": finding.message,
            "file": project.name(),
            "line": place.line,
            "column": place.column,
            "label": finding.label,
            "note": finding.note,
            "help": finding.help,
            "text": finding_in_words(project.name(), project.text(), finding),
        })
    });
    all.collect()
}

/// A file that cannot be used: every finding with its line and caret.
pub(crate) fn unusable(py: Python<'_>, project: &Project) -> PyErr {
    let all = findings(project);
    let text: Vec<&str> = all.iter().filter_map(|one| one["text"].as_str()).collect();
    exception(py, "bridge", &all, text.join("\n").trim_end())
}
