//! What the gateway counts, for Prometheus.

use std::sync::Arc;
use std::time::Duration;

use prometheus_client::encoding::text;
use prometheus_client::encoding::{EncodeLabelSet, EncodeLabelValue};
use prometheus_client::metrics::counter::Counter;
use prometheus_client::metrics::family::Family;
use prometheus_client::metrics::gauge::Gauge;
use prometheus_client::metrics::histogram::{Histogram, exponential_buckets};
use prometheus_client::registry::{Registry, Unit};

/// Where requests come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, EncodeLabelValue)]
pub enum Front {
    /// Queries on the control key.
    Zenoh,
    /// Messages of a WebSocket.
    WebSocket,
    /// Calls of the service `NeuroSim`.
    Grpc,
}

/// What has been counted; clones count together.
#[derive(Debug, Clone)]
pub struct Metrics(Arc<Counters>);

#[derive(Debug)]
struct Counters {
    registry: Registry,
    requests: Family<OfFront, Counter>,
    seconds: Family<OfFront, Histogram, fn() -> Histogram>,
    failures: Family<OfCause, Counter>,
    dropped: Family<OfReason, Counter>,
    undelivered: Family<OfFront, Counter>,
    bytes: Family<OfDirection, Counter>,
    connections: Counter,
    reconnects: Counter,
    in_flight: Gauge,
}

#[derive(Debug, Clone, PartialEq, Eq, Hash, EncodeLabelSet)]
struct OfFront {
    front: Front,
}

#[derive(Debug, Clone, PartialEq, Eq, Hash, EncodeLabelSet)]
struct OfCause {
    cause: &'static str,
}

#[derive(Debug, Clone, PartialEq, Eq, Hash, EncodeLabelSet)]
struct OfReason {
    reason: &'static str,
}

#[derive(Debug, Clone, PartialEq, Eq, Hash, EncodeLabelSet)]
struct OfDirection {
    direction: &'static str,
}

impl Default for Metrics {
    fn default() -> Self {
        // 0.1 ms to 13 s.
        let buckets: fn() -> Histogram = || Histogram::new(exponential_buckets(1e-4, 2.0, 18));
        let mut counters = Counters {
            registry: Registry::default(),
            requests: Family::default(),
            seconds: Family::new_with_constructor(buckets),
            failures: Family::default(),
            dropped: Family::default(),
            undelivered: Family::default(),
            bytes: Family::default(),
            connections: Counter::default(),
            reconnects: Counter::default(),
            in_flight: Gauge::default(),
        };
        let mut registry = Registry::with_prefix("ncp_gateway");
        registry.register("requests", "Requests that came", counters.requests.clone());
        let help = "Time from a request's arrival to its reply";
        registry.register_with_unit("request_duration", help, Unit::Seconds, counters.seconds.clone());
        registry.register("error_frames", "Error frames, by what went wrong", counters.failures.clone());
        registry.register("dropped_clients", "Connections that the gateway ended", counters.dropped.clone());
        let help = "Replies that a client was not there to take";
        registry.register("undelivered_replies", help, counters.undelivered.clone());
        let help = "What went over the line bridge";
        registry.register_with_unit("bridge", help, Unit::Bytes, counters.bytes.clone());
        let help = "Connections to the simulation service that were made";
        registry.register("connections", help, counters.connections.clone());
        let help = "Those of them that took the place of one that was lost";
        registry.register("reconnects", help, counters.reconnects.clone());
        registry.register("in_flight", "Requests that wait for their reply", counters.in_flight.clone());
        counters.registry = registry;
        Self(Arc::new(counters))
    }
}

impl Metrics {
    /// All of it in the text format of OpenMetrics, which Prometheus reads.
    #[must_use]
    pub fn text(&self) -> String {
        let mut text = String::new();
        // A string takes whatever is written into it.
        let _ = text::encode(&mut text, &self.0.registry);
        text
    }

    pub(crate) fn came(&self, front: Front) {
        self.0.requests.get_or_create(&OfFront { front }).inc();
        self.0.in_flight.inc();
    }

    pub(crate) fn answered(&self, front: Front, took: Duration) {
        self.0.seconds.get_or_create(&OfFront { front }).observe(took.as_secs_f64());
        self.0.in_flight.dec();
    }

    pub(crate) fn failed(&self, cause: &'static str) {
        self.0.failures.get_or_create(&OfCause { cause }).inc();
    }

    pub(crate) fn dropped(&self, reason: &'static str) {
        self.0.dropped.get_or_create(&OfReason { reason }).inc();
    }

    pub(crate) fn undelivered(&self, front: Front) {
        self.0.undelivered.get_or_create(&OfFront { front }).inc();
    }

    pub(crate) fn sent(&self, bytes: usize) {
        self.bytes("to_service", bytes);
    }

    pub(crate) fn received(&self, bytes: usize) {
        self.bytes("from_service", bytes);
    }

    pub(crate) fn connected(&self) {
        self.0.connections.inc();
    }

    pub(crate) fn reconnected(&self) {
        self.0.reconnects.inc();
    }

    fn bytes(&self, direction: &'static str, bytes: usize) {
        let counter = self.0.bytes.get_or_create(&OfDirection { direction }).clone();
        counter.inc_by(u64::try_from(bytes).unwrap_or(u64::MAX));
    }
}
