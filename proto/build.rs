//! Compiles `ncp.proto` without protoc: the Rust types and the embedded descriptor set.

use std::{env, error::Error, fs, path::PathBuf};

use prost::Message;

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=ncp.proto");
    let mut compiler = protox::Compiler::new(["."])?;
    compiler.include_source_info(true).open_file("ncp.proto")?;
    let mut set = compiler.file_descriptor_set();

    // The comments become documentation: leave the linter's remarks out of it.
    for location in set.file.iter_mut().flat_map(|file| &mut file.source_code_info).flat_map(|info| &mut info.location)
    {
        if let Some(comment) = &mut location.leading_comments {
            *comment = comment
                .lines()
                .filter(|line| !line.trim_start().starts_with("buf:lint:"))
                .map(|line| format!("{line}\n"))
                .collect();
        }
    }

    let out = PathBuf::from(env::var("OUT_DIR")?);
    fs::write(out.join("ncp.binpb"), set.encode_to_vec())?;
    prost_build::Config::new().btree_map(["."]).compile_fds(set)?;
    Ok(())
}
