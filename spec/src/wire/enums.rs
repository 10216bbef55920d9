//! The enums of section 1.4. `[NCP-WIRE-040] [NCP-WIRE-087]`
//!
//! Six are *descriptive*: a wire string that this build does not know is kept as it is and written
//! unchanged. `Mode` and `SimMode` decide what happens, so for them it is not kept.

use std::fmt;

pub use ncp_kernel::Mode;

use super::error::{DecodeError, DecodeProblem, EncodeError};
use super::json::{Reader, Writer};
use super::table::JsonType;
use super::value::Value;

/// A wire string of a descriptive enum that this build does not know.
///
/// It only comes from reading: a program cannot make one up. `// [NCP-WIRE-045]`
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct UnknownName(Box<str>);

impl UnknownName {
    /// The string as it was read.
    #[must_use]
    pub fn as_str(&self) -> &str {
        &self.0
    }
}

/// Declares an enum by its wire strings, in the contract's order.
macro_rules! wire_enum {
    ($(#[$meta:meta])* descriptive $name:ident {
        $($(#[$value_meta:meta])* $value:ident = $wire:literal,)*
    }) => {
        $(#[$meta])*
        #[derive(Debug, Clone, PartialEq, Eq, Hash)]
        pub enum $name {
            $($(#[$value_meta])* $value,)*
            /// A wire string that this build does not know; written unchanged.
            Unknown(UnknownName),
        }

        impl $name {
            /// The known values, in the contract's order.
            pub const KNOWN: &[Self] = &[$(Self::$value),*];

            /// The value of a wire string, known or not. `// [NCP-WIRE-040] [NCP-WIRE-042]`
            #[must_use]
            pub fn from_wire(wire: &str) -> Self {
                match wire {
                    $($wire => Self::$value,)*
                    _ => Self::Unknown(UnknownName(wire.into())),
                }
            }

            /// The known value of a wire string.
            #[must_use]
            pub fn parse(wire: &str) -> Option<Self> {
                match wire {
                    $($wire => Some(Self::$value),)*
                    _ => None,
                }
            }

            /// The wire string. `// [NCP-WIRE-043] [NCP-WIRE-087]`
            #[must_use]
            pub fn as_str(&self) -> &str {
                match self {
                    $(Self::$value => $wire,)*
                    Self::Unknown(name) => name.as_str(),
                }
            }
        }

        wire_enum!(@common $name, |read, _at| Ok($name::from_wire(read)));
    };

    ($(#[$meta:meta])* $name:ident {
        $($(#[$value_meta:meta])* $value:ident = $wire:literal,)*
    } $unknown:expr) => {
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum $name {
            $($(#[$value_meta])* $value,)*
        }

        impl $name {
            /// The values, in the contract's order.
            pub const KNOWN: &[Self] = &[$(Self::$value),*];

            /// The value of a wire string. `// [NCP-WIRE-040]`
            #[must_use]
            pub fn parse(wire: &str) -> Option<Self> {
                match wire {
                    $($wire => Some(Self::$value),)*
                    _ => None,
                }
            }

            /// The wire string. `// [NCP-WIRE-087]`
            #[must_use]
            pub const fn as_str(&self) -> &'static str {
                match self {
                    $(Self::$value => $wire,)*
                }
            }
        }

        wire_enum!(@common $name, $unknown);
    };

    (@common $name:ident, $from_wire:expr) => {
        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(self.as_str())
            }
        }

        wire_enum!(@value $name, $from_wire);
    };

    (@value $name:ident, $from_wire:expr) => {
        impl Value for $name {
            const JSON: JsonType = JsonType::Enum(stringify!($name));

            fn read(r: &mut Reader<'_>) -> Result<Self, DecodeError> {
                let at = r.at();
                let read = r.string()?;
                let from_wire: fn(&str, usize) -> Result<Self, DecodeError> = $from_wire;
                from_wire(&read, at)
            }

            fn write(&self, w: &mut Writer) -> Result<(), EncodeError> {
                w.string(self.as_str());
                Ok(())
            }
        }
    };
}

wire_enum! {
    /// The family of a recorded quantity.
    descriptive Observable {
        /// Membrane potential.
        Vm = "V_m",
        /// Spike times.
        Spikes = "spikes",
        /// Firing rate.
        Rate = "rate",
        /// Synaptic weight.
        Weight = "weight",
        /// The state of a binary neuron.
        BinaryState = "binary_state",
    }
}

wire_enum! {
    /// What the values of a stimulus are.
    descriptive StimulusKind {
        /// A current in pA.
        CurrentPa = "current_pA",
        /// A Poisson rate in Hz.
        RateHz = "rate_hz",
        /// Spike times in ms.
        SpikeTimes = "spike_times",
        /// Synaptic weights to be set.
        WeightSet = "weight_set",
        /// A rate that is fed into rate neurons.
        RateInject = "rate_inject",
    }
}

wire_enum! {
    /// How [`NetworkRef::reference`](super::NetworkRef::reference) is to be read.
    descriptive NetworkRefKind {
        /// A handle that the server gave out.
        Handle = "handle",
        /// A network that the server is built with.
        Builtin = "builtin",
        /// The id of a model.
        ModelId = "model_id",
        /// A specification of the network.
        Spec = "spec",
    }
}

wire_enum! {
    /// What an entity is.
    descriptive EntityRole {
        /// The whole system.
        System = "system",
        /// Something that senses and acts.
        Actor = "actor",
        /// Something that senses.
        Sensor = "sensor",
        /// Something that acts.
        Actuator = "actuator",
    }
}

wire_enum! {
    /// The shape of a channel's value.
    descriptive ChannelKind {
        /// One component.
        Scalar = "scalar",
        /// Three components, x, y and z.
        Vec3 = "vec3",
        /// Four components.
        Quat = "quat",
        /// As many as [`ChannelSpec::size`](super::ChannelSpec::size) says.
        Array = "array",
    }
}

wire_enum! {
    /// Which end of the control loop a peer is.
    descriptive Role {
        /// It sends commands.
        Controller = "controller",
        /// It obeys them.
        Plant = "plant",
    }
}

// [NCP-WIRE-041]
wire_enum!(@value Mode, |read, _at| Ok(Mode::parse(read).unwrap_or(Mode::Hold)));

wire_enum! {
    /// How a simulation is run.
    SimMode {
        /// Chunk by chunk, on request.
        Stream = "stream",
        /// Once, for a stated time.
        Batch = "batch",
    }
    // [NCP-WIRE-044]
    |read, at| SimMode::parse(read)
        .ok_or_else(|| DecodeError::new(DecodeProblem::unknown_sim_mode(read), at))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_wire_strings_are_those_of_the_table_in_the_text() {
        macro_rules! known {
            ($($name:ident)*) => {
                vec![$((
                    stringify!($name).to_owned(),
                    $name::KNOWN.iter().map(|value| value.as_str().to_owned()).collect::<Vec<_>>(),
                )),*]
            };
        }
        let known = known!(Observable StimulusKind NetworkRefKind EntityRole ChannelKind Role Mode SimMode);
        let table = ncp_text::tables().enums.iter().map(|known| (known.name.clone(), known.strings.clone()));
        assert_eq!(known, table.collect::<Vec<_>>());
    }

    #[test]
    fn a_known_string_is_never_an_unknown_name() {
        for value in Observable::KNOWN {
            assert_eq!(&Observable::from_wire(value.as_str()), value);
            assert_eq!(Observable::parse(value.as_str()).as_ref(), Some(value));
        }
        let unknown = Observable::from_wire("g_ex");
        assert!(matches!(&unknown, Observable::Unknown(name) if name.as_str() == "g_ex"));
        assert_eq!(unknown.to_string(), "g_ex");
        assert_eq!(Observable::parse("g_ex"), None);
    }
}
