//! Messages in the form that requests and answers give them.

use std::collections::BTreeMap;

use ncp_adapter::CallError;
use ncp_adapter::value::{Double, Fields};
use ncp_spec::wire::{self, Capabilities, ChannelMap, ChannelValue, CommandFrame, DecodeProblem};
use ncp_spec::wire::{Kind, Message, SensorFrame};
use serde::Serialize;

use crate::refusal::Refusal;

/// The kind of this name.
pub(crate) fn kind(name: &str) -> Result<Kind, CallError> {
    Kind::parse(name).ok_or_else(|| CallError::misfit(format_args!("{name:?} is not a kind")))
}

/// The message of these fields.
pub(crate) fn build(kind: Kind, fields: &str) -> Result<Message, Refusal> {
    wire::build(kind, fields.as_bytes()).map_err(|error| match error.problem() {
        // A program that names such a field does not even compile.
        DecodeProblem::NoSuchField | DecodeProblem::NotAnObject => CallError::misfit(error).into(),
        _ => error.into(),
    })
}

/// The capabilities of these fields.
pub(crate) fn capabilities(fields: &str) -> Result<Capabilities, Refusal> {
    match build(Kind::Capabilities, fields)? {
        Message::Capabilities(capabilities) => Ok(capabilities),
        other => Err(other_kind(&other)),
    }
}

/// The command of these fields.
pub(crate) fn command(fields: &str) -> Result<CommandFrame, Refusal> {
    match build(Kind::CommandFrame, fields)? {
        Message::CommandFrame(command) => Ok(command),
        other => Err(other_kind(&other)),
    }
}

/// The sensor frame of these fields.
pub(crate) fn sensor(fields: &str) -> Result<SensorFrame, Refusal> {
    match build(Kind::SensorFrame, fields)? {
        Message::SensorFrame(sensor) => Ok(sensor),
        other => Err(other_kind(&other)),
    }
}

/// Every field of the message.
pub(crate) fn fields(message: impl Into<Message>) -> Result<Fields, CallError> {
    Fields::of_text(message.into().fields())
}

/// Channel values by name.
pub(crate) fn channels(map: &ChannelMap) -> Result<Fields, CallError> {
    #[derive(Serialize)]
    struct Channel<'a> {
        data: Vec<Double>,
        unit: Option<&'a str>,
    }

    let shown = map.iter().map(|(name, ChannelValue { data, unit })| {
        let data = data.iter().copied().map(Double).collect();
        (name, Channel { data, unit: unit.as_deref() })
    });
    Fields::of(&shown.collect::<BTreeMap<_, _>>())
}

/// A message is always of the kind that was asked for.
fn other_kind(message: &Message) -> Refusal {
    CallError::misfit(format_args!("{} was built", message.kind())).into()
}
