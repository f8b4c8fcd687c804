//! All tables of a run as one workbook, read back by another library.

use crate::stage::{Stage, number};
use calamine::{Data, Reader, Xlsx};
use std::io::Cursor;

fn open(stage: &Stage, name: &str) -> Xlsx<Cursor<Vec<u8>>> {
    let bytes = std::fs::read(stage.folder.join(name)).expect("a workbook");
    Xlsx::new(Cursor::new(bytes)).expect("another library opens it")
}

#[test]
fn a_workbook_holds_every_table_with_numbers_as_numbers() {
    let stage = Stage::with_example("workbook-two-span", "two-span");
    let (answer, _) = stage.object(&["collapse", "bridge/bridge.toml", "--method", "limit"]);
    let mut book = open(&stage, "out/bridge/tables.xlsx");
    let sheets = book.sheet_names();
    for table in ["result", "notes", "hinges", "thrust-line", "blocks", "contacts"] {
        assert!(sheets.iter().any(|sheet| sheet == table), "{table}: {sheets:?}");
    }
    let result = book.worksheet_range("result").expect("numbers");
    let carried =
        result.rows().find(|row| row[0] == Data::String("last_stable_load_kn_per_m".into())).expect("the load");
    assert_eq!(carried[1], Data::Float(number(&answer, "last_stable_load_kn_per_m")));
    let notes = book.worksheet_range("notes").expect("notes");
    let said = answer["warnings"].as_array().map_or(0, Vec::len) + answer["assumptions"].as_array().map_or(0, Vec::len);
    assert_eq!(notes.height(), 1 + said, "a heading, and a row for all that is said");
    // The same cells as the CSV file beside it.
    let text = stage.read("out/bridge/contacts.csv");
    let sheet = book.worksheet_range("contacts").expect("contacts");
    assert_eq!(sheet.height(), text.lines().count());
    for (row, line) in sheet.rows().zip(text.lines()) {
        for (cell, written) in row.iter().zip(line.split(',')) {
            match cell {
                Data::Float(value) => assert_eq!(written.parse::<f64>().ok(), Some(*value), "{line}"),
                Data::Int(value) => assert_eq!(written.parse::<i64>().ok(), Some(*value), "{line}"),
                Data::String(words) => assert_eq!(words, written, "{line}"),
                other => assert!(written.is_empty(), "{other:?} {line}"),
            }
        }
    }
    assert!(sheet.rows().skip(1).flatten().any(|cell| matches!(cell, Data::Float(_))), "numbers are numbers");
    // The same bytes again.
    let first = std::fs::read(stage.folder.join("out/bridge/tables.xlsx")).expect("a workbook");
    stage.object(&["collapse", "bridge/bridge.toml", "--method", "limit"]);
    let again = std::fs::read(stage.folder.join("out/bridge/tables.xlsx")).expect("a workbook");
    assert_eq!(first, again, "the same file for the same result");
}
