//! Makes the broken kernels: a copy of the kernel's decisions, or of its numbers, for each defect of the table, to be
//! compiled as it is; and the sabotaged engine.

use std::env;
use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use ncp_defects::copy::{CopyError, planted};
use ncp_defects::weave::{Site, weave};
use ncp_defects::{Defect, read};

/// What is copied: one of both.
const DECISIONS: &str = "spec/kernel/src/decisions";
const NUMBERS: &str = "spec/kernel/src/scalar.rs";
const TABLE: &str = "defects/kernel.toml";

/// The engine's own sources, and the defects that are woven into a copy of them.
const ENGINE: [&str; 2] = ["proofs/src/engines", "proofs/src/provers"];
const SABOTAGE: &str = "defects/engine.toml";

fn main() -> Result<(), Box<dyn Error>> {
    let root = Path::new(&env::var("CARGO_MANIFEST_DIR")?).join("..");
    let out = PathBuf::from(env::var("OUT_DIR")?);
    for source in [DECISIONS, NUMBERS, TABLE] {
        println!("cargo::rerun-if-changed={}", root.join(source).display());
    }
    println!("cargo::rustc-check-cfg=cfg(kani)");
    // A copy of the numbers stands under the feature that production has.
    println!("cargo::rustc-check-cfg=cfg(feature, values(\"std\"))");
    println!("cargo::rustc-cfg=feature=\"std\"");

    let (mut modules, mut arms, mut missing) = (String::new(), String::new(), String::new());
    for defect in read(&root.join(TABLE))? {
        let source = if defect.edit.iter().any(|edit| edit.file == NUMBERS) { NUMBERS } else { DECISIONS };
        match planted(&root, source, &out.join(&defect.name), &defect) {
            Ok(copy) => add(&defect, &copy, &mut modules, &mut arms)?,
            Err(error @ CopyError::Place(_)) => writeln!(missing, "({:?}, {:?}),", defect.name, error.to_string())?,
            Err(error) => return Err(error.into()),
        }
    }
    let table = format!(
        "{modules}\n/// The harness of a property on a broken kernel.\n#[must_use]\n\
         pub fn harness(name: &str, property: &str) -> Option<crate::harness::Harness> {{\n \
         match (name, property) {{\n{arms} _ => None }}\n}}\n"
    );
    fs::write(out.join("broken_kernels.rs"), table)?;
    let missing = format!(
        "/// The defects that have no place in the kernel, and why.\npub const MISSING: &[(&str, &str)] = \
         &[\n{missing}];\n"
    );
    fs::write(out.join("broken_missing.rs"), missing)?;
    if env::var_os("CARGO_FEATURE_SABOTAGE").is_some() {
        sabotage(&root, &out)?;
    }
    Ok(())
}

/// Weaves a switch for every defect of the engine into a copy of its sources.
fn sabotage(root: &Path, out: &Path) -> Result<(), Box<dyn Error>> {
    let defects = read(&root.join(SABOTAGE))?;
    let mut modules = String::new();
    for folder in ENGINE {
        println!("cargo::rerun-if-changed={}", root.join(folder).display());
        for file in files(&root.join(folder))? {
            let name = file.strip_prefix(root)?.to_string_lossy().replace('\\', "/");
            let sites = defects.iter().enumerate().flat_map(|(number, defect)| {
                let edits = defect.edit.iter().filter(|edit| edit.file == name);
                edits.map(move |edit| Site { number, name: &defect.name, edit })
            });
            let text = fs::read_to_string(&file)?.replace("\r\n", "\n");
            let woven = weave(&text, "crate::sabotage::is", &sites.collect::<Vec<_>>())?;
            let copy = out.join("sabotaged").join(&name);
            fs::create_dir_all(copy.parent().ok_or("no folder")?)?;
            fs::write(copy, woven)?;
        }
        let module = folder.rsplit('/').next().unwrap_or(folder);
        let file = out.join("sabotaged").join(folder).join("mod.rs");
        writeln!(modules, "#[path = {file:?}]\n#[allow(warnings, reason = \"woven\")]\npub mod {module};")?;
    }
    println!("cargo::rerun-if-changed={}", root.join(SABOTAGE).display());
    fs::write(out.join("sabotaged.rs"), modules)?;
    Ok(())
}

/// All files under a folder.
fn files(folder: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let mut all = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            all.extend(files(&path)?);
        } else {
            all.push(path);
        }
    }
    Ok(all)
}

/// A broken kernel, as a module and as the harnesses of its properties.
fn add(defect: &Defect, copy: &Path, modules: &mut String, arms: &mut String) -> Result<(), Box<dyn Error>> {
    let own = defect.properties.iter().filter(|property| !property.starts_with("machine/"));
    let name = &defect.name;
    let module = name.replace('-', "_");
    for (nth, property) in own.enumerate() {
        if nth == 0 {
            let (file, parts) = if copy.is_dir() {
                (copy.join("mod.rs"), format!("[super::{module}] [ncp_kernel]"))
            } else {
                (copy.to_owned(), format!("[ncp_kernel] [super::{module}]"))
            };
            writeln!(modules, "#[path = {file:?}]\nmod {module};")?;
            writeln!(
                modules,
                "mod k_{module} {{ use super::*; crate::kernel::kernel! {{ /// A broken kernel.\nKernel = {parts} }} }}"
            )?;
        }
        let claim = property.replace('/', "::").replace('-', "_");
        let harness = format!("crate::harness::of!(k_{module}::Kernel, crate::properties::{claim})");
        writeln!(arms, "({name:?}, {property:?}) => Some({harness}),")?;
    }
    Ok(())
}
