//! Beyond the seed: BulkBlocks. Reading one copies nothing.

use std::ffi::{c_char, c_void};
use std::mem::MaybeUninit;

use ncp_spec::ErrorCode;
use ncp_spec::bulk::{self, Block, ColumnRef, DataRef, Dtype};

use crate::abi::{Refusal, bytes, entry, items, required, sized};

/// A column of a block, lent: by the block when it is read, by the caller when it is written.
#[repr(C)]
pub struct BlockColumn {
    /// The name, UTF-8, without a NUL at its end.
    pub name: *const c_char,
    /// Bytes of the name.
    pub name_len: usize,
    /// The type of the values: NCP_F32, NCP_F64, NCP_I32 or NCP_I64.
    pub dtype: i32,
    /// Number of values.
    pub rows: usize,
    /// The values. In a column that is written: in the machine's own order, aligned. In one that was read:
    /// little-endian, and at any address, so copy them with memcpy before they are used.
    pub data: *const c_void,
}

/// IEEE 754 binary32.
pub const NCP_F32: i32 = 1;
/// IEEE 754 binary64.
pub const NCP_F64: i32 = 2;
/// Two's complement, 32 bits.
pub const NCP_I32: i32 = 3;
/// Two's complement, 64 bits.
pub const NCP_I64: i32 = 4;

/// A checked block: a view of the caller's bytes.
pub struct BlockView(Block<'static>);

/// Checks a block and lends views of it, or NULL if it breaks a rule. The bytes must stay as they are until
/// ncp_block_free. Views may be read by many threads at once.
///
/// # Safety
/// There are that many bytes, and they outlive the view.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ncp_block_parse(block: *const u8, block_len: usize) -> Option<Box<BlockView>> {
    entry(|| {
        // SAFETY: as this function demands; the view is their only user.
        let block: &'static [u8] = unsafe { bytes(block, block_len, "block")? };
        Ok(Some(Box::new(BlockView(Block::parse(block)?))))
    })
}

/// The number of columns; 0 for NULL.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_block_columns(block: Option<&BlockView>) -> usize {
    entry(|| Ok(required(block, "block")?.0.len()))
}

/// A column by its place in the directory, from 0: 1, or -1 past the last.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_block_column(
    block: Option<&BlockView>,
    index: usize,
    column: Option<&mut MaybeUninit<BlockColumn>>,
) -> i32 {
    entry(|| {
        let BlockView(block) = required(block, "block")?;
        let out = required(column, "column")?;
        let view = block
            .column(index)
            .ok_or_else(|| Refusal::new(ErrorCode::Invalid, format_args!("there is no column {index}")))?;
        out.write(BlockColumn {
            name: view.name().as_ptr().cast(),
            name_len: view.name().len(),
            dtype: i32::from(view.dtype().code()),
            rows: view.rows(),
            data: view.bytes().as_ptr().cast(),
        });
        Ok(1)
    })
}

/// Frees a view, not the bytes of the block. NULL is nothing.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_block_free(block: Option<Box<BlockView>>) {
    entry(|| {
        drop(block);
        Ok(())
    });
}

/// Writes the block of these columns, which the caller frees with ncp_bytes_free, or NULL.
///
/// # Safety
/// There are that many columns, and of each as many values of its type, and bytes of its name, as it says.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ncp_block_encode(
    columns: *const BlockColumn,
    count: usize,
    block_len: Option<&mut MaybeUninit<usize>>,
) -> *mut u8 {
    entry(|| {
        let out = required(block_len, "block_len")?;
        // SAFETY: as this function demands.
        let columns = unsafe { items(columns, count, "columns")? };
        let columns: Vec<ColumnRef<'_>> = columns
            .iter()
            // SAFETY: as this function demands.
            .map(|column| unsafe { column_in(column) })
            .collect::<Result<_, _>>()?;
        Ok(block_out(bulk::encode(&columns)?, out))
    })
}

/// Writes the block of an observation's arrays, which the caller frees with ncp_bytes_free, or NULL if they
/// do not agree. An array may be NULL if it is empty.
///
/// # Safety
/// The arrays have that many values.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ncp_observation_pack(
    times: *const f64,
    times_len: usize,
    values: *const f64,
    values_len: usize,
    senders: *const i64,
    senders_len: usize,
    block_len: Option<&mut MaybeUninit<usize>>,
) -> *mut u8 {
    entry(|| {
        let out = required(block_len, "block_len")?;
        // SAFETY: as this function demands.
        let (times, values, senders) = unsafe {
            (
                items(times, times_len, "times")?,
                items(values, values_len, "values")?,
                items(senders, senders_len, "senders")?,
            )
        };
        Ok(block_out(bulk::pack(times, values, senders)?, out))
    })
}

/// The arrays of an observation that came as a block.
pub struct Arrays {
    times: Vec<f64>,
    values: Vec<f64>,
    senders: Vec<i64>,
}

/// Reads the arrays of an observation, or NULL if the block is rejected. They are copies.
///
/// # Safety
/// The block has that many bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ncp_observation_unpack(block: *const u8, block_len: usize) -> Option<Box<Arrays>> {
    entry(|| {
        // SAFETY: as this function demands.
        let block = unsafe { bytes(block, block_len, "block")? };
        let (times, values, senders) = bulk::unpack(block)?;
        Ok(Some(Box::new(Arrays { times, values, senders })))
    })
}

/// The times in ms, lent by the arrays, and how many.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_arrays_times(arrays: Option<&Arrays>, count: Option<&mut MaybeUninit<usize>>) -> *const f64 {
    entry(|| lend(&required(arrays, "arrays")?.times, count))
}

/// The values, lent by the arrays, and how many.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_arrays_values(arrays: Option<&Arrays>, count: Option<&mut MaybeUninit<usize>>) -> *const f64 {
    entry(|| lend(&required(arrays, "arrays")?.values, count))
}

/// The senders, lent by the arrays, and how many.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_arrays_senders(arrays: Option<&Arrays>, count: Option<&mut MaybeUninit<usize>>) -> *const i64 {
    entry(|| lend(&required(arrays, "arrays")?.senders, count))
}

/// Frees the arrays. NULL is nothing.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_arrays_free(arrays: Option<Box<Arrays>>) {
    entry(|| {
        drop(arrays);
        Ok(())
    });
}

/// Frees a block that this library wrote. NULL is nothing.
///
/// # Safety
/// The block came from this library with this length, and is not used again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ncp_bytes_free(block: *mut u8, block_len: usize) {
    entry(|| {
        if !block.is_null() {
            let block = std::ptr::slice_from_raw_parts_mut(block, block_len);
            // SAFETY: it came from `block_out`, once, as this function demands.
            drop(unsafe { Box::from_raw(block) });
        }
        Ok(())
    });
}

fn block_out(block: Vec<u8>, len: &mut MaybeUninit<usize>) -> *mut u8 {
    len.write(block.len());
    Box::into_raw(block.into_boxed_slice()).cast()
}

fn lend<T>(values: &[T], count: Option<&mut MaybeUninit<usize>>) -> Result<*const T, Refusal> {
    required(count, "count")?.write(values.len());
    Ok(values.as_ptr())
}

/// # Safety
/// The column points to as many values of its type, and bytes of its name, as it says, for `'a`.
unsafe fn column_in<'a>(column: &BlockColumn) -> Result<ColumnRef<'a>, Refusal> {
    let BlockColumn { name, name_len, dtype, rows, data } = *column;
    // SAFETY: the caller vouches for it.
    let name = unsafe { sized(name, name_len, "the name of a column")? };
    let dtype = u8::try_from(dtype).ok().and_then(Dtype::from_code);
    let dtype = dtype.ok_or_else(|| Refusal::new(ErrorCode::Block, "the dtype of a column is none of the four"))?;
    let what = "the data of a column";
    // SAFETY: the caller vouches for it.
    let data = unsafe {
        match dtype {
            Dtype::F32 => DataRef::F32(items(data.cast(), rows, what)?),
            Dtype::F64 => DataRef::F64(items(data.cast(), rows, what)?),
            Dtype::I32 => DataRef::I32(items(data.cast(), rows, what)?),
            Dtype::I64 => DataRef::I64(items(data.cast(), rows, what)?),
        }
    };
    Ok(ColumnRef::new(required(name, "the name of a column")?, data))
}
