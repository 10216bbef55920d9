//! Where within a frame something stands: deep, far behind, at the end of much, or just at the limit of sizes.

use super::{Draw, Tree, frame_at, value};
use crate::fuzz::generate::corrupt::{digits, wild};
use crate::fuzz::tree::{Step, at, at_mut, int, list, literal, name_at, object, own, places, text};
use crate::json::Json;

/// What a reader has to notice wherever it stands, or to pass wherever it stands: as text of a frame.
const LEAVES: [&str; 23] = [
    "1",
    "-0",
    "1.0",
    "1e400",
    "-1E+400",
    "9007199254740993",
    "-9007199254740993",
    "1e-400",
    "01",
    "1.",
    "+1",
    "\"\\ud800\"",
    "\"\\ud83d\\ude80\"",
    "\"\\\\\\ud83d\\ude80\"",
    "\"\\\\ud83d\"",
    "\"\\\"\\ud83d\\ude80\"",
    "\"\\x\"",
    "{\"a\":1,\"a\":2}",
    "{\"a\":1,\"\\u0061\":2}",
    "{\"mode\":\"estop\"}",
    "[1,]",
    "nul",
    "\"\u{7f}\"",
];

/// A member that nobody knows, whose leaf stands deep within it, behind much, or both; how much, in bytes.
pub(super) fn buried(frame: &str, draw: &mut Draw<'_>) -> (String, usize) {
    let mut leaf = draw.pick(&LEAVES).to_owned();
    if draw.chance(15) {
        leaf = digits(draw);
    } else if draw.chance(15)
        && let Ok(own_frame) = Json::parse(frame)
    {
        // A frame of the same kind that says something else.
        let mut other = own(&own_frame);
        (0..4).for_each(|_| value(&mut other, draw));
        leaf = other.to_string();
    }
    // As deep as a frame may be, and its own levels around.
    let levels = draw.one(&[0, 0, 1, 2, 8, 31, 32, 60, 61, 62, 63, 64, 65, 100, 129, 500]);
    let is_list = draw.chance(70);
    let (open, close) = if is_list { ("[", "]") } else { ("{\"a\":", "}") };
    let crowd = if levels > 8 && draw.chance(12) { "[],".repeat(draw.size(1 << 11, 1 << 17)) } else { String::new() };
    let deep = if crowd.is_empty() {
        format!("{}{leaf}{}", open.repeat(levels), close.repeat(levels))
    } else {
        // A part of the levels is open while many brackets come and go.
        let before = 1 + draw.below(levels - 1);
        let behind = levels - before;
        format!("{}{crowd}{}{leaf}{}", "[".repeat(before), "[".repeat(behind), "]".repeat(levels))
    };
    let most = draw.one(&[60, 1 << 10, 1 << 16, 1 << 17, 300_000]);
    let size = draw.size(0, most);
    // So many brackets that what is deep begins before a power of two, and ends behind it.
    let pairs = (draw.one(&[1 << 8, 1 << 12, 1 << 15, 1 << 16]) - draw.below(100)) / 2;
    let before = match draw.below(7) {
        0 => String::new(),
        1 => format!("\"x0\":[{}],", vec!["[]"; size / 3 + 1].join(",")),
        6 => format!("\"x0\":[{}],", vec!["[]"; pairs].join(",")),
        2 => format!("\"x0\":[{}],", vec!["1"; size / 2 + 1].join(",")),
        3 => format!("\"x0\":\"{}\",", "w".repeat(size)),
        4 if draw.chance(50) => format!("\"x0\":\"{}\",", "\\u0041".repeat(size / 6)),
        // Escapes of which a border may cut one in two, and brackets behind them.
        4 => {
            let (shift, unit) = ("w".repeat(draw.below(2)), draw.pick(&["\\\"", "\\\\"]));
            format!("\"x0\":\"{shift}{}{}\",", unit.repeat(size / 2), "[".repeat(70))
        }
        _ => format!("{}\"x0\":{{}},", " ".repeat(size)),
    };
    let member = format!("{before}\"x1\":{deep}");
    let much = member.len();
    (join(frame, &member, draw.chance(50)), much)
}

/// With white space, a member that nobody knows, or a longer text or name, so that the frame has just so many bytes.
pub(super) fn fitted(frame: &str, draw: &mut Draw<'_>) -> (String, usize) {
    let limits = if draw.chance(75) {
        &[256, 512, 1024, 4096, 8192, 1 << 14, 1 << 15, 1 << 16, 1 << 16][..]
    } else {
        &[1 << 17, 1 << 20, 1 << 20, 1 << 20, 1 << 21, 1 << 22][..]
    };
    let limit = draw.one(limits);
    let total = limit + draw.below(3) - 1;
    // What is read before a long frame is parsed may be spelled strangely there.
    let spelled = Json::parse(frame).ok().filter(|_| draw.chance(30)).map(|parsed| wild(&own(&parsed), draw));
    let frame = spelled.as_deref().unwrap_or(frame);
    let rest = total.saturating_sub(frame.len());
    if spelled.is_none()
        && draw.chance(40)
        && let Some(long) = stretched(frame, rest, draw)
    {
        return (long, limit);
    }
    let long = match draw.below(3) {
        0 => format!("{frame}{}", " ".repeat(rest)),
        1 => format!("{}{frame}", " ".repeat(rest)),
        _ => {
            let frame = join(frame, "\"x\":\"\"", true);
            let rest = total.saturating_sub(frame.len());
            frame.replacen("\"x\":\"\"", &format!("\"x\":\"{}\"", "w".repeat(rest)), 1)
        }
    };
    (long, limit)
}

/// A frame of which a text or the name of an entry has so many bytes more: what a peer says about it may not fit where
/// it is to be said, the less if it needs more room there.
fn stretched(frame: &str, more: usize, draw: &mut Draw<'_>) -> Option<String> {
    let mut frame = own(&Json::parse(frame).ok()?);
    let (unit, room) = draw.one(&[("w", 1), ("w", 1), ("\u{85}", 2), ("\u{e9}", 2), ("\"", 2), ("\\", 2), ("\n", 2)]);
    let more = unit.repeat(more / room) + &"w".repeat(more % room);
    let sites: Vec<Vec<Step>> = places(&frame)
        .into_iter()
        .filter(|place| match at(&frame, place) {
            Some(Json::String(_)) => true,
            Some(Json::Object(members)) => !members.is_empty(),
            _ => false,
        })
        .collect();
    let place = sites.get(draw.below(sites.len()))?;
    match at_mut(&mut frame, place)? {
        Json::String(word) => *word = format!("{word}{more}").into(),
        Json::Object(members) => {
            let nth = draw.below(members.len());
            let name = format!("{}{more}", members[nth].0);
            members[nth].0 = name.into();
        }
        _ => return None,
    }
    Some(frame.to_string())
}

fn join(frame: &str, member: &str, front: bool) -> String {
    let inner = frame.trim();
    let empty = inner.get(1..).is_some_and(|rest| rest.trim_start().starts_with('}'));
    match (inner.strip_prefix('{'), inner.strip_suffix('}')) {
        (Some(_), Some(_)) if empty => format!("{{{member}}}"),
        (Some(rest), _) if front => format!("{{{member},{rest}"),
        (_, Some(head)) => format!("{head},{member}}}"),
        _ => frame.to_owned(),
    }
}

/// An array of many items, of which one that is not the first is wrong, or different.
pub(super) fn blemish(tree: &mut Tree, draw: &mut Draw<'_>) -> usize {
    // Where doubles stand as PROTOCOL.md, section 2, spells them, and not as a frame does.
    let is_frame = tree.get("ncp_version").is_some() || tree.get("session_id").is_some();
    let arrays: Vec<Vec<Step>> = places(tree)
        .into_iter()
        .filter(|place| {
            matches!(at(tree, place), Some(Json::Array(_)))
                && !matches!(name_at(tree, place), "steps" | "requests" | "verbs")
        })
        .collect();
    let Some(place) = arrays.get(draw.below(arrays.len())) else { return 0 };
    let Some(Json::Array(items)) = at_mut(tree, place) else { return 0 };
    let item = items.first().cloned().unwrap_or_else(|| literal("1"));
    let is_small = matches!(item, Json::Number(_));
    let most = if is_small && draw.chance(25) { 70_000 } else { 600 };
    let count = draw.size(1, most);
    let count = if is_small { count } else { draw.afford(count) };
    while items.len() < count {
        items.push(item.clone());
    }
    let at = if draw.chance(60) { items.len() } else { 1 + draw.below(items.len().max(1)) };
    let wrong = match (&item, draw.below(12)) {
        (Json::Number(spelling), 0..=4) if !spelling.contains('.') => literal(draw.pick(&[
            "9007199254740991",
            "9007199254740992",
            "-9007199254740991",
            "-9007199254740992",
            "9223372036854775808",
            "1.0",
            "1e0",
            "-0",
            "0",
            "-1",
        ])),
        (Json::Number(_), 0..=7) if !is_frame => text(draw.pick(&["NaN", "Infinity", "-Infinity", "-0"])),
        (Json::Number(_), 0..=4) => literal(draw.pick(&["1e400", "-1e400", "-0.0", "1E+2", "2e-324", "1.5"])),
        (_, 5) => Json::Null,
        (_, 6) => Json::Bool(true),
        (_, 7) => text("1"),
        (_, 8) => list(Vec::new()),
        (_, 9) => object([]),
        (_, 10) => int(draw.integer()),
        (other, _) => {
            let mut changed = (*other).clone();
            super::other_numbers(&mut changed);
            changed
        }
    };
    items.insert(at.min(items.len()), wrong);
    items.len()
}

/// A frame that is written in one of the strings, changed as text.
pub(super) fn in_a_frame(
    args: &mut Tree,
    draw: &mut Draw<'_>,
    change: fn(&str, &mut Draw<'_>) -> (String, usize),
) -> usize {
    let frames: Vec<Vec<Step>> = places(args).into_iter().filter(|place| frame_at(args, place).is_some()).collect();
    let Some(place) = frames.get(draw.below(frames.len())) else { return 0 };
    let Some(Json::String(frame)) = at_mut(args, place) else { return 0 };
    let (changed, much) = change(frame, draw);
    *frame = changed.into();
    much
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fuzz::harvest::Harvest;
    use crate::fuzz::tree::items;

    const FRAME: &str = r#"{"ncp_version":"0.5","kind":"sensor_frame","seq":7}"#;

    #[test]
    fn a_stretched_frame_is_read_as_one_and_has_so_many_bytes_more() {
        let harvest = Harvest::default();
        let (mut names, mut values) = (0, 0);
        for number in 0..60 {
            let long = stretched(FRAME, 1 << 12, &mut Draw::new(2, number, &harvest)).unwrap();
            let more = long.len() - FRAME.len();
            assert_eq!(more, 1 << 12, "{number}");
            let frame = Json::parse(&long).unwrap();
            let is_whole = ["ncp_version", "kind", "seq"].iter().all(|name| frame.get(name).is_some());
            *if is_whole { &mut values } else { &mut names } += 1;
        }
        assert!(names > 8 && values > 8, "{names} {values}");
    }

    #[test]
    fn what_is_buried_leaves_a_frame_whole_unless_its_leaf_is_no_json() {
        let harvest = Harvest::default();
        let (mut read, mut far) = (0, 0);
        for number in 0..300 {
            let (frame, much) = buried(FRAME, &mut Draw::new(2, number, &harvest));
            assert!(frame.starts_with('{') && frame.ends_with('}') && frame.contains("\"seq\":7"), "{number}");
            read += usize::from(Json::parse(&frame).is_ok_and(|frame| frame.get("x1").is_some()));
            far += usize::from(much > 1 << 16);
        }
        assert!(read > 60 && far > 20, "{read} {far}");
    }

    #[test]
    fn a_fitted_frame_has_the_same_members_but_for_a_long_name_and_is_within_a_byte_of_its_size() {
        let harvest = Harvest::default();
        let (mut exact, mut spelled, mut twice) = (0, 0, 0);
        for number in 0..120 {
            let (frame, limit) = fitted(FRAME, &mut Draw::new(2, number, &harvest));
            // What nobody reads may be longer than all of it was to be.
            assert!(frame.len() + 1 >= limit, "{} {limit}", frame.len());
            exact += usize::from(frame.len().abs_diff(limit) <= 1);
            spelled += usize::from(["ncp_version", "kind", "seq"].iter().any(|name| !frame.contains(name)));
            let members = match Json::parse(&frame) {
                Ok(frame) => own(&frame),
                // What nobody reads may have a name twice.
                Err(error) if matches!(error.what, crate::json::JsonFault::Duplicate(_)) => {
                    twice += 1;
                    continue;
                }
                Err(error) => panic!("{number}: {error}"),
            };
            let of = |known: &str| {
                crate::fuzz::tree::members(Some(&members)).iter().find(|(name, _)| name.starts_with(known)).cloned()
            };
            assert!(of("ncp_version").is_some() && of("kind").is_some(), "{number}");
            assert_eq!(of("seq").map(|(_, value)| value), Some(int(7)), "{number}");
        }
        assert!(exact > 100 && spelled > 5 && twice < 5, "{exact} {spelled} {twice}");
    }

    #[test]
    fn a_blemish_is_not_the_first_of_its_array() {
        let harvest = Harvest::default();
        let mut longest = 0;
        for number in 0..200 {
            let data = list(vec![literal("0.5"); 3]);
            let mut tree = object([("session_id", text("s")), ("data", data)]);
            blemish(&mut tree, &mut Draw::new(2, number, &harvest));
            let found = items(tree.get("data"));
            assert!(found.len() > 3 && found[0] == literal("0.5"), "{tree}");
            longest = longest.max(found.len());
        }
        assert!(longest > 1000, "{longest}");
    }
}
