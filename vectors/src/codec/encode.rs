//! From sensor channels to rates.

use super::{
    ALIKE, EXTREME, EXTREMELY, FAR_OFF, MANIFOLD, MANY, Mapping, NAMELESS, NAMELESSLY, OF_ITS_OWN, PLAIN, POINT,
    POINTEDLY, POPULATIONS, PRECISE, PRECISELY, RANGES, SHARES, STRANGE, WIDELY, codec, codec_of_both_ways, manifold,
    map, mappings_in_turn, mappings_of_names, mappings_of_one, maps, narrow, pairs, precisely, widely,
};
use crate::case::{Case, File, Role};
use crate::json::{Json, object};
use crate::names;
use crate::trace::{any, exactly, name_of, num, nums, within};

pub(super) fn file() -> File {
    let mut cases = uav();
    cases.extend(ranges());
    cases.extend(missing());
    cases.extend(mappings());
    cases.extend(alike());
    cases.extend(extreme());
    cases.extend(points());
    cases.extend(nameless());
    cases.push(both_ways());
    cases.extend(of_all_names());
    cases.extend([many(MANY), many(1_100), many(4_000), many_of_one(4_200), many_of_one(66_000)]);
    let about = "The encoder of the rate codec: the default UAV codec, ranges, clamps, and what gives the middle of \
                 the rate range.";
    File::new("codec", "encode", about, cases)
}

fn sensor(channels: &[(&str, &[f64])]) -> Json {
    let value = |(name, data): &(&str, &[f64])| ((*name).to_owned(), object! { "data" => nums(data) });
    object! { "seq" => 3_u32, "t" => num(1.0), "channels" => Json::Object(channels.iter().map(value).collect()) }
}

fn case(path: String, rules: &[&'static str], codec: Json, sensor: Json) -> Case {
    Case::new(path, rules, &[Role::Commander]).call("codec.encode", object! { "codec" => codec, "sensor" => sensor })
}

fn rates(of: &[(&str, f64)]) -> Json {
    let rates = of.iter().map(|(name, rate)| ((*name).to_owned(), num(*rate))).collect();
    object! { "rates" => exactly(Json::Object(rates)) }
}

fn err(data: [f64; 3]) -> Json {
    let rate = |x| map(x, [-2.0, 2.0], [0.0, 200.0]);
    rates(&[("err_x", rate(data[0])), ("err_y", rate(data[1])), ("err_z", rate(data[2]))])
}

fn uav() -> Vec<Case> {
    let mut cases = Vec::new();
    let table: [(&str, [f64; 3]); 14] = [
        ("zero", [0.0; 3]),
        ("ends", [-2.0, 0.0, 2.0]),
        ("other-ends", [2.0, -2.0, 0.0]),
        ("quarters", [-1.0, 1.0, 0.5]),
        ("beyond", [-3.0, 3.0, 100.0]),
        ("far-beyond", [-1e308, 1e308, 1e300]),
        ("just-beyond", [2.0009765625, -2.0009765625, 1.9990234375]),
        ("subnormal", [5e-324, -5e-324, -0.0]),
        ("x-only", [1.5, 0.0, 0.0]),
        ("y-only", [0.0, 1.5, 0.0]),
        ("z-only", [0.0, 0.0, 1.5]),
        ("negative", [-0.25, -0.5, -0.75]),
        ("fine", [0.001, -0.002, 0.003]),
        ("largest", [f64::MAX, -f64::MAX, 0.0]),
    ];
    for (name, data) in table {
        let beyond = data.iter().any(|x| x.abs() > 2.0);
        let rules: &[&'static str] = if beyond {
            &["NCP-CODEC-002", "NCP-CODEC-020"]
        } else {
            if name.ends_with("ends") || name.ends_with("-only") {
                &["NCP-CODEC-020", "NCP-CODEC-001"]
            } else {
                &["NCP-CODEC-001", "NCP-CODEC-020"]
            }
        };
        cases.push(
            case(format!("uav/{name}"), rules, "uav".into(), sensor(&[("pose_error", &data)]))
                .shows(err(data))
                .title(format!("The UAV codec encodes an error of ({}, {}, {}).", data[0], data[1], data[2]))
                .because(
                    "Each component of `pose_error` is mapped from \u{2212}2 \u{2026} 2 to 0 \u{2026} 200 Hz \
                          and clamped.",
                ),
        );
    }
    for at in 0..3 {
        for value in STRANGE {
            let mut data = [1.0, -1.0, 0.5];
            if let Some(x) = data.get_mut(at) {
                *x = value;
            }
            cases.push(
                case(
                    format!("uav/component-{at}/{}", name_of(value)),
                    &["NCP-CODEC-005"],
                    "uav".into(),
                    sensor(&[("pose_error", &data)]),
                )
                .shows_or_refuses(err(data))
                .title(format!("The UAV codec encodes a component {at} of {} as the middle rate.", name_of(value)))
                .flags(&["L06"])
                .because(
                    "A sample that is not finite gives the middle of the rate range; the others are encoded as ever.",
                ),
            );
        }
    }
    cases
}

fn ranges() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, value) in RANGES {
        for share in SHARES {
            for rate in [[0.0, 200.0], [10.0, 30.0], [-50.0, 50.0], [200.0, 0.0]] {
                let x = share.of(value);
                let mapping = Mapping { value, rate, ..PLAIN };
                let rule = share.decides("NCP-CODEC-001", "NCP-CODEC-002");
                cases.push(
                    case(
                        format!("range/{name}/{}/to-{}-{}", share.name, rate[0], rate[1]).replace("--", "-minus-"),
                        &[rule],
                        codec(&[mapping], &[]),
                        sensor(&[("x", &[x])]),
                    )
                    .shows(object! { "rates" => exactly(object! { "p" => maps(x, value, rate) }) })
                    .title(format!(
                        "{x} in {} \u{2026} {} is encoded within {} \u{2026} {} Hz ({}).",
                        value[0], value[1], rate[0], rate[1], share.name
                    ))
                    .because(
                        "The rate is r0 + (x \u{2212} v0) / (v1 \u{2212} v0) \u{b7} (r1 \u{2212} r0), \
                                  clamped to the rate range.",
                    ),
                );
            }
        }
    }
    for (name, x) in [("quarter", 0.5), ("above", -2.0)] {
        let (value, rate) = ([1.0, -1.0], [10.0, 30.0]);
        let mapping = Mapping { value, rate, ..PLAIN };
        cases.push(
            case(format!("downwards/{name}"), &["NCP-CODEC-012"], codec(&[mapping], &[]), sensor(&[("x", &[x])]))
                .shows(rates(&[("p", map(x, value, rate))]))
                .title(format!("{x} in 1 \u{2026} -1 should be encoded as by any other range ({name})."))
                .flags(&["degenerate-range"])
                .because("A source range that runs downwards should be mapped like every other."),
        );
    }
    for (name, x, value, rate) in PRECISE {
        let mapping = Mapping { value, rate, ..PLAIN };
        cases.push(
            case(format!("precise/{name}"), &["NCP-CODEC-013"], codec(&[mapping], &[]), sensor(&[("x", &[x])]))
                .shows_exactly(object! { "rates" => exactly(object! { "p" => precisely(x, value, rate) }) })
                .title(format!("{x:?} in {:?} \u{2026} {:?} is encoded to twelve digits ({name}).", value[0], value[1]))
                .because(PRECISELY),
        );
    }
    for (name, x, value, rate) in narrow() {
        let mapping = Mapping { value, rate, ..PLAIN };
        cases.push(
            case(
                format!("narrow/{name}"),
                &["NCP-CODEC-001", "NCP-CODEC-013"],
                codec(&[mapping], &[]),
                sensor(&[("x", &[x])]),
            )
            .shows(rates(&[("p", map(x, value, rate))]))
            .title(format!(
                "{x:e} in {:e} \u{2026} {:e} is encoded as in any wider range ({name}).",
                value[0], value[1]
            ))
            .flags(&["degenerate-range"])
            .because("A range is degenerate when its length is 0 or not finite, and not when it is small."),
        );
    }
    for (path, words, x, rate) in widely() {
        let mapping = Mapping { value: [-1.0, 1.0], rate, ..PLAIN };
        cases.push(
            case(path, &["NCP-CODEC-002"], codec(&[mapping], &[]), sensor(&[("x", &[x])]))
                .shows(object! { "rates" => exactly(object! { "p" => within(-1e308, 1e308) }) })
                .title(format!("{x} is encoded within a rate range whose length overflows{words}."))
                .because(WIDELY),
        );
    }
    let [low, high] = [0.0, 200.0];
    for (name, x) in FAR_OFF {
        let mapping = Mapping { value: [0.0, 1e-300], rate: [low, high], ..PLAIN };
        let path = format!("quotient/{name}");
        cases.push(
            case(path, &["NCP-CODEC-002"], codec(&[mapping], &[]), sensor(&[("x", &[x])]))
                .shows(object! { "rates" => exactly(object! { "p" => within(low, high) }) })
                .title(format!("{x:e} is encoded within {low} \u{2026} {high} Hz, though the quotient overflows."))
                .because(WIDELY),
        );
    }
    // A mapping without ranges has the defaults.
    let bare = object! { "encoders" => Json::Array(vec![object! { "channel" => "x", "component" => 0_u32,
    "population" => "p" }]), "decoders" => Json::Array(Vec::new()) };
    for x in [-1.0_f64, 0.0, 0.5, 1.0, 2.0] {
        let rules = if x.abs() > 1.0 { ["NCP-CODEC-002", "NCP-CODEC-001"] } else { ["NCP-CODEC-001", "NCP-CODEC-002"] };
        cases.push(
            case(format!("defaults/{}", name_of(x)), &rules, bare.clone(), sensor(&[("x", &[x])]))
                .shows(rates(&[("p", map(x, [-1.0, 1.0], [0.0, 200.0]))]))
                .title(format!("A mapping without ranges encodes {x} from \u{2212}1 \u{2026} 1 to 0 \u{2026} 200 Hz."))
                .because("The defaults are \u{2212}1 \u{2026} 1 and 0 \u{2026} 200 Hz."),
        );
    }
    // A codec of one side: an absent array is empty.
    let one_sided = object! { "encoders" => Json::Array(vec![PLAIN.json()]) };
    cases.push(
        case("one-sided".to_owned(), &["NCP-CODEC-001"], one_sided, sensor(&[("x", &[0.5])]))
            .shows(rates(&[("p", map(0.5, PLAIN.value, PLAIN.rate))]))
            .title("A codec that is given encoders alone encodes by them.")
            .because("Encoding takes no decoder; an absent array of mappings is empty."),
    );
    // Ranges without length.
    for (name, value) in [
        ("zero-length", [1.0, 1.0]),
        ("at-zero", [0.0, 0.0]),
        ("minus-zero", [-0.0, 0.0]),
        ("nan-low", [f64::NAN, 1.0]),
        ("nan-high", [0.0, f64::NAN]),
        ("infinite", [f64::NEG_INFINITY, f64::INFINITY]),
        ("infinite-high", [0.0, f64::INFINITY]),
    ] {
        for x in [0.0, 1.0, -5.0] {
            let mapping = Mapping { value, rate: [20.0, 60.0], ..PLAIN };
            let case = case(
                format!("degenerate/{name}/{}", name_of(x)),
                &["NCP-CODEC-007"],
                codec(&[mapping], &[]),
                sensor(&[("x", &[x])]),
            )
            .title(format!("A value range without a finite length ({name}) encodes {x} as the middle rate."))
            .because("A source range that is degenerate gives the middle of the target range, here 40 Hz.");
            let expected = rates(&[("p", 40.0)]);
            cases.push(if value.iter().all(|end| end.is_finite()) {
                case.shows(expected)
            } else {
                case.shows_or_refuses(expected)
            });
        }
    }
    cases
}

fn missing() -> Vec<Case> {
    let middle = || rates(&[("err_x", 100.0), ("err_y", 100.0), ("err_z", 100.0)]);
    let table: [(&str, &str, Json, Json); 8] = [
        ("no-frame", "no sensor frame", Json::Null, middle()),
        ("no-channels", "a frame without channels", sensor(&[]), middle()),
        ("other-channel", "a frame with another channel", sensor(&[("pose_position", &[2.0, 2.0, 2.0])]), middle()),
        ("other-case", "a channel in another case", sensor(&[("Pose_Error", &[2.0, 2.0, 2.0])]), middle()),
        ("empty", "an empty channel", sensor(&[("pose_error", &[])]), middle()),
        ("one-component", "one component", sensor(&[("pose_error", &[2.0])]), err([2.0, 0.0, 0.0])),
        ("two-components", "two components", sensor(&[("pose_error", &[2.0, -2.0])]), err([2.0, -2.0, 0.0])),
        (
            "four-components",
            "a component more than is mapped",
            sensor(&[("pose_error", &[2.0, -2.0, 1.0, 9.0])]),
            err([2.0, -2.0, 1.0]),
        ),
    ];
    let mut cases: Vec<Case> = table
        .into_iter()
        .map(|(name, words, sensor, expected)| {
            case(format!("missing/{name}"), &["NCP-CODEC-005"], "uav".into(), sensor)
                .shows(expected)
                .title(format!("The UAV codec encodes {words} as the middle rate where nothing is."))
                .flags(&["L06"])
                .because("An absent channel or a missing component gives the middle of the rate range, 100 Hz.")
        })
        .collect();
    for (name, value, rate) in [
        ("asymmetric", [0.0, 10.0], [10.0, 30.0]),
        ("negative", [-8.0, -4.0], [-50.0, 0.0]),
        ("inverted", [1.0, -1.0], [0.0, 80.0]),
        ("huge", [0.0, 1.0], [1e308, 1.5e308]),
    ] {
        let nothing: [(&str, &str, Json); 5] = [
            ("", "An absent channel", sensor(&[])),
            ("/no-frame", "A missing sensor frame", Json::Null),
            ("/other-channel", "A frame without the channel", sensor(&[("y", &[0.5])])),
            ("/empty", "An empty channel", sensor(&[("x", &[])])),
            ("/nan", "A sample that is no number", sensor(&[("x", &[f64::NAN])])),
        ];
        for (with, words, sensor) in nothing {
            let mapping = Mapping { value, rate, ..PLAIN };
            let case = case(format!("missing/{name}{with}"), &["NCP-CODEC-005"], codec(&[mapping], &[]), sensor)
                .title(format!("{words} gives the middle of the rate range, also of one that is {name}."))
                .flags(&["L06"])
                .because("What is absent gives the middle of the rate range, not 0 and not the rate of the value 0.");
            let middle = rates(&[("p", f64::midpoint(rate[0], rate[1]))]);
            cases.push(if with == "/nan" { case.shows_or_refuses(middle) } else { case.shows(middle) });
        }
    }
    cases
}

fn mappings() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, other) in pairs(PLAIN) {
        // Two populations in each pair, since of mappings to one only the last counts.
        let other = Mapping { population: "q", ..other };
        let data = |channel: &str| if channel == "x" { [0.5, -0.25] } else { [0.125, 0.25] };
        let rate = |of: &Mapping| {
            let place = usize::try_from(of.component).unwrap_or_default();
            map(data(of.channel).get(place).copied().unwrap_or_default(), of.value, of.rate)
        };
        let sensed = || sensor(&[("x", &data("x")), ("y", &data("y"))]);
        for (order, mappings) in [("after", [PLAIN, other]), ("before", [other, PLAIN])] {
            cases.push(
                case(format!("pair/{name}/{order}"), &["NCP-CODEC-001"], codec(&mappings, &[]), sensed())
                    .shows(rates(&[("p", rate(&PLAIN)), ("q", rate(&other))]))
                    .title(format!(
                        "Of two mappings that differ in {} alone each encodes as it says ({order}).",
                        name.replace('-', " ")
                    ))
                    .because("The encoder maps each mapping's value by that mapping's ranges."),
            );
        }
    }
    for component in [4096_u32, 4097, 65_536, 4_294_967_295] {
        let far = Mapping { component, population: "far", ..PLAIN };
        let near = Mapping { component: 1, population: "near", ..PLAIN };
        let with = |middle: bool| {
            let mut all = vec![("near", 150.0)];
            if middle {
                all.push(("far", 100.0));
            }
            rates(&all)
        };
        cases.push(
            case(
                format!("ignored/{component}"),
                &["NCP-CODEC-008"],
                codec(&[far, near], &[]),
                sensor(&[("x", &[0.0, 0.5])]),
            )
            .shows(any(vec![with(false), with(true)]))
            .title(format!("A mapping of component {component} is ignored, and the others are not."))
            .because(
                "A mapping with a component of 4,096 or more is ignored; that its population rests at the \
                          middle is as good.",
            ),
        );
    }
    for component in [4096_u32, 4097] {
        // As wide as the component asks for.
        let far = Mapping { component, population: "far", ..PLAIN };
        let near = Mapping { component: 1, population: "near", ..PLAIN };
        let middle = rates(&[("near", 150.0), ("far", 100.0)]);
        cases.push(
            case(
                format!("ignored/{component}-of-4100"),
                &["NCP-CODEC-008"],
                codec(&[far, near], &[]),
                sensor(&[("x", &[0.5; 4_100])]),
            )
            .shows(any(vec![rates(&[("near", 150.0)]), middle]))
            .title(format!("A mapping of component {component} is ignored, also where the channel has it."))
            .because("A mapping with a component of 4,096 or more is ignored, however wide its channel is."),
        );
    }
    // As if it were not there: it takes nothing from the other mapping of its population.
    for component in [4096_u32, 4097] {
        let far = Mapping { component, ..PLAIN };
        for (order, both) in [("before", [far, PLAIN]), ("behind", [PLAIN, far])] {
            cases.push(
                case(
                    format!("ignored/{component}-of-a-population/{order}"),
                    &["NCP-CODEC-008"],
                    codec(&both, &[]),
                    sensor(&[("x", &[0.5])]),
                )
                .shows(rates(&[("p", 150.0)]))
                .title(format!(
                    "A mapping of component {component} is ignored {order} another of its population, which counts."
                ))
                .because("A mapping that is ignored is as if it were not there."),
            );
        }
    }
    let in_a_row = [4096, 4097, 5000].map(|component| Mapping { component, ..PLAIN });
    let in_a_row = [&in_a_row[..], &[PLAIN], &in_a_row[..]].concat();
    cases.push(
        case("ignored/in-a-row".to_owned(), &["NCP-CODEC-008"], codec(&in_a_row, &[]), sensor(&[("x", &[0.5])]))
            .shows(rates(&[("p", 150.0)]))
            .title("Mappings of component 4,096 and more are ignored, however many follow each other.")
            .because("A mapping that is ignored is as if it were not there."),
    );
    let last = Mapping { component: 4095, ..PLAIN };
    cases.push(
        case("ignored/not-4095".to_owned(), &["NCP-CODEC-005"], codec(&[last], &[]), sensor(&[("x", &[0.0])]))
            .shows(rates(&[("p", 100.0)]))
            .title("A mapping of component 4,095 is not ignored.")
            .because("A missing component gives the middle of the rate range."),
    );
    let many = [
        Mapping { channel: "a", population: "a0", ..PLAIN },
        Mapping { channel: "a", component: 1, population: "a1", ..PLAIN },
        Mapping { channel: "b", population: "b0", value: [0.0, 4.0], rate: [0.0, 80.0], ..PLAIN },
        Mapping { channel: "a", population: "again", rate: [0.0, 100.0], ..PLAIN },
    ];
    cases.push(
        case(
            "several".to_owned(),
            &["NCP-CODEC-001"],
            codec(&many, &[]),
            sensor(&[("a", &[0.5, -0.5]), ("b", &[1.0])]),
        )
        .shows(rates(&[("a0", 150.0), ("a1", 50.0), ("b0", 20.0), ("again", 75.0)]))
        .title("Each mapping has its own channel, component and ranges.")
        .because("The encoder maps each mapping's value by that mapping's ranges."),
    );
    let twice = [
        Mapping { channel: "a", ..PLAIN },
        Mapping { channel: "b", population: "q", ..PLAIN },
        Mapping { channel: "b", value: [0.0, 4.0], rate: [0.0, 80.0], ..PLAIN },
    ];
    cases.push(
        case(
            "one-population-twice".to_owned(),
            &["NCP-CODEC-014"],
            codec(&twice, &[]),
            sensor(&[("a", &[0.5]), ("b", &[1.0])]),
        )
        .shows(rates(&[("p", 20.0), ("q", 200.0)]))
        .title("Of two mappings to one population the last should count.")
        .because("Of mappings with one target, here a population, the last should count."),
    );
    cases.push(
        case("none".to_owned(), &["NCP-CODEC-001"], codec(&[], &[]), sensor(&[("a", &[0.5])]))
            .shows(rates(&[]))
            .title("A codec without mappings gives no rates.")
            .because("Each mapping gives one rate; there are none."),
    );
    cases
}

/// Ranges at either end of the doubles.
fn extreme() -> Vec<Case> {
    let rate = [0.0, 100.0];
    EXTREME
        .into_iter()
        .map(|(name, x, value)| {
            let mapping = Mapping { value, rate, ..PLAIN };
            case(
                format!("extreme/{name}"),
                &["NCP-CODEC-001", "NCP-CODEC-007", "NCP-CODEC-013"],
                codec(&[mapping], &[]),
                sensor(&[("x", &[x])]),
            )
            .shows(rates(&[("p", map(x, value, rate))]))
            .title(format!(
                "{x:e} in {:e} \u{2026} {:e} is encoded as in any other range ({name}).",
                value[0], value[1]
            ))
            .flags(&["degenerate-range"])
            .because(EXTREMELY)
        })
        .collect()
}

/// Rate ranges of length 0.
fn points() -> Vec<Case> {
    FAR_OFF
        .into_iter()
        .map(|(side, x)| {
            let mapping = Mapping { value: [0.0, 1e-300], rate: [POINT; 2], ..PLAIN };
            let path = format!("point/five/{side}");
            case(path, &["NCP-CODEC-002"], codec(&[mapping], &[]), sensor(&[("x", &[x])]))
                .shows_exactly(rates(&[("p", POINT)]))
                .title(format!("A rate range of the one number {POINT} gives that number for {x:e}."))
                .because(POINTEDLY)
        })
        .collect()
}

/// Channels and populations of an empty name.
fn nameless() -> Vec<Case> {
    let mut cases: Vec<Case> = NAMELESS
        .into_iter()
        .map(|(name, channel, population, words)| {
            let mapping = Mapping { channel, population, ..PLAIN };
            case(format!("nameless/{name}"), &["NCP-CODEC-001"], codec(&[mapping], &[]), sensor(&[(channel, &[0.5])]))
                .shows(rates(&[(population, 150.0)]))
                .title(format!("The encoder maps {words} of the empty name like every other."))
                .because(NAMELESSLY)
        })
        .collect();
    let mapping = Mapping { channel: "", ..PLAIN };
    cases.push(
        case("nameless/absent".to_owned(), &["NCP-CODEC-005"], codec(&[mapping], &[]), sensor(&[("x", &[0.5])]))
            .shows(rates(&[("p", 100.0)]))
            .title("A channel of the empty name that is absent gives the middle of the rate range.")
            .because(NAMELESSLY),
    );
    cases
}

/// So many mappings, of which the last two have a population of their own.
fn many(count: u32) -> Case {
    let data = [vec![0.5; count as usize - 2], vec![-0.5; 2]].concat();
    let codec = object! { "encoders" => mappings_in_turn(count), "decoders" => Json::Array(Vec::new()) };
    case(manifold(count), &["NCP-CODEC-001"], codec, sensor(&[("x", &data)]))
        .shows(rates(&[("p", 150.0), ("q", 50.0)]))
        .title(format!("A codec of {count} mappings encodes by each of them."))
        .because(MANIFOLD)
}

/// So many mappings of one component to one population, and one of another.
fn many_of_one(count: u32) -> Case {
    let codec = object! { "encoders" => mappings_of_one(count), "decoders" => Json::Array(Vec::new()) };
    case(manifold(count), &["NCP-CODEC-001"], codec, sensor(&[("x", &[0.5, -0.5])]))
        .shows(rates(&[("p", 150.0), ("q", 50.0)]))
        .title(format!(
            "A codec of {count} mappings, \
             all but the last of one component to one population, encodes by the last."
        ))
        .because(MANIFOLD)
}

/// Components that a careless name for them confuses: written together with their channel, or of channels whose names
/// are alike.
fn alike() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, components, words) in ALIKE {
        for order in ["in-order", "reversed"] {
            if order == "reversed" && !name.starts_with("joined") {
                continue;
            }
            let mut mappings: Vec<Mapping> = Vec::new();
            let mut sensed: Vec<(&str, Vec<f64>)> = Vec::new();
            let mut expected = Vec::new();
            for ((channel, component), population) in components.iter().copied().zip(POPULATIONS) {
                // A value for each, far from all others and from 0.
                #[expect(clippy::cast_precision_loss, reason = "a few mappings")]
                let value = (mappings.len() as f64 + 1.0) / 16.0;
                mappings.push(Mapping { channel, component, population, ..PLAIN });
                expected.push((population, map(value, PLAIN.value, PLAIN.rate)));
                let width = component as usize + 1;
                let at = sensed.iter().position(|(known, _)| *known == channel).unwrap_or_else(|| {
                    sensed.push((channel, Vec::new()));
                    sensed.len() - 1
                });
                if let Some((_, data)) = sensed.get_mut(at) {
                    data.resize(data.len().max(width), 0.0);
                    data[width - 1] = value;
                }
            }
            if order == "reversed" {
                mappings.reverse();
            }
            let sensed: Vec<(&str, &[f64])> = sensed.iter().map(|(name, data)| (*name, &data[..])).collect();
            cases.push(
                case(
                    format!("alike/{name}/{order}"),
                    &["NCP-CODEC-001", "NCP-CODEC-002"],
                    codec(&mappings, &[]),
                    sensor(&sensed),
                )
                .shows(rates(&expected))
                .title(format!("Each of several components {words} has its own rate ({}).", order.replace('-', " ")))
                .because("The encoder maps the value of the component that the mapping names, and of no other."),
            );
        }
        cases.extend(alike_populations(name, components, words));
    }
    cases
}

/// A population that the encoder drives and the decoder reads, with ranges of its own on each side.
fn both_ways() -> Case {
    case("both-ways".to_owned(), &["NCP-CODEC-001"], codec_of_both_ways(), sensor(&[(PLAIN.channel, &[1.0])]))
        .shows(rates(&[(PLAIN.population, 75.0)]))
        .title("The encoder maps by its own ranges to a population that the decoder reads by others.")
        .because(OF_ITS_OWN)
}

/// Channels, and populations, of all names that are alike.
fn of_all_names() -> [Case; 2] {
    let values: Vec<f64> = (1_u32..).zip(names::alike()).map(|(nth, _)| f64::from(nth) / 128.0).collect();
    let hertz = values.iter().map(|value| map(*value, PLAIN.value, PLAIN.rate));
    let of = |are_channels| {
        object! { "encoders" => mappings_of_names(are_channels), "decoders" => Json::Array(Vec::new()) }
    };
    let all: Vec<&str> = names::alike().map(|(name, _)| name).collect();
    let numbered: Vec<String> = (0..all.len()).map(|nth| format!("p{nth}")).collect();
    let each: Vec<(&str, &[f64])> = all.iter().copied().zip(values.chunks(1)).collect();
    let by_number: Vec<(&str, f64)> = numbered.iter().map(String::as_str).zip(hertz.clone()).collect();
    let by_name: Vec<(&str, f64)> = all.iter().copied().zip(hertz).collect();
    [("channels", true, sensor(&each), by_number), ("populations", false, sensor(&[("x", &values)]), by_name)].map(
        |(what, are_channels, sensor, expected)| {
            case(format!("alike/{what}/all"), &["NCP-CODEC-001", "NCP-CODEC-002"], of(are_channels), sensor)
                .shows(rates(&expected))
                .title(format!("Each of {} {what} whose names are alike has its own rate.", all.len()))
                .because("Names are compared letter for letter, and a mapping is of those that it names.")
        },
    )
}

/// The same names of populations, each of which is driven by a component of one channel.
fn alike_populations(name: &str, components: &[(&'static str, u32)], words: &str) -> Option<Case> {
    if components.iter().any(|(_, component)| *component > 0) {
        return None; // They differ in more than the names of their channels.
    }
    let (mut mappings, mut data, mut expected) = (Vec::new(), Vec::new(), Vec::new());
    for ((population, _), component) in components.iter().copied().zip(0_u32..) {
        let value = (f64::from(component) + 1.0) / 16.0;
        mappings.push(Mapping { component, population, ..PLAIN });
        data.push(value);
        expected.push((population, map(value, PLAIN.value, PLAIN.rate)));
    }
    let words = words.replace("of channels whose names", "that").replace("of channels whose long names", "that");
    let case = case(
        format!("alike/populations/{name}"),
        &["NCP-CODEC-001", "NCP-CODEC-002"],
        codec(&mappings, &[]),
        sensor(&[("x", &data)]),
    );
    let case = case
        .shows(rates(&expected))
        .title(format!("Each of several populations with names {words} has a rate of its own."))
        .because(
            "Each mapping gives the rate of the population that it names, and names are compared letter for letter.",
        );
    Some(case)
}
