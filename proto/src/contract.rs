//! The contract as one model: what the proto declares, and beside it how that travels as JSON.
//!
//! A [`Contract`] is made from two inputs, an encoded descriptor set (or a buf image) and the text
//! of a projection. [`Contract::disagreements`] holds the two
//! against each other: what the tables of the text say of a field has to fit the proto.

use std::{collections::BTreeSet, fmt};

use prost::Message as _;
use prost_types::{
    DescriptorProto, EnumDescriptorProto, FieldDescriptorProto, FileDescriptorProto, FileDescriptorSet,
    ServiceDescriptorProto,
    field_descriptor_proto::{Label, Type},
};
use serde_json::{Map, Value};
use thiserror::Error;

use crate::projection::{Encoding, FieldProjection, MessageProjection, Projection, Shape, Unknown};

/// The name of the error frame in diagnostics; the proto has no message of that name.
pub const ERROR_FRAME: &str = "RPC error frame";

/// A proto and its projection.
#[derive(Clone, Debug)]
pub struct Contract {
    /// The package, `ncp.v0`.
    pub package: String,
    /// The syntax, `proto3`.
    pub syntax: String,
    /// The messages in declaration order, map entries left out.
    pub messages: Vec<MessageShape>,
    /// The enums in declaration order.
    pub enums: Vec<EnumShape>,
    /// The services in declaration order.
    pub services: Vec<ServiceShape>,
    /// How all this travels as JSON.
    pub projection: Projection,
}

/// A message of the proto.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MessageShape {
    /// Its name within the package.
    pub name: String,
    /// Its comment.
    pub doc: String,
    /// Its fields in declaration order.
    pub fields: Vec<FieldShape>,
    /// What is reserved in it.
    pub reserved: Reserved,
}

/// A field of a message.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FieldShape {
    /// Its name.
    pub name: String,
    /// Its number on the protobuf wire.
    pub number: i32,
    /// Its type.
    pub ty: FieldType,
    /// Its name in protobuf's own JSON mapping.
    pub json_name: String,
    /// The oneof that it is in; a proto3 `optional` field is in one of its own.
    pub oneof: Option<String>,
    /// Its comment.
    pub doc: String,
}

/// The type of a field. It displays as the proto spells it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FieldType {
    /// One value.
    One(ElementType),
    /// Any number of values.
    Repeated(ElementType),
    /// A map from the first to the second.
    Map(ElementType, ElementType),
}

/// The type of a value. It displays as the proto spells it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ElementType {
    /// A scalar such as `int64`.
    Scalar(&'static str),
    /// A message, by its name within the package.
    Message(String),
    /// An enum, by its name within the package.
    Enum(String),
}

/// What a message or an enum reserves.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Reserved {
    /// Ranges of numbers, both ends included.
    pub numbers: Vec<(i32, i32)>,
    /// Names.
    pub names: BTreeSet<String>,
}

/// An enum of the proto.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EnumShape {
    /// Its name within the package.
    pub name: String,
    /// Its comment.
    pub doc: String,
    /// Its values in declaration order.
    pub values: Vec<ValueShape>,
    /// What is reserved in it.
    pub reserved: Reserved,
}

/// A value of an enum.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ValueShape {
    /// The proto constant.
    pub name: String,
    /// Its number.
    pub number: i32,
    /// Its comment.
    pub doc: String,
}

/// A service of the proto.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ServiceShape {
    /// Its name within the package.
    pub name: String,
    /// Its RPCs in declaration order.
    pub rpcs: Vec<RpcShape>,
}

/// An RPC of a service.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RpcShape {
    /// Its name.
    pub name: String,
    /// The message that it takes.
    pub request: String,
    /// The message that it returns.
    pub response: String,
    /// Whether the client sends a stream.
    pub client_streaming: bool,
    /// Whether the server sends a stream.
    pub server_streaming: bool,
}

/// A contract that cannot be read.
#[derive(Debug, Error)]
pub enum ContractError {
    /// The descriptor set or image is not one.
    #[error("the descriptor set cannot be decoded: {0}")]
    Descriptor(#[from] prost::DecodeError),
    /// The contract is one file; there are none or several.
    #[error("the descriptor set holds {0} files, expected one")]
    Files(usize),
    /// A field whose descriptor says no known type.
    #[error("field {0} has no known type")]
    FieldType(String),
    /// The projection is not JSON, or not of the format of `projection.schema.json`.
    #[error("the projection cannot be read: {0}")]
    Projection(#[from] serde_json::Error),
}

/// One place where the projection does not fit the proto.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{place}: {problem}")]
pub struct Disagreement {
    /// Where, as in [`crate::compat::Violation::place`].
    pub place: String,
    /// What does not fit.
    pub problem: String,
}

impl Contract {
    /// Reads a contract from an encoded descriptor set (or buf image) of one file, and the text of
    /// its projection.
    ///
    /// # Errors
    /// When one of the two cannot be read. That they fit each other is [`Contract::disagreements`]' business.
    pub fn new(descriptor_set: &[u8], projection: &str) -> Result<Self, ContractError> {
        let set = FileDescriptorSet::decode(descriptor_set)?;
        let [file] = &set.file[..] else {
            return Err(ContractError::Files(set.file.len()));
        };
        let reader = Reader { file };
        let mut messages = Vec::new();
        let mut enums = Vec::new();
        for (index, message) in (0..).zip(&file.message_type) {
            reader.message(message, "", &[4, index], &mut messages, &mut enums)?;
        }
        enums.extend((0..).zip(&file.enum_type).map(|(index, item)| reader.enumeration(item, "", &[5, index])));
        Ok(Self {
            package: file.package().to_owned(),
            // A descriptor leaves the syntax out when it is proto2.
            syntax: file.syntax.clone().unwrap_or_else(|| "proto2".to_owned()),
            messages,
            enums,
            services: file.service.iter().map(|service| reader.service(service)).collect(),
            projection: serde_json::from_str(projection)?,
        })
    }

    /// The contract of this build.
    ///
    /// # Errors
    /// When the projection cannot be read; the tests rule it out for a build that they passed.
    pub fn current() -> Result<Self, ContractError> {
        Self::new(crate::DESCRIPTOR_SET, &crate::PROJECTION_TEXT)
    }

    /// The frozen contract.
    ///
    /// # Errors
    /// When a file of the baseline cannot be read; the tests rule it out for a build that they passed.
    pub fn baseline() -> Result<Self, ContractError> {
        Self::new(crate::BASELINE_IMAGE, crate::BASELINE_PROJECTION)
    }

    /// The message of this name.
    pub fn message(&self, name: &str) -> Option<&MessageShape> {
        self.messages.iter().find(|message| message.name == name)
    }

    /// The enum of this name.
    pub fn enumeration(&self, name: &str) -> Option<&EnumShape> {
        self.enums.iter().find(|item| item.name == name)
    }

    /// The messages that are frames of their own, with their kinds, in declaration order.
    pub fn kinds(&self) -> impl Iterator<Item = (&str, &MessageShape, &MessageProjection)> {
        self.messages.iter().filter_map(|message| {
            let projected = self.projection.messages.get(&message.name)?;
            Some((projected.kind.as_deref()?, message, projected))
        })
    }

    /// Everywhere that the projection does not fit the proto. Empty for a sound contract.
    pub fn disagreements(&self) -> Vec<Disagreement> {
        let mut audit = Audit { contract: self, found: Vec::new() };
        audit.run();
        audit.found
    }

    /// The JSON type that a field of this proto type has.
    fn image(&self, ty: &FieldType) -> Shape {
        match ty {
            FieldType::One(element) => self.element_image(element),
            FieldType::Repeated(element) => Shape::Array(Box::new(self.element_image(element))),
            FieldType::Map(_, element) => Shape::Map(Box::new(self.element_image(element))),
        }
    }

    fn element_image(&self, ty: &ElementType) -> Shape {
        match ty {
            ElementType::Scalar("double" | "float") => Shape::Number,
            ElementType::Scalar("bool") => Shape::Boolean,
            ElementType::Scalar("string" | "bytes") => Shape::String,
            ElementType::Scalar(_) => Shape::Integer,
            ElementType::Enum(name) => Shape::Named(name.clone()),
            ElementType::Message(name) => {
                // [NCP-WIRE-051] A transparent message is its one field.
                let transparent = self.projection.messages.get(name).filter(|message| message.transparent);
                match transparent.and_then(|message| message.fields.values().next()) {
                    Some(field) => field.ty.shape.clone(),
                    None => Shape::Named(name.clone()),
                }
            }
        }
    }
}

/// Reads the parts of a descriptor.
struct Reader<'a> {
    file: &'a FileDescriptorProto,
}

impl Reader<'_> {
    fn message(
        &self,
        message: &DescriptorProto,
        outer: &str,
        path: &[i32],
        messages: &mut Vec<MessageShape>,
        enums: &mut Vec<EnumShape>,
    ) -> Result<(), ContractError> {
        let name = nested(outer, message.name());
        let mut fields = Vec::new();
        for (index, field) in (0..).zip(&message.field) {
            fields.push(FieldShape {
                name: field.name().to_owned(),
                number: field.number(),
                ty: self.field_type(field, message)?,
                json_name: field.json_name().to_owned(),
                oneof: usize::try_from(field.oneof_index.unwrap_or(-1))
                    .ok()
                    .and_then(|index| message.oneof_decl.get(index))
                    .map(|oneof| oneof.name().to_owned()),
                doc: self.doc(path, &[2, index]),
            });
        }
        messages.push(MessageShape {
            doc: self.doc(path, &[]),
            fields,
            reserved: Reserved {
                // A message's ranges exclude their end in the descriptor.
                numbers: message
                    .reserved_range
                    .iter()
                    .map(|range| (range.start(), range.end().saturating_sub(1)))
                    .collect(),
                names: message.reserved_name.iter().cloned().collect(),
            },
            name: name.clone(),
        });
        for (index, inner) in (0..).zip(&message.nested_type) {
            if !is_map_entry(inner) {
                self.message(inner, &name, &[path, &[3, index]].concat(), messages, enums)?;
            }
        }
        enums.extend(
            (0..)
                .zip(&message.enum_type)
                .map(|(index, item)| self.enumeration(item, &name, &[path, &[4, index]].concat())),
        );
        Ok(())
    }

    fn enumeration(&self, item: &EnumDescriptorProto, outer: &str, path: &[i32]) -> EnumShape {
        EnumShape {
            name: nested(outer, item.name()),
            doc: self.doc(path, &[]),
            values: (0..)
                .zip(&item.value)
                .map(|(index, value)| ValueShape {
                    name: value.name().to_owned(),
                    number: value.number(),
                    doc: self.doc(path, &[2, index]),
                })
                .collect(),
            reserved: Reserved {
                numbers: item.reserved_range.iter().map(|range| (range.start(), range.end())).collect(),
                names: item.reserved_name.iter().cloned().collect(),
            },
        }
    }

    fn service(&self, service: &ServiceDescriptorProto) -> ServiceShape {
        let rpcs = service.method.iter().map(|method| RpcShape {
            name: method.name().to_owned(),
            request: self.within_package(method.input_type()),
            response: self.within_package(method.output_type()),
            client_streaming: method.client_streaming(),
            server_streaming: method.server_streaming(),
        });
        ServiceShape { name: service.name().to_owned(), rpcs: rpcs.collect() }
    }

    fn field_type(&self, field: &FieldDescriptorProto, message: &DescriptorProto) -> Result<FieldType, ContractError> {
        let entry = message
            .nested_type
            .iter()
            .find(|inner| is_map_entry(inner) && field.type_name().ends_with(&format!(".{}", inner.name())));
        if let Some([key, value]) = entry.map(|entry| &entry.field[..]) {
            return Ok(FieldType::Map(self.element_type(key)?, self.element_type(value)?));
        }
        let element = self.element_type(field)?;
        Ok(if field.label() == Label::Repeated { FieldType::Repeated(element) } else { FieldType::One(element) })
    }

    fn element_type(&self, field: &FieldDescriptorProto) -> Result<ElementType, ContractError> {
        let unknown = || ContractError::FieldType(field.name().to_owned());
        Ok(match Type::try_from(field.r#type.unwrap_or_default()).map_err(|_| unknown())? {
            Type::Message => ElementType::Message(self.within_package(field.type_name())),
            Type::Enum => ElementType::Enum(self.within_package(field.type_name())),
            Type::Group => return Err(unknown()),
            Type::Double => ElementType::Scalar("double"),
            Type::Float => ElementType::Scalar("float"),
            Type::Int64 => ElementType::Scalar("int64"),
            Type::Uint64 => ElementType::Scalar("uint64"),
            Type::Int32 => ElementType::Scalar("int32"),
            Type::Uint32 => ElementType::Scalar("uint32"),
            Type::Sint32 => ElementType::Scalar("sint32"),
            Type::Sint64 => ElementType::Scalar("sint64"),
            Type::Fixed64 => ElementType::Scalar("fixed64"),
            Type::Fixed32 => ElementType::Scalar("fixed32"),
            Type::Sfixed32 => ElementType::Scalar("sfixed32"),
            Type::Sfixed64 => ElementType::Scalar("sfixed64"),
            Type::Bool => ElementType::Scalar("bool"),
            Type::String => ElementType::Scalar("string"),
            Type::Bytes => ElementType::Scalar("bytes"),
        })
    }

    /// A type's name without the package.
    fn within_package(&self, full: &str) -> String {
        let package = format!(".{}.", self.file.package());
        full.strip_prefix(&package).unwrap_or(full).to_owned()
    }

    /// The comment at a path of the descriptor, on one line.
    fn doc(&self, path: &[i32], inner: &[i32]) -> String {
        let path = [path, inner].concat();
        let locations = self.file.source_code_info.iter().flat_map(|info| &info.location);
        let comment = locations
            .filter(|location| location.path == path)
            .find_map(|location| location.leading_comments.as_deref());
        comment.unwrap_or_default().split_whitespace().collect::<Vec<_>>().join(" ")
    }
}

/// Holds a projection against its proto.
struct Audit<'a> {
    contract: &'a Contract,
    found: Vec<Disagreement>,
}

impl Audit<'_> {
    fn run(&mut self) {
        let Contract { package, messages, enums, projection, .. } = self.contract;
        if projection.format != 1 {
            self.say("projection", format!("format {} is not known, only 1 is", projection.format));
        }
        if projection.package != *package {
            self.say("projection", format!("is of package {:?}, the proto is {package:?}", projection.package));
        }
        for item in enums {
            self.enumeration(item);
        }
        for name in projection.enums.keys().filter(|name| self.contract.enumeration(name).is_none()) {
            self.say(&format!("enum {name}"), "is projected, but the proto has none");
        }
        let mut kinds = BTreeSet::new();
        for message in messages {
            let place = format!("message {}", message.name);
            let Some(projected) = projection.messages.get(&message.name) else {
                self.say(&place, "has no projection");
                continue;
            };
            if let Some(kind) = &projected.kind
                && !kinds.insert(kind)
            {
                self.say(&place, format!("shares the kind {kind:?} with another message"));
            }
            for field in &message.fields {
                let place = format!("{place}, field {}", field.name);
                match projected.fields.get(&field.name) {
                    None => self.say(&place, "has no projection"),
                    Some(projection) => self.field_fits_proto(&place, field, projection),
                }
            }
            for name in projected.fields.keys().filter(|name| message.fields.iter().all(|field| field.name != **name)) {
                self.say(&format!("{place}, field {name}"), "is projected, but the proto has none");
            }
            self.message(&place, projected);
        }
        for name in projection.messages.keys().filter(|name| self.contract.message(name).is_none()) {
            self.say(&format!("message {name}"), "is projected, but the proto has none");
        }
        self.message(ERROR_FRAME, &projection.error_frame);
        for kind in projection.limits.frame_bytes_of.keys().filter(|kind| !kinds.contains(kind)) {
            self.say("limits", format!("frame_bytes_of names {kind:?}, which is no kind"));
        }
    }

    fn enumeration(&mut self, item: &EnumShape) {
        let place = format!("enum {}", item.name);
        let Some(projected) = self.contract.projection.enums.get(&item.name) else {
            self.say(&place, "has no projection");
            return;
        };
        for value in &item.values {
            match (value.number, projected.values.contains_key(&value.name)) {
                (0, true) => self
                    .say(&format!("{place}, value {}", value.name), "is the zero constant, which has no wire string"),
                (0, false) | (_, true) => {}
                (_, false) => self.say(&format!("{place}, value {}", value.name), "has no wire string"),
            }
        }
        for name in projected.values.keys().filter(|name| item.values.iter().all(|value| value.name != **name)) {
            self.say(&format!("{place}, value {name}"), "is projected, but the proto has none");
        }
        let mut strings = BTreeSet::new();
        for (name, string) in &projected.values {
            if !strings.insert(string) {
                self.say(
                    &format!("{place}, value {name}"),
                    format!("shares the wire string {string:?} with another value"),
                );
            }
        }
        if let Unknown::ReadAs(string) = &projected.unknown
            && !strings.contains(string)
        {
            self.say(&place, format!("reads an unknown string as {string:?}, which is no wire string of it"));
        }
    }

    fn field_fits_proto(&mut self, place: &str, field: &FieldShape, projected: &FieldProjection) {
        let expected = self.contract.image(&field.ty);
        if projected.ty.shape != expected {
            self.say(
                place,
                format!(
                    "is {} on JSON, but {} in the proto, which is {expected} on JSON",
                    projected.ty.shape, field.ty
                ),
            );
        }
        let bytes = field.ty == FieldType::One(ElementType::Scalar("bytes"));
        if bytes != (projected.encoding == Some(Encoding::Base64)) {
            self.say(place, "is bytes without an encoding, or has an encoding without being bytes");
        }
    }

    fn message(&mut self, place: &str, projected: &MessageProjection) {
        if projected.transparent && projected.fields.len() != 1 {
            self.say(place, "is transparent, but has not exactly one field");
        }
        for name in &projected.required {
            if !projected.fields.contains_key(name) {
                self.say(&format!("{place}, field {name}"), "is required, but there is none");
            }
        }
        let inside = projected
            .inside_request
            .iter()
            .flat_map(|inside| inside.may_be_absent.iter().chain(&inside.same_as_request));
        for name in inside.filter(|name| !projected.fields.contains_key(*name)) {
            self.say(&format!("{place}, field {name}"), "is named for frames inside a request, but there is none");
        }
        if let Some(kind) = &projected.kind {
            let pinned = projected.fields.get("kind").and_then(|field| field.pinned.as_ref());
            if pinned != Some(&Value::from(kind.as_str())) {
                self.say(&format!("{place}, field kind"), format!("is not pinned to {kind:?}"));
            }
            if !projected.required.iter().any(|name| name == "kind") {
                self.say(&format!("{place}, field kind"), "is not required"); // [NCP-WIRE-028]
            }
        }
        for (name, field) in &projected.fields {
            let place = format!("{place}, field {name}");
            let required = projected.required.contains(name);
            if required && field.default.is_some() {
                self.say(&place, "is required and has a default");
            }
            if !required && !projected.transparent && field.default.is_none() {
                self.say(&place, "is neither required nor has a default");
            }
            if let Some(name) = named(&field.ty.shape)
                && self.contract.message(name).is_none()
                && self.contract.enumeration(name).is_none()
            {
                self.say(&place, format!("is of type {name}, which the proto does not have"));
            }
            if field.segment && field.ty.shape != Shape::String {
                self.say(&place, "is a key segment, but not a string");
            }
            for (what, value) in [("default", &field.default), ("built", &field.built), ("pinned", &field.pinned)] {
                if let Some(value) = value
                    && !self.has_type(value, field, what)
                {
                    self.say(&place, format!("{what} {value} is not of type {}", field.ty));
                }
            }
            if let (Some(pinned), Some(default)) = (&field.pinned, &field.default)
                && pinned != default
            {
                self.say(&place, format!("is pinned to {pinned}, but defaults to {default}")); // [NCP-PROV-005]
            }
        }
    }

    fn has_type(&self, value: &Value, field: &FieldProjection, what: &str) -> bool {
        match value {
            Value::Null => field.ty.nullable && what != "pinned",
            // An optional field that is absent has no other default: null and absent are one.
            // [NCP-WIRE-022]
            _ if what == "default" && field.ty.nullable => false,
            _ => self.has_shape(value, &field.ty.shape),
        }
    }

    fn has_shape(&self, value: &Value, shape: &Shape) -> bool {
        match shape {
            Shape::Integer => value.is_i64(),
            Shape::Number => value.is_f64(),
            Shape::String => value.is_string(),
            Shape::Boolean => value.is_boolean(),
            Shape::Array(items) => {
                value.as_array().is_some_and(|array| array.iter().all(|item| self.has_shape(item, items)))
            }
            Shape::Map(values) => {
                value.as_object().is_some_and(|map| map.values().all(|item| self.has_shape(item, values)))
            }
            Shape::Named(name) => {
                match (self.contract.projection.enums.get(name), self.contract.projection.messages.get(name)) {
                    (Some(item), _) => {
                        value.as_str().is_some_and(|string| item.values.values().any(|known| known == string))
                    }
                    // The default of a message is the message of all defaults.
                    (None, Some(message)) => value.as_object().is_some_and(|object| is_all_defaults(object, message)),
                    (None, None) => false,
                }
            }
        }
    }

    fn say(&mut self, place: &str, problem: impl Into<String>) {
        self.found.push(Disagreement { place: place.to_owned(), problem: problem.into() });
    }
}

fn is_all_defaults(object: &Map<String, Value>, message: &MessageProjection) -> bool {
    object.len() == message.fields.len()
        && message.fields.iter().all(|(name, field)| field.default.as_ref() == object.get(name))
}

fn named(shape: &Shape) -> Option<&str> {
    match shape {
        Shape::Named(name) => Some(name),
        Shape::Array(inner) | Shape::Map(inner) => named(inner),
        Shape::Integer | Shape::Number | Shape::String | Shape::Boolean => None,
    }
}

fn nested(outer: &str, name: &str) -> String {
    if outer.is_empty() { name.to_owned() } else { format!("{outer}.{name}") }
}

fn is_map_entry(message: &DescriptorProto) -> bool {
    message.options.as_ref().is_some_and(|options| options.map_entry())
}

impl Reserved {
    /// Whether this number is reserved.
    pub fn holds_number(&self, number: i32) -> bool {
        self.numbers.iter().any(|(first, last)| (*first..=*last).contains(&number))
    }
}

impl RpcShape {
    /// The signature as the proto spells it.
    pub fn signature(&self) -> String {
        let stream = |streaming| if streaming { "stream " } else { "" };
        format!(
            "({}{}) returns ({}{})",
            stream(self.client_streaming),
            self.request,
            stream(self.server_streaming),
            self.response
        )
    }
}

impl fmt::Display for FieldType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::One(element) => write!(f, "{element}"),
            Self::Repeated(element) => write!(f, "repeated {element}"),
            Self::Map(key, value) => write!(f, "map<{key}, {value}>"),
        }
    }
}

impl fmt::Display for ElementType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Scalar(name) => f.write_str(name),
            Self::Message(name) | Self::Enum(name) => f.write_str(name),
        }
    }
}
