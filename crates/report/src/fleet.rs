//! Many bridges in one table, worst first.

use crate::numbers::percent;
use askama::Template;
use outcome::counted;

/// A bridge of a fleet.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FleetRow {
    /// Its file.
    pub file: String,
    /// Its name; empty where the file could not be read.
    pub name: String,
    /// "adequate", "inadequate", "undetermined", "unusable-input", or how else the assessment ended.
    pub status: String,
    /// Largest utilisation.
    pub utilisation: Option<f64>,
    /// Code and title of the check that governs.
    pub governing: String,
    /// The load that it is for.
    pub load_model: String,
    /// Whether every analysis of it came to its end.
    pub finished: bool,
    /// Comparisons that are not met.
    pub broken: usize,
    /// The verdict, or what is wrong with the file.
    pub words: String,
    /// The verdict in a line, and by what it is given.
    pub head: String,
    /// What stands beside it, in lines.
    pub beside: Vec<String>,
    /// Stages that the file asks for and the command left out.
    pub skipped: Vec<String>,
    /// Load cases of the rule that were left out.
    pub left_out: Vec<String>,
    /// Codes of doubtful values.
    pub doubtful: Vec<String>,
    /// Least factor on a vehicle of the rule, or else on the loads of the file; none where nothing was found.
    pub factor: Option<f64>,
    /// What that factor is on; empty where there is none.
    pub factor_on: String,
    /// Latitude and longitude [deg], where the file has both.
    pub place: Option<[f64; 2]>,
    /// Its report, relative to the table; empty where there is none.
    pub report: String,
}

impl FleetRow {
    /// Worse bridges come first: not met, nothing settled, files that cannot be used, met; then by utilisation.
    fn rank(&self) -> u8 {
        match self.status.as_str() {
            "inadequate" => 0,
            "undetermined" => 1,
            "adequate" => 3,
            _ => 2,
        }
    }
}

/// The rows, worst first; of equals in the order of their files.
fn sorted(rows: &[FleetRow]) -> Vec<&FleetRow> {
    let mut list: Vec<&FleetRow> = rows.iter().collect();
    let used = |row: &FleetRow| row.utilisation.unwrap_or(-1.0);
    list.sort_by(|a, b| a.rank().cmp(&b.rank()).then(used(b).total_cmp(&used(a))).then(a.file.cmp(&b.file)));
    list
}

/// The table for scripts.
pub fn fleet_csv(rows: &[FleetRow]) -> String {
    let quoted = findings::visible::quoted_cell;
    let mut csv = String::from(
        "file,bridge,status,utilisation,governing,load_model,not_met,verdict,report,head,beside,skipped,load_cases_left_out,doubtful\n",
    );
    for row in sorted(rows) {
        csv += &format!(
            "{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
            quoted(&row.file),
            quoted(&row.name),
            row.status,
            row.utilisation.map_or(String::new(), |value| value.to_string()),
            quoted(&row.governing),
            quoted(&row.load_model),
            row.broken,
            quoted(&row.words),
            quoted(&row.report),
            quoted(&row.head),
            quoted(&row.beside.join("; ")),
            quoted(&row.skipped.join(" ")),
            quoted(&row.left_out.join(" ")),
            quoted(&row.doubtful.join(" "))
        );
    }
    csv
}

#[derive(Template)]
#[template(path = "fleet.html")]
struct Page<'a> {
    style: &'static str,
    folder: &'a str,
    words: String,
    rows: Vec<Row<'a>>,
    made: String,
}

struct Row<'a> {
    row: &'a FleetRow,
    used: String,
    bar: u32,
    class: &'static str,
}

/// The table for people, with a link to every report. `made` says by what it was made.
pub fn fleet_html(folder: &str, rows: &[FleetRow], made: &str) -> String {
    let count = |status: &str| rows.iter().filter(|row| row.status == status).count();
    let (met, broken, open) = (count("adequate"), count("inadequate"), count("undetermined"));
    let words = format!(
        "{}: {broken} not adequate, {open} undetermined, {met} adequate, {} that could not be assessed.",
        counted(rows.len(), "bridge"),
        counted(rows.len() - met - broken - open, "file")
    );
    let row = |row| {
        let row: &FleetRow = row;
        Row {
            used: row.utilisation.map_or("–".to_owned(), percent),
            bar: row.utilisation.map_or(0, |value| (100.0 * value).clamp(0.0, 100.0) as u32),
            class: match row.rank() {
                3 => "met",
                0 => "broken",
                _ => "open",
            },
            row,
        }
    };
    let page = Page {
        style: include_str!("../templates/style.css"),
        folder,
        words,
        rows: sorted(rows).into_iter().map(row).collect(),
        made: made.to_owned(),
    };
    page.render().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(file: &str, status: &str, utilisation: Option<f64>) -> FleetRow {
        FleetRow {
            file: file.into(),
            name: "<b>".into(),
            status: status.into(),
            utilisation,
            finished: true,
            words: "a \"word\"\nmore".into(),
            report: format!("{file}/report.html"),
            ..FleetRow::default()
        }
    }

    #[test]
    fn the_worst_comes_first_and_text_is_escaped() {
        let rows = [
            row("a", "adequate", Some(0.9)),
            row("b", "unusable-input", None),
            row("c", "inadequate", Some(1.2)),
            row("d", "inadequate", Some(2.0)),
            row("e", "adequate", Some(0.95)),
            row("f", "undetermined", None),
        ];
        let order: Vec<&str> = sorted(&rows).iter().map(|row| row.file.as_str()).collect();
        assert_eq!(order, ["d", "c", "f", "b", "e", "a"]);
        let csv = fleet_csv(&rows);
        assert_eq!(csv.lines().count(), 7, "{csv}");
        let page = fleet_html("bridges", &rows, "test");
        assert!(page.contains("d/report.html") && !page.contains("<b>"), "{page}");
    }
}
