//! The arrays of an observation as a block. `[NCP-OBS-001]`

use ncp_spec::wire::Observation;

use super::{Block, BulkError, ColumnRef, ColumnView, Element, encode};

/// The arrays of one observation, in step with each other: `times` in ms, `values` in the
/// observation's unit, `senders` as neurons' numbers.
pub type Arrays = (Vec<f64>, Vec<f64>, Vec<i64>);

/// Packs an observation's arrays: those that are not empty become the columns
/// `times`, `values` (f64) and `senders` (i64), in this order.
///
/// Three empty arrays make a block without columns.
/// Requirements: NCP-OBS-001 to NCP-OBS-003.
///
/// # Errors
/// Two non-empty arrays of different length, or a block over the limit.
pub fn pack(times: &[f64], values: &[f64], senders: &[i64]) -> Result<Vec<u8>, BulkError> {
    check_rows([(TIMES, times.len()), (VALUES, values.len()), (SENDERS, senders.len())])?;
    let columns = [
        ColumnRef::new(TIMES, times), // [NCP-OBS-001]
        ColumnRef::new(VALUES, values),
        ColumnRef::new(SENDERS, senders),
    ];
    let present: Vec<_> = columns.into_iter().filter(|column| !column.data.is_empty()).collect(); // [NCP-OBS-002]
    encode(&present)
}

/// Packs the arrays of an [`Observation`] as [`pack`] does. Its other fields have their
/// own place in a [`BulkObservation`](ncp_spec::wire::BulkObservation).
///
/// # Errors
/// As [`pack`].
pub fn pack_observation(observation: &Observation) -> Result<Vec<u8>, BulkError> {
    pack(&observation.times, &observation.values, &observation.senders)
}

/// Reads an observation's arrays out of a block; an absent column is an empty array,
/// columns of other names are ignored.
///
/// What it allocates is no longer than the block.
/// Requirements: NCP-OBS-004 to NCP-OBS-008.
///
/// # Errors
/// A buffer that is no block; a `times`, `values` or `senders` of another type than
/// [`pack`] gives it; or two of them that are not empty and differ in length.
pub fn unpack(block: &[u8]) -> Result<Arrays, BulkError> {
    let block = Block::parse(block)?;
    let times = find::<f64>(&block, TIMES)?;
    let values = find::<f64>(&block, VALUES)?;
    let senders = find::<i64>(&block, SENDERS)?;

    let rows = |view: &Option<ColumnView<'_>>| view.as_ref().map_or(0, ColumnView::rows);
    check_rows([(TIMES, rows(&times)), (VALUES, rows(&values)), (SENDERS, rows(&senders))])?;
    Ok((copy(times), copy(values), copy(senders)))
}

const TIMES: &str = "times";
const VALUES: &str = "values";
const SENDERS: &str = "senders";

/// Arrays that are there agree in length. [NCP-OBS-003] [NCP-OBS-004]
fn check_rows(arrays: [(&'static str, usize); 3]) -> Result<(), BulkError> {
    let mut present = arrays.into_iter().filter(|(_, rows)| *rows > 0);
    let Some((first, first_rows)) = present.next() else {
        return Ok(());
    };
    match present.find(|(_, rows)| *rows != first_rows) {
        Some((second, second_rows)) => Err(BulkError::RowsDiffer { first, first_rows, second, second_rows }),
        None => Ok(()),
    }
}

/// The column of this name, wherever it stands, if it has the type `T`. [NCP-OBS-008]
fn find<'a, T: Element>(block: &Block<'a>, name: &'static str) -> Result<Option<ColumnView<'a>>, BulkError> {
    match block.find(name) {
        Some((column, view)) if view.dtype() != T::DTYPE => {
            // [NCP-OBS-006]
            Err(BulkError::ColumnDtype { column, name, expected: T::DTYPE, found: view.dtype() })
        }
        Some((_, view)) => Ok(Some(view)),
        None => Ok(None),
    }
}

/// The values of a column of type `T`; none if it is not there. [NCP-OBS-005]
fn copy<T: Element>(view: Option<ColumnView<'_>>) -> Vec<T> {
    view.and_then(|view| view.to_vec()).unwrap_or_default()
}
