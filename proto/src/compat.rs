//! The breaking check: what of a frozen contract would a change take away from the peers that speak
//! it?
//!
//! `buf breaking` compares protos. It cannot see wire strings, defaults, required fields or limits,
//! because they are no part of the proto text, and some of its categories let through what breaks
//! JSON peers. `proto/README.md` lists the evidence. This check compares two [`Contract`]s, proto
//! and projection alike, and reports each difference that a peer of the frozen one could notice,
//! with what stood there and what stands there now.
//!
//! Additions pass (receivers ignore what they don't know [NCP-WIRE-026]) unless an old peer would
//! reject the frame: a new required field, or a new value of an enum whose unknown strings are
//! rejected.

use std::{collections::BTreeMap, fmt};

use serde_json::Value;

use crate::{
    contract::{Contract, ERROR_FRAME, EnumShape, FieldShape, MessageShape, Reserved, ServiceShape},
    projection::{EnumProjection, FieldProjection, Limits, MessageProjection, Projection, Unknown},
};

/// One breaking change: what, where, what was there and what is there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Violation {
    /// The rule that it breaks.
    pub rule: Rule,
    /// Where, from the outside in: `message CommandFrame, field 7 ttl_ms`.
    pub place: String,
    /// What the frozen contract says.
    pub was: String,
    /// What the contract under check says.
    pub is: String,
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{} in {}", self.rule.code(), self.place)?;
        writeln!(f, "  was: {}", self.was)?;
        writeln!(f, "  is:  {}", self.is)?;
        write!(f, "  why: {}", self.rule.why())
    }
}

/// Holds the contract of this build against the frozen one.
///
/// Empty when nothing breaks. A contract that cannot be read is a violation of
/// [`Rule::Unreadable`].
pub fn check_current() -> Vec<Violation> {
    check_against(crate::BASELINE_IMAGE, crate::BASELINE_PROJECTION)
}

/// Holds the contract of this build against another: an image (or descriptor set) and the text of its projection.
///
/// As [`check_current`], which holds it against the frozen one.
pub fn check_against(image: &[u8], projection: &str) -> Vec<Violation> {
    match (Contract::new(image, projection), Contract::current()) {
        (Ok(baseline), Ok(current)) => check(&baseline, &current),
        (baseline, current) => [("frozen contract", baseline.err()), ("contract", current.err())]
            .into_iter()
            .filter_map(|(place, error)| Some(Violation::new(Rule::Unreadable, place, "readable", error?)))
            .collect(),
    }
}

/// Everything in `current` that breaks a peer of `baseline`, and everywhere that `current`
/// contradicts itself.
pub fn check(baseline: &Contract, current: &Contract) -> Vec<Violation> {
    let mut check = Check { found: Vec::new() };
    check.contract(baseline, current);
    check.projection(&baseline.projection, &as_the_frozen_wire(&current.projection, &baseline.projection));
    check.found.extend(current.disagreements().into_iter().map(|found| {
        Violation::new(Rule::ProjectionDisagrees, found.place, "a projection that fits the proto", found.problem)
    }));
    check.found
}

/// A wire with a version and a hash of its own is a new one, and not a change of the frozen one: it is seen with the
/// frozen identity, so that what it takes away is left.
fn as_the_frozen_wire(current: &Projection, frozen: &Projection) -> Projection {
    let mut seen = current.clone();
    if current.wire == frozen.wire || current.contract_hash == frozen.contract_hash {
        return seen;
    }
    let own = [(&current.wire, &frozen.wire), (&current.contract_hash, &frozen.contract_hash)];
    for field in seen.messages.values_mut().flat_map(|message| message.fields.values_mut()) {
        for value in [&mut field.default, &mut field.built].into_iter().flatten() {
            if let Some((_, frozen)) = own.iter().find(|(current, _)| value.as_str() == Some(current)) {
                *value = Value::from(frozen.as_str());
            }
        }
    }
    seen.wire.clone_from(&frozen.wire);
    seen.contract_hash.clone_from(&frozen.contract_hash);
    seen
}

macro_rules! rules {
    ($($(#[doc = $doc:literal])+ $name:ident $code:literal $why:literal;)+) => {
        /// What a change can break.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Rule {
            $($(#[doc = $doc])+ $name,)+
        }

        impl Rule {
            /// Every rule.
            pub const ALL: &'static [Self] = &[$(Self::$name),+];

            /// Its name in diagnostics.
            pub const fn code(self) -> &'static str {
                match self { $(Self::$name => $code,)+ }
            }

            /// Who is hurt, and how.
            pub const fn why(self) -> &'static str {
                match self { $(Self::$name => $why,)+ }
            }
        }
    };
}

rules! {
    /// A contract cannot be read at all.
    Unreadable "unreadable" "Nothing can be said about a contract that cannot be read.";
    /// Proto and projection of the contract do not fit each other.
    ProjectionDisagrees "projection-disagrees"
        "The proto and its JSON projection are one contract and must say the same.";

    /// The package has another name.
    PackageChanged "package-changed" "Every type has another full name, so no generated code fits.";
    /// The syntax is another.
    SyntaxChanged "syntax-changed" "Presence, packing and closed enums differ between syntaxes.";

    /// A message is gone.
    MessageDeleted "message-deleted" "Peers still send it, and generated code still names it.";
    /// A field is gone.
    FieldDeleted "field-deleted" "Peers still send it, and its meaning is lost on the receiver.";
    /// A field is gone and its number is free for another.
    NumberNotReserved "number-not-reserved" "A later field could take the number and be read as the old one.";
    /// A field or a value is gone and its name is free for another.
    NameNotReserved "name-not-reserved" "A later declaration could take the name and be read as the old one on JSON.";
    /// A reservation is gone.
    ReservationDeleted "reservation-deleted"
        "What was reserved had a meaning once, and stored data may still carry it.";
    /// A field has another number.
    FieldRenumbered "field-renumbered" "Protobuf peers read the field under its old number.";
    /// A field has another name.
    FieldRenamed "field-renamed" "JSON peers know the field by its name and ignore the new one.";
    /// A field has another name in protobuf's own JSON mapping.
    JsonNameChanged "json-name-changed" "Tools that use protobuf's JSON mapping no longer find the field.";
    /// A field has another type.
    FieldTypeChanged "field-type-changed"
        "Values change their range, form or type in generated code, even where the bytes still parse.";
    /// A field became repeated, or ceased to be.
    CardinalityChanged "cardinality-changed" "One value and an array of values are different JSON types.";
    /// A field went into a oneof, out of one, or changed its presence.
    PresenceChanged "presence-changed"
        "Fields of a oneof clear each other, and unset and default become, or cease to be, two things.";
    /// Fields of a message are in another order.
    FieldOrderChanged "field-order-changed" "Encoders write fields in declaration order [NCP-WIRE-080].";

    /// An enum is gone.
    EnumDeleted "enum-deleted" "Generated code still names it.";
    /// A value is gone.
    ValueDeleted "value-deleted" "Peers still send it.";
    /// A value has another constant.
    ValueRenamed "value-renamed" "Generated code, and protobuf's JSON mapping, know the value by its name.";
    /// A value has another number.
    ValueRenumbered "value-renumbered" "Protobuf peers read the value under its old number.";
    /// A value is new in an enum whose unknown strings are rejected.
    ValueAddedToClosedEnum "value-added-to-closed-enum"
        "Peers of the frozen contract reject a frame with a value that they do not know.";

    /// A service is gone.
    ServiceDeleted "service-deleted" "Clients still call it.";
    /// An RPC is gone.
    RpcDeleted "rpc-deleted" "Clients still call it.";
    /// An RPC takes or returns another message.
    RpcMessageChanged "rpc-message-changed" "The other side still sends the old message.";
    /// An RPC became a stream on one side, or ceased to be.
    RpcStreamingChanged "rpc-streaming-changed" "A stream and a single message are framed and awaited differently.";

    /// The wire version or contract hash of the projection is another.
    IdentityChanged "identity-changed" "A frozen wire keeps its version and hash; a new wire has both of its own.";
    /// A limit is another.
    LimitChanged "limit-changed" "A frame that one peer sends within the limit is beyond it for another.";
    /// A kind is gone.
    KindDeleted "kind-deleted" "Peers still send frames of this kind.";
    /// A message has another kind.
    KindChanged "kind-changed" "Receivers find frames by their kind and reject one that they do not know.";
    /// A field is required that was not.
    RequiredAdded "required-added" "Frames without the field were valid, and are now rejected.";
    /// A field is no longer required.
    RequiredRemoved "required-removed" "Frames without the field are now sent, and older peers reject them.";
    /// A field has another JSON type.
    JsonTypeChanged "json-type-changed" "Receivers reject a field of another JSON type [NCP-WIRE-020].";
    /// `null` is allowed where it was not, or the other way round.
    NullabilityChanged "nullability-changed" "Receivers reject null in a field that is not optional [NCP-WIRE-021].";
    /// An absent field is read as another value.
    DefaultChanged "default-changed" "The same frame means different things to two peers.";
    /// A program that does not name a field gets another value.
    BuiltDefaultChanged "built-default-changed" "The same program sends different frames after an upgrade.";
    /// A pin is another, gone or new.
    PinChanged "pin-changed" "Receivers reject a pinned field with another value.";
    /// A string is a key segment that was not, or ceased to be.
    SegmentChanged "segment-changed"
        "Strings that were valid are rejected, or strings are let through that no key can hold.";
    /// Bytes are written in another encoding.
    EncodingChanged "encoding-changed" "The receiver decodes other bytes, or none.";
    /// An unset optional field is written otherwise.
    UnsetFormChanged "unset-form-changed" "Encoders write an unset field in one agreed way [NCP-WIRE-082].";
    /// A message became transparent on JSON, or ceased to be.
    TransparencyChanged "transparency-changed" "Its fields move one level up or down on JSON.";
    /// Other fields may be left out, or must fit, in a frame inside a request.
    InsideRequestChanged "inside-request-changed" "A request that one peer sends is rejected by another.";
    /// The JSON form of a kind became optional, or ceased to be.
    JsonFormChanged "json-form-changed" "Peers count on the form, or lack it.";
    /// A value travels as another string.
    WireStringChanged "wire-string-changed"
        "Receivers compare wire strings letter for letter and do not know the new one.";
    /// A wire string that they do not know means something else to receivers.
    UnknownPolicyChanged "unknown-policy-changed" "The same frame is kept, held or rejected by different peers.";
}

impl Violation {
    #[expect(clippy::needless_pass_by_value, reason = "callers give what they have, owned or not")]
    fn new(rule: Rule, place: impl Into<String>, was: impl ToString, is: impl ToString) -> Self {
        Self { rule, place: place.into(), was: was.to_string(), is: is.to_string() }
    }
}

/// What stands in a diagnostic for something that is not there.
const NOTHING: &str = "nothing";

struct Check {
    found: Vec<Violation>,
}

impl Check {
    fn contract(&mut self, was: &Contract, is: &Contract) {
        self.differ(Rule::PackageChanged, "package", &was.package, &is.package);
        self.differ(Rule::SyntaxChanged, "syntax", &was.syntax, &is.syntax);
        for message in &was.messages {
            match is.message(&message.name) {
                Some(now) => self.message(message, now),
                None => self.gone(
                    Rule::MessageDeleted,
                    format!("message {}", message.name),
                    format!("{} fields", message.fields.len()),
                ),
            }
        }
        for item in &was.enums {
            match is.enumeration(&item.name) {
                Some(now) => {
                    let closed = was
                        .projection
                        .enums
                        .get(&item.name)
                        .is_some_and(|projected| projected.unknown == Unknown::Reject);
                    self.enumeration(item, now, closed);
                }
                None => {
                    self.gone(
                        Rule::EnumDeleted,
                        format!("enum {}", item.name),
                        format!("{} values", item.values.len()),
                    );
                }
            }
        }
        for service in &was.services {
            match is.services.iter().find(|now| now.name == service.name) {
                Some(now) => self.service(service, now),
                None => self.gone(
                    Rule::ServiceDeleted,
                    format!("service {}", service.name),
                    format!("{} RPCs", service.rpcs.len()),
                ),
            }
        }
    }

    fn message(&mut self, was: &MessageShape, is: &MessageShape) {
        let place = format!("message {}", was.name);
        for field in &was.fields {
            let place = format!("{place}, field {} {}", field.number, field.name);
            let by_number = is.fields.iter().find(|now| now.number == field.number);
            let by_name = is.fields.iter().find(|now| now.name == field.name);
            match (by_name, by_number) {
                (Some(now), _) => {
                    self.differ(Rule::FieldRenumbered, &place, field.number, now.number);
                    self.field(&place, field, now);
                }
                (None, Some(now)) => {
                    self.differ(Rule::FieldRenamed, &place, &field.name, &now.name);
                    self.field(&place, field, now);
                }
                (None, None) => {
                    self.gone(Rule::FieldDeleted, &place, format!("{} {} = {}", field.ty, field.name, field.number));
                    if !is.reserved.holds_number(field.number) {
                        self.gone(Rule::NumberNotReserved, &place, field.number);
                    }
                    if !is.reserved.names.contains(&field.name) {
                        self.gone(Rule::NameNotReserved, &place, &field.name);
                    }
                }
            }
        }
        self.reserved(&place, &was.reserved, &is.reserved);

        // Of the fields that both have, by number: the order of the frozen message must survive.
        let order = |fields: &[FieldShape], other: &[FieldShape]| {
            let shared = fields.iter().filter(|field| other.iter().any(|there| there.number == field.number));
            shared.map(|field| field.number.to_string()).collect::<Vec<_>>().join(", ")
        };
        self.differ(Rule::FieldOrderChanged, &place, order(&was.fields, &is.fields), order(&is.fields, &was.fields));
    }

    fn field(&mut self, place: &str, was: &FieldShape, is: &FieldShape) {
        use crate::contract::FieldType::{One, Repeated};
        if was.ty != is.ty {
            let rule = match (&was.ty, &is.ty) {
                (One(was), Repeated(is)) | (Repeated(was), One(is)) if was == is => Rule::CardinalityChanged,
                _ => Rule::FieldTypeChanged,
            };
            self.differ(rule, place, &was.ty, &is.ty);
        }
        // A field that was renamed has another JSON name for that reason.
        if was.name == is.name {
            self.differ(Rule::JsonNameChanged, place, &was.json_name, &is.json_name);
        }
        let oneof = |field: &FieldShape| {
            field.oneof.as_ref().map_or_else(|| "in no oneof".to_owned(), |name| format!("in oneof {name}"))
        };
        self.differ(Rule::PresenceChanged, place, oneof(was), oneof(is));
    }

    fn enumeration(&mut self, was: &EnumShape, is: &EnumShape, closed: bool) {
        let place = format!("enum {}", was.name);
        for value in &was.values {
            let place = format!("{place}, value {} {}", value.number, value.name);
            let by_number = is.values.iter().find(|now| now.number == value.number);
            let by_name = is.values.iter().find(|now| now.name == value.name);
            match (by_name, by_number) {
                (Some(now), _) => {
                    self.differ(Rule::ValueRenumbered, &place, value.number, now.number);
                }
                (None, Some(now)) => {
                    self.differ(Rule::ValueRenamed, &place, &value.name, &now.name);
                }
                (None, None) => {
                    self.gone(Rule::ValueDeleted, &place, format!("{} = {}", value.name, value.number));
                    if !is.reserved.holds_number(value.number) {
                        self.gone(Rule::NumberNotReserved, &place, value.number);
                    }
                    if !is.reserved.names.contains(&value.name) {
                        self.gone(Rule::NameNotReserved, &place, &value.name);
                    }
                }
            }
        }
        self.reserved(&place, &was.reserved, &is.reserved);
        if closed {
            let known =
                |name: &str, number| was.values.iter().any(|value| value.name == name || value.number == number);
            for value in is.values.iter().filter(|value| !known(&value.name, value.number)) {
                let place = format!("{place}, value {} {}", value.number, value.name);
                self.differ(
                    Rule::ValueAddedToClosedEnum,
                    &place,
                    NOTHING,
                    format!("{} = {}", value.name, value.number),
                );
            }
        }
    }

    fn reserved(&mut self, place: &str, was: &Reserved, is: &Reserved) {
        for (first, last) in &was.numbers {
            // Ranges may be split or merged, so long as every number stays reserved.
            let mut next = Some(*first);
            while let Some(number) = next.filter(|number| number <= last) {
                match is.numbers.iter().find(|(first, last)| (*first..=*last).contains(&number)) {
                    Some((_, covered)) => next = covered.checked_add(1),
                    None => {
                        self.gone(Rule::ReservationDeleted, place, format!("reserved {first} to {last}"));
                        break;
                    }
                }
            }
        }
        for name in was.names.difference(&is.names) {
            self.gone(Rule::ReservationDeleted, place, format!("reserved {name:?}"));
        }
    }

    fn service(&mut self, was: &ServiceShape, is: &ServiceShape) {
        for rpc in &was.rpcs {
            let place = format!("service {}, rpc {}", was.name, rpc.name);
            let Some(now) = is.rpcs.iter().find(|now| now.name == rpc.name) else {
                self.gone(Rule::RpcDeleted, place, rpc.signature());
                continue;
            };
            if (&rpc.request, &rpc.response) != (&now.request, &now.response) {
                self.differ(Rule::RpcMessageChanged, &place, rpc.signature(), now.signature());
            }
            if (rpc.client_streaming, rpc.server_streaming) != (now.client_streaming, now.server_streaming) {
                self.differ(Rule::RpcStreamingChanged, &place, rpc.signature(), now.signature());
            }
        }
    }

    fn projection(&mut self, was: &Projection, is: &Projection) {
        self.differ(Rule::IdentityChanged, "projection, wire", &was.wire, &is.wire);
        self.differ(Rule::IdentityChanged, "projection, contract_hash", &was.contract_hash, &is.contract_hash);
        self.limits(&was.limits, &is.limits);
        for (name, item) in &was.enums {
            if let Some(now) = is.enums.get(name) {
                self.wire_strings(name, item, now);
            }
        }
        for (name, message) in &was.messages {
            match is.messages.get(name) {
                Some(now) => self.projected_message(&format!("message {name}"), message, now),
                None => {
                    if let Some(kind) = &message.kind {
                        self.gone(Rule::KindDeleted, format!("message {name}"), kind);
                    }
                }
            }
        }
        self.projected_message(ERROR_FRAME, &was.error_frame, &is.error_frame);
    }

    fn limits(&mut self, was: &Limits, is: &Limits) {
        let list = |limits: &Limits| {
            let Limits { integer, entries, items, levels, segment_bytes, frame_bytes, frame_bytes_of, block_bytes } =
                limits.clone();
            let mut list: BTreeMap<String, u64> =
                frame_bytes_of.into_iter().map(|(kind, bytes)| (format!("frame_bytes_of {kind}"), bytes)).collect();
            list.extend(
                [
                    ("integer", integer),
                    ("entries", entries),
                    ("items", items),
                    ("levels", levels),
                    ("segment_bytes", segment_bytes),
                    ("frame_bytes", frame_bytes),
                    ("block_bytes", block_bytes),
                ]
                .map(|(name, value)| (name.to_owned(), value)),
            );
            list
        };
        let (was, is) = (list(was), list(is));
        for name in was.keys().chain(is.keys().filter(|name| !was.contains_key(*name))) {
            let show =
                |limits: &BTreeMap<String, u64>| limits.get(name).map_or_else(|| NOTHING.to_owned(), u64::to_string);
            self.differ(Rule::LimitChanged, &format!("limit {name}"), show(&was), show(&is));
        }
    }

    fn wire_strings(&mut self, name: &str, was: &EnumProjection, is: &EnumProjection) {
        let place = format!("enum {name}");
        self.differ(Rule::UnknownPolicyChanged, &place, &was.unknown, &is.unknown);
        for (constant, string) in &was.values {
            // A constant without a string disagrees with the proto, or is gone from it: reported
            // there.
            if let Some(now) = is.values.get(constant) {
                self.differ(
                    Rule::WireStringChanged,
                    &format!("{place}, value {constant}"),
                    format!("{string:?}"),
                    format!("{now:?}"),
                );
            }
        }
    }

    fn projected_message(&mut self, place: &str, was: &MessageProjection, is: &MessageProjection) {
        match (&was.kind, &is.kind) {
            (Some(kind), None) => self.gone(Rule::KindDeleted, place, kind),
            (was, is) => self.differ(Rule::KindChanged, place, optional(was.as_ref()), optional(is.as_ref())),
        }
        let required = |message: &MessageProjection, name: &String| message.required.contains(name);
        for name in was.required.iter().filter(|name| !required(is, name)) {
            self.differ(Rule::RequiredRemoved, &format!("{place}, field {name}"), "required", "not required");
        }
        for name in is.required.iter().filter(|name| !required(was, name)) {
            self.differ(Rule::RequiredAdded, &format!("{place}, field {name}"), "not required", "required");
        }
        self.differ(Rule::TransparencyChanged, place, transparency(was), transparency(is));
        self.differ(Rule::JsonFormChanged, place, format!("{:?}", was.json_form), format!("{:?}", is.json_form));
        let inside = |message: &MessageProjection| {
            message.inside_request.as_ref().map_or_else(
                || NOTHING.to_owned(),
                |inside| {
                    format!(
                        "may be absent: {}; as in the request: {}",
                        inside.may_be_absent.join(", "),
                        inside.same_as_request.join(", ")
                    )
                },
            )
        };
        self.differ(Rule::InsideRequestChanged, place, inside(was), inside(is));
        for (name, field) in &was.fields {
            // A field that is missing disagrees with the proto, or is gone from it: reported there.
            match is.fields.get(name) {
                Some(now) => self.projected_field(&format!("{place}, field {name}"), field, now),
                None if place == ERROR_FRAME => {
                    self.gone(Rule::FieldDeleted, format!("{place}, field {name}"), &field.ty);
                }
                None => {}
            }
        }
    }

    fn projected_field(&mut self, place: &str, was: &FieldProjection, is: &FieldProjection) {
        self.differ(Rule::JsonTypeChanged, place, &was.ty.shape, &is.ty.shape);
        if was.ty.nullable != is.ty.nullable {
            self.differ(Rule::NullabilityChanged, place, &was.ty, &is.ty);
        }
        self.differ(Rule::DefaultChanged, place, optional(was.default.as_ref()), optional(is.default.as_ref()));
        // A program gets the wire's default where nothing else is said: that is reported once.
        if was.built.is_some() || is.built.is_some() {
            self.differ(Rule::BuiltDefaultChanged, place, optional(built(was)), optional(built(is)));
        }
        self.differ(Rule::PinChanged, place, optional(was.pinned.as_ref()), optional(is.pinned.as_ref()));
        let segment = |field: &FieldProjection| {
            if field.segment { "a key segment" } else { "any string" }
        };
        self.differ(Rule::SegmentChanged, place, segment(was), segment(is));
        let encoding = |field: &FieldProjection| {
            field.encoding.map_or_else(|| NOTHING.to_owned(), |encoding| format!("{encoding:?}"))
        };
        self.differ(Rule::EncodingChanged, place, encoding(was), encoding(is));
        self.differ(Rule::UnsetFormChanged, place, format!("{:?}", was.unset), format!("{:?}", is.unset));
    }

    /// Reports `rule` unless the two read the same.
    fn differ(&mut self, rule: Rule, place: &str, was: impl ToString, is: impl ToString) {
        let violation = Violation::new(rule, place, was, is);
        if violation.was != violation.is {
            self.found.push(violation);
        }
    }

    fn gone(&mut self, rule: Rule, place: impl Into<String>, was: impl ToString) {
        self.found.push(Violation::new(rule, place, was, NOTHING));
    }
}

/// What a program gets that does not name the field.
fn built(field: &FieldProjection) -> Option<&Value> {
    field.built.as_ref().or(field.default.as_ref())
}

fn optional(value: Option<&impl ToString>) -> String {
    value.map_or_else(|| NOTHING.to_owned(), |value| value.to_string())
}

fn transparency(message: &MessageProjection) -> &'static str {
    if message.transparent { "its one field stands in its place" } else { "an object of its own" }
}
