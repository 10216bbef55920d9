//! BulkBlock, "NCPB" version 1: columns of numbers for the observation plane.
//!
//! A block is a header, a directory with one entry a column, the columns' names
//! and the columns' values, all little-endian, all inside one buffer whose length
//! the header states:
//!
//! | part      | bytes  | content |
//! |-----------|--------|---------|
//! | header    | 12     | magic `NCPB`, u8 version 1, u8 flags 0, u16 columns, u32 total length |
//! | directory | 16 × n | u32 name offset, u16 name length, u8 dtype, u8 pad 0, u32 rows, u32 data offset |
//! | names     |        | UTF-8 |
//! | data      |        | the values; this encoder starts each column at a multiple of 8 |
//!
//! Three ways in and out, from the cheapest on:
//!
//! - [`Block::parse`] checks a buffer completely and lends [`ColumnView`]s of it. It
//!   never looks at the values, so it costs the same for ten rows and for ten million.
//! - [`Block::to_columns`] and [`encode`] own or borrow whole columns.
//! - [`pack`] (or [`pack_observation`]) and [`unpack`] carry the three arrays of an
//!   observation.
//!
//! ```
//! use ncp_spec::bulk::{Block, ColumnRef, encode};
//!
//! let bytes = encode(&[
//!     ColumnRef::new("times", &[1.5, 2.5, 9.0][..]),
//!     ColumnRef::new("senders", &[7_i64, 7, 9][..]),
//! ])?;
//!
//! let block = Block::parse(&bytes)?;
//! let (_, senders) = block.find("senders").ok_or("no senders")?;
//! assert_eq!(senders.rows(), 3);
//! assert_eq!(senders.get::<i64>(2), Some(9));
//! assert_eq!(senders.get::<f64>(2), None, "the column is i64");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A block comes from a stranger. Nothing here panics, and checking a block
//! allocates at most as many bytes as the block has: its regions must be disjoint,
//! so no value and no name is ever counted twice.

mod block;
mod column;
mod encode;
mod error;
mod layout;
mod observation;

pub use block::{Block, ColumnView};
pub use column::{Column, ColumnData, ColumnRef, DataRef, Dtype, Element};
pub use encode::encode;
pub use error::{BulkError, Region};
pub use layout::{MAX_BLOCK_LEN, MAX_COLUMNS, MAX_NAME_LEN};
pub use observation::{Arrays, pack, pack_observation, unpack};
