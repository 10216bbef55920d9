//! Quality of service in Zenoh's own types: what a publisher asks for, and what a receiver sees.

use std::fmt;

use ncp_spec::plane;
use zenoh::qos::{CongestionControl, Priority};
use zenoh::query::Query;
use zenoh::sample::Sample;

/// Quality of service as it travels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SeenQos {
    /// What happens to a frame that meets a full queue.
    pub congestion: CongestionControl,
    /// Which traffic goes first.
    pub priority: Priority,
    /// Whether a frame is sent at once, without batching.
    pub express: bool,
}

impl From<plane::Qos> for SeenQos {
    /// `[NCP-PLANE-001] [NCP-PLANE-002] [NCP-PLANE-003] [NCP-PLANE-004] [NCP-TRANS-002]`
    fn from(plane::Qos { congestion, priority, express }: plane::Qos) -> Self {
        let congestion = match congestion {
            plane::Congestion::Block => CongestionControl::Block,
            plane::Congestion::Drop => CongestionControl::Drop,
        };
        let priority = match priority {
            plane::Priority::Data => Priority::Data,
            plane::Priority::DataHigh => Priority::DataHigh,
            plane::Priority::RealTime => Priority::RealTime,
        };
        Self { congestion, priority, express }
    }
}

impl From<&Sample> for SeenQos {
    fn from(sample: &Sample) -> Self {
        Self { congestion: sample.congestion_control(), priority: sample.priority(), express: sample.express() }
    }
}

impl From<&Query> for SeenQos {
    fn from(query: &Query) -> Self {
        Self { congestion: query.congestion_control(), priority: query.priority(), express: query.express() }
    }
}

impl fmt::Display for SeenQos {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { congestion, priority, express } = self;
        write!(f, "{congestion:?}, {priority:?}, {}express", if *express { "" } else { "not " })
    }
}
