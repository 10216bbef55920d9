//! The session service over WebSocket: a request a message, a reply a message, in the order of the requests.

use std::future::ready;
use std::net::{IpAddr, SocketAddr};
use std::pin::Pin;
use std::sync::Arc;
use std::time::Duration;

use futures_util::stream::{SplitSink, SplitStream};
use futures_util::{SinkExt, StreamExt};
use ncp_spec::wire::MAX_FRAME_BYTES;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{Semaphore, mpsc};
use tokio::time::{sleep, timeout};
use tokio_tungstenite::tungstenite::error::CapacityError;
use tokio_tungstenite::tungstenite::handshake::server::{ErrorResponse, Request, Response};
use tokio_tungstenite::tungstenite::http::{StatusCode, Uri, header};
use tokio_tungstenite::tungstenite::protocol::frame::coding::CloseCode;
use tokio_tungstenite::tungstenite::protocol::{CloseFrame, WebSocketConfig};
use tokio_tungstenite::tungstenite::{self, Message, Utf8Bytes};
use tokio_tungstenite::{WebSocketStream, accept_hdr_async_with_config};
use tokio_util::sync::CancellationToken;
use tokio_util::task::TaskTracker;

use crate::backend::Backend;
use crate::failure::{Answer, Failure, Refusal, frame};
use crate::metrics::{Front, Metrics};

/// Connections at most; one beyond is dropped.
const MAX_CLIENTS: usize = 256;

/// Requests of a connection without a reply at most; while there are as many, no more are read.
const MAX_QUEUED: usize = 32;

/// The longest message that is read. One between the limit of a request and this one costs its sender an error frame, a
/// longer one the connection as well.
const MAX_MESSAGE_BYTES: usize = 2 * MAX_FRAME_BYTES;

/// How long a client may take to open its WebSocket.
const HANDSHAKE: Duration = Duration::from_secs(5);

/// How long a client may take to close its side.
const FAREWELL: Duration = Duration::from_secs(1);

/// What a WebSocket front end needs.
#[derive(Clone)]
pub(crate) struct WebSockets {
    pub(crate) backend: Backend,
    pub(crate) metrics: Metrics,
    /// Pages that may connect besides those of this host.
    pub(crate) origins: Arc<[String]>,
    /// How long a client may take to take a reply.
    pub(crate) send_timeout: Duration,
    /// Told to stop, it reads no more, and sends the replies to what it read.
    pub(crate) stop: CancellationToken,
}

type Socket = WebSocketStream<TcpStream>;

/// The answers that a connection waits for, in the order of its requests.
type Queued = Pin<Box<dyn Future<Output = Answer> + Send>>;

impl WebSockets {
    /// Serves until it is told to stop, and every connection has ended.
    pub(crate) async fn serve(self, listener: TcpListener) {
        let clients = TaskTracker::new();
        let room = Arc::new(Semaphore::new(MAX_CLIENTS));
        loop {
            let accepted = tokio::select! {
                () = self.stop.cancelled() => break,
                accepted = listener.accept() => accepted,
            };
            match (accepted, Arc::clone(&room).try_acquire_owned()) {
                (Ok((stream, address)), Ok(place)) => {
                    let serves = self.clone();
                    clients.spawn(async move {
                        serves.client(stream, address).await;
                        drop(place);
                    });
                }
                (Ok((_, address)), Err(_)) => self.drops("crowd", address),
                (Err(error), _) => {
                    // Such as no more files: it passes, or every other front end suffers, too.
                    tracing::warn!("websocket: {error}");
                    sleep(Duration::from_millis(100)).await;
                }
            }
        }
        drop(listener);
        clients.close();
        clients.wait().await;
    }

    async fn client(&self, stream: TcpStream, address: SocketAddr) {
        // A reply is one write; a client that waits for it waits for no other.
        let _ = stream.set_nodelay(true);
        let config = WebSocketConfig::default()
            .max_message_size(Some(MAX_MESSAGE_BYTES))
            .max_frame_size(Some(MAX_MESSAGE_BYTES));
        #[expect(clippy::result_large_err, reason = "the handshake's own type")]
        let admit = |request: &Request, response: Response| match self.admits(request) {
            true => Ok(response),
            false => Err(forbidden()),
        };
        let opened = timeout(HANDSHAKE, accept_hdr_async_with_config(stream, admit, Some(config))).await;
        let (sink, messages) = match opened {
            Ok(Ok(socket)) => socket.split(),
            Ok(Err(error)) => return tracing::info!(%address, "websocket: not opened: {error}"),
            Err(_) => return self.drops("handshake", address),
        };
        let (queue, queued) = mpsc::channel(MAX_QUEUED);
        let (code, mut messages) = tokio::join!(self.write(sink, queued, address), self.read(messages, queue, address));
        if code.is_some() {
            // A socket that is closed before all of it is read takes what it sent last with it.
            let left = async { while matches!(messages.next().await, Some(Ok(_))) {} };
            let _ = timeout(FAREWELL, left).await;
        }
        tracing::debug!(%address, ?code, "websocket: ended");
    }

    /// Takes requests until the client leaves, the gateway stops, or nobody writes any more; gives back what it read.
    async fn read(
        &self,
        mut messages: SplitStream<Socket>,
        queue: mpsc::Sender<Queued>,
        address: SocketAddr,
    ) -> SplitStream<Socket> {
        loop {
            // A request is read when there is room for its reply.
            let Ok(place) = queue.reserve().await else { return messages };
            let message = tokio::select! {
                () = self.stop.cancelled() => return messages,
                () = queue.closed() => return messages,
                message = messages.next() => message,
            };
            match message {
                Some(Ok(Message::Text(request))) => place.send(Box::pin(self.submit(request.as_bytes()))),
                Some(Ok(Message::Binary(request))) => place.send(Box::pin(self.submit(&request))),
                Some(Ok(Message::Ping(_) | Message::Pong(_) | Message::Frame(_))) => {}
                Some(Err(tungstenite::Error::Capacity(CapacityError::MessageTooLong { size, max_size: _ }))) => {
                    let too_long = Failure::RequestTooLong { len: size, limit: MAX_FRAME_BYTES };
                    place.send(Box::pin(ready(Err(self.backend.refuse(Front::WebSocket, too_long)))));
                    self.drops("too_long", address);
                    return messages;
                }
                Some(Err(error)) => {
                    tracing::info!(%address, "websocket: {error}");
                    return messages;
                }
                Some(Ok(Message::Close(_))) | None => return messages,
            }
        }
    }

    /// Sends the answers as they are due; with which code it closes the connection.
    async fn write(
        &self,
        mut sink: SplitSink<Socket, Message>,
        mut queued: mpsc::Receiver<Queued>,
        address: SocketAddr,
    ) -> Option<CloseCode> {
        while let Some(answer) = queued.recv().await {
            let reply = Utf8Bytes::try_from(frame(answer.await));
            let internal = || Refusal { session: None, failure: Failure::Internal };
            let reply = reply.unwrap_or_else(|_| String::from_utf8_lossy(&internal().frame()).as_ref().into());
            match timeout(self.send_timeout, sink.send(Message::Text(reply))).await {
                Ok(Ok(())) => {}
                Ok(Err(error)) => {
                    self.metrics.undelivered(Front::WebSocket);
                    tracing::info!(%address, "websocket: a reply is not taken: {error}");
                    return None;
                }
                Err(_) => {
                    self.metrics.undelivered(Front::WebSocket);
                    self.drops("slow", address);
                    return None;
                }
            }
        }
        let code = if self.stop.is_cancelled() { CloseCode::Away } else { CloseCode::Normal };
        let close = Message::Close(Some(CloseFrame { code, reason: "".into() }));
        // A client that has gone needs none.
        let _ = timeout(self.send_timeout, sink.send(close)).await;
        Some(code)
    }

    fn submit(&self, request: &[u8]) -> impl Future<Output = Answer> + Send + use<> {
        self.backend.submit(Front::WebSocket, request)
    }

    /// A connection that the gateway ends is counted, and said.
    fn drops(&self, reason: &'static str, address: SocketAddr) {
        self.metrics.dropped(reason);
        tracing::warn!(%address, reason, "websocket: a client is dropped");
    }

    /// Any page that a browser shows could reach loopback: those of other hosts are turned away.
    fn admits(&self, request: &Request) -> bool {
        let Some(origin) = request.headers().get(header::ORIGIN) else { return true };
        let is_named = |origin: &str| self.origins.iter().any(|known| known == origin);
        let is_known = origin.to_str().is_ok_and(|origin| is_of_this_host(origin) || is_named(origin));
        if !is_known {
            self.metrics.dropped("origin");
            tracing::warn!(?origin, "websocket: a page of another host is turned away");
        }
        is_known
    }
}

fn forbidden() -> ErrorResponse {
    let mut refused = ErrorResponse::new(None);
    *refused.status_mut() = StatusCode::FORBIDDEN;
    refused
}

fn is_of_this_host(origin: &str) -> bool {
    let uri: Option<Uri> = origin.parse().ok();
    let host = uri.as_ref().and_then(Uri::host).unwrap_or_default();
    let host = host.trim_start_matches('[').trim_end_matches(']');
    host == "localhost" || host.parse::<IpAddr>().is_ok_and(|ip| ip.is_loopback())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_pages_of_loopback_are_of_this_host() {
        for origin in ["http://localhost:5173", "http://127.0.0.1", "https://[::1]:8443"] {
            assert!(is_of_this_host(origin), "{origin}");
        }
        for origin in ["null", "", "https://evil.example", "http://localhost.evil.example", "http://10.0.0.1"] {
            assert!(!is_of_this_host(origin), "{origin}");
        }
    }
}
