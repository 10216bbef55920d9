//! What the proofs run: each part of the safety path as a harness calls it, with its state in sight.

use std::collections::BTreeSet;
use std::fmt::Debug;

use ncp_spec::control::Tick;
use ncp_spec::resilience::LinkReport;
use ncp_spec::safety::{Decision, Reason};
use ncp_spec::wire::{Capabilities, ChannelMap, ChannelSpec, CommandFrame, SafetyLimits, SensorFrame, Text};

use crate::spies::Scripted;

/// The state of a link monitor, all of it.
#[derive(Debug, Clone, PartialEq)]
pub struct LinkState {
    /// The usual share of losses.
    pub ref_loss: f64,
    /// Where a burst begins.
    pub threshold: f64,
    /// The first seq seen and the highest.
    pub seen: Option<(i64, i64)>,
    /// Frames that arrived.
    pub received: u64,
    /// Frames that did not.
    pub lost: u64,
    /// Which of these are remembered.
    pub missing: BTreeSet<i64>,
    /// The detector.
    pub cusum: f64,
}

/// A link monitor.
pub trait Link: Clone + Debug {
    /// One in this state.
    fn of(state: LinkState) -> Self;
    /// Its state.
    fn state(&self) -> LinkState;
    /// A new one.
    fn new(ref_loss: f64, threshold: f64) -> Self;
    /// A frame arrives.
    fn on_frame(&mut self, seq: i64);
    /// What it knows.
    fn report(&self) -> LinkReport;
    /// Lost over expected.
    fn loss_rate(&self) -> f64;
    /// Whether losses bunch up.
    fn burst(&self) -> bool;
}

/// A governor.
pub trait Governor: Clone + Debug {
    /// One for the canonical channels.
    fn new(limits: &SafetyLimits) -> Self;
    /// One for negotiated channels.
    fn negotiated(limits: &SafetyLimits, sensor: &[ChannelSpec], command: &[ChannelSpec]) -> Self;
    /// One for the channels and limits of a plant.
    fn from_capabilities(capabilities: &Capabilities) -> Self;
    /// The channels that it knows, with their units.
    fn channels(&self) -> &[(Text, Option<Text>)];
    /// Decides on a command.
    fn govern(
        &mut self,
        command: &mut CommandFrame,
        now_s: f64,
        sensor: Option<&SensorFrame>,
        last_sensor_s: Option<f64>,
    ) -> Decision;
    /// Takes note of the link.
    fn note_link(&mut self, burst: bool);
    /// Clears the latch.
    fn reset(&mut self);
    /// Whether ESTOP is latched.
    fn is_stopped(&self) -> bool;
    /// Whether the limits cannot be enforced.
    fn has_config_fault(&self) -> bool;
    /// What the kernel sees of a command.
    fn with_ticks<T>(&self, command: &mut CommandFrame, ask: impl FnOnce(&mut dyn Ticks) -> T) -> T;
}

/// The ticks of a command as the governor shows them to the kernel.
pub trait Ticks {
    /// How many steps follow tick 0.
    fn steps(&self) -> usize;
    /// The velocity of a tick.
    fn velocity(&self, tick: usize) -> Option<[f64; 3]>;
    /// Limits a tick to a speed in m/s.
    ///
    /// # Errors
    /// The tick is not to be used, or there is none such.
    fn limit(&mut self, tick: usize, max_mps: f64) -> Result<bool, Reason>;
    /// Shortens the horizon.
    fn truncate(&mut self, steps: usize);
    /// The channels of a tick, by the words of NCP-RES-028 and not by those of the governor.
    fn tick_mut(&mut self, tick: usize) -> Option<&mut ChannelMap>;
}

/// The scanner for ESTOPs, and the buffer behind it.
pub trait Stopping {
    /// Whether bytes are an ESTOP.
    fn is_estop(frame: &[u8]) -> bool;
    /// Whether a new buffer is latched once these bytes arrived.
    fn latches(frame: &[u8], is_strict: bool) -> bool;
}

/// The parts of a control loop, all of them.
#[derive(Debug, Clone)]
pub struct LoopParts<G, L> {
    /// Who commands.
    pub controller: Scripted,
    /// Who decides.
    pub governor: G,
    /// Who counts.
    pub link: L,
    /// From tick to tick, in ms.
    pub period_ms: f64,
    /// The newest sensor frame and when it arrived.
    pub newest: Option<(SensorFrame, f64)>,
    /// The counter of the status.
    pub ticks: i64,
    /// The last finite reading of the clock, in seconds.
    pub t: f64,
}

/// A control loop with a controller that does what it is told.
pub trait Loop: Sized {
    /// Its governor.
    type Governor: Clone + Debug;
    /// Its link monitor.
    type Link: Clone + Debug;
    /// One that has not ticked; none where it is refused.
    fn new(period_ms: f64, governor: Self::Governor, link: Self::Link) -> Option<Self>;
    /// One of these parts.
    fn of(parts: LoopParts<Self::Governor, Self::Link>) -> Self;
    /// Its parts.
    fn parts(&self) -> LoopParts<Self::Governor, Self::Link>;
    /// A sensor frame arrives.
    fn on_sensor(&mut self, frame: SensorFrame, now_s: f64) -> bool;
    /// One tick.
    fn tick(&mut self, now_s: f64, took_ms: f64) -> Tick;
    /// A supervisor's reset.
    fn reset(&mut self);
}
