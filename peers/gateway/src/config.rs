//! What the gateway is told when it starts, by environment or command line.

use std::net::SocketAddr;
use std::path::{Path, PathBuf};
use std::time::Duration;

use clap::builder::FalseyValueParser;
use clap::{Parser, ValueEnum};
use ncp_spec::keys::{KeyError, validate_realm};
use thiserror::Error;
use zenoh::Config;

use crate::bridge::BridgeSettings;

const BRIDGE_ADDR: &str = "127.0.0.1:28474";
const WS_SEND_TIMEOUT_MS: u64 = 5_000;
const BRIDGE_TIMEOUT_MS: u64 = 8_000;
/// The default of Zenoh's queries.
const QUERY_TIMEOUT_MS: u64 = 10_000;
const BRIDGE_CONNECTIONS: usize = 64;

/// Stand between NCP clients and a simulation service that speaks JSON by lines over TCP
#[derive(Debug, Clone, PartialEq, Eq, Parser)]
#[command(name = "ncp-gateway", version)]
pub struct Settings {
    /// The realm whose control key is answered
    #[arg(long, env = "NCP_REALM", default_value = ncp_spec::keys::DEFAULT_REALM)]
    pub realm: String,
    /// Where the simulation service listens
    #[arg(long, env = "NCP_BRIDGE_ADDR", value_name = "HOST:PORT", default_value = BRIDGE_ADDR)]
    pub bridge_addr: String,
    /// Zenoh's configuration [default: Zenoh's own: a peer that scouts, and listens on every interface]
    #[arg(long, env = "NCP_ZENOH_CONFIG", value_name = "FILE")]
    pub zenoh_config: Option<PathBuf>,
    /// Serve WebSockets here
    #[arg(long, env = "NCP_WS_ADDR", value_name = "ADDRESS")]
    pub ws_addr: Option<SocketAddr>,
    /// Pages that may connect besides those of this host, such as https://lab.example
    #[arg(long, env = "NCP_WS_ORIGINS", value_name = "ORIGIN", value_delimiter = ',')]
    pub ws_origins: Vec<String>,
    /// Drop a WebSocket that has not taken a reply within this time, in ms
    #[arg(long, env = "NCP_WS_SEND_TIMEOUT_MS", value_name = "MS", default_value_t = WS_SEND_TIMEOUT_MS)]
    pub ws_send_timeout_ms: u64,
    /// Serve gRPC here
    #[arg(long, env = "NCP_GRPC_ADDR", value_name = "ADDRESS")]
    pub grpc_addr: Option<SocketAddr>,
    /// Serve /healthz and /metrics here
    #[arg(long, env = "NCP_HTTP_ADDR", value_name = "ADDRESS")]
    pub http_addr: Option<SocketAddr>,
    /// Serve these also beyond this host: they ask for no certificate
    #[arg(long, env = "NCP_ALLOW_REMOTE", value_parser = FalseyValueParser::new())]
    pub allow_remote: bool,
    /// Answer with an error frame when a request took longer, in ms
    #[arg(long, env = "NCP_BRIDGE_TIMEOUT_MS", value_name = "MS", default_value_t = BRIDGE_TIMEOUT_MS)]
    pub bridge_timeout_ms: u64,
    /// How long the clients of this deployment wait for a reply, in ms
    #[arg(long, env = "NCP_QUERY_TIMEOUT_MS", value_name = "MS", default_value_t = QUERY_TIMEOUT_MS)]
    pub query_timeout_ms: u64,
    /// Connections to the simulation service at most: as many sessions are stepped side by side
    #[arg(long, env = "NCP_BRIDGE_CONNECTIONS", value_name = "COUNT", default_value_t = BRIDGE_CONNECTIONS)]
    pub bridge_connections: usize,
    /// How the log is written to stderr; RUST_LOG says how much of it
    #[arg(long, env = "NCP_LOG", default_value = "text")]
    pub log: LogForm,
}

/// How the log is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum LogForm {
    /// A line for people
    Text,
    /// A JSON object a line
    Json,
}

/// Why the gateway refuses to start.
#[derive(Debug, Error)]
pub enum ConfigError {
    /// `NCP_ZENOH_CONFIG` cannot be read, or is no configuration of Zenoh's. `[NCP-TRANS-012]`
    #[error("NCP_ZENOH_CONFIG: {path}: {why}")]
    Zenoh {
        /// The file.
        path: PathBuf,
        /// What Zenoh says.
        why: String,
    },
    /// `NCP_REALM` is no realm.
    #[error("NCP_REALM: {0}")]
    Realm(#[from] KeyError),
    /// The bridge would still wait when the client has given up. `[NCP-TRANS-006]`
    #[error("NCP_BRIDGE_TIMEOUT_MS is {bridge_ms}: it has to be over 0, and under NCP_QUERY_TIMEOUT_MS, {query_ms}")]
    Timeouts {
        /// The bridge's time-out, ms.
        bridge_ms: u64,
        /// The query's, ms.
        query_ms: u64,
    },
    /// `NCP_BRIDGE_CONNECTIONS` is 0, or more than there are requests.
    #[error("NCP_BRIDGE_CONNECTIONS is {0}: it has to be from 1 to {max}", max = crate::backend::MAX_IN_FLIGHT)]
    Connections(usize),
    /// An address is not on this host, and nothing says that it may be so.
    #[error("{variable}: {address} is not on loopback, and NCP_ALLOW_REMOTE is not set")]
    Remote {
        /// The variable.
        variable: &'static str,
        /// The address.
        address: SocketAddr,
    },
}

impl Default for Settings {
    /// What an environment that says nothing says.
    fn default() -> Self {
        Self {
            realm: ncp_spec::keys::DEFAULT_REALM.to_owned(),
            bridge_addr: BRIDGE_ADDR.to_owned(),
            zenoh_config: None,
            ws_addr: None,
            ws_origins: Vec::new(),
            ws_send_timeout_ms: WS_SEND_TIMEOUT_MS,
            grpc_addr: None,
            http_addr: None,
            allow_remote: false,
            bridge_timeout_ms: BRIDGE_TIMEOUT_MS,
            query_timeout_ms: QUERY_TIMEOUT_MS,
            bridge_connections: BRIDGE_CONNECTIONS,
            log: LogForm::Text,
        }
    }
}

impl Settings {
    /// Checks what can be checked before anything is opened, and gives Zenoh's configuration.
    ///
    /// # Errors
    /// [`ConfigError`] says which setting is wrong.
    pub(crate) fn check(&self) -> Result<Config, ConfigError> {
        validate_realm(&self.realm)?; // [NCP-KEY-006]
        let (bridge_ms, query_ms) = (self.bridge_timeout_ms, self.query_timeout_ms);
        if bridge_ms == 0 || bridge_ms >= query_ms {
            return Err(ConfigError::Timeouts { bridge_ms, query_ms }); // [NCP-TRANS-006]
        }
        if !(1..=crate::backend::MAX_IN_FLIGHT).contains(&self.bridge_connections) {
            return Err(ConfigError::Connections(self.bridge_connections));
        }
        let listened =
            [("NCP_WS_ADDR", self.ws_addr), ("NCP_GRPC_ADDR", self.grpc_addr), ("NCP_HTTP_ADDR", self.http_addr)];
        for (variable, address) in listened {
            if let Some(address) = address.filter(|address| !self.allow_remote && !address.ip().is_loopback()) {
                return Err(ConfigError::Remote { variable, address });
            }
        }
        self.zenoh_config.as_deref().map_or_else(|| Ok(Config::default()), zenoh_config)
    }

    /// How the simulation service is spoken to.
    pub(crate) fn bridge(&self) -> BridgeSettings {
        BridgeSettings {
            address: self.bridge_addr.clone(),
            timeout: Duration::from_millis(self.bridge_timeout_ms),
            connections: self.bridge_connections,
        }
    }
}

/// `[NCP-TRANS-012]`
fn zenoh_config(path: &Path) -> Result<Config, ConfigError> {
    Config::from_file(path).map_err(|why| ConfigError::Zenoh { path: path.to_owned(), why: why.to_string() })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn settings(arguments: &[&str]) -> Settings {
        Settings::try_parse_from(["ncp-gateway"].iter().chain(arguments)).unwrap()
    }

    #[test]
    fn the_defaults_are_those_of_the_text() {
        assert_eq!(settings(&[]), Settings::default());
        let chapter = include_str!("../../../spec/text/11-transports.md");
        let Settings { realm, bridge_addr, zenoh_config, .. } = Settings::default();
        for (variable, default) in [("NCP_REALM", realm), ("NCP_BRIDGE_ADDR", bridge_addr)] {
            let row = format!("| `{variable}` | `{default}` |");
            assert!(chapter.lines().any(|line| line == row), "{row}");
        }
        assert!(chapter.contains("| `NCP_ZENOH_CONFIG` | none: Zenoh's defaults |"));
        assert_eq!(zenoh_config, None);
    }

    /// `[NCP-TRANS-006]`
    #[test]
    fn a_bridge_that_waits_as_long_as_a_query_is_refused() {
        assert!(settings(&[]).check().is_ok());
        for (bridge, query) in [("10000", "10000"), ("10001", "10000"), ("0", "10000"), ("1", "0")] {
            let refused = settings(&["--bridge-timeout-ms", bridge, "--query-timeout-ms", query]).check();
            assert!(matches!(refused, Err(ConfigError::Timeouts { .. })), "{bridge} {query}");
        }
    }

    #[test]
    fn what_is_not_on_loopback_is_served_only_when_that_is_said() {
        for option in ["--ws-addr", "--grpc-addr", "--http-addr"] {
            let refused = settings(&[option, "0.0.0.0:0"]).check();
            assert!(matches!(refused, Err(ConfigError::Remote { .. })), "{option}");
            assert!(settings(&[option, "0.0.0.0:0", "--allow-remote"]).check().is_ok(), "{option}");
            assert!(settings(&[option, "[::1]:0"]).check().is_ok(), "{option}");
        }
    }

    #[test]
    fn a_realm_that_is_none_and_no_connections_are_refused() {
        assert!(matches!(settings(&["--realm", "a//b"]).check(), Err(ConfigError::Realm(_))));
        assert!(matches!(settings(&["--bridge-connections", "0"]).check(), Err(ConfigError::Connections(0))));
    }
}
