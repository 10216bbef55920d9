//! The messages, field by field.
//!
//! A field converts as its types say (see [`super::fields`]), so that a message is a list of names. The build script
//! writes the lists from the proto, and the compiler checks that no field of either side is forgotten.

use ncp_spec::wire::{
    self, BulkObservation, Capabilities, ChannelKind, ChannelSpec, ChannelValue, CloseSession, CommandFrame,
    ControlStatus, EntityBinding, EntityRef, EntityRole, Frame, Kind, LinkStatus, Message, Mode, NetworkRef,
    NetworkRefKind, Observable, Observation, ObservationFrame, OpenSession, RecordSpec, RecordTarget, Role, RunRequest,
    SafetyLimits, SensorFrame, SessionClosed, SessionOpened, SimConfig, SimMode, SimProvenance, StepRequest,
    StimulusFrame, StimulusKind, StimulusSpec, StimulusTarget,
};
use prost::Message as _;

use super::{
    Convert, FromProtoError, Lost, ToProtoError,
    fields::{Field, Item, Losses, Record},
};
use crate::v0;

/// Declares a message by its fields: the name on the wire, in a frame, and in the prost struct.
macro_rules! record {
    ($name:ident [$($kind:ident)?] $(prepare $prepare:path)? { $($wire:literal $field:ident $proto:ident),* }) => {
        impl Record for $name {
            type Proto = v0::$name;

            fn to(&self, losses: &mut Losses) -> v0::$name {
                let Self { $($field),* } = self;
                v0::$name {
                    $($kind: Self::KIND.as_str().to_owned(),)?
                    $($proto: losses.member($wire, |losses| Field::to($field, losses)),)*
                }
            }

            fn from(proto: v0::$name) -> Result<Self, FromProtoError> {
                $(let proto = $prepare(proto)?;)?
                let v0::$name { $($kind,)? $($proto: $field),* } = proto;
                $(expect_kind(Self::KIND, $kind)?;)?
                Ok(Self {
                    $($field: Field::from($field).map_err(|error: FromProtoError| error.inside($wire))?,)*
                })
            }
        }
    };
}

/// Declares messages that stand inside others.
macro_rules! messages {
    ($($name:ident { $($fields:tt)* })*) => {
        $(
            record! { $name [] { $($fields)* } }
            nested! { $name }
        )*
    };
}

/// What a message can be inside others.
macro_rules! nested {
    ($name:ident) => {
        impl Item<v0::$name> for $name {
            fn to(&self, losses: &mut Losses) -> v0::$name {
                Record::to(self, losses)
            }

            fn from(proto: v0::$name) -> Result<Self, FromProtoError> {
                Record::from(proto)
            }
        }

        /// As the value of a map.
        impl Field<v0::$name> for $name {
            fn to(&self, losses: &mut Losses) -> v0::$name {
                Record::to(self, losses)
            }

            fn from(proto: v0::$name) -> Result<Self, FromProtoError> {
                Record::from(proto)
            }
        }

        /// As a field: an absent one is the message of all defaults. [NCP-WIRE-023]
        impl Field<Option<v0::$name>> for $name {
            fn to(&self, losses: &mut Losses) -> Option<v0::$name> {
                Some(Record::to(self, losses))
            }

            fn from(proto: Option<v0::$name>) -> Result<Self, FromProtoError> {
                proto.map_or_else(|| Ok(Self::default()), Record::from)
            }
        }

        optional! { $name }
    };
}

/// As an optional field.
macro_rules! optional {
    ($name:ident) => {
        impl Field<Option<v0::$name>> for Option<$name> {
            fn to(&self, losses: &mut Losses) -> Option<v0::$name> {
                self.as_ref().map(|message| Record::to(message, losses))
            }

            fn from(proto: Option<v0::$name>) -> Result<Self, FromProtoError> {
                proto.map(Record::from).transpose()
            }
        }
    };
}

/// Declares the messages that are frames of their own.
macro_rules! frames {
    ($($name:ident $(prepare $prepare:path)? { $($fields:tt)* })*) => {
        $(
            record! { $name [kind] $(prepare $prepare)? { $($fields)* } }

            impl Convert for $name {
                type Proto = v0::$name;

                fn to_proto(&self) -> (v0::$name, Vec<super::Loss>) {
                    let mut losses = Losses::default();
                    let proto = Record::to(self, &mut losses);
                    (proto, losses.into_found())
                }

                fn from_proto(proto: v0::$name) -> Result<Self, FromProtoError> {
                    let message: Self = Record::from(proto)?;
                    // An encoder refuses what a receiver would reject. [NCP-WIRE-091]
                    // [NCP-PROV-006]
                    message.encode()?;
                    Ok(message)
                }
            }
        )*

        pub(super) fn to_binary(message: &Message) -> Result<Vec<u8>, ToProtoError> {
            match message {
                $(Message::$name(message) => match message.to_proto() {
                    (proto, losses) if losses.is_empty() => Ok(proto.encode_to_vec()),
                    (_, losses) => Err(ToProtoError::Lossy(losses)),
                },)*
                Message::Error(_) => Err(ToProtoError::ErrorFrame),
            }
        }

        pub(super) fn from_binary(kind: Kind, bytes: &[u8]) -> Result<Message, FromProtoError> {
            match kind {
                $(Kind::$name => {
                    let proto = v0::$name::decode(bytes).map_err(|source| FromProtoError::Binary { kind, source })?;
                    wire::$name::from_proto(proto).map(Message::$name)
                })*
                Kind::Error => Err(FromProtoError::ErrorFrame),
            }
        }
    };
}

/// Declares descriptive enums. A constant of the proto is the wire string in capitals.
macro_rules! descriptive {
    ($($name:ident)*) => {
        $(impl Field<i32> for $name {
            fn to(&self, losses: &mut Losses) -> i32 {
                if let Self::Unknown(string) = self {
                    losses.add(Lost::UnknownString(string.as_str().to_owned()));
                    return v0::$name::Unspecified.into();
                }
                v0::$name::from_str_name(&self.as_str().to_ascii_uppercase()).unwrap_or_default().into()
            }

            // A number that is not known has no wire string, and none may be invented.
            // [NCP-WIRE-045]
            fn from(proto: i32) -> Result<Self, FromProtoError> {
                let constant = v0::$name::try_from(proto).map(|value| value.as_str_name()).unwrap_or_default();
                let mut known = Self::KNOWN.iter().filter(|value| value.as_str().eq_ignore_ascii_case(constant));
                known.next().cloned().ok_or_else(|| FromProtoError::EnumNumber {
                    path: String::new(),
                    number: proto,
                    of: stringify!($name),
                })
            }
        })*
    };
}

include!(concat!(env!("OUT_DIR"), "/messages.rs"));

optional! { StimulusFrame }

descriptive! { Observable StimulusKind NetworkRefKind EntityRole ChannelKind Role }

impl Field<i32> for Mode {
    fn to(&self, _: &mut Losses) -> i32 {
        let mode = match self {
            Self::Init => v0::Mode::Init,
            Self::Active => v0::Mode::Active,
            Self::Hold => v0::Mode::Hold,
            Self::Estop => v0::Mode::Estop,
        };
        mode.into()
    }

    // [NCP-WIRE-041]
    fn from(proto: i32) -> Result<Self, FromProtoError> {
        Ok(match v0::Mode::try_from(proto) {
            Ok(v0::Mode::Init) => Self::Init,
            Ok(v0::Mode::Active) => Self::Active,
            Ok(v0::Mode::Estop) => Self::Estop,
            Ok(v0::Mode::Hold | v0::Mode::Unspecified) | Err(_) => Self::Hold,
        })
    }
}

impl Field<i32> for SimMode {
    fn to(&self, _: &mut Losses) -> i32 {
        let mode = match self {
            Self::Stream => v0::SimMode::Stream,
            Self::Batch => v0::SimMode::Batch,
        };
        mode.into()
    }

    // [NCP-WIRE-044]
    fn from(proto: i32) -> Result<Self, FromProtoError> {
        match v0::SimMode::try_from(proto) {
            Ok(v0::SimMode::Stream) => Ok(Self::Stream),
            Ok(v0::SimMode::Batch) => Ok(Self::Batch),
            Ok(v0::SimMode::Unspecified) | Err(_) => {
                Err(FromProtoError::EnumNumber { path: String::new(), number: proto, of: "SimMode" })
            }
        }
    }
}

fn expect_kind(expected: Kind, found: String) -> Result<(), FromProtoError> {
    if found == expected.as_str() {
        return Ok(());
    }
    Err(FromProtoError::Kind { path: "kind".to_owned(), expected: expected.as_str(), found })
}

// [NCP-WIRE-027]
fn network_is_there(proto: v0::OpenSession) -> Result<v0::OpenSession, FromProtoError> {
    if proto.network.is_some() { Ok(proto) } else { Err(FromProtoError::Missing { path: "network".to_owned() }) }
}

fn fill_in_step(mut proto: v0::StepRequest) -> Result<v0::StepRequest, FromProtoError> {
    fill_in(proto.stimulus.as_mut(), &proto.ncp_version, &proto.session_id);
    Ok(proto)
}

fn fill_in_run(mut proto: v0::RunRequest) -> Result<v0::RunRequest, FromProtoError> {
    fill_in(proto.stimulus.as_mut(), &proto.ncp_version, &proto.session_id);
    Ok(proto)
}

/// What a stimulus frame inside a request leaves out is what the request says. [NCP-WIRE-035]
fn fill_in(stimulus: Option<&mut v0::StimulusFrame>, ncp_version: &str, session_id: &str) {
    let Some(stimulus) = stimulus else { return };
    let said = [
        (&mut stimulus.kind, Kind::StimulusFrame.as_str()),
        (&mut stimulus.ncp_version, ncp_version),
        (&mut stimulus.session_id, session_id),
    ];
    for (field, said) in said {
        if field.is_empty() {
            said.clone_into(field);
        }
    }
}
