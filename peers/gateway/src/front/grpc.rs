//! The service `NeuroSim` of the proto. A call is a request, and its reply in JSON is read into protobuf.

use std::fmt::Write as _;

use ncp_proto::convert::{Convert, Loss};
use ncp_proto::v0;
use ncp_spec::wire::{
    CloseSession, ErrorFrame, Frame, MAX_FRAME_BYTES, MAX_OBSERVATION_BYTES, ObservationFrame, OpenSession, RunRequest,
    SessionClosed, SessionOpened, StepRequest,
};
use tokio::net::TcpListener;
use tokio::sync::mpsc;
use tokio_stream::wrappers::{ReceiverStream, TcpListenerStream};
use tokio_util::sync::CancellationToken;
use tonic::metadata::MetadataValue;
use tonic::transport::Server;
use tonic::{Request, Response, Status, Streaming};

use crate::backend::Backend;
use crate::failure::{Failure, Refusal};
use crate::metrics::Front;
use crate::neuro_sim::neuro_sim_server::{NeuroSim, NeuroSimServer};

/// The metadata of a reply that protobuf cannot carry whole: the fields that read back otherwise.
const LOST: &str = "ncp-lost-fields";

/// Serves until it is told to stop, and every call has ended.
pub(crate) async fn serve(listener: TcpListener, backend: Backend, stop: CancellationToken) {
    let service = NeuroSimServer::new(Calls { backend, stop: stop.clone() })
        .max_decoding_message_size(MAX_FRAME_BYTES)
        .max_encoding_message_size(MAX_OBSERVATION_BYTES);
    let connections = TcpListenerStream::new(listener);
    let server = Server::builder().tcp_nodelay(true).add_service(service);
    if let Err(error) = server.serve_with_incoming_shutdown(connections, stop.cancelled_owned()).await {
        tracing::error!("grpc: {error}");
    }
}

#[derive(Clone)]
struct Calls {
    backend: Backend,
    stop: CancellationToken,
}

impl Calls {
    async fn ask<Q: Convert, R: Convert>(&self, request: Q::Proto) -> Result<Response<R::Proto>, Status> {
        let refused = |failure| status(&self.backend.refuse(Front::Grpc, failure));
        let request = Q::from_proto(request).map_err(|error| refused(error.into()))?;
        let request = request.encode().map_err(|error| refused(Failure::Unwritable(error.to_string())))?;
        let reply = self.backend.submit(Front::Grpc, request.as_bytes()).await.map_err(|refusal| status(&refusal))?;
        match R::decode(&reply) {
            Ok(reply) => Ok(response(reply.to_proto())),
            // The backend lets a reply through, or an error frame.
            Err(error) => Err(ErrorFrame::decode(&reply).map_or_else(
                |_| Status::internal(error.to_string()),
                |frame| Status::failed_precondition(frame.error.into_owned()),
            )),
        }
    }
}

#[tonic::async_trait]
impl NeuroSim for Calls {
    type ObserveStream = ReceiverStream<Result<v0::ObservationFrame, Status>>;
    type ControlStream = ReceiverStream<Result<v0::CommandFrame, Status>>;

    async fn open(&self, request: Request<v0::OpenSession>) -> Result<Response<v0::SessionOpened>, Status> {
        self.ask::<OpenSession, SessionOpened>(request.into_inner()).await
    }

    async fn step(&self, request: Request<v0::StepRequest>) -> Result<Response<v0::ObservationFrame>, Status> {
        self.ask::<StepRequest, ObservationFrame>(request.into_inner()).await
    }

    async fn run(&self, request: Request<v0::RunRequest>) -> Result<Response<v0::ObservationFrame>, Status> {
        self.ask::<RunRequest, ObservationFrame>(request.into_inner()).await
    }

    async fn close(&self, request: Request<v0::CloseSession>) -> Result<Response<v0::SessionClosed>, Status> {
        self.ask::<CloseSession, SessionClosed>(request.into_inner()).await
    }

    /// Steps the session by the same request, as fast as the client takes the frames, until either side ends.
    async fn observe(&self, request: Request<v0::StepRequest>) -> Result<Response<Self::ObserveStream>, Status> {
        let request = request.into_inner();
        let (frames, stream) = mpsc::channel(1);
        let calls = self.clone();
        tokio::spawn(async move {
            while !calls.stop.is_cancelled() {
                // The next step is made when there is room for its frame.
                let Ok(place) = frames.reserve().await else { return };
                let frame = calls.ask::<StepRequest, ObservationFrame>(request.clone()).await;
                let is_last = frame.is_err();
                place.send(frame.map(Response::into_inner));
                if is_last {
                    return;
                }
            }
        });
        Ok(Response::new(ReceiverStream::new(stream)))
    }

    /// Sensor and command frames travel on their planes; the session service carries none.
    async fn control(
        &self,
        _request: Request<Streaming<v0::SensorFrame>>,
    ) -> Result<Response<Self::ControlStream>, Status> {
        Err(Status::unimplemented("sensor and command frames travel on the perception and the action plane"))
    }
}

/// What protobuf does not carry of a reply is named beside it.
fn response<P>((reply, losses): (P, Vec<Loss>)) -> Response<P> {
    let mut response = Response::new(reply);
    let mut lost = String::new();
    for (nth, Loss { path, .. }) in losses.iter().take(16).enumerate() {
        // A string takes whatever is written into it.
        let _ = write!(lost, "{}{path}", if nth == 0 { "" } else { ", " });
    }
    // A path of a channel's name in another script is no text of a header.
    let unnamed = || MetadataValue::from_static("fields whose names are not ASCII");
    if !lost.is_empty() {
        tracing::warn!(lost, "grpc: protobuf does not carry all of a reply");
        response.metadata_mut().insert(LOST, lost.parse().unwrap_or_else(|_| unnamed()));
    }
    response
}

fn status(refusal: &Refusal) -> Status {
    let why = refusal.to_string();
    match refusal.failure {
        Failure::RequestTooLong { .. }
        | Failure::RequestRejected(_)
        | Failure::NotARequest(_)
        | Failure::Unwritable(_)
        | Failure::NoFrame(_) => Status::invalid_argument(why),
        Failure::Busy => Status::resource_exhausted(why),
        Failure::Stopping | Failure::Unreachable(_) | Failure::Cut => Status::unavailable(why),
        Failure::Expired(_) | Failure::TimedOut(_) => Status::deadline_exceeded(why),
        Failure::ReplyTooLong { .. } | Failure::ReplyRejected(_) | Failure::Misfit { .. } => Status::data_loss(why),
        Failure::Internal => Status::internal(why),
    }
}
