//! The extension module of the Python package `extrados`: the crate of the same name, typed on the other side by
//! `python/extrados/`. Nothing here computes; `run` keeps work away from the interpreter, `view` lets NumPy look into results.

mod answer;
mod arrays;
mod errors;
mod examples;
mod kept;
mod object;
mod options;
mod project;
mod run;
mod stepping;
mod view;

use pyo3::prelude::*;
use pyo3::types::PyBytes;

/// The version of the program.
#[pyfunction]
fn version() -> &'static str {
    env!("CARGO_PKG_VERSION")
}

/// How many threads analyses use; `EXTRADOS_THREADS` sets it before the first analysis.
#[pyfunction]
fn threads() -> usize {
    run::threads()
}

/// An example: the text of its bridge file, and the files beside it.
#[pyfunction]
fn example(name: &str) -> Option<examples::Example> {
    examples::named(name)
}

/// Names of the examples.
#[pyfunction]
fn examples_known() -> Vec<&'static str> {
    examples::names()
}

/// A drawing in SVG as a picture in PNG, so many pixels wide.
#[pyfunction]
fn png(py: Python<'_>, svg: String, width_px: u32) -> PyResult<Bound<'_, PyBytes>> {
    let drawn = run::run(py, None, move |_| figures::png(&svg, width_px))?.given(py)?;
    let bytes = drawn.map_err(|error| match error {
        figures::RasterError::Size(..) => {
            errors::argument(py, format!("width_px = {width_px} cannot be used: {error}"), "give 1 to 20000 pixels")
        }
        _ => errors::argument(py, error.to_string(), "give a drawing as a result has it"),
    })?;
    Ok(PyBytes::new(py, &bytes))
}

/// Width of a picture where none is said [pixels].
#[pyfunction]
fn png_width() -> u32 {
    figures::PNG_WIDTH
}

/// Breaks, for the tests of what happens then.
#[pyfunction]
#[pyo3(signature = (deep = false))]
fn _break(py: Python<'_>, deep: bool) -> PyResult<()> {
    let broken = run::run(py, None, move |_| match deep {
        true => rayon::join(|| panic!("a test breaks on a thread of the pool"), || ()).1,
        false => panic!("a test breaks"),
    })?;
    broken.given(py)
}

/// Does nothing for a while, in steps of a millisecond that can be interrupted, for tests of interruption.
#[pyfunction]
#[pyo3(signature = (seconds, progress = None))]
fn _wait(py: Python<'_>, seconds: f64, progress: options::Listener<'_, '_>) -> PyResult<u64> {
    let done = run::run(py, progress, move |watch| {
        let begun = std::time::Instant::now();
        let mut looks = 0;
        while begun.elapsed().as_secs_f64() < seconds {
            looks += 1;
            let fraction = Some(begun.elapsed().as_secs_f64() / seconds);
            let told = extrados::Progress { stage: "waiting".to_owned(), fraction, steps: looks };
            if extrados::Watch::look(watch, &told) == extrados::Wish::Stop {
                break;
            }
            std::thread::sleep(std::time::Duration::from_millis(1));
        }
        looks
    })?;
    done.given(py)
}

/// The sum of the limit loads [kN/m] of bridges that differ in a friction angle, from a loop in Rust: what a loop in Python is held against.
#[pyfunction]
fn _limit_loads(py: Python<'_>, path: std::path::PathBuf, count: u32) -> PyResult<f64> {
    use extrados::{Choice, CollapseOptions, Disk, Refusal, Unwatched};
    let sum = move || -> Result<f64, Vec<Refusal>> {
        let project = extrados::Project::read(path, &Disk)?;
        let choice = Choice { method: Some(bridge::Method::Limit), ..Choice::default() };
        let mut sum = 0.0;
        for k in 0..count {
            let angle = 25.0 + 15.0 * f64::from(k) / f64::from(count);
            let edited = project.with(&[format!("joint.friction_angle={angle} deg")])?;
            let options = CollapseOptions { choice, resume: None };
            sum += extrados::collapse(&edited, &options, &mut Unwatched)?.last_stable_load.unwrap_or(0.0) / 1e3;
        }
        Ok(sum)
    };
    let found = run::run(py, None, move |_| sum())?.given(py)?;
    found.map_err(|refusals| errors::refused(py, &refusals))
}

/// The extension module.
#[pymodule]
fn _extrados(module: &Bound<'_, PyModule>) -> PyResult<()> {
    run::keep_panics();
    module.add_class::<project::Project>()?;
    module.add_class::<project::BlockModel>()?;
    module.add_class::<answer::Answer>()?;
    module.add_class::<kept::State>()?;
    module.add_class::<stepping::CollapseRun>()?;
    module.add_class::<stepping::PassageRun>()?;
    module.add_class::<stepping::PassageMoment>()?;
    module.add_function(wrap_pyfunction!(version, module)?)?;
    module.add_function(wrap_pyfunction!(threads, module)?)?;
    module.add_function(wrap_pyfunction!(example, module)?)?;
    module.add_function(wrap_pyfunction!(examples_known, module)?)?;
    module.add_function(wrap_pyfunction!(png, module)?)?;
    module.add_function(wrap_pyfunction!(png_width, module)?)?;
    module.add_function(wrap_pyfunction!(_break, module)?)?;
    module.add_function(wrap_pyfunction!(_wait, module)?)?;
    module.add_function(wrap_pyfunction!(_limit_loads, module)?)?;
    Ok(())
}
