//! The gateway as a whole: front ends on one backend, started and stopped together.

use std::io;
use std::net::SocketAddr;
use std::time::Duration;

use ncp_zenoh::{Bus, BusError};
use thiserror::Error;
use tokio::net::TcpListener;
use tokio::runtime::Handle;
use tokio::task::{JoinError, spawn_blocking};
use tokio::time::timeout;
use tokio_util::sync::CancellationToken;
use tokio_util::task::TaskTracker;

use crate::backend::Backend;
use crate::config::{ConfigError, Settings};
use crate::front::websocket::WebSockets;
use crate::front::zenoh::ZenohFront;
use crate::front::{grpc, http};
use crate::metrics::Metrics;

/// How long front ends may take to end once all requests are answered, and clients have taken their replies.
const FAREWELL: Duration = Duration::from_secs(2);

/// A running gateway.
pub struct Gateway {
    backend: Backend,
    metrics: Metrics,
    addresses: Addresses,
    zenoh: ZenohFront,
    /// Told, the front ends take no more.
    stop: CancellationToken,
    /// Told, also `/healthz` and `/metrics` end.
    stop_http: CancellationToken,
    serving: TaskTracker,
    send_timeout: Duration,
}

/// Where the front ends listen that do.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Addresses {
    /// WebSockets.
    pub websocket: Option<SocketAddr>,
    /// gRPC.
    pub grpc: Option<SocketAddr>,
    /// `/healthz` and `/metrics`.
    pub http: Option<SocketAddr>,
}

/// Why the gateway did not start.
#[derive(Debug, Error)]
pub enum GatewayError {
    /// A setting is wrong.
    #[error(transparent)]
    Config(#[from] ConfigError),
    /// An address cannot be listened on.
    #[error("{address}: {source}")]
    Listen {
        /// The address.
        address: SocketAddr,
        /// Why.
        source: io::Error,
    },
    /// The bus.
    #[error(transparent)]
    Bus(#[from] BusError),
    /// A thread panicked while it opened the bus.
    #[error(transparent)]
    Join(#[from] JoinError),
    /// The operating system gives no threads, or no signals.
    #[error(transparent)]
    Io(#[from] io::Error),
}

impl Gateway {
    /// Starts all front ends. It needs a runtime of several threads.
    ///
    /// # Errors
    /// A setting is wrong, an address is taken, or Zenoh cannot be opened.
    pub async fn start(settings: &Settings) -> Result<Self, GatewayError> {
        let config = settings.check()?;
        if settings.zenoh_config.is_none() {
            tracing::warn!("Zenoh's own configuration scouts, and listens on every interface; see NCP_ZENOH_CONFIG");
        }
        let (websocket, ws_addr) = listen("websocket", settings.ws_addr).await?;
        let (grpc, grpc_addr) = listen("grpc", settings.grpc_addr).await?;
        let (http, http_addr) = listen("http", settings.http_addr).await?;
        let addresses = Addresses { websocket: ws_addr, grpc: grpc_addr, http: http_addr };

        let metrics = Metrics::default();
        let backend = Backend::new(settings.bridge(), metrics.clone(), Handle::current());
        let (of_zenoh, counts, realm) = (backend.clone(), metrics.clone(), settings.realm.clone());
        let runtime = Handle::current();
        let zenoh = spawn_blocking(move || {
            ZenohFront::start(Bus::with_config(config, Some(&realm))?, of_zenoh, counts, runtime)
        });
        let zenoh = zenoh.await??;

        let send_timeout = Duration::from_millis(settings.ws_send_timeout_ms);
        let (stop, stop_http, serving) = (CancellationToken::new(), CancellationToken::new(), TaskTracker::new());
        if let Some(listener) = websocket {
            let serves = WebSockets {
                backend: backend.clone(),
                metrics: metrics.clone(),
                origins: settings.ws_origins.clone().into(),
                send_timeout,
                stop: stop.clone(),
            };
            serving.spawn(serves.serve(listener));
        }
        if let Some(listener) = grpc {
            serving.spawn(grpc::serve(listener, backend.clone(), stop.clone()));
        }
        if let Some(listener) = http {
            serving.spawn(http::serve(listener, backend.clone(), metrics.clone(), stop_http.clone()));
        }
        tracing::info!(realm = settings.realm, service = settings.bridge_addr, "requests are taken");
        Ok(Self { backend, metrics, addresses, zenoh, stop, stop_http, serving, send_timeout })
    }

    /// Where it listens, besides Zenoh.
    #[must_use]
    pub const fn addresses(&self) -> Addresses {
        self.addresses
    }

    /// What it has counted.
    #[must_use]
    pub const fn metrics(&self) -> &Metrics {
        &self.metrics
    }

    /// Takes no more requests, answers those that are in flight, and ends; whether all were answered.
    /// `[NCP-TRANS-010]`
    pub async fn stop(self) -> bool {
        let Self { backend, zenoh, stop, stop_http, serving, send_timeout, .. } = self;
        tracing::info!("stopping: what is in flight is answered");
        stop.cancel();
        let answering = spawn_blocking(move || zenoh.stop_taking()).await;
        let is_drained = backend.drain().await;
        if let Ok(answering) = answering
            && let Ok(bus) = timeout(FAREWELL, answering.finish()).await
        {
            // What Zenoh says when it closes, nobody needs.
            let _ = spawn_blocking(move || drop(bus)).await;
        }
        stop_http.cancel();
        serving.close();
        let has_ended = timeout(send_timeout + FAREWELL, serving.wait()).await.is_ok();
        tracing::info!(is_drained, has_ended, "stopped");
        is_drained && has_ended
    }
}

async fn listen(
    front: &'static str,
    address: Option<SocketAddr>,
) -> Result<(Option<TcpListener>, Option<SocketAddr>), GatewayError> {
    let Some(address) = address else { return Ok((None, None)) };
    let failed = |source| GatewayError::Listen { address, source };
    let listener = TcpListener::bind(address).await.map_err(failed)?;
    let address = listener.local_addr().map_err(failed)?;
    tracing::info!(front, %address, "listening");
    Ok((Some(listener), Some(address)))
}
