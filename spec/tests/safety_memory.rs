//! What keeps a plant safe allocates nothing once it is warm, counted by the allocator itself: no
//! gate, no deadline and no replay can wait for memory or fail for the lack of it.
#![allow(unsafe_code, reason = "a global allocator is an unsafe trait")]

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::hint::black_box;

use ncp_spec::resilience::{ActionBuffer, CommandWatchdog, Received};
use ncp_spec::safety::{
    Decision, METRES, METRES_PER_SECOND, POSITION_CHANNEL, Reason, SafetyGovernor, VELOCITY_CHANNEL,
};
use ncp_spec::wire::{
    Capabilities, ChannelKind, ChannelMap, ChannelSpec, ChannelValue, CommandFrame, Mode, SafetyLimits, SensorFrame,
};

/// Counts what each thread asks for, so that tests may run side by side.
struct Counting;

thread_local! {
    static ASKED: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: every call goes unchanged to the system's allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ASKED.set(ASKED.get() + 1);
        unsafe { System.alloc(layout) }
    }

    unsafe fn realloc(&self, old: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        ASKED.set(ASKED.get() + 1);
        unsafe { System.realloc(old, layout, size) }
    }

    unsafe fn dealloc(&self, old: *mut u8, layout: Layout) {
        unsafe { System.dealloc(old, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

const NOW_S: f64 = 10.0;

/// The result, and how often memory was asked for.
fn counted<T>(run: impl FnOnce() -> T) -> (T, usize) {
    let before = ASKED.get();
    let result = run();
    (result, ASKED.get() - before)
}

/// A plant with a gripper beside its velocity, a speed limit of 2 m/s and a fence of 10 m.
fn governor() -> SafetyGovernor {
    let vector = |name: &'static str, unit: &'static str| ChannelSpec {
        name: name.into(),
        kind: ChannelKind::Vec3,
        unit: Some(unit.into()),
        ..ChannelSpec::default()
    };
    let gripper = ChannelSpec { name: "gripper".into(), ..ChannelSpec::default() };
    SafetyGovernor::from_capabilities(&Capabilities {
        sensor_channels: vec![vector(POSITION_CHANNEL, METRES)],
        command_channels: vec![gripper, vector(VELOCITY_CHANNEL, METRES_PER_SECOND)],
        safety: SafetyLimits { max_speed_mps: Some(2.0), geofence_radius_m: Some(10.0), ..SafetyLimits::default() },
        ..Capabilities::default()
    })
}

fn channels(velocity: [f64; 3]) -> ChannelMap {
    ChannelMap::from_iter([
        ("gripper", ChannelValue::without_unit([0.5])),
        (VELOCITY_CHANNEL, ChannelValue::new(velocity, METRES_PER_SECOND)),
    ])
}

fn command(velocity: [f64; 3], steps: usize) -> CommandFrame {
    CommandFrame {
        seq: 1,
        channels: channels(velocity),
        horizon: vec![channels(velocity); steps],
        horizon_dt_ms: (steps > 0).then_some(50.0),
        ..CommandFrame::default()
    }
}

fn at(position: [f64; 3]) -> SensorFrame {
    let mut frame = SensorFrame::default();
    frame.channels.insert(POSITION_CHANNEL, ChannelValue::new(position, METRES));
    frame
}

/// Governs one command, and says what became of it and how often memory was asked for.
fn govern(command: &mut CommandFrame, sensor: &SensorFrame, last_s: f64) -> (Decision, usize) {
    let mut governor = governor();
    counted(|| governor.govern(command, NOW_S, Some(sensor), Some(last_s)))
}

#[test]
fn the_count_sees_every_allocation() {
    let (_, asked) = counted(|| {
        let mut grown = black_box(vec![0_u8; 10]);
        grown.reserve(1_000);
        drop(black_box(Box::new(1)));
        grown
    });
    assert_eq!(asked, 3);
}

#[test]
fn a_command_passes_without_an_allocation() {
    let passed = govern(&mut command([0.5, 0.0, 0.0], 0), &at([1.0, 2.0, 3.0]), NOW_S);
    assert_eq!(passed, (Decision::Passed, 0));
    let with_horizon = govern(&mut command([0.5, 0.0, 0.0], 8), &at([1.0, 2.0, 3.0]), NOW_S);
    assert_eq!(with_horizon, (Decision::Passed, 0));
}

#[test]
fn a_command_is_clamped_and_truncated_without_an_allocation() {
    let mut hasty = command([30.0, 40.0, 0.0], 8);
    assert_eq!(govern(&mut hasty, &at([0.0; 3]), NOW_S), (Decision::Limited, 0));
    assert!(hasty.horizon.len() == 8 && hasty.channels[VELOCITY_CHANNEL].data[0] < 2.0);

    let mut outward = command([2.0, 0.0, 0.0], 8);
    outward.ttl_ms = 1_000.0;
    assert_eq!(govern(&mut outward, &at([9.75, 0.0, 0.0]), NOW_S), (Decision::Limited, 0));
    assert_eq!(outward.horizon.len(), 1);
}

#[test]
fn every_gate_closes_without_an_allocation() {
    let home = at([0.0; 3]);
    let held = |command: &mut CommandFrame, sensor: &SensorFrame, last_s| {
        let (decision, asked) = govern(command, sensor, last_s);
        assert_eq!((command.mode, asked), (Mode::Hold, 0), "{decision:?}");
        decision
    };
    let calm = || command([0.5, 0.0, 0.0], 4);
    assert_eq!(held(&mut calm(), &home, NOW_S - 1.0), Decision::Held(Reason::StaleSensor));
    assert_eq!(held(&mut calm(), &SensorFrame::default(), NOW_S), Decision::Held(Reason::NoPosition));
    let mut idle = CommandFrame { mode: Mode::Init, ..calm() };
    assert_eq!(held(&mut idle, &home, NOW_S), Decision::Held(Reason::NotActive));
    let mut broken = command([f64::NAN, 0.0, 0.0], 4);
    assert_eq!(held(&mut broken, &home, NOW_S), Decision::Held(Reason::NotFinite));
    let mut narrow = calm();
    narrow.channels.get_mut(VELOCITY_CHANNEL).unwrap().data.pop();
    assert_eq!(held(&mut narrow, &home, NOW_S), Decision::Held(Reason::NoVelocity));
    let mut timeless = CommandFrame { horizon_dt_ms: None, ..calm() };
    assert_eq!(held(&mut timeless, &home, NOW_S), Decision::Held(Reason::BadHorizon));
    let mut leaving = command([2.0, 0.0, 0.0], 0);
    assert_eq!(held(&mut leaving, &at([9.9, 0.0, 0.0]), NOW_S), Decision::Held(Reason::LeavesFence));
}

#[test]
fn estop_latches_and_is_reset_without_an_allocation() {
    let (mut governor, outside) = (governor(), at([11.0, 0.0, 0.0]));
    let mut first = command([0.5, 0.0, 0.0], 4);
    let mut second = command([0.5, 0.0, 0.0], 4);
    let (decisions, asked) = counted(|| {
        let breach = governor.govern(&mut first, NOW_S, Some(&outside), Some(NOW_S));
        governor.note_link(true);
        let latched = governor.govern(&mut second, NOW_S, None, None);
        governor.reset();
        (breach, latched)
    });
    assert_eq!(decisions, (Decision::Stopped(Reason::OutsideFence), Decision::Stopped(Reason::Estop)));
    assert_eq!((asked, governor.is_stopped()), (0, false));
    assert_eq!((first.mode, second.mode), (Mode::Estop, Mode::Estop));
}

#[test]
fn a_governor_with_a_config_fault_holds_without_an_allocation() {
    let limits = SafetyLimits { max_speed_mps: Some(f64::NAN), ..SafetyLimits::default() };
    let mut governor = SafetyGovernor::new(&limits);
    let mut command = command([0.5, 0.0, 0.0], 4);
    let held = counted(|| governor.govern(&mut command, NOW_S, None, Some(NOW_S)));
    assert_eq!(held, (Decision::Held(Reason::ConfigFault), 0));
}

#[test]
fn a_watchdog_lives_its_whole_life_without_an_allocation() {
    let (held, asked) = counted(|| {
        let mut watchdog = CommandWatchdog::new();
        let before = watchdog.should_hold(0.0);
        watchdog.on_command(0.0, 200.0, 1);
        let within = watchdog.should_hold(0.1);
        let past = watchdog.should_hold(0.3);
        watchdog.reset();
        [before, within, past, watchdog.should_hold(0.0)]
    });
    assert_eq!((held, asked), ([true, false, true, true], 0));
}

#[test]
fn a_buffer_takes_replays_and_drops_commands_without_an_allocation() {
    let mut buffer = ActionBuffer::new();
    let first = command([0.5, 0.0, 0.0], 3);
    let (mut second, mut hold, mut estop) = (first.clone(), first.clone(), first.clone());
    second.seq = 2;
    (hold.seq, hold.mode) = (2, Mode::Hold);
    estop.mode = Mode::Estop;
    let duplicate = second.clone();
    let (seen, asked) = counted(|| {
        let took = [buffer.on_command(first, 0.0), buffer.on_command(second, 0.1), buffer.on_command(duplicate, 0.1)];
        // Tick 0, the horizon's first step, and past its end.
        let active = [0.1, 0.16, 0.35].map(|now_s| buffer.active(now_s).is_some());
        let held = buffer.on_command(hold, 0.4);
        let stopped = buffer.on_command(estop, 0.4);
        let moving = buffer.active(0.4).is_some();
        buffer.reset();
        (took, active, held, stopped, moving)
    });
    use Received::{Accepted, Dropped, Held, Stopped};
    assert_eq!(seen, ([Accepted, Accepted, Dropped], [true, true, false], Held, Stopped, false));
    assert_eq!(asked, 0);
}
