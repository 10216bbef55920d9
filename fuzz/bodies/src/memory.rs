//! Counts what is allocated, if the program has the allocator of `fuzz/bodies/allocator.rs`.

use std::cell::Cell;
use std::hint::black_box;

thread_local! {
    static BYTES: Cell<usize> = const { Cell::new(0) };
}

/// Takes note of an allocation on this thread; the allocator calls it.
pub fn note(bytes: usize) {
    // A thread that ends has nothing to count any more.
    let _ = BYTES.try_with(|total| total.set(total.get().wrapping_add(bytes)));
}

/// Runs `work`, and says how many bytes it asked for in all.
///
/// # Panics
/// The program does not count, so that whatever is checked would hold.
pub fn counted<T>(work: impl FnOnce() -> T) -> (T, usize) {
    let before = BYTES.get();
    drop(black_box(Box::new(1_u64)));
    let start = BYTES.get();
    assert_ne!(start, before, "the program does not count its allocations");
    let result = work();
    (result, BYTES.get().wrapping_sub(start))
}
