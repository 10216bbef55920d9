//! The four planes and their quality of service (chapter 3.1).

use std::fmt;

/// A kind of traffic; each has a key of its own, which [`Keys`](crate::keys::Keys) builds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Plane {
    /// Requests and replies: `{realm}/rpc`.
    Control,
    /// What the body senses: `{realm}/session/{id}/sensor[/{name}]`.
    Perception,
    /// What the body is to do: `{realm}/session/{id}/command[/{name}]`.
    Action,
    /// What the simulation records: `{realm}/session/{id}/observation`.
    Observation,
}

impl Plane {
    /// All planes.
    pub const ALL: [Self; 4] = [Self::Control, Self::Perception, Self::Action, Self::Observation];

    /// The plane's name, in lower case.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Control => "control",
            Self::Perception => "perception",
            Self::Action => "action",
            Self::Observation => "observation",
        }
    }

    /// The plane of that name.
    #[must_use]
    pub fn parse(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|plane| plane.as_str() == name)
    }

    /// The quality of service with which the plane's frames are published.
    #[must_use]
    pub const fn qos(self) -> Qos {
        match self {
            // [NCP-PLANE-001] [NCP-PLANE-004]
            Self::Control | Self::Observation => {
                Qos { congestion: Congestion::Block, priority: Priority::Data, express: false }
            }
            // [NCP-PLANE-002]
            Self::Perception => Qos { congestion: Congestion::Drop, priority: Priority::DataHigh, express: false },
            // [NCP-PLANE-003]
            Self::Action => Qos { congestion: Congestion::Drop, priority: Priority::RealTime, express: true },
        }
    }
}

impl fmt::Display for Plane {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

/// Quality of service, in Zenoh's terms.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Qos {
    /// What happens to a frame that meets a full queue.
    pub congestion: Congestion,
    /// Which traffic goes first.
    pub priority: Priority,
    /// Whether a frame is sent at once, without batching.
    pub express: bool,
}

/// What happens to a frame that meets a full queue.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Congestion {
    /// The publisher waits.
    Block,
    /// The frame is lost: a newer one is worth more.
    Drop,
}

impl Congestion {
    /// `block` or `drop`.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Block => "block",
            Self::Drop => "drop",
        }
    }
}

/// Which traffic goes first; Zenoh's names, the most urgent last.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Priority {
    /// Zenoh's default.
    Data,
    /// Above the default.
    DataHigh,
    /// The highest that an application may use.
    RealTime,
}

impl Priority {
    /// `Data`, `DataHigh` or `RealTime`.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Data => "Data",
            Self::DataHigh => "DataHigh",
            Self::RealTime => "RealTime",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_planes_are_served_as_the_table_of_the_text_says() {
        let here = Plane::ALL.map(|plane| {
            let Qos { congestion, priority, express } = plane.qos();
            (plane.as_str(), congestion.as_str(), priority.as_str(), express)
        });
        let text = ncp_text::planes().iter();
        let text = text.map(|plane| (&*plane.name, &*plane.congestion, &*plane.priority, plane.express));
        assert_eq!(here.to_vec(), text.collect::<Vec<_>>());
    }

    #[test]
    fn a_plane_is_found_by_its_name() {
        for plane in Plane::ALL {
            assert_eq!(Plane::parse(plane.as_str()), Some(plane));
        }
        assert_eq!(Plane::parse("Action"), None);
    }
}
