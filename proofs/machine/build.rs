//! Copies the kernel's decisions once for each defect that the proofs of the machine code have to refute, with that
//! defect in them.

use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;
use std::{env, fs};

use ncp_defects::copy::{CopyError, planted};
use ncp_defects::read;

const DECISIONS: &str = "spec/kernel/src/decisions";
const TABLE: &str = "defects/kernel.toml";

fn main() -> Result<(), Box<dyn Error>> {
    let root = Path::new(&env::var("CARGO_MANIFEST_DIR")?).join("../..");
    let out = env::var("OUT_DIR")?;
    let out = Path::new(&out);
    for source in [DECISIONS, TABLE] {
        println!("cargo::rerun-if-changed={}", root.join(source).display());
    }

    let mut modules = String::new();
    for defect in read(&root.join(TABLE))? {
        if !defect.properties.iter().any(|property| property.starts_with("machine/")) {
            continue;
        }
        let module = defect.name.replace('-', "_");
        let copy = match planted(&root, DECISIONS, &out.join(&defect.name), &defect) {
            Ok(copy) => copy,
            // There is no such kernel, and the proofs say that it was not refuted.
            Err(error @ CopyError::Place(_)) => {
                println!("cargo::warning={error}");
                continue;
            }
            Err(error) => return Err(error.into()),
        };
        writeln!(
            modules,
            "mod {module} {{\n    #[path = {:?}]\n    mod decisions;\n    \
             crate::wrappers::wrap!({module:?}, super::decisions);\n}}",
            copy.join("mod.rs")
        )?;
    }
    fs::write(out.join("broken.rs"), modules)?;
    Ok(())
}
