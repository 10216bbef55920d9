//! The properties: what is claimed, in words and in symbols, and the harness that says it.

pub mod clamp;
mod command;
pub mod geofence;
pub mod latch;
mod loops;
pub mod number;
mod table;
pub mod watchdog;
mod words;

pub use table::PROPERTIES;

/// What a property is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// The deadline of a command, and the order of commands.
    Watchdog,
    /// The fence and the look-ahead.
    Geofence,
    /// The speed limit.
    Clamp,
    /// ESTOP, the order of the gates, the modes.
    Latch,
    /// The numbers on which all of it runs.
    Number,
}

impl Family {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Watchdog, Self::Geofence, Self::Clamp, Self::Latch, Self::Number];

    /// Its name in reports and in the table of broken kernels.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Watchdog => "watchdog",
            Self::Geofence => "geofence",
            Self::Clamp => "clamp",
            Self::Latch => "latch",
            Self::Number => "number",
        }
    }
}

/// A property of the kernel.
#[derive(Debug, Clone, Copy)]
pub struct Property {
    /// Its name: family and subject.
    pub id: &'static str,
    /// What it is about.
    pub family: Family,
    /// The rules for which it is evidence.
    pub rules: &'static [&'static str],
    /// The claim in words.
    pub sentence: &'static str,
    /// The claim in symbols.
    pub statement: &'static str,
    /// The bounds within which it is claimed; all doubles and all seqs where nothing is said.
    pub bounds: &'static str,
    /// What is assumed.
    pub assumptions: &'static [&'static str],
}
