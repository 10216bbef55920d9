//! The decisions of the safety kernel as functions that C can call, so that their machine code can be
//! explored by name. See `README.md`.
//!
//! Nothing is decided here: each function builds the state that its arguments describe, calls the
//! kernel once, and says what it answered.

#![allow(unsafe_code, reason = "a function is exported by name with an attribute that counts as unsafe")]

mod wrappers;

wrappers::wrap!("ncp", ncp_kernel);
