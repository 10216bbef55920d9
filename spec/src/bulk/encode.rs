//! Writing a block.

use super::layout::{
    DATA_ALIGN, Entry, MAX_BLOCK_LEN, MAX_COLUMNS, MAX_NAME_LEN, Scratch, directory_end, find_duplicate, write_header,
};
use super::{BulkError, ColumnRef};

/// Writes columns as one block, into one allocation of exactly its length.
///
/// Takes [`ColumnRef`]s or owned [`Column`](super::Column)s, and copies every value
/// once. The layout is fixed, so equal columns give equal bytes: header, directory,
/// names in order and without gaps, then each column's values, an empty column's too,
/// at the next multiple of 8, with zeros between.
/// Requirements: NCP-BULK-030 to NCP-BULK-035.
///
/// # Errors
/// More than [`MAX_COLUMNS`] columns, a name longer than [`MAX_NAME_LEN`], a block
/// longer than [`MAX_BLOCK_LEN`], or two equal names. No count is ever cut short.
pub fn encode<'c, C>(columns: &'c [C]) -> Result<Vec<u8>, BulkError>
where
    &'c C: Into<ColumnRef<'c>>,
{
    let to_ref = |column: &'c C| -> ColumnRef<'c> { column.into() };
    let refs = || columns.iter().map(to_ref);

    let Extent { columns: n_cols, names, data, end } = Extent::of(refs())?;
    let name = |column| -> &'c [u8] { columns.get(column).map(to_ref).map_or(&[], |column| column.name.as_bytes()) };
    let mut scratch = Scratch::for_columns(columns.len());
    // [NCP-BULK-034]
    if let Some((first, second)) = find_duplicate(columns.len(), &mut scratch, name) {
        return Err(BulkError::DuplicateName { first, second });
    }

    let mut block = Vec::with_capacity(end as usize);
    write_header(&mut block, n_cols, end);
    let (mut name_off, mut data_off) = (names, data);
    for column in refs() {
        // [NCP-BULK-031]: the extent has been checked, none of these counts is cut short.
        let name_len = column.name.len() as u16;
        let rows = column.data.len() as u32;
        data_off = data_off.next_multiple_of(DATA_ALIGN);
        let entry = Entry { name_off, name_len, dtype: column.data.dtype(), rows, data_off };
        entry.write(&mut block);
        name_off = entry.name().end() as u32;
        data_off = entry.data().end() as u32;
    }
    // [NCP-BULK-032]
    for column in refs() {
        block.extend_from_slice(column.name.as_bytes());
    }
    for column in refs() {
        // [NCP-BULK-033]
        block.resize(block.len().next_multiple_of(DATA_ALIGN as usize), 0);
        column.data.write(&mut block);
    }
    Ok(block)
}

/// How many columns a block has and where its parts begin, all within the limits.
/// [NCP-BULK-031]
struct Extent {
    columns: u16,
    names: u32,
    data: u32,
    end: u32,
}

impl Extent {
    fn of<'c>(columns: impl ExactSizeIterator<Item = ColumnRef<'c>> + Clone) -> Result<Self, BulkError> {
        let n_cols = columns.len();
        if n_cols > MAX_COLUMNS {
            return Err(BulkError::TooManyColumns { columns: n_cols });
        }
        let names = directory_end(n_cols) as u64;
        let mut data = names;
        for (column, ColumnRef { name, .. }) in columns.clone().enumerate() {
            if name.len() > MAX_NAME_LEN {
                return Err(BulkError::NameTooLong { column, len: name.len() });
            }
            data += name.len() as u64;
        }
        let mut end = within_limit(data)?;
        for ColumnRef { data, .. } in columns {
            // A slice has at most isize::MAX bytes, so one more cannot overflow.
            let len = data.len() as u64 * data.dtype().size() as u64;
            end = within_limit(u64::from(end.next_multiple_of(DATA_ALIGN)) + len)?;
        }
        Ok(Self { columns: n_cols as u16, names: within_limit(names)?, data: within_limit(data)?, end })
    }
}

fn within_limit(len: u64) -> Result<u32, BulkError> {
    u32::try_from(len).ok().filter(|len| *len as usize <= MAX_BLOCK_LEN).ok_or(BulkError::TooLong { len })
}
