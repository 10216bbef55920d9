//! The session service with the reference backend, over the local bus.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::sync::{Arc, Mutex};

use ncp_spec::bus::{BusError, LocalBus, NeuroSimClient, QUEUE_FRAMES};
use ncp_spec::reply::ReplyError;
use ncp_spec::session::{BackendError, Opened, ReferenceBackend, SessionService, Simulation, SimulationBackend};
use ncp_spec::wire::{
    ChannelMap, ChannelValue, Frame, Kind, Message, NetworkRef, NetworkRefKind, Observable, Observation, OpenSession,
    RecordSpec, RecordTarget, RunRequest, SessionOpened, SortedMap, StepRequest, StimulusFrame, StimulusKind,
    StimulusSpec, StimulusTarget, Text, decode_any,
};
use proptest::prelude::*;

fn network(reference: &'static str, neurons: i64) -> NetworkRef {
    NetworkRef {
        kind: NetworkRefKind::Builtin,
        reference: reference.into(),
        population_sizes: [(Text::from("exc"), neurons)].into_iter().collect(),
        ..NetworkRef::default()
    }
}

fn record(port: &'static str, observable: Observable) -> RecordTarget {
    RecordTarget { port: port.into(), target: "exc".into(), observable, ..RecordTarget::default() }
}

fn lif_session(id: &'static str) -> OpenSession {
    OpenSession {
        session_id: id.into(),
        network: network("ncp.reference.lif", 2),
        record: RecordSpec { targets: vec![record("v", Observable::Vm), record("s", Observable::Spikes)] },
        stimulus: StimulusSpec {
            targets: vec![StimulusTarget {
                port: "i".into(),
                target: "exc".into(),
                kind: StimulusKind::CurrentPa,
                ids: vec![2],
                ..StimulusTarget::default()
            }],
        },
        ..OpenSession::default()
    }
}

fn current(id: &'static str, pa: f64) -> StimulusFrame {
    let mut values = ChannelMap::new();
    values.insert("i", ChannelValue::new([pa], "pA"));
    StimulusFrame { session_id: id.into(), values, ..StimulusFrame::default() }
}

fn bus() -> (LocalBus, ncp_spec::bus::Serving, NeuroSimClient) {
    let bus = LocalBus::new();
    let mut service = SessionService::new(ReferenceBackend);
    let serving = bus.serve("ncp/rpc", move |request| service.serve(request).into_bytes()).unwrap();
    let client = NeuroSimClient::new(bus.clone(), None).unwrap();
    (bus, serving, client)
}

/// [NCP-SESS-060]
#[test]
fn a_session_with_two_targets_of_one_port_is_not_opened() {
    let mut service = SessionService::new(ReferenceBackend);
    let mut opens = |request: &OpenSession| {
        let reply = service.serve(request.encode().unwrap().as_bytes());
        let Ok(Message::SessionOpened(opened)) = decode_any(reply.as_bytes()) else { panic!("{reply}") };
        opened.ok
    };
    let mut recorded = lif_session("a");
    recorded.record.targets.push(record("v", Observable::Spikes));
    assert!(!opens(&recorded));
    let mut driven = lif_session("a");
    driven.stimulus.targets.push(driven.stimulus.targets[0].clone());
    assert!(!opens(&driven));
    assert!(opens(&lif_session("a")));
}

/// The closed solution of the membrane equation, which the backend does not use.
/// [NCP-SESS-050] [NCP-SESS-052] [NCP-SESS-053] [NCP-SESS-054]
#[test]
fn a_neuron_under_a_constant_current_follows_the_closed_solution_until_it_spikes() {
    let (_bus, _serving, mut client) = bus();
    let opened = client.open(lif_session("a")).unwrap();
    assert_eq!(opened.resolved.get("exc"), Some(&2));
    let frame = client
        .run(RunRequest {
            session_id: "a".into(),
            duration_ms: 40.0,
            stimulus: Some(current("a", 500.0)),
            ..RunRequest::default()
        })
        .unwrap();
    assert_eq!(frame.sim_time_ms, 40.0);
    let (v, spikes) = (frame.records.get("v").unwrap(), frame.records.get("s").unwrap());
    // 500 pA · 10 ms / 250 pF = 20 mV above rest: −55 mV is crossed at 10·ln 4 ms = 13.86 ms.
    assert_eq!(spikes.times.first().map(|t| (t * 10.0).round()), Some(139.0));
    assert!(spikes.senders.iter().all(|&id| id == 2));
    assert!(spikes.values.is_empty());
    for ((&t, &value), &id) in v.times.iter().zip(&v.values).zip(&v.senders) {
        if id == 1 {
            assert_eq!(value, -70.0);
        } else if t < 13.8 {
            let exact = -70.0 + 20.0 * (1.0 - (-t / 10.0).exp());
            assert!(((value - exact) / exact).abs() < 1e-9, "{value} at {t} ms, not {exact}");
        }
    }
    // One period: the way up and 2 ms of refractoriness.
    let period = spikes.times[1] - spikes.times[0];
    assert!((period - 15.9).abs() < 0.11, "{period}");
    assert_eq!(v.times.len(), 80);
}

/// [NCP-SESS-051]
#[test]
fn a_rate_neuron_relaxes_to_its_input() {
    let (_bus, _serving, mut client) = bus();
    let mut request = lif_session("r");
    request.network = network("ncp.reference.rate", 1);
    request.network.params.insert("mu", 8.0);
    request.record.targets = vec![record("r", Observable::Rate)];
    request.stimulus.targets.clear();
    client.open(request).unwrap();
    let frame = client.run(RunRequest { session_id: "r".into(), duration_ms: 30.0, ..RunRequest::default() }).unwrap();
    let rates = frame.records.get("r").unwrap();
    assert_eq!(rates.times.len(), 30);
    for (&t, &rate) in rates.times.iter().zip(&rates.values) {
        let exact = 8.0 * (1.0 - (-t / 10.0).exp());
        assert!((rate / exact - 1.0).abs() < 1e-9);
    }
}

/// [NCP-SESS-037] [NCP-SESS-057]
#[test]
fn a_run_that_leaves_the_doubles_fails_and_the_next_goes_on_from_before_it() {
    let (_bus, _serving, mut client) = bus();
    let mut request = lif_session("o");
    request.network.params.insert("C_m", 1.0);
    client.open(request).unwrap();
    let run = |pa: f64| RunRequest {
        session_id: "o".into(),
        duration_ms: 5.0,
        stimulus: Some(current("o", pa)),
        ..RunRequest::default()
    };
    client.run(run(0.5)).unwrap();
    client.run(run(-1.7e308)).unwrap_err();
    let frame = client.run(run(0.5)).unwrap();
    assert_eq!(frame.sim_time_ms, 10.0);
    // The driven neuron approaches E_L + I·tau/C = -65 mV as if nothing had come between.
    let v = frame.records.get("v").unwrap();
    let driven = v.senders.iter().zip(&v.times).zip(&v.values);
    for ((_, t), v) in driven.filter(|((id, _), _)| **id == 2) {
        let exact = -70.0 + 5.0 * (1.0 - (-t / 10.0).exp());
        assert!((v / exact - 1.0).abs() < 1e-9, "{t} ms: {v} mV");
    }
    assert_eq!(v.times.first(), Some(&6.0));
}

/// [NCP-SESS-031] [NCP-SESS-033] [NCP-SESS-035]
#[test]
fn steps_of_any_size_make_the_same_trace_as_one_run_and_sessions_stay_apart() {
    let (_bus, _serving, mut client) = bus();
    for id in ["one", "many", "idle"] {
        client.open(lif_session(id)).unwrap();
    }
    let whole = client
        .run(RunRequest {
            session_id: "one".into(),
            duration_ms: 30.0,
            stimulus: Some(current("one", 450.0)),
            ..RunRequest::default()
        })
        .unwrap();
    let mut times = Vec::new();
    let mut values = Vec::new();
    for (step, advance_ms) in [Some(0.1), Some(3.3), None, Some(0.04), Some(0.1), Some(16.5)].into_iter().enumerate() {
        let stimulus = (step == 0).then(|| current("many", 450.0));
        let request = StepRequest { session_id: "many".into(), advance_ms, stimulus, ..StepRequest::default() };
        let frame = client.step(request).unwrap();
        assert_eq!(frame.seq, i64::try_from(step).unwrap() + 1);
        let v = frame.records.get("v").unwrap();
        times.extend_from_slice(&v.times);
        values.extend_from_slice(&v.values);
    }
    let v = whole.records.get("v").unwrap();
    assert_eq!((&v.times, &v.values), (&times, &values));
    let idle = client.step(StepRequest { session_id: "idle".into(), ..StepRequest::default() }).unwrap();
    assert_eq!(idle.sim_time_ms, 10.0);
}

/// [NCP-SESS-058] A request that comes to no step is answered all the same, and its stimulus acts from the next step.
/// [NCP-SESS-054]
#[test]
fn a_time_is_the_nearest_number_of_steps_and_a_remainder_is_forgotten() {
    let (_bus, _serving, mut client) = bus();
    client.open(lif_session("a")).unwrap();
    client.open(lif_session("b")).unwrap();
    let run = |id: &'static str, duration_ms: f64, pa: Option<f64>| {
        let stimulus = pa.map(|pa| current(id, pa));
        client.run(RunRequest { session_id: id.into(), duration_ms, stimulus, ..RunRequest::default() }).unwrap()
    };
    let none = run("a", 0.04, Some(450.0));
    assert_eq!((none.seq, none.sim_time_ms), (1, 0.0));
    assert!(none.records.iter().all(|(_, record)| record.times.is_empty()));
    // 0.15 / 0.1 is less than one and a half as a double.
    for (nth, duration_ms) in [0.14, 0.15, 0.05, 0.1].into_iter().enumerate() {
        assert_eq!(run("a", duration_ms, None).sim_time_ms, (nth + 1) as f64 * 0.1);
    }
    let before = run("b", 0.35, Some(450.0)); // 3.4999999999999996 steps
    assert_eq!(before.sim_time_ms, 3.0 * 0.1);
    run("b", 0.1, None);
    let (a, b) = (run("a", 20.0, None), run("b", 20.0, None));
    assert_eq!((a.sim_time_ms, b.sim_time_ms), (204.0 * 0.1, 204.0 * 0.1));
    assert_eq!(a.records, b.records);
}

/// [NCP-SESS-059]
#[test]
fn samples_come_by_time_and_then_as_the_port_names_its_neurons() {
    let (_bus, _serving, mut client) = bus();
    let mut request = lif_session("a");
    request.network.population_sizes.insert("exc", 3);
    request.network.params.insert("I_e", 900.0);
    let named = |port, observable| RecordTarget { ids: vec![3, 1], ..record(port, observable) };
    request.record.targets.extend([named("v31", Observable::Vm), named("s31", Observable::Spikes)]);
    client.open(request).unwrap();
    let frame = client.run(RunRequest { session_id: "a".into(), duration_ms: 20.0, ..RunRequest::default() }).unwrap();
    for (port, order) in [("v", &[1, 2, 3][..]), ("s", &[1, 2, 3]), ("v31", &[3, 1]), ("s31", &[3, 1])] {
        let record = &frame.records[port];
        assert!(record.times.is_sorted() && record.times.len() > order.len(), "{port}");
        for (times, senders) in record.times.chunks(order.len()).zip(record.senders.chunks(order.len())) {
            assert_eq!(senders, order, "{port}");
            assert!(times.iter().all(|time| *time == times[0]), "{port}");
        }
    }
}

/// [NCP-SESS-054] [NCP-SESS-055] What several ports give one neuron adds up.
#[test]
fn the_currents_of_two_ports_add_up() {
    let (_bus, _serving, mut client) = bus();
    let mut request = lif_session("a");
    let mut more = request.stimulus.targets[0].clone();
    (more.port, more.ids) = ("j".into(), Vec::new());
    request.stimulus.targets.push(more);
    client.open(request).unwrap();
    let mut stimulus = current("a", 200.0);
    stimulus.values.insert("j", ChannelValue::new([100.0], "pA"));
    let run =
        RunRequest { session_id: "a".into(), duration_ms: 10.0, stimulus: Some(stimulus), ..RunRequest::default() };
    let v = client.run(run).unwrap().records["v"].clone();
    for ((t, v), id) in v.times.iter().zip(&v.values).zip(&v.senders) {
        let pa = if *id == 2 { 300.0 } else { 100.0 };
        let exact = -70.0 + pa / 25.0 * (1.0 - (-t / 10.0).exp());
        assert!((v / exact - 1.0).abs() < 1e-9, "neuron {id} at {t} ms: {v} mV");
    }
}

/// [NCP-SESS-023] [NCP-SESS-024] [NCP-SESS-025] [NCP-SESS-030] [NCP-SESS-039]
#[test]
fn only_a_fitting_open_opens_a_session_and_it_says_where_its_numbers_come_from() {
    let mut service = SessionService::new(ReferenceBackend);
    let mut open = |change: &dyn Fn(&mut OpenSession)| {
        let mut request = lif_session("a");
        change(&mut request);
        SessionOpened::decode(service.serve(request.encode().unwrap().as_bytes()).as_bytes()).unwrap()
    };
    for version in ["0.4", "1.0", "junk", ""] {
        let refused = open(&|request| request.ncp_version = version.into());
        assert!(!refused.ok && refused.error.is_some(), "{version}");
    }
    assert!(!open(&|request| request.network.reference = "nest.brunel".into()).ok);
    assert!(
        !open(&|request| {
            request.network.params.insert("V_rest", 1.0);
        })
        .ok
    );
    assert!(!open(&|request| request.network.population_sizes.insert("x", -1).map_or((), drop)).ok);
    assert!(!open(&|request| request.record.targets[0].target = "inh".into()).ok);
    let opened = open(&|request| request.contract_hash = Some("2cf0763ad61e4f1c".into()));
    assert!(opened.ok);
    let provenance = opened.provenance.unwrap();
    assert!(provenance.is_simulation_output && !provenance.calibrated_posterior);
    assert!(!open(&|_| {}).ok, "it is open already");
    assert_eq!(service.open_sessions().collect::<Vec<_>>(), ["a"]);
}

/// [NCP-SESS-022] [NCP-SESS-026] [NCP-SESS-029] [NCP-SESS-032]
#[test]
fn what_cannot_be_served_is_answered_with_an_error_frame() {
    let mut service = SessionService::new(ReferenceBackend);
    service.serve(lif_session("a").encode().unwrap().as_bytes());
    for request in [
        r#"{"kind":"step_request","session_id":"b"}"#,
        r#"{"kind":"run_request","session_id":"b","duration_ms":1}"#,
        r#"{"kind":"run_request","session_id":"a","duration_ms":-1}"#,
        r#"{"kind":"run_request","session_id":"a","duration_ms":1e300}"#,
        r#"{"kind":"step_request","session_id":"a","stimulus":{"values":{"x":{"data":[1]}}}}"#,
        r#"{"kind":"step_request","session_id":"a","stimulus":{"values":{"i":{"data":[1,2]}}}}"#,
        r#"{"kind":"sensor_frame"}"#,
        r#"{"kind":"session_opened","session_id":"a"}"#,
        r#"{"kind":"dance"}"#,
        "",
        "[]",
    ] {
        let reply = decode_any(service.serve(request.as_bytes()).as_bytes()).unwrap();
        assert_eq!(reply.kind(), Kind::Error, "{request}");
    }
    let closed = service.serve(br#"{"kind":"close_session","session_id":"b"}"#);
    assert!(closed.contains(r#""ok":false"#));
}

/// [NCP-SESS-040] [NCP-SESS-028]
#[test]
fn a_client_closes_only_the_session_that_it_opened() {
    let (bus, _serving, mut owner) = bus();
    let mut guest = NeuroSimClient::new(bus, None).unwrap();
    owner.open(lif_session("a")).unwrap();
    guest.step(StepRequest { session_id: "a".into(), ..StepRequest::default() }).unwrap();
    assert!(guest.close("a").unwrap().is_none());
    assert!(owner.close("a").unwrap().unwrap().ok);
    let gone = owner.step(StepRequest { session_id: "a".into(), ..StepRequest::default() });
    assert!(matches!(gone, Err(BusError::Reply(ReplyError::Reported(_)))));
}

/// [NCP-SESS-037]
#[test]
fn a_simulator_that_panics_costs_that_request_only() {
    struct Fragile;
    impl Simulation for Fragile {
        fn stimulate(&mut self, _: &ChannelMap) -> Result<(), BackendError> {
            Ok(())
        }
        fn advance(&mut self, advance_ms: f64) -> Result<SortedMap<Observation>, BackendError> {
            assert!(advance_ms < 5.0);
            Ok(SortedMap::new())
        }
        fn time_ms(&self) -> f64 {
            0.0
        }
    }
    struct Backend;
    impl SimulationBackend for Backend {
        fn name(&self) -> &'static str {
            "fragile"
        }
        fn open(&mut self, _: &OpenSession) -> Result<Opened, BackendError> {
            Ok(Opened { simulation: Box::new(Fragile), resolved: SortedMap::new(), seed: None })
        }
    }
    let mut service = SessionService::new(Backend);
    service.serve(lif_session("a").encode().unwrap().as_bytes());
    let kind_of = |reply: String| decode_any(reply.as_bytes()).unwrap().kind();
    assert_eq!(kind_of(service.serve(br#"{"kind":"run_request","session_id":"a","duration_ms":9}"#)), Kind::Error);
    assert_eq!(
        kind_of(service.serve(br#"{"kind":"run_request","session_id":"a","duration_ms":1}"#)),
        Kind::ObservationFrame
    );
}

/// [NCP-TRANS-001] [NCP-TRANS-008] [NCP-TRANS-009] [NCP-TRANS-010]
#[test]
fn a_subscription_ends_with_its_handle_and_a_full_one_drops_the_oldest() {
    let bus = LocalBus::new();
    let all = bus.subscribe("ncp/session/**").unwrap();
    let one = bus.subscribe("ncp/session/*/sensor").unwrap();
    assert_eq!(bus.publish("ncp/session/a/sensor", b"1").unwrap(), 2);
    assert_eq!(bus.publish("ncp/session/a/sensor/front", b"2").unwrap(), 1);
    assert_eq!(&*one.next_frame().unwrap().frame, b"1");
    assert!(one.next_frame().is_none());
    drop(one);
    assert_eq!(bus.publish("ncp/session/a/sensor", b"3").unwrap(), 1);
    for n in 0..QUEUE_FRAMES {
        bus.publish("ncp/session/a/command", n.to_string().as_bytes()).unwrap();
    }
    assert_eq!(&*all.next_frame().unwrap().frame, b"0");
    let served = Arc::new(Mutex::new(0));
    let count = Arc::clone(&served);
    let serving = bus
        .serve("ncp/rpc", move |_| {
            *count.lock().unwrap() += 1;
            Vec::new()
        })
        .unwrap();
    bus.query("ncp/rpc", b"x").unwrap();
    drop(serving);
    assert!(matches!(bus.query("ncp/rpc", b"x"), Err(BusError::NoServer { .. })));
    assert_eq!(*served.lock().unwrap(), 1);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(2_000) })]

    /// [NCP-SESS-020] [NCP-SESS-021]
    #[test]
    fn every_request_has_one_reply_that_a_client_can_read(
        requests in prop::collection::vec(
            prop_oneof![
                prop::collection::vec(any::<u8>(), 0..40),
                "[ -~]{0,40}".prop_map(String::into_bytes),
                (prop::sample::select(Kind::ALL.to_vec()), "[ab]", any::<f64>()).prop_map(|(kind, id, n)| {
                    let network = r#"{"ref":"ncp.reference.lif"}"#;
                    format!(r#"{{"kind":"{kind}","session_id":"{id}","duration_ms":{n:e},"network":{network}}}"#)
                        .into_bytes()
                }),
            ],
            1..8,
        ),
    ) {
        let mut service = SessionService::new(ReferenceBackend);
        for request in requests {
            let reply = service.serve(&request);
            let reply = decode_any(reply.as_bytes()).unwrap();
            prop_assert!(matches!(
                reply,
                Message::Error(_) | Message::SessionOpened(_) | Message::SessionClosed(_) | Message::ObservationFrame(_)
            ));
        }
    }
}
