//! `extrados explain`: what a code or a status means.

use crate::failure;
use crate::report::Report;
use crate::status::{self, Status};
use extrados::Refusal;
use findings::Card;
use std::fmt::Write;

/// What is printed about a code or a status.
struct Entry {
    code: String,
    title: String,
    text: String,
}

/// Prints one card, or the list of all.
pub(super) fn run(code: Option<&str>) -> Result<Report, Refusal> {
    match code {
        Some(code) => one(code),
        None => Ok(list()),
    }
}

fn one(code: &str) -> Result<Report, Refusal> {
    let cards = all();
    let card = cards.iter().find(|card| card.code.eq_ignore_ascii_case(code)).ok_or_else(|| {
        let message = format!("there is no error, warning or status {code}");
        Refusal::new("F105", message, "extrados explain lists them all; extrados vehicles lists vehicles and rules")
    })?;
    Ok(Report::new(Status::Completed)
        .with("code", card.code.as_str())
        .with("title", card.title.as_str())
        .with("text", card.text.as_str())
        .saying(format!("{}: {}\n\n{}\n", card.code, card.title, folded(&card.text))))
}

fn list() -> Report {
    let mut summary = String::new();
    let mut codes = Vec::new();
    for card in all() {
        let _ = writeln!(summary, "{:<28} {}", card.code, card.title);
        codes.push(serde_json::json!({ "code": card.code, "title": card.title }));
    }
    Report::new(Status::Completed).with("cards", codes).saying(summary)
}

/// Every entry there is: of files, of analyses, of checks, of drawings, of records, of the command, of its statuses.
fn all() -> Vec<Entry> {
    let entry =
        |code: &str, title: &str, text: &str| Entry { code: code.into(), title: title.into(), text: text.into() };
    let plain = |card: &Card| entry(card.code, card.title, card.text);
    let file = bridge::explain::cards().map(|card| entry(card.code, card.title, &of_file(card)));
    let analysis = outcome::warning::CARDS.iter().map(plain);
    let check = assess::checks::CHECKS.iter().map(|card| {
        let text = format!("{}\n\nClause: {}\n\nSource: {}", card.text, card.clause, card.source);
        entry(card.code, card.title, &text)
    });
    let drawing = drawing::cards::CARDS.iter().map(plain);
    let record = records::CARDS.iter().map(|card| {
        entry(card.code, card.title, &format!("Found in measured records. What is done about it: {}.", card.text))
    });
    let command = failure::CARDS.iter().map(plain);
    let status = status::ALL
        .iter()
        .map(|status| entry(status.name(), &format!("status, exit code {}", status.exit_code()), status.meaning()));
    file.chain(analysis).chain(check).chain(drawing).chain(record).chain(command).chain(status).collect()
}

/// A card about files: what is checked and why, an example and its remedy, the source.
fn of_file(card: &bridge::explain::FileCard) -> String {
    let indented = |lines: &str| lines.lines().map(|line| format!("  {line}")).collect::<Vec<_>>().join("\n");
    let mut text = format!("{} {}\n\nRaised by:\n{}\n", card.meaning, card.why, indented(card.wrong));
    if !card.right.is_empty() {
        let _ = write!(text, "\n{}\n{}\n", card.instead_is(), indented(&card.instead()));
    }
    let _ = write!(text, "\nSource: {}", card.source);
    text
}

/// Text folded at 96 columns, paragraph by paragraph; lines that start with a blank stay as they are.
fn folded(text: &str) -> String {
    let mut page = String::new();
    for line in text.lines() {
        if line.starts_with(' ') {
            page += line;
            page.push('\n');
            continue;
        }
        let mut column = 0;
        for word in line.split_whitespace() {
            let length = word.chars().count();
            if column > 0 && column + 1 + length > 96 {
                page.push('\n');
                column = 0;
            } else if column > 0 {
                page.push(' ');
                column += 1;
            }
            page += word;
            column += length;
        }
        page.push('\n');
    }
    page.trim_end().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_has_one_card_that_says_something() {
        let cards = all();
        for (index, card) in cards.iter().enumerate() {
            assert!(!card.title.is_empty() && card.text.len() > 30, "{}", card.code);
            assert!(cards[..index].iter().all(|other| other.code != card.code), "{} twice", card.code);
        }
    }

    #[test]
    fn long_lines_fold_and_examples_stay() {
        let page = folded(&format!("{}\n  rise = \"2 m\"", "word ".repeat(60)));
        assert!(page.lines().all(|line| line.len() <= 96));
        assert!(page.ends_with("\n  rise = \"2 m\""));
    }
}
