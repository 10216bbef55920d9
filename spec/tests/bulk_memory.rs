//! What decoding a block may allocate, counted by the allocator itself (finding L01).
#![allow(unsafe_code, reason = "a global allocator is an unsafe trait")]
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic as tests may")]

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use ncp_spec::bulk::{Block, Column, ColumnRef, MAX_COLUMNS, encode, unpack};

/// Counts what each thread asks for, so that tests may run side by side.
struct Counting;

thread_local! {
    static BYTES: Cell<usize> = const { Cell::new(0) };
    static CALLS: Cell<usize> = const { Cell::new(0) };
}

fn count(size: usize) {
    BYTES.set(BYTES.get() + size);
    CALLS.set(CALLS.get() + 1);
}

// SAFETY: every call goes unchanged to the system's allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count(layout.size());
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        count(layout.size());
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn realloc(&self, old: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count(size);
        unsafe { System.realloc(old, layout, size) }
    }

    unsafe fn dealloc(&self, old: *mut u8, layout: Layout) {
        unsafe { System.dealloc(old, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Runs `work` and returns its result, all bytes that it asked for, and how often.
fn counted<T>(work: impl FnOnce() -> T) -> (T, usize, usize) {
    let before = (BYTES.get(), CALLS.get());
    let result = work();
    (result, BYTES.get() - before.0, CALLS.get() - before.1)
}

/// A block of so many columns with short names and so many rows of i32.
fn block_of(columns: usize, rows: usize) -> Vec<u8> {
    let values: Vec<i32> = (0..rows as i32).collect();
    let names: Vec<_> = (0..columns).map(|column| format!("{column:x}")).collect();
    let columns: Vec<_> = names.iter().map(|name| ColumnRef::new(name, &values[..])).collect();
    encode(&columns).unwrap()
}

/// `columns` entries that all lie: each claims the block's last `rows` values, and
/// its name the last `name_len` bytes.
fn bomb(columns: u16, rows: u32, name_len: u16) -> Vec<u8> {
    let end = 12 + 16 * u32::from(columns) + 4 * rows + u32::from(name_len);
    let mut block = b"NCPB\x01\0".to_vec();
    block.extend(columns.to_le_bytes());
    block.extend(end.to_le_bytes());
    for _ in 0..columns {
        block.extend((end - u32::from(name_len)).to_le_bytes());
        block.extend(name_len.to_le_bytes());
        block.extend([3, 0]);
        block.extend(rows.to_le_bytes());
        block.extend((end - u32::from(name_len) - 4 * rows).to_le_bytes());
    }
    block.resize(end as usize, b'x');
    block
}

#[test]
fn the_count_sees_what_is_allocated() {
    let (_, bytes, calls) = counted(|| vec![1_u8; 1000]);
    assert_eq!((bytes, calls), (1000, 1));
}

#[test]
fn viewing_up_to_eight_columns_allocates_nothing() {
    for columns in 0..=8 {
        let block = block_of(columns, 1000);
        let (sum, bytes, _) = counted(|| {
            let block = Block::parse(&block).unwrap();
            block.columns().flat_map(|view| view.iter::<i32>().unwrap()).map(i64::from).sum::<i64>()
        });
        assert_eq!((sum, bytes), (499_500 * columns as i64, 0), "{columns} columns");
    }
}

#[test]
fn viewing_more_columns_allocates_no_more_than_the_directory_has() {
    for columns in [9, 100, MAX_COLUMNS] {
        let block = block_of(columns, 0);
        let (count, bytes, calls) = counted(|| Block::parse(&block).unwrap().columns().count());
        assert_eq!((count, calls), (columns, 1));
        assert!(bytes <= 16 * columns, "{bytes} bytes for {columns} columns");
    }
}

#[test]
fn four_thousand_columns_over_one_megabyte_are_rejected_before_anything_is_copied() {
    for block in [
        bomb(4096, 1 << 18, 0),
        bomb(4096, 0, u16::MAX),
        bomb(4096, 1 << 18, 2),
        bomb(4096, 0, 0),
        bomb(2, 1 << 23, 1),
        bomb(4096, 1, 1),
    ] {
        let (accepted, bytes, _) = counted(|| Block::parse(&block).is_ok());
        assert!(!accepted);
        assert!(bytes <= block.len(), "{bytes} bytes for a block of {}", block.len());
        let (accepted, bytes, _) = counted(|| unpack(&block).is_ok());
        assert!(!accepted);
        assert!(bytes <= block.len(), "{bytes} bytes for a block of {}", block.len());
    }
}

#[test]
fn owned_columns_take_no_more_than_the_block_and_their_own_size() {
    for (columns, rows) in [(1, 0), (1, 100_000), (8, 3), (500, 70), (MAX_COLUMNS, 0)] {
        let block = block_of(columns, rows);
        let view = Block::parse(&block).unwrap();
        let (owned, bytes, _) = counted(|| view.to_columns());
        assert_eq!(owned.len(), columns);
        let limit = block.len() + columns * size_of::<Column>();
        assert!(bytes <= limit, "{bytes} bytes, limit {limit}");
    }
}

#[test]
fn unpacking_allocates_no_more_than_the_block() {
    let mut columns: Vec<_> = (0..4000).map(|i| Column::new(format!("other {i}"), Vec::<f32>::new())).collect();
    columns.push(Column::new("senders", (0..1000).collect::<Vec<i64>>()));
    columns.push(Column::new("times", vec![0.5; 1000]));
    for columns in [&columns[..], &columns[4000..]] {
        let block = encode(columns).unwrap();
        let (arrays, bytes, _) = counted(|| unpack(&block).unwrap());
        assert_eq!((arrays.0.len(), arrays.1.len(), arrays.2.len()), (1000, 0, 1000));
        assert!(bytes <= block.len(), "{bytes} bytes for a block of {}", block.len());
    }
}

#[test]
fn encoding_allocates_exactly_the_block() {
    let values = vec![0.5; 100_000];
    let columns = ["times", "values"].map(|name| ColumnRef::new(name, &values[..]));
    let (block, bytes, calls) = counted(|| encode(&columns).unwrap());
    assert_eq!((bytes, calls), (block.len(), 1));
    assert_eq!(block.capacity(), block.len());
}
