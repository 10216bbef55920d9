//! Clients over gRPC.

use ncp_gateway::neuro_sim::neuro_sim_client::NeuroSimClient;
use ncp_proto::convert::Convert;
use ncp_proto::v0;
use ncp_spec::wire::{CloseSession, NetworkRef, OpenSession, RunRequest, StepRequest};
use tokio::runtime::Runtime;
use tonic::Code;
use tonic::transport::{Channel, Endpoint};

use crate::program::Program;
use crate::service::{self, Does};
use crate::{json, observation};

fn runtime() -> Runtime {
    tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap()
}

async fn connect(program: &Program) -> NeuroSimClient<Channel> {
    let endpoint = Endpoint::from_shared(format!("http://{}", program.address("grpc"))).unwrap();
    NeuroSimClient::new(endpoint.connect().await.unwrap()).max_decoding_message_size(64 << 20)
}

fn open(session: &str) -> v0::OpenSession {
    let network = NetworkRef { reference: "ncp.reference.rate".into(), ..NetworkRef::default() };
    OpenSession { session_id: session.to_owned().into(), network, ..OpenSession::default() }.to_proto().0
}

fn step(session: &str, advance_ms: f64) -> v0::StepRequest {
    let session_id = session.to_owned().into();
    StepRequest { session_id, advance_ms: Some(advance_ms), ..StepRequest::default() }.to_proto().0
}

#[test]
fn a_session_is_opened_stepped_run_and_closed() {
    let service = service::reference();
    let program = Program::start(service.address(), &[]);
    runtime().block_on(async {
        let mut client = connect(&program).await;
        let opened = client.open(open("s")).await.unwrap().into_inner();
        assert!(opened.ok && opened.session_id == "s", "{opened:?}");
        assert_eq!(client.step(step("s", 2.5)).await.unwrap().into_inner().sim_time_ms, 2.5);
        let run = RunRequest { session_id: "s".into(), duration_ms: 7.5, ..RunRequest::default() }.to_proto().0;
        let frame = client.run(run).await.unwrap().into_inner();
        assert_eq!((frame.sim_time_ms, frame.seq), (10.0, 2));
        assert!(frame.is_simulation_output && !frame.calibrated_posterior);
        let close = CloseSession { session_id: "s".into(), ..CloseSession::default() }.to_proto().0;
        assert!(client.close(close).await.unwrap().into_inner().ok);
    });
    assert_eq!(program.counted("ncp_gateway_requests_total{front=\"Grpc\"}"), 4.0);
}

#[test]
fn what_goes_wrong_is_a_status() {
    let service = service::start(|line| match json(line.as_bytes())["session_id"].as_str().unwrap() {
        "cut" => Does::Cut("{".to_owned()),
        "junk" => Does::Reply("junk".to_owned()),
        "silent" => Does::Nothing,
        "error" => Does::Reply(r#"{"kind":"error","error":"no such session"}"#.to_owned()),
        id => Does::Reply(observation(id, 1)),
    });
    let program = Program::start(service.address(), &[("NCP_BRIDGE_TIMEOUT_MS", "1000")]);
    runtime().block_on(async {
        let mut client = connect(&program).await;
        for (session, code) in [
            ("cut", Code::Unavailable),
            ("junk", Code::DataLoss),
            ("silent", Code::DeadlineExceeded),
            ("error", Code::FailedPrecondition),
            ("not a segment/", Code::InvalidArgument),
        ] {
            let status = client.step(step(session, 1.0)).await.unwrap_err();
            assert_eq!(status.code(), code, "{session}: {status}");
        }
        // A request without its version and kind is no frame.
        let status = client.step(v0::StepRequest::default()).await.unwrap_err();
        assert_eq!(status.code(), Code::InvalidArgument, "{status}");
        let control = client.control(tokio_stream::empty()).await.unwrap_err();
        assert_eq!(control.code(), Code::Unimplemented);
        assert_eq!(client.step(step("fine", 1.0)).await.unwrap().into_inner().session_id, "fine");
    });
    service::die(service);
    runtime().block_on(async {
        let status = connect(&program).await.step(step("s", 1.0)).await.unwrap_err();
        assert_eq!(status.code(), Code::Unavailable, "{status}");
    });
}

#[test]
fn an_observer_gets_a_frame_a_step_until_it_leaves_or_the_session_ends() {
    let service = service::reference();
    let program = Program::start(service.address(), &[]);
    runtime().block_on(async {
        let mut client = connect(&program).await;
        client.open(open("s")).await.unwrap();
        let mut frames = client.observe(step("s", 1.0)).await.unwrap().into_inner();
        for seq in 1..=5 {
            let frame = frames.message().await.unwrap().unwrap();
            assert_eq!((frame.seq, frame.sim_time_ms), (seq, seq as f64));
        }
        let close = CloseSession { session_id: "s".into(), ..CloseSession::default() }.to_proto().0;
        client.close(close).await.unwrap();
        let ended = loop {
            match frames.message().await {
                Ok(Some(_)) => {}
                Ok(None) => panic!("it ends with what ended it"),
                Err(status) => break status,
            }
        };
        assert_eq!(ended.code(), Code::FailedPrecondition, "{ended}");

        client.open(open("t")).await.unwrap();
        let mut frames = client.observe(step("t", 1.0)).await.unwrap().into_inner();
        frames.message().await.unwrap().unwrap();
        drop(frames);
    });
    let mut stepped = service.lines().len();
    crate::until("nobody steps for one who left", || {
        std::thread::sleep(std::time::Duration::from_millis(300));
        std::mem::replace(&mut stepped, service.lines().len()) == service.lines().len()
    });
}

#[test]
fn what_protobuf_cannot_carry_of_a_reply_is_named_beside_it() {
    let reply = r#"{"kind":"observation_frame","session_id":"s","sim_time_ms":-0.0}"#;
    let service = service::start(move |_| Does::Reply(reply.to_owned()));
    let program = Program::start(service.address(), &[]);
    runtime().block_on(async {
        let reply = connect(&program).await.step(step("s", 1.0)).await.unwrap();
        assert_eq!(reply.metadata().get("ncp-lost-fields").unwrap(), "sim_time_ms");
    });
}
