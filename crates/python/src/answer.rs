//! What analyses found, for Python: the object of the command, figures, tables, and columns that look into the result.

use crate::arrays;
use crate::object;
use crate::run;
use extrados::results::collapse::Collapse;
use extrados::results::passage::Passage;
use extrados::results::published::{self, Object};
use extrados::results::records::Severity as Weight;
use extrados::results::study::Study;
use extrados::results::sweep::Sweep;
use extrados::results::update::Update;
use extrados::results::vehicles::VehicleSweep;
use extrados::results::warning::Warning;
use extrados::written::{self, Written};
use extrados::{Assessed, Cases, Compared, Project, bridge};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use serde_json::{Value, json};
use std::sync::Arc;

/// A result of any analysis.
pub enum Found {
    /// Of a collapse.
    Collapse(Box<Collapse>),
    /// Of loads at every position, on a bridge of this name and width [m].
    Sweep(String, f64, Sweep),
    /// Of vehicles at every position.
    Vehicles(Box<VehicleSweep>),
    /// Of a train that crosses.
    Passage(Box<Passage>),
    /// Of a search for parameters, with the evaluations that were taken up.
    Update(Box<Update>, usize),
    /// Of an analysis over ranges, with tolerance and seed of the plan.
    Study(Box<Study>, f64, u64),
    /// Of an assessment.
    Assessed(Box<Assessed>),
    /// Of the named cases of a file.
    Cases(Cases),
    /// Of two files.
    Compared(Box<Compared>),
}

/// A result, with the files that it belongs to.
#[pyclass(frozen, module = "extrados")]
pub struct Answer {
    /// What was found.
    pub found: Found,
    /// The files that it belongs to.
    pub projects: Vec<Arc<Project>>,
    /// How long it took [s].
    pub seconds: f64,
}

impl Answer {
    /// As the command writes it to `result.json`, but for the places of its files.
    fn whole(&self) -> Object {
        let mut warnings: Vec<Value> = self.projects.iter().flat_map(|project| of_file(project)).collect();
        let told = |one: &Warning| json!({ "code": one.code(), "message": one.message() });
        let mut add = |list: &[Warning]| warnings.extend(list.iter().map(told));
        let (schema, status, fields) = match &self.found {
            Found::Collapse(found) => {
                add(&written::warnings_of(found));
                ("collapse", found.status.word(), found.object())
            }
            Found::Sweep(name, width, found) => {
                add(&found.warnings);
                ("sweep", found.ended().word(), found.object(name, *width))
            }
            Found::Vehicles(found) => {
                add(&found.warnings);
                ("vehicle-sweep", found.status().word(), found.object())
            }
            Found::Passage(found) => {
                add(&found.warnings);
                ("respond", found.status.word(), found.object())
            }
            Found::Update(found, taken_up) => {
                add(&found.warnings);
                for (finding, file) in found.records.findings.iter().zip(&found.records.places) {
                    if finding.severity > Weight::Note {
                        warnings.push(written::finding_in_records(file, finding));
                    }
                }
                let mut fields = found.object();
                fields.insert("evaluations_taken_up".to_owned(), json!(taken_up));
                ("update", found.status.word(), fields)
            }
            Found::Study(study, tolerance, seed) => {
                warnings.extend(written::warnings_of_study(study));
                let known = study.rows.iter().any(|row| study.number(row).is_some());
                let mut fields = study.object();
                fields.insert("tolerance".to_owned(), json!(tolerance));
                fields.insert("seed".to_owned(), json!(seed));
                ("vary", if known { "completed" } else { "undetermined" }, fields)
            }
            Found::Assessed(done) => {
                add(&done.warnings());
                let verdict = &done.assessment.verdict;
                let mut fields = done.object();
                fields.insert("stages".to_owned(), done.stages());
                fields.insert("input_hash".to_owned(), json!(done.appendix.input));
                ("assess", verdict.status.word(), fields)
            }
            Found::Cases(found) => {
                add(&found.warnings());
                ("cases", written::worst(found.answers.iter().map(|one| one.collapse.status)).word(), found.object())
            }
            Found::Compared(found) => {
                let mut fields = Object::new();
                for (key, project) in ["before_file", "after_file"].into_iter().zip(&self.projects) {
                    fields.insert(key.to_owned(), json!(project.name()));
                }
                fields.extend(found.object());
                ("compare", written::worst(found.answers.iter().map(|one| one.status)).word(), fields)
            }
        };
        let mut whole = written::headed(&format!("extrados.{schema}/1"), status, fields, warnings);
        whole.insert("wall_seconds".to_owned(), json!(self.seconds));
        whole.insert("threads".to_owned(), json!(run::threads()));
        whole.insert("version".to_owned(), json!(extrados::VERSION));
        whole
    }

    fn drawings(&self) -> Vec<(String, String)> {
        match &self.found {
            Found::Collapse(found) => figures::drawings(&found.picture),
            Found::Sweep(name, _, found) => {
                figures::sweep_drawing(name, found).map(|svg| ("envelope".to_owned(), svg)).into_iter().collect()
            }
            Found::Vehicles(found) => {
                let own = found.collapse.iter().flat_map(|collapse| figures::drawings(&collapse.picture));
                own.chain(figures::vehicles(found).into_iter().map(|(name, svg)| (name.to_owned(), svg))).collect()
            }
            Found::Passage(found) => figures::passage_drawings(found),
            Found::Update(found, _) => figures::update_drawings(found),
            Found::Study(study, ..) => figures::study_drawings(study),
            Found::Assessed(done) => {
                done.figures.iter().map(|figure| (figure.name.clone(), figure.svg.clone())).collect()
            }
            Found::Cases(found) => {
                let bridge = found.answers.first().map_or("", |one| one.collapse.bridge.as_str());
                let bars = figures::case_factors(bridge, &found.factors()).map(|svg| ("cases".to_owned(), svg));
                bars.into_iter().chain(found.drawings()).collect()
            }
            Found::Compared(found) => found.drawings().collect(),
        }
    }

    fn written(&self) -> Written {
        match &self.found {
            Found::Collapse(found) => written::collapse(found, None),
            Found::Sweep(name, _, found) => written::loads_moved(name, found),
            Found::Vehicles(found) => written::vehicles_moved(found),
            Found::Passage(found) => written::passage(found),
            Found::Update(found, _) => written::update(found),
            Found::Study(study, ..) => written::study(study),
            Found::Assessed(done) => written::assessed(done),
            Found::Cases(found) => {
                written::cases(found.answers.first().map_or("", |one| one.collapse.bridge.as_str()), found)
            }
            Found::Compared(found) => written::compared(found),
        }
    }

    fn table_texts(&self) -> Vec<(&'static str, String)> {
        match &self.found {
            Found::Collapse(found) => vec![
                ("path", published::path(found)),
                ("hinges", published::hinges(found)),
                ("thrust_line", published::thrust_line(found)),
                ("blocks", published::blocks(found)),
                ("contacts", published::contacts(found)),
                ("particles", published::particles(found)),
                ("particle_contacts", published::particle_contacts(found)),
            ],
            Found::Sweep(_, _, found) => vec![("positions", published::sweep_table(found))],
            Found::Vehicles(found) => vec![
                ("vehicles", published::vehicles_table(found)),
                ("envelope", published::vehicle_envelope_table(found)),
                ("sections", published::vehicle_sections_table(found)),
            ],
            Found::Passage(found) => vec![
                ("channels", published::channels_table(found)),
                ("influence", published::influence_table(found)),
                ("joints", published::joint_states(found)),
                ("thrust_lines", published::thrust_lines(found)),
                ("log", published::passage_log(found)),
            ],
            Found::Update(found, _) => vec![
                ("histories", published::histories_table(found)),
                ("sweeps", published::sweeps_table(found)),
                ("samples", published::samples_table(found)),
            ],
            Found::Study(study, ..) => vec![("runs", published::vary_table(study))],
            Found::Assessed(done) => vec![("checks", done.table())],
            Found::Cases(_) | Found::Compared(_) => Vec::new(),
        }
    }
}

#[pymethods]
impl Answer {
    /// The object of the command.
    fn object<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let whole = run::guarded(py, || self.whole())?;
        object::object(py, &whole)
    }

    /// One of the numbers that loops ask for, without the whole object; `None` where the result has none.
    fn number(&self, name: &str) -> Option<f64> {
        let Found::Collapse(found) = &self.found else { return None };
        let load = |load: Option<f64>| load.map(|load| load / 1e3);
        match name {
            "last_stable_load_kn_per_m" => load(found.last_stable_load),
            "collapse_load_kn_per_m" => load(found.collapse_load),
            "headline_kn_per_m" => load(found.carried()),
            "load_factor" => found.load_factor(),
            _ => None,
        }
    }

    /// How the analysis ended.
    fn status(&self) -> String {
        let word = match &self.found {
            Found::Collapse(found) => found.status.word(),
            Found::Sweep(_, _, found) => found.ended().word(),
            Found::Vehicles(found) => found.status().word(),
            Found::Passage(found) => found.status.word(),
            Found::Update(found, _) => found.status.word(),
            Found::Assessed(done) => done.assessment.verdict.status.word(),
            _ => return self.whole().get("status").and_then(Value::as_str).unwrap_or_default().to_owned(),
        };
        word.to_owned()
    }

    /// Whether vehicles were moved, and not the loads of the file.
    fn is_of_vehicles(&self) -> bool {
        matches!(self.found, Found::Vehicles(_))
    }

    /// All figures as SVG, by their names.
    fn figures<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = PyDict::new(py);
        for (name, svg) in run::guarded(py, || self.drawings())? {
            all.set_item(name, svg)?;
        }
        Ok(all)
    }

    /// One figure as SVG; `None` where there is no material for it.
    fn figure(&self, py: Python<'_>, name: &str) -> PyResult<Option<String>> {
        run::guarded(py, || {
            if let Found::Collapse(found) = &self.found {
                let known = figures::FIGURES.iter().find(|figure| figure.name == name)?;
                return (known.draw)(&found.picture);
            }
            self.drawings().into_iter().find(|(known, _)| known == name).map(|(_, svg)| svg)
        })
    }

    /// What the command writes beside its object, by the names of the files: drawings as SVG, tables, files for CAD and ParaView, the report.
    fn files<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = PyDict::new(py);
        let written = run::guarded(py, || self.written())?;
        for (name, svg) in written.drawings {
            all.set_item(format!("{name}.svg"), PyBytes::new(py, svg.as_bytes()))?;
        }
        for file in written.files {
            all.set_item(file.name, PyBytes::new(py, &file.bytes))?;
        }
        Ok(all)
    }

    /// Tables as CSV, by their names.
    fn tables<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = PyDict::new(py);
        for (name, text) in run::guarded(py, || self.table_texts())? {
            all.set_item(name, text)?;
        }
        Ok(all)
    }

    /// The report of an assessment as one page of HTML.
    fn report(&self, py: Python<'_>) -> PyResult<Option<String>> {
        match &self.found {
            Found::Assessed(done) => run::guarded(py, || done.html()).map(Some),
            _ => Ok(None),
        }
    }

    /// A column of the result as an array that looks into its memory; `at` and `within` tell which of several.
    #[pyo3(signature = (name, at = 0, within = 0))]
    fn array<'py>(slf: &Bound<'py, Self>, name: &str, at: usize, within: usize) -> PyResult<Option<Bound<'py, PyAny>>> {
        arrays::array(slf.as_any(), &slf.get().found, name, at, within)
    }

    /// How many there are of something that has columns of its own.
    fn count(&self, name: &str) -> usize {
        arrays::count(&self.found, name)
    }

    /// Names and words of things that have columns of their own.
    fn words(&self, name: &str) -> Vec<String> {
        arrays::words(&self.found, name)
    }
}

/// Doubts about a file, as the command lists them.
fn of_file(project: &Project) -> impl Iterator<Item = Value> {
    let doubts = project.findings().iter().filter(|finding| finding.severity != bridge::Severity::Error);
    doubts.map(|finding| written::finding(project.name(), project.text(), finding))
}
