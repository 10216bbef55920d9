#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| ncp_fuzz_bodies::bulk::bulk_decode(input));
