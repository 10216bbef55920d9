//! How the program starts, and when it refuses to.

use std::fs;

use crate::program::command;

/// `[NCP-TRANS-012]`
#[test]
fn a_zenoh_configuration_that_cannot_be_read_is_refused_with_2() {
    let folder = tempfile::tempdir().unwrap();
    let missing = folder.path().join("missing.json5");
    let malformed = folder.path().join("malformed.json5");
    fs::write(&malformed, "{mode: 'client', connect: {").unwrap();
    let unknown = folder.path().join("unknown.json5");
    fs::write(&unknown, "{mode: 'client', conect: {endpoints: []}}").unwrap();
    for file in [&missing, &malformed, &unknown, &folder.path().to_owned()] {
        let ended = command(&[("NCP_ZENOH_CONFIG", file.to_str().unwrap())]).output().unwrap();
        let said = String::from_utf8_lossy(&ended.stderr).into_owned();
        assert_eq!(ended.status.code(), Some(2), "{file:?}: {said}");
        assert!(said.contains("NCP_ZENOH_CONFIG") && said.contains(file.to_str().unwrap()), "{said}");
    }
    let empty = command(&[("NCP_ZENOH_CONFIG", "")]).output().unwrap();
    assert_eq!(empty.status.code(), Some(2), "{}", String::from_utf8_lossy(&empty.stderr));
}

/// `[NCP-TRANS-006]`
#[test]
fn a_wrong_setting_is_refused_with_2_and_named() {
    for (variable, value) in [
        ("NCP_REALM", "a//b"),
        ("NCP_BRIDGE_TIMEOUT_MS", "10000"),
        ("NCP_BRIDGE_TIMEOUT_MS", "soon"),
        ("NCP_WS_ADDR", "0.0.0.0:0"),
        ("NCP_GRPC_ADDR", "everywhere"),
        ("NCP_BRIDGE_CONNECTIONS", "0"),
    ] {
        let ended = command(&[(variable, value)]).output().unwrap();
        let said = String::from_utf8_lossy(&ended.stderr).into_owned();
        assert_eq!(ended.status.code(), Some(2), "{variable}={value}: {said}");
        // A setting of the command line is named as it is there.
        let option = variable.trim_start_matches("NCP_").to_lowercase().replace('_', "-");
        assert!(said.contains(variable) || said.contains(&option), "{said}");
    }
}

#[test]
fn the_help_names_every_variable_and_the_version_is_the_crates() {
    let ended = command(&[]).arg("--help").output().unwrap();
    let help = String::from_utf8(ended.stdout).unwrap();
    let page = include_str!("../../README.md");
    for variable in help.split("[env: ").skip(1).filter_map(|rest| rest.split('=').next()) {
        assert!(page.contains(&format!("| `{variable}` |")), "the README does not list {variable}");
    }
    assert!(help.matches("[env: ").count() > 10, "{help}");
    let version = command(&[]).arg("--version").output().unwrap();
    assert_eq!(String::from_utf8(version.stdout).unwrap(), concat!("ncp-gateway ", env!("CARGO_PKG_VERSION"), "\n"));
}
