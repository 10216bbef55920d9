//! What buf sees of the planted changes: the evidence behind the table of README.md.
//!
//! It needs the buf CLI 1.75.0: `NCP_BUF=/path/to/buf cargo test -p ncp-proto --test buf --
//! --ignored`.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on has failed")]

mod common;

use std::{collections::BTreeSet, env, fs, path::Path, process::Command};

use common::{Buf, Change, changes};

#[test]
#[ignore = "needs buf 1.75.0 in NCP_BUF"]
fn buf_sees_of_each_planted_change_what_is_recorded() {
    let buf = env::var("NCP_BUF").expect("NCP_BUF names the buf CLI");
    let mut differences = String::new();
    for change in changes() {
        let seen = if change.touches_proto() { breaking(&buf, &change) } else { Buf::default() };
        if seen != change.buf {
            differences += &format!(
                "{}\nbuf = {{ WIRE = {:?}, WIRE_JSON = {:?}, FILE = {:?} }}\n",
                change.name, seen.wire, seen.wire_json, seen.file
            );
        }
    }
    assert!(differences.is_empty(), "{differences}");
}

fn breaking(buf: &str, change: &Change) -> Buf {
    let folder = tempfile::tempdir().unwrap();
    let frozen = folder.path().join("frozen.binpb");
    fs::write(folder.path().join("ncp.proto"), change.frozen_proto()).unwrap();
    let built = run(buf, folder.path(), &["build", "-o", frozen.to_str().unwrap()]);
    assert!(built.0, "{}: {}", change.name, built.1);
    fs::write(folder.path().join("ncp.proto"), change.changed_proto()).unwrap();
    let rules = |category: &str| {
        let config = format!(r#"{{"version":"v2","breaking":{{"use":["{category}"]}}}}"#);
        let (_, output) = run(
            buf,
            folder.path(),
            &["breaking", "--against", frozen.to_str().unwrap(), "--config", &config, "--error-format", "json"],
        );
        let rules: BTreeSet<String> = output
            .lines()
            .map(|line| {
                serde_json::from_str::<serde_json::Value>(line).unwrap_or_else(|_| panic!("{}: {output}", change.name))
            })
            .map(|violation| violation["type"].as_str().unwrap().to_owned())
            .collect();
        rules.into_iter().collect()
    };
    Buf { wire: rules("WIRE"), wire_json: rules("WIRE_JSON"), file: rules("FILE") }
}

fn run(buf: &str, folder: &Path, args: &[&str]) -> (bool, String) {
    let output = Command::new(buf).args(args).current_dir(folder).output().unwrap();
    (output.status.success(), String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned())
}
