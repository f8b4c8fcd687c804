//! Runs in the hands of Python: a collapse by discrete elements some steps at a time, a passage some positions at a time.

use crate::answer::{Answer, Found};
use crate::arrays;
use crate::errors;
use crate::options::{Given, Listener, Options};
use crate::project::{Project, passage_options};
use crate::run;
use extrados::results::passage::{Moment, PassageStatus};
use extrados::{Passing, Stepping, Watch, Wish};
use ndarray::Array2;
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Instant;

/// Steps between two looks at whether somebody asked to stop: some milliseconds of a large model.
const CHUNK: u64 = 50;

fn locked<T>(of: &Mutex<T>) -> MutexGuard<'_, T> {
    of.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Work on a run that is kept whatever happens; Ctrl-C ends the call and leaves the run where it is.
fn moved<S: Send + 'static, T: Send + 'static>(
    py: Python<'_>,
    held: &Arc<Mutex<S>>,
    progress: Listener<'_, '_>,
    work: impl FnOnce(&mut S, &mut run::Looker) -> T + Send + 'static,
) -> PyResult<T> {
    let own = Arc::clone(held);
    run::run(py, progress, move |watch| work(&mut locked(&own), watch))?.given(py)
}

/// Last stable load and collapse load [kN/m], and all iterations.
type Loads = (Option<f64>, Option<f64>, u64);

/// A collapse by discrete elements that goes on when it is told to.
#[pyclass(frozen, module = "extrados")]
pub struct CollapseRun {
    held: Arc<Mutex<Option<Stepping>>>,
    loads: [f64; 2],
}

#[pymethods]
impl CollapseRun {
    #[new]
    fn new(py: Python<'_>, project: &Project, options: Given<'_, '_>) -> PyResult<CollapseRun> {
        let width = project.usable(py)?.width;
        let choice = Options::read(options, |given| given.choice(width))?;
        let file = Arc::clone(&project.file);
        let run = run::run(py, None, move |_| Stepping::new(&file, &choice))?.given(py)?;
        let run = run.map_err(|refusal| errors::refused(py, &[refusal]))?;
        let loads = [run.blocks().load(0.0), run.blocks().load(1.0)];
        Ok(CollapseRun { held: Arc::new(Mutex::new(Some(run))), loads })
    }

    /// Goes on for so many steps or to the end; gives the word for how it ended.
    fn advance(&self, py: Python<'_>, steps: u64) -> PyResult<Option<String>> {
        moved(py, &self.held, None, move |held, watch| {
            let run = held.as_mut()?;
            let mut left = steps;
            while left > 0 {
                let now = left.min(CHUNK);
                if let Some(status) = run.advance(now) {
                    return Some(Stepping::ended(status).word().to_owned());
                }
                left -= now;
                let told = extrados::Progress { stage: "stepping".to_owned(), fraction: None, steps: steps - left };
                if watch.look(&told) == Wish::Stop {
                    break;
                }
            }
            None
        })
    }

    /// The load that acts [kN/m].
    fn load(&self) -> Option<f64> {
        locked(&self.held).as_ref().map(|run| run.load() / 1e3)
    }

    /// Blocks, contacts and particles as they are now, as arrays of their own.
    fn frame<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let Some(frame) = locked(&self.held).as_ref().map(Stepping::frame) else { return Ok(None) };
        let all = PyDict::new(py);
        let pair = |at: mechanics::plane::Vec2| [at.x, at.y];
        all.set_item("load_kn_per_m", self.load_of(frame.factor) / 1e3)?;
        all.set_item("iterations", frame.iterations)?;
        all.set_item("centres_m", table(py, frame.poses.iter().map(|pose| pair(pose.position)))?)?;
        all.set_item(
            "angles_rad",
            list(py, frame.poses.iter().map(|pose| pose.rotation.sin.atan2(pose.rotation.cos))),
        )?;
        all.set_item("velocities_m_per_s", table(py, frame.velocities.iter().map(|one| pair(one.0)))?)?;
        all.set_item("stresses_pa", table(py, frame.stresses.iter().copied())?)?;
        all.set_item("contact_points_m", table(py, frame.contacts.iter().map(|one| pair(one.point)))?)?;
        all.set_item("contact_compressions_n_per_m", list(py, frame.contacts.iter().map(|one| one.compression)))?;
        all.set_item("contact_shears_n_per_m", list(py, frame.contacts.iter().map(|one| one.shear)))?;
        all.set_item("particle_centres_m", table(py, frame.particles.iter().map(|one| pair(one.centre)))?)?;
        all.set_item("particle_radii_m", list(py, frame.particles.iter().map(|one| one.radius)))?;
        Ok(Some(all))
    }

    /// Ends the run: the last stable load and the load that made it collapse [kN/m], and all iterations.
    fn finish(&self, py: Python<'_>) -> PyResult<Option<Loads>> {
        let Some(run) = locked(&self.held).take() else { return Ok(None) };
        let found = run::guarded(py, || run.finish())?;
        let load = |factor: f64| self.load_of(factor) / 1e3;
        let steps = found.iterations_total;
        Ok(Some((found.last_stable_factor.map(load), found.collapse_factor.map(load), steps)))
    }
}

impl CollapseRun {
    fn load_of(&self, factor: f64) -> f64 {
        self.loads[0] + factor * (self.loads[1] - self.loads[0])
    }
}

fn list<'py>(py: Python<'py>, all: impl Iterator<Item = f64>) -> Bound<'py, PyArray1<f64>> {
    PyArray1::from_iter(py, all)
}

fn table<'py, const N: usize>(
    py: Python<'py>,
    rows: impl Iterator<Item = [f64; N]>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let flat: Vec<f64> = rows.flatten().collect();
    let array = Array2::from_shape_vec((flat.len() / N, N), flat);
    let array = array.map_err(|error| pyo3::exceptions::PyValueError::new_err(error.to_string()))?;
    Ok(PyArray2::from_owned_array(py, array))
}

/// A passage that goes on when it is told to.
#[pyclass(frozen, module = "extrados")]
pub struct PassageRun {
    held: Arc<Mutex<Option<Passing>>>,
    project: Py<Project>,
    begun: Instant,
}

#[pymethods]
impl PassageRun {
    #[new]
    #[pyo3(signature = (project, options, progress = None))]
    fn new(project: Bound<'_, Project>, options: Given<'_, '_>, progress: Listener<'_, '_>) -> PyResult<PassageRun> {
        let py = project.py();
        project.get().usable(py)?;
        let options = Options::read(options, passage_options)?;
        let (file, begun) = (Arc::clone(&project.get().file), Instant::now());
        let run = run::run(py, progress, move |watch| Passing::new(&file, &options, watch))?.given(py)?;
        let run = run.map_err(|refusal| errors::refused(py, &[refusal]))?;
        Ok(PassageRun { held: Arc::new(Mutex::new(Some(run))), project: project.unbind(), begun })
    }

    /// Moves the train on by so many positions; gives the word for how the passage ended.
    #[pyo3(signature = (positions, progress = None))]
    fn advance(&self, py: Python<'_>, positions: usize, progress: Listener<'_, '_>) -> PyResult<Option<&'static str>> {
        let ended = moved(py, &self.held, progress, move |held, watch| {
            held.as_mut().map_or(Ok(None), |run| run.advance(positions, watch))
        })?;
        let ended: Option<PassageStatus> = ended.map_err(|refusal| errors::refused(py, &[refusal]))?;
        Ok(ended.map(PassageStatus::word))
    }

    /// Time [s] and place of the first axle [m] at the position that was reached last.
    fn place(&self) -> Option<(f64, f64)> {
        locked(&self.held).as_ref().and_then(Passing::place)
    }

    /// Values of the sensors there, in SI units, in the order of `sensors`.
    fn values<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let values: Vec<f64> = locked(&self.held).as_ref().map_or_else(Vec::new, |run| run.values().collect());
        PyArray1::from_vec(py, values)
    }

    /// Names of the sensors.
    fn sensors(&self) -> Vec<String> {
        let held = locked(&self.held);
        held.as_ref().map_or_else(Vec::new, |run| run.setup().sensors.iter().map(|one| one.name.clone()).collect())
    }

    /// How many positions there are.
    fn positions(&self) -> usize {
        locked(&self.held).as_ref().map_or(0, |run| run.setup().positions.len())
    }

    /// Displacements, stresses and joints there.
    fn moment(&self, py: Python<'_>) -> PyResult<Option<PassageMoment>> {
        let found = moved(py, &self.held, None, |held, _| held.as_mut().map(Passing::moment))?;
        let found = found.transpose().map_err(|refusal| errors::refused(py, &[refusal]))?;
        Ok(found.map(|moment| PassageMoment { moment }))
    }

    /// Ends the passage where it is.
    #[pyo3(signature = (progress = None))]
    fn finish(&self, py: Python<'_>, progress: Listener<'_, '_>) -> PyResult<Option<Answer>> {
        let found = moved(py, &self.held, progress, |held, watch| held.take().map(|run| run.finish(watch)))?;
        let found = found.transpose().map_err(|refusal| errors::refused(py, &[refusal]))?;
        let (projects, seconds) = (vec![Arc::clone(&self.project.get().file)], self.begun.elapsed().as_secs_f64());
        Ok(found.map(|found| Answer { found: Found::Passage(Box::new(found)), projects, seconds }))
    }
}

/// The bridge at one position of a passage.
#[pyclass(frozen, module = "extrados")]
pub struct PassageMoment {
    moment: Moment,
}

#[pymethods]
impl PassageMoment {
    /// Name, time [s] and place of the first axle [m].
    fn place(&self) -> (String, f64, f64) {
        (self.moment.name.clone(), self.moment.time, self.moment.position)
    }

    /// A column that looks into the moment; `within` tells which joint.
    #[pyo3(signature = (name, within = 0))]
    fn array<'py>(slf: &Bound<'py, Self>, name: &str, within: usize) -> PyResult<Option<Bound<'py, PyAny>>> {
        arrays::of_moment(slf.as_any(), &slf.get().moment, name, within)
    }

    /// How many joints and contacts there are.
    fn rows(&self) -> usize {
        self.moment.rows.len()
    }
}
