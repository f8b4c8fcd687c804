//! Records with a defect, as their users meet them: the command names the defect with file, line, time and channel, and uses
//! nothing of it in silence.

use crate::stage::Stage;
use crate::tiny::BRIDGE;
use crate::update::SOUGHT;
use serde_json::Value;
use std::fmt::Write;

/// Steps of the table: 100 Hz over five seconds, both axles of the wagon above the crown at 2.2 and 2.4 s.
const STEPS: usize = 500;
/// First line of data, behind two comments and the headings.
const FIRST: usize = 4;
/// Columns of the table, counted from 1.
const CROWN: usize = 2;
const QUARTER: usize = 3;
const STRAIN: usize = 4;

/// Cells of one good run: quiet, then two axles, then quiet; sizes as the start model has them.
fn good() -> Vec<Vec<String>> {
    let bell = |time: f64, at: f64| (-0.5 * ((time - at) / 0.1).powi(2)).exp();
    // The last digit wavers as a logger's does: a held value would be called dead.
    let waver = |k: usize, column: usize| (((k * 7919 + column * 104_729) % 5) as f64 - 2.0) * 1e-4;
    let cell = |k: usize, column: usize, size: f64| {
        let time = k as f64 / 100.0;
        format!("{:.4}", size * (bell(time, 2.2) + bell(time, 2.4)) + waver(k, column) * size.abs())
    };
    let row =
        |k: usize| vec![format!("{:.2}", k as f64 / 100.0), cell(k, 1, -0.08), cell(k, 2, -0.05), cell(k, 3, -8.0)];
    (0..STEPS).map(row).collect()
}

fn table(rows: &[Vec<String>]) -> String {
    let mut text = "# run: first\n# speed: 36 km/h\ntime [s],crown [mm],quarter [mm],strain [microstrain]\n".to_owned();
    rows.iter().for_each(|row| {
        let _ = writeln!(text, "{}", row.join(","));
    });
    text
}

/// The bridge, with a clock that is laid on the passing of axles: the record's own is the logger's.
fn bridge() -> String {
    let aligned = SOUGHT.replace("zero = false", "zero = false\nalign = \"crown\"\nalign_by = \"axles\"");
    format!("{BRIDGE}{aligned}")
}

fn value(cell: &str) -> f64 {
    cell.parse().expect("a number")
}

/// A finding as a script reads it.
struct Wanted {
    defect: &'static str,
    code: &'static str,
    line: Option<usize>,
    column: Option<usize>,
    time: Option<f64>,
    /// Channels that are left out of the comparison.
    out: &'static [&'static str],
}

const ALL: &[&str] = &["crown", "quarter", "strain"];

/// Each defect: what it does to the good rows, and what must be said of it.
fn defects() -> Vec<(String, Wanted)> {
    let mut all = Vec::new();
    let mut put = |change: &dyn Fn(&mut Vec<Vec<String>>), wanted: Wanted| {
        let mut rows = good();
        change(&mut rows);
        all.push((table(&rows), wanted));
    };
    let at = |k: usize| (Some(FIRST + k), Some(k as f64 / 100.0));
    let (line, time) = at(210);
    let wanted = |defect, code, column, out| Wanted { defect, code, line, column, time, out };
    put(&|rows| rows[210][CROWN - 1] = "-0.0S1".to_owned(), wanted("text in a number", "R020", Some(CROWN), &[]));
    put(
        &|rows| {
            rows.drain(211..251);
        },
        wanted("gap", "R035", None, ALL),
    );
    put(
        &|rows| rows[210][0] = rows[209][0].clone(),
        Wanted { time: Some(2.09), ..wanted("repeated time", "R033", None, &[]) },
    );
    put(
        &|rows| (250..STEPS).for_each(|k| rows[k][0] = format!("{:.3}", 2.5 + 0.004 * (k - 250) as f64)),
        Wanted { line: None, time: None, ..wanted("two clocks", "R032", None, ALL) },
    );
    put(
        &|rows| rows.iter_mut().for_each(|row| row[QUARTER - 1] = format!("{:.1}", 1000.0 * value(&row[QUARTER - 1]))),
        Wanted { line: None, time: None, ..wanted("unit slip by 1000", "R044", Some(QUARTER), &["quarter"]) },
    );
    put(
        &|rows| rows.iter_mut().for_each(|row| row[STRAIN - 1] = "3.1500".to_owned()),
        Wanted { line: Some(FIRST), time: Some(0.0), ..wanted("flat channel", "R040", Some(STRAIN), &["strain"]) },
    );
    put(&|rows| rows[210][QUARTER - 1] = "9.9900".to_owned(), wanted("spike", "R042", Some(QUARTER), &[]));
    put(
        &|rows| {
            for (k, row) in rows.iter_mut().enumerate() {
                row[STRAIN - 1] = format!("{:.4}", value(&row[STRAIN - 1]) + 0.01 * k as f64);
            }
        },
        Wanted { line: Some(FIRST), time: Some(0.0), ..wanted("drift", "R041", Some(STRAIN), &["strain"]) },
    );
    put(
        &|rows| rows.iter_mut().for_each(|row| row[CROWN - 1] = format!("{:.4}", -value(&row[CROWN - 1]))),
        Wanted { line: None, time: None, ..wanted("wrong sign", "R045", Some(CROWN), &["crown"]) },
    );
    let mut cut = table(&good());
    cut.truncate(cut.len() - 4);
    let last = Wanted { line: Some(FIRST + STEPS - 1), time: None, ..wanted("truncated last line", "R028", None, &[]) };
    all.push((cut, last));
    all
}

fn of<'a>(answer: &'a Value, list: &str, code: &str) -> &'a Value {
    let all = if list == "findings" { &answer["records"]["findings"] } else { &answer[list] };
    let found = all.as_array().and_then(|all| all.iter().find(|one| one["code"] == code));
    found.unwrap_or_else(|| panic!("no {code} in {all}"))
}

#[test]
fn a_good_table_is_judged_without_a_search() {
    let stage = Stage::new("records-good");
    stage.write("bridge.toml", bridge());
    stage.write("records.csv", table(&good()));
    let (answer, ending) = stage.object(&["update", "bridge.toml", "--records-only"]);
    assert_eq!((ending.code, answer["status"].as_str()), (Some(0), Some("completed")), "{answer}");
    assert!(answer["records"]["findings"].as_array().is_some_and(Vec::is_empty), "{answer}");
    assert!(answer["search"].is_null() && answer["searches"].as_array().is_some_and(Vec::is_empty), "{answer}");
    assert_eq!(answer["records"]["peaks"].as_array().map(Vec::len), Some(3), "{answer}");
    // The first axle starts at -3 m and stands above the crown at 2 m after 0.5 s; in the record it does so at 2.2 s.
    let done = answer["records"]["done"].to_string();
    let shift = done.split("clock shifted by ").nth(1).and_then(|rest| rest.split(' ').next()).expect("a shift");
    assert!((value(shift) + 1.7).abs() < 0.01 && done.contains("to the passing of 2 axles"), "{done}");
    // One run at one speed on one line proves neither.
    assert_eq!(answer["records"]["dynamics"]["answer"], "cannot-tell", "{answer}");
    assert!(answer["channels"][0]["shape_correlation"].is_null() && answer["initial_error_norm"].is_f64(), "{answer}");
}

/// A misspelt heading is doubted where its sensor is left without a column; one more column of a logger is a note.
#[test]
fn a_misspelt_heading_is_doubted() {
    let stage = Stage::new("records-misspelt");
    stage.write("bridge.toml", bridge());
    let told = |text: String| {
        stage.write("records.csv", text);
        let (answer, _) = stage.object(&["update", "bridge.toml", "--records-only"]);
        let finding = of(&answer, "findings", "R016").clone();
        (finding, answer["records"]["runs"][0]["channels"].clone())
    };
    let (finding, used) = told(table(&good()).replacen("quarter [mm]", "quartr [mm]", 1));
    assert_eq!((finding["severity"].as_str(), finding["column"].as_u64(), used), (Some("warning"), Some(3), 2.into()));
    let help = finding["help"].as_str().expect("help");
    assert!(help.contains("(quarter)") && help.contains("column = \"quartr\""), "{help}");
    let wider: Vec<Vec<String>> = good().into_iter().map(|row| [row.clone(), vec![row[1].clone()]].concat()).collect();
    let (finding, used) = told(table(&wider).replacen("[microstrain]", "[microstrain],spare [mm]", 1));
    assert_eq!((finding["severity"].as_str(), finding["column"].as_u64(), used), (Some("note"), Some(5), 3.into()));
}

#[test]
fn each_of_ten_defects_is_named_with_its_place() {
    let stage = Stage::new("records-defects");
    stage.write("bridge.toml", bridge());
    let defects = defects();
    assert_eq!(defects.len(), 10);
    for (text, wanted) in &defects {
        let name = wanted.defect;
        stage.write("records.csv", text);
        let (answer, ending) = stage.object(&["update", "bridge.toml", "--records-only"]);
        assert_eq!((ending.code, answer["status"].as_str()), (Some(1), Some("inadequate")), "{name}: {answer}");
        let finding = of(&answer, "findings", wanted.code);
        assert_eq!(finding["file"], "records.csv", "{name}: {finding}");
        if let Some(line) = wanted.line {
            assert!(
                finding["line"].as_u64().is_some_and(|found| found.abs_diff(line as u64) <= 1),
                "{name}: {finding}"
            );
        }
        if let Some(time) = wanted.time {
            assert!(finding["time_s"].as_f64().is_some_and(|found| (found - time).abs() < 0.011), "{name}: {finding}");
        }
        if let Some(column) = wanted.column {
            assert_eq!(finding["column"], column, "{name}: {finding}");
        }
        assert!(
            finding["line"].is_u64() || finding["time_s"].is_f64() || finding["channel"].is_string(),
            "{name}: {finding}"
        );
        assert_eq!(of(&answer, "warnings", wanted.code)["file"], "records.csv", "{name}");
        assert!(
            ending.stderr.contains(wanted.code) && ending.stderr.contains("records.csv"),
            "{name}: {}",
            ending.stderr
        );
        let channels = answer["channels"].as_array().into_iter().flatten();
        let left: Vec<&str> = channels
            .filter(|channel| channel["left_out"].is_string())
            .filter_map(|channel| channel["name"].as_str())
            .collect();
        if wanted.out.len() < 3 {
            assert_eq!(left, wanted.out, "{name}: {answer}");
        } else {
            // Nothing is left to compare: a search is refused before anything is solved, with the finding in its words.
            assert!(
                left.is_empty() && answer["records"]["peaks"].as_array().is_some_and(Vec::is_empty),
                "{name}: {answer}"
            );
            let (refused, ending) = stage.object(&["update", "bridge.toml", "--quiet"]);
            let said = refused["errors"][0]["message"].as_str().unwrap_or_default();
            assert!(ending.code == Some(2) && refused["errors"][0]["code"] == "F130", "{name}: {refused}");
            assert!(said.contains(wanted.code) && said.contains("records.csv"), "{name}: {said}");
            assert_eq!(stage.read("out/bridge/evaluations.log").lines().count(), 1, "{name}: nothing was solved");
        }
    }
}
