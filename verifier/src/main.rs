//! The program `ncp-verify`.

#![forbid(unsafe_code)]

fn main() -> std::process::ExitCode {
    ncp_verifier::cli::main()
}
