//! Protobuf binary ↔ JSON model, in both directions, against a reader that knows only the
//! descriptor and the projection.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on has failed")]

mod common;

use std::{collections::BTreeMap, sync::LazyLock};

use base64::{Engine as _, engine::general_purpose::STANDARD};
use common::frames::frame;
use ncp_proto::{
    DESCRIPTOR_SET,
    contract::Contract,
    convert::{Convert, FromProtoError, Loss, Lost, ToProtoError, from_binary, to_binary},
    projection::FieldProjection,
    v0,
};
use ncp_spec::{
    ErrorCode, WIRE_VERSION,
    wire::{EncodeError, Kind, Message, decode},
};
use proptest::{collection::vec, prelude::*, sample::select, strategy::ValueTree as _};
use prost::Message as _;
use prost_reflect::{DescriptorPool, DynamicMessage, FieldDescriptor, MessageDescriptor, ReflectMessage as _};
use serde_json::{Value, json};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    /// [NCP-WIRE-015] [NCP-WIRE-043]
    #[test]
    fn a_frame_comes_back_from_protobuf_bit_for_bit_or_says_what_is_lost((kind, text) in frame(true)) {
        let message = decode(kind, text.as_bytes()).unwrap();
        let (back, losses) = there_and_back(&message);
        let same = back.as_ref().is_ok_and(|back| back.encode() == message.encode());
        prop_assert_eq!(losses.is_empty(), same, "{:?}\n{:?}\n{:?}", losses, message, back);
        match to_binary(&message) {
            Ok(bytes) => prop_assert_eq!(from_binary(kind, &bytes).unwrap().encode(), message.encode()),
            Err(error) => prop_assert_eq!(error, ToProtoError::Lossy(losses)),
        }
    }

    /// [NCP-WIRE-034]
    #[test]
    fn the_protobuf_form_holds_each_value_under_its_own_field((kind, text) in frame(false)) {
        let message = decode(kind, text.as_bytes()).unwrap();
        let bytes = to_binary(&message).unwrap();
        let json: Value = serde_json::from_str(&message.encode().unwrap()).unwrap();
        prop_assert_eq!(READER.read(kind, &bytes), json);
    }

    /// [NCP-WIRE-015]
    #[test]
    fn a_protobuf_form_comes_back_as_it_was((kind, text) in frame(false)) {
        let bytes = to_binary(&decode(kind, text.as_bytes()).unwrap()).unwrap();
        let again = to_binary(&from_binary(kind, &bytes).unwrap()).unwrap();
        prop_assert_eq!(again, bytes);
    }

    /// [NCP-WIRE-091] [NCP-PROV-006]
    #[test]
    fn what_is_read_from_any_protobuf_can_be_sent_and_crosses_unchanged_from_then_on((kind, bytes) in any_protobuf()) {
        if let Ok(message) = from_binary(kind, &bytes) {
            let text = message.encode().unwrap();
            prop_assert_eq!(&decode(kind, text.as_bytes()).unwrap(), &message);
            let bytes = to_binary(&message).unwrap();
            prop_assert_eq!(from_binary(kind, &bytes).unwrap(), message);
        }
    }

    /// [NCP-PROV-006]
    #[test]
    fn no_bytes_make_it_panic(kind in select(Kind::ALL.to_vec()), (of, bytes) in any_protobuf(),
        at in any::<prop::sample::Index>(), byte: u8, noise in vec(any::<u8>(), 0..64)) {
        let _ = from_binary(kind, &noise);
        let mut bytes = bytes;
        if !bytes.is_empty() {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        if let Ok(message) = from_binary(of, &bytes) {
            prop_assert!(message.encode().is_ok());
        }
    }
}

#[test]
fn most_of_the_generated_protobuf_makes_a_message() {
    // Else the property about any protobuf would say little.
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let strategy = any_protobuf();
    let made = (0..500).filter(|_| {
        let (kind, bytes) = strategy.new_tree(&mut runner).unwrap().current();
        from_binary(kind, &bytes).is_ok()
    });
    let made = made.count();
    assert!((250..500).contains(&made), "{made} of 500");
}

#[test]
fn each_loss_is_named_by_its_field() {
    let losses = |kind, frame: Value| match to_binary(&decode(kind, frame.to_string().as_bytes()).unwrap()) {
        Err(ToProtoError::Lossy(losses)) => {
            losses.into_iter().map(|Loss { path, what }| (path, what)).collect::<Vec<_>>()
        }
        other => panic!("{other:?}"),
    };
    let open = json!({
        "kind": "open_session", "session_id": "s", "contract_hash": "",
        "network": {"kind": "cloud", "model_name": "", "params": {"a": -0.0}},
        "record": {"targets": [{}, {"observable": "g_ex", "cadence_ms": -0.0}]},
        "sim": {"seed": 0, "duration_ms": 0.0},
    });
    assert_eq!(
        losses(Kind::OpenSession, open),
        [
            ("network.kind".to_owned(), Lost::UnknownString("cloud".to_owned())),
            ("network.model_name".to_owned(), Lost::EmptyString),
            ("network.params.a".to_owned(), Lost::ZeroSign),
            ("record.targets[1].observable".to_owned(), Lost::UnknownString("g_ex".to_owned())),
            ("record.targets[1].cadence_ms".to_owned(), Lost::ZeroSign),
            ("sim.seed".to_owned(), Lost::Zero),
            ("sim.duration_ms".to_owned(), Lost::Zero),
            ("contract_hash".to_owned(), Lost::EmptyString),
        ]
    );
    let command =
        json!({"kind": "command_frame", "horizon": [{}, {"v": {"data": [-0.0], "unit": ""}}], "horizon_dt_ms": -0.0});
    assert_eq!(
        losses(Kind::CommandFrame, command),
        [("horizon[1].v.unit".to_owned(), Lost::EmptyString), ("horizon_dt_ms".to_owned(), Lost::Zero)]
    );
}

#[test]
fn the_error_frame_does_not_cross() {
    let message = decode(Kind::Error, br#"{"kind":"error","error":"no"}"#).unwrap();
    assert_eq!(to_binary(&message), Err(ToProtoError::ErrorFrame));
    assert_eq!(from_binary(Kind::Error, b""), Err(FromProtoError::ErrorFrame));
}

#[test]
fn a_protobuf_form_that_is_no_frame_is_told_why() {
    let observation = || v0::ObservationFrame {
        ncp_version: WIRE_VERSION.into(),
        kind: "observation_frame".into(),
        session_id: "s".into(),
        is_simulation_output: true,
        ..Default::default()
    };
    let open = || v0::OpenSession {
        ncp_version: WIRE_VERSION.into(),
        kind: "open_session".into(),
        session_id: "s".into(),
        network: Some(v0::NetworkRef { kind: v0::NetworkRefKind::Builtin.into(), ..Default::default() }),
        ..Default::default()
    };
    assert!(from_binary(Kind::ObservationFrame, &observation().encode_to_vec()).is_ok());
    assert!(from_binary(Kind::OpenSession, &open().encode_to_vec()).is_ok());

    let mut told = Vec::new();
    let mut tell = |kind, bytes: Vec<u8>| told.push(from_binary(kind, &bytes).unwrap_err().to_string());
    tell(Kind::ObservationFrame, vec![0x0a]);
    tell(Kind::ObservationFrame, v0::ObservationFrame { kind: String::new(), ..observation() }.encode_to_vec());
    tell(Kind::CloseSession, observation().encode_to_vec());
    tell(Kind::ObservationFrame, v0::ObservationFrame { is_simulation_output: false, ..observation() }.encode_to_vec());
    tell(Kind::ObservationFrame, v0::ObservationFrame { calibrated_posterior: true, ..observation() }.encode_to_vec());
    tell(Kind::ObservationFrame, v0::ObservationFrame { session_id: "a/b".into(), ..observation() }.encode_to_vec());
    tell(Kind::ObservationFrame, v0::ObservationFrame { seq: 1 << 53, ..observation() }.encode_to_vec());
    tell(Kind::ObservationFrame, v0::ObservationFrame { t: f64::NAN, ..observation() }.encode_to_vec());
    let record = v0::Observation { observable: 6, ..Default::default() };
    tell(
        Kind::ObservationFrame,
        v0::ObservationFrame { records: BTreeMap::from([("p".into(), record)]), ..observation() }.encode_to_vec(),
    );
    tell(Kind::OpenSession, v0::OpenSession { network: None, ..open() }.encode_to_vec());
    tell(Kind::OpenSession, v0::OpenSession { network: Some(v0::NetworkRef::default()), ..open() }.encode_to_vec());
    tell(
        Kind::OpenSession,
        v0::OpenSession { sim: Some(v0::SimConfig { mode: 3, ..Default::default() }), ..open() }.encode_to_vec(),
    );
    let target = v0::RecordTarget { observable: -1, ..Default::default() };
    tell(
        Kind::OpenSession,
        v0::OpenSession { record: Some(v0::RecordSpec { targets: vec![target] }), ..open() }.encode_to_vec(),
    );
    insta::assert_snapshot!(told.join("\n"));
}

#[test]
fn what_protobuf_leaves_out_reads_as_the_table_of_the_module_says() {
    let mode = |mode| {
        let proto = v0::CommandFrame { kind: "command_frame".into(), mode, ..Default::default() };
        let Message::CommandFrame(command) = from_binary(Kind::CommandFrame, &proto.encode_to_vec()).unwrap() else {
            unreachable!()
        };
        command.mode.as_str()
    };
    assert_eq!([0, 1, 2, 3, 4, 5, -1].map(mode), ["hold", "init", "active", "hold", "estop", "hold", "hold"]);

    let network = Some(v0::NetworkRef { kind: v0::NetworkRefKind::Spec.into(), ..Default::default() });
    let binding = v0::EntityBinding::default();
    let open = v0::OpenSession {
        kind: "open_session".into(),
        session_id: "s".into(),
        network,
        bindings: vec![binding],
        ..Default::default()
    };
    let Message::OpenSession(open) = from_binary(Kind::OpenSession, &open.encode_to_vec()).unwrap() else {
        unreachable!()
    };
    let read = concat!(
        r#"{"kind":"open_session","session_id":"s","ncp_version":"","#,
        r#""network":{"kind":"spec"},"bindings":[{"direction":""}]}"#
    );
    let read = decode(Kind::OpenSession, read.as_bytes()).unwrap();
    assert_eq!(Message::from(open), read);

    // No default of JSON is filled in for a plain field.
    let sensor = v0::SensorFrame { kind: "sensor_frame".into(), ..Default::default() };
    let Message::SensorFrame(sensor) = from_binary(Kind::SensorFrame, &sensor.encode_to_vec()).unwrap() else {
        unreachable!()
    };
    assert_eq!((&*sensor.ncp_version, &*sensor.frame_id), ("", ""));
}

#[test]
fn a_stimulus_inside_a_request_takes_what_it_leaves_out_from_the_request() {
    let request = |stimulus: v0::StimulusFrame| {
        let proto = v0::StepRequest {
            ncp_version: WIRE_VERSION.into(),
            kind: "step_request".into(),
            session_id: "s".into(),
            stimulus: Some(stimulus),
            ..Default::default()
        };
        from_binary(Kind::StepRequest, &proto.encode_to_vec())
    };
    let Ok(Message::StepRequest(step)) = request(v0::StimulusFrame { t: 1.5, ..Default::default() }) else {
        panic!("rejected")
    };
    let stimulus = step.stimulus.unwrap();
    assert_eq!((&*stimulus.ncp_version, &*stimulus.session_id, stimulus.t), (WIRE_VERSION, "s", 1.5));
    let run = v0::RunRequest {
        kind: "run_request".into(),
        session_id: "s".into(),
        stimulus: Some(v0::StimulusFrame::default()),
        ..Default::default()
    };
    assert!(from_binary(Kind::RunRequest, &run.encode_to_vec()).is_ok());

    let code = |result: Result<Message, FromProtoError>| match result {
        Err(FromProtoError::Unsendable(error)) => EncodeError::code(&error),
        other => panic!("{other:?}"),
    };
    assert_eq!(code(request(v0::StimulusFrame { session_id: "other".into(), ..Default::default() })), ErrorCode::Value);
    assert_eq!(code(request(v0::StimulusFrame { ncp_version: "0.4".into(), ..Default::default() })), ErrorCode::Value);
    let other_kind = request(v0::StimulusFrame { kind: "sensor_frame".into(), ..Default::default() }).unwrap_err();
    assert_eq!(other_kind.to_string(), r#"stimulus.kind: expected "stimulus_frame", found "sensor_frame""#);
}

#[test]
fn unknown_fields_are_left_out() {
    let mut bytes = to_binary(&decode(Kind::SensorFrame, br#"{"kind":"sensor_frame","seq":7}"#).unwrap()).unwrap();
    let before = from_binary(Kind::SensorFrame, &bytes).unwrap();
    bytes.extend([0xa0, 0x06, 0x01]); // Field 100, a varint.
    assert_eq!(from_binary(Kind::SensorFrame, &bytes).unwrap(), before);
}

/// The message after the way to protobuf and back, whatever is lost on it, and what is.
fn there_and_back(message: &Message) -> (Result<Message, FromProtoError>, Vec<Loss>) {
    fn frame<F: Convert>(frame: &F) -> (Result<F, FromProtoError>, Vec<Loss>) {
        let (proto, losses) = frame.to_proto();
        let binary = F::Proto::decode(&*proto.encode_to_vec()).unwrap();
        (F::from_proto(binary), losses)
    }
    macro_rules! each {
        ($($kind:ident)*) => {
            match message {
                $(Message::$kind(message) => {
                    let (back, losses) = frame(message);
                    (back.map(Message::$kind), losses)
                })*
                Message::Error(_) => unreachable!("it is not generated"),
            }
        };
    }
    each!(OpenSession SessionOpened StimulusFrame StepRequest RunRequest ObservationFrame BulkObservation CloseSession
        SessionClosed
          Capabilities SensorFrame CommandFrame ControlStatus LinkStatus)
}

/// Protobuf forms of any kind, made from the descriptor: mostly, not always, of what a frame can
/// hold.
fn any_protobuf() -> impl Strategy<Value = (Kind, Vec<u8>)> {
    let kinds = [
        Kind::OpenSession,
        Kind::StepRequest,
        Kind::ObservationFrame,
        Kind::CommandFrame,
        Kind::Capabilities,
        Kind::LinkStatus,
    ];
    (select(kinds.to_vec()), any::<u64>())
        .prop_map(|(kind, seed)| (kind, random(&READER.descriptor(kind), Some(kind), &mut Dice(seed)).encode_to_vec()))
}

/// A small generator of numbers (SplitMix64): the shape of a protobuf form depends on each throw.
struct Dice(u64);

impl Dice {
    fn throw(&mut self, sides: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (mixed ^ (mixed >> 31)) % sides
    }
}

fn random(descriptor: &MessageDescriptor, kind: Option<Kind>, dice: &mut Dice) -> DynamicMessage {
    let mut message = DynamicMessage::new(descriptor.clone());
    for field in descriptor.fields() {
        if dice.throw(4) == 0
            && !matches!(
                field.name(),
                "network" | "kind" | "session_id" | "is_simulation_output" | "observable" | "role" | "mode"
            )
        {
            continue;
        }
        let single = |dice: &mut Dice| random_value(&field, kind, dice);
        let value = if field.is_map() {
            let of = field.kind().as_message().unwrap().map_entry_value_field();
            let entries = (0..dice.throw(3))
                .map(|nth| (prost_reflect::MapKey::String(format!("k{nth}")), random_value(&of, None, dice)));
            prost_reflect::Value::Map(entries.collect())
        } else if field.is_list() {
            prost_reflect::Value::List((0..dice.throw(3)).map(|_| single(dice)).collect())
        } else {
            single(dice)
        };
        message.set_field(&field, value);
    }
    message
}

fn random_value(field: &FieldDescriptor, kind: Option<Kind>, dice: &mut Dice) -> prost_reflect::Value {
    use prost_reflect::{Kind as Type, Value as Proto};
    match field.kind() {
        Type::String => Proto::String(match (field.name(), kind) {
            ("kind", Some(kind)) => kind.as_str().to_owned(),
            ("kind", None) => ["stimulus_frame", ""][dice.throw(2) as usize].to_owned(),
            ("session_id", _) => "s".to_owned(),
            ("ncp_version", _) => WIRE_VERSION.to_owned(),
            _ => ["", "m", "vel_x"][dice.throw(3) as usize].to_owned(),
        }),
        Type::Bool => Proto::Bool(match field.name() {
            "is_simulation_output" => true,
            "calibrated_posterior" => false,
            _ => dice.throw(2) == 0,
        }),
        Type::Int64 => {
            Proto::I64([0, 1, -1, 1 << 40, if dice.throw(20) == 0 { i64::MAX } else { 5 }][dice.throw(5) as usize])
        }
        Type::Double => Proto::F64(
            [0.0, 1.5, -2.0, 5e-324, if dice.throw(20) == 0 { f64::INFINITY } else { 0.1 }][dice.throw(5) as usize],
        ),
        Type::Bytes => Proto::Bytes(vec![0, 255].into()),
        Type::Enum(_) => Proto::EnumNumber(if dice.throw(30) == 0 { 9 } else { 1 + dice.throw(2) as i32 }),
        Type::Message(inner) => Proto::Message(random(&inner, None, dice)),
        other => unreachable!("the contract has no {other:?}"),
    }
}

/// Reads a protobuf form as JSON by descriptor and projection alone, as a second source for
/// [`to_binary`].
struct Reader {
    contract: Contract,
    pool: DescriptorPool,
}

static READER: LazyLock<Reader> = LazyLock::new(|| Reader {
    contract: Contract::current().unwrap(),
    pool: DescriptorPool::decode(DESCRIPTOR_SET).unwrap(),
});

impl Reader {
    fn descriptor(&self, kind: Kind) -> MessageDescriptor {
        let (_, message, _) = self.contract.kinds().find(|(name, ..)| *name == kind.as_str()).unwrap();
        self.pool.get_message_by_name(&format!("ncp.v0.{}", message.name)).unwrap()
    }

    fn read(&self, kind: Kind, bytes: &[u8]) -> Value {
        self.message(&DynamicMessage::decode(self.descriptor(kind), bytes).unwrap())
    }

    fn message(&self, message: &DynamicMessage) -> Value {
        let descriptor = message.descriptor();
        let projected = &self.contract.projection.messages[descriptor.name()];
        let mut fields = descriptor.fields().map(|field| {
            let projection = &projected.fields[field.name()];
            (
                field.name().to_owned(),
                self.field(&message.get_field(&field), &field, projection, message.has_field(&field)),
            )
        });
        if projected.transparent { fields.next().unwrap().1 } else { Value::Object(fields.collect()) }
    }

    fn field(
        &self,
        value: &prost_reflect::Value,
        field: &FieldDescriptor,
        projection: &FieldProjection,
        is_set: bool,
    ) -> Value {
        use prost_reflect::Value as Proto;
        match value {
            _ if projection.ty.nullable && !is_set => Value::Null,
            Proto::List(items) => items.iter().map(|item| self.single(item, field)).collect(),
            Proto::Map(entries) => {
                let of = field.kind().as_message().unwrap().map_entry_value_field();
                let entries: BTreeMap<_, _> = entries
                    .iter()
                    .map(|(key, value)| (key.as_str().unwrap().to_owned(), self.single(value, &of)))
                    .collect();
                Value::Object(entries.into_iter().collect())
            }
            single => self.single(single, field),
        }
    }

    fn single(&self, value: &prost_reflect::Value, field: &FieldDescriptor) -> Value {
        use prost_reflect::Value as Proto;
        match value {
            Proto::Bool(value) => json!(value),
            Proto::I64(value) => json!(value),
            Proto::F64(value) => json!(value),
            Proto::String(value) => json!(value),
            Proto::Bytes(value) => json!(STANDARD.encode(value)),
            Proto::EnumNumber(number) => {
                let of = field.kind();
                let of = of.as_enum().unwrap();
                let constant = of.get_value(*number).unwrap();
                json!(self.contract.projection.enums[of.name()].values[constant.name()])
            }
            Proto::Message(message) => self.message(message),
            other => unreachable!("the contract has no {other:?}"),
        }
    }
}
