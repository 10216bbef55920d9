//! The limits of section 1.6, as the text states them. Every one is an error, never a crash.

pub use ncp_text::limits::{
    ENTRIES as MAX_ENTRIES, FRAME_BYTES as MAX_FRAME_BYTES, INTEGER as MAX_INTEGER, ITEMS as MAX_ITEMS,
    LEVELS as MAX_LEVELS, OBSERVATION_FRAME_BYTES as MAX_OBSERVATION_BYTES,
};
