//! All tables of a run as one workbook for spreadsheets: a sheet each, numbers as numbers.

use findings::visible::harmless;
use rust_xlsxwriter::{DocProperties, ExcelDateTime, Format, Workbook, Worksheet, XlsxError};
use serde_json::{Map, Value};

/// Its name.
pub(crate) const NAME: &str = "tables.xlsx";

/// Cells of a table beyond which it stays a CSV file alone: a spreadsheet would not open it with pleasure.
const MOST_CELLS: usize = 1_000_000;

/// Widest column [characters].
const WIDEST: usize = 48;

/// Longest name of a sheet.
const LONGEST_NAME: usize = 31;

/// The workbook of a run: its numbers, what it assumes and warns of, and each of its tables (name, CSV text). None without a table.
///
/// # Errors
/// The library refuses a sheet.
pub(crate) fn workbook(
    fields: &Map<String, Value>,
    warnings: &[Value],
    tables: &[(&str, &[u8])],
) -> Result<Option<Vec<u8>>, XlsxError> {
    if tables.is_empty() {
        return Ok(None);
    }
    let mut book = Workbook::new();
    // The same file for the same result.
    book.set_properties(&DocProperties::new().set_creation_datetime(&ExcelDateTime::from_ymd(2000, 1, 1)?));
    let look = Look { head: Format::new().set_bold().set_text_wrap(), text: Format::new().set_text_wrap() };
    numbers(book.add_worksheet(), fields, &look)?;
    notes(book.add_worksheet(), fields, warnings, &look)?;
    for (name, text) in tables {
        let rows: Vec<csv::StringRecord> = csv::ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .from_reader(*text)
            .records()
            .flatten()
            .collect();
        if rows.iter().map(csv::StringRecord::len).sum::<usize>() <= MOST_CELLS {
            table(book.add_worksheet(), name, &rows, &look)?;
        }
    }
    book.save_to_buffer().map(Some)
}

struct Look {
    head: Format,
    text: Format,
}

/// Fields that tell how often a run was interrupted, and nothing of its result: workbooks of a resumed and of an undisturbed run are one.
const OF_THE_RUN: [&str; 3] = ["evaluations_computed", "evaluations_taken_up", "runs_from_cache"];

/// Numbers and words of the result that stand alone; the unit is the end of the name.
fn numbers(sheet: &mut Worksheet, fields: &Map<String, Value>, look: &Look) -> Result<(), XlsxError> {
    sheet.set_name("result")?.set_freeze_panes(1, 0)?.set_column_width(0, 38)?.set_column_width(1, 24)?;
    sheet.write_with_format(0, 0, "name", &look.head)?.write_with_format(0, 1, "value", &look.head)?;
    let mut row = 0;
    for (name, value) in fields.iter().filter(|(name, _)| !OF_THE_RUN.contains(&name.as_str())) {
        match value {
            Value::Number(_) | Value::String(_) | Value::Bool(_) => row += 1,
            Value::Null | Value::Array(_) | Value::Object(_) => continue,
        }
        sheet.write(row, 0, name.as_str())?;
        match value {
            Value::Number(number) => sheet.write(row, 1, number.as_f64().unwrap_or(f64::NAN))?,
            Value::Bool(flag) => sheet.write(row, 1, *flag)?,
            other => sheet.write_with_format(row, 1, harmless(other.as_str().unwrap_or_default()), &look.text)?,
        };
    }
    Ok(())
}

/// What the result assumes, and what it warns of.
fn notes(sheet: &mut Worksheet, fields: &Map<String, Value>, warnings: &[Value], look: &Look) -> Result<(), XlsxError> {
    sheet.set_name("notes")?.set_freeze_panes(1, 0)?.set_column_width(0, 12)?.set_column_width(1, 100)?;
    sheet.write_with_format(0, 0, "kind", &look.head)?.write_with_format(0, 1, "what it says", &look.head)?;
    // Those of the command (F...) tell of folders and checkpoints, and nothing of the result.
    let of_result =
        warnings.iter().filter(|warning| !warning["code"].as_str().is_some_and(|code| code.starts_with('F')));
    let warned = of_result.map(|warning| (warning["code"].as_str(), warning["message"].as_str()));
    let assumed = fields.get("assumptions").and_then(Value::as_array).into_iter().flatten();
    let all = warned.chain(assumed.map(|said| (Some("assumption"), said.as_str())));
    for (row, (kind, said)) in (1..).zip(all) {
        sheet.write(row, 0, kind.unwrap_or("warning"))?;
        sheet.write_with_format(row, 1, harmless(said.unwrap_or_default()), &look.text)?;
    }
    Ok(())
}

/// A table with its heading in the first row.
fn table(sheet: &mut Worksheet, name: &str, rows: &[csv::StringRecord], look: &Look) -> Result<(), XlsxError> {
    let short: String = name.chars().take(LONGEST_NAME).collect();
    sheet.set_name(short)?.set_freeze_panes(1, 0)?;
    for (row, record) in (0..).zip(rows) {
        for (column, cell) in (0..).zip(record) {
            match cell.parse::<f64>() {
                Ok(number) if row > 0 && number.is_finite() => sheet.write(row, column, number)?,
                _ if row == 0 => sheet.write_with_format(row, column, harmless(cell), &look.head)?,
                _ => sheet.write(row, column, harmless(cell))?,
            };
        }
    }
    let columns = rows.first().map_or(0, csv::StringRecord::len);
    for (column, index) in (0..).zip(0..columns) {
        let cells = rows.iter().take(50).filter_map(|row| row.get(index));
        let wide = cells.map(|cell| cell.chars().count()).max().unwrap_or(0);
        sheet.set_column_width(column, (wide + 2).clamp(9, WIDEST) as f64)?;
    }
    let last = rows.len().saturating_sub(1);
    if let (Ok(last), Ok(column)) = (u32::try_from(last), u16::try_from(columns.saturating_sub(1)))
        && last > 0
    {
        sheet.autofilter(0, 0, last, column)?;
    }
    Ok(())
}
