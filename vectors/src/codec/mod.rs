//! Area `codec`: the rate codec, both ways.

mod decode;
mod encode;

use crate::case::File;
use crate::json::{Json, object};
use crate::names::{self, LONG_NAMES};
use crate::trace::{any, num, nums, within};

pub(crate) fn files() -> Vec<File> {
    vec![encode::file(), decode::file()]
}

/// A mapping between a component and a population, with its ranges.
#[derive(Clone, Copy)]
struct Mapping {
    channel: &'static str,
    component: u32,
    population: &'static str,
    value: [f64; 2],
    rate: [f64; 2],
}

const PLAIN: Mapping = Mapping { channel: "x", component: 0, population: "p", value: [-1.0, 1.0], rate: [0.0, 200.0] };

impl Mapping {
    fn json(&self) -> Json {
        object! {
            "channel" => self.channel,
            "component" => self.component,
            "population" => self.population,
            "value_range" => nums(&self.value),
            "rate_range" => nums(&self.rate),
        }
    }
}

fn codec(encoders: &[Mapping], decoders: &[Mapping]) -> Json {
    object! {
        "encoders" => encoders.iter().map(Mapping::json).collect::<Json>(),
        "decoders" => decoders.iter().map(Mapping::json).collect::<Json>(),
    }
}

/// The linear map of chapter 9 with its clamp: plain, as the text writes it.
fn map(x: f64, from: [f64; 2], to: [f64; 2]) -> f64 {
    let middle = f64::midpoint(to[0], to[1]);
    let span = from[1] - from[0];
    if !x.is_finite() || !span.is_finite() || span == 0.0 {
        return middle;
    }
    (to[0] + (x - from[0]) / span * (to[1] - to[0])).clamp(to[0].min(to[1]), to[0].max(to[1]))
}

/// What may come of the map: the middle too, if the source runs downwards and is taken for degenerate.
fn maps(x: f64, from: [f64; 2], to: [f64; 2]) -> Json {
    let mut all = vec![map(x, from, to)];
    let middle = f64::midpoint(to[0], to[1]);
    if from[0] > from[1] && !all.contains(&middle) {
        all.push(middle);
    }
    any(all.into_iter().map(num).collect())
}

/// The map as exactly as rule 13 asks for it.
fn precisely(x: f64, from: [f64; 2], to: [f64; 2]) -> Json {
    let (result, off) = (map(x, from, to), 1e-12 * to[0].abs().max(to[1].abs()));
    within(result - off, result + off)
}

/// Maps on which a careless order of the operations shows, or a rounding on the way: a place, the range that it is
/// mapped from, and the one that it is mapped to. The differences of each are exact, so that the plain formula is off
/// by a few roundings only.
///
/// The last four are ranges of which the quotient of lengths is no normal double, though every step of the formula is.
const PRECISE: [(&str, f64, [f64; 2], [f64; 2]); 15] = [
    ("far-from-zero", 1_000_000.3, [1_000_000.0, 1_000_000.7], [0.0, 1.0]),
    ("far-below-zero", -4_000_000.4, [-4_000_000.9, -4_000_000.2], [-1.0, 1.0]),
    ("far-and-downwards", 70_000.1, [70_000.0, 70_000.3], [1.0, 0.0]),
    ("some-way-from-zero", 40_000.3, [40_000.0, 40_000.7], [0.0, 1.0]),
    ("some-way-below-zero", -50_000.4, [-50_000.9, -50_000.1], [-1.0, 1.0]),
    ("seconds-of-an-epoch", 1_700_000_000.123, [1.7e9, 1_700_000_001.0], [0.0, 100.0]),
    ("to-a-small-range", 0.123_456_789, [-1.0, 1.0], [0.0, 1e-3]),
    ("to-a-smaller-range", 61.7, [0.0, 200.0], [-1e-7, 1e-7]),
    ("from-a-small-range", 1.7e-9, [0.0, 3e-9], [0.0, 200.0]),
    ("from-huge-to-tiny", 3.1e299, [0.0, 9e299], [0.0, 7e-20]),
    ("from-huge-to-tiny-signed", -2.3e150, [-7e150, 7e150], [-3e-160, 3e-160]),
    ("from-tiny-to-tiny", 1.1e-200, [0.0, 3e-200], [0.0, 7e-120]),
    ("from-small-to-small", 1.23e-170, [-3e-170, 3e-170], [-7e-150, 3e-150]),
    ("from-tiny-to-huge", 1.1e-200, [0.0, 3e-200], [0.0, 7e120]),
    ("from-tiny-to-huge-signed", -2.3e-160, [-7e-160, 7e-160], [-3e150, 3e150]),
];
const PRECISELY: &str =
    "The result is what the formula says to 10\u{207b}\u{b9}\u{b2} of the greater end of the target range.";

/// Lengths of a source range, down to where the doubles of it are still normal.
const NARROW: [f64; 8] = [1e-6, 1e-9, 3e-11, 1e-12, 5e-13, 1e-15, 1e-100, 1e-290];

/// A narrow range at 0 and about it, in either direction of what it is mapped to, with a place in it: its name, the
/// place, and both ranges.
fn narrow() -> Vec<(String, f64, [f64; 2], [f64; 2])> {
    let mut all = Vec::new();
    for length in NARROW {
        all.push((format!("at-zero/{length:e}"), length * 0.25, [0.0, length], [0.0, 100.0]));
        all.push((format!("about-zero/{length:e}"), length * 0.5, [-length, length], [60.0, 20.0]));
    }
    // Differences of doubles that lie next to each other are exact.
    for power in [20, 36, 44] {
        let length = 2.0_f64.powi(-power);
        let name = format!("at-one/2-to-minus-{power}");
        all.push((name, 1.0 + length * 0.25, [1.0, 1.0 + length], [0.0, 100.0]));
    }
    all
}

/// A source range near one end of the doubles, or near the other, with a place in it: each step of the map is still a
/// normal double.
const EXTREME: [(&str, f64, [f64; 2]); 3] = [
    ("short/1e-305", 2.5e-306, [0.0, 1e-305]),
    ("short/3e-308", 2.3e-308, [0.0, 3e-308]),
    ("long/1.7e308", 4.25e307, [0.0, 1.7e308]),
];
const EXTREMELY: &str =
    "A range is degenerate when its length is 0 or not finite: neither a short one is, nor a long one.";

/// Names of a channel and of a population, of which one is empty, in a path and in words.
const NAMELESS: [(&str, &str, &str, &str); 2] =
    [("channel", "", "p", "a channel"), ("population", "x", "", "a population")];
const NAMELESSLY: &str = "An empty name is a name of a population or a channel like every other.";

/// So many mappings that an index of a byte ends before the last.
const MANY: u32 = 258;
const MANIFOLD: &str = "Each mapping is followed; there is no limit to their number.";

/// The path of a case of so many mappings.
fn manifold(count: u32) -> String {
    if count == MANY { "many".to_owned() } else { format!("many/{count}") }
}

/// What overflows when it is divided by the length of a source range of 1e-300, on either side of it.
const FAR_OFF: [(&str, f64); 2] = [("above", 1e300), ("below", -1e300)];
/// The one number of a target range of length 0.
const POINT: f64 = 5.0;
const POINTEDLY: &str =
    "A result whose step on the way overflows is clamped all the same, and the range has one number.";

/// Two mappings that differ in one thing, which is the name of the pair.
fn pairs(one: Mapping) -> [(&'static str, Mapping); 7] {
    [
        ("channel", Mapping { channel: "y", ..one }),
        ("component", Mapping { component: 1, ..one }),
        ("population", Mapping { population: "q", ..one }),
        ("value-low", Mapping { value: [-3.0, 1.0], ..one }),
        ("value-high", Mapping { value: [-1.0, 3.0], ..one }),
        ("rate-low", Mapping { rate: [-100.0, 200.0], ..one }),
        ("rate-high", Mapping { rate: [0.0, 400.0], ..one }),
    ]
}

/// A codec whose encoder drives a population that its decoder reads, with ranges of their own.
fn codec_of_both_ways() -> Json {
    let encoder = Mapping { value: [-2.0, 2.0], rate: [0.0, 100.0], ..PLAIN };
    let decoder = Mapping { value: [-8.0, 8.0], rate: [0.0, 400.0], ..PLAIN };
    codec(&[encoder], &[decoder])
}

const OF_ITS_OWN: &str = "A mapping of the encoder and one of the decoder have each the ranges that it names.";

/// Numbers that JSON lacks: an interface of JSON texts refuses them.
const STRANGE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// Ranges of a source, their names, and whether they are degenerate.
const RANGES: [(&str, [f64; 2]); 6] = [
    ("default", [-1.0, 1.0]),
    ("uav", [-2.0, 2.0]),
    ("positive", [0.0, 10.0]),
    ("negative", [-8.0, -4.0]),
    ("inverted", [1.0, -1.0]),
    ("wide", [-1e6, 1e6]),
];

/// A place by its share of a range: 0 is its first end, 1 its second.
#[derive(Clone, Copy)]
struct Share {
    name: &'static str,
    share: f64,
}

impl Share {
    /// The number at that place.
    fn of(self, range: [f64; 2]) -> f64 {
        range[0] + self.share * (range[1] - range[0])
    }

    /// The rule of the map within the range, that of the clamp outside of it.
    fn decides(self, map: &'static str, clamp: &'static str) -> &'static str {
        if (0.0..=1.0).contains(&self.share) { map } else { clamp }
    }
}

/// Places within a range and outside of it.
const SHARES: [Share; 6] = [
    Share { name: "low", share: 0.0 },
    Share { name: "quarter", share: 0.25 },
    Share { name: "middle", share: 0.5 },
    Share { name: "high", share: 1.0 },
    Share { name: "below", share: -0.5 },
    Share { name: "above", share: 1.5 },
];

/// Mappings of all names that are alike: each of a channel with a population of its own, or each of a population with a
/// component of its own.
fn mappings_of_names(are_channels: bool) -> Json {
    let mapping = |(nth, (name, _)): (u32, (&str, bool))| {
        let population = format!("p{nth}");
        let (channel, component, population) = if are_channels { (name, 0, &*population) } else { ("x", nth, name) };
        object! { "channel" => channel, "component" => component, "population" => population }
    };
    (0_u32..).zip(names::alike()).map(mapping).collect()
}

/// So many mappings between the components of a channel in turn and one population, the last two and another.
fn mappings_in_turn(count: u32) -> Json {
    // Of one target the last should count, so all that have one say the same.
    let mapping = |nth: u32| {
        let population = if nth < count - 2 { "p" } else { "q" };
        object! { "channel" => "x", "component" => nth, "population" => population }
    };
    (0..count).map(mapping).collect()
}

/// So many mappings between one component and one population, the last between others.
fn mappings_of_one(count: u32) -> Json {
    let mapping = |component: u32, population: &str| {
        object! { "channel" => "x", "component" => component, "population" => population }
    };
    (1..count).map(|_| mapping(0, "p")).chain([mapping(1, "q")]).collect()
}

/// A name, components that are easily confused with each other, by their channel and their number, and what they are.
type Alike = (&'static str, &'static [(&'static str, u32)], &'static str);

const ALIKE: [Alike; 8] = [
    (
        "joined",
        &[("ray1", 0), ("ray", 10), ("ray11", 1), ("ray1", 11), ("ray", 111), ("ray1", 1), ("ray", 11)],
        "that are the same when channel and number are written together",
    ),
    (
        "joined-number-first",
        &[("0ray", 1), ("ray", 10), ("1ray", 1), ("ray", 11), ("11ray", 1), ("1ray", 11), ("ray", 111)],
        "that are the same when number and channel are written together",
    ),
    (
        "names",
        &[
            ("x", 0),
            ("X", 0),
            ("x ", 0),
            (" x", 0),
            ("x\u{301}", 0),
            ("\u{ff58}", 0),
            ("a.b", 0),
            ("a_b", 0),
            ("a-b", 0),
            ("a/b", 0),
            ("Aa", 0),
            ("BB", 0),
        ],
        "of channels whose names are alike",
    ),
    (
        "numbers",
        &[("1", 0), ("01", 0), ("1.0", 0), ("1e0", 0), ("+1", 0), ("\u{e9}", 0), ("e\u{301}", 0), ("\u{212b}", 0)],
        "of channels whose names are equal as numbers or normalised",
    ),
    (
        "long-names",
        &[
            ("a_channel_of_a_name_of_sixty_four_characters_and_a_number_behind_1", 0),
            ("a_channel_of_a_name_of_sixty_four_characters_and_a_number_behind_2", 0),
            ("a_channel_of_a_name_of_sixty_four_characters_and_a_number_behind_", 0),
            ("a_channel_of_a_name_of_sixteen", 0),
            ("a_channel", 0),
            ("a_channe", 0),
        ],
        "of channels whose long names begin alike",
    ),
    (
        "names-of-1024",
        &[(LONG_NAMES[0], 0), (LONG_NAMES[1], 0)],
        "of channels whose long names agree in 1,023 characters",
    ),
    (
        "letters",
        &[("\u{c5}", 0), ("A\u{30a}", 0), ("\u{e5}", 0), ("\u{3c3}", 0), ("\u{3c2}", 0), ("\u{df}", 0), ("ss", 0)],
        "of channels whose names are equal but for case and form",
    ),
    (
        "nul",
        &[("p\0a", 0), ("p", 0), ("p\0b", 0), ("p\0", 0), ("\0", 0), ("", 0)],
        "of channels whose names are equal up to a U+0000",
    ),
];

/// Samples for a target range whose length overflows.
const WIDE: [(&str, f64); 7] = [
    ("first-end", -1.0),
    ("last-end", 1.0),
    ("below", -3.0),
    ("above", 3.0),
    ("middle", 0.0),
    ("quarter", -0.5),
    ("near-the-end", 0.999),
];
/// Each of them with each such range: the end of a path, the range in words, the sample, and from where to where.
fn widely() -> impl Iterator<Item = (String, String, f64, [f64; 2])> {
    let ranges = [("", "", [-1e308, 1e308]), ("-downwards", " and that runs downwards", [1e308, -1e308])];
    WIDE.into_iter().flat_map(move |(name, sample)| {
        ranges.map(|(way, words, range)| (format!("wide{way}/{name}"), format!("{words} ({name})"), sample, range))
    })
}

const WIDELY: &str = "By how much a result is off where a step on the way overflows is left open; its clamp holds \
                      there, too, and what is no number is within no range.";

/// Populations, whose names say nothing of their mappings.
const POPULATIONS: [&str; 12] = ["p", "q", "r", "s", "t", "u", "v", "w", "k", "l", "m", "n"];
