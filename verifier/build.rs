//! Builds the corpus of `vectors/corpus` and the deep set of `vectors/deep` into the program, so that it stands alone.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let root = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    let vectors = root.join("../vectors");
    println!("cargo::rerun-if-changed=build.rs");
    let mut corpus = Vec::new();
    for area in watched(&vectors.join("corpus"))? {
        if area.is_dir() {
            corpus.extend(watched(&area)?.into_iter().filter(|file| file.extension().is_some_and(|e| e == "json")));
        }
    }
    let deep = watched(&vectors.join("deep"))?.into_iter().filter(|file| file.extension().is_some_and(|e| e == "json"));
    let mut code =
        String::from("/// Every vector file of the corpus: its path within `vectors/corpus/`, and its text.\n");
    table("EMBEDDED", &corpus, &vectors.join("corpus"), &mut code)?;
    code.push_str("/// Every vector file of the deep set: its path within `vectors/`, and its text.\n");
    table("EMBEDDED_DEEP", &deep.collect::<Vec<_>>(), &vectors, &mut code)?;
    let out = PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default());
    fs::write(out.join("embedded.rs"), code)
}

fn table(name: &str, files: &[PathBuf], within: &Path, code: &mut String) -> io::Result<()> {
    writeln!(code, "static {name}: &[(&str, &str)] = &[").map_err(io::Error::other)?;
    for file in files {
        println!("cargo::rerun-if-changed={}", file.display());
        let name = file.strip_prefix(within).unwrap_or(file).to_string_lossy().replace('\\', "/");
        let path = file.canonicalize()?;
        writeln!(code, "    ({name:?}, include_str!({:?})),", path.to_string_lossy()).map_err(io::Error::other)?;
    }
    code.push_str("];\n");
    Ok(())
}

/// What is in a folder, which is watched for changes; nothing, if there is no such folder.
fn watched(folder: &Path) -> io::Result<Vec<PathBuf>> {
    println!("cargo::rerun-if-changed={}", folder.display());
    if folder.is_dir() { entries(folder) } else { Ok(Vec::new()) }
}

fn entries(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut paths = fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<_>>>()?;
    paths.sort();
    Ok(paths)
}
