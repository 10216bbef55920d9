//! Numbers and texts as arguments: what Python would convert by guess is a `TypeError`, what does not
//! fit is a `ValueError`.

use ncp_spec::ErrorCode;
use pyo3::exceptions::{PyOverflowError, PyTypeError};
use pyo3::prelude::*;
use pyo3::pybacked::{PyBackedBytes, PyBackedStr};
use pyo3::types::{PyBool, PyByteArray, PyBytes, PyString};

use crate::error::{Error, Result};

/// A double: anything with `__float__` or `__index__` but a bool.
pub(crate) fn double(value: &Bound<'_, PyAny>) -> PyResult<f64> {
    Ok(double_of(value)?)
}

/// A double, or nothing.
pub(crate) fn optional_double(value: &Bound<'_, PyAny>) -> PyResult<Option<f64>> {
    if value.is_none() {
        return Ok(None);
    }
    double(value).map(Some)
}

/// A 64-bit integer: anything with `__index__` but a bool.
pub(crate) fn integer(value: &Bound<'_, PyAny>) -> PyResult<i64> {
    Ok(integer_of(value)?)
}

/// As [`double`].
pub(crate) fn double_of(value: &Bound<'_, PyAny>) -> Result<f64> {
    if value.is_instance_of::<PyBool>() {
        return Err(wrong_type("a number", value).into());
    }
    value.extract().map_err(|error| fitting(value.py(), error, "an integer beyond the largest double"))
}

/// As [`integer`].
pub(crate) fn integer_of(value: &Bound<'_, PyAny>) -> Result<i64> {
    if value.is_instance_of::<PyBool>() {
        return Err(wrong_type("an integer", value).into());
    }
    value.extract().map_err(|error| fitting(value.py(), error, "an integer beyond 64 bits"))
}

/// A count, from 0.
pub(crate) fn index(value: &Bound<'_, PyAny>) -> PyResult<usize> {
    usize::try_from(integer(value)?).map_err(|_| Error::refused(ErrorCode::Value, &"an index is not negative").into())
}

/// Three doubles.
pub(crate) fn vector(value: &Bound<'_, PyAny>) -> PyResult<[f64; 3]> {
    doubles(value)
}

/// Two doubles, the ends of a range.
pub(crate) fn range(value: &Bound<'_, PyAny>) -> PyResult<(f64, f64)> {
    doubles(value).map(|[from, to]| (from, to))
}

/// A `TypeError` for a value.
pub(crate) fn wrong_type(expected: &str, found: &Bound<'_, PyAny>) -> PyErr {
    let name = found.get_type().name();
    let name = name.as_ref().map_or("something else".into(), ToString::to_string);
    PyTypeError::new_err(format!("expected {expected}, found {name}"))
}

/// A frame as it arrived: `str` or `bytes`.
pub(crate) enum Frame {
    Text(PyBackedStr),
    Bytes(PyBackedBytes),
}

impl Frame {
    pub(crate) fn bytes(&self) -> &[u8] {
        match self {
            Self::Text(text) => text.as_bytes(),
            Self::Bytes(bytes) => bytes,
        }
    }
}

impl<'py> FromPyObject<'_, 'py> for Frame {
    type Error = PyErr;

    fn extract(value: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        if value.is_instance_of::<PyString>() {
            value.extract().map(Self::Text)
        } else if value.is_instance_of::<PyBytes>() || value.is_instance_of::<PyByteArray>() {
            value.extract().map(Self::Bytes).map_err(Into::into)
        } else {
            Err(wrong_type("a frame, str or bytes", &value))
        }
    }
}

fn doubles<const N: usize>(value: &Bound<'_, PyAny>) -> PyResult<[f64; N]> {
    let misfit = || wrong_type(&format!("{N} numbers"), value);
    if value.is_instance_of::<PyString>() || value.len()? != N {
        return Err(misfit());
    }
    let mut found = [0.0; N];
    let mut items = value.try_iter()?;
    for slot in &mut found {
        *slot = double(&items.next().ok_or_else(misfit)??)?;
    }
    Ok(found)
}

/// An `OverflowError` is no `ValueError` in Python, but means one here.
fn fitting(py: Python<'_>, error: PyErr, what: &str) -> Error {
    if error.is_instance_of::<PyOverflowError>(py) { Error::refused(ErrorCode::Value, &what) } else { error.into() }
}
