//! JSON Schemas (draft 2020-12) of every kind, made from the proto and its projection.
//!
//! A schema file stands alone: whatever it refers to is in its own `$defs`, so a validator needs
//! one file and no network. It describes what a receiver must accept, and says as much of it as
//! JSON Schema can; [`GAPS`] lists the rest. The descriptions are the comments of the proto.

use std::collections::BTreeMap;

use serde_json::{Map, Value, json};

use crate::{
    contract::{Contract, EnumShape, FieldShape, MessageShape},
    projection::{Encoding, FieldProjection, JsonForm, JsonType, MessageProjection, Shape, Unknown},
};

/// The schema files of this build as (file name, text), a file a kind and one for the error frame.
///
/// It is empty only if `projection.json` cannot be read, which [`crate::compat::check_current`]
/// reports and the tests rule out.
pub fn generate() -> Vec<(String, String)> {
    Contract::current().map(|contract| generate_from(&contract)).unwrap_or_default()
}

/// The schema files of a contract, as [`generate`] makes them of the current one.
///
/// A field without a projection has no place in the schema; [`Contract::disagreements`] reports it.
pub fn generate_from(contract: &Contract) -> Vec<(String, String)> {
    let kinds = contract.kinds().map(|(kind, message, projected)| {
        let generator = Generator { contract, defs: BTreeMap::new() };
        (kind.to_owned(), generator.file(kind, message, projected))
    });
    let error = error_frame(contract);
    kinds
        .chain(error.iter().map(|(kind, message)| {
            let generator = Generator { contract, defs: BTreeMap::new() };
            (kind.clone(), generator.file(kind, message, &contract.projection.error_frame))
        }))
        .map(|(kind, schema)| (format!("{kind}.schema.json"), format!("{schema:#}\n")))
        .collect()
}

/// A rule that no JSON Schema can state, so that a schema lets through what a receiver must reject.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Gap {
    /// Its name.
    pub name: &'static str,
    /// The requirements concerned. One that ends in `-` stands for all that begin so.
    pub requirements: &'static [&'static str],
    /// Why a schema cannot say it.
    pub reason: &'static str,
}

/// Everything that the schemas leave to a decoder.
pub const GAPS: &[Gap] = &[
    Gap {
        name: "text",
        requirements: &["NCP-WIRE-001", "NCP-WIRE-002", "NCP-WIRE-004", "NCP-WIRE-006", "NCP-WIRE-008"],
        reason: "A schema judges a JSON value; that the bytes are one JSON text in UTF-8 is its parser's business.",
    },
    Gap {
        name: "duplicate-members",
        requirements: &["NCP-WIRE-007"],
        reason: "The value that a parser hands over has each member once, whichever it kept.",
    },
    Gap {
        name: "integer-spelling",
        requirements: &["NCP-WIRE-010"],
        reason: "To a schema 1.0, 1e0 and 1 are one integer, and -0 is 0.",
    },
    Gap {
        name: "double-range",
        requirements: &["NCP-WIRE-013", "NCP-WIRE-014"],
        reason: "Parsers refuse a number beyond a double, or read it as infinite or as exact, before a schema sees it.",
    },
    Gap {
        name: "frame-bytes",
        requirements: &["NCP-WIRE-060", "NCP-WIRE-062", "NCP-WIRE-070"],
        reason: "A schema does not see the bytes of the frame.",
    },
    Gap {
        name: "levels",
        requirements: &["NCP-WIRE-064"],
        reason: "A schema cannot count levels in members that it does not know.",
    },
    Gap {
        name: "segment-bytes",
        requirements: &["NCP-KEY-017"],
        reason: "maxLength counts code points, and a segment of 256 of them may have up to 1,024 bytes.",
    },
    Gap {
        name: "stimulus-fits-request",
        requirements: &["NCP-WIRE-037", "NCP-WIRE-038"],
        reason: "A schema cannot compare two members of the same frame.",
    },
    Gap {
        name: "block",
        requirements: &["NCP-BULK-", "NCP-OBS-"],
        reason: "A schema does not look into the base64 of a BulkBlock.",
    },
];

/// The gap that a requirement falls into: a frame that breaks only such requirements may satisfy
/// its schema.
pub fn gap(requirement: &str) -> Option<&'static Gap> {
    let concerns = |pattern: &&str| {
        if pattern.ends_with('-') { requirement.starts_with(pattern) } else { requirement == *pattern }
    };
    GAPS.iter().find(|gap| gap.requirements.iter().any(concerns))
}

/// Makes one file, and collects what it refers to.
struct Generator<'a> {
    contract: &'a Contract,
    /// By name; `null` while the definition is being made.
    defs: BTreeMap<String, Value>,
}

impl Generator<'_> {
    fn file(mut self, kind: &str, message: &MessageShape, projected: &MessageProjection) -> Value {
        let projection = &self.contract.projection;
        let mut schema = Map::new();
        schema.insert("$schema".into(), "https://json-schema.org/draft/2020-12/schema".into());
        schema.insert("$id".into(), format!("urn:ncp:{}:{kind}", projection.wire).into());
        schema.insert("$comment".into(), comment(kind, self.contract, projected).into());
        schema.insert("title".into(), message.name.as_str().into());
        schema.insert("description".into(), message.doc.as_str().into());
        schema.append(&mut self.object(message, projected, &[]));
        if !self.defs.is_empty() {
            schema.insert("$defs".into(), Value::Object(self.defs.into_iter().collect()));
        }
        Value::Object(schema)
    }

    /// The assertions about an object. Members that the contract does not have are allowed.
    /// [NCP-WIRE-026]
    fn object(
        &mut self,
        message: &MessageShape,
        projected: &MessageProjection,
        may_be_absent: &[String],
    ) -> Map<String, Value> {
        let fields = message.fields.iter().filter_map(|field| Some((field, projected.fields.get(&field.name)?)));
        let properties: Map<_, _> =
            fields.map(|(field, projected)| (field.name.clone(), self.property(field, projected))).collect();
        let required: Vec<_> =
            projected.required.iter().filter(|name| !may_be_absent.contains(name)).cloned().collect();
        let mut object = Map::new();
        object.insert("type".into(), "object".into());
        if !required.is_empty() {
            object.insert("required".into(), required.into());
        }
        object.insert("properties".into(), properties.into());
        object
    }

    fn property(&mut self, field: &FieldShape, projected: &FieldProjection) -> Value {
        let mut property = Map::new();
        if !field.doc.is_empty() {
            property.insert("description".into(), field.doc.as_str().into());
        }
        match &projected.pinned {
            Some(pinned) => _ = property.insert("const".into(), pinned.clone()),
            None => property.append(&mut self.field_type(projected)),
        }
        if let Some(default) = &projected.default {
            property.insert("default".into(), default.clone());
        }
        Value::Object(property)
    }

    fn field_type(&mut self, projected: &FieldProjection) -> Map<String, Value> {
        if projected.segment {
            return self.segment();
        }
        let JsonType { shape, nullable } = &projected.ty;
        let mut schema = self.shape(shape);
        if projected.encoding == Some(Encoding::Base64) {
            schema.insert("contentEncoding".into(), "base64".into());
            schema.insert("pattern".into(), "^([A-Za-z0-9+/]{4})*([A-Za-z0-9+/]{2}==|[A-Za-z0-9+/]{3}=)?$".into());
        }
        if !nullable {
            return schema;
        }
        match schema.get_mut("type") {
            // [NCP-WIRE-022]
            Some(ty) => {
                *ty = json!([ty.take(), "null"]);
                schema
            }
            None => object([("anyOf", json!([schema, {"type": "null"}]))]),
        }
    }

    fn shape(&mut self, shape: &Shape) -> Map<String, Value> {
        let limits = &self.contract.projection.limits;
        let (entries, items) = (limits.entries, limits.items);
        match shape {
            Shape::Integer => self.integer(),
            Shape::Number => object([("type", "number".into())]),
            Shape::String => object([("type", "string".into())]),
            Shape::Boolean => object([("type", "boolean".into())]),
            Shape::Named(name) => self.named(name),
            Shape::Array(inner) => {
                let mut array = object([("type", "array".into()), ("items", self.shape(inner).into())]);
                // [NCP-WIRE-067] [NCP-WIRE-069]
                if !shape.is_numeric_array() {
                    array.insert("maxItems".into(), items.into());
                }
                array
            }
            Shape::Map(inner) => object([
                ("type", "object".into()),
                ("additionalProperties", self.shape(inner).into()),
                ("maxProperties", entries.into()), // [NCP-WIRE-066]
            ]),
        }
    }

    fn named(&mut self, name: &str) -> Map<String, Value> {
        let contract = self.contract;
        if let Some(item) = contract.enumeration(name) {
            return self.define(name, |_| enumeration(contract, item).into());
        }
        let Some((message, projected)) = contract.message(name).zip(contract.projection.messages.get(name)) else {
            return Map::new();
        };
        // A message that has a kind stands inside another only in a request. [NCP-WIRE-035]
        match &projected.inside_request {
            Some(inside) => self.define(&format!("{name}InsideRequest"), |this| {
                let doc =
                    format!("{} Inside a request {} may be left out.", message.doc, inside.may_be_absent.join(", "));
                this.definition(&doc, message, projected, &inside.may_be_absent)
            }),
            None => self.define(name, |this| this.definition(&message.doc, message, projected, &[])),
        }
    }

    fn definition(
        &mut self,
        doc: &str,
        message: &MessageShape,
        projected: &MessageProjection,
        may_be_absent: &[String],
    ) -> Value {
        let mut definition = object([("description", doc.into())]);
        definition.append(&mut self.object(message, projected, may_be_absent));
        Value::Object(definition)
    }

    fn integer(&mut self) -> Map<String, Value> {
        // [NCP-WIRE-011] The limit is far below i64::MAX, so that the negation cannot overflow.
        let limit = i64::try_from(self.contract.projection.limits.integer).unwrap_or(i64::MAX);
        self.define("integer", |_| {
            json!({
                "description": "An integer that every double can hold, spelled without fraction or exponent.",
                "type": "integer", "minimum": -limit, "maximum": limit,
            })
        })
    }

    /// [NCP-KEY-010] to [NCP-KEY-017], as far as code points tell. Patterns of what is forbidden
    /// read alike in every dialect of regular expressions; one anchored pattern of what is allowed
    /// does not.
    fn segment(&mut self) -> Map<String, Value> {
        let bytes = self.contract.projection.limits.segment_bytes;
        self.define("segment", |_| {
            json!({
                "description": format!("One segment of a key, at most {bytes} bytes of UTF-8."),
                "type": "string", "minLength": 1, "maxLength": bytes,
                "not": {"anyOf": [
                    {"description": "A separator, a wildcard, white space or a control character.",
                        "pattern": r"[/*$#?\u0000-\u0020\u007f-\u009f]"},
                    {"description": "Hidden from wildcards.", "pattern": "^@"},
                    {"description": "A path's own and parent folder.", "enum": [".", ".."]},
                ]},
            })
        })
    }

    /// A reference to a definition, which is made on first use.
    fn define(&mut self, name: &str, make: impl FnOnce(&mut Self) -> Value) -> Map<String, Value> {
        if !self.defs.contains_key(name) {
            self.defs.insert(name.to_owned(), Value::Null);
            let definition = make(self);
            self.defs.insert(name.to_owned(), definition);
        }
        object([("$ref", format!("#/$defs/{name}").into())])
    }
}

/// The known wire strings with their comments, and what any other string means.
fn enumeration(contract: &Contract, item: &EnumShape) -> Map<String, Value> {
    let Some(projected) = contract.projection.enums.get(&item.name) else {
        return object([("type", "string".into())]);
    };
    let mut choices: Vec<Value> = item
        .values
        .iter()
        .filter_map(|value| Some(json!({"const": projected.values.get(&value.name)?, "description": value.doc})))
        .collect();
    match &projected.unknown {
        // [NCP-WIRE-042]
        Unknown::Keep => {
            choices.push(json!({"type": "string", "description": "Any other string: kept, and written unchanged."}));
        }
        // [NCP-WIRE-041]
        Unknown::ReadAs(string) => {
            choices.push(json!({"type": "string", "description": format!("Any other string: read as `{string}`.")}));
        }
        // [NCP-WIRE-044]
        Unknown::Reject => {}
    }
    object([("description", item.doc.as_str().into()), ("anyOf", choices.into())])
}

/// The error frame as a message, so that it is made like the others; the proto has none. `None`
/// without a kind.
fn error_frame(contract: &Contract) -> Option<(String, MessageShape)> {
    let projected = &contract.projection.error_frame;
    let doc = |name: &str| match name {
        "kind" => "Always `error`.",
        "error" => "What went wrong, for people.",
        "session_id" => "The session that it concerns. Left out when there is none.",
        _ => "",
    };
    // `kind` first, then in the order of the required ones, then the rest. [NCP-WIRE-102]
    let rest = projected.fields.keys().filter(|name| !projected.required.contains(name));
    let fields = projected.required.iter().chain(rest).map(|name| FieldShape {
        name: name.clone(),
        number: 0,
        ty: crate::contract::FieldType::One(crate::contract::ElementType::Scalar("string")),
        json_name: name.clone(),
        oneof: None,
        doc: doc(name).to_owned(),
    });
    let message = MessageShape {
        name: crate::contract::ERROR_FRAME.to_owned(),
        doc: "Control plane, server to commander: the reply to a request that cannot be served.".to_owned(),
        fields: fields.collect(),
        reserved: Default::default(),
    };
    Some((projected.kind.clone()?, message))
}

fn comment(kind: &str, contract: &Contract, projected: &MessageProjection) -> String {
    let limits = &contract.projection.limits;
    let bytes = limits.frame_bytes_of.get(kind).unwrap_or(&limits.frame_bytes);
    let form = match projected.json_form {
        JsonForm::Normal => "",
        JsonForm::Optional => " The contract has no JSON form of this kind; this is the one that a peer may offer.",
    };
    format!(
        "Generated from proto/ncp.proto and proto/projection.json; do not edit.{form} \
         Only a decoder can check what a schema \
         cannot: at most {bytes} bytes and {} levels, no member twice, integers without fraction or exponent; \
         README.md has the whole list.",
        limits.levels
    )
}

fn object<const N: usize>(members: [(&str, Value); N]) -> Map<String, Value> {
    members.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
}
