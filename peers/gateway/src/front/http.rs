//! `/healthz` and `/metrics`.

use axum::Router;
use axum::extract::State;
use axum::http::{StatusCode, header};
use axum::response::IntoResponse;
use axum::routing::get;
use tokio::net::TcpListener;
use tokio_util::sync::CancellationToken;

use crate::backend::Backend;
use crate::metrics::Metrics;

/// Serves until it is told to stop.
pub(crate) async fn serve(listener: TcpListener, backend: Backend, metrics: Metrics, stop: CancellationToken) {
    let router = Router::new()
        .route("/healthz", get(health).with_state(backend))
        .route("/metrics", get(counted).with_state(metrics));
    let served = axum::serve(listener, router).with_graceful_shutdown(stop.cancelled_owned()).await;
    if let Err(error) = served {
        tracing::error!("http: {error}");
    }
}

/// 200 while requests are taken and the service can be reached.
async fn health(State(backend): State<Backend>) -> impl IntoResponse {
    if !backend.is_open() {
        return (StatusCode::SERVICE_UNAVAILABLE, "stopping\n");
    }
    match backend.is_reachable().await {
        true => (StatusCode::OK, "ok\n"),
        false => (StatusCode::SERVICE_UNAVAILABLE, "the simulation service cannot be reached\n"),
    }
}

async fn counted(State(metrics): State<Metrics>) -> impl IntoResponse {
    let form = "application/openmetrics-text; version=1.0.0; charset=utf-8";
    ([(header::CONTENT_TYPE, form)], metrics.text())
}
