//! Where a message stands: as a frame of its own, or somewhere within one.

use crate::json::Json;
use crate::model;
use ncp_text::tables::{Message, Shape, tables};

/// A message at a place in the frames of one kind.
#[derive(Debug, Clone)]
pub(super) struct Place {
    /// The frame's kind.
    pub(super) kind: &'static str,
    /// The members, indices and map keys that lead from the frame to the message.
    path: Vec<String>,
    /// The message that stands there.
    pub(super) message: &'static Message,
}

/// What surrounds the value under test.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Ground {
    /// Only what must be there: for frames that are to be rejected for one reason.
    Minimal,
    /// Every default written out: for frames that are to be read, so that the case does not also
    /// depend on how the peer fills in what is absent.
    Explicit,
}

impl Place {
    /// The kinds, each as a frame of its own.
    pub(super) fn frames() -> impl Iterator<Item = Self> {
        tables().messages.iter().filter_map(|message| {
            let kind = message.kind.as_deref()?;
            Some(Self { kind, path: Vec::new(), message })
        })
    }

    /// Every place where a message stands within a frame. A stimulus frame within a request is
    /// entered, but the channels within it are left to the stimulus frame that stands alone.
    pub(super) fn nested() -> Vec<Self> {
        let mut places = Vec::new();
        for frame in Self::frames() {
            frame.enter(&mut places);
        }
        places
    }

    fn enter(&self, places: &mut Vec<Self>) {
        if !self.path.is_empty() && self.message.kind.is_some() {
            return;
        }
        for field in &self.message.fields {
            let mut path = self.path.clone();
            path.push(field.name.clone());
            let mut shape = &field.shape;
            loop {
                match shape {
                    Shape::List(item) => {
                        path.push("0".to_owned());
                        shape = item;
                    }
                    Shape::Map(value) => {
                        path.push("a".to_owned());
                        shape = value;
                    }
                    Shape::Message(name) => {
                        if let Some(message) = tables().message(name) {
                            let place = Self { kind: self.kind, path, message };
                            places.push(place.clone());
                            place.enter(places);
                        }
                        break;
                    }
                    _ => break,
                }
            }
        }
    }

    /// Whether the message stands within another.
    pub(super) fn is_nested(&self) -> bool {
        !self.path.is_empty()
    }

    /// Whether the other message stands within this one.
    pub(super) fn surrounds(&self, other: &Self) -> bool {
        self.kind == other.kind && other.path.len() > self.path.len() && other.path.starts_with(&self.path)
    }

    /// Whether the message stands in the same kind in the same way under another name.
    pub(super) fn is_twin(&self) -> bool {
        self.path.first().is_some_and(|name| name == "command_channels")
    }

    /// The first part of a case's id: nothing for a frame, else the kind and the members that
    /// lead there.
    pub(super) fn label(&self) -> String {
        if !self.is_nested() {
            return String::new();
        }
        let members = self.path.iter().filter(|part| !matches!(part.as_str(), "0" | "a"));
        let parts: Vec<&str> = std::iter::once(self.kind).chain(members.map(String::as_str)).collect();
        parts.join("/") + "/"
    }

    /// A member of the message, as a reader finds it from the frame: `channels.a.unit`.
    pub(super) fn member(&self, name: &str) -> String {
        let mut out = String::new();
        for part in &self.path {
            match part.as_str() {
                "0" => out.push_str("[0]"),
                part => {
                    out.push_str(if out.is_empty() { "" } else { "." });
                    out.push_str(part);
                }
            }
        }
        if !out.is_empty() && !name.is_empty() {
            out.push('.');
        }
        out + name
    }

    /// The member as a JSON pointer from the frame.
    pub(super) fn pointer(&self, name: &str) -> String {
        self.path.iter().map(String::as_str).chain([name]).map(|part| format!("/{part}")).collect()
    }

    /// The message alone, on that ground.
    pub(super) fn alone(&self, ground: Ground) -> Json {
        match (self.is_nested(), ground) {
            (false, Ground::Minimal) => model::minimal(self.kind),
            (false, Ground::Explicit) => model::explicit(self.kind),
            (true, Ground::Minimal) => Json::object(),
            (true, Ground::Explicit) => model::explicit_message(&self.message.name),
        }
    }

    /// A frame with that in the message's place.
    pub(super) fn frame(&self, ground: Ground, message: Json) -> Json {
        if !self.is_nested() {
            return message;
        }
        let frame = match ground {
            Ground::Minimal => model::minimal(self.kind),
            Ground::Explicit => model::explicit(self.kind),
        };
        let Some(host) = tables().kind(self.kind) else {
            return frame;
        };
        put(host, frame, &self.path, message, ground)
    }

    /// What the text says that the frame means.
    pub(super) fn meaning(&self, frame: &Json) -> String {
        model::meaning(self.kind, frame).text()
    }
}

/// Puts `leaf` where `path` leads to from `object`, with what must surround it.
pub(super) fn put(message: &Message, object: Json, path: &[String], leaf: Json, ground: Ground) -> Json {
    let Some((name, rest)) = path.split_first() else {
        return leaf;
    };
    let Some(field) = message.field(name) else {
        return object;
    };
    object.with(name, wrap(&field.shape, rest, leaf, ground))
}

fn wrap(shape: &Shape, path: &[String], leaf: Json, ground: Ground) -> Json {
    match (shape, path) {
        (_, []) => leaf,
        (Shape::List(item), [_, rest @ ..]) => Json::Array(vec![wrap(item, rest, leaf, ground)]),
        (Shape::Map(value), [key, rest @ ..]) => Json::object().with(key, wrap(value, rest, leaf, ground)),
        (Shape::Message(name), _) => {
            let Some(message) = tables().message(name) else {
                return leaf;
            };
            let object = match ground {
                Ground::Minimal => Json::object(),
                Ground::Explicit => model::explicit_message(name),
            };
            put(message, object, path, leaf, ground)
        }
        _ => leaf,
    }
}
