//! What an interrupted call leaves behind: the state of a run, and finished pieces of a study, an update or an assessment.

use crate::run::Shared;
use extrados::Refusal;
use extrados::shelf::Shelf;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::collections::BTreeMap;
use std::io;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Finished pieces in memory.
#[derive(Default)]
pub struct Kept(Mutex<Pieces>);

#[derive(Default, Clone, serde::Serialize, serde::Deserialize)]
struct Pieces {
    by_name: BTreeMap<String, Vec<u8>>,
    identity: String,
    lines: Vec<String>,
}

impl Kept {
    fn pieces(&self) -> MutexGuard<'_, Pieces> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// How many pieces there are.
    fn len(&self) -> usize {
        let pieces = self.pieces();
        pieces.by_name.len() + pieces.lines.len()
    }

    /// Evaluations of an update that are kept.
    pub fn lines(&self) -> usize {
        self.pieces().lines.len()
    }
}

impl Shelf for Kept {
    fn find(&self, name: &str) -> Option<Vec<u8>> {
        self.pieces().by_name.get(name).cloned()
    }

    fn put(&self, name: &str, bytes: &[u8]) -> io::Result<()> {
        self.pieces().by_name.insert(name.to_owned(), bytes.to_vec());
        Ok(())
    }

    fn evaluations(&self, identity: &str) -> Result<calibrate::Log, Refusal> {
        let mut pieces = self.pieces();
        let log = calibrate::Log::new(identity);
        if pieces.identity != identity {
            (pieces.identity, pieces.lines) = (identity.to_owned(), Vec::new());
            return Ok(log);
        }
        let text = format!("{}\n{}\n", log.head(), pieces.lines.join("\n"));
        Ok(calibrate::Log::read(identity, &text).map_or(log, |(known, _)| known))
    }

    fn append(&self, line: &str) {
        self.pieces().lines.push(line.to_owned());
    }

    fn appends(&self) -> bool {
        true
    }
}

/// From where an interrupted call goes on: give it as `resume`.
#[pyclass(frozen, module = "extrados")]
pub struct State {
    /// The run that was stopped, which leaves its state when it has come to its end.
    pub run: Option<Arc<Shared>>,
    /// The state of a run by discrete elements, where it was read back.
    pub bytes: Option<Vec<u8>>,
    /// Finished pieces.
    pub kept: Option<Arc<Kept>>,
}

impl State {
    /// The state of the run, once it has come to its end.
    pub fn bytes(&self, py: Python<'_>) -> PyResult<Option<Vec<u8>>> {
        match &self.run {
            Some(run) => run.state(py),
            None => Ok(self.bytes.clone()),
        }
    }
}

#[pymethods]
impl State {
    #[new]
    fn from_bytes(bytes: &[u8]) -> PyResult<State> {
        let (bytes, pieces): (Option<Vec<u8>>, Option<Pieces>) = serde_json::from_slice(bytes)
            .map_err(|_| pyo3::exceptions::PyValueError::new_err("these bytes are no state of extrados"))?;
        Ok(State { run: None, bytes, kept: pieces.map(|pieces| Arc::new(Kept(Mutex::new(pieces)))) })
    }

    fn to_bytes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let pieces = self.kept.as_ref().map(|kept| kept.pieces().clone());
        let bytes = serde_json::to_vec(&(self.bytes(py)?, pieces))
            .map_err(|error| pyo3::exceptions::PyValueError::new_err(error.to_string()))?;
        Ok(PyBytes::new(py, &bytes))
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, (Bound<'py, PyBytes>,))> {
        let class = slf.get_type().into_any();
        Ok((class, (slf.get().to_bytes(slf.py())?,)))
    }

    fn __repr__(&self) -> String {
        let pieces = self.kept.as_ref().map_or(0, |kept| kept.len());
        let run = if self.bytes.is_some() || self.run.is_some() { "of a run" } else { "of no run" };
        format!("<extrados.State {run}, with {pieces} finished pieces>")
    }
}
