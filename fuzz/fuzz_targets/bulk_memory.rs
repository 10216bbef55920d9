#![no_main]

include!("../bodies/allocator.rs");

libfuzzer_sys::fuzz_target!(|input: &[u8]| ncp_fuzz_bodies::bulk::bulk_memory(input));
