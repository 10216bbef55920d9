//! Publishers, each declared once for its stream, so that frames leave in the order in which they are sent.

use std::sync::atomic::{AtomicU64, Ordering};

use ncp_spec::plane::{Plane, Qos};
use ncp_spec::wire::{
    BulkObservation, CommandFrame, ControlStatus, EncodeError, Frame, LinkStatus, ObservationFrame, SensorFrame,
};
use zenoh::Wait;
use zenoh::bytes::ZBytes;
use zenoh::key_expr::KeyExpr;
use zenoh::pubsub::Publisher;

use crate::bus::{Bus, BusError};
use crate::qos::SeenQos;

/// What a publisher has done.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct PublishCounts {
    /// Frames that Zenoh took.
    pub sent: u64,
    /// Frames that could not be written, or that Zenoh refused. `[NCP-TRANS-011]`
    pub failed: u64,
}

/// Publishes on one key. The planes have publishers of their own; this one is for whatever else is to travel, and for
/// showing what a wrong publication looks like.
pub struct StreamPublisher {
    publisher: Publisher<'static>,
    sent: AtomicU64,
    failed: AtomicU64,
}

impl StreamPublisher {
    /// Declares a publisher on a key.
    ///
    /// # Errors
    /// The key is none, or Zenoh refuses.
    pub fn declare(bus: &Bus, key: String, qos: impl Into<SeenQos>) -> Result<Self, BusError> {
        let SeenQos { congestion, priority, express } = qos.into();
        let publisher = bus.session().declare_publisher(KeyExpr::try_from(key)?);
        let publisher = publisher.congestion_control(congestion).priority(priority).express(express).wait()?;
        Ok(Self { publisher, sent: AtomicU64::new(0), failed: AtomicU64::new(0) })
    }

    /// Publishes bytes as they are, and moves them. `[NCP-TRANS-001]` Calls from one thread leave in their order.
    /// `[NCP-CTRL-020]`
    ///
    /// # Errors
    /// Zenoh refuses. It is counted.
    pub fn send_bytes(&self, frame: impl Into<ZBytes>) -> Result<(), BusError> {
        self.counted(self.publisher.put(frame).wait().map_err(BusError::Zenoh))
    }

    /// Publishes a frame.
    ///
    /// # Errors
    /// The frame cannot be written, or Zenoh refuses. Either is counted.
    pub fn send(&self, frame: &impl Frame) -> Result<(), BusError> {
        match frame.encode() {
            Ok(text) => self.send_bytes(text),
            Err(error) => self.counted(Err(EncodeError::into(error))),
        }
    }

    /// What it has done so far. `[NCP-TRANS-011]`
    #[must_use]
    pub fn counts(&self) -> PublishCounts {
        PublishCounts { sent: self.sent.load(Ordering::Relaxed), failed: self.failed.load(Ordering::Relaxed) }
    }

    /// Whether anybody subscribes to what it publishes.
    ///
    /// # Errors
    /// Zenoh cannot say.
    pub fn has_reader(&self) -> Result<bool, BusError> {
        Ok(self.publisher.matching_status().wait()?.matching())
    }

    fn counted(&self, result: Result<(), BusError>) -> Result<(), BusError> {
        let counter = if result.is_ok() { &self.sent } else { &self.failed };
        counter.fetch_add(1, Ordering::Relaxed);
        result
    }
}

/// Declares the publisher of one plane, and what it may send: the types keep a block off the loop. `[NCP-OBS-010]`
macro_rules! plane_publisher {
    ($(#[$meta:meta])* $publisher:ident on $plane:ident by $key:ident($($argument:ident: $type:ty),*) {
        $($(#[$of_method:meta])* $method:ident: $frame:ty,)*
    }) => {
        $(#[$meta])*
        pub struct $publisher(StreamPublisher);

        impl $publisher {
            /// Declares it, with the quality of service of its plane. `[NCP-TRANS-002]`
            ///
            /// # Errors
            /// A segment of the key is none, or Zenoh refuses.
            pub fn declare(bus: &Bus, $($argument: $type),*) -> Result<Self, BusError> {
                const QOS: Qos = Plane::$plane.qos();
                Ok(Self(StreamPublisher::declare(bus, bus.keys().$key($($argument),*)?, QOS)?))
            }

            $($(#[$of_method])*
            ///
            /// # Errors
            /// As [`StreamPublisher::send`].
            pub fn $method(&self, frame: &$frame) -> Result<(), BusError> {
                self.0.send(frame)
            })*

            /// The publisher of bytes below it.
            #[must_use]
            pub const fn stream(&self) -> &StreamPublisher {
                &self.0
            }
        }
    };
}

plane_publisher! {
    /// What a body senses, one stream.
    SensorPublisher on Perception by sensor(session: &str, name: Option<&str>) {
        /// Publishes a sensor frame.
        send: SensorFrame,
    }
}

plane_publisher! {
    /// What a body is to do, one stream.
    CommandPublisher on Action by command(session: &str, name: Option<&str>) {
        /// Publishes a command, after those that were sent before. `[NCP-CTRL-020]`
        send: CommandFrame,
    }
}

plane_publisher! {
    /// What a simulation records, and how a loop and its link are doing.
    ObservationPublisher on Observation by observation(session: &str) {
        /// Publishes an observation.
        send: ObservationFrame,
        /// Publishes one port's samples as a block. `[NCP-OBS-011]`
        send_bulk: BulkObservation,
        /// Publishes how the loop is doing.
        send_status: ControlStatus,
        /// Publishes how a stream arrives.
        send_link: LinkStatus,
    }
}
