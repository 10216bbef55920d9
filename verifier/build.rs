//! Packs the corpus of `vectors/corpus` and the deep set of `vectors/deep` into the program, so that it stands alone.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

use flate2::Compression;
use flate2::write::DeflateEncoder;

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
    let out = PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default());
    let mut code = String::from("/// Every vector file of the corpus, named by its path within `vectors/corpus/`.\n");
    table("EMBEDDED", &corpus, &vectors.join("corpus"), &out, &mut code)?;
    code.push_str("/// Every vector file of the deep set, named by its path within `vectors/`.\n");
    table("EMBEDDED_DEEP", &deep.collect::<Vec<_>>(), &vectors, &out, &mut code)?;
    fs::write(out.join("embedded.rs"), code)
}

fn table(table: &str, files: &[PathBuf], within: &Path, out: &Path, code: &mut String) -> io::Result<()> {
    writeln!(code, "static {table}: &[Packed] = &[").map_err(io::Error::other)?;
    for (number, file) in files.iter().enumerate() {
        println!("cargo::rerun-if-changed={}", file.display());
        let name = file.strip_prefix(within).unwrap_or(file).to_string_lossy().replace('\\', "/");
        let text = fs::read(file)?;
        let mut encoder = DeflateEncoder::new(Vec::new(), Compression::best());
        encoder.write_all(&text)?;
        let packed = format!("{table}-{number}.deflate");
        fs::write(out.join(&packed), encoder.finish()?)?;
        let bytes = format!("include_bytes!(concat!(env!(\"OUT_DIR\"), \"/{packed}\"))");
        writeln!(code, "    Packed {{ name: {name:?}, length: {}, bytes: {bytes} }},", text.len())
            .map_err(io::Error::other)?;
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
