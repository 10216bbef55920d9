//! Compiles `ncp.proto` without protoc: the Rust types, the embedded descriptor set, and the lists by which the
//! messages are converted.

use std::{env, error::Error, fs, path::PathBuf};

use prost::Message;
use prost_types::{DescriptorProto, FileDescriptorSet};

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
    fs::write(out.join("messages.rs"), conversions(&set))?;
    prost_build::Config::new().btree_map(["."]).compile_fds(set)?;
    Ok(())
}

/// The fields of every message, as the macros of `src/convert/messages.rs` take them.
fn conversions(set: &FileDescriptorSet) -> String {
    let messages = || set.file.iter().flat_map(|file| &file.message_type);
    // A frame says its kind and its version; the step of a horizon is a plain map in a message.
    let is_frame = |message: &DescriptorProto| message.field.iter().any(|field| field.name() == "ncp_version");
    let list = |name: &str, frames: bool| {
        let listed = messages().filter(|message| message.name() != "SetpointStep" && is_frame(message) == frames);
        let listed: String = listed.map(|message| conversion(message, frames)).collect();
        format!("{name}! {{\n{listed}}}\n")
    };
    list("messages", false) + &list("frames", true)
}

fn conversion(message: &DescriptorProto, is_frame: bool) -> String {
    let prepare = match message.name() {
        "OpenSession" => "prepare network_is_there ",
        "StepRequest" => "prepare fill_in_step ",
        "RunRequest" => "prepare fill_in_run ",
        _ => "",
    };
    let fields = message.field.iter().map(|field| field.name()).filter(|name| !is_frame || *name != "kind");
    let fields = fields.map(|name| match name {
        // A word of Rust, so the two sides name it differently.
        "ref" => "\"ref\" reference r#ref".to_owned(),
        name => format!("\"{name}\" {name} {name}"),
    });
    format!("    {} {prepare}{{ {} }}\n", message.name(), fields.collect::<Vec<_>>().join(", "))
}
