//! What can be wrong with a block, or with columns that should become one. `[NCP-BULK-031]`

use std::fmt;

use thiserror::Error;

use super::{Dtype, MAX_BLOCK_LEN, MAX_COLUMNS, MAX_NAME_LEN};
use ncp_spec::ErrorCode;

/// Why a buffer is no BulkBlock, or why columns cannot be written as one.
///
/// Columns are counted from 0 in the directory's order; offsets and lengths are
/// in bytes, offsets from the block's start.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum BulkError {
    /// The block is, or would be, longer than [`MAX_BLOCK_LEN`].
    #[error("a block of {len} bytes is over the limit of {MAX_BLOCK_LEN}")]
    TooLong {
        /// Length of the buffer; when encoding, of the part that had been laid out.
        len: u64,
    },
    /// There are more than [`MAX_COLUMNS`] columns.
    #[error("{columns} columns are over the limit of {MAX_COLUMNS}")]
    TooManyColumns {
        /// Number of columns stated or given.
        columns: usize,
    },
    /// A name to be written is longer than [`MAX_NAME_LEN`].
    #[error("the name of column {column} has {len} bytes, over the limit of {MAX_NAME_LEN}")]
    NameTooLong {
        /// The column.
        column: usize,
        /// Bytes in its name.
        len: usize,
    },
    /// The buffer ends inside the header.
    #[error("{len} bytes are too few for the 12-byte header")]
    HeaderTruncated {
        /// Length of the buffer.
        len: usize,
    },
    /// The first four bytes are not `NCPB`.
    #[error("the magic is {found:02x?}, not \"NCPB\"")]
    Magic {
        /// The bytes in its place.
        found: [u8; 4],
    },
    /// The version is not 1.
    #[error("the block's version is {found}, not 1")]
    Version {
        /// The version stated.
        found: u8,
    },
    /// A flag is set; version 1 defines none.
    #[error("the flags are {found:#04x}, not 0")]
    Flags {
        /// The flags stated.
        found: u8,
    },
    /// The header's total length is not the buffer's.
    #[error("the header says {stated} bytes, the buffer has {len}")]
    LengthMismatch {
        /// The length in the header.
        stated: u32,
        /// Length of the buffer.
        len: usize,
    },
    /// The buffer ends inside the directory.
    #[error("a directory of {columns} columns ends at {end}, the block at {len}")]
    DirectoryTruncated {
        /// Number of columns stated.
        columns: usize,
        /// Where the directory would end.
        end: usize,
        /// Length of the buffer.
        len: usize,
    },
    /// A dtype outside 1 to 4.
    #[error("column {column} has the unknown dtype {found}")]
    UnknownDtype {
        /// The column.
        column: usize,
        /// The code in the directory.
        found: u8,
    },
    /// The pad byte of a directory entry is not 0.
    #[error("the pad byte of column {column} is {found:#04x}, not 0")]
    Pad {
        /// The column.
        column: usize,
        /// The byte in its place.
        found: u8,
    },
    /// A region starts or ends behind the block's end.
    #[error("{region} takes bytes {start} to {end}, the block ends at {len}")]
    OutOfBounds {
        /// The region.
        region: Region,
        /// Its first byte.
        start: u64,
        /// The byte behind its last.
        end: u64,
        /// Length of the block.
        len: u64,
    },
    /// A non-empty region starts inside the header or the directory.
    #[error("{region} starts at {start}, before the directory's end at {directory_end}")]
    InDirectory {
        /// The region.
        region: Region,
        /// Its first byte.
        start: u64,
        /// The byte behind the directory.
        directory_end: u64,
    },
    /// Two non-empty regions share bytes.
    #[error("{first} and {second} share the byte at {at}")]
    Overlap {
        /// The region that starts first.
        first: Region,
        /// The other one.
        second: Region,
        /// The first byte that both have.
        at: u64,
    },
    /// A name is not UTF-8.
    #[error("the name of column {column} is not UTF-8 from its byte {valid_up_to} on")]
    NameNotUtf8 {
        /// The column.
        column: usize,
        /// Bytes of the name that are valid.
        valid_up_to: usize,
    },
    /// Two columns have the same name.
    #[error("columns {first} and {second} have the same name")]
    DuplicateName {
        /// The lower of the two.
        first: usize,
        /// The higher one.
        second: usize,
    },
    /// An observation's column has another dtype than an observation's.
    #[error("column {column}, `{name}`, is {found}, not {expected}")]
    ColumnDtype {
        /// The column.
        column: usize,
        /// Its name.
        name: &'static str,
        /// The dtype that it must have.
        expected: Dtype,
        /// The dtype that it has.
        found: Dtype,
    },
    /// Two non-empty arrays of one observation differ in length.
    #[error("`{first}` has {first_rows} rows and `{second}` has {second_rows}")]
    RowsDiffer {
        /// One array.
        first: &'static str,
        /// Its length.
        first_rows: usize,
        /// The other array.
        second: &'static str,
        /// Its length.
        second_rows: usize,
    },
}

impl BulkError {
    /// The code under which a peer answers with this error: [`ErrorCode::Limit`]
    /// for what is too large, [`ErrorCode::Block`] for everything else.
    #[must_use]
    pub fn code(&self) -> ErrorCode {
        match self {
            Self::TooLong { .. } | Self::TooManyColumns { .. } | Self::NameTooLong { .. } => ErrorCode::Limit,
            _ => ErrorCode::Block,
        }
    }
}

/// A stretch of a block that belongs to one column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Region {
    /// The name of this column.
    Name(usize),
    /// The values of this column.
    Data(usize),
}

impl fmt::Display for Region {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Name(column) => write!(f, "the name of column {column}"),
            Self::Data(column) => write!(f, "the data of column {column}"),
        }
    }
}
