#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| ncp_fuzz_bodies::link_monitor::link_monitor_trace(input));
