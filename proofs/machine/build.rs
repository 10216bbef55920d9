//! Copies the kernel once for each defect of `broken.json`, with that defect in it.

use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;
use std::{env, fs};

fn main() -> Result<(), Box<dyn Error>> {
    let here = env::var("CARGO_MANIFEST_DIR")?;
    let here = Path::new(&here);
    let kernel = here.join("../../spec/src/safety/kernel");
    println!("cargo::rerun-if-changed=broken.json");
    println!("cargo::rerun-if-changed={}", kernel.display());
    let out = env::var("OUT_DIR")?;
    let out = Path::new(&out);

    let broken: serde_json::Value = serde_json::from_str(&fs::read_to_string(here.join("broken.json"))?)?;
    let mut modules = String::new();
    for defect in broken.as_array().ok_or("broken.json is no array")? {
        let text = |name: &str| defect[name].as_str().ok_or(format!("{defect}: no {name}"));
        let id = text("id")?;
        let (changed, find) = (text("file")?, text("find")?);
        // Without its text there is no such kernel, and the proofs say that it was not refuted.
        if fs::read_to_string(kernel.join(changed))?.matches(find).count() != 1 {
            println!("cargo::warning={id}: {find:?} is not in {changed} exactly once");
            continue;
        }
        let folder = out.join(id);
        fs::create_dir_all(&folder)?;
        for file in fs::read_dir(&kernel)? {
            let file = file?;
            let name = file.file_name();
            let mut source = fs::read_to_string(file.path())?;
            if *name == *changed {
                source = source.replace(find, text("replace")?);
            }
            let source = source.replace("crate::wire::", "ncp_spec::wire::");
            fs::write(folder.join(name), source)?;
        }
        writeln!(
            modules,
            "mod {id} {{\n    #[path = {:?}]\n    mod kernel;\n    crate::wrappers::wrap!({id:?}, super::kernel);\n}}",
            folder.join("mod.rs")
        )?;
    }
    fs::write(out.join("broken.rs"), modules)?;
    Ok(())
}
