//! The fixed parts of a block: limits, header, directory entries, and the one
//! check that decoder and encoder share, that names are distinct.

use super::{BulkError, Dtype};

/// Longest block that is read or written, in bytes: 64 MiB.
pub const MAX_BLOCK_LEN: usize = 64 << 20;
/// Most columns that a block may have.
pub const MAX_COLUMNS: usize = 4096;
/// Longest name of a column, in bytes: the directory counts it in 16 bits.
pub const MAX_NAME_LEN: usize = u16::MAX as usize;

pub(super) const HEADER_LEN: usize = 12;
pub(super) const ENTRY_LEN: usize = 16;

/// The encoder starts a column's values at a multiple of this, counted from the
/// block's start; a decoder takes them anywhere.
pub(super) const DATA_ALIGN: u32 = 8;

const MAGIC: [u8; 4] = *b"NCPB";
const VERSION: u8 = 1;

/// Checks the header and cuts the directory, still raw, out of a whole block.
pub(super) fn read_directory(block: &[u8]) -> Result<&[[u8; ENTRY_LEN]], BulkError> {
    // [NCP-BULK-015] [NCP-BULK-025]
    if block.len() > MAX_BLOCK_LEN {
        return Err(BulkError::TooLong { len: block.len() as u64 });
    }
    // [NCP-BULK-001]
    let Some((header, rest)) = block.split_first_chunk::<HEADER_LEN>() else {
        return Err(BulkError::HeaderTruncated { len: block.len() });
    };
    let [m0, m1, m2, m3, version, flags, c0, c1, t0, t1, t2, t3] = *header;

    let magic = [m0, m1, m2, m3];
    // [NCP-BULK-002]
    if magic != MAGIC {
        return Err(BulkError::Magic { found: magic });
    }
    // [NCP-BULK-003]
    if version != VERSION {
        return Err(BulkError::Version { found: version });
    }
    // [NCP-BULK-004]
    if flags != 0 {
        return Err(BulkError::Flags { found: flags });
    }
    let stated = u32::from_le_bytes([t0, t1, t2, t3]);
    // [NCP-BULK-005]
    if usize::try_from(stated) != Ok(block.len()) {
        return Err(BulkError::LengthMismatch { stated, len: block.len() });
    }
    let columns = usize::from(u16::from_le_bytes([c0, c1]));
    // [NCP-BULK-016] [NCP-BULK-017]
    if columns > MAX_COLUMNS {
        return Err(BulkError::TooManyColumns { columns });
    }
    // [NCP-BULK-006]
    let (entries, _) = rest.as_chunks::<ENTRY_LEN>();
    entries.get(..columns).ok_or(BulkError::DirectoryTruncated {
        columns,
        end: directory_end(columns),
        len: block.len(),
    })
}

/// Appends a header.
pub(super) fn write_header(out: &mut Vec<u8>, columns: u16, total_len: u32) {
    out.extend_from_slice(&MAGIC);
    out.extend_from_slice(&[VERSION, 0]);
    out.extend_from_slice(&columns.to_le_bytes());
    out.extend_from_slice(&total_len.to_le_bytes());
}

/// The byte behind the directory of a block of so many columns.
pub(super) fn directory_end(columns: usize) -> usize {
    HEADER_LEN + ENTRY_LEN * columns
}

/// One column's entry in the directory.
pub(super) struct Entry {
    pub(super) name_off: u32,
    pub(super) name_len: u16,
    pub(super) dtype: Dtype,
    pub(super) rows: u32,
    pub(super) data_off: u32,
}

impl Entry {
    /// Reads the entry of `column`; where it points to is not checked here.
    pub(super) fn read(raw: &[u8; ENTRY_LEN], column: usize) -> Result<Self, BulkError> {
        let [n0, n1, n2, n3, l0, l1, dtype, pad, r0, r1, r2, r3, d0, d1, d2, d3] = *raw;
        // Every field is little-endian. [NCP-BULK-022] [NCP-BULK-007]
        let entry = Self {
            name_off: u32::from_le_bytes([n0, n1, n2, n3]),
            name_len: u16::from_le_bytes([l0, l1]),
            dtype: Dtype::from_code(dtype).ok_or(BulkError::UnknownDtype { column, found: dtype })?,
            rows: u32::from_le_bytes([r0, r1, r2, r3]),
            data_off: u32::from_le_bytes([d0, d1, d2, d3]),
        };
        // [NCP-BULK-008]
        if pad != 0 {
            return Err(BulkError::Pad { column, found: pad });
        }
        Ok(entry)
    }

    /// Appends the entry.
    pub(super) fn write(&self, out: &mut Vec<u8>) {
        out.extend_from_slice(&self.name_off.to_le_bytes());
        out.extend_from_slice(&self.name_len.to_le_bytes());
        out.extend_from_slice(&[self.dtype.code(), 0]);
        out.extend_from_slice(&self.rows.to_le_bytes());
        out.extend_from_slice(&self.data_off.to_le_bytes());
    }

    /// Where the name lies.
    pub(super) fn name(&self) -> Span {
        Span { start: u64::from(self.name_off), len: u64::from(self.name_len) }
    }

    /// Where the values lie.
    pub(super) fn data(&self) -> Span {
        // [NCP-BULK-011]: 32-bit rows times at most 8 bytes cannot overflow 64 bits.
        let len = u64::from(self.rows) * self.dtype.size() as u64;
        Span { start: u64::from(self.data_off), len }
    }
}

/// A stretch of bytes, counted from the block's start.
#[derive(Clone, Copy)]
pub(super) struct Span {
    pub(super) start: u64,
    pub(super) len: u64,
}

impl Span {
    /// The byte behind the last; both parts stem from 32-bit fields, so it cannot overflow.
    pub(super) fn end(self) -> u64 {
        self.start + self.len
    }

    /// The bytes of this span, or `None` when they are not all there.
    pub(super) fn of(self, block: &[u8]) -> Option<&[u8]> {
        let start = usize::try_from(self.start).ok()?;
        let end = usize::try_from(self.end()).ok()?;
        block.get(start..end)
    }
}

/// Room to sort in: on the stack for blocks of up to eight columns, else one
/// allocation of 16 bytes a column, which is what a directory entry takes.
pub(super) struct Scratch {
    inline: [u64; 2 * Self::INLINE_COLUMNS],
    heap: Vec<u64>,
}

impl Scratch {
    const INLINE_COLUMNS: usize = 8;

    /// Room for two numbers a column.
    pub(super) fn for_columns(columns: usize) -> Self {
        let heap = if columns > Self::INLINE_COLUMNS { 2 * columns } else { 0 };
        Self { inline: [0; 2 * Self::INLINE_COLUMNS], heap: vec![0; heap] }
    }

    /// Fills the room with as many of `numbers` as it holds, and lends that part.
    pub(super) fn fill(&mut self, numbers: impl Iterator<Item = u64>) -> &mut [u64] {
        let room = if self.heap.is_empty() { &mut self.inline[..] } else { &mut self.heap };
        let mut filled = 0;
        for (slot, number) in room.iter_mut().zip(numbers) {
            *slot = number;
            filled += 1;
        }
        &mut room[..filled]
    }
}

/// Finds two of `columns` names that are equal; the lower index comes first.
///
/// Sorts by a digest of each name and looks at the names only where digests agree.
/// Names chosen to agree cost no more than sorting them.
pub(super) fn find_duplicate<'n>(
    columns: usize,
    scratch: &mut Scratch,
    name: impl Fn(usize) -> &'n [u8],
) -> Option<(usize, usize)> {
    // A key is the upper 48 bits of the digest over the index, which fits 16 bits.
    const INDEX: u64 = 0xffff;
    let index = |key: u64| (key & INDEX) as usize;
    let keys = scratch.fill((0..columns).map(|i| digest(name(i)) & !INDEX | i as u64));
    keys.sort_unstable();
    for alike in keys.chunk_by_mut(|a, b| a & !INDEX == b & !INDEX) {
        alike.sort_unstable_by_key(|key| (name(index(*key)), *key));
        let mut neighbours = alike.iter().zip(alike.iter().skip(1));
        if let Some((a, b)) = neighbours.find(|(a, b)| name(index(**a)) == name(index(**b))) {
            return Some((index(*a), index(*b)));
        }
    }
    None
}

/// Mixes a name into 64 bits, eight bytes at a time; equal names have equal digests.
fn digest(name: &[u8]) -> u64 {
    const ODD: u64 = 0x9e37_79b9_7f4a_7c15;
    let (words, rest) = name.as_chunks();
    let mut last = [0; 8];
    last.iter_mut().zip(rest).for_each(|(slot, byte)| *slot = *byte);
    words.iter().chain([&last]).fold(0, |digest: u64, word| {
        let mixed = (digest ^ u64::from_le_bytes(*word)).wrapping_mul(ODD);
        mixed ^ (mixed >> 32)
    })
}
