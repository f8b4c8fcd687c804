//! What a command says of its result: a first screen of at most twenty lines that leads with one number, or with `--details` everything.

use console::{measure_text_width, truncate_str};
use findings::words::counted;
use outcome::warning;
use serde_json::Value;

/// Lines of a first screen.
pub(crate) const MOST_LINES: usize = 20;
/// Warnings on it.
const MOST_WARNINGS: usize = 3;
/// Letters of a line on it.
const WIDTH: usize = 150;

/// A result in words.
#[derive(Debug, Clone, Default)]
pub(crate) struct Page {
    /// What was found, the answer first.
    pub body: String,
    /// What it rests on, each in a sentence.
    pub assumptions: Vec<String>,
    /// Where the rest is.
    pub place: String,
}

/// Warnings that are told last: where loads go at some position, and what stands in the head of a verdict anyway.
const LAST: [&str; 8] = [
    warning::CHOSEN,
    warning::RECALLED_FACTOR,
    warning::STRENGTH_OPEN,
    warning::NO_LONGITUDINAL,
    "A102",
    "A103",
    // The place says it.
    warning::WITHOUT_PDF,
    warning::UNSET_PDF,
];

impl Page {
    /// Everything.
    pub(crate) fn whole(&self) -> String {
        let mut page = self.body.clone();
        if !self.assumptions.is_empty() {
            page += "\nThis assumes:\n";
            self.assumptions.iter().for_each(|line| page += &format!("  - {line}\n"));
        }
        page + &format!("\n{}\n", self.place)
    }

    /// The first screen: the answer, the warnings that matter most, and how much more there is.
    pub(crate) fn first(&self, warnings: &[Value]) -> String {
        let told = important(warnings);
        let more = more(told.len().saturating_sub(MOST_WARNINGS), self.assumptions.len());
        let shown = told.len().min(MOST_WARNINGS);
        // A line for each warning and one over them, one for what is left out, the place after an empty line, and one that says what was made.
        let beside = usize::from(shown > 0) + shown + usize::from(!more.is_empty()) + self.place.lines().count() + 2;
        let body: Vec<&str> = self.body.trim_end().lines().collect();
        let room = MOST_LINES - beside;
        let mut page: Vec<String> = body.iter().take(room).map(|line| clipped(line)).collect();
        if body.len() > room {
            page.truncate(room - 1);
            page.push(format!("  … {}: --details", counted(body.len() - room + 1, "more line")));
        }
        if shown > 0 {
            page.push("  warnings".to_owned());
            page.extend(told.iter().take(shown).map(|line| clipped(&format!("    {line}"))));
        }
        if !more.is_empty() {
            page.push(more);
        }
        page.push(String::new());
        page.push(self.place.clone());
        page.join("\n") + "\n"
    }
}

/// How much a first screen leaves out, in a line; empty where nothing.
fn more(warnings: usize, assumptions: usize) -> String {
    let parts: Vec<String> =
        [(warnings, counted(warnings, "more warning")), (assumptions, counted(assumptions, "assumption"))]
            .into_iter()
            .filter(|(count, _)| *count > 0)
            .map(|(_, words)| words)
            .collect();
    if parts.is_empty() { String::new() } else { format!("  {}: --details, and in the results", parts.join(", ")) }
}

/// Warnings as lines, each once, what matters most first: doubtful values of the file, then what the analysis warns of.
fn important(warnings: &[Value]) -> Vec<String> {
    let text = |one: &Value, key: &str| one[key].as_str().unwrap_or_default().to_owned();
    let rank = |code: &str| match (code.starts_with('P'), LAST.contains(&code)) {
        (true, _) => 0,
        (false, false) => 1,
        (false, true) => 2,
    };
    let mut list: Vec<(usize, String)> = warnings
        .iter()
        .map(|one| {
            let code = text(one, "code");
            let place = one["line"].as_u64().map_or(String::new(), |line| format!(" (line {line})"));
            (rank(&code), format!("{code} {}{place}", text(one, "message")))
        })
        .collect();
    list.sort_by_key(|(rank, _)| *rank);
    let mut lines: Vec<String> = Vec::new();
    for (_, line) in list {
        if !lines.contains(&line) {
            lines.push(line);
        }
    }
    lines
}

/// A line that fits.
fn clipped(line: &str) -> String {
    if measure_text_width(line) <= WIDTH { line.to_owned() } else { truncate_str(line, WIDTH, "…").into_owned() }
}

/// What an answer may not lose: a line that is broken between words where it does not fit, the rest so many letters in.
pub(crate) fn wrapped(line: &str, hanging: usize) -> String {
    let mut lines = vec![String::new()];
    for (k, word) in line.split(' ').enumerate() {
        let last = lines.len() - 1;
        if k > 0 && measure_text_width(&lines[last]) + 1 + measure_text_width(word) > WIDTH {
            lines.push(" ".repeat(hanging) + word);
        } else {
            lines[last] += &if k > 0 { format!(" {word}") } else { word.to_owned() };
        }
    }
    lines.join("\n") + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn a_first_screen_has_twenty_lines_at_most_and_says_what_it_leaves_out() {
        let warnings: Vec<Value> =
            (0..7).map(|k| json!({ "code": format!("A10{k}"), "message": "m".repeat(300) })).collect();
        let body = (0..40).map(|k| format!("  line {k}\n")).collect();
        let page = Page { body, assumptions: vec!["a".into(); 5], place: "Results are in out".into() };
        let first = page.first(&warnings);
        // One more line names what was made.
        assert_eq!(first.lines().count() + 1, MOST_LINES, "{first}");
        assert!(first.contains("4 more warnings, 5 assumptions: --details") && first.contains("more lines"), "{first}");
        assert!(first.lines().all(|line| measure_text_width(line) <= WIDTH));
        // Where a load goes matters least.
        assert!(!first.contains("A102") && first.contains("A101"), "{first}");
        assert!(page.whole().lines().count() > 40);
    }

    #[test]
    fn a_line_that_is_wrapped_loses_no_word() {
        let line = format!("  next      restrict: {}", "no more than 13 t ".repeat(20).trim_end());
        let told = wrapped(&line, 12);
        assert!(told.lines().count() > 1 && told.lines().all(|one| measure_text_width(one) <= WIDTH), "{told}");
        let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(words(&told), words(&line));
        assert!(
            told.lines().skip(1).all(|one| one.starts_with("            no") || one.starts_with(&" ".repeat(12))),
            "{told}"
        );
        assert_eq!(wrapped("  short  line", 2), "  short  line\n");
    }

    #[test]
    fn what_the_file_doubts_comes_first() {
        let list = [json!({ "code": "A111", "message": "x" }), json!({ "code": "P003", "message": "y", "line": 4 })];
        assert_eq!(important(&list), ["P003 y (line 4)", "A111 x"]);
    }
}
