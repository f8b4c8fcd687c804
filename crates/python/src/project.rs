//! A bridge file in the hands of Python, and every analysis of it.

use crate::answer::{Answer, Found};
use crate::errors;
use crate::kept::{Kept, State};
use crate::object;
use crate::options::{self, Given, Listener, Options};
use crate::run::{self, Finished};
use extrados::results::published;
use extrados::{
    AssessOptions, CollapseOptions, Disk, Files, Means, Project as File, Refusal, RespondOptions, SweepOptions, Swept,
    UpdateOptions, VaryOptions,
};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

/// Files that a caller holds, and those of the disk where it holds none.
#[derive(Clone, Default)]
struct Beside(Arc<BTreeMap<PathBuf, Vec<u8>>>);

impl Beside {
    /// Their bytes, by their paths.
    fn listed<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = PyDict::new(py);
        for (path, bytes) in &*self.0 {
            all.set_item(path.to_string_lossy(), pyo3::types::PyBytes::new(py, bytes))?;
        }
        Ok(all)
    }
}

impl Files for Beside {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.0.get(path).map_or_else(|| Disk.read(path), |bytes| Ok(bytes.clone()))
    }

    fn list(&self, folder: &Path) -> io::Result<Option<Vec<PathBuf>>> {
        let inside: Vec<PathBuf> = self.0.keys().filter(|path| path.parent() == Some(folder)).cloned().collect();
        if inside.is_empty() { Disk.list(folder) } else { Ok(Some(inside)) }
    }

    fn head(&self, path: &Path, most: u64) -> io::Result<Vec<u8>> {
        match self.0.get(path) {
            Some(bytes) => Ok(bytes[..bytes.len().min(usize::try_from(most).unwrap_or(usize::MAX))].to_vec()),
            None => Disk.head(path, most),
        }
    }

    fn real(&self, path: &Path) -> io::Result<PathBuf> {
        if self.0.contains_key(path) { Ok(path.to_owned()) } else { Disk.real(path) }
    }
}

/// A bridge file that was read. It does not change.
#[pyclass(frozen, module = "extrados")]
pub struct Project {
    /// The file itself.
    pub(crate) file: Arc<File>,
    beside: Beside,
}

#[pymethods]
impl Project {
    /// Reads a file and those that it names. `files` are held in memory and take the place of those of the disk.
    #[staticmethod]
    #[pyo3(signature = (path, files = None))]
    fn read(py: Python<'_>, path: PathBuf, files: Option<&Bound<'_, PyDict>>) -> PyResult<Project> {
        let beside = Beside(Arc::new(options::files(files)?.into_iter().collect()));
        Project::open(py, path, beside)
    }

    /// The path of the file, as it was given.
    fn name(&self) -> &str {
        self.file.name()
    }

    /// The text of the file.
    fn text(&self) -> String {
        String::from_utf8_lossy(self.file.text()).into_owned()
    }

    /// Files that are held in memory.
    fn files<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.beside.listed(py)
    }

    /// Everything that was found in it.
    fn findings<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let all = run::guarded(py, || errors::findings(&self.file))?;
        object::value(py, &serde_json::Value::Array(all))
    }

    /// Whether an analysis can be made of it.
    fn is_usable(&self) -> bool {
        self.file.meaning().bridge.is_some()
    }

    /// Path of the table or folder of records that it names, as it stands in the file.
    fn records_place(&self) -> Option<String> {
        Some(self.file.meaning().update.as_ref()?.records.as_ref()?.place.clone())
    }

    /// Names of the cases that it has.
    fn case_names(&self) -> Vec<String> {
        self.file.meaning().cases.iter().map(|case| case.name.clone()).collect()
    }

    /// Path, value, meaning and, where it is the default's, "default", of every quantity that it has.
    fn quantities<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        let found =
            run::guarded(py, || self.file.document_without_ranges().map(|document| bridge::vary::known(&document)))?;
        let all = found.map_err(|refusal| errors::refused(py, &[refusal]))?;
        let origin = |by_default: bool| if by_default { "default" } else { "file" };
        PyList::new(py, all.into_iter().map(|one| (one.path, one.value, one.doc, origin(one.by_default))))
    }

    /// The same file with other values: `joint.friction_angle=30deg`.
    fn edited(&self, py: Python<'_>, edits: Vec<String>) -> PyResult<Project> {
        self.usable(py)?;
        let made = run::guarded(py, || self.file.edited(&edits))?;
        let file = made.map_err(|refusals| errors::of_kind(py, "bridge", &refusals))?;
        if file.meaning().bridge.is_none() {
            return Err(errors::unusable(py, &file));
        }
        Ok(Project { file: Arc::new(file), beside: self.beside.clone() })
    }

    /// The bridge as its file describes it, as SVG.
    fn drawing(&self, py: Python<'_>) -> PyResult<String> {
        self.usable(py)?;
        let drawn =
            run::guarded(py, || extrados::as_built(&self.file).map(|picture| figures::bridge_as_drawn(&picture)))?;
        drawn.map_err(|refusal| errors::refused(py, &[refusal]))
    }

    /// A hash of everything that the numbers of an analysis follow from: what the file means, the analysis and its options, and the
    /// build. The text does not count: a comment changes nothing.
    fn key(&self, py: Python<'_>, analysis: &str, options: Given<'_, '_>, program: &str) -> PyResult<String> {
        self.usable(py)?;
        let read = self.file.meaning();
        let mut pairs: Vec<(String, String)> = Vec::new();
        for (name, value) in options.iter().filter(|(_, value)| !value.is_none()) {
            pairs.push((name.to_string(), value.repr()?.to_string()));
        }
        pairs.sort();
        run::guarded(py, || {
            let meaning = (&read.bridge, &read.cases, &read.update, &read.vary);
            let records = self.file.records().unwrap_or_default();
            let records: Vec<_> = records.iter().map(|file| blake3::hash(&file.bytes)).collect();
            Means { program, ..Means::default() }.key(analysis, &(pairs, meaning, records))
        })
    }

    #[pyo3(signature = (options, progress = None, resume = None))]
    fn collapse(&self, options: Given<'_, '_>, progress: Listener<'_, '_>, resume: Option<&State>) -> PyResult<Answer> {
        let py = options.py();
        let width = self.usable(py)?.width;
        let choice = Options::read(options, |given| given.choice(width))?;
        let resume = resume.map_or(Ok(None), |state| state.bytes(py))?;
        self.answered(py, progress, move |file, watch| {
            Ok(Found::Collapse(Box::new(extrados::collapse(file, &CollapseOptions { choice, resume }, watch)?)))
        })
    }

    #[pyo3(signature = (options, progress = None))]
    fn sweep(&self, py: Python<'_>, options: Given<'_, '_>, progress: Listener<'_, '_>) -> PyResult<Answer> {
        let width = self.usable(py)?.width;
        let (step, choice) = Options::read(options, |given| Ok((given.length("step")?, given.choice(width)?)))?;
        if let Some(method) = choice.method.filter(|method| !extrados::sweeps(*method)) {
            let message = format!("method = \"{}\" cannot be used: a sweep is limit analysis", method.word());
            let help = "leave method out, or write \"limit\", or \"path\" for deformable joints too";
            return Err(errors::argument(py, message, help));
        }
        self.answered(py, progress, move |file, watch| {
            Ok(match extrados::sweep(file, &SweepOptions { choice, step }, watch)? {
                Swept::Vehicles(found) => Found::Vehicles(found),
                Swept::Loads(found) => {
                    let name = file.bridge().map_or("", |bridge| bridge.name.as_str()).to_owned();
                    Found::Sweep(name, width, found)
                }
            })
        })
    }

    #[pyo3(signature = (options, progress = None))]
    fn respond(&self, py: Python<'_>, options: Given<'_, '_>, progress: Listener<'_, '_>) -> PyResult<Answer> {
        self.usable(py)?;
        let options = Options::read(options, passage_options)?;
        self.answered(py, progress, move |file, watch| {
            Ok(Found::Passage(Box::new(extrados::respond(file, &options, watch)?)))
        })
    }

    #[pyo3(signature = (options, program, progress = None, resume = None))]
    fn update(
        &self,
        py: Python<'_>,
        options: Given<'_, '_>,
        program: String,
        progress: Listener<'_, '_>,
        resume: Option<&State>,
    ) -> PyResult<Answer> {
        self.usable(py)?;
        let (records_only, options) = Options::read(options, |given| {
            let (search, variant, start) = (given.word("search")?, given.word("variant")?, given.word("start")?);
            Ok((given.flag("records_only")?, UpdateOptions { search, variant, start }))
        })?;
        let kept = kept(resume);
        let taken_up = if records_only { 0 } else { kept.lines() };
        self.keeping(py, progress, kept, program, move |file, means, watch| {
            let found = match records_only {
                true => extrados::judge(file, means, watch)?,
                false => extrados::update(file, &options, means, watch)?,
            };
            Ok(Some(Found::Update(Box::new(found), taken_up)))
        })
    }

    /// What the load test would tell; nothing where the file has none, or seeks nothing.
    fn plan_load_test<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        self.usable(py)?;
        let file = Arc::clone(&self.file);
        let found = run::guarded(py, || py.detach(move || extrados::plan_load_test(&file, &mut extrados::Unwatched)))?;
        let found = found.map_err(|refusal| errors::refused(py, &[refusal]))?;
        found.map(|plan| object::object(py, &plan.object())).transpose()
    }

    #[pyo3(signature = (options, program, progress = None, resume = None))]
    fn vary(
        &self,
        py: Python<'_>,
        options: Given<'_, '_>,
        program: String,
        progress: Listener<'_, '_>,
        resume: Option<&State>,
    ) -> PyResult<Answer> {
        let width = self.usable(py)?.width;
        let (ranges, options) = Options::read(options, |given| {
            let ranges = given.texts("ranges", "write a list such as [\"joint.friction_angle=30deg..40deg:5\"]")?;
            let options = VaryOptions {
                sweep: given.flag("sweep")?,
                grid: given.flag("grid")?,
                outcome: given.text("outcome", "write the name of a number, such as \"headline_kn_per_m\"")?,
                most_runs: given.count("most_runs")?.map_or(1000, |count| count as usize),
                choice: given.choice(width)?,
            };
            Ok((ranges, options))
        })?;
        let plan = extrados::planned(&self.file, &options.choice).map_err(|refusal| errors::refused(py, &[refusal]))?;
        let plan = plan.plan;
        let name = self.file.name().to_owned();
        self.keeping(py, progress, kept(resume), program, move |file, means, watch| {
            let requests =
                if ranges.is_empty() { file.meaning().vary.clone() } else { extrados::settings(file, &ranges)? };
            if requests.is_empty() {
                let help =
                    "add [[vary]] tables to the file, or name a range: vary(\"joint.friction_angle=30deg..40deg:5\")";
                return Err(vec![Refusal::new("F113", format!("{name} says nothing of what to vary"), help)]);
            }
            let found = extrados::vary(file, &requests, &options, means, watch)?;
            Ok(found.study.map(|study| Found::Study(Box::new(study), plan.tolerance, plan.seed)))
        })
    }

    #[pyo3(signature = (options, program, progress = None, resume = None))]
    fn assess(
        &self,
        py: Python<'_>,
        options: Given<'_, '_>,
        program: String,
        progress: Listener<'_, '_>,
        resume: Option<&State>,
    ) -> PyResult<Answer> {
        self.usable(py)?;
        let (skip, day) = Options::read(options, |given| {
            Ok((given.stages("skip")?, given.text("day", "write the day as \"2026-01-31\"")?.unwrap_or_default()))
        })?;
        let options = AssessOptions { skip, command: "extrados.Bridge.assess".to_owned(), day };
        self.keeping(py, progress, kept(resume), program, move |file, means, watch| {
            Ok(extrados::assess(file, &options, means, watch)?.map(|done| Found::Assessed(Box::new(done))))
        })
    }

    #[pyo3(signature = (options, progress = None))]
    fn cases(&self, py: Python<'_>, options: Given<'_, '_>, progress: Listener<'_, '_>) -> PyResult<Answer> {
        let width = self.usable(py)?.width;
        let choice = Options::read(options, |given| given.choice(width))?;
        self.answered(py, progress, move |file, watch| Ok(Found::Cases(extrados::cases(file, choice, watch)?)))
    }

    #[pyo3(signature = (other, options, progress = None))]
    fn compare(&self, other: &Project, options: Given<'_, '_>, progress: Listener<'_, '_>) -> PyResult<Answer> {
        let py = options.py();
        let width = self.usable(py)?.width;
        other.usable(py)?;
        let choice = Options::read(options, |given| given.choice(width))?;
        let (before, after) = (Arc::clone(&self.file), Arc::clone(&other.file));
        let files = vec![Arc::clone(&before), Arc::clone(&after)];
        worked(py, progress, None, files, move |watch| {
            Ok(Some(Found::Compared(Box::new(extrados::compare(&before, &after, choice, watch)?))))
        })
    }

    /// Numbers of a collapse by name, as studies have them: for loops over many bridges.
    fn collapse_numbers<'py>(&self, py: Python<'py>, options: &Bound<'py, PyDict>) -> PyResult<Bound<'py, PyDict>> {
        let answer = self.collapse(options, None, None)?;
        let all = PyDict::new(py);
        if let Found::Collapse(found) = &answer.found {
            for (name, number) in published::collapse_numbers(found) {
                all.set_item(name, number)?;
            }
        }
        Ok(all)
    }
}

/// How a train crosses.
pub(crate) fn passage_options(given: &Options<'_>) -> PyResult<RespondOptions> {
    Ok(RespondOptions { speed: given.speed("speed")?, analysis: given.word("analysis")?, path: given.word("path")? })
}

fn kept(resume: Option<&State>) -> Arc<Kept> {
    resume.and_then(|state| state.kept.clone()).unwrap_or_default()
}

/// Work on a file: what it gave, nothing where it was stopped, or why it cannot begin.
type Gave = Result<Option<Found>, Vec<Refusal>>;

impl Project {
    fn open(py: Python<'_>, path: PathBuf, beside: Beside) -> PyResult<Project> {
        let own = beside.clone();
        let read = run::run(py, None, move |_| File::read(&path, &own))?.given(py)?;
        let file = read.map_err(|refusal| errors::refused(py, &[refusal]))?;
        Ok(Project { file: Arc::new(file), beside })
    }

    /// The bridge, or everything that is wrong with its file.
    pub fn usable(&self, py: Python<'_>) -> PyResult<&bridge::Bridge> {
        match &self.file.meaning().bridge {
            Some(bridge) => Ok(bridge),
            None if bridge::is_block_file(self.file.text()) => {
                let message = format!("{} is a block model file", self.file.name());
                Err(errors::argument(py, message, "read it with extrados.Blocks.read"))
            }
            None => Err(errors::unusable(py, &self.file)),
        }
    }

    fn answered(
        &self,
        py: Python<'_>,
        progress: Listener<'_, '_>,
        work: impl FnOnce(&File, &mut run::Looker) -> Result<Found, Vec<Refusal>> + Send + 'static,
    ) -> PyResult<Answer> {
        let file = Arc::clone(&self.file);
        worked(py, progress, None, vec![Arc::clone(&file)], move |watch| work(&file, watch).map(Some))
    }

    /// Work that keeps its finished pieces, and takes up those of an interrupted call.
    fn keeping(
        &self,
        py: Python<'_>,
        progress: Listener<'_, '_>,
        kept: Arc<Kept>,
        program: String,
        work: impl FnOnce(&File, &Means<'_>, &mut run::Looker) -> Gave + Send + 'static,
    ) -> PyResult<Answer> {
        let (file, shelf) = (Arc::clone(&self.file), Arc::clone(&kept));
        worked(py, progress, Some(kept), vec![Arc::clone(&file)], move |watch| {
            let begun = Instant::now();
            let clock = || begun.elapsed().as_secs_f64();
            work(&file, &Means { shelf: &*shelf, clock: &clock, program: &program }, watch)
        })
    }
}

/// Runs work on files; an interruption becomes an exception that holds what there is.
fn worked(
    py: Python<'_>,
    progress: Listener<'_, '_>,
    kept: Option<Arc<Kept>>,
    files: Vec<Arc<File>>,
    work: impl FnOnce(&mut run::Looker) -> Gave + Send + 'static,
) -> PyResult<Answer> {
    let begun = Instant::now();
    let Finished { result, shared } = run::run(py, progress, work)?;
    let answer = |found| Answer { found, projects: files, seconds: begun.elapsed().as_secs_f64() };
    match result {
        Ok(Ok(Some(found))) => Ok(answer(found)),
        Ok(Ok(None)) => Err(errors::argument(py, "the work was stopped".to_owned(), "run it again")),
        Ok(Err(refusals)) => Err(errors::refused(py, &refusals)),
        Err((cause, found)) => {
            let found = found.and_then(Result::ok).flatten().map(|found| Bound::new(py, answer(found))).transpose()?;
            Err(run::interruption(py, cause, found.map(Bound::into_any), Some(shared), kept))
        }
    }
}

/// A block model file with its drawing.
#[pyclass(frozen, module = "extrados")]
pub struct BlockModel {
    blocks: Arc<extrados::Blocks>,
    beside: Beside,
}

#[pymethods]
impl BlockModel {
    /// Reads a block model file and its drawing. `files` are held in memory and take the place of those of the disk.
    #[staticmethod]
    #[pyo3(signature = (path, files = None))]
    fn read(py: Python<'_>, path: PathBuf, files: Option<&Bound<'_, PyDict>>) -> PyResult<BlockModel> {
        let beside = Beside(Arc::new(options::files(files)?.into_iter().collect()));
        let own = beside.clone();
        let read = run::run(py, None, move |_| extrados::Blocks::read(&path, &own))?.given(py)?;
        let blocks = read.map_err(|refusal| errors::refused(py, &[refusal]))?;
        if blocks.scene().is_none() {
            let own = blocks.findings().iter().map(|finding| {
                let text = extrados::finding_in_words(blocks.name(), blocks.text(), finding);
                serde_json::json!({ "code": finding.code, "severity": finding.severity.word(), "message": finding.message,
                    "help": finding.help, "text": text })
            });
            let drawn = blocks.drawing().into_iter().flat_map(|(_, all)| all).map(|finding| {
                serde_json::json!({ "code": finding.code, "severity": finding.severity.word(), "message": finding.message,
                    "help": finding.help, "text": format!("{}[{}]: {}: {}", finding.severity.word(), finding.code, finding.message, finding.place) })
            });
            let all: Vec<serde_json::Value> = own.chain(drawn).collect();
            let text: Vec<&str> = all.iter().filter_map(|one| one["text"].as_str()).collect();
            return Err(errors::exception(py, "bridge", &all, &text.join("\n")));
        }
        Ok(BlockModel { blocks: Arc::new(blocks), beside })
    }

    /// The path of the file, as it was given.
    fn name(&self) -> &str {
        self.blocks.name()
    }

    /// The text of the file.
    fn text(&self) -> String {
        String::from_utf8_lossy(self.blocks.text()).into_owned()
    }

    /// Files that are held in memory.
    fn files<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.beside.listed(py)
    }

    #[pyo3(signature = (options, progress = None, resume = None))]
    fn collapse(&self, options: Given<'_, '_>, progress: Listener<'_, '_>, resume: Option<&State>) -> PyResult<Answer> {
        let py = options.py();
        let choice = Options::read(options, |given| given.choice(1.0))?;
        let resume = resume.map_or(Ok(None), |state| state.bytes(py))?;
        let (blocks, options) = (Arc::clone(&self.blocks), CollapseOptions { choice, resume });
        worked(py, progress, None, Vec::new(), move |watch| {
            Ok(Some(Found::Collapse(Box::new(extrados::collapse_of_blocks(&blocks, &options, watch)?))))
        })
    }
}
