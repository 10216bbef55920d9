//! Makes the broken kernels: copies of the kernel's source, each with one token changed.
//!
//! A change whose text does not occur exactly once is left out, and said to be missing: a kernel that was changed
//! is held against its properties all the same.

use std::env;
use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

include!("broken.rs");

/// The words of the kernel are shared: a broken kernel speaks the same ones.
const SHARED: [&str; 2] = ["scalar", "vocabulary"];

fn main() -> Result<(), Box<dyn Error>> {
    let source = Path::new(&env::var("CARGO_MANIFEST_DIR")?).join("../spec/src/safety/kernel");
    let out = PathBuf::from(env::var("OUT_DIR")?);
    println!("cargo:rerun-if-changed={}", source.display());
    println!("cargo:rerun-if-changed=broken.rs");
    println!("cargo:rerun-if-changed=edit.rs");
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rustc-check-cfg=cfg(kani)");

    let is_wanted = env::var_os("CARGO_FEATURE_BROKEN").is_some();
    let (mut modules, mut arms, mut missing) = (String::new(), String::new(), String::new());
    for broken in BROKEN {
        let changed = fs::read_to_string(source.join(broken.file))?.replace("\r\n", "\n");
        let times = changed.matches(broken.from).count();
        if times != 1 {
            writeln!(missing, "({:?}, {times}),", broken.id)?;
            continue;
        }
        let folder = out.join(broken.id);
        fs::create_dir_all(&folder)?;
        for file in fs::read_dir(&source)? {
            let file = file?;
            let name = file.file_name().to_string_lossy().into_owned();
            let mut text = fs::read_to_string(file.path())?.replace("\r\n", "\n");
            if name == broken.file {
                text = text.replacen(broken.from, broken.to, 1);
            }
            text = text.replace("crate::wire::", "ncp_spec::wire::");
            if name == "mod.rs" {
                for shared in SHARED {
                    text = text
                        .replace(&format!("mod {shared};\n"), "")
                        .replace(&format!("pub use {shared}::"), "pub use ncp_spec::safety::kernel::");
                }
            }
            fs::write(folder.join(name), text)?;
        }
        if !is_wanted {
            continue;
        }
        let path = folder.join("mod.rs");
        let id = broken.id;
        writeln!(modules, "#[path = {path:?}]\nmod {id};")?;
        let numbers = if broken.file == "scalar.rs" {
            let path = folder.join("scalar.rs");
            writeln!(modules, "#[path = {path:?}]\nmod {id}_numbers;")?;
            format!("super::{id}_numbers")
        } else {
            "ncp_spec::safety::kernel".to_owned()
        };
        writeln!(
            modules,
            "pub mod k_{id} {{ use super::*; crate::kernel::kernel! {{ /// A broken kernel.\nKernel = [super::{id}] [{numbers}] }} }}"
        )?;
        let harness = broken.property.replace('/', "::").replace('-', "_");
        writeln!(arms, "{id:?} => Some(crate::properties::of!(k_{id}::Kernel, crate::properties::{harness})),")?;
    }
    let table = format!(
        "{modules}\n/// The harness of its property on a broken kernel.\n#[must_use]\npub fn harness(id: &str) -> Option<crate::properties::Harness> {{\n match id {{\n{arms} _ => None }}\n}}\n"
    );
    fs::write(out.join("broken_kernels.rs"), table)?;
    let missing = format!(
        "/// The broken kernels whose text does not occur once in its file, with how often it does.\npub const MISSING: &[(&str, usize)] = &[\n{missing}];\n"
    );
    fs::write(out.join("broken_missing.rs"), missing)?;
    Ok(())
}
