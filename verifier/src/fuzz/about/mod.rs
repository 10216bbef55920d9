//! Which rules decide the answer to a question that was drawn, place by place.
//!
//! Of a frame that is rejected, the reader of the specification says which check it fails. Of a trace that a model
//! knows, the model says the rule of each step. Elsewhere it is what the question itself shows; what that leaves open,
//! the most similar case of the corpus decides.

mod traces;

use std::collections::{BTreeMap, HashMap};

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use ncp_spec::bulk::{Block, BulkError, Region};
use ncp_spec::wire::{self, DecodeProblem, Kind, Rule as Breach};
use ncp_text::catalogue::{Level, Role};
use ncp_text::{CONTRACT_HASH, WIRE_VERSION};

use super::generate::Input;
use super::rules::Rules;
use super::tree::{MAPS, Tree, double, doubles, integer, items, members, string};
use crate::json::Json;
use crate::peer::Call;
use crate::suite::Suite;

/// The rules of a case.
#[derive(Debug, Clone, Default)]
pub(crate) struct About {
    /// Those that it cites: it is about the first.
    pub(crate) rules: Vec<String>,
    /// The rules of parts of the answer.
    pub(crate) by: BTreeMap<String, String>,
    /// The roles that it is for.
    pub(crate) roles: Vec<Role>,
}

impl About {
    /// The rules of a question with this expectation; none, if nothing says one.
    pub(crate) fn of(
        suite: &Suite,
        rules: &mut Rules<'_>,
        input: &Input,
        expect: &Tree,
        steps: Option<&[Option<&str>]>,
    ) -> Option<Self> {
        let rejects = expect.get("reject").is_some();
        let (call, args) = (input.call, &input.args);
        let (like, _) = rules.decide(call, args, rejects, "", &Role::ALL, Level::Strict)?;
        let mut about = Self::default();
        let mut head = like.rule;
        match call {
            Call::Decode if rejects => {
                head =
                    rejected(string(args, "kind")?, &super::oracle::frame_bytes(args), is_strict(args)).unwrap_or(head);
            }
            Call::Decode => {
                let frame = super::oracle::frame_bytes(args);
                head = about.frame(&frame, expect, "NCP-WIRE-034", "NCP-WIRE-012", "NCP-WIRE-011");
                about.put("refusal", accepted(&frame));
            }
            Call::Encode if rejects => head = "NCP-WIRE-086".to_owned(),
            Call::Encode => {
                let written = string(expect, "text").unwrap_or_default().as_bytes().to_vec();
                head = about.frame(&written, expect, "NCP-WIRE-093", "NCP-WIRE-084", "NCP-WIRE-085");
                about.put("order", if has_map(&written) { "NCP-WIRE-083" } else { "NCP-WIRE-080" });
                about.put("extra", "NCP-WIRE-081");
                about.put("/ncp_version", "NCP-WIRE-090");
            }
            Call::ReplyCheck => head = reply(args, rejects),
            Call::KeyMatch => head = key_match(args, rejects),
            Call::KeyBuild => head = key_build(args, rejects).unwrap_or(head),
            Call::VersionCheck | Call::ContractStatus | Call::ContractVerify | Call::Negotiate => {
                head = version(call, args, expect, rejects);
            }
            Call::HorizonMaxLen => head = "NCP-RES-033".to_owned(),
            Call::BulkDecode if rejects => head = refused_block(args).map_or(head, str::to_owned),
            Call::BulkDecode => {
                head = "NCP-BULK-023".to_owned();
                let columns = items(expect.get("columns")).len();
                about.put("refusal", if columns > 16 { "NCP-BULK-017" } else { "NCP-BULK-018" });
            }
            Call::BulkEncode => head = if rejects { "NCP-BULK-031" } else { "NCP-BULK-030" }.to_owned(),
            Call::GovernorRun | Call::BufferRun | Call::WatchdogRun if !rejects => {
                let mut steps = steps.map(<[_]>::to_vec);
                if call == Call::BufferRun {
                    traces::buffer(args, steps.get_or_insert_default());
                }
                if let Some(steps) = &steps {
                    head = about.trace(steps).unwrap_or(head);
                    if call == Call::GovernorRun {
                        about.governor(args, expect, steps);
                    }
                }
            }
            Call::LinkRun if !rejects => {
                for (member, rule) in [
                    ("last_seq", "NCP-RES-054"),
                    ("lost", "NCP-RES-040"),
                    ("received", "NCP-RES-041"),
                    ("loss_rate", "NCP-RES-044"),
                    ("burst", "NCP-RES-046"),
                ] {
                    about.put(&format!("/steps/*/{member}"), rule);
                }
                about.link(args);
                head = "NCP-RES-040".to_owned();
            }
            Call::LoopRun if !rejects => {
                for (place, rule) in [
                    ("command/seq", "NCP-CTRL-013"),
                    ("command/ttl_ms", "NCP-CTRL-014"),
                    ("command/channels", "NCP-CTRL-011"),
                    ("command/mode", "NCP-CTRL-015"),
                    ("status/counter", "NCP-CTRL-017"),
                    ("status/seq", "NCP-CTRL-017"),
                    ("status/mode", "NCP-CTRL-017"),
                    ("status/safety_ok", "NCP-CTRL-018"),
                ] {
                    about.put(&format!("/steps/*/{place}"), rule);
                }
                about.control_loop(args, expect);
                head = "NCP-CTRL-011".to_owned();
            }
            Call::ReflexStep if !rejects => {
                let holds = expect.to_string().contains("\"mode\":\"hold\"");
                head = if holds { "NCP-CTRL-003" } else { "NCP-CTRL-001" }.to_owned();
            }
            Call::CodecEncode | Call::CodecDecode if !rejects => head = about.codec(call, args),
            Call::SessionRun => head = about.session(args),
            _ => {}
        }
        about.rules.push(head.clone());
        let mut counts: HashMap<&String, usize> = HashMap::new();
        for rule in about.by.values() {
            *counts.entry(rule).or_default() += 1;
        }
        let mut others: Vec<&String> = counts.keys().copied().filter(|rule| **rule != head).collect();
        others.sort();
        let others: Vec<String> = others.into_iter().cloned().collect();
        about.rules.extend(others);
        let is_known = |rule: &String| suite.requirement(rule).is_some();
        about.rules.retain(is_known);
        about.by.retain(|_, rule| suite.requirement(rule).is_some());
        let (answering, _) = super::concerns(call);
        let binds = |role: &Role| suite.requirement(&head).is_some_and(|rule| rule.binds(*role));
        about.roles = answering.iter().copied().filter(binds).filter(|role| super::has(*role, call, args)).collect();
        (!about.rules.is_empty() && !about.roles.is_empty()).then_some(about)
    }

    fn put(&mut self, place: &str, rule: &str) {
        self.by.insert(place.to_owned(), rule.to_owned());
    }

    /// The members of a frame: by what is in them. The rule of the frame.
    fn frame(&mut self, frame: &[u8], expect: &Tree, words: &str, numbers: &str, integers: &str) -> String {
        let text = string(expect, "text").unwrap_or_default();
        let Ok(parsed) = Json::parse(text) else { return words.to_owned() };
        let (mut strange_words, mut strange_numbers) = (frame.contains(&b'\\'), false);
        for (name, value) in members(Some(&parsed)) {
            let mut kinds = Kinds::default();
            kinds.of(value);
            strange_words |= kinds.strange_word;
            strange_numbers |= kinds.strange_number;
            let rule = match (name.as_ref(), kinds) {
                ("mode", _) => "NCP-WIRE-041",
                (_, Kinds { strange_number: true, .. }) => numbers,
                (_, Kinds { strange_word: true, .. }) => words,
                (_, Kinds { double: true, .. }) => numbers,
                (_, Kinds { integer: true, .. }) => integers,
                _ => words,
            };
            if name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_') {
                self.put(&format!("/{name}"), rule);
            }
        }
        if strange_numbers || !strange_words { numbers.to_owned() } else { words.to_owned() }
    }

    fn codec(&mut self, call: Call, args: &Tree) -> String {
        let encodes = call == Call::CodecEncode;
        let [maps, clamps, absent] = if encodes {
            ["NCP-CODEC-001", "NCP-CODEC-002", "NCP-CODEC-005"]
        } else {
            ["NCP-CODEC-003", "NCP-CODEC-004", "NCP-CODEC-006"]
        };
        let side = if encodes { "encoders" } else { "decoders" };
        let mut head = maps;
        let mut named: HashMap<&str, Vec<i64>> = HashMap::new();
        for mapping in items(args.get("codec").and_then(|codec| codec.get(side))) {
            let (Some(channel), Some(component), Some(population)) =
                (string(mapping, "channel"), integer(mapping.get("component")), string(mapping, "population"))
            else {
                continue;
            };
            let ends = |name: &str, default: [f64; 2]| match doubles(mapping.get(name)).as_slice() {
                [from, to] => [*from, *to],
                _ => default,
            };
            let (value, rate) = (ends("value_range", [-1.0, 1.0]), ends("rate_range", [0.0, 200.0]));
            let (from, given) = if encodes {
                let channels = args.get("sensor").and_then(|sensor| sensor.get("channels"));
                let data =
                    channels.and_then(|channels| channels.get(channel)).map(|sample| doubles(sample.get("data")));
                let at = usize::try_from(component).unwrap_or(usize::MAX);
                (value, data.and_then(|data| data.get(at).copied()))
            } else {
                (rate, double(args.get("rates").and_then(|rates| rates.get(population))))
            };
            let rule = match given.filter(|value| value.is_finite()) {
                _ if component >= 4096 => "NCP-CODEC-008",
                None => absent,
                Some(_) if !from.iter().all(|end| end.is_finite()) || from[0] == from[1] => "NCP-CODEC-007",
                Some(_) if from[0] > from[1] => "NCP-CODEC-012",
                Some(x) if x < from[0] || x > from[1] => clamps,
                Some(_) => maps,
            };
            let is_plain = |name: &str| name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_');
            if encodes && is_plain(population) {
                self.put(&format!("/rates/{population}"), rule);
            } else if !encodes && is_plain(channel) {
                self.put(&format!("/command/channels/{channel}/data/{component}"), rule);
                named.entry(channel).or_default().push(component);
            }
            head = rule;
        }
        for (channel, components) in named {
            let last = components.iter().copied().max().unwrap_or(0);
            if (0..last).any(|component| !components.contains(&component)) {
                self.put(&format!("/command/channels/{channel}/data/*"), "NCP-CODEC-010");
            }
        }
        if !encodes {
            for member in ["t", "seq", "frame_id", "mode"] {
                self.put(&format!("/command/{member}"), "NCP-CODEC-009");
            }
        }
        head.to_owned()
    }
}

fn is_strict(args: &Tree) -> bool {
    args.get("strict") == Some(&Json::Bool(true))
}

/// What stands in a value.
#[derive(Debug, Clone, Copy, Default)]
struct Kinds {
    integer: bool,
    double: bool,
    /// A number that is not plain: long, tiny, huge.
    strange_number: bool,
    /// A string that is not plain: long, or not of letters and digits.
    strange_word: bool,
}

impl Kinds {
    fn of(&mut self, json: &Json<'_>) {
        match json {
            Json::Number(spelling) => {
                let value = double(Some(json)).unwrap_or(0.0).abs();
                let is_integer = crate::json::is_integer(spelling);
                self.integer |= is_integer;
                self.double |= !is_integer;
                self.strange_number |= spelling.len() > 8 || value > 1e9 || value > 0.0 && value < 1e-6;
            }
            Json::String(word) => self.word(word),
            Json::Array(items) => items.iter().for_each(|item| self.of(item)),
            Json::Object(members) => members.iter().for_each(|(name, value)| {
                self.word(name);
                self.of(value);
            }),
            Json::Null | Json::Bool(_) => {}
        }
    }

    fn word(&mut self, word: &str) {
        self.strange_word |=
            word.len() > 24 || !word.bytes().all(|b| b.is_ascii_alphanumeric() || b"_-./".contains(&b));
    }
}

/// The rule against a frame: that of the check of the specification that it fails.
fn rejected(kind: &str, frame: &[u8], strict: bool) -> Option<String> {
    let kind = Kind::parse(kind)?;
    let error = match if strict { wire::decode_strict(kind, frame) } else { wire::decode(kind, frame) } {
        Ok(_) => return None,
        Err(error) => error,
    };
    let is_command = kind == Kind::CommandFrame;
    Some(
        match error.problem() {
            DecodeProblem::TooLong { .. } if is_command => "NCP-WIRE-062",
            DecodeProblem::TooLong { .. } => "NCP-WIRE-060",
            DecodeProblem::NotUtf8 => "NCP-WIRE-001",
            DecodeProblem::ByteOrderMark => "NCP-WIRE-006",
            DecodeProblem::Syntax(_) => "NCP-WIRE-002",
            DecodeProblem::NotAnObject => "NCP-WIRE-003",
            DecodeProblem::Trailing => "NCP-WIRE-004",
            DecodeProblem::Repeated => "NCP-WIRE-007",
            DecodeProblem::LoneSurrogate => "NCP-WIRE-008",
            DecodeProblem::NumberTooLarge => "NCP-WIRE-013",
            DecodeProblem::TooDeep => "NCP-WIRE-064",
            DecodeProblem::TooManyEntries => "NCP-WIRE-066",
            DecodeProblem::TooManyItems => "NCP-WIRE-067",
            DecodeProblem::WrongType { .. } => "NCP-WIRE-020",
            DecodeProblem::Null { .. } => "NCP-WIRE-021",
            DecodeProblem::IntegerSpelling => "NCP-WIRE-010",
            DecodeProblem::IntegerRange => "NCP-WIRE-011",
            DecodeProblem::KindMissing => "NCP-WIRE-028",
            DecodeProblem::KindUnknown(_) => "NCP-WIRE-029",
            DecodeProblem::KindOther { .. } => "NCP-WIRE-030",
            DecodeProblem::Missing => "NCP-WIRE-027",
            DecodeProblem::UnknownSimMode(_) => "NCP-WIRE-044",
            DecodeProblem::NotBase64 => "NCP-OBS-012",
            DecodeProblem::Rule(rule) => return breached(*rule, kind, error.path()).map(str::to_owned),
            _ => return None,
        }
        .to_owned(),
    )
}

fn breached(rule: Breach, kind: Kind, path: &str) -> Option<&'static str> {
    let said = rule.to_string();
    let is_observation = kind == Kind::ObservationFrame;
    Some(match said.as_str() {
        said if said.starts_with("not a valid session id") => "NCP-WIRE-031",
        said if said.contains("another session") => "NCP-WIRE-037",
        said if said.contains("another version") => "NCP-WIRE-038",
        said if said.contains("not compatible") => "NCP-STRICT-003",
        said if said.contains("stamped") => "NCP-STRICT-004",
        said if said.contains("pin") => match (is_observation, path.contains("calibrated_posterior")) {
            (true, true) => "NCP-PROV-001",
            (true, false) => "NCP-PROV-002",
            (false, true) => "NCP-PROV-003",
            (false, false) => "NCP-PROV-004",
        },
        said if said.contains("version") => "NCP-STRICT-002",
        _ => return None,
    })
}

/// The rule against a block: that of the check of the specification that it fails.
fn refused_block(args: &Tree) -> Option<&'static str> {
    let bytes = STANDARD.decode(string(args, "block")?).ok()?;
    Some(match Block::parse(&bytes).err()? {
        BulkError::TooLong { .. } => "NCP-BULK-015",
        BulkError::TooManyColumns { .. } => "NCP-BULK-016",
        BulkError::HeaderTruncated { .. } => "NCP-BULK-001",
        BulkError::Magic { .. } => "NCP-BULK-002",
        BulkError::Version { .. } => "NCP-BULK-003",
        BulkError::Flags { .. } => "NCP-BULK-004",
        BulkError::LengthMismatch { .. } => "NCP-BULK-005",
        BulkError::DirectoryTruncated { .. } => "NCP-BULK-006",
        BulkError::UnknownDtype { .. } => "NCP-BULK-007",
        BulkError::OutOfBounds { region: Region::Name(_), .. } => "NCP-BULK-009",
        BulkError::OutOfBounds { .. } => "NCP-BULK-011",
        BulkError::NameNotUtf8 { .. } => "NCP-BULK-010",
        BulkError::Overlap { .. } | BulkError::InDirectory { .. } => "NCP-BULK-012",
        _ => return None,
    })
}

/// Whether a frame has a map of several entries, whose order is another rule than that of members.
fn has_map(frame: &[u8]) -> bool {
    fn within(json: &Json<'_>, name: &str) -> bool {
        match json {
            Json::Object(entries) => {
                MAPS.contains(&name) && entries.len() > 1 || entries.iter().any(|(name, value)| within(value, name))
            }
            Json::Array(items) => items.iter().any(|item| within(item, name)),
            _ => false,
        }
    }
    std::str::from_utf8(frame).ok().and_then(|text| Json::parse(text).ok()).is_some_and(|json| within(&json, ""))
}

/// The rule by which a frame must not be refused: that of the limit to which it comes nearest, or of what is strange
/// about it.
fn accepted(frame: &[u8]) -> &'static str {
    let parsed = std::str::from_utf8(frame).ok().and_then(|text| Json::parse(text).ok());
    let (mut entries, mut things, mut depth) = (0, 0, 0);
    let mut kinds = Kinds::default();
    if let Some(parsed) = &parsed {
        measure(parsed, 1, &mut entries, &mut things, &mut depth);
        kinds.of(parsed);
    }
    let shares = [
        (entries as f64 / 4096.0, "NCP-WIRE-066"),
        (things as f64 / 65_536.0, "NCP-WIRE-067"),
        (f64::from(depth) / 64.0 - 0.1, "NCP-WIRE-064"),
        (frame.len() as f64 / 1_048_576.0, "NCP-WIRE-060"),
    ];
    let largest = shares.into_iter().max_by(|(a, _), (b, _)| a.total_cmp(b));
    match largest {
        Some((share, rule)) if share > 1.0 / 64.0 => rule,
        _ if frame.contains(&b'\\') => "NCP-WIRE-034",
        _ if kinds.strange_number => "NCP-WIRE-012",
        _ if frame.iter().any(|byte| byte.is_ascii_whitespace()) => "NCP-WIRE-005",
        _ => "NCP-WIRE-032",
    }
}

fn measure(json: &Json<'_>, level: u32, entries: &mut usize, things: &mut usize, depth: &mut u32) {
    *depth = (*depth).max(level);
    match json {
        Json::Array(items) => {
            *things = (*things).max(items.len());
            items.iter().for_each(|item| measure(item, level + 1, entries, things, depth));
        }
        Json::Object(members) => {
            *entries = (*entries).max(members.len());
            members.iter().for_each(|(_, value)| measure(value, level + 1, entries, things, depth));
        }
        _ => {}
    }
}

fn reply(args: &Tree, rejects: bool) -> String {
    let parse = |name: &str| string(args, name).and_then(|text| Json::parse(text).ok());
    let (request, reply) = (parse("request"), parse("reply"));
    let bytes = string(args, "reply").unwrap_or_default().as_bytes();
    let of = |json: &Option<Json<'_>>, name: &str| json.as_ref().and_then(|json| string(json, name)).map(str::to_owned);
    let kind = of(&reply, "kind").unwrap_or_default();
    let wanted = super::generate::answer_to(&of(&request, "kind").unwrap_or_default());
    let is_read = Kind::parse(&kind).is_some_and(|kind| wire::decode(kind, bytes).is_ok());
    let version = of(&reply, "ncp_version");
    let is_ok = reply.as_ref().and_then(|reply| reply.get("ok")) == Some(&Json::Bool(true));
    let has_ok = matches!(kind.as_str(), "session_opened" | "session_closed");
    match () {
        () if !rejects => "NCP-SESS-007",
        () if kind == "error" && is_read => "NCP-SESS-005",
        () if !is_read => "NCP-SESS-006",
        () if Some(kind.as_str()) != wanted => "NCP-SESS-001",
        () if of(&reply, "session_id") != of(&request, "session_id") => "NCP-SESS-002",
        () if version.is_none() && is_strict(args) => "NCP-STRICT-002",
        () if version.is_some_and(|version| version != WIRE_VERSION) => "NCP-SESS-003",
        () if has_ok && !is_ok => "NCP-SESS-004",
        () => "NCP-SESS-006",
    }
    .to_owned()
}

fn key_match(args: &Tree, rejects: bool) -> String {
    let (pattern, key) = (string(args, "pattern").unwrap_or_default(), string(args, "key").unwrap_or_default());
    // Verbatim chunks decide where others in their place were matched otherwise.
    let matches = |pattern: &str, key: &str| ncp_spec::keys::matches(pattern, key).ok();
    let plain = |text: &str| text.replace('@', "a");
    match () {
        () if rejects => "NCP-KEY-036",
        () if key.contains('@') && matches(pattern, key) != matches(&plain(pattern), &plain(key)) => "NCP-KEY-034",
        () if pattern.contains("$*") => "NCP-KEY-033",
        () if pattern.split('/').any(|chunk| chunk == "**") => "NCP-KEY-032",
        () if pattern.contains('*') => "NCP-KEY-031",
        () => "NCP-KEY-030",
    }
    .to_owned()
}

fn key_build(args: &Tree, rejects: bool) -> Option<String> {
    let segments = ["session", "name"].into_iter().filter_map(|name| string(args, name));
    if !rejects {
        return Some("NCP-KEY-020".to_owned());
    }
    let wrong = |segment: &str| match segment {
        "" => Some("NCP-KEY-010"),
        "." | ".." => Some("NCP-KEY-014"),
        _ if segment.len() > 256 => Some("NCP-KEY-017"),
        _ if segment.starts_with('@') => Some("NCP-KEY-013"),
        _ if segment.contains(['/', '*', '$', '#', '?']) => Some("NCP-KEY-011"),
        _ if segment.contains([' ', '\t', '\n', '\u{b}', '\u{c}', '\r']) => Some("NCP-KEY-012"),
        _ if segment.chars().any(|c| c.is_ascii_control()) => Some("NCP-KEY-015"),
        _ if segment.chars().any(char::is_control) => Some("NCP-KEY-016"),
        _ => None,
    };
    let own = segments.filter_map(wrong).next();
    let realm = string(args, "realm").filter(|realm| realm.split('/').any(|part| wrong(part).is_some()));
    own.or(realm.map(|_| "NCP-KEY-018")).map(str::to_owned)
}

fn version(call: Call, args: &Tree, expect: &Tree, rejects: bool) -> String {
    let hash = args.get("peer_hash").or(args.get("contract_hash")).and_then(Json::as_str);
    let version = string(args, "version").unwrap_or_default();
    let parts: Vec<&str> = version.split('.').collect();
    let is_version =
        parts.len() <= 2 && parts.iter().all(|part| !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit()));
    let value = expect.get("value");
    match call {
        Call::VersionCheck => match value {
            _ if !is_version => "NCP-VER-001",
            _ if parts.iter().any(|part| part.len() > 1 && part.starts_with('0') || part.len() > 9) => "NCP-VER-009",
            _ if rejects => "NCP-VER-006",
            Some(&Json::Bool(true)) => "NCP-VER-008",
            _ => "NCP-VER-007",
        },
        Call::Negotiate if rejects => "NCP-VER-030",
        Call::Negotiate => "NCP-VER-031",
        Call::ContractStatus => match hash {
            None => "NCP-VER-022",
            Some(hash) if hash == CONTRACT_HASH => "NCP-VER-023",
            Some(_) => "NCP-VER-024",
        },
        _ => match hash {
            None => "NCP-VER-028",
            Some(hash) if hash == CONTRACT_HASH => "NCP-VER-027",
            Some(_) => "NCP-VER-026",
        },
    }
    .to_owned()
}
