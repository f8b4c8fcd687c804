//! Objects for scripts as Python's own.

use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use serde_json::{Map, Value};

/// Any JSON value.
pub(crate) fn value<'py>(py: Python<'py>, of: &Value) -> PyResult<Bound<'py, PyAny>> {
    match of {
        Value::Null => Ok(py.None().into_bound(py)),
        Value::Bool(flag) => flag.into_bound_py_any(py),
        Value::Number(number) => match (number.as_i64(), number.as_u64()) {
            (Some(whole), _) => whole.into_bound_py_any(py),
            (None, Some(whole)) => whole.into_bound_py_any(py),
            _ => number.as_f64().unwrap_or(f64::NAN).into_bound_py_any(py),
        },
        Value::String(text) => text.into_bound_py_any(py),
        Value::Array(list) => {
            let all = PyList::empty(py);
            list.iter().try_for_each(|one| all.append(value(py, one)?))?;
            Ok(all.into_any())
        }
        Value::Object(map) => Ok(object(py, map)?.into_any()),
    }
}

/// An object as a dictionary, its keys in their order.
pub(crate) fn object<'py>(py: Python<'py>, of: &Map<String, Value>) -> PyResult<Bound<'py, PyDict>> {
    let all = PyDict::new(py);
    of.iter().try_for_each(|(key, one)| all.set_item(key, value(py, one)?))?;
    Ok(all)
}
