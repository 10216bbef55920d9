//! Compiles the service of `ncp.proto` without protoc. The messages are those of `ncp-proto`.

use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=../../proto/ncp.proto");
    let files = protox::compile(["ncp.proto"], ["../../proto"])?;
    tonic_prost_build::configure().extern_path(".ncp.v0", "::ncp_proto::v0").compile_fds(files)?;
    Ok(())
}
