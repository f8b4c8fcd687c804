//! The cards, the resolver, the schema and the written reference agree.

use std::path::Path;

use bridge::fields::{FILE, Field, Kind, Section, sections_of};
use bridge::read;
use toml::de::{DeTable, DeValue};

use crate::files::{GOOD, show_all};
use crate::written;

/// Every key that a table holds, with its card and the place of its value.
fn keys(
    table: &DeTable<'_>,
    section: &'static Section,
    found: &mut Vec<(&'static Section, &'static Field, std::ops::Range<usize>)>,
) {
    for (key, value) in table.iter() {
        let field = section.field(key.get_ref()).unwrap_or_else(|| panic!("no card for {}", key.get_ref()));
        match field.kind {
            Kind::Table(inner) | Kind::Tables(inner) => match value.get_ref() {
                DeValue::Table(table) => keys(table, inner, found),
                DeValue::Array(items) => {
                    for item in items.iter() {
                        keys(item.get_ref().as_table().unwrap(), inner, found);
                    }
                }
                _ => panic!("{key:?}"),
            },
            _ => found.push((section, field, value.span())),
        }
    }
}

/// The good files use every key there is, and a date in its place is noticed: the resolver reads every key of the
/// cards, and (by the reader's own check for unknown keys) no other.
#[test]
fn every_card_is_read() {
    let mut used = Vec::new();
    for good in GOOD {
        let tree = DeTable::parse(good).unwrap();
        let mut found = Vec::new();
        keys(tree.get_ref(), &FILE, &mut found);
        for (section, field, range) in found {
            let file = format!("{}1979-05-27{}", &good[..range.start], &good[range.end..]);
            let noticed = read(file.as_bytes())
                .diagnostics
                .iter()
                .any(|finding| finding.code == "B012" && finding.range.start == range.start);
            assert!(noticed, "{}.{}:\n{}", section.path, field.key, show_all(&file));
            used.push((section.path, field.key));
        }
    }
    for section in sections_of(&FILE) {
        for field in section.fields {
            // [ring_joint] and [wall_joint] have the keys of [joint], field by field the same cards.
            let path = if section.path.ends_with("_joint") { "joint" } else { section.path };
            let table = matches!(field.kind, Kind::Table(_) | Kind::Tables(_));
            assert!(table || used.contains(&(path, field.key)), "no good file uses {}.{}", section.path, field.key);
        }
    }
}

/// Words of the plan that stand in the cards as defaults are what the resolver takes.
#[test]
fn defaults_are_those_of_the_cards() {
    use bridge::fields::Need;
    let plain = crate::files::TINY;
    let without = read(plain.as_bytes()).bridge.unwrap();
    let mut analysis = String::from("\n[analysis]\n");
    let section = sections_of(&FILE).into_iter().find(|section| section.path == "analysis").unwrap();
    for field in section.fields {
        if let Need::Default(value) = field.need {
            let text = matches!(field.kind, Kind::Word(_));
            analysis += &format!("{} = {}\n", field.key, if text { format!("\"{value}\"") } else { value.to_owned() });
        }
    }
    let gravity = plain.replace("width = \"4 m\"", "width = \"4 m\", gravity = \"9.81 m/s^2\"");
    let rounding = gravity.replace("masonry = {", "masonry = { rounding = \"0 mm\",");
    let abutment = rounding + "abutment = { top_width = \"2 m\", height = \"2 m\" }\n";
    let with = read((abutment + &analysis).as_bytes()).bridge.unwrap();
    assert_eq!(without, with);
}

#[test]
fn written_documents_are_up_to_date() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/input");
    let schema = |schema| serde_json::to_string_pretty(&schema).unwrap() + "\n";
    let documents = [
        ("reference.md", written::reference()),
        ("messages.md", written::messages()),
        ("bridge.schema.json", schema(bridge::schema::schema())),
        ("blocks.md", written::blocks_reference()),
        ("blocks.schema.json", schema(bridge::schema::schema_of_blocks())),
    ];
    for (name, fresh) in documents {
        let path = folder.join(name);
        if std::env::var_os("EXTRADOS_WRITE_DOCS").is_some() {
            std::fs::create_dir_all(&folder).unwrap();
            std::fs::write(&path, &fresh).unwrap();
        }
        let written = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(
            written == fresh,
            "docs/input/{name} is out of date; EXTRADOS_WRITE_DOCS=1 cargo test -p bridge writes it"
        );
    }
}

#[test]
fn example_of_the_guide_reads() {
    let guide = include_str!("../../../../docs/input/README.md");
    let example = guide.split("```toml\n").nth(1).and_then(|rest| rest.split("```").next()).unwrap();
    assert_eq!(show_all(example), "");
    assert!(read(example.as_bytes()).bridge.is_some());
}
