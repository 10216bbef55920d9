//! The BulkBlock: chapter 5. The package's `bulk.py` makes arrays of it.

use std::borrow::Cow;

use bytemuck::Pod;
use ncp_spec::ErrorCode;
use ncp_spec::bulk::{self, Block, ColumnRef, DataRef, Dtype};
use pyo3::prelude::*;
use pyo3::pybacked::{PyBackedBytes, PyBackedStr};
use pyo3::types::PyBytes;

use crate::error::{Error, Result};

/// Checks a block and returns where its columns lie: name, dtype, rows, and the offset of the data in bytes.
#[pyfunction]
pub(crate) fn bulk_directory(block: &Bound<'_, PyBytes>) -> Result<Vec<(String, &'static str, usize, usize)>> {
    let bytes = block.as_bytes();
    let block = Block::parse(bytes)?;
    let start = bytes.as_ptr().addr();
    let columns = block.columns().map(|column| {
        (column.name().to_owned(), column.dtype().as_str(), column.rows(), column.bytes().as_ptr().addr() - start)
    });
    Ok(columns.collect())
}

/// Writes a block of columns: name, dtype, and the values' bytes as they lie in memory.
#[pyfunction]
pub(crate) fn bulk_encode<'py>(
    py: Python<'py>,
    columns: Vec<(PyBackedStr, PyBackedStr, PyBackedBytes)>,
) -> Result<Bound<'py, PyBytes>> {
    let values: Vec<Values<'_>> =
        columns.iter().map(|(_, dtype, bytes)| Values::of(dtype, bytes)).collect::<Result<_>>()?;
    let columns = columns.iter().zip(&values);
    let columns: Vec<ColumnRef<'_>> =
        columns.map(|((name, ..), values)| ColumnRef::new(name, values.borrow())).collect();
    Ok(PyBytes::new(py, &bulk::encode(&columns)?))
}

/// Writes the arrays of an observation as a block: the bytes of two of f64 and one of i64, as they lie in memory.
#[pyfunction]
pub(crate) fn observation_pack(
    py: Python<'_>,
    times: PyBackedBytes,
    values: PyBackedBytes,
    senders: PyBackedBytes,
) -> Result<Bound<'_, PyBytes>> {
    let block = bulk::pack(&cast(&times)?, &cast(&values)?, &cast(&senders)?)?;
    Ok(PyBytes::new(py, &block))
}

/// Checks that a block holds the arrays of an observation.
#[pyfunction]
pub(crate) fn observation_check(block: &Bound<'_, PyBytes>) -> Result<()> {
    bulk::unpack(block.as_bytes())?;
    Ok(())
}

/// The values of a column, borrowed where their bytes lie as values do.
enum Values<'a> {
    F32(Cow<'a, [f32]>),
    F64(Cow<'a, [f64]>),
    I32(Cow<'a, [i32]>),
    I64(Cow<'a, [i64]>),
}

impl<'a> Values<'a> {
    fn of(dtype: &str, bytes: &'a [u8]) -> Result<Self> {
        let unknown = || Error::refused(ErrorCode::Value, &"a dtype is f32, f64, i32 or i64");
        Ok(match Dtype::parse(dtype).ok_or_else(unknown)? {
            Dtype::F32 => Self::F32(cast(bytes)?),
            Dtype::F64 => Self::F64(cast(bytes)?),
            Dtype::I32 => Self::I32(cast(bytes)?),
            Dtype::I64 => Self::I64(cast(bytes)?),
        })
    }

    fn borrow(&self) -> DataRef<'_> {
        match self {
            Self::F32(values) => DataRef::F32(values),
            Self::F64(values) => DataRef::F64(values),
            Self::I32(values) => DataRef::I32(values),
            Self::I64(values) => DataRef::I64(values),
        }
    }
}

fn cast<T: Pod>(bytes: &[u8]) -> Result<Cow<'_, [T]>> {
    if !bytes.len().is_multiple_of(size_of::<T>()) {
        let what = "the bytes are not whole values";
        return Err(Error::refused(ErrorCode::Value, &what));
    }
    Ok(match bytemuck::try_cast_slice(bytes) {
        Ok(values) => Cow::Borrowed(values),
        Err(_) => Cow::Owned(bytes.chunks_exact(size_of::<T>()).map(bytemuck::pod_read_unaligned).collect()),
    })
}
