//! Copies of the kernel with one token changed each, which `cargo xtask prove --mutate` writes.
#![allow(warnings, reason = "changed by a program, without regard to sense")]

include!(env!("NCP_MUTANTS"));
