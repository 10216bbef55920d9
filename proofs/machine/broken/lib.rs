//! The exported functions over broken copies of the kernel, which the proofs have to refute.
//! `defects/kernel.toml` says what is broken in each.

#![allow(unsafe_code, reason = "a function is exported by name with an attribute that counts as unsafe")]
#![allow(missing_docs, unused, unreachable_pub, clippy::all, reason = "the copies are not to be used")]

#[path = "../src/wrappers.rs"]
mod wrappers;

include!(concat!(env!("OUT_DIR"), "/broken.rs"));
