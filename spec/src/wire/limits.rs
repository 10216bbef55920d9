//! The limits of section 1.6. Every one is an error, never a crash.

/// The longest frame in bytes, an `observation_frame` aside: 1 MiB.
pub const MAX_FRAME_BYTES: usize = 1 << 20;

/// The longest `observation_frame` in bytes: 64 MiB.
pub const MAX_OBSERVATION_BYTES: usize = 64 << 20;

/// Levels of nested objects and arrays, the top-level object included.
pub const MAX_LEVELS: usize = 64;

/// Entries of one map.
pub const MAX_ENTRIES: usize = 4_096;

/// Items of one array whose items are not numbers.
pub const MAX_ITEMS: usize = 4_096;

/// The largest magnitude of an integer: 2^53 − 1.
pub const MAX_INTEGER: i64 = (1 << 53) - 1;
