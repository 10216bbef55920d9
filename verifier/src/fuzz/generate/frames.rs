//! Messages from the tables of the text: as frames, as fields, and as replies.

use ncp_text::tables::{Default, Field, Message, Shape, Unknown, tables};
use ncp_text::{CONTRACT_HASH, WIRE_VERSION};

use super::corrupt::{corrupted, wild};
use super::{Draw, Menu, Tree};
use crate::fuzz::tree::{int, list, literal, map, num, object, set, text};
use crate::json::Json;

/// Which features the messages of one input have, and how often, of a hundred.
#[derive(Debug, Clone, Copy)]
pub(super) struct Swarm {
    /// A field that may be left out is there.
    present: u64,
    /// An optional field is null.
    null: u64,
    /// A number is of any class, not a plain one.
    odd_numbers: u64,
    /// A string is of any kind, not a name.
    odd_strings: u64,
    /// A descriptive enum has a string that is not known.
    novel: u64,
    /// The most entries of a map or an array.
    most: usize,
    /// Whether numbers are those of a frame, not of the protocol.
    frame: bool,
}

impl Swarm {
    pub(super) fn draw(draw: &mut Draw<'_>, frame: bool) -> Self {
        let most = if draw.chance(6) { draw.size(8, 4096) } else { draw.size(0, 8) };
        Self {
            present: draw.one(&[0, 10, 30, 70, 100]),
            null: draw.one(&[0, 0, 30]),
            odd_numbers: draw.one(&[0, 30, 100]),
            odd_strings: draw.one(&[0, 20, 100]),
            novel: draw.one(&[0, 0, 25]),
            most,
            frame,
        }
    }
}

/// The arguments of `decode`.
pub(super) fn decode(menu: &Menu, draw: &mut Draw<'_>) -> Option<Tree> {
    let kind = draw.one(menu.reads.get(..).filter(|kinds| !kinds.is_empty())?);
    let frame = frame(kind, None, draw);
    let strict = menu.strict && draw.chance(20);
    let bytes = if draw.chance(45) { wild(&frame, draw).into_bytes() } else { corrupted(&frame, draw) };
    let mut args = match String::from_utf8(bytes) {
        Ok(frame) => object([("kind", text(kind)), ("text", text(frame))]),
        Err(error) => object([("kind", text(kind)), ("base64", base64(error.as_bytes()))]),
    };
    if strict {
        set(&mut args, "strict", Json::Bool(true));
    }
    Some(args)
}

/// Bytes as the protocol writes them.
pub(super) fn base64(bytes: &[u8]) -> Tree {
    use base64::Engine as _;
    text(base64::engine::general_purpose::STANDARD.encode(bytes))
}

/// A valid frame of a kind, of this session if it has one.
pub(super) fn frame(kind: &str, session: Option<&str>, draw: &mut Draw<'_>) -> Tree {
    let swarm = Swarm::draw(draw, true);
    let mut frame = object([]);
    let Some(message) = tables().kind(kind) else {
        return frame;
    };
    for field in &message.fields {
        let required = field.is_required() || field.name == "session_id" && kind != "error";
        if !required && !draw.chance(swarm.present) && field.name != "ncp_version" {
            continue;
        }
        match field.name.as_str() {
            "kind" => set(&mut frame, "kind", text(kind)),
            "ncp_version" => {
                if let Some(version) = version(draw) {
                    set(&mut frame, "ncp_version", text(version));
                }
            }
            "session_id" if kind != "link_status" => {
                let id = session.map_or_else(|| segment(draw), str::to_owned);
                set(&mut frame, "session_id", text(id));
            }
            "stimulus" if kind != "open_session" => {
                let value = stimulus_within(&frame, draw);
                set(&mut frame, "stimulus", value);
            }
            name => {
                let value = field_value(message, field, &swarm, draw);
                set(&mut frame, name, value);
            }
        }
    }
    frame
}

/// A version that passes, or none.
fn version(draw: &mut Draw<'_>) -> Option<String> {
    if draw.chance(85) { Some(WIRE_VERSION.to_owned()) } else { None }
}

/// A stimulus frame within a request.
fn stimulus_within(request: &Tree, draw: &mut Draw<'_>) -> Tree {
    let swarm = Swarm::draw(draw, true);
    let mut stimulus = object([]);
    if draw.chance(50) {
        set(&mut stimulus, "kind", text("stimulus_frame"));
    }
    for name in ["ncp_version", "session_id"] {
        if let Some(value) = request.get(name).filter(|_| draw.chance(50)) {
            set(&mut stimulus, name, value.clone());
        }
    }
    if draw.chance(80) {
        set(
            &mut stimulus,
            "values",
            value_of(&Shape::Map(Box::new(Shape::Message("ChannelValue".to_owned()))), &swarm, draw),
        );
    }
    if draw.chance(50) {
        set(&mut stimulus, "t", number(&swarm, draw));
    }
    stimulus
}

/// A valid id of a session.
pub(super) fn segment(draw: &mut Draw<'_>) -> String {
    match draw.below(9) {
        0 => {
            let length = draw.size(1, 256);
            draw.letters(length)
        }
        // Beyond ASCII, of any length.
        8 => {
            let c = draw.pick(&["é", "中", "\u{3000}", "\u{a0}", "\u{1f681}", "ß", "e\u{301}", "\u{958}"]);
            c.repeat((draw.size(1, 256) / c.len()).max(1))
        }
        1 => ["é", "e\u{301}", "A", "a", "ﬁ", "0", "uav-3_b.c", "中", "\u{1f681}", "İ", "~"][draw.below(11)].to_owned(),
        2 => {
            let word = draw.string();
            let fits = !word.is_empty()
                && word.len() <= 256
                && word.chars().all(|c| !c.is_control() && !c.is_ascii_whitespace() && !"/*$#?@".contains(c))
                && !matches!(word.as_str(), "." | "..");
            if fits { word } else { "s1".to_owned() }
        }
        _ => draw.pick(&["a", "b", "s1", "uav3", "session-7"]).to_owned(),
    }
}

fn field_value(message: &Message, field: &Field, swarm: &Swarm, draw: &mut Draw<'_>) -> Tree {
    if field.optional && draw.chance(swarm.null) {
        return Json::Null;
    }
    match (message.name.as_str(), field.name.as_str()) {
        // A pin has one value.
        (_, "calibrated_posterior") => Json::Bool(false),
        (_, "is_simulation_output") => Json::Bool(true),
        (_, "contract_hash") if draw.chance(60) => text(CONTRACT_HASH),
        ("SimConfig", "mode") => text(draw.pick(&["stream", "batch"])),
        _ => value_of(&field.shape, swarm, draw),
    }
}

/// A value of a type of the tables.
pub(super) fn value_of(shape: &Shape, swarm: &Swarm, draw: &mut Draw<'_>) -> Tree {
    match shape {
        // A word of the tables, where any text may stand.
        Shape::String if draw.chance(10) => text(known_word(draw)),
        Shape::String => text(string(swarm, draw)),
        Shape::Boolean => Json::Bool(draw.chance(50)),
        Shape::Integer => int(if draw.chance(swarm.odd_numbers) { draw.integer() } else { draw.range(0, 9) }),
        Shape::Number => number(swarm, draw),
        Shape::Enum(name) => {
            let Some(known) = tables().enumeration(name) else { return text("") };
            let novel = known.unknown == Unknown::Kept && draw.chance(swarm.novel);
            // Many that differ, or one of any kind.
            let word = if draw.chance(40) { format!("u{}", draw.below(5000)) } else { draw.string() };
            if novel { text(word) } else { text(known.strings[draw.below(known.strings.len())].clone()) }
        }
        Shape::Message(name) => {
            let mut value = object([]);
            for field in tables().message(name).map_or(&[][..], |message| &message.fields) {
                if draw.chance(swarm.present) {
                    let inner = Swarm { most: swarm.most.min(4), ..*swarm };
                    let of = tables().message(name).map(|message| field_value(message, field, &inner, draw));
                    set(&mut value, &field.name, of.unwrap_or(Json::Null));
                }
            }
            value
        }
        Shape::List(item) => {
            let numeric = matches!(**item, Shape::Number | Shape::Integer);
            let most = match draw.below(100) {
                0 if numeric => draw.size(256, 70_000),
                1 | 2 if numeric => 4 * swarm.most,
                _ => swarm.most.min(4096),
            };
            let count = draw.size(0, most);
            let count = draw.afford(count);
            let inner = Swarm { most: if numeric { swarm.most } else { swarm.most.min(3) }, ..*swarm };
            if numeric && count > 8 && draw.chance(15) {
                // Few values, again and again.
                let mut few: Vec<Tree> = (0..3).map(|_| value_of(item, &inner, draw)).collect();
                if matches!(**item, Shape::Number) {
                    let zero = |negative: bool| match (swarm.frame, negative) {
                        (true, negative) => literal(if negative { "-0.0" } else { "0.0" }),
                        (false, negative) => num(if negative { -0.0 } else { 0.0 }),
                    };
                    few.extend([zero(false), zero(true)]);
                }
                return list((0..count).map(|_| few[draw.below(few.len())].clone()).collect());
            }
            let mut items: Vec<Tree> = Vec::new();
            for _ in 0..count {
                let value = like(items.last(), value_of(item, &inner, draw), draw);
                items.push(value);
            }
            list(items)
        }
        Shape::Map(value) => {
            let count = draw.size(0, swarm.most.min(4096));
            let count = draw.afford(count);
            let inner = Swarm { most: swarm.most.min(4), ..*swarm };
            // Names that are equal for long, now and then.
            let prefix = if draw.chance(8) { draw.size(8, 2500) } else { 0 };
            let prefix = "k".repeat(prefix.max(1));
            let backwards = draw.chance(30);
            let mut before: Option<Tree> = None;
            let mut entry = |nth: usize, draw: &mut Draw<'_>| {
                let nth = if backwards { count - nth } else { nth };
                let named = count > 8 && !draw.chance(5) || prefix.len() > 1;
                let name = if named { format!("{prefix}{nth}") } else { string(swarm, draw) };
                let value = like(before.as_ref(), value_of(value, &inner, draw), draw);
                before = Some(value.clone());
                (name, value)
            };
            map((0..count).map(|nth| entry(nth, draw)).collect())
        }
    }
}

/// A value, or now and then the one before it with a member or two of this one: what differs in no more than that may
/// be taken for the same.
fn like(before: Option<&Tree>, value: Tree, draw: &mut Draw<'_>) -> Tree {
    let (Some(Json::Object(before)), Json::Object(members)) = (before, &value) else { return value };
    if before.is_empty() || !draw.chance(20) {
        return value;
    }
    let mut alike = Json::Object(before.clone());
    for _ in 0..draw.below(3) {
        if let Some((name, value)) = members.get(draw.below(members.len())) {
            set(&mut alike, name, value.clone());
        }
    }
    alike
}

/// An enum string, a kind, or the name of a field.
fn known_word(draw: &mut Draw<'_>) -> String {
    let tables = tables();
    if draw.chance(70) {
        let known = &tables.enums[draw.below(tables.enums.len())];
        return known.strings[draw.below(known.strings.len())].clone();
    }
    let message = &tables.messages[draw.below(tables.messages.len())];
    match &message.kind {
        Some(kind) if draw.chance(40) => kind.clone(),
        _ => message.fields[draw.below(message.fields.len())].name.clone(),
    }
}

fn string(swarm: &Swarm, draw: &mut Draw<'_>) -> String {
    let drawn = if draw.chance(swarm.odd_strings) { draw.string() } else { draw.name() };
    // A member of this form would be a template of the vector files.
    drawn.replace('$', "S")
}

/// A number in the spelling of the frame or of the protocol.
fn number(swarm: &Swarm, draw: &mut Draw<'_>) -> Tree {
    let value = if draw.chance(swarm.odd_numbers) { draw.finite() } else { draw.plain() };
    if !swarm.frame {
        // An encoder is given what JSON lacks, too.
        return num(if draw.chance(swarm.odd_numbers / 30) { draw.strange() } else { value });
    }
    literal(match draw.below(10) {
        // As many digits as one likes, of any size.
        8 => {
            let count = draw.size(1, 45);
            let digits: String = (0..count).map(|_| char::from(draw.one(b"0123456789"))).collect();
            let exponent = draw.range(-340, 300);
            let sign = if draw.chance(30) { "-" } else { "" };
            let lead = draw.below(10);
            let written = format!("{sign}{lead}.{digits}e{}", exponent.min(307));
            if draw.chance(50) { written } else { format!("{sign}{}{digits}", lead.max(1)) }
        }
        9 if draw.chance(40) => {
            draw.pick(&["0e999", "-0e999", "0.0E-999", "-1e-400", "1e-400", "-4e-324", "2e-324", "0E+400"]).to_owned()
        }
        0 => format!("{value:e}"),
        1 => format!("{value:E}"),
        2 if value.abs() < 1e15 && value.abs() > 1e-6 => format!("{value}"),
        // More digits than a double has: half-way between two, or just beside.
        3 => {
            let digits = format!("{:.*e}", draw.size(17, 60), value);
            let at = digits.find('e').unwrap_or(digits.len());
            let more = draw.one(&["", "0", "1", "5", "49", "50000000000000000000001"]);
            format!("{}{more}{}", &digits[..at], &digits[at..])
        }
        _ => format!("{value:?}"),
    })
}

/// The arguments of `encode`.
pub(super) fn encode(menu: &Menu, draw: &mut Draw<'_>) -> Option<Tree> {
    let kind = draw.one(menu.writes.get(..).filter(|kinds| !kinds.is_empty())?);
    let swarm = Swarm::draw(draw, false);
    let message = tables().kind(kind)?;
    let mut fields = object([]);
    for field in &message.fields {
        let name = field.name.as_str();
        let required = matches!(field.default, Default::Required);
        if name == "kind" || name == "ncp_version" || !required && !draw.chance(swarm.present) {
            continue;
        }
        let value = match name {
            "session_id" if kind != "link_status" => text(segment(draw)),
            "stimulus" if kind != "open_session" => {
                let values = Shape::Map(Box::new(Shape::Message("ChannelValue".to_owned())));
                let mut stimulus = object([("values", value_of(&values, &swarm, draw))]);
                if let Some(id) = fields.get("session_id").cloned() {
                    set(&mut stimulus, "session_id", id);
                }
                stimulus
            }
            _ => field_value(message, field, &swarm, draw),
        };
        set(&mut fields, name, value);
    }
    if draw.chance(30)
        && let Json::Object(members) = &mut fields
    {
        members.reverse();
    }
    Some(object([("kind", text(kind)), ("fields", fields)]))
}

/// The requests, and the replies that answer them.
pub(super) const PAIRS: [(&str, &str); 4] = [
    ("open_session", "session_opened"),
    ("step_request", "observation_frame"),
    ("run_request", "observation_frame"),
    ("close_session", "session_closed"),
];

/// The arguments of `reply.check`.
pub(super) fn reply(menu: &Menu, draw: &mut Draw<'_>) -> Tree {
    let (request, reply) = draw.one(&PAIRS);
    let id = segment(draw);
    let mut asked = frame(request, Some(&id), draw);
    let others = ["0.4", "0.7", "1.0", "0", "latest", ""];
    // Whoever asks in another version is answered in it, or in one's own.
    let (own, answered) = match draw.below(12) {
        0 => (draw.pick(&others), false),
        1 => (draw.pick(&others), true),
        _ => (WIRE_VERSION, false),
    };
    set(&mut asked, "ncp_version", text(own));
    // Its stimulus frame is of the request's version.
    if own != WIRE_VERSION
        && let Json::Object(members) = &mut asked
    {
        members.retain(|(name, _)| name != "stimulus");
    }
    let other = match draw.below(12) {
        0 => segment(draw),
        // Equal for long, or after normalisation.
        1 => format!("{id}x"),
        2 => draw.nearly(&id),
        3 => id.replace('é', "e\u{301}"),
        _ => id,
    };
    let kind = match draw.below(12) {
        0 => "error",
        1 => draw.one(&PAIRS).1,
        2 => draw.one(&PAIRS).0,
        _ => reply,
    };
    let mut answer = frame(kind, Some(&other), draw);
    match draw.below(10) {
        _ if answered => set(&mut answer, "ncp_version", text(own)),
        0 => set(&mut answer, "ncp_version", text(draw.pick(&["0.4", "0.6", "1.0", "0", "0.5.0", "", " 0.5"]))),
        1 | 2 if answer.get("ok").is_some() || draw.chance(30) => set(&mut answer, "ok", Json::Bool(draw.chance(50))),
        _ => set(&mut answer, "ok", Json::Bool(true)),
    }
    if !matches!(kind, "session_opened" | "session_closed")
        && draw.chance(85)
        && let Json::Object(members) = &mut answer
    {
        members.retain(|(name, _)| name != "ok");
    }
    // A remark, or what the table of the reply lacks.
    if !matches!(kind, "error") && draw.chance(10) {
        set(&mut answer, "error", text(draw.pick(&["", "3 of 4 ports are used"])));
    }
    let bytes = if draw.chance(75) { wild(&answer, draw).into_bytes() } else { corrupted(&answer, draw) };
    let reply = String::from_utf8_lossy(&bytes).into_owned();
    let mut args = object([("request", text(asked.to_string())), ("reply", text(reply))]);
    if menu.strict && draw.chance(20) {
        set(&mut args, "strict", Json::Bool(true));
    }
    args
}

#[cfg(test)]
mod tests {
    use ncp_spec::wire::{DecodeProblem, Kind, decode};

    use super::*;
    use crate::fuzz::harvest::Harvest;

    #[test]
    fn an_observation_has_a_member_ok_now_and_then_which_its_table_lacks() {
        let (menu, harvest) = (crate::fuzz::generate::tests::whole_menu(), Harvest::default());
        let has_ok = |number: &u64| {
            let args = reply(&menu, &mut Draw::new(3, *number, &harvest));
            let said = |name: &str| crate::fuzz::tree::string(&args, name).and_then(|text| Json::parse(text).ok());
            said("reply").is_some_and(|reply| {
                reply.get("kind").and_then(Json::as_str) == Some("observation_frame") && reply.get("ok").is_some()
            })
        };
        let found = (0..1000).filter(has_ok).count();
        assert!((10..200).contains(&found), "{found}");
    }

    #[test]
    fn a_frame_that_is_drawn_as_valid_is_read() {
        let harvest = Harvest::default();
        let (mut read, mut drawn_in_all) = (0, 0);
        for kind in tables().messages.iter().filter_map(|message| message.kind.as_deref()) {
            for number in 0..100 {
                let mut draw = Draw::new(11, number, &harvest);
                let drawn = frame(kind, None, &mut draw);
                for spelled in [drawn.to_string(), wild(&drawn, &mut draw)] {
                    drawn_in_all += 1;
                    let problem = decode(Kind::parse(kind).unwrap(), spelled.as_bytes()).err();
                    // Strange spelling may be too long, and may repeat a name within a member that nobody knows.
                    let is_meant = problem.as_ref().is_none_or(|error| {
                        matches!(error.problem(), DecodeProblem::TooLong { .. } | DecodeProblem::Repeated)
                    });
                    assert!(is_meant, "{kind} {number}: {problem:?}: {spelled}");
                    read += usize::from(problem.is_none());
                }
            }
        }
        assert!(read * 100 > drawn_in_all * 95, "{read} of {drawn_in_all}");
    }

    #[test]
    fn neighbours_of_a_message_differ_in_a_member_or_none_now_and_then() {
        let harvest = Harvest::default();
        let value = |nth: i64| object([("data", list(vec![int(nth)])), ("unit", text(format!("u{nth}")))]);
        let (before, other) = (value(1), value(2));
        let drawn: std::collections::HashSet<String> = (0..400)
            .map(|number| like(Some(&before), other.clone(), &mut Draw::new(3, number, &harvest)).to_string())
            .collect();
        for alike in [&before, &other, &object([("data", list(vec![int(1)])), ("unit", text("u2"))])] {
            assert!(drawn.contains(&alike.to_string()), "{alike}");
        }
    }
}
