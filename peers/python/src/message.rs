//! Messages from dicts and to dicts, by the tables of `ncp-spec`.
//!
//! A dict goes through the JSON that [`wire::build`] takes: a program's message, which is not checked
//! before it is encoded. In Python a double may be any float, so the strings that stand for NaN and
//! its like in that JSON never come from a string of the dict.

use ncp_spec::ErrorCode;
use ncp_spec::wire::{self, JsonType, Kind, Message, NESTED, Table};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedStr;
use pyo3::types::{PyBool, PyDict, PyList, PyString};
use serde_json::Value;

use crate::argument::{Frame, double_of, integer_of, wrong_type};
use crate::error::{Error, Result};

/// The kind of this name.
pub(crate) fn kind(name: &str) -> Result<Kind> {
    Kind::parse(name).ok_or_else(|| {
        let name: String = name.chars().take(64).collect();
        Error::at(ErrorCode::Kind, "kind".to_owned(), &format_args!("{name:?} is not a kind"))
    })
}

/// The message of a dict of fields.
pub(crate) fn build(kind: Kind, fields: &Bound<'_, PyAny>) -> Result<Message> {
    let mut text = Vec::new();
    write_message(kind.table(), fields, &mut text).map_err(Misfit::into_error)?;
    // The bytes that an error counts are those of a text that nobody sees.
    wire::build(kind, &text).map_err(|error| Error::at(error.code(), error.path().to_owned(), error.problem()))
}

/// A message of the type `M`: a frame, or a dict of fields.
pub(crate) fn message<M>(given: &Bound<'_, PyAny>) -> Result<M>
where
    M: wire::Frame + TryFromMessage,
{
    if given.is_instance_of::<PyDict>() {
        return M::take(build(M::KIND, given)?);
    }
    if let Ok(frame) = given.extract::<Frame>() {
        return Ok(M::decode(frame.bytes())?);
    }
    Err(wrong_type("a dict of fields, or a frame as str or bytes", given).into())
}

/// A message of the type `M`, or nothing.
pub(crate) fn optional<M>(given: Option<&Bound<'_, PyAny>>) -> Result<Option<M>>
where
    M: wire::Frame + TryFromMessage,
{
    given.map(message).transpose()
}

/// A message out of a [`Message`] of its kind.
pub(crate) trait TryFromMessage: Sized {
    fn take(message: Message) -> Result<Self>;
}

macro_rules! try_from_message {
    ($($message:ident),+) => {$(
        impl TryFromMessage for wire::$message {
            fn take(message: Message) -> Result<Self> {
                match message {
                    Message::$message(message) => Ok(message),
                    other => Err(Error::refused(ErrorCode::Kind, &format_args!("{} was built", other.kind()))),
                }
            }
        }
    )+};
}

try_from_message!(Capabilities, CommandFrame, SensorFrame);

/// Every field of a message, as a dict.
pub(crate) fn to_dict<'py>(py: Python<'py>, message: impl Into<Message>) -> Result<Bound<'py, PyAny>> {
    let message = message.into();
    let value: Value = serde_json::from_str(&message.fields()).map_err(|error| shown(&error))?;
    read_message(py, message.kind().table(), &value)
}

/// The channel values of a map, as a dict.
pub(crate) fn channels_to_dict<'py>(py: Python<'py>, channels: &wire::ChannelMap) -> Result<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    for (name, channel) in channels.iter() {
        let value = PyDict::new(py);
        value.set_item("data", &channel.data)?;
        value.set_item("unit", channel.unit.as_deref())?;
        dict.set_item(name, value)?;
    }
    Ok(dict)
}

/// Why a dict is no message: the error, and where.
struct Misfit {
    error: Error,
    path: String,
}

impl Misfit {
    fn inside(mut self, name: &str) -> Self {
        self.path = if self.path.is_empty() || self.path.starts_with('[') {
            format!("{name}{}", self.path)
        } else {
            format!("{name}.{}", self.path)
        };
        self
    }

    /// What Python finds wrong with a field is a refusal of the field.
    fn into_error(self) -> Error {
        match self.error {
            Error::Python(error) => Python::attach(|py| {
                if error.is_instance_of::<pyo3::exceptions::PyTypeError>(py) {
                    Error::at(ErrorCode::Type, self.path, error.value(py))
                } else {
                    Error::Python(error)
                }
            }),
            Error::Refused { code, what, .. } => Error::at(code, self.path, &what),
        }
    }
}

impl<E: Into<Error>> From<E> for Misfit {
    fn from(error: E) -> Self {
        Self { error: error.into(), path: String::new() }
    }
}

type Written = std::result::Result<(), Misfit>;

fn write_message(table: Table, fields: &Bound<'_, PyAny>, out: &mut Vec<u8>) -> Written {
    write_object(fields, out, |name, value, out| {
        let Some(field) = table.fields.iter().find(|field| field.name == name) else {
            let what = format!("{} has no such field", table.message);
            return Err(Error::refused(ErrorCode::Invalid, &what).into());
        };
        write_value(field.json, value, out)
    })
}

fn write_value(json: JsonType, value: &Bound<'_, PyAny>, out: &mut Vec<u8>) -> Written {
    match json {
        JsonType::Optional(_) if value.is_none() => out.extend_from_slice(b"null"),
        JsonType::Optional(inner) => return write_value(*inner, value, out),
        JsonType::Number => write_double(double_of(value)?, out)?,
        JsonType::Integer => write_json(&integer_of(value)?, out)?,
        JsonType::String | JsonType::Enum(_) => write_json(&*string(value)?, out)?,
        JsonType::Boolean => {
            let flag = value.cast::<PyBool>();
            let flag = flag.map_err(|_| wrong_type("a bool", value))?;
            write_json(&flag.is_true(), out)?;
        }
        JsonType::Object(message) => {
            let table = nested(message)?;
            return write_message(table, value, out);
        }
        JsonType::Map(item) => {
            return write_object(value, out, |_, value, out| write_value(*item, value, out));
        }
        JsonType::Array(item) => return write_array(*item, value, out),
    }
    Ok(())
}

fn write_object(
    value: &Bound<'_, PyAny>,
    out: &mut Vec<u8>,
    mut member: impl FnMut(&str, &Bound<'_, PyAny>, &mut Vec<u8>) -> Written,
) -> Written {
    let dict = value.cast::<PyDict>().map_err(|_| wrong_type("a dict", value))?;
    // A copy: the conversion of a value may run Python code that changes the dict.
    let items = dict.items();
    out.push(b'{');
    for (nth, item) in items.iter().enumerate() {
        let (name, value) = item.extract::<(Bound<'_, PyAny>, Bound<'_, PyAny>)>()?;
        let name = string(&name)?;
        if nth > 0 {
            out.push(b',');
        }
        write_json(&*name, out)?;
        out.push(b':');
        member(&name, &value, out).map_err(|misfit| misfit.inside(&name))?;
    }
    out.push(b'}');
    Ok(())
}

/// An array: anything with a length and items, such as a list, a tuple or a numpy array.
fn write_array(json: JsonType, value: &Bound<'_, PyAny>, out: &mut Vec<u8>) -> Written {
    let is_other = value.is_instance_of::<PyString>() || value.is_instance_of::<PyDict>();
    if is_other || value.len().is_err() {
        return Err(wrong_type("a sequence", value).into());
    }
    let len = value.len()?;
    out.push(b'[');
    // No more than it says that it has: an object may go on for ever.
    for (nth, item) in value.try_iter()?.take(len).enumerate() {
        if nth > 0 {
            out.push(b',');
        }
        write_value(json, &item?, out).map_err(|misfit| misfit.inside(&format!("[{nth}]")))?;
    }
    out.push(b']');
    Ok(())
}

fn write_double(value: f64, out: &mut Vec<u8>) -> Result<()> {
    let name = match value {
        value if value.is_nan() => "NaN",
        f64::INFINITY => "Infinity",
        f64::NEG_INFINITY => "-Infinity",
        _ => return write_json(&value, out),
    };
    write_json(name, out)
}

fn write_json(value: &(impl serde::Serialize + ?Sized), out: &mut Vec<u8>) -> Result<()> {
    serde_json::to_writer(out, value).map_err(|error| shown(&error))
}

fn string(value: &Bound<'_, PyAny>) -> Result<PyBackedStr> {
    if !value.is_instance_of::<PyString>() {
        return Err(wrong_type("a str", value).into());
    }
    Ok(value.extract()?)
}

fn read_message<'py>(py: Python<'py>, table: Table, value: &Value) -> Result<Bound<'py, PyAny>> {
    let object = value.as_object().ok_or_else(|| shown(value))?;
    let dict = PyDict::new(py);
    for (name, value) in object {
        let field = table.fields.iter().find(|field| field.name == name);
        let json = field.ok_or_else(|| shown(name))?.json;
        dict.set_item(name, read_value(py, json, value)?)?;
    }
    Ok(dict.into_any())
}

fn read_value<'py>(py: Python<'py>, json: JsonType, value: &Value) -> Result<Bound<'py, PyAny>> {
    match (json, value) {
        (JsonType::Optional(_), Value::Null) => Ok(py.None().into_bound(py)),
        (JsonType::Optional(inner), _) => read_value(py, *inner, value),
        (JsonType::Number, _) => {
            let double = match value {
                Value::String(name) => match name.as_str() {
                    "NaN" => Some(f64::NAN),
                    "Infinity" => Some(f64::INFINITY),
                    "-Infinity" => Some(f64::NEG_INFINITY),
                    _ => None,
                },
                value => value.as_f64(),
            };
            let double = double.ok_or_else(|| shown(value))?;
            Ok(pyo3::types::PyFloat::new(py, double).into_any())
        }
        (JsonType::Integer, value) => {
            let integer = value.as_i64().ok_or_else(|| shown(value))?;
            Ok(pyo3::types::PyInt::new(py, integer).into_any())
        }
        (JsonType::String | JsonType::Enum(_), Value::String(text)) => Ok(PyString::new(py, text).into_any()),
        (JsonType::Boolean, Value::Bool(value)) => Ok(PyBool::new(py, *value).to_owned().into_any()),
        (JsonType::Object(message), value) => read_message(py, nested(message)?, value),
        (JsonType::Map(item), Value::Object(object)) => {
            let dict = PyDict::new(py);
            for (name, value) in object {
                dict.set_item(name, read_value(py, *item, value)?)?;
            }
            Ok(dict.into_any())
        }
        (JsonType::Array(item), Value::Array(items)) => {
            let list = PyList::empty(py);
            for value in items {
                list.append(read_value(py, *item, value)?)?;
            }
            Ok(list.into_any())
        }
        _ => Err(shown(value)),
    }
}

fn nested(message: &str) -> Result<Table> {
    let all = NESTED.into_iter().chain(Kind::ALL.into_iter().map(Kind::table));
    all.into_iter().find(|table| table.message == message).ok_or_else(|| shown(&message))
}

/// The tables and the messages of `ncp-spec` agree, so no caller meets this.
fn shown(what: &(impl std::fmt::Display + ?Sized)) -> Error {
    Error::refused(ErrorCode::Internal, &format_args!("not of its table: {what}"))
}
