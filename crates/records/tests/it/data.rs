//! The committed tables are those that this file makes: a good one, and one for each of ten defects.

use crate::{path, train};

/// A line of the file that holds a row of data, from 0, and its cells.
fn edit(text: &str, row: usize, change: impl Fn(&mut Vec<String>)) -> String {
    each(text, |k, cells| {
        if k == row {
            change(cells);
        }
    })
}

/// Every row of data, changed.
fn each(text: &str, change: impl Fn(usize, &mut Vec<String>)) -> String {
    let mut row = 0;
    let mut out = String::new();
    for line in text.lines() {
        if line.starts_with(|c: char| c.is_ascii_digit()) {
            let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
            change(row, &mut cells);
            out += &cells.join(",");
            row += 1;
        } else {
            out += line;
        }
        out.push('\n');
    }
    out
}

fn number(cell: &str) -> f64 {
    cell.parse().expect("a number")
}

/// Columns of the good table.
pub(crate) const CROWN: usize = 1;
pub(crate) const PIER: usize = 2;
pub(crate) const STRAIN: usize = 3;
pub(crate) const PIER_STRAIN: usize = 4;

/// Name of each file and its text.
fn files() -> Vec<(&'static str, String)> {
    let good = records::write(&train::good());
    let rows: Vec<&str> = good.lines().collect();
    let drop = |from: usize, to: usize| -> String {
        let head = rows.iter().position(|line| line.starts_with("time")).expect("headings") + 1;
        let kept = rows.iter().enumerate().filter(|(k, _)| !(head + from..head + to).contains(k));
        kept.map(|(_, line)| format!("{line}\n")).collect()
    };
    let at = |row: usize| row as f64 / 100.0;
    let cut = good[..good.len() - 9].to_owned();
    vec![
        ("good.csv", good.clone()),
        ("text-in-a-number.csv", edit(&good, 200, |cells| cells[CROWN] = "-0.1O".to_owned())),
        ("gap.csv", drop(300, 340)),
        ("repeated-time.csv", edit(&good, 251, |cells| cells[0] = at(250).to_string())),
        (
            "two-clocks.csv",
            each(&good, |row, cells| {
                if row > 380 {
                    cells[0] = format!("{:.4}", at(380) + (row - 380) as f64 / 250.0);
                }
            }),
        ),
        ("unit-slip.csv", each(&good, |_, cells| cells[PIER] = format!("{:.5}", number(&cells[PIER]) / 1000.0))),
        ("flat-channel.csv", each(&good, |_, cells| cells[STRAIN] = "3.15".to_owned())),
        ("spike.csv", edit(&good, 333, |cells| cells[PIER] = "9.99".to_owned())),
        (
            "drift.csv",
            each(&good, |row, cells| {
                let steps = (number(&cells[STRAIN]) / 0.05 + row as f64 * 0.2).round();
                cells[STRAIN] = format!("{:.2}", 0.05 * steps);
            }),
        ),
        (
            "wrong-sign.csv",
            each(&good, |_, cells| {
                cells[PIER_STRAIN] = format!("{:.2}", -number(&cells[PIER_STRAIN])).replace("-0.00", "0.00");
            }),
        ),
        ("truncated.csv", cut),
    ]
}

#[test]
fn the_committed_tables_are_these() {
    for (name, text) in files() {
        let path = path(name);
        if std::env::var_os("EXTRADOS_WRITE_DATA").is_some() {
            std::fs::write(&path, &text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        }
        let committed = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        assert!(committed == text, "{name} is another: EXTRADOS_WRITE_DATA=1 cargo test -p records writes it");
    }
}
