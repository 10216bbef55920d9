//! The roads to a session service: Zenoh, a WebSocket, gRPC, or the line of a bridge.

use std::io::{self, BufRead as _, BufReader, Write as _};
use std::net::{SocketAddr, TcpStream};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use ncp_gateway::neuro_sim::neuro_sim_client::NeuroSimClient;
use ncp_proto::convert::Convert;
use ncp_spec::plane::Plane;
use ncp_spec::reply::{ReplyError, check_reply};
use ncp_spec::wire::{ErrorFrame, Frame as _, Message, ObservationFrame, SessionClosed, SessionOpened, decode_any};
use ncp_zenoh::{Bus, BusError, ControlClient, SeenQos};
use thiserror::Error;
use tokio::runtime::Runtime;
use tonic::transport::{Channel, Endpoint};
use tonic::{Code, Response, Status};
use tungstenite::WebSocket;
use zenoh::Wait;

use crate::target::Target;

/// A road to a session service.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) enum Road {
    /// The control plane of the target's realm.
    #[default]
    Zenoh,
    /// A message a request, and one a reply.
    WebSocket(SocketAddr),
    /// The service `NeuroSim`: an error frame is a status.
    Grpc(SocketAddr),
    /// A line a request, and one a reply.
    Lines(SocketAddr),
}

/// Why there is no reply.
#[derive(Debug, Error)]
pub(crate) enum AskError {
    /// Nobody answered in time.
    #[error("no reply within {0:?}")]
    NoReply(Duration),
    /// What came is no frame, or the connection ended.
    #[error("{0}")]
    Failed(String),
    /// The road has no form for it, such as gRPC for text that is no request.
    #[error("this road carries no such request")]
    Unsayable,
    /// The reply is not accepted.
    #[error(transparent)]
    Reply(#[from] ReplyError),
    /// The request cannot be written, or the network refuses.
    #[error(transparent)]
    Bus(BusError),
}

/// Who asks on a road, over a connection of its own.
pub(super) struct Asker {
    /// How long it waits for a reply.
    longest: Duration,
    way: Way,
}

enum Way {
    Zenoh(ControlClient, Bus),
    WebSocket(Mutex<WebSocket<TcpStream>>),
    Grpc(Runtime, NeuroSimClient<Channel>),
    Lines(Mutex<BufReader<TcpStream>>),
}

impl Asker {
    /// Connects to the target on its road.
    ///
    /// # Errors
    /// Nobody listens there.
    pub(super) fn connect(target: &Target, longest: Duration) -> Result<Self, AskError> {
        let tcp = |address: SocketAddr| -> io::Result<TcpStream> {
            let stream = TcpStream::connect(address)?;
            stream.set_read_timeout(Some(longest))?;
            stream.set_nodelay(true)?;
            Ok(stream)
        };
        let way = match target.road {
            Road::Zenoh => {
                let bus = target.bus()?;
                Way::Zenoh(ControlClient::new(&bus, longest)?, bus)
            }
            Road::WebSocket(address) => {
                let opened = tungstenite::client(format!("ws://{address}/"), tcp(address)?);
                let (socket, _) = opened.map_err(|error| AskError::Failed(format!("no WebSocket: {error}")))?;
                Way::WebSocket(Mutex::new(socket))
            }
            Road::Grpc(address) => {
                let runtime = tokio::runtime::Builder::new_multi_thread().worker_threads(1).enable_all().build()?;
                let failed = |error: tonic::transport::Error| AskError::Failed(format!("no gRPC: {error}"));
                let endpoint = Endpoint::from_shared(format!("http://{address}")).map_err(failed)?.timeout(longest);
                let channel = runtime.block_on(endpoint.connect()).map_err(failed)?;
                Way::Grpc(runtime, NeuroSimClient::new(channel).max_decoding_message_size(usize::MAX))
            }
            Road::Lines(address) => Way::Lines(Mutex::new(BufReader::new(tcp(address)?))),
        };
        Ok(Self { longest, way })
    }

    /// The bus, if the road is Zenoh.
    pub(super) fn bus(&self) -> Option<&Bus> {
        match &self.way {
            Way::Zenoh(_, bus) => Some(bus),
            _ => None,
        }
    }

    /// Sends a request, and gives the reply if it is one to it.
    ///
    /// # Errors
    /// There is no reply, or it is not accepted [NCP-SESS-006].
    pub(super) fn ask(&self, request: &Message) -> Result<Message, AskError> {
        let reply = self.ask_bytes(request.encode().map_err(BusError::from)?.as_bytes())?;
        Ok(check_reply(request, &reply)?)
    }

    /// Sends bytes, and gives those of the reply.
    ///
    /// # Errors
    /// There is no reply, or the road has no form for such bytes.
    pub(super) fn ask_bytes(&self, request: &[u8]) -> Result<Vec<u8>, AskError> {
        match &self.way {
            Way::Zenoh(client, _) => Ok(client.ask_bytes(request)?),
            Way::WebSocket(socket) => {
                let socket = &mut *lock(socket);
                send(socket, request)?;
                self.received(receive(socket))
            }
            Way::Grpc(runtime, client) => runtime.block_on(call(client.clone(), request, self.longest)),
            Way::Lines(stream) => {
                let stream = &mut *lock(stream);
                write(stream, request)?;
                self.received(read(stream))
            }
        }
    }

    /// Sends requests without waiting for their replies, and gives these in the order of the requests; what has none
    /// has an empty one.
    ///
    /// # Errors
    /// The requests cannot be sent, or the road keeps no order among them.
    pub(super) fn ask_in_a_row(&self, requests: &[String]) -> Result<Vec<Vec<u8>>, AskError> {
        let replies = match &self.way {
            Way::Zenoh(_, bus) => {
                let key = bus.keys().rpc().map_err(BusError::from)?;
                let qos = SeenQos::from(Plane::Control.qos());
                let mut replies = Vec::new();
                for request in requests {
                    let query = bus.session().get(&key).payload(request.as_str()).timeout(self.longest);
                    let query = query.congestion_control(qos.congestion).priority(qos.priority).express(qos.express);
                    replies.push(query.wait().map_err(BusError::from)?);
                }
                let replies = replies.into_iter().map(|replies| {
                    let reply = replies.recv().ok().and_then(|reply| reply.into_result().ok());
                    reply.map(|sample| sample.payload().to_bytes().into_owned()).unwrap_or_default()
                });
                replies.collect()
            }
            Way::WebSocket(socket) => {
                let socket = &mut *lock(socket);
                requests.iter().try_for_each(|request| send(socket, request.as_bytes()))?;
                requests.iter().map(|_| receive(socket).unwrap_or_default()).collect()
            }
            Way::Lines(stream) => {
                let stream = &mut *lock(stream);
                requests.iter().try_for_each(|request| write(stream, request.as_bytes()))?;
                requests.iter().map(|_| read(stream).unwrap_or_default()).collect()
            }
            // Calls are streams of their own, which may overtake each other.
            Way::Grpc(..) => return Err(AskError::Unsayable),
        };
        Ok(replies)
    }

    fn received(&self, reply: io::Result<Vec<u8>>) -> Result<Vec<u8>, AskError> {
        reply.map_err(|error| match error.kind() {
            io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut => AskError::NoReply(self.longest),
            _ => error.into(),
        })
    }
}

impl From<BusError> for AskError {
    fn from(error: BusError) -> Self {
        match error {
            BusError::NoReply(longest) => Self::NoReply(longest),
            BusError::Failed(why) => Self::Failed(why),
            BusError::Reply(error) => Self::Reply(error),
            error => Self::Bus(error),
        }
    }
}

impl From<io::Error> for AskError {
    fn from(error: io::Error) -> Self {
        Self::Failed(error.to_string())
    }
}

fn send(socket: &mut WebSocket<TcpStream>, request: &[u8]) -> Result<(), AskError> {
    let message = match std::str::from_utf8(request) {
        Ok(text) => tungstenite::Message::text(text),
        Err(_) => tungstenite::Message::binary(request.to_vec()),
    };
    socket.send(message).map_err(|error| AskError::Failed(error.to_string()))
}

fn receive(socket: &mut WebSocket<TcpStream>) -> io::Result<Vec<u8>> {
    loop {
        match socket.read() {
            Ok(tungstenite::Message::Text(reply)) => return Ok(reply.as_bytes().to_vec()),
            Ok(tungstenite::Message::Binary(reply)) => return Ok(reply.to_vec()),
            Ok(tungstenite::Message::Close(_)) => return Err(io::ErrorKind::ConnectionAborted.into()),
            Ok(_) => {}
            Err(tungstenite::Error::Io(error)) => return Err(error),
            Err(error) => return Err(io::Error::other(error)),
        }
    }
}

fn write(stream: &mut BufReader<TcpStream>, request: &[u8]) -> Result<(), AskError> {
    if request.contains(&b'\n') {
        return Err(AskError::Unsayable);
    }
    Ok(stream.get_mut().write_all(&[request, b"\n"].concat())?)
}

fn read(stream: &mut BufReader<TcpStream>) -> io::Result<Vec<u8>> {
    let mut reply = Vec::new();
    stream.read_until(b'\n', &mut reply)?;
    match reply.pop() {
        Some(b'\n') => Ok(reply),
        _ => Err(io::ErrorKind::UnexpectedEof.into()),
    }
}

/// A request as a call, and what came as the frame that it stands for.
async fn call(mut client: NeuroSimClient<Channel>, request: &[u8], longest: Duration) -> Result<Vec<u8>, AskError> {
    let reply = match decode_any(request) {
        Ok(Message::OpenSession(request)) => frame::<SessionOpened>(client.open(request.to_proto().0).await),
        Ok(Message::StepRequest(request)) => frame::<ObservationFrame>(client.step(request.to_proto().0).await),
        Ok(Message::RunRequest(request)) => frame::<ObservationFrame>(client.run(request.to_proto().0).await),
        Ok(Message::CloseSession(request)) => frame::<SessionClosed>(client.close(request.to_proto().0).await),
        _ => return Err(AskError::Unsayable),
    };
    reply.map_err(|status| match status.code() {
        Code::DeadlineExceeded | Code::Cancelled => AskError::NoReply(longest),
        _ => AskError::Failed(format!("{:?}: {}", status.code(), status.message())),
    })
}

/// The frame of a response; of a status that stands for an error frame, that.
fn frame<R: Convert>(response: Result<Response<R::Proto>, Status>) -> Result<Vec<u8>, Status> {
    let internal = |error: &dyn std::error::Error| Status::internal(error.to_string());
    match response {
        Ok(response) => {
            let reply = R::from_proto(response.into_inner()).map_err(|error| internal(&error))?;
            Ok(reply.encode().map_err(|error| internal(&error))?.into_bytes())
        }
        Err(status) if matches!(status.code(), Code::FailedPrecondition | Code::InvalidArgument) => {
            let frame = ErrorFrame { error: status.message().to_owned().into(), session_id: None };
            Ok(frame.encode().map_err(|error| internal(&error))?.into_bytes())
        }
        Err(status) => Err(status),
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
