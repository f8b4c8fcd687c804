//! What `docs/input/` says of keys and messages; made from the cards.

use std::fmt::Write;

use bridge::explain::cards;
use bridge::fields::{FILE, Field, Kind, Need, Section, blocks, sections_of, title};
use bridge::quantity::{UNITS, USUAL_GRAVITY};

/// The reference as Markdown.
pub(crate) fn reference() -> String {
    let mut out = String::from(
        "# The bridge file\n\nGenerated from the field cards of the reader; a test keeps it up to date.\n\nA bridge \
         file is TOML: `[section]` headers and `key = value` lines. Quantities are text with a unit, `\"18.30 m\"`; \
         bare numbers are refused where there is a dimension. Span and rise are always measured at the intrados. \
         Properties of the bridge have no defaults; numerical settings have. A section that may occur several times is \
         written `[[section]]`. `extrados schema` prints the same as a JSON Schema; `extrados explain CODE` explains a \
         message.\n\n",
    );
    units(&mut out);
    for section in sections_of(&FILE).into_iter().filter(|section| !section.path.is_empty()) {
        describe(&FILE, section, &mut out);
    }
    out
}

/// The reference of block model files as Markdown, `docs/input/blocks.md`.
pub(crate) fn blocks_reference() -> String {
    let mut out = String::from(
        "# The block model file, key by key\n\nGenerated from the field cards of the reader; a test keeps it up to \
         date. [Drawings](drawings.md) says how to write such a file, [reference.md](reference.md) lists the units, \
         and `[analysis]` is that of a bridge file, without the analyses that need an arch.\n\n",
    );
    for section in sections_of(&blocks::FILE).into_iter().filter(|s| !s.path.is_empty() && s.path != "analysis") {
        describe(&blocks::FILE, section, &mut out);
    }
    out
}

/// All cards of messages as Markdown, `docs/input/messages.md`.
pub(crate) fn messages() -> String {
    let mut out = String::from(
        "# Messages\n\nGenerated from the cards of the reader; a test keeps it up to date. Codes that start with B are \
         errors: the file cannot be used. Codes that start with P are doubts: the value is possible but unlikely, and \
         the file is used. `extrados explain CODE` prints the same.\n",
    );
    for card in cards() {
        line(&mut out, &format!("\n## {}: {}\n\n{} {}\n", card.code, card.title, card.meaning, card.why));
        let (wrong, right) = (card.wrong.trim(), card.instead());
        let own = if right.contains('…') { ", with this bridge's own value" } else { "" };
        line(&mut out, &format!("```toml\n# wrong\n{wrong}\n\n# right{own}\n{right}\n```\n"));
        line(&mut out, &format!("Source: {}.", card.source));
    }
    out
}

fn units(out: &mut String) {
    out.push_str("## Units\n\n| Quantity | Units |\n|---|---|\n");
    for units in UNITS.chunk_by(|a, b| a.dimension == b.dimension) {
        let name = units[0].dimension.name().trim_start_matches("a ").trim_start_matches("an ");
        let symbols: Vec<String> = units.iter().map(|unit| format!("`{}`", unit.symbol)).collect();
        line(out, &format!("| {name} | {} |", symbols.join(", ")));
    }
    let _ = writeln!(
        out,
        "\nA weight per volume such as `22 kN/m^3` is the density that has this weight, and a mass such as `11.5 t` where a force is asked for is its weight, both with \
         gravity at {} m/s²; the file keeps the unit that was written.",
        USUAL_GRAVITY
    );
    out.push_str("\nExponents may be written `m^3`, `m3` or `m³`. Capitals matter: `MPa`, not `mpa`.\n\n");
}

fn describe(file: &'static Section, section: &'static Section, out: &mut String) {
    line(out, &format!("## `{}`\n\n{}\n", title(file, section), section.doc));
    out.push_str("| Key | Value | Needed | Meaning |\n|---|---|---|---|\n");
    for field in section.fields {
        line(out, &format!("| `{}` | {} | {} | {} |", field.key, value(file, field), need(field), meaning(field)));
    }
    out.push('\n');
    for field in section.fields {
        let Kind::Word(words) = field.kind else { continue };
        line(out, &format!("`{}` is one of\n", field.key));
        for word in words {
            line(out, &format!("- `\"{}\"`: {}", word.word, word.doc));
        }
        out.push('\n');
    }
}

fn meaning(field: &Field) -> String {
    let Some((key, words)) = field.only else { return field.doc.to_owned() };
    let list: Vec<String> = words.iter().map(|word| format!("`{word}`")).collect();
    format!("{} (only with `{key}` {})", field.doc, list.join(", "))
}

fn value(file: &'static Section, field: &Field) -> String {
    match field.kind {
        Kind::Table(section) | Kind::Tables(section) => format!("see `{}`", title(file, section)),
        Kind::Word(_) => format!("a word, as `{}`", field.example_literal()),
        _ => format!("`{}`", field.example_literal()),
    }
}

fn need(field: &Field) -> String {
    match field.need {
        Need::Required => "yes".to_owned(),
        Need::Optional(meaning) => format!("no: {meaning}"),
        Need::Default(value) => format!("no: `{value}`"),
    }
}

fn line(out: &mut String, text: &str) {
    // Writing to a string cannot fail.
    let _ = writeln!(out, "{text}");
}
