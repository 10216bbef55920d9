//! How the types of fields convert, whichever message they stand in.

use std::collections::BTreeMap;

use ncp_spec::wire::{ChannelMap, SortedMap, Text};

use super::{FromProtoError, Loss, Lost};
use crate::v0;

/// A field of type `Self` in a frame, and of type `P` in its prost struct.
pub(super) trait Field<P>: Sized {
    fn to(&self, losses: &mut Losses) -> P;
    fn from(proto: P) -> Result<Self, FromProtoError>;
}

/// An item of an array, likewise.
pub(super) trait Item<P>: Sized {
    fn to(&self, losses: &mut Losses) -> P;
    fn from(proto: P) -> Result<Self, FromProtoError>;
}

/// A message, as the tables of [`super::messages`] declare it.
pub(super) trait Record: Sized {
    type Proto;
    fn to(&self, losses: &mut Losses) -> Self::Proto;
    fn from(proto: Self::Proto) -> Result<Self, FromProtoError>;
}

/// The losses so far, and the way to the field that is being converted.
#[derive(Default)]
pub(super) struct Losses {
    found: Vec<Loss>,
    path: String,
}

impl Losses {
    pub(super) fn member<T>(&mut self, name: &str, convert: impl FnOnce(&mut Self) -> T) -> T {
        let outer = self.path.len();
        if outer > 0 {
            self.path.push('.');
        }
        self.path.push_str(name);
        let result = convert(self);
        self.path.truncate(outer);
        result
    }

    fn item<T>(&mut self, nth: usize, convert: impl FnOnce(&mut Self) -> T) -> T {
        let outer = self.path.len();
        self.path.push_str(&format!("[{nth}]"));
        let result = convert(self);
        self.path.truncate(outer);
        result
    }

    pub(super) fn add(&mut self, what: Lost) {
        self.found.push(Loss { path: self.path.clone(), what });
    }

    pub(super) fn into_found(self) -> Vec<Loss> {
        self.found
    }
}

impl FromProtoError {
    /// The same error, seen from the message that has the field.
    pub(super) fn inside(mut self, name: &str) -> Self {
        if let Self::Kind { path, .. } | Self::Missing { path } | Self::EnumNumber { path, .. } = &mut self {
            let joint = if path.is_empty() || path.starts_with('[') { "" } else { "." };
            *path = format!("{name}{joint}{path}");
        }
        self
    }
}

/// A type that is the same on both sides and loses nothing.
macro_rules! same {
    ($($type:ty),*) => {
        $(
            impl Field<$type> for $type {
                fn to(&self, _: &mut Losses) -> $type {
                    self.clone()
                }

                fn from(proto: $type) -> Result<Self, FromProtoError> {
                    Ok(proto)
                }
            }

            impl Item<$type> for $type {
                fn to(&self, _: &mut Losses) -> $type {
                    self.clone()
                }

                fn from(proto: $type) -> Result<Self, FromProtoError> {
                    Ok(proto)
                }
            }
        )*
    };
}

same!(i64, bool, Vec<u8>);

impl Field<String> for Text {
    fn to(&self, _: &mut Losses) -> String {
        self.clone().into_owned()
    }

    fn from(proto: String) -> Result<Self, FromProtoError> {
        Ok(Self::Owned(proto))
    }
}

impl Item<String> for Text {
    fn to(&self, losses: &mut Losses) -> String {
        Field::to(self, losses)
    }

    fn from(proto: String) -> Result<Self, FromProtoError> {
        Field::from(proto)
    }
}

/// In a field or a map, prost leaves out what equals zero, and −0.0 does.
impl Field<f64> for f64 {
    fn to(&self, losses: &mut Losses) -> f64 {
        if *self == 0.0 && self.is_sign_negative() {
            losses.add(Lost::ZeroSign);
        }
        *self
    }

    fn from(proto: f64) -> Result<Self, FromProtoError> {
        Ok(proto)
    }
}

impl Item<f64> for f64 {
    fn to(&self, _: &mut Losses) -> f64 {
        *self
    }

    fn from(proto: f64) -> Result<Self, FromProtoError> {
        Ok(proto)
    }
}

impl Field<String> for Option<Text> {
    fn to(&self, losses: &mut Losses) -> String {
        if self.as_ref().is_some_and(|text| text.is_empty()) {
            losses.add(Lost::EmptyString);
        }
        self.as_deref().unwrap_or_default().to_owned()
    }

    fn from(proto: String) -> Result<Self, FromProtoError> {
        Ok(Some(proto).filter(|text| !text.is_empty()).map(Text::Owned))
    }
}

impl Field<i64> for Option<i64> {
    fn to(&self, losses: &mut Losses) -> i64 {
        if *self == Some(0) {
            losses.add(Lost::Zero);
        }
        self.unwrap_or_default()
    }

    fn from(proto: i64) -> Result<Self, FromProtoError> {
        Ok(Some(proto).filter(|number| *number != 0))
    }
}

impl Field<f64> for Option<f64> {
    fn to(&self, losses: &mut Losses) -> f64 {
        if *self == Some(0.0) {
            losses.add(Lost::Zero);
        }
        self.unwrap_or_default()
    }

    fn from(proto: f64) -> Result<Self, FromProtoError> {
        Ok(Some(proto).filter(|number| *number != 0.0))
    }
}

impl<T: Item<P>, P> Field<Vec<P>> for Vec<T> {
    fn to(&self, losses: &mut Losses) -> Vec<P> {
        self.iter().enumerate().map(|(nth, item)| losses.item(nth, |losses| item.to(losses))).collect()
    }

    fn from(proto: Vec<P>) -> Result<Self, FromProtoError> {
        let items = proto.into_iter().enumerate();
        items.map(|(nth, item)| T::from(item).map_err(|error| error.inside(&format!("[{nth}]")))).collect()
    }
}

impl<T: Field<P>, P> Field<BTreeMap<String, P>> for SortedMap<T> {
    fn to(&self, losses: &mut Losses) -> BTreeMap<String, P> {
        self.iter().map(|(name, value)| (name.to_owned(), losses.member(name, |losses| value.to(losses)))).collect()
    }

    fn from(proto: BTreeMap<String, P>) -> Result<Self, FromProtoError> {
        // Both sorts are by code points, so every insertion is at the end.
        let entries = proto.into_iter().map(|(name, value)| match T::from(value) {
            Ok(value) => Ok((name, value)),
            Err(error) => Err(error.inside(&name)),
        });
        entries.collect()
    }
}

/// A step of a horizon is a plain map on JSON. [NCP-WIRE-051]
impl Item<v0::SetpointStep> for ChannelMap {
    fn to(&self, losses: &mut Losses) -> v0::SetpointStep {
        v0::SetpointStep { channels: Field::to(self, losses) }
    }

    fn from(proto: v0::SetpointStep) -> Result<Self, FromProtoError> {
        Field::from(proto.channels).map_err(|error: FromProtoError| error.inside("channels"))
    }
}
