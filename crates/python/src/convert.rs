//! Answers as Python objects: dictionaries, lists and numbers, by the names of the command's JSON.

use crate::error::internal;
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyList};
use serde::Serialize;
use serde_json::Value;

/// Anything that the command prints as JSON.
pub fn to_python<'py>(py: Python<'py>, answer: &impl Serialize) -> PyResult<Bound<'py, PyAny>> {
    let value = serde_json::to_value(answer).map_err(|error| internal(py, &error.to_string()))?;
    object(py, &value)
}

/// Numbers stay as they are; what JSON has no number for is None.
fn object<'py>(py: Python<'py>, value: &Value) -> PyResult<Bound<'py, PyAny>> {
    match value {
        Value::Null => Ok(py.None().into_bound(py)),
        Value::Bool(truth) => truth.into_bound_py_any(py),
        Value::Number(number) => match (number.as_u64(), number.as_i64(), number.as_f64()) {
            (Some(count), _, _) => count.into_bound_py_any(py),
            (_, Some(count), _) => count.into_bound_py_any(py),
            (_, _, number) => number.into_bound_py_any(py),
        },
        Value::String(text) => text.into_bound_py_any(py),
        Value::Array(values) => {
            let list = PyList::empty(py);
            values.iter().try_for_each(|value| list.append(object(py, value)?))?;
            Ok(list.into_any())
        }
        Value::Object(fields) => {
            let dict = PyDict::new(py);
            fields.iter().try_for_each(|(name, value)| dict.set_item(name, object(py, value)?))?;
            Ok(dict.into_any())
        }
    }
}

/// Plain values of Python, as [`to_python`] makes them; anything else is null.
pub fn from_python(value: &Bound<'_, PyAny>) -> PyResult<Value> {
    if let Ok(fields) = value.cast::<PyDict>() {
        let pairs = fields.iter().map(|(name, value)| Ok((name.extract::<String>()?, from_python(&value)?)));
        return Ok(Value::Object(pairs.collect::<PyResult<_>>()?));
    }
    if let Ok(values) = value.cast::<PyList>() {
        return Ok(Value::Array(values.iter().map(|value| from_python(&value)).collect::<PyResult<_>>()?));
    }
    if let Ok(text) = value.extract::<String>() {
        return Ok(Value::String(text));
    }
    if value.is_instance_of::<PyBool>() {
        return Ok(Value::Bool(value.extract()?));
    }
    if let Ok(count) = value.extract::<i64>() {
        return Ok(count.into());
    }
    Ok(value.extract::<f64>().map_or(Value::Null, Value::from))
}
