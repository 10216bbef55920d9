//! The words in which the kernel is asked and answers; no decision is taken here.

use core::fmt;

/// What a command lets the plant do: only [`Active`](Mode::Active) moves it. Its names are the wire strings of section
/// 1.4. `[NCP-WIRE-040] [NCP-WIRE-087]`
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Mode {
    /// Before the start.
    Init,
    /// The setpoints hold.
    Active,
    /// Do not move; the fail-safe, from which the loop can go on.
    Hold,
    /// Stop, and stay stopped until a reset.
    Estop,
}

impl Mode {
    /// The values, in the contract's order.
    pub const KNOWN: &[Self] = &[Self::Init, Self::Active, Self::Hold, Self::Estop];

    /// The value of a wire string. `// [NCP-WIRE-040]`
    #[must_use]
    pub fn parse(wire: &str) -> Option<Self> {
        match wire {
            "init" => Some(Self::Init),
            "active" => Some(Self::Active),
            "hold" => Some(Self::Hold),
            "estop" => Some(Self::Estop),
            _ => None,
        }
    }

    /// The wire string. `// [NCP-WIRE-087]`
    #[must_use]
    pub const fn as_str(&self) -> &'static str {
        match self {
            Self::Init => "init",
            Self::Active => "active",
            Self::Hold => "hold",
            Self::Estop => "estop",
        }
    }
}

impl fmt::Display for Mode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

/// What a limit says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Limit<S> {
    /// Nothing: it is absent or 0.
    Disabled,
    /// A finite bound above 0.
    Enabled(S),
    /// It cannot be enforced, and so nothing may move.
    Faulty,
}

/// What the governor did with a command.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Decision {
    /// It passes as it came.
    Passed,
    /// It passes with a velocity scaled or its horizon truncated.
    Limited,
    /// It became a HOLD frame.
    Held(Reason),
    /// It became an ESTOP frame; ESTOP is latched.
    Stopped(Reason),
}

/// Which gate closed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// ESTOP was latched before, or the command itself is an ESTOP.
    Estop,
    /// The limits cannot be enforced.
    ConfigFault,
    /// The sensor is stale, or its age is unknown.
    StaleSensor,
    /// There is no usable position.
    NoPosition,
    /// The position is outside the fence, or its distance cannot be computed.
    OutsideFence,
    /// The command is not in mode `active`.
    NotActive,
    /// A component of tick 0 is not finite.
    NotFinite,
    /// The velocity is absent, not 3 wide, or in another unit.
    NoVelocity,
    /// There is a horizon, but its tick has no finite, positive length.
    BadHorizon,
    /// Tick 0 would lead out of the fence.
    LeavesFence,
}

/// What became of a command in the plant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Received {
    /// It is the one that the plant follows now.
    Accepted,
    /// The plant holds.
    Held,
    /// ESTOP is latched.
    Stopped,
    /// It is stale, a duplicate or reordered, and changes nothing.
    Dropped,
}

/// A command as the governor sees it: tick 0, and the steps of the horizon, which are the ticks 1, 2, …
pub trait Plan<S> {
    /// What it lets the plant do.
    fn mode(&self) -> Mode;
    /// Its ttl as sent, in ms.
    fn ttl_ms(&self) -> S;
    /// The length of a tick, in ms.
    fn dt_ms(&self) -> Option<S>;
    /// How many steps its horizon has.
    fn steps(&self) -> usize;
    /// Applies the speed limit to a tick, by [`limit_tick`](crate::limit_tick). Whether it changed.
    ///
    /// # Errors
    /// The tick is not to be used, or there is none such.
    fn limit(&mut self, tick: usize, max_mps: Limit<S>) -> Result<bool, Reason>;
    /// The velocity of a tick in m/s, if it has one that is 3 wide. `[NCP-SAFE-052]`
    fn velocity(&self, tick: usize) -> Option<[S; 3]>;
    /// Shortens the horizon to its first `steps` steps.
    fn truncate(&mut self, steps: usize);
}

/// A channel of a tick as the speed limit sees it.
#[derive(Debug)]
pub struct Channel<'a, S> {
    /// Its components.
    pub data: &'a mut [S],
    /// Whether it is the velocity channel, by name. `[NCP-SAFE-011]`
    pub is_velocity: bool,
    /// Whether its unit is m/s. `[NCP-SAFE-065]`
    pub in_mps: bool,
}
