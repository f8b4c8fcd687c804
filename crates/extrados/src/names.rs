//! Names of vehicles and rules that a bridge file takes from the library: looked up as soon as the file is read, so that a
//! slip of the pen ends as a finding with its place and not after minutes of analyses.

use assess::vehicles::{self, Unknown};
use bridge::{Diagnostic, Read, Severity, TextRange};

/// Adds a finding for every name that nothing bears; a file with one cannot be used.
pub(crate) fn look_up(read: &mut Read, text: &[u8]) {
    let Some(bridge) = &read.bridge else { return };
    let text = String::from_utf8_lossy(text);
    let mut wrong = Vec::new();
    if let Some(Err(refused)) = bridge.sweep.as_ref().map(|plan| vehicles::chosen(bridge, plan)) {
        for unknown in &refused.0 {
            let word = match unknown {
                Unknown::Vehicle { code, .. } | Unknown::Rule { code, .. } => code.as_str(),
                Unknown::Pairing { vehicle, .. } | Unknown::Span { vehicle, .. } => vehicle.as_str(),
                Unknown::File(_) => "",
            };
            wrong.push(finding(&text, "sweep", word, unknown));
        }
    }
    let rule = read.assess.as_ref().and_then(|asked| asked.limits.rule.as_ref());
    if let (Some(code), Ok(library)) = (rule, vehicles::library(bridge.gravity))
        && library.rule(code).is_none()
    {
        let known: Vec<&str> = library.rules.iter().map(|rule| rule.code.as_str()).collect();
        let mut finding = finding(&text, "assess", code, &vehicles::no_rule(&library, code));
        finding.help = Some(format!("write one of {}", known.join(", ")));
        wrong.push(finding);
    }
    if !wrong.is_empty() {
        read.bridge = None;
        read.diagnostics.extend(wrong);
        read.diagnostics.sort_by_key(|finding| finding.range.start);
    }
}

fn finding(text: &str, section: &str, word: &str, unknown: &Unknown) -> Diagnostic {
    let said = unknown.to_string();
    let (message, help) = said.split_once(": write ").unwrap_or((&said, ""));
    Diagnostic {
        code: "B013",
        severity: Severity::Error,
        message: message.to_owned(),
        range: range(text, section, word),
        label: match unknown {
            Unknown::Vehicle { .. } | Unknown::Rule { .. } => "no such name in the library",
            Unknown::Pairing { .. } => "the rule has no factors for these loads",
            Unknown::Span { .. } => "the model is too short for this bridge",
            Unknown::File(_) => "from a file beside this one",
        }
        .to_owned(),
        note: None,
        help: (!help.is_empty()).then(|| format!("write {help}")),
    }
}

/// Where a quoted word stands in a table; the table's head where it cannot be found.
fn range(text: &str, section: &str, word: &str) -> TextRange {
    let head = format!("[{section}]");
    let mut start = 0;
    let mut table = None;
    for line in text.split_inclusive('\n') {
        let bare = line.trim_start();
        if bare.starts_with(&head) {
            table = Some(start + line.len() - bare.len());
        } else if table.is_some() && bare.starts_with('[') {
            break;
        } else if let Some(at) = table.and_then(|_| quoted(line, word)) {
            return TextRange { start: start + at, end: start + at + word.len() + 2 };
        }
        start += line.len();
    }
    let table = table.unwrap_or(0);
    let end = if text[table..].starts_with(&head) { table + head.len() } else { table };
    TextRange { start: table, end }
}

/// Where a word stands between quotes in a line, before any remark.
fn quoted(line: &str, word: &str) -> Option<usize> {
    let at = ['"', '\''].into_iter().filter_map(|quote| line.find(&format!("{quote}{word}{quote}"))).min()?;
    (!word.is_empty() && line.find('#').is_none_or(|remark| at < remark)).then_some(at)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_is_found_in_its_own_table() {
        let text =
            "rule = \"x\"\n[dispersal]\nrule = \"x\"\n[sweep]\n# \"x\"\nrule = \"x\" # so\n[assess]\nrule = 'x'\n";
        let place = |section, word| {
            let range = range(text, section, word);
            (text[..range.start].lines().count(), &text[range.start..range.end])
        };
        assert_eq!(place("sweep", "x"), (6, "\"x\""));
        assert_eq!(place("assess", "x"), (8, "'x'"));
        assert_eq!(place("sweep", "y"), (3, "[sweep]"));
        assert_eq!(range(text, "missing", "x"), TextRange { start: 0, end: 0 });
    }
}
