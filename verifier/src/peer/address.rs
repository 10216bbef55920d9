//! Where a peer listens that is reached over a network.

use std::fmt;
use std::net::{SocketAddr, TcpListener, ToSocketAddrs as _};

/// Stands for a port that is free when the peer's server is started.
pub(super) const ANY_PORT: &str = "{port}";

/// Where a peer listens: `tcp://HOST:PORT`, or `ws://HOST:PORT/PATH`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Address {
    pub(super) framing: Framing,
    host: String,
    /// None: one that is free when the server is started.
    port: Option<u16>,
    path: String,
}

/// How a line travels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Framing {
    /// With its line feed, on a TCP connection.
    Lines,
    /// Without its line feed, a text frame of WebSocket.
    WebSocket,
}

/// Why a text is no address of a peer.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum AddressError {
    /// It begins otherwise.
    #[error("{0:?} is no address of a peer: tcp://HOST:PORT or ws://HOST:PORT/PATH")]
    Scheme(String),
    /// It has no port.
    #[error("{0:?} lacks a host or a port, such as tcp://127.0.0.1:7000")]
    Port(String),
    /// There is something behind the port of a TCP address.
    #[error("{0:?} has a path, which only ws:// has")]
    Path(String),
}

impl Address {
    /// Reads an address.
    ///
    /// # Errors
    /// [`AddressError`] if the text is none.
    pub fn parse(text: &str) -> Result<Self, AddressError> {
        let (framing, rest) = match text.split_once("://") {
            Some(("tcp", rest)) => (Framing::Lines, rest),
            Some(("ws", rest)) => (Framing::WebSocket, rest),
            _ => return Err(AddressError::Scheme(text.to_owned())),
        };
        let (authority, path) = rest.find('/').map_or((rest, ""), |at| rest.split_at(at));
        if framing == Framing::Lines && !path.is_empty() {
            return Err(AddressError::Path(text.to_owned()));
        }
        let port_error = || AddressError::Port(text.to_owned());
        let (host, port) = authority.rsplit_once(':').filter(|(host, _)| !host.is_empty()).ok_or_else(port_error)?;
        let port = match port {
            ANY_PORT => None,
            port => Some(port.parse().ok().filter(|port| *port != 0).ok_or_else(port_error)?),
        };
        let path = if path.is_empty() { "/" } else { path };
        Ok(Self { framing, host: host.to_owned(), port, path: path.to_owned() })
    }

    /// Whether its port is chosen when the server is started.
    pub(super) fn is_open(&self) -> bool {
        self.port.is_none()
    }

    /// The same, at a port that is free now if none is fixed.
    pub(super) fn placed(&self) -> std::io::Result<Self> {
        let port = match self.port {
            Some(port) => port,
            None => TcpListener::bind((self.bare_host(), 0))?.local_addr()?.port(),
        };
        Ok(Self { port: Some(port), ..self.clone() })
    }

    /// The port, as a command names it.
    pub(super) fn port_text(&self) -> String {
        self.port.map_or_else(|| ANY_PORT.to_owned(), |port| port.to_string())
    }

    /// What the host's name stands for.
    pub(super) fn resolve(&self) -> std::io::Result<Vec<SocketAddr>> {
        Ok((self.bare_host(), self.port.unwrap_or_default()).to_socket_addrs()?.collect())
    }

    /// The host without the brackets that an IPv6 address has in a URL.
    fn bare_host(&self) -> &str {
        self.host.strip_prefix('[').and_then(|host| host.strip_suffix(']')).unwrap_or(&self.host)
    }
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (host, port) = (&self.host, self.port_text());
        match self.framing {
            Framing::Lines => write!(f, "tcp://{host}:{port}"),
            Framing::WebSocket => write!(f, "ws://{host}:{port}{}", self.path),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_address_is_read_and_written() {
        for (text, written) in [
            ("tcp://127.0.0.1:7000", "tcp://127.0.0.1:7000"),
            ("tcp://localhost:{port}", "tcp://localhost:{port}"),
            ("ws://[::1]:80", "ws://[::1]:80/"),
            ("ws://host:8080/ncp/peer?x=1", "ws://host:8080/ncp/peer?x=1"),
        ] {
            assert_eq!(Address::parse(text).unwrap().to_string(), written);
        }
        assert_eq!(Address::parse("ws://[::1]:80").unwrap().resolve().unwrap(), ["[::1]:80".parse().unwrap()]);
    }

    #[test]
    fn what_is_no_address_is_refused_with_its_reason() {
        let why = |text: &str| Address::parse(text).unwrap_err();
        for text in ["", "127.0.0.1:7000", "http://a:1", "wss://a:1"] {
            assert_eq!(why(text), AddressError::Scheme(text.to_owned()));
        }
        for text in ["tcp://a", "tcp://:1", "tcp://a:0", "tcp://a:65536", "ws://a/b:1", "tcp://a:{ports}"] {
            assert_eq!(why(text), AddressError::Port(text.to_owned()));
        }
        assert_eq!(why("tcp://a:1/b"), AddressError::Path("tcp://a:1/b".to_owned()));
    }

    #[test]
    fn an_open_port_is_filled_by_a_free_one_and_a_fixed_one_stays() {
        let placed = Address::parse("tcp://127.0.0.1:{port}").unwrap().placed().unwrap();
        let addresses = placed.resolve().unwrap();
        assert!(addresses[0].port() > 0 && TcpListener::bind(addresses[0]).is_ok());
        assert_eq!(Address::parse("tcp://a:7").unwrap().placed().unwrap().port_text(), "7");
    }
}
