//! Builds the corpus of `vectors/corpus` into the program, so that it stands alone.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let root = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    let vectors = root.join("../vectors/corpus");
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed={}", vectors.display());
    let mut files = Vec::new();
    if vectors.is_dir() {
        for area in entries(&vectors)? {
            if area.is_dir() {
                println!("cargo::rerun-if-changed={}", area.display());
                files.extend(entries(&area)?.into_iter().filter(|file| file.extension().is_some_and(|e| e == "json")));
            }
        }
    }
    let mut code = String::from("/// Every vector file: its path within `vectors/corpus/`, and its text.\n");
    code.push_str("static EMBEDDED: &[(&str, &str)] = &[\n");
    for file in &files {
        println!("cargo::rerun-if-changed={}", file.display());
        let name = file.strip_prefix(&vectors).unwrap_or(file).to_string_lossy().replace('\\', "/");
        let path = file.canonicalize()?;
        writeln!(code, "    ({name:?}, include_str!({:?})),", path.to_string_lossy()).map_err(io::Error::other)?;
    }
    code.push_str("];\n");
    let out = PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default());
    fs::write(out.join("embedded.rs"), code)
}

fn entries(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut paths = fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<_>>>()?;
    paths.sort();
    Ok(paths)
}
