//! The front ends, by which clients reach the [`Backend`](crate::Backend).
//!
//! | module | what it serves |
//! |---|---|
//! | [`zenoh`] | control RPC on `{realm}/rpc` |
//! | [`websocket`] | the session service over WebSocket: a frame a message |
//! | [`grpc`] | the service `NeuroSim` of the proto |
//! | [`http`] | `/healthz` and `/metrics` |

pub(crate) mod grpc;
pub(crate) mod http;
pub(crate) mod websocket;
pub(crate) mod zenoh;
