//! NCP over Zenoh: the four planes, each with the quality of service of the text, and control RPC.
//!
//! A frame travels as opaque bytes on the key of its plane, so that a plain Zenoh program of any language that declares
//! the same keys is a peer. Every handle undeclares what it declared when it is dropped. `[NCP-TRANS-008]`
//! Nothing here has a thread of its own but the [`ControlServer`], which has one a session with requests in flight.
//!
//! | module | what it holds |
//! |---|---|
//! | [`bus`] | a Zenoh session, owned or borrowed, and the realm's keys |
//! | [`qos`] | quality of service in Zenoh's own types |
//! | [`publish`] | publishers, declared once a stream |
//! | [`intake`] | bounded subscriptions that keep the newest, and the commands of a plant |
//! | [`control`] | RPC: the server side by side for sessions, the client with a time-out |
//! | [`host`] | the session services behind a server, one a session |

#![forbid(unsafe_code)]

pub mod bus;
pub mod control;
pub mod host;
pub mod intake;
pub mod publish;
pub mod qos;

pub use bus::{Bus, BusError, Link};
pub use control::{ControlClient, ControlServer};
pub use host::SessionHost;
pub use intake::{Arrival, Commands, Intake, Perception};
pub use publish::{CommandPublisher, ObservationPublisher, SensorPublisher, StreamPublisher};
pub use qos::SeenQos;
