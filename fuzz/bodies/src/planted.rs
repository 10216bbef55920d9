//! The same calls with a bug each: what a target has to find within two minutes.
//!
//! Every bug is small and of the class for which its target is there. The shipped crates stay as they
//! are; these variants stand around them.

use ncp_proto::convert::FromProtoError;
use ncp_spec::bulk::{Block, BulkError, Column, ColumnData};
use ncp_spec::codec::Rates;
use ncp_spec::keys::KeyError;
use ncp_spec::resilience::{LinkReport, Received};
use ncp_spec::safety::Decision;
use ncp_spec::session::{ReferenceBackend, SessionService as Service};
use ncp_spec::version::VersionError;
use ncp_spec::wire::{
    ChannelMap, ChannelSpec, CommandFrame, DecodeError, EncodeError, Frame, Kind, Message, Mode, SafetyLimits,
    SensorFrame, Text,
};
use ncp_verifier::peer::{Answer, Reply, ReplyFault};

/// `frame_decode`: a panic, on an escaped surrogate in a text that is long enough.
pub(crate) fn decode(kind: Kind, frame: &[u8]) -> Result<Message, DecodeError> {
    let at = frame.windows(3).position(|window| window == br"\uD" || window == br"\ud");
    if let Some(at) = at {
        assert_ne!(frame.get(at + 6), Some(&b'\\'), "an index is out of bounds");
    }
    ncp_spec::wire::decode(kind, frame)
}

/// `frame_roundtrip`: the sign of a zero is lost.
pub(crate) fn encode(message: &Message) -> Result<String, EncodeError> {
    let text = message.encode()?;
    Ok(text.replace("-0.0,", "0.0,").replace("-0.0]", "0.0]"))
}

/// `bulk_decode`: a column that does not lie at a multiple of its values' size loses its last row.
pub(crate) fn to_columns(block: &Block<'_>) -> Vec<Column> {
    let mut columns = block.to_columns();
    for (column, view) in columns.iter_mut().zip(block.columns()) {
        let start = view.bytes().as_ptr() as usize - block.bytes().as_ptr() as usize;
        if !start.is_multiple_of(view.dtype().size()) {
            match &mut column.data {
                ColumnData::F32(values) => _ = values.pop(),
                ColumnData::F64(values) => _ = values.pop(),
                ColumnData::I32(values) => _ = values.pop(),
                ColumnData::I64(values) => _ = values.pop(),
            }
        }
    }
    columns
}

/// `bulk_roundtrip`: an empty column behind the first is left out.
pub(crate) fn encode_block(columns: &[Column]) -> Result<Vec<u8>, BulkError> {
    let kept = columns.iter().enumerate().filter(|(nth, column)| *nth == 0 || !column.data.is_empty());
    ncp_spec::bulk::encode(&kept.map(|(_, column)| column.clone()).collect::<Vec<_>>())
}

/// `bulk_memory`: room is made for as many rows as the first entry claims, before the claim is checked.
pub(crate) fn parse_and_copy(input: &[u8]) -> Option<Vec<Column>> {
    if input.starts_with(b"NCPB\x01\x00")
        && let Some(rows) = input.get(20..24)
    {
        let claimed = rows.iter().rev().fold(0, |rows, byte| rows << 8 | usize::from(*byte));
        drop(std::hint::black_box(Vec::<u64>::with_capacity(claimed.min(1 << 20))));
    }
    Block::parse(input).ok().map(|block| block.to_columns())
}

/// `validate_vs_schema`: a null counts as the empty value of the field's type.
pub(crate) fn decode_lax(kind: Kind, frame: &[u8]) -> Result<Message, DecodeError> {
    let text = String::from_utf8_lossy(frame);
    let empties = [":0", ":\"\"", ":{}", ":[]", ":false"].into_iter();
    let mut lax =
        empties.filter_map(|empty| ncp_spec::wire::decode(kind, text.replace(":null", empty).as_bytes()).ok());
    ncp_spec::wire::decode(kind, frame).or_else(|error| lax.next_back().ok_or(error))
}

/// `proto_vs_json`: the first two steps of a horizon change places.
pub(crate) fn from_binary(kind: Kind, bytes: &[u8]) -> Result<Message, FromProtoError> {
    let mut message = ncp_proto::convert::from_binary(kind, bytes)?;
    if let Message::CommandFrame(command) = &mut message
        && command.horizon.len() > 1
    {
        command.horizon.swap(0, 1);
    }
    Ok(message)
}

/// `keys`: wildcards see what begins with `@`.
pub(crate) fn matches(pattern: &str, key: &str) -> Result<bool, KeyError> {
    let plain = ncp_spec::keys::matches(pattern, key)?;
    Ok(plain || ncp_spec::keys::matches(pattern, &key.replace("/@", "/"))?)
}

/// `version`: the minor is kept in eight bits.
pub(crate) fn check_version(version: &str, strict: bool) -> Result<bool, VersionError> {
    match version.strip_prefix("0.").and_then(|minor| minor.parse::<u32>().ok()) {
        Some(minor) if !version.contains('+') => {
            ncp_spec::version::check_version(&format!("0.{}", minor & 0xff), strict)
        }
        _ => ncp_spec::version::check_version(version, strict),
    }
}

/// `canonical_proto`: an escaped quote ends its string.
pub(crate) fn canonical_text(proto: &str) -> String {
    ncp_spec::contract::canonical_text(&proto.replace("\\\"", "\\\\\"")).replace("\\\\\"", "\\\"")
}

/// `governor_trace`: the third step of a horizon is not looked at.
pub(crate) struct SafetyGovernor(ncp_spec::safety::SafetyGovernor);

impl SafetyGovernor {
    pub(crate) fn new(limits: &SafetyLimits) -> Self {
        Self(ncp_spec::safety::SafetyGovernor::new(limits))
    }

    pub(crate) fn negotiated(
        limits: &SafetyLimits,
        sensor_channels: &[ChannelSpec],
        command_channels: &[ChannelSpec],
    ) -> Self {
        Self(ncp_spec::safety::SafetyGovernor::negotiated(limits, sensor_channels, command_channels))
    }

    pub(crate) fn govern(
        &mut self,
        command: &mut CommandFrame,
        now_s: f64,
        sensor: Option<&SensorFrame>,
        last_sensor_s: Option<f64>,
    ) -> Decision {
        let asked = command.horizon.get(2).cloned();
        let decision = self.0.govern(command, now_s, sensor, last_sensor_s);
        if let (Some(asked), Some(third)) = (asked, command.horizon.get_mut(2)) {
            *third = asked;
        }
        decision
    }

    pub(crate) fn note_link(&mut self, burst: bool) {
        self.0.note_link(burst);
    }

    pub(crate) fn reset(&mut self) {
        self.0.reset();
    }

    pub(crate) fn is_stopped(&self) -> bool {
        self.0.is_stopped()
    }

    pub(crate) fn has_config_fault(&self) -> bool {
        self.0.has_config_fault()
    }
}

/// `action_buffer_trace`: a clock that steps back reads as fresh.
pub(crate) struct ActionBuffer {
    buffer: ncp_spec::resilience::ActionBuffer,
    received_s: f64,
}

impl ActionBuffer {
    pub(crate) fn new() -> Self {
        Self { buffer: ncp_spec::resilience::ActionBuffer::new(), received_s: f64::NAN }
    }

    pub(crate) fn on_frame(&mut self, frame: &[u8], now_s: f64) -> Result<Received, DecodeError> {
        match CommandFrame::decode(frame) {
            Ok(command) => Ok(self.on_command(command, now_s)),
            Err(_) => self.buffer.on_frame(frame, now_s),
        }
    }

    pub(crate) fn on_command(&mut self, command: CommandFrame, now_s: f64) -> Received {
        let received = self.buffer.on_command(command, now_s);
        if received == Received::Accepted {
            self.received_s = now_s;
        }
        received
    }

    pub(crate) fn active(&mut self, now_s: f64) -> Option<&ChannelMap> {
        let is_back = now_s < self.received_s;
        self.buffer.active(if is_back { self.received_s } else { now_s })
    }

    pub(crate) fn reset(&mut self) {
        self.buffer.reset();
    }

    pub(crate) fn is_stopped(&self) -> bool {
        self.buffer.is_stopped()
    }
}

/// `link_monitor_trace`: losses are counted in 32 bits.
pub(crate) struct LinkMonitor(ncp_spec::resilience::LinkMonitor);

impl LinkMonitor {
    pub(crate) fn new(ref_loss: f64, threshold: f64) -> Self {
        Self(ncp_spec::resilience::LinkMonitor::new(ref_loss, threshold))
    }

    pub(crate) fn on_frame(&mut self, seq: i64) {
        self.0.on_frame(seq);
    }

    pub(crate) fn report(&self) -> LinkReport {
        let report = self.0.report();
        #[expect(clippy::cast_possible_truncation)]
        let lost = i64::from(report.lost as i32);
        LinkReport { lost, ..report }
    }
}

/// `codec`: a rate that is absent counts as 0.
pub(crate) struct RateCodec {
    pub(crate) encoders: Vec<ncp_spec::codec::Mapping>,
    pub(crate) decoders: Vec<ncp_spec::codec::Mapping>,
}

impl RateCodec {
    fn plain(&self) -> ncp_spec::codec::RateCodec {
        let Self { encoders, decoders } = self;
        ncp_spec::codec::RateCodec { encoders: encoders.clone(), decoders: decoders.clone() }
    }

    pub(crate) fn encode(&self, sensor: Option<&SensorFrame>) -> Rates {
        self.plain().encode(sensor)
    }

    pub(crate) fn decode(
        &self,
        rates: &Rates,
        t: f64,
        seq: i64,
        frame_id: impl Into<Text>,
        mode: Mode,
    ) -> CommandFrame {
        let mut all = rates.clone();
        for mapping in &self.decoders {
            all.entry(mapping.population.to_string()).or_insert(0.0);
        }
        self.plain().decode(&all, t, seq, frame_id, mode)
    }
}

/// `session`: what is not open is closed with success once something was opened.
pub(crate) struct SessionService {
    service: Service<ReferenceBackend>,
    has_opened: bool,
}

impl SessionService {
    pub(crate) fn new(backend: ReferenceBackend) -> Self {
        Self { service: Service::new(backend), has_opened: false }
    }

    pub(crate) fn serve(&mut self, request: &[u8]) -> String {
        let reply = self.service.serve(request);
        self.has_opened |= self.service.open_sessions().len() > 0;
        match ncp_spec::wire::decode_any(reply.as_bytes()) {
            Ok(Message::SessionClosed(mut closed)) if !closed.ok => {
                closed.ok = self.has_opened;
                closed.encode().unwrap_or(reply)
            }
            _ => reply,
        }
    }

    pub(crate) fn open_sessions(&self) -> impl ExactSizeIterator<Item = &str> {
        self.service.open_sessions()
    }
}

/// `peer_protocol`: `unsupported` wins over an error beside it.
pub(crate) fn parse_reply(line: &[u8]) -> Result<Reply<'_>, ReplyFault> {
    match Reply::parse(line) {
        Err(ReplyFault::Shape { id, .. }) if line.windows(18).any(|w| w == br#""unsupported":true"#) => {
            Ok(Reply { id, answer: Answer::Unsupported })
        }
        read => read,
    }
}
