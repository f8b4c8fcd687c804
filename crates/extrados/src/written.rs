//! What the command writes of an answer: one object for scripts, drawings, tables, files for other programs. Everything is made in
//! memory; who calls decides where it goes.

use crate::assess::Assessed;
use crate::cases::Cases;
use crate::compare::Compared;
use crate::project::Project;
use bridge::{Diagnostic, Severity};
use figures::File;
use outcome::collapse::{Collapse, Status};
use outcome::passage::Passage;
use outcome::published::{self, Object};
use outcome::records;
use outcome::study::Study;
use outcome::sweep::Sweep;
use outcome::update::Update;
use outcome::vehicles::VehicleSweep;
use outcome::warning::{self, Warning};
use serde_json::{Value, json};
use structure::packing_file;

/// Drawings and files of an answer.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Written {
    /// Drawings: name without extension, which may have a folder before it, and SVG. The command writes each as PNG too.
    pub drawings: Vec<(String, String)>,
    /// Tables, drawings for CAD, ParaView files, reports.
    pub files: Vec<File>,
}

/// Of a collapse; displacements in drawings for CAD are `scale` times larger, or as much larger as in the figures.
pub fn collapse(found: &Collapse, scale: Option<f64>) -> Written {
    let mut written = strip(found, scale);
    if let Some(wall) = &found.wall_strip {
        let Written { drawings, files } = strip(wall, scale);
        written.drawings.extend(drawings.into_iter().map(|(name, svg)| (format!("wall/{name}"), svg)));
        written.files.extend(files.into_iter().map(|file| File { name: format!("wall/{}", file.name), ..file }));
    }
    written
}

fn strip(found: &Collapse, scale: Option<f64>) -> Written {
    let mut files = figures::paraview(&found.picture);
    files.extend(figures::dxf::drawings(&found.picture, scale));
    files.extend(tables([
        ("path", published::path(found)),
        ("hinges", published::hinges(found)),
        ("thrust-line", published::thrust_line(found)),
        ("blocks", published::blocks(found)),
        ("contacts", published::contacts(found)),
        ("particles", published::particles(found)),
        ("particle-contacts", published::particle_contacts(found)),
        ("packing", packing_file::write(found)),
    ]));
    Written { drawings: figures::drawings(&found.picture), files }
}

/// Of loads that were moved over a bridge of this name.
pub fn loads_moved(name: &str, found: &Sweep) -> Written {
    let envelope = figures::sweep_drawing(name, found).map(|svg| ("envelope".to_owned(), svg));
    Written { drawings: envelope.into_iter().collect(), files: vec![file("sweep", published::sweep_table(found))] }
}

/// Of vehicles that were moved over a bridge.
pub fn vehicles_moved(found: &VehicleSweep) -> Written {
    let (mut drawings, mut files) = (Vec::new(), Vec::new());
    if let Some(collapse) = &found.collapse {
        drawings = figures::drawings(&collapse.picture);
        files = figures::paraview(&collapse.picture);
    }
    drawings.extend(figures::vehicles(found).into_iter().map(|(name, svg)| (name.to_owned(), svg)));
    files.push(file("vehicles", published::vehicles_table(found)));
    files.push(file("sweep", published::vehicle_envelope_table(found)));
    files.push(file("sections", published::vehicle_sections_table(found)));
    Written { drawings, files }
}

/// Of the passage of a train.
pub fn passage(found: &Passage) -> Written {
    let mut files = figures::passage_paraview(found);
    files.extend(tables([
        ("influence", published::influence_table(found)),
        ("channels", published::channels_table(found)),
        ("positions", published::positions_table(found)),
        ("log", published::passage_log(found)),
        ("joints", published::joint_states(found)),
        ("thrust-lines", published::thrust_lines(found)),
    ]));
    Written { drawings: figures::passage_drawings(found), files }
}

/// Of an update.
pub fn update(found: &Update) -> Written {
    let files = tables([
        ("histories", published::histories_table(found)),
        ("readings", published::readings_table(found)),
        ("sweeps", published::sweeps_table(found)),
        ("samples", published::samples_table(found)),
    ]);
    Written { drawings: figures::update_drawings(found), files: files.collect() }
}

/// What some runs of a study warn of and others do not, with the runs: what all warn of is the bridge's, and told by an analysis of it.
pub fn warnings_of_study(found: &Study) -> Vec<Value> {
    let mut codes: Vec<&str> =
        found.rows.iter().flat_map(|row| row.outcome.warnings.iter().map(String::as_str)).collect();
    codes.sort_unstable();
    codes.dedup();
    let of = |code: &&str| {
        let has = |row: &outcome::study::Row| row.outcome.warnings.iter().any(|one| one == code);
        let runs: Vec<String> = (0..found.rows.len()).filter(|k| has(&found.rows[*k])).map(|k| k.to_string()).collect();
        if runs.len() == found.rows.len() {
            return None;
        }
        let title = outcome::warning::CARDS.iter().find(|card| card.code == *code).map_or("", |card| card.title);
        let message = format!("in {} of {} runs ({}): {title}", runs.len(), found.rows.len(), runs.join(", "));
        Some(json!({ "code": code, "message": message }))
    };
    codes.iter().filter_map(of).collect()
}

/// Of a study.
pub fn study(found: &Study) -> Written {
    Written { drawings: figures::study_drawings(found), files: vec![file("vary", published::vary_table(found))] }
}

/// Of an assessment: its report has the drawings in it.
pub fn assessed(found: &Assessed) -> Written {
    let page = File { name: "report.html".to_owned(), bytes: found.html().into_bytes() };
    Written { drawings: Vec::new(), files: [page].into_iter().chain(tables([("checks", found.table())])).collect() }
}

/// Of the named cases of a bridge of this name.
pub fn cases(name: &str, found: &Cases) -> Written {
    let bars = figures::case_factors(name, &found.factors()).map(|svg| ("cases".to_owned(), svg));
    Written { drawings: bars.into_iter().chain(found.drawings()).collect(), files: vec![file("cases", found.table())] }
}

/// Of two bridges side by side.
pub fn compared(found: &Compared) -> Written {
    let [differences, answers] = found.tables();
    let files = tables([("differences", differences), ("answers", answers)]).collect();
    Written { drawings: found.drawings().collect(), files }
}

/// Tables (name without extension, text) as files; those without a row are left out.
pub fn tables<'a>(all: impl IntoIterator<Item = (&'a str, String)>) -> impl Iterator<Item = File> {
    let filled = all.into_iter().filter(|(_, text)| text.lines().nth(1).is_some());
    filled.map(|(name, text)| file(name, text))
}

fn file(name: &str, text: String) -> File {
    File { name: format!("{name}.csv"), bytes: text.into_bytes() }
}

/// A finding in a file as an object.
pub fn finding(name: &str, text: &[u8], finding: &Diagnostic) -> Value {
    let place = bridge::text::position(text, finding.range.start);
    let mut value = json!({
        "code": finding.code,
        "message": finding.message,
        "file": name,
        "line": place.line,
        "column": place.column,
        "label": finding.label,
    });
    for (key, words) in [("note", &finding.note), ("help", &finding.help)] {
        if let Some(words) = words {
            value[key] = json!(words);
        }
    }
    value
}

/// A finding in a drawing as an object: its place is a layer, an entity and coordinates instead of a line.
pub fn finding_in_drawing(name: &str, finding: &drawing::Finding) -> Value {
    let place = &finding.place;
    let mut value = json!({ "code": finding.code, "message": finding.message, "file": name });
    for (key, words) in [("layer", &place.layer), ("entity", &place.entity), ("help", &finding.help)] {
        if !words.is_empty() {
            value[key] = json!(words);
        }
    }
    if let Some([x, y]) = place.at {
        value["x_m"] = json!(x);
        value["y_m"] = json!(y);
    }
    value
}

/// A finding in a file of records as an object: its place is a line and a column where they are known.
pub fn finding_in_records(name: &str, finding: &records::Finding) -> Value {
    let words = finding.words();
    let message = if name.is_empty() { words } else { format!("{name}: {words}") };
    let mut value = json!({ "code": finding.code, "message": message });
    if !name.is_empty() {
        value["file"] = json!(name);
        for (key, number) in [("line", finding.place.lines.map(|lines| lines[0])), ("column", finding.place.column)] {
            if let Some(number) = number {
                value[key] = json!(number);
            }
        }
    }
    value
}

/// The status of several analyses: of the one that ended worst; where nothing failed they are completed.
pub fn worst(all: impl Iterator<Item = Status>) -> Status {
    let worst = all.max_by_key(|status| status.exit_code());
    worst.filter(|status| status.exit_code() != 0).unwrap_or(Status::Completed)
}

/// What the analysis of a collapse warns of, in the words of the command.
pub fn warnings_of(found: &Collapse) -> Vec<Warning> {
    let mut all = found.warnings.clone();
    for one in found.wall_strip.iter().flat_map(|wall| &wall.warnings) {
        // What is said of the other strip already need not be repeated.
        if !found.warnings.contains(one) {
            all.push(warning::Passed::OfWalls { warning: Box::new(one.clone()) }.into());
        }
    }
    all.extend(figures::left_out(&found.picture).map(Warning::from));
    all
}

/// The object of an answer: `schema` and `status`, its fields, then `warnings`: those of the file first, then those of the analysis. The
/// command adds `wall_seconds` and `threads`, and where and what it wrote.
pub fn object(project: &Project, schema: &str, status: &str, fields: Object, warnings: &[Warning]) -> Object {
    let of_file = project.findings().iter().filter(|finding| finding.severity != Severity::Error);
    let of_file = of_file.map(|one| finding(project.name(), project.text(), one));
    let of_analysis = warnings.iter().map(|one| json!({ "code": one.code(), "message": one.message() }));
    headed(schema, status, fields, of_file.chain(of_analysis).collect())
}

/// An object with its head, and what is warned of at its end.
pub fn headed(schema: &str, status: &str, fields: Object, warnings: Vec<Value>) -> Object {
    let mut object = Object::new();
    object.insert("schema".to_owned(), json!(schema));
    object.insert("status".to_owned(), json!(status));
    object.extend(fields.into_iter().filter(|(key, _)| !["schema", "status", "warnings"].contains(&key.as_str())));
    object.insert("warnings".to_owned(), json!(warnings));
    object
}
