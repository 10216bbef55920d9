//! The golden cases against a mutated specification: the test `cases`, which `cargo assure mutate spec` has
//! cargo-mutants run for every mutant.
//!
//! The tests of `ncp-peer-rust` do much the same. But they link the verifier, which asks `ncp-spec` what a
//! frame means: it would judge a mutant by the mutant's own rules, and would be compiled anew for each.

#![forbid(unsafe_code)]
