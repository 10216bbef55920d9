//! Makes the broken readers: copies of the sources that read versions, keys and blocks, each with one edit.
//!
//! Comments and tests are left out of the copies; an edit whose text does not occur exactly once is an error.

use std::env;
use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

include!("broken.rs");

/// The three readers, each a file or a folder of the specification.
const READERS: [&str; 3] = ["version", "keys", "bulk"];

fn main() -> Result<(), Box<dyn Error>> {
    let source = Path::new(&env::var("CARGO_MANIFEST_DIR")?).join("../../spec/src");
    let out = PathBuf::from(env::var("OUT_DIR")?);
    println!("cargo:rerun-if-changed=broken.rs");
    println!("cargo:rerun-if-changed=../edit.rs");
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rustc-check-cfg=cfg(kani)");
    for reader in ["version.rs", "keys.rs", "bulk"] {
        println!("cargo:rerun-if-changed={}", source.join(reader).display());
    }

    let is_wanted = env::var_os("CARGO_FEATURE_BROKEN").is_some();
    let (mut modules, mut arms) = (String::new(), String::new());
    for broken in BROKEN {
        let id = broken.id;
        let reader = broken.file.split(['.', '/']).next().unwrap_or_default();
        let folder = out.join("readers").join(id);
        let path = copy(broken, reader, &source, &folder)?;
        if !is_wanted {
            continue;
        }
        let sound: Vec<_> = READERS.into_iter().filter(|r| *r != reader).collect();
        writeln!(
            modules,
            "mod {id} {{ #[path = {path:?}] pub mod {reader}; pub use ncp_spec::{{{}}}; crate::readers::readers! {{ /// A broken reader.\nSubject }} }}",
            sound.join(", ")
        )?;
        writeln!(arms, "{id:?} => crate::properties::enumerated::{reader}::<{id}::Subject>(property),")?;
    }
    let table = format!(
        "{modules}\n/// The harness of a property on a broken reader.\n#[must_use]\npub fn harness(id: &str, property: &str) -> Option<crate::properties::Enumerated> {{\n match id {{\n{arms} _ => None }}\n}}\n"
    );
    fs::write(out.join("broken_readers.rs"), table)?;
    Ok(())
}

/// Copies a reader with its one edit, and returns the file of its module.
fn copy(broken: &Broken, reader: &str, source: &Path, folder: &Path) -> Result<PathBuf, Box<dyn Error>> {
    fs::create_dir_all(folder.join(reader))?;
    let mut files = Vec::new();
    if source.join(reader).is_dir() {
        for file in fs::read_dir(source.join(reader))? {
            files.push(format!("{reader}/{}", file?.file_name().to_string_lossy()));
        }
    } else {
        files.push(format!("{reader}.rs"));
    }
    let mut edited = 0;
    for file in &files {
        let mut text = code_of(&fs::read_to_string(source.join(file))?);
        if file == broken.file {
            edited += text.matches(broken.from).count();
            text = text.replacen(broken.from, broken.to, 1);
        }
        text = text.replace("crate::wire::", "ncp_spec::wire::").replace("crate::ErrorCode", "ncp_spec::ErrorCode");
        fs::write(folder.join(file), text)?;
    }
    if edited != 1 {
        return Err(format!("{}: {:?} does not occur once in {}", broken.id, broken.from, broken.file).into());
    }
    let is_folder = source.join(reader).is_dir();
    Ok(folder.join(if is_folder { format!("{reader}/mod.rs") } else { format!("{reader}.rs") }))
}

/// A source without its comments on whole lines and without its tests.
fn code_of(text: &str) -> String {
    let text = text.replace("\r\n", "\n");
    let code = text.split("#[cfg(test)]").next().unwrap_or_default();
    code.lines()
        .filter(|line| !line.trim_start().starts_with("//"))
        .fold(String::new(), |code, line| code + line + "\n")
}
