//! Findings as an engineer sees them in a terminal: the line, a caret, and what to write instead.

use bridge::{Diagnostic, Severity};
use console::Style;
use extrados::{Excerpt, Refusal};
use findings::visible::{one_line, visible};
use findings::words::counted;
use std::fmt::Write;

/// Colours, or none where the text does not go to a terminal.
#[derive(Debug, Clone)]
pub(crate) struct Paint {
    error: Style,
    warning: Style,
    frame: Style,
    bold: Style,
}

impl Paint {
    /// With or without colours.
    pub(crate) fn new(coloured: bool) -> Paint {
        let style = || Style::new().force_styling(coloured);
        Paint {
            error: style().red().bold(),
            warning: style().yellow().bold(),
            frame: style().blue().bold(),
            bold: style().bold(),
        }
    }

    /// Coloured where stderr is a terminal that wants it.
    pub(crate) fn for_stderr() -> Paint {
        Paint::new(console::colors_enabled_stderr() && console::user_attended_stderr())
    }

    fn of(&self, severity: Severity) -> (&'static str, &Style) {
        let style = if severity == Severity::Error { &self.error } else { &self.warning };
        (severity.word(), style)
    }

    /// The first line of a finding.
    fn headed(&self, severity: Severity, code: &str, message: &str) -> String {
        let (word, style) = self.of(severity);
        let message = self.bold.apply_to(format!(": {}", visible(message)));
        format!("{}{message}\n", style.apply_to(format!("{word}[{code}]")))
    }
}

/// All findings about a file, and how many they are.
pub(crate) fn findings(name: &str, text: &[u8], list: &[Diagnostic], paint: &Paint) -> String {
    let mut page = String::new();
    for finding in list {
        page += &one(name, text, finding, paint);
        page.push('\n');
    }
    if !list.is_empty() {
        page += &count(name, list);
    }
    page
}

/// Findings in a drawing: errors and warnings one by one with their places, notes counted by code and layer.
pub(crate) fn drawing(name: &str, list: &[drawing::Finding], paint: &Paint) -> String {
    let mut page = String::new();
    let name = one_line(name);
    let (mut errors, mut warnings) = (0, 0);
    let mut notes: Vec<(&drawing::Finding, usize)> = Vec::new();
    for finding in list {
        match finding.severity {
            Severity::Error => errors += 1,
            Severity::Warning => warnings += 1,
            Severity::Note => {
                let same = |(known, _): &&mut (&drawing::Finding, usize)| {
                    known.code == finding.code && known.place.layer == finding.place.layer
                };
                match notes.iter_mut().find(same) {
                    Some((_, count)) => *count += 1,
                    None => notes.push((finding, 1)),
                }
                continue;
            }
        }
        page += &paint.headed(finding.severity, finding.code, &finding.message);
        let words = finding.place.to_string();
        let words = one_line(&words);
        let _ = writeln!(page, "  {name}{}{words}", if words.is_empty() { "" } else { ": " });
        if !finding.help.is_empty() {
            let _ = writeln!(page, "  help: {}", visible(&finding.help));
        }
        page.push('\n');
    }
    for (finding, count) in notes {
        let others = match count {
            1 => String::new(),
            2 => ", and once more on this layer".to_owned(),
            n => format!(", and {} times more on this layer", n - 1),
        };
        let _ = writeln!(
            page,
            "note[{}]: {}{others} ({name}: {})",
            finding.code,
            visible(&finding.message),
            one_line(&finding.place.to_string())
        );
    }
    if errors + warnings > 0 {
        let end = if errors > 0 { "the drawing cannot be used" } else { "the drawing can be used" };
        let _ = writeln!(page, "{name}: {}, {}; {end}", counted(errors, "error"), counted(warnings, "warning"));
    }
    page
}

/// A failure of the command itself.
pub(crate) fn failure(failure: &Refusal, paint: &Paint) -> String {
    let head = paint.headed(Severity::Error, failure.code, &failure.message);
    format!("{head}  help: {}\n", visible(&failure.help))
}

/// A warning of an analysis.
pub(crate) fn warning(code: &str, message: &str, paint: &Paint) -> String {
    let head = paint.warning.apply_to(format!("warning[{code}]"));
    format!("{head}: {}\n", visible(message))
}

/// How many findings, and whether the file can be used.
fn count(name: &str, list: &[Diagnostic]) -> String {
    let name = one_line(name);
    let errors = list.iter().filter(|finding| finding.severity == Severity::Error).count();
    let warnings = list.len() - errors;
    let told = match (errors, warnings) {
        (0, _) => counted(warnings, "warning"),
        (_, 0) => counted(errors, "error"),
        _ => format!("{}, {}", counted(errors, "error"), counted(warnings, "warning")),
    };
    let can = if errors == 0 { "can" } else { "cannot" };
    format!("{name}: {told}; the file {can} be used\n")
}

fn one(name: &str, text: &[u8], finding: &Diagnostic, paint: &Paint) -> String {
    let (_, style) = paint.of(finding.severity);
    let place = bridge::text::position(text, finding.range.start);
    let excerpt = Excerpt::of(text, finding.range);
    let gutter = place.line.to_string().len().max(3);
    let bar = paint.frame.apply_to("|");
    let mut page = paint.headed(finding.severity, finding.code, &finding.message);
    let _ = writeln!(page, "  {}:{}:{}", one_line(name), place.line, place.column);
    let number = paint.frame.apply_to(format!("{:>gutter$}", place.line));
    let _ = writeln!(page, "{number} {bar} {}", excerpt.shown);
    let carets = style.apply_to("^".repeat(excerpt.carets));
    let _ = writeln!(
        page,
        "{:gutter$} {bar} {:indent$}{carets} {}",
        "",
        "",
        visible(&finding.label),
        indent = excerpt.indent
    );
    for (word, words) in [("note", &finding.note), ("help", &finding.help)] {
        words.iter().for_each(|words| page += &format!("  {word}: {}\n", visible(words)));
    }
    page
}

#[cfg(test)]
mod tests {
    use super::*;
    use bridge::TextRange;
    use unicode_width::UnicodeWidthStr;

    fn width(text: &str) -> usize {
        text.width()
    }

    fn finding(text: &str, marked: &str) -> Diagnostic {
        let start = text.find(marked).unwrap();
        Diagnostic {
            code: "B104",
            severity: Severity::Error,
            message: "expected a length, found a pressure".to_owned(),
            range: TextRange { start, end: start + marked.len() },
            label: "rise is measured from springing to crown, on the intrados".to_owned(),
            note: None,
            help: Some("write \"2.85 m\"".to_owned()),
        }
    }

    #[test]
    fn a_finding_shows_line_caret_and_remedy() {
        let text = "[bridge]\nname = \"x\"\n\nrise = \"2.85 GPa\"\n";
        let page = findings("bridge.toml", text.as_bytes(), &[finding(text, "\"2.85 GPa\"")], &Paint::new(false));
        let expected = "\
error[B104]: expected a length, found a pressure
  bridge.toml:4:8
  4 | rise = \"2.85 GPa\"
    |        ^^^^^^^^^^ rise is measured from springing to crown, on the intrados
  help: write \"2.85 m\"

bridge.toml: 1 error; the file cannot be used
";
        assert_eq!(page, expected);
    }

    #[test]
    fn carets_stand_under_wide_characters_and_tabs() {
        let text = "\tname = \"橋\", rise = 3\n";
        let page = findings("b.toml", text.as_bytes(), &[finding(text, "3")], &Paint::new(false));
        let lines: Vec<&str> = page.lines().collect();
        let column = width(&lines[2][..lines[2].find('3').unwrap()]);
        assert_eq!(lines[3].find('^'), Some(column));
    }

    #[test]
    fn any_bytes_and_any_range_can_be_shown() {
        let text = b"a = \xff\xfe\x1b[31m \xe6\xa9";
        for start in 0..12 {
            for end in start..20 {
                let mut odd = finding("a", "a");
                odd.range = TextRange { start, end };
                let page = findings("odd.toml", text, &[odd], &Paint::new(false));
                assert!(!page.contains('\u{1b}') && page.contains('^'));
            }
        }
    }

    #[test]
    fn long_lines_are_cut_around_the_place() {
        let text = format!("x = [{}7, {}]", "1, ".repeat(400), "2, ".repeat(400));
        let page = findings("long.toml", text.as_bytes(), &[finding(&text, "7")], &Paint::new(false));
        assert!(page.lines().all(|line| width(line) < 130), "{page}");
        assert!(page.contains("7, 2"));
    }
}
