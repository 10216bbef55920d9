//! The gateway: it stands between NCP clients and a simulation service that speaks JSON by lines over TCP.
//!
//! A request of any front end is read, written anew as one line, forwarded, and answered by the line that comes back,
//! if that is a reply to it, and by an error frame if not. Sessions are served side by side, each in order.
//!
//! | module | what it holds |
//! |---|---|
//! | [`config`] | the settings, by environment or command line |
//! | [`gateway`] | all of it, started and stopped together |
//! | [`backend`] | what the front ends share: a lane a session, and the bridge |
//! | [`failure`] | why a request is answered with an error frame |
//! | [`metrics`] | what is counted |
//! | [`service`] | the other end of the bridge, for simulators in Rust and for tests |
//! | `front` | Zenoh, WebSocket, gRPC, and HTTP for those who watch |
//! | `bridge` | the connections to the service |
//! | `request` | a request as one line, and which reply fits it |
//! | `neuro_sim` | the gRPC service as tonic makes it from the proto |

#![forbid(unsafe_code)]

pub mod backend;
mod bridge;
pub mod config;
pub mod failure;
mod front;
pub mod gateway;
pub mod metrics;
mod request;
pub mod service;

/// The service `NeuroSim`, server and client, as tonic makes them from the proto.
#[allow(missing_docs, clippy::all, clippy::semicolon_if_nothing_returned, reason = "generated")]
pub mod neuro_sim {
    tonic::include_proto!("ncp.v0");
}

use std::process::ExitCode;

use tokio::signal::unix::{SignalKind, signal};
use tracing_subscriber::EnvFilter;

pub use backend::Backend;
pub use config::{ConfigError, LogForm, Settings};
pub use failure::{Answer, Failure, Refusal};
pub use gateway::{Addresses, Gateway, GatewayError};
pub use metrics::{Front, Metrics};

/// What the program does: it serves until SIGTERM or SIGINT, drains, and ends with 0. It ends with 2 when a setting is
/// wrong `[NCP-TRANS-012]`, and with 1 when it cannot start for another reason, or could not drain.
#[must_use]
pub fn run(settings: &Settings) -> ExitCode {
    log(settings.log);
    match serve(settings) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            tracing::error!("refused to start: {error}");
            ExitCode::from(if matches!(error, GatewayError::Config(_)) { 2 } else { 1 })
        }
    }
}

fn serve(settings: &Settings) -> Result<bool, GatewayError> {
    let runtime = tokio::runtime::Builder::new_multi_thread().enable_all().thread_name("ncp-gateway").build()?;
    runtime.block_on(async {
        let (mut terminate, mut interrupt) = (signal(SignalKind::terminate())?, signal(SignalKind::interrupt())?);
        let gateway = Gateway::start(settings).await?;
        tokio::select! {
            _ = terminate.recv() => {}
            _ = interrupt.recv() => {}
        }
        Ok(gateway.stop().await)
    })
}

/// Writes the log to stderr. A log that somebody else set up stays.
fn log(form: LogForm) {
    let filter = EnvFilter::try_from_default_env().unwrap_or_else(|_| EnvFilter::new("info,zenoh=warn"));
    let log = tracing_subscriber::fmt().with_env_filter(filter).with_writer(std::io::stderr);
    let _ = match form {
        LogForm::Text => log.with_ansi(false).try_init(),
        LogForm::Json => log.json().flatten_event(true).try_init(),
    };
}
