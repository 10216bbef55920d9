//! Two routers, a relay between them, and who meets over it.

use std::thread;

use ncp_spec::wire::{CloseSession, CommandFrame, ControlStatus, Frame, Message, SensorFrame};
use ncp_zenoh::{
    CommandPublisher, ControlClient, ControlServer, Intake, ObservationPublisher, SeenQos, SensorPublisher,
};

use super::*;
use crate::target::free_endpoint;

const LONG: Duration = Duration::from_secs(20);

struct Net {
    relay: Relay,
    left: Bus,
    right: Bus,
    _routers: [Bus; 2],
}

impl Net {
    fn new(schedule: &str) -> Self {
        let endpoints = [free_endpoint("tcp").unwrap(), free_endpoint("tcp").unwrap()];
        let _routers = endpoints.clone().map(|endpoint| Bus::open(&Link::Router(endpoint), None).unwrap());
        let [left, right] = endpoints.clone().map(|endpoint| Bus::open(&Link::Connect(endpoint), Some("ncp")).unwrap());
        let relay = Relay::start(&endpoints[0], &endpoints[1], "ncp", Schedule::parse(schedule).unwrap()).unwrap();
        Self { relay, left, right, _routers }
    }

    fn commands(&self) -> (CommandPublisher, Intake<CommandFrame>) {
        let publisher = CommandPublisher::declare(&self.left, "s", None).unwrap();
        let intake = Intake::subscribe(&self.right, self.right.keys().command("s", None).unwrap(), 4_096).unwrap();
        until(|| publisher.stream().has_reader().unwrap());
        thread::sleep(Duration::from_millis(100));
        (publisher, intake)
    }
}

fn until(mut is_so: impl FnMut() -> bool) {
    let began = Instant::now();
    while !is_so() {
        assert!(began.elapsed() < LONG, "not within {LONG:?}");
        thread::sleep(Duration::from_millis(2));
    }
}

fn send(publisher: &CommandPublisher, seqs: std::ops::RangeInclusive<i64>) {
    for seq in seqs {
        publisher.send(&CommandFrame { seq, ..CommandFrame::default() }).unwrap();
    }
}

/// Sends one after the other: the plane drops what comes faster than a busy machine takes it.
fn send_slowly(net: &Net, publisher: &CommandPublisher, seqs: std::ops::RangeInclusive<i64>) {
    for seq in seqs {
        send(publisher, seq..=seq);
        until(|| net.relay.passed().any(|passed| passed.fate == Fate::Came));
    }
}

fn seqs(intake: &Intake<CommandFrame>, count: usize) -> Vec<i64> {
    let mut seqs = Vec::new();
    until(|| {
        seqs.extend(std::iter::from_fn(|| intake.next_frame()).map(|frame| frame.seq));
        seqs.len() >= count
    });
    seqs
}

/// `[NCP-PLANE-002] [NCP-PLANE-003] [NCP-PLANE-004] [NCP-TRANS-001] [NCP-TRANS-002]`
#[test]
fn a_quiet_link_hands_on_each_plane_unchanged_with_its_quality_of_service() {
    let net = Net::new("");
    let pattern = || net.left.keys().fleet_glob().unwrap();
    let taps = [&net.left, &net.right].map(|bus| Intake::<()>::subscribe(bus, pattern(), 64).unwrap());
    let sensor = SensorPublisher::declare(&net.right, "s", Some("front")).unwrap();
    let observation = ObservationPublisher::declare(&net.right, "s").unwrap();
    let command = CommandPublisher::declare(&net.left, "s", None).unwrap();
    let streams = [sensor.stream(), observation.stream(), command.stream()];
    until(|| streams.iter().all(|stream| stream.has_reader().unwrap()));
    thread::sleep(Duration::from_millis(200));
    let (sensed, status) = (SensorFrame { seq: 1, ..SensorFrame::default() }, ControlStatus::default());
    let commanded = CommandFrame { seq: 2, ..CommandFrame::default() };
    sensor.send(&sensed).unwrap();
    observation.send_status(&status).unwrap();
    command.send(&commanded).unwrap();
    // On the right is what was put there, and the command that came over.
    let expected = [
        ("ncp/session/s/sensor/front", PlaneName::Perception, sensed.encode().unwrap()),
        ("ncp/session/s/observation", PlaneName::Observation, status.encode().unwrap()),
        ("ncp/session/s/command", PlaneName::Action, commanded.encode().unwrap()),
    ];
    for tap in &taps {
        let mut seen = Vec::new();
        until(|| {
            seen.extend(tap.next());
            seen.len() == expected.len()
        });
        for (key, plane, bytes) in &expected {
            let found = seen.iter().find(|arrival| arrival.key.as_str() == *key).unwrap();
            assert_eq!(&*found.payload.to_bytes(), bytes.as_bytes());
            assert_eq!(found.qos, SeenQos::from(plane.plane().qos()), "{key}");
        }
    }
    assert_eq!(net.relay.faults(), FaultCounts::new());
}

/// `[NCP-SESS-020]`
#[test]
fn requests_and_replies_pass_and_a_reply_that_is_lost_is_silence() {
    let asked: Message = CloseSession { session_id: "s".into(), ..CloseSession::default() }.into();
    for (schedule, answers) in [("", true), ("[control]\nlose = 1.0", false)] {
        let net = Net::new(schedule);
        let reply = r#"{"kind":"session_closed","session_id":"s","ok":true}"#;
        let _server = ControlServer::start(&net.right, move |_| reply.as_bytes().to_vec()).unwrap();
        let client = ControlClient::new(&net.left, Duration::from_millis(500)).unwrap();
        if answers {
            until(|| client.ask(&asked).is_ok());
        } else {
            let began = Instant::now();
            assert!(client.ask(&asked).is_err());
            assert!(began.elapsed() >= Duration::from_millis(400), "a lost request was answered at once");
        }
    }
}

#[test]
fn a_link_that_loses_all_hands_on_nothing_and_counts_it() {
    let net = Net::new("[action]\nlose = 1.0");
    let (publisher, intake) = net.commands();
    send_slowly(&net, &publisher, 1..=20);
    until(|| net.relay.faults().get(&PlaneName::Action).is_some_and(|of| of.get(&Fault::Lost) == Some(&20)));
    thread::sleep(Duration::from_millis(100));
    assert!(intake.next().is_none());
}

#[test]
fn a_reordered_frame_comes_after_the_next_one_and_a_duplicate_twice() {
    let net = Net::new("[action]\nreorder = 1.0");
    let (publisher, intake) = net.commands();
    send(&publisher, 1..=4);
    assert_eq!(seqs(&intake, 4), [2, 1, 4, 3]);
    let net = Net::new("[action]\nduplicate = 1.0\nduplicate_ms = [20, 20]");
    let (publisher, intake) = net.commands();
    send(&publisher, 1..=1);
    assert_eq!(seqs(&intake, 2), [1, 1]);
}

#[test]
fn a_flood_and_a_burst_are_as_long_as_the_schedule_says() {
    let net = Net::new("[action]\nflood = 1.0\nflood_copies = 9\nflood_ms = 50");
    let (publisher, intake) = net.commands();
    send(&publisher, 1..=1);
    assert_eq!(seqs(&intake, 10), [1; 10]);
    let net = Net::new("[action]\nburst = { every = 5, frames = 2 }");
    let (publisher, intake) = net.commands();
    send_slowly(&net, &publisher, 1..=10);
    assert_eq!(seqs(&intake, 6), [1, 2, 3, 6, 7, 8]);
}

#[test]
fn a_supervisor_stops_the_commands_and_lets_them_through_again() {
    let net = Net::new("[action]\ndelay = 1.0\ndelay_ms = [200, 200]");
    let (publisher, intake) = net.commands();
    send(&publisher, 1..=2);
    let mut came = 0;
    until(|| {
        came += net.relay.passed().filter(|passed| passed.fate == Fate::Came).count();
        came == 2
    });
    net.relay.stop_commands(true);
    send(&publisher, 3..=4);
    thread::sleep(Duration::from_millis(500));
    net.relay.stop_commands(false);
    send(&publisher, 5..=5);
    assert_eq!(seqs(&intake, 1), [5]);
}
