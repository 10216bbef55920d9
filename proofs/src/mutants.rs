//! Copies of the kernel with one token changed each, which `cargo assure mutate kernel` writes.
#![allow(warnings, reason = "changed by a program, without regard to sense")]

include!(env!("NCP_MUTANTS"));
