//! The packages of npm: the launcher, which names one package of each platform, and that of this one.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Map, Value, json};

use super::{Contents, PROGRAM, PackageError, VERSION, copy, copy_all, create, remove, write};
use xtask::setup::{NPM, carry_out};

/// What Rust and what Node call the systems and machines for which the program is built.
const PLATFORMS: [(&str, &str, &str, &str); 5] = [
    ("linux", "x86_64", "linux", "x64"),
    ("linux", "aarch64", "linux", "arm64"),
    ("macos", "x86_64", "darwin", "x64"),
    ("macos", "aarch64", "darwin", "arm64"),
    ("windows", "x86_64", "win32", "x64"),
];

pub(super) fn make(contents: &Contents<'_>, folder: &Path) -> Result<[PathBuf; 2], PackageError> {
    let stage = contents.project.path("target/packaged/npm");
    remove(&stage)?;
    let here = |platform: &&(&str, &str, &str, &str)| (platform.0, platform.1) == (env::consts::OS, env::consts::ARCH);
    let (_, _, os, cpu) = PLATFORMS.iter().find(here).ok_or(PackageError::Platform)?;

    let main = stage.join("main");
    copy_all(&contents.project.path("packages/npm"), &main)?;
    documents(contents, &main)?;
    let manifest = launcher(&main)?;
    let launcher = pack(contents, &main, &manifest, folder)?;

    let platform = stage.join("platform");
    copy(&contents.program, &platform.join("bin").join(PROGRAM))?;
    copy_all(&contents.shared.join("man"), &platform.join("man"))?;
    documents(contents, &platform)?;
    write(&platform.join("README.md"), format!("The program of `ncp-verify` for {os} on {cpu}.\n").as_bytes())?;
    let manifest = json!({
        "name": format!("@ncp-verify/{os}-{cpu}"),
        "version": VERSION,
        "description": format!("The program of ncp-verify for {os} on {cpu}."),
        "license": "MIT OR Apache-2.0",
        "os": [os],
        "cpu": [cpu],
        "preferUnplugged": true,
    });
    Ok([launcher, pack(contents, &platform, &manifest, folder)?])
}

/// The manifest of the launcher: that of `packages/npm`, with its version, the packages of the platforms, and what it
/// exports of what is there.
fn launcher(folder: &Path) -> Result<Value, PackageError> {
    let path = folder.join("package.json");
    let text = fs::read_to_string(&path).map_err(|source| PackageError::File { path: path.clone(), source })?;
    let wrong = |message: String| PackageError::Json { what: path.display().to_string(), message };
    let mut manifest: Map<String, Value> = serde_json::from_str(&text).map_err(|error| wrong(error.to_string()))?;
    manifest.insert("version".to_owned(), VERSION.into());
    let platforms = PLATFORMS.map(|(_, _, os, cpu)| (format!("@ncp-verify/{os}-{cpu}"), Value::from(VERSION)));
    manifest.insert("optionalDependencies".to_owned(), Value::from_iter(platforms));
    if let Some(Value::Object(exports)) = manifest.get_mut("exports") {
        exports.retain(|_, file| file.as_str().is_none_or(|file| folder.join(file).is_file()));
    }
    Ok(Value::Object(manifest))
}

/// Packs a folder whose manifest this is.
fn pack(contents: &Contents<'_>, folder: &Path, manifest: &Value, to: &Path) -> Result<PathBuf, PackageError> {
    write(&folder.join("package.json"), format!("{manifest:#}\n").as_bytes())?;
    create(to)?;
    let (from, to_shown) = (folder.display().to_string(), to.display().to_string());
    carry_out(contents.project.program(NPM, &["pack", "--silent", &from, "--pack-destination", &to_shown], ""))?;
    let name = manifest["name"].as_str().unwrap_or_default().trim_start_matches('@').replace('/', "-");
    Ok(to.join(format!("{name}-{VERSION}.tgz")))
}

/// What each package has beside its own files.
fn documents(contents: &Contents<'_>, folder: &Path) -> Result<(), PackageError> {
    copy_all(&contents.shared.join("doc/ncp-verify"), folder)
}
