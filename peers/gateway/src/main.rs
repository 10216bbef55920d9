//! The program `ncp-gateway`.

use std::process::ExitCode;

use clap::Parser;
use ncp_gateway::Settings;

fn main() -> ExitCode {
    ncp_gateway::run(&Settings::parse())
}
