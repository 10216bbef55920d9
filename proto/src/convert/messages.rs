//! The messages, field by field.
//!
//! A field converts as its types say (see [`super::fields`]), so a declaration here is a list of
//! names. The compiler checks that no field of either side is forgotten.

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

/// Declares a message by its fields, which are named alike on both sides.
macro_rules! record {
    ($name:ident [$($kind:ident)?] $(prepare $prepare:path)? { $($field:ident),* }) => {
        impl Record for $name {
            type Proto = v0::$name;

            fn to(&self, losses: &mut Losses) -> v0::$name {
                let Self { $($field),* } = self;
                v0::$name {
                    $($kind: Self::KIND.as_str().to_owned(),)?
                    $($field: losses.member(stringify!($field), |losses| Field::to($field, losses)),)*
                }
            }

            fn from(proto: v0::$name) -> Result<Self, FromProtoError> {
                $(let proto = $prepare(proto)?;)?
                let v0::$name { $($kind,)? $($field),* } = proto;
                $(expect_kind(Self::KIND, $kind)?;)?
                Ok(Self {
                    $($field: Field::from($field).map_err(|error: FromProtoError| error.inside(stringify!($field)))?,)*
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
            record! { $name [kind] $(prepare $prepare)? { ncp_version, $($fields)* } }

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

/// Declares a descriptive enum: spec value = prost value.
macro_rules! descriptive {
    ($($name:ident { $($value:ident = $proto:ident),* })*) => {
        $(impl Field<i32> for $name {
            fn to(&self, losses: &mut Losses) -> i32 {
                match self {
                    $(Self::$value => v0::$name::$proto.into(),)*
                    Self::Unknown(string) => {
                        losses.add(Lost::UnknownString(string.as_str().to_owned()));
                        v0::$name::Unspecified.into()
                    }
                }
            }

            // A number that is not known has no wire string, and none may be invented.
            // [NCP-WIRE-045]
            fn from(proto: i32) -> Result<Self, FromProtoError> {
                match v0::$name::try_from(proto) {
                    $(Ok(v0::$name::$proto) => Ok(Self::$value),)*
                    Ok(v0::$name::Unspecified) | Err(_) => {
                        Err(FromProtoError::EnumNumber { path: String::new(), number: proto, of: stringify!($name) })
                    }
                }
            }
        })*
    };
}

messages! {
    ChannelValue { data, unit }
    EntityRef { path, role, meta }
    EntityBinding { entity, port, direction }
    RecordTarget { port, target, observable, ids, cadence_ms, recordables }
    RecordSpec { targets }
    StimulusTarget { port, target, kind, ids, params }
    StimulusSpec { targets }
    SimConfig { dt_ms, chunk_ms, seed, mode, duration_ms }
    SimProvenance { network_ref, backend, seed, calibrated_posterior, is_simulation_output, advisory_only, note }
    Observation { port, target, observable, times, values, senders, unit, recordable }
    ChannelSpec { name, kind, unit, size, optional, description }
    SafetyLimits { max_speed_mps, max_tilt_rad, geofence_radius_m, command_timeout_ms }
}

frames! {
    OpenSession prepare network_is_there { session_id, network, record, stimulus, sim, bindings, contract_hash }
    SessionOpened { session_id, ok, backend, resolved, provenance, error, contract_hash }
    StimulusFrame { session_id, t, values }
    StepRequest prepare fill_in_step { session_id, advance_ms, stimulus }
    RunRequest prepare fill_in_run { session_id, duration_ms, stimulus }
    ObservationFrame { session_id, seq, t, sim_time_ms, records, calibrated_posterior, is_simulation_output }
    BulkObservation { port, target, observable, unit, recordable, block }
    CloseSession { session_id }
    SessionClosed { session_id, ok }
    Capabilities { controller_id, role, control_rate_hz, sensor_channels, command_channels, codec_id, safety }
    SensorFrame { seq, t, frame_id, channels }
    CommandFrame { seq, t, frame_id, mode, ttl_ms, channels, horizon, horizon_dt_ms }
    ControlStatus { seq, t, mode, sim_time_ms, loop_latency_ms, safety_ok, note }
    LinkStatus { session_id, t, last_seq, received, lost, loss_rate, burst }
}

optional! { StimulusFrame }
nested! { NetworkRef }

/// `ref` is a word of Rust, so the two sides name it differently.
impl Record for NetworkRef {
    type Proto = v0::NetworkRef;

    fn to(&self, losses: &mut Losses) -> v0::NetworkRef {
        let Self { kind, reference, model_name, population_sizes, params } = self;
        v0::NetworkRef {
            kind: losses.member("kind", |losses| Field::to(kind, losses)),
            r#ref: losses.member("ref", |losses| Field::to(reference, losses)),
            model_name: losses.member("model_name", |losses| Field::to(model_name, losses)),
            population_sizes: losses.member("population_sizes", |losses| Field::to(population_sizes, losses)),
            params: losses.member("params", |losses| Field::to(params, losses)),
        }
    }

    fn from(proto: v0::NetworkRef) -> Result<Self, FromProtoError> {
        let v0::NetworkRef { kind, r#ref, model_name, population_sizes, params } = proto;
        Ok(Self {
            kind: Field::from(kind).map_err(|error: FromProtoError| error.inside("kind"))?,
            reference: Field::from(r#ref)?,
            model_name: Field::from(model_name)?,
            population_sizes: Field::from(population_sizes)?,
            params: Field::from(params)?,
        })
    }
}

descriptive! {
    Observable { Vm = VM, Spikes = Spikes, Rate = Rate, Weight = Weight, BinaryState = BinaryState }
    StimulusKind { CurrentPa = CurrentPa, RateHz = RateHz, SpikeTimes = SpikeTimes, WeightSet = WeightSet, RateInject = RateInject }
    NetworkRefKind { Handle = Handle, Builtin = Builtin, ModelId = ModelId, Spec = Spec }
    EntityRole { System = System, Actor = Actor, Sensor = Sensor, Actuator = Actuator }
    ChannelKind { Scalar = Scalar, Vec3 = Vec3, Quat = Quat, Array = Array }
    Role { Controller = Controller, Plant = Plant }
}

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
