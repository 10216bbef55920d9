//! Replays the committed corpora: what a fuzzer once found interesting stays right.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::fs;
use std::path::{Path, PathBuf};

use ncp_fuzz_bodies::{TARGETS, seeds, target};

include!("../allocator.rs");

const FUZZ: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// The files of a corpus, sorted.
fn corpus(name: &str) -> Vec<PathBuf> {
    let folder = Path::new(FUZZ).join("corpus").join(name);
    let files = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut files: Vec<_> = files.map(|file| file.unwrap().path()).collect();
    files.sort();
    files
}

fn replay(name: &str) {
    let target = target(name).unwrap();
    let files = corpus(name);
    assert!(files.len() >= 10, "{name}: {} files are no corpus", files.len());
    for file in files {
        // Whoever sees the panic has to know which input it was.
        let input = fs::read(&file).unwrap();
        let run = || (target.run)(&input);
        if let Err(panic) = std::panic::catch_unwind(std::panic::AssertUnwindSafe(run)) {
            eprintln!("{}\n{}", file.display(), (target.show)(&input));
            std::panic::resume_unwind(panic);
        }
    }
}

macro_rules! replays {
    ($($test:ident of $name:literal,)*) => {
        $(#[test] fn $test() { replay($name); })*

        #[test]
        fn every_target_is_replayed_and_has_a_wrapper() {
            let mut replayed = vec![$($name),*];
            let mut targets: Vec<_> = TARGETS.iter().map(|target| target.name).collect();
            let wrappers = fs::read_dir(Path::new(FUZZ).join("fuzz_targets")).unwrap();
            let mut wrappers: Vec<_> = wrappers
                .map(|file| file.unwrap().path().file_stem().unwrap().to_str().unwrap().to_owned())
                .collect();
            replayed.sort_unstable();
            targets.sort_unstable();
            wrappers.sort_unstable();
            assert_eq!(replayed, targets);
            assert_eq!(wrappers, targets);
        }
    };
}

replays! {
    the_corpus_of_frame_decode_passes of "frame_decode",
    the_corpus_of_frame_roundtrip_passes of "frame_roundtrip",
    the_corpus_of_bulk_decode_passes of "bulk_decode",
    the_corpus_of_bulk_roundtrip_passes of "bulk_roundtrip",
    the_corpus_of_bulk_memory_passes of "bulk_memory",
    the_corpus_of_validate_vs_schema_passes of "validate_vs_schema",
    the_corpus_of_proto_vs_json_passes of "proto_vs_json",
    the_corpus_of_keys_passes of "keys",
    the_corpus_of_version_passes of "version",
    the_corpus_of_canonical_proto_passes of "canonical_proto",
    the_corpus_of_governor_trace_passes of "governor_trace",
    the_corpus_of_action_buffer_trace_passes of "action_buffer_trace",
    the_corpus_of_link_monitor_trace_passes of "link_monitor_trace",
    the_corpus_of_codec_passes of "codec",
    the_corpus_of_session_passes of "session",
    the_corpus_of_peer_protocol_passes of "peer_protocol",
}

#[test]
fn the_seeds_of_the_vectors_reach_every_target() {
    let seeds = seeds::seeds(&Path::new(FUZZ).join("..")).unwrap();
    for target in TARGETS {
        let inputs = seeds.get(target.name).unwrap_or_else(|| panic!("{} has no seeds", target.name));
        for input in inputs {
            (target.run)(input);
        }
    }
}

#[test]
fn the_dictionary_is_the_one_of_the_tables() {
    let committed = fs::read_to_string(Path::new(FUZZ).join("dict/frame.dict")).unwrap();
    assert_eq!(committed, seeds::dictionary());
}
