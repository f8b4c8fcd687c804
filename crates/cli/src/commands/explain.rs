//! `extrados explain`: what a code, a status or a word of the glossary means, and which codes, keys and vehicles are about some words.

use super::vehicles::GRAVITY;
use crate::failure;
use crate::report::Report;
use crate::status::{self, Status};
use assess::vehicles::{Library, LoadModel, Vehicle};
use bridge::fields::{Kind, Need};
use extrados::Refusal;
use findings::Card;
use std::fmt::Write;

/// What is printed about a code or a status.
struct Entry {
    code: String,
    title: String,
    text: String,
}

/// Most entries that words find.
const MOST: usize = 20;

/// Prints one card, those that are about some words, or the list of all.
pub(super) fn run(words: &[String]) -> Result<Report, Refusal> {
    let cards = all();
    match words {
        [] => Ok(list(&cards)),
        [code] if cards.iter().any(|card| card.code.eq_ignore_ascii_case(code)) => {
            Ok(one(cards.iter().find(|card| card.code.eq_ignore_ascii_case(code)).expect("it was found")))
        }
        words => about(words, cards.into_iter().chain(keys()).chain(glossary()).chain(vehicles()).collect()),
    }
}

fn one(card: &Entry) -> Report {
    Report::new(Status::Completed)
        .with("code", card.code.as_str())
        .with("title", card.title.as_str())
        .with("text", card.text.as_str())
        .saying(format!("{}: {}\n\n{}\n", card.code, card.title, folded(&card.text)))
}

/// The entries that have all of these words, those first that have them in their name or title.
fn about(words: &[String], entries: Vec<Entry>) -> Result<Report, Refusal> {
    let asked: Vec<String> = words.iter().flat_map(|text| parts(text)).collect();
    let mut found: Vec<(usize, &Entry)> =
        entries.iter().filter_map(|entry| Some((weight(&asked, entry)?, entry))).collect();
    found.sort_by_key(|(weight, _)| std::cmp::Reverse(*weight));
    match &found[..] {
        [] => {
            let said = words.join(" ");
            let message =
                format!("there is no error, warning, status, key, vehicle or word of the glossary about {said}");
            let help = "extrados explain lists errors, warnings and statuses; docs/input/reference.md has the keys";
            Err(Refusal::new("F105", message, help))
        }
        [(_, only)] => Ok(one(only)),
        several => {
            let shown: Vec<&Entry> = several.iter().take(MOST).map(|(_, entry)| *entry).collect();
            let longest = shown.iter().map(|entry| entry.code.len()).max().unwrap_or(0);
            let mut summary = String::new();
            for entry in &shown {
                let _ = writeln!(summary, "{:<longest$} {}", entry.code, entry.title);
            }
            if several.len() > MOST {
                let _ = writeln!(summary, "and {} more: more words find fewer", several.len() - MOST);
            }
            let cards: Vec<serde_json::Value> =
                shown.iter().map(|entry| serde_json::json!({ "code": entry.code, "title": entry.title })).collect();
            Ok(Report::new(Status::Completed).with("cards", cards).saying(summary))
        }
    }
}

/// Letters and digits, word by word, small; a plural as its singular.
fn parts(text: &str) -> Vec<String> {
    let words = text.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    let small = words.map(str::to_lowercase);
    small.map(|word| word.strip_suffix('s').filter(|word| word.len() > 3).map_or(word.clone(), str::to_owned)).collect()
}

/// How much an entry is about these words: none where it lacks one.
fn weight(asked: &[String], entry: &Entry) -> Option<usize> {
    let named = [parts(&entry.code), parts(&entry.title)].concat();
    let said = parts(&entry.text);
    // Two letters are a word of their own: RA is no range.
    let is = |word: &String, asked: &str| if asked.len() > 2 { word.starts_with(asked) } else { word == asked };
    let has = |words: &[String], asked: &str| words.iter().any(|word| is(word, asked));
    let of = |asked: &String| match (named.contains(asked), has(&named, asked), has(&said, asked)) {
        (true, ..) => Some(6),
        (false, true, _) => Some(4),
        (false, false, true) => Some(1),
        (false, false, false) => None,
    };
    asked.iter().map(of).sum::<Option<usize>>().filter(|_| !asked.is_empty())
}

/// Every key of a bridge file.
fn keys() -> impl Iterator<Item = Entry> {
    let sections = bridge::fields::sections_of(&bridge::fields::FILE);
    sections.into_iter().flat_map(|section| {
        section.fields.iter().map(|field| {
            let code =
                if section.path.is_empty() { field.key.to_owned() } else { format!("{}.{}", section.path, field.key) };
            let missing = match field.need {
                Need::Required => "It must be given.".to_owned(),
                Need::Optional(meaning) => format!("Where it is not given: {meaning}."),
                Need::Default(value) => format!("Where it is not given: {value}."),
            };
            let example =
                if field.example.is_empty() { String::new() } else { format!("\n\nFor example: {}", field.example) };
            let words = match field.kind {
                Kind::Word(words) => words.iter().map(|word| format!("\n  \"{}\": {}", word.word, word.doc)).collect(),
                _ => String::new(),
            };
            let words = if words.is_empty() { words } else { format!("\n\nOne of these words:{words}") };
            let text =
                format!("A key of a bridge file. {missing}{example}{words}\n\ndocs/input/reference.md has all keys.");
            Entry { code, title: field.doc.to_owned(), text }
        })
    })
}

/// Every word of the glossary, as the book has it.
fn glossary() -> impl Iterator<Item = Entry> {
    let rows = include_str!("../../../../docs/glossary.md").lines().filter(|line| line.starts_with("| "));
    rows.skip(1).filter_map(|row| {
        let mut cells = row.trim_matches('|').split(" | ").map(str::trim);
        let (code, text) = (cells.next()?.to_owned(), cells.next()?);
        let title = text.split([';', ':', ',']).next().unwrap_or(text).to_owned();
        Some(Entry { code, title, text: format!("A word of the glossary: {text}.\n\ndocs/glossary.md has all words.") })
    })
}

/// Every vehicle of the library.
fn vehicles() -> impl Iterator<Item = Entry> {
    let library = assess::vehicles::library(GRAVITY);
    let entries = |library: Library| -> Vec<Entry> {
        let of = |(model, vehicle): (&LoadModel, &Vehicle)| {
            let text = format!(
                "A vehicle of the library, of {}: {}.\n\nextrados vehicles {} tells its axles and its rules.",
                model.title, model.source.text, vehicle.code
            );
            Entry { code: vehicle.code.clone(), title: vehicle.title.clone(), text }
        };
        library.vehicles().map(of).collect()
    };
    library.map(entries).unwrap_or_default().into_iter()
}

fn list(cards: &[Entry]) -> Report {
    let mut summary = String::new();
    let mut codes = Vec::new();
    for card in cards {
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

    /// Words of the trade lead to keys and findings that are about them.
    #[test]
    fn words_find_what_is_about_them() {
        let first = |words: &[&str]| {
            let words: Vec<String> = words.iter().map(|word| (*word).to_owned()).collect();
            let report = run(&words).map_err(|refusal| refusal.code)?;
            let fields = &report.fields;
            let codes = match fields.get("cards") {
                Some(cards) => cards.as_array().unwrap().iter().map(|card| card["code"].as_str().unwrap()).collect(),
                None => vec![fields["code"].as_str().unwrap()],
            };
            Ok(codes.into_iter().map(str::to_owned).collect::<Vec<_>>())
        };
        for (words, code) in [
            (&["compressive", "strength"][..], "masonry.compressive_strength"),
            (&["friction angle"], "joint.friction_angle"),
            (&["a124"], "A124"),
            (&["backing"], "backing.height"),
            (&["Skew"], "span.skew"),
            (&["separated", "rings"], "defect.ring"),
            (&["lost-mortar"], "defect.kind"),
            (&["voussoir"], "voussoir"),
            (&["watched", "point"], "watched point"),
            (&["sign", "convention"], "sign convention"),
            (&["Sobol"], "Sobol index"),
            (&["SV80"], "sv-80"),
        ] {
            let found = first(words).unwrap();
            assert!(found.contains(&code.to_owned()) && found.len() <= MOST, "{words:?}: {found:?}");
        }
        assert_eq!(first(&["zeppelin"]), Err("F105"));
        assert_eq!(first(&["backing", "zeppelin"]), Err("F105"));
    }

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
