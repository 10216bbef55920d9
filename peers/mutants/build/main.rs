//! Makes the mutated peer: copies the sources of `ncp-spec` and `ncp-peer-rust` into `OUT_DIR`, with a switch at
//! every place that a mutant changes. The sources themselves stay as they are.

mod table;
mod weave;

use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs, io};

use table::Mutant;
use weave::Site;

/// The packages that are copied: the folder in the repository, and the module that it becomes.
const PACKAGES: [(&str, &str); 2] = [("spec", "ncp_spec"), ("peers/rust", "ncp_peer_rust")];

fn main() -> ExitCode {
    match make() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn make() -> Result<(), Box<dyn Error>> {
    let here = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    let out = PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default());
    let root = here.join("../..").canonicalize()?;
    println!("cargo::rerun-if-changed=build");
    println!("cargo::rerun-if-changed=mutants");

    let mutants = table::read(&here.join("mutants"))?;
    let mut sites: BTreeMap<&str, Vec<Site<'_>>> = BTreeMap::new();
    for (number, mutant) in mutants.iter().enumerate() {
        for edit in &mutant.edit {
            sites.entry(&edit.file).or_default().push(Site {
                number,
                name: &mutant.name,
                after: edit.after.as_deref(),
                code: &edit.code,
                with: &edit.with,
            });
        }
    }

    let mut modules = String::new();
    for (folder, module) in PACKAGES {
        // A file that is no longer there must not be left over from the last time.
        if out.join(folder).exists() {
            fs::remove_dir_all(out.join(folder))?;
        }
        println!("cargo::rerun-if-changed={}", root.join(folder).display());
        for source in files(&root.join(folder).join("src"))? {
            let name = relative(&source, &root);
            let text = fs::read_to_string(&source)?;
            let sites = sites.remove(name.as_str()).unwrap_or_default();
            let woven = weave::weave(&text, &sites).map_err(|e| format!("{name}: {e}"))?;
            write(&out.join(&name), &moved(&woven, module))?;
        }
        let root_file = out.join(folder).join("src/lib.rs");
        writeln!(
            modules,
            "#[allow(warnings, reason = \"it is checked where it comes from\")]\n#[path = {root_file:?}]\nmod {module};"
        )?;
    }
    if let Some((file, sites)) = sites.first_key_value() {
        let names: Vec<&str> = sites.iter().map(|site| site.name).collect();
        return Err(format!("{file} is no source file: {}", names.join(", ")).into());
    }
    // The specification reads its own text.
    for source in files(&root.join("spec/text"))? {
        write(&out.join(relative(&source, &root)), &fs::read_to_string(&source)?)?;
    }
    fs::write(out.join("modules.rs"), modules)?;
    fs::write(out.join("table.rs"), as_code(&mutants)?)?;
    Ok(())
}

/// The text of a crate's file as one of a module: paths begin at the module, and no function is `const`, since a
/// switch is read at run time.
fn moved(text: &str, module: &str) -> String {
    let text = text.replace("const fn ", "fn ");
    let text = text.replace("crate::", &format!("crate::{module}::"));
    if module == "ncp_spec" { text } else { text.replace("ncp_spec::", "crate::ncp_spec::") }
}

/// The table, as `src/main.rs` includes it.
fn as_code(mutants: &[Mutant]) -> Result<String, std::fmt::Error> {
    let mut code = String::from("/// Every mutant; its place is its number.\nstatic MUTANTS: &[Mutant] = &[\n");
    for Mutant { name, about, finding, rules, .. } in mutants {
        writeln!(code, "    Mutant {{ name: {name:?}, about: {about:?}, finding: {finding:?}, rules: &{rules:?} }},")?;
    }
    code.push_str("];\n");
    Ok(code)
}

/// All files below a folder.
fn files(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            found.extend(files(&path)?);
        } else {
            found.push(path);
        }
    }
    Ok(found)
}

fn relative(path: &Path, root: &Path) -> String {
    let path = path.strip_prefix(root).unwrap_or(path);
    path.to_string_lossy().replace('\\', "/")
}

fn write(path: &Path, text: &str) -> io::Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    fs::write(path, text)
}
