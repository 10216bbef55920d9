//! Makes the broken readers: a copy of the sources that read versions, keys or blocks for each defect of the table, to
//! be compiled as it is.

use std::env;
use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use ncp_defects::copy::planted;
use ncp_defects::{Defect, read};

/// The three readers, each a file or a folder of the specification.
const READERS: [(&str, &str); 3] =
    [("version", "spec/src/version.rs"), ("keys", "spec/src/keys.rs"), ("bulk", "spec/src/bulk")];
const TABLE: &str = "defects/readers.toml";

fn main() -> Result<(), Box<dyn Error>> {
    let root = Path::new(&env::var("CARGO_MANIFEST_DIR")?).join("../..");
    let out = PathBuf::from(env::var("OUT_DIR")?);
    for source in READERS.map(|(_, source)| source).into_iter().chain([TABLE]) {
        println!("cargo::rerun-if-changed={}", root.join(source).display());
    }
    println!("cargo::rustc-check-cfg=cfg(kani)");

    let (mut modules, mut arms) = (String::new(), String::new());
    for defect in read(&root.join(TABLE))? {
        let module = defect.name.replace('-', "_");
        let (reader, source) = reader_of(&defect)?;
        let mut copy = planted(&root, source, &out.join("readers").join(&defect.name), &defect)?;
        if copy.is_dir() {
            copy.push("mod.rs");
        }
        let sound: Vec<_> = READERS.map(|(name, _)| name).into_iter().filter(|name| *name != reader).collect();
        writeln!(
            modules,
            "mod {module} {{ #[path = {copy:?}] pub mod {reader}; pub use ncp_spec::{{{}}}; \
             crate::readers::readers! {{ /// A broken reader.\nSubject }} }}",
            sound.join(", ")
        )?;
        let name = &defect.name;
        writeln!(arms, "{name:?} => crate::properties::enumerated::{reader}::<{module}::Subject>(property),")?;
    }
    let table = format!(
        "{modules}\n/// The harness of a property on a broken reader.\n#[must_use]\n\
         pub fn harness(name: &str, property: &str) -> Option<crate::properties::Enumerated> {{\n \
         match name {{\n{arms} _ => None }}\n}}\n"
    );
    fs::write(out.join("broken_readers.rs"), table)?;
    Ok(())
}

/// The reader that a defect is in, and where that stands.
fn reader_of(defect: &Defect) -> Result<(&'static str, &'static str), String> {
    let is_there = |source: &str| defect.edit.iter().any(|edit| edit.file.starts_with(source));
    let reader = READERS.into_iter().find(|(_, source)| is_there(source));
    reader.ok_or_else(|| format!("{} is in none of the readers", defect.name))
}
