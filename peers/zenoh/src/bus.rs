//! A Zenoh session, and the keys of the realm in which it is used.

use std::time::Duration;

use ncp_spec::keys::{KeyError, Keys};
use ncp_spec::reply::ReplyError;
use ncp_spec::wire::EncodeError;
use thiserror::Error;
use zenoh::{Config, Session, Wait};

/// How a session reaches others; an endpoint is Zenoh's, such as `tcp/127.0.0.1:7447`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Link {
    /// Routes between the sessions that connect to it. Listens on loopback only.
    Router(String),
    /// Waits for a peer. Listens on loopback only.
    Listen(String),
    /// Connects to a router or a peer.
    Connect(String),
}

/// Why something could not be done on the bus.
#[derive(Debug, Error)]
pub enum BusError {
    /// A realm, an id or a name is not a key segment.
    #[error(transparent)]
    Key(#[from] KeyError),
    /// A frame cannot be written.
    #[error(transparent)]
    Encode(#[from] EncodeError),
    /// A reply is not accepted.
    #[error(transparent)]
    Reply(#[from] ReplyError),
    /// Zenoh refused.
    #[error("Zenoh: {0}")]
    Zenoh(#[from] zenoh::Error),
    /// A session without a configuration of its own would listen beyond this host.
    #[error("{0} is not on loopback")]
    NotLoopback(String),
    /// A request has more bytes than a server reads.
    #[error("the request has {len} bytes, more than {limit}")]
    TooLong {
        /// What it has.
        len: usize,
        /// What it may have.
        limit: usize,
    },
    /// Nobody answered in time.
    #[error("no reply within {0:?}")]
    NoReply(Duration),
    /// The reply is Zenoh's error reply, so the call failed; it is no frame.
    #[error("the call failed: {0}")]
    Failed(String),
}

/// A Zenoh session in a realm. It closes the session when it is dropped, if it opened it.
pub struct Bus {
    session: Session,
    keys: Keys,
    is_owned: bool,
}

impl Bus {
    /// Opens a session of its own, without scouting; none for the realm is the default one.
    ///
    /// # Errors
    /// The realm is not one, a listener is not on loopback, or Zenoh cannot open the session.
    pub fn open(link: &Link, realm: Option<&str>) -> Result<Self, BusError> {
        Self::with_config(link.config()?, realm)
    }

    /// Opens a session of its own by a configuration of Zenoh's, which may listen anywhere.
    ///
    /// # Errors
    /// The realm is not one, or Zenoh cannot open the session.
    pub fn with_config(config: Config, realm: Option<&str>) -> Result<Self, BusError> {
        let keys = Keys::new(realm)?;
        Ok(Self { session: zenoh::open(config).wait()?, keys, is_owned: true })
    }

    /// Uses a session of somebody else, who closes it.
    ///
    /// # Errors
    /// The realm is not one.
    pub fn borrowed(session: &Session, realm: Option<&str>) -> Result<Self, BusError> {
        Ok(Self { session: session.clone(), keys: Keys::new(realm)?, is_owned: false })
    }

    /// The keys of the realm.
    #[must_use]
    pub const fn keys(&self) -> &Keys {
        &self.keys
    }

    /// The Zenoh session.
    #[must_use]
    pub const fn session(&self) -> &Session {
        &self.session
    }
}

impl Drop for Bus {
    fn drop(&mut self) {
        if self.is_owned {
            // Nobody is left who could be told, and the session is gone either way.
            let _ = self.session.close().wait();
        }
    }
}

impl Link {
    /// Zenoh's configuration of such a link.
    ///
    /// # Errors
    /// A listener is not on loopback.
    pub fn config(&self) -> Result<Config, BusError> {
        let (mode, side, endpoint) = match self {
            Self::Router(endpoint) => ("router", "listen", endpoint),
            Self::Listen(endpoint) => ("peer", "listen", endpoint),
            Self::Connect(endpoint) => ("client", "connect", endpoint),
        };
        if side == "listen" && !is_loopback(endpoint) {
            return Err(BusError::NotLoopback(endpoint.clone()));
        }
        let mut config = Config::default();
        config.insert_json5("mode", &quoted(mode))?;
        // A peer listens by default, everywhere.
        config.insert_json5("listen/endpoints", "[]")?;
        config.insert_json5(&format!("{side}/endpoints"), &format!("[{}]", quoted(endpoint)))?;
        config.insert_json5("scouting/multicast/enabled", "false")?;
        config.insert_json5("scouting/gossip/enabled", "false")?;
        Ok(config)
    }
}

fn is_loopback(endpoint: &str) -> bool {
    let address = endpoint.split_once('/').map_or("", |(_, address)| address);
    let host = address.rsplit_once(':').map_or("", |(host, _)| host);
    let host = host.trim_start_matches('[').trim_end_matches(']');
    host == "localhost" || host.parse::<std::net::IpAddr>().is_ok_and(|ip| ip.is_loopback())
}

fn quoted(text: &str) -> String {
    format!("{text:?}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_loopback_is_listened_on_without_a_configuration_of_ones_own() {
        for endpoint in ["tcp/0.0.0.0:7447", "tcp/[::]:7447", "tcp/192.168.1.4:7447", "tcp/example.org:1", "tcp", ""] {
            let refused = Link::Router(endpoint.to_owned()).config();
            assert!(matches!(refused, Err(BusError::NotLoopback(_))), "{endpoint}");
        }
        for endpoint in ["tcp/127.0.0.1:7447", "tls/localhost:7447", "tcp/[::1]:7447"] {
            assert!(Link::Listen(endpoint.to_owned()).config().is_ok(), "{endpoint}");
        }
        assert!(Link::Connect("tcp/192.168.1.4:7447".to_owned()).config().is_ok());
    }
}
