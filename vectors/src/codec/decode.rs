//! From rates to a command.

use super::{
    ALIKE, EXTREME, EXTREMELY, FAR_OFF, MANIFOLD, MANY, Mapping, NAMELESS, NAMELESSLY, OF_ITS_OWN, PLAIN, POINT,
    POINTEDLY, POPULATIONS, PRECISE, PRECISELY, RANGES, SHARES, STRANGE, WIDELY, codec, codec_of_both_ways, manifold,
    map, mappings_in_turn, mappings_of_names, mappings_of_one, maps, narrow, pairs, precisely, widely,
};
use crate::case::{Case, File, Role};
use crate::json::{Json, object};
use crate::names;
use crate::trace::{any, int, name_of, num, nums, within};

pub(super) fn file() -> File {
    let mut cases = uav();
    cases.extend(ranges());
    cases.extend(zeros());
    cases.extend(mappings());
    cases.extend(heads());
    cases.extend(alike());
    cases.extend(extreme());
    cases.extend(points());
    cases.extend(nameless());
    cases.push(both_ways());
    cases.extend(of_all_names());
    cases.extend([many(MANY), many(1_100), many(4_000), many_of_one(4_200), many_of_one(66_000)]);
    let about = "The decoder of the rate codec: the default UAV codec, ranges, clamps, and the command that is built.";
    File::new("codec", "decode", about, cases)
}

fn case(path: String, rules: &[&'static str], codec: Json, rates: &[(&str, f64)]) -> Case {
    let rates = rates.iter().map(|(name, rate)| ((*name).to_owned(), num(*rate))).collect();
    Case::new(path, rules, &[Role::Commander]).call(
        "codec.decode",
        object! { "codec" => codec, "rates" => Json::Object(rates), "t" => num(2.5), "seq" => int(42),
        "frame_id" => "world", "mode" => "active" },
    )
}

fn channels(of: Vec<(&str, Vec<f64>)>) -> Json {
    let channels = of.into_iter().map(|(name, data)| (name.to_owned(), object! { "data" => nums(&data) })).collect();
    object! { "command" => object! { "channels" => Json::Object(channels) } }
}

fn velocity(rates: [Option<f64>; 3]) -> Json {
    let of = |rate: Option<f64>| map(rate.unwrap_or(f64::NAN), [0.0, 200.0], [-1.5, 1.5]);
    let data = nums(&rates.map(of));
    object! { "command" => object! { "mode" => "active",
    "channels" => object! { "velocity_setpoint" => object! { "data" => data } } } }
}

/// And the unit of the table, which only the cases of that rule ask for.
fn in_metres_a_second(expected: Json) -> Json {
    expected.edit(&["command", "channels", "velocity_setpoint"], |channel| channel.with("unit", "m/s".into()))
}

fn uav() -> Vec<Case> {
    let mut cases = Vec::new();
    let table: [(&str, [f64; 3]); 13] = [
        ("middle", [100.0; 3]),
        ("ends", [0.0, 100.0, 200.0]),
        ("other-ends", [200.0, 0.0, 100.0]),
        ("quarters", [50.0, 150.0, 25.0]),
        ("beyond", [-1.0, 201.0, 1e6]),
        ("far-beyond", [-1e308, 1e308, 1e300]),
        ("subnormal", [5e-324, -5e-324, -0.0]),
        ("x-only", [175.0, 100.0, 100.0]),
        ("y-only", [100.0, 175.0, 100.0]),
        ("z-only", [100.0, 100.0, 175.0]),
        ("silent", [0.0; 3]),
        ("largest", [f64::MAX, -f64::MAX, 100.0]),
        ("fine", [100.1, 99.9, 0.001]),
    ];
    let names = ["vel_x", "vel_y", "vel_z"];
    for (name, data) in table {
        let rates: Vec<(&str, f64)> = names.into_iter().zip(data).collect();
        let beyond = data.iter().any(|rate| !(0.0..=200.0).contains(rate));
        let rules: &[&'static str] = if beyond {
            &["NCP-CODEC-004", "NCP-CODEC-020"]
        } else {
            if name.ends_with("ends") || name.ends_with("-only") {
                &["NCP-CODEC-020", "NCP-CODEC-003"]
            } else {
                &["NCP-CODEC-003", "NCP-CODEC-020"]
            }
        };
        let expected = velocity(data.map(Some));
        let expected = if rules[0] == "NCP-CODEC-020" { in_metres_a_second(expected) } else { expected };
        cases.push(
            case(format!("uav/{name}"), rules, "uav".into(), &rates)
                .shows(expected)
                .title(format!("The UAV codec decodes the rates {}, {} and {} Hz.", data[0], data[1], data[2]))
                .because("Each rate is mapped from 0 \u{2026} 200 Hz to \u{2212}1.5 \u{2026} 1.5 m/s and clamped."),
        );
    }
    for (at, missing) in names.into_iter().enumerate() {
        let of = |name: &&'static str| *name != missing;
        let rates: Vec<(&str, f64)> = names.into_iter().filter(of).map(|name| (name, 200.0)).collect();
        let mut expected = [Some(200.0); 3];
        if let Some(rate) = expected.get_mut(at) {
            *rate = None;
        }
        cases.push(
            case(format!("uav/absent/{missing}"), &["NCP-CODEC-006"], "uav".into(), &rates)
                .shows(velocity(expected))
                .title(format!("The UAV codec decodes an absent `{missing}` to 0 m/s."))
                .because("An absent population gives the middle of the value range."),
        );
        for value in STRANGE {
            let rates: Vec<(&str, f64)> =
                names.into_iter().map(|name| (name, if name == missing { value } else { 150.0 })).collect();
            let mut expected = [Some(150.0); 3];
            if let Some(rate) = expected.get_mut(at) {
                *rate = None;
            }
            cases.push(
                case(format!("uav/{missing}/{}", name_of(value)), &["NCP-CODEC-006"], "uav".into(), &rates)
                    .shows_or_refuses(velocity(expected))
                    .title(format!("The UAV codec decodes a `{missing}` of {} to 0 m/s.", name_of(value)))
                    .because("A rate that is not finite gives the middle of the value range."),
            );
        }
    }
    cases.push(
        case("uav/absent/all".to_owned(), &["NCP-CODEC-006"], "uav".into(), &[])
            .shows(velocity([None; 3]))
            .title("The UAV codec decodes no rates to standing still.")
            .because("An absent population gives the middle of the value range."),
    );
    cases.push(
        case(
            "uav/other-populations".to_owned(),
            &["NCP-CODEC-006", "NCP-CODEC-020"],
            "uav".into(),
            &[("err_x", 200.0), ("VEL_X", 200.0), ("other", 200.0)],
        )
        .shows(velocity([None; 3]))
        .title("The UAV codec does not take other populations for its own.")
        .because("The populations are `vel_x`, `vel_y`, `vel_z`."),
    );
    cases
}

/// Ranges within which 0 is a number like any other, and not the middle.
const AROUND_ZERO: [(&str, [f64; 2]); 5] = [
    ("at-the-low-end", [0.0, 50.0]),
    ("at-the-high-end", [-30.0, 0.0]),
    ("below-the-middle", [-50.0, 200.0]),
    ("above-the-middle", [-200.0, 50.0]),
    ("far-below-the-middle", [-1.0, 1e6]),
];

/// Ranges at either end of the doubles.
fn extreme() -> Vec<Case> {
    let value = [0.0, 100.0];
    EXTREME
        .into_iter()
        .map(|(name, r, rate)| {
            let mapping = Mapping { value, rate, ..PLAIN };
            case(
                format!("extreme/{name}"),
                &["NCP-CODEC-003", "NCP-CODEC-007", "NCP-CODEC-013"],
                codec(&[], &[mapping]),
                &[("p", r)],
            )
            .shows(channels(vec![("x", vec![map(r, rate, value)])]))
            .title(format!(
                "{r:e} Hz in {:e} \u{2026} {:e} is decoded as in any other range ({name}).",
                rate[0], rate[1]
            ))
            .flags(&["degenerate-range"])
            .because(EXTREMELY)
        })
        .collect()
}

/// Value ranges of length 0.
fn points() -> Vec<Case> {
    FAR_OFF
        .into_iter()
        .map(|(side, r)| {
            let mapping = Mapping { rate: [0.0, 1e-300], value: [POINT; 2], ..PLAIN };
            case(format!("point/five/{side}"), &["NCP-CODEC-004"], codec(&[], &[mapping]), &[("p", r)])
                .shows_exactly(channels(vec![("x", vec![POINT])]))
                .title(format!("A value range of the one number {POINT} gives that number for {r:e} Hz."))
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
            case(format!("nameless/{name}"), &["NCP-CODEC-003"], codec(&[], &[mapping]), &[(population, 150.0)])
                .shows(channels(vec![(channel, vec![0.5])]))
                .title(format!("The decoder maps {words} of the empty name like every other."))
                .because(NAMELESSLY)
        })
        .collect();
    let mapping = Mapping { population: "", ..PLAIN };
    cases.push(
        case("nameless/absent".to_owned(), &["NCP-CODEC-006"], codec(&[], &[mapping]), &[("p", 150.0)])
            .shows(channels(vec![("x", vec![0.0])]))
            .title("A population of the empty name that is absent gives the middle of the value range.")
            .because(NAMELESSLY),
    );
    cases
}

/// So many mappings, of which the last two have a population of their own.
fn many(count: u32) -> Case {
    let codec = object! { "encoders" => Json::Array(Vec::new()), "decoders" => mappings_in_turn(count) };
    let data = [vec![0.5; count as usize - 2], vec![-0.5; 2]].concat();
    case(manifold(count), &["NCP-CODEC-003"], codec, &[("p", 150.0), ("q", 50.0)])
        .shows(channels(vec![("x", data)]))
        .title(format!("A codec of {count} mappings decodes by each of them."))
        .because(MANIFOLD)
}

/// So many mappings of one population to one component, and one of another.
fn many_of_one(count: u32) -> Case {
    let codec = object! { "encoders" => Json::Array(Vec::new()), "decoders" => mappings_of_one(count) };
    case(manifold(count), &["NCP-CODEC-003"], codec, &[("p", 150.0), ("q", 50.0)])
        .shows(channels(vec![("x", vec![0.5, -0.5])]))
        .title(format!(
            "A codec of {count} mappings, \
             all but the last of one population to one component, decodes by the last."
        ))
        .because(MANIFOLD)
}

/// A rate of 0 is a rate, and no absent one.
fn zeros() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, rate) in AROUND_ZERO {
        for value in [[-1.0, 1.0], [2.0, 6.0]] {
            let mapping = Mapping { value, rate, ..PLAIN };
            cases.push(
                case(
                    format!("zero/{name}/to-{}-{}", value[0], value[1]).replace("--", "-minus-"),
                    &["NCP-CODEC-003"],
                    codec(&[], &[mapping]),
                    &[("p", 0.0)],
                )
                .shows(channels(vec![("x", vec![map(0.0, rate, value)])]))
                .title(format!(
                    "A rate of 0 Hz {} of {} \u{2026} {} Hz is decoded within {} \u{2026} {} as any other.",
                    name.replace('-', " "),
                    rate[0],
                    rate[1],
                    value[0],
                    value[1]
                ))
                .because("A population that is silent is there: its rate is mapped, and is not the middle."),
            );
        }
    }
    cases
}

fn ranges() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, rate, from, to) in PRECISE {
        let mapping = Mapping { rate: from, value: to, ..PLAIN };
        let data: Json = std::iter::once(precisely(rate, from, to)).collect();
        let channels = object! { "x" => object! { "data" => data } };
        cases.push(
            case(format!("precise/{name}"), &["NCP-CODEC-013"], codec(&[], &[mapping]), &[("p", rate)])
                .shows_exactly(object! { "command" => object! { "channels" => channels } })
                .title(format!(
                    "{rate:?} Hz in {:?} \u{2026} {:?} Hz is decoded to twelve digits ({name}).",
                    from[0], from[1]
                ))
                .because(PRECISELY),
        );
    }
    for (name, r, rate, value) in narrow() {
        let mapping = Mapping { value, rate, ..PLAIN };
        cases.push(
            case(format!("narrow/{name}"), &["NCP-CODEC-003", "NCP-CODEC-013"], codec(&[], &[mapping]), &[("p", r)])
                .shows(channels(vec![("x", vec![map(r, rate, value)])]))
                .title(format!(
                    "{r:e} Hz in {:e} \u{2026} {:e} is decoded as in any wider range ({name}).",
                    rate[0], rate[1]
                ))
                .flags(&["degenerate-range"])
                .because("A range is degenerate when its length is 0 or not finite, and not when it is small."),
        );
    }
    for (path, words, r, value) in widely() {
        let mapping = Mapping { rate: [-1.0, 1.0], value, ..PLAIN };
        let data: Json = std::iter::once(within(-1e308, 1e308)).collect();
        cases.push(
            case(path, &["NCP-CODEC-004"], codec(&[], &[mapping]), &[("p", r)])
                .shows(object! { "command" => object! { "channels" => object! { "x" => object! { "data" => data } } } })
                .title(format!("{r} Hz are decoded within a value range whose length overflows{words}."))
                .because(WIDELY),
        );
    }
    let [low, high] = [0.0, 200.0];
    for (name, r) in FAR_OFF {
        let mapping = Mapping { rate: [0.0, 1e-300], value: [low, high], ..PLAIN };
        let data: Json = std::iter::once(within(low, high)).collect();
        cases.push(
            case(format!("quotient/{name}"), &["NCP-CODEC-004"], codec(&[], &[mapping]), &[("p", r)])
                .shows(object! { "command" => object! { "channels" => object! { "x" => object! { "data" => data } } } })
                .title(format!("{r:e} Hz are decoded within {low} \u{2026} {high}, though the quotient overflows."))
                .because(WIDELY),
        );
    }
    for (name, rate) in RANGES {
        for share in SHARES {
            for value in [[-1.0, 1.0], [2.0, 6.0], [6.0, 2.0]] {
                let r = share.of(rate);
                let mapping = Mapping { value, rate, ..PLAIN };
                let rule = share.decides("NCP-CODEC-003", "NCP-CODEC-004");
                cases.push(
                    case(
                        format!("range/{name}/{}/to-{}-{}", share.name, value[0], value[1]).replace("--", "-minus-"),
                        &[rule],
                        codec(&[], &[mapping]),
                        &[("p", r)],
                    )
                    .shows(object! { "command" => object! { "channels" => object! { "x" => object! { "data" =>
                    Json::Array(vec![maps(r, rate, value)]) } } } })
                    .title(format!(
                        "{r} Hz in {} \u{2026} {} is decoded within {} \u{2026} {} ({}).",
                        rate[0], rate[1], value[0], value[1], share.name
                    ))
                    .because(
                        "The value is v0 + (r \u{2212} r0) / (r1 \u{2212} r0) \u{b7} (v1 \u{2212} v0), \
                                  clamped to the value range.",
                    ),
                );
            }
        }
    }
    for (name, r) in [("quarter", 0.5), ("above", -2.0)] {
        let (value, rate) = ([2.0, 6.0], [1.0, -1.0]);
        let mapping = Mapping { value, rate, ..PLAIN };
        cases.push(
            case(format!("downwards/{name}"), &["NCP-CODEC-012"], codec(&[], &[mapping]), &[("p", r)])
                .shows(channels(vec![("x", vec![map(r, rate, value)])]))
                .title(format!("{r} Hz in 1 \u{2026} -1 should be decoded as by any other range ({name})."))
                .flags(&["degenerate-range"])
                .because("A source range that runs downwards should be mapped like every other."),
        );
    }
    for (name, rate) in [
        ("zero-length", [50.0, 50.0]),
        ("at-zero", [0.0, 0.0]),
        ("nan", [f64::NAN, 1.0]),
        ("infinite", [0.0, f64::INFINITY]),
    ] {
        for r in [0.0, 50.0, 500.0] {
            let mapping = Mapping { value: [2.0, 6.0], rate, ..PLAIN };
            let case = case(format!("degenerate/{name}/{r}"), &["NCP-CODEC-007"], codec(&[], &[mapping]), &[("p", r)])
                .title(format!("A rate range without a finite length ({name}) decodes {r} Hz to the middle value."))
                .because("A source range that is degenerate gives the middle of the target range, here 4.");
            let expected = channels(vec![("x", vec![4.0])]);
            cases.push(if rate.iter().all(|end| end.is_finite()) {
                case.shows(expected)
            } else {
                case.shows_or_refuses(expected)
            });
        }
    }
    cases
}

/// What stands between the components that mappings name is another rule's.
fn between_mappings(case: Case, mappings: &[Mapping]) -> Case {
    let has_gaps = mappings.iter().any(|mapping| (1..4096).contains(&mapping.component));
    if !has_gaps || case.requirements.first() == Some(&"NCP-CODEC-010") {
        return case;
    }
    mappings.iter().fold(case, |case, mapping| {
        let data = format!("/command/channels/{}/data", mapping.channel);
        let own = format!("{data}/{}", mapping.component);
        case.by(data, "NCP-CODEC-010").by_own(own)
    })
}

/// Components of one channel, each of which is beyond what is there by more than the one before.
const GROWING: [u32; 7] = [2, 5, 11, 20, 70, 300, 700];

fn mappings() -> Vec<Case> {
    let mut cases = Vec::new();
    let mapping = |channel, component, population| Mapping { channel, component, population, ..PLAIN };
    let table: Vec<(&str, &'static str, &str, Vec<Mapping>, Json)> = vec![
        (
            "gap",
            "NCP-CODEC-010",
            "A component that no mapping names is 0",
            vec![mapping("x", 2, "p")],
            channels(vec![("x", vec![0.0, 0.0, 0.5])]),
        ),
        (
            "gap-between",
            "NCP-CODEC-010",
            "A component between two that are mapped is 0",
            vec![mapping("x", 0, "p"), mapping("x", 2, "q")],
            channels(vec![("x", vec![0.5, 0.0, -0.5])]),
        ),
        (
            "backward",
            "NCP-CODEC-003",
            "The order of the mappings does not matter",
            vec![mapping("x", 1, "q"), mapping("x", 0, "p")],
            channels(vec![("x", vec![0.5, -0.5])]),
        ),
        (
            "two-channels",
            "NCP-CODEC-003",
            "Two channels are built from two mappings",
            vec![mapping("x", 0, "p"), mapping("y", 0, "q")],
            channels(vec![("x", vec![0.5]), ("y", vec![-0.5])]),
        ),
        (
            "one-population",
            "NCP-CODEC-003",
            "One population may drive two components",
            vec![mapping("x", 0, "p"), mapping("x", 1, "p")],
            channels(vec![("x", vec![0.5, 0.5])]),
        ),
        (
            "one-population-of-other-ranges",
            "NCP-CODEC-003",
            "A population of which one mapping cannot tell anything drives the others all the same",
            vec![
                mapping("x", 0, "p"),
                Mapping { rate: [50.0, 50.0], ..mapping("x", 1, "p") },
                mapping("y", 0, "p"),
                Mapping { rate: [0.0, 0.0], ..mapping("y", 1, "q") },
                mapping("y", 2, "q"),
            ],
            channels(vec![("x", vec![0.5, 0.0]), ("y", vec![0.5, 0.0, -0.5])]),
        ),
        (
            "ignored-in-a-row",
            "NCP-CODEC-008",
            "Mappings of component 4,096 and more are ignored, however many follow each other",
            vec![
                mapping("x", 4096, "q"),
                mapping("x", 4097, "q"),
                mapping("x", 5000, "q"),
                mapping("x", 0, "p"),
                mapping("x", 4096, "p"),
                mapping("x", 4096, "p"),
            ],
            channels(vec![("x", vec![0.5])]),
        ),
        (
            "one-component-twice",
            "NCP-CODEC-014",
            "Of two mappings to one component the last should count",
            vec![mapping("x", 0, "p"), mapping("x", 1, "p"), mapping("x", 0, "q")],
            channels(vec![("x", vec![-0.5, 0.5])]),
        ),
        (
            "absent",
            "NCP-CODEC-006",
            "An absent population is the middle of the value range",
            vec![mapping("x", 0, "silent"), mapping("x", 1, "p")],
            channels(vec![("x", vec![0.0, 0.5])]),
        ),
        (
            "ignored-4096",
            "NCP-CODEC-008",
            "A mapping of component 4,096 is ignored",
            vec![mapping("x", 0, "p"), mapping("x", 4096, "q")],
            channels(vec![("x", vec![0.5])]),
        ),
        (
            "ignored-huge",
            "NCP-CODEC-008",
            "A mapping of component 4,294,967,295 is ignored, and takes no memory",
            vec![mapping("x", 4_294_967_295, "q"), mapping("x", 0, "p")],
            channels(vec![("x", vec![0.5])]),
        ),
        (
            "ignored-other",
            "NCP-CODEC-008",
            "An ignored mapping does not disturb another channel",
            vec![mapping("y", 5000, "q"), mapping("x", 0, "p")],
            channels(vec![("x", vec![0.5])]),
        ),
        (
            "last",
            "NCP-CODEC-010",
            "A mapping of component 300 makes a channel 301 wide",
            vec![mapping("x", 300, "p")],
            channels(vec![("x", [vec![0.0; 300], vec![0.5]].concat())]),
        ),
        (
            "component-1024",
            "NCP-CODEC-003",
            "A mapping of component 1,024 is followed",
            vec![mapping("x", 1024, "p")],
            channels(vec![("x", [vec![0.0; 1024], vec![0.5]].concat())]),
        ),
        (
            "component-4095",
            "NCP-CODEC-003",
            "A mapping of component 4,095 is followed",
            vec![mapping("x", 4095, "p")],
            channels(vec![("x", [vec![0.0; 4095], vec![0.5]].concat())]),
        ),
    ];
    let wide: Vec<f64> = (0..=1024).map(|nth| if [256, 1024].contains(&nth) { -0.5 } else { 0.0 }).collect();
    let growing: Vec<f64> = (0..=700).map(|nth| if GROWING.contains(&nth) { 0.5 } else { 0.0 }).collect();
    let powers = [mapping("x", 256, "q"), mapping("x", 1024, "q")];
    let beside = [mapping("y", 0, "p")];
    let table = table.into_iter().chain([
        (
            "powers-then-another",
            "NCP-CODEC-003",
            "The components 256 and 1,024 of a channel are none of the next one",
            [&powers[..], &beside].concat(),
            channels(vec![("x", wide.clone()), ("y", vec![0.5])]),
        ),
        (
            "powers-behind-another",
            "NCP-CODEC-003",
            "The components 256 and 1,024 of a channel are none of the one before",
            [&beside[..], &powers].concat(),
            channels(vec![("x", wide), ("y", vec![0.5])]),
        ),
        (
            "grows",
            "NCP-CODEC-010",
            "A channel whose mappings name ever later components is 0 between them",
            GROWING.map(|at| mapping("x", at, "p")).to_vec(),
            channels(vec![("x", growing.clone())]),
        ),
        (
            "shrinks",
            "NCP-CODEC-010",
            "A channel whose mappings name ever earlier components is 0 between them",
            GROWING.iter().rev().map(|at| mapping("x", *at, "p")).collect(),
            channels(vec![("x", growing.clone())]),
        ),
        (
            "grow-by-turns",
            "NCP-CODEC-010",
            "Channels whose mappings name ever later components by turns are 0 between them",
            GROWING.iter().flat_map(|at| [mapping("x", *at, "p"), mapping("y", *at, "p")]).collect(),
            channels(vec![("x", growing.clone()), ("y", growing)]),
        ),
    ]);
    for (name, rule, words, mappings, expected) in table {
        cases.push(
            between_mappings(
                case(format!("mapping/{name}"), &[rule], codec(&[], &mappings), &[("p", 150.0), ("q", 50.0)]),
                &mappings,
            )
            .shows(expected)
            .title(format!("{words}."))
            .because(
                "Each mapping sets one component; those below it that none names are 0, and a component of \
                          4,096 or more is ignored.",
            ),
        );
    }
    cases.extend(in_pairs());
    // What no mapping names is 0, and not the middle of another's range.
    for (name, value) in [("positive", [2.0, 6.0]), ("negative", [-8.0, -4.0])] {
        let far = Mapping { component: 2, value, ..PLAIN };
        cases.push(
            case(format!("mapping/gap-{name}"), &["NCP-CODEC-010"], codec(&[], &[far]), &[("p", 100.0)])
                .shows(channels(vec![("x", vec![0.0, 0.0, f64::midpoint(value[0], value[1])])]))
                .title(format!("A component that no mapping names is 0, also below one whose value range is {name}."))
                .because(
                    "A component of a decoded channel that no mapping names, below one that a mapping names, is 0.",
                ),
        );
    }
    cases.extend(units());
    // The middle is the range's, not 0.
    let high = Mapping { value: [2.0, 6.0], ..PLAIN };
    cases.push(
        case("mapping/absent-asymmetric".to_owned(), &["NCP-CODEC-006"], codec(&[], &[high]), &[])
            .shows(channels(vec![("x", vec![4.0])]))
            .title("An absent population is the middle of a value range that does not hold 0.")
            .because("An absent population gives the middle of the value range."),
    );
    let united = object! { "encoders" => Json::Array(Vec::new()),
    "decoders" => Json::Array(vec![high.json().with("unit", "rad/s".into())]) };
    cases.push(
        case("mapping/unit".to_owned(), &["NCP-CODEC-011"], united, &[("p", 100.0)])
            .shows(object! { "command" => object! { "channels" => object! { "x" => object! { "data" => nums(&[4.0]),
            "unit" => "rad/s" } } } })
            .title("A decoder's unit becomes the channel's.")
            .because("The decoder builds the command's channel; its unit is the mapping's."),
    );
    cases
}

/// Two mappings that differ in one thing only, in either order, and the first once more behind them.
fn in_pairs() -> Vec<Case> {
    let mut cases = Vec::new();
    let rates = [("p", 150.0), ("q", 25.0)];
    let decoded = |of: &Mapping| {
        let rate = rates.iter().find(|(name, _)| *name == of.population).map_or(f64::NAN, |(_, rate)| *rate);
        map(rate, of.rate, of.value)
    };
    for (name, other) in pairs(PLAIN) {
        // Two channels in each pair, but for where they lie in one.
        let other = if name == "component" { other } else { Mapping { channel: "y", ..other } };
        let again = Mapping { channel: "z", ..PLAIN };
        for (order, mappings) in
            [("after", vec![PLAIN, other]), ("before", vec![other, PLAIN]), ("between", vec![PLAIN, other, again])]
        {
            let mut expected = match name {
                "component" => vec![("x", vec![decoded(&PLAIN), decoded(&other)])],
                _ => vec![("x", vec![decoded(&PLAIN)]), ("y", vec![decoded(&other)])],
            };
            if order == "between" {
                expected.push(("z", vec![decoded(&again)]));
            }
            cases.push(
                case(format!("pair/{name}/{order}"), &["NCP-CODEC-003"], codec(&[], &mappings), &rates)
                    .shows(channels(expected))
                    .title(format!(
                        "Of two mappings that differ in {} alone each decodes as it says ({order}).",
                        name.replace('-', " ")
                    ))
                    .because("The decoder maps each mapping's rate by that mapping's ranges."),
            );
        }
    }
    cases
}

/// The unit of a channel of several mappings.
fn units() -> Vec<Case> {
    type Row = (&'static str, &'static str, &'static str, &'static [(u32, Option<&'static str>)], usize, &'static str);
    let (first, ignored) = ("NCP-CODEC-011", "NCP-CODEC-008");
    let table: [Row; 8] = [
        ("first", first, "the first names", &[(0, Some("rad/s")), (1, None)], 2, "rad/s"),
        ("second", first, "the second alone names", &[(0, None), (1, Some("rad/s"))], 2, "rad/s"),
        ("same", first, "both name", &[(0, Some("rad/s")), (1, Some("rad/s"))], 2, "rad/s"),
        ("two", first, "the first of two names", &[(0, Some("rad/s")), (1, Some("deg/s"))], 2, "rad/s"),
        (
            "three",
            first,
            "the first of two after one without names",
            &[(0, None), (1, Some("deg/s")), (2, Some("rad/s"))],
            3,
            "deg/s",
        ),
        ("downwards", first, "the first in the list names", &[(1, Some("deg/s")), (0, Some("rad/s"))], 2, "deg/s"),
        (
            "ignored-first",
            ignored,
            "the first names whose component is below 4,096",
            &[(4096, Some("rad/s")), (0, Some("deg/s"))],
            1,
            "deg/s",
        ),
        (
            "ignored-large-first",
            ignored,
            "the first names whose component is below 4,096",
            &[(4_294_967_295, Some("rad/s")), (0, None), (1, Some("deg/s"))],
            2,
            "deg/s",
        ),
    ];
    let one = |(name, rule, words, mappings, width, expected): Row| {
        let decoders: Json = mappings
            .iter()
            .map(|(component, unit)| {
                let mapping = Mapping { component: *component, ..PLAIN }.json();
                match unit {
                    Some(unit) => mapping.with("unit", (*unit).into()),
                    None => mapping,
                }
            })
            .collect();
        let united = object! { "encoders" => Json::Array(Vec::new()), "decoders" => decoders };
        let data = vec![0.5; width];
        case(format!("mapping/unit-of/{name}"), &[rule], united, &[("p", 150.0)])
            .shows(object! { "command" => object! { "channels" => object! { "x" => object! { "data" => nums(&data),
            "unit" => expected } } } })
            .title(format!("The unit of a decoded channel is the one that {words}."))
            .because(if rule == ignored {
                "A mapping of a component of 4,096 or more is ignored, its unit as well."
            } else {
                "The unit of a decoded channel is that of the first of its mappings that names one."
            })
    };
    table.into_iter().map(one).collect()
}

/// What stands beside the channels.
fn heads() -> Vec<Case> {
    let mut cases = Vec::new();
    let mut add = |path: String, t: f64, seq: i64, frame_id: &str, mode: &str, title: String| {
        let args = object! { "codec" => "uav", "rates" => object! { "vel_x" => num(100.0) }, "t" => num(t),
        "seq" => int(seq), "frame_id" => frame_id, "mode" => mode };
        let command = object! { "t" => num(t), "seq" => int(seq), "frame_id" => frame_id, "mode" => mode };
        let case = Case::new(format!("head/{path}"), &["NCP-CODEC-009"], &[Role::Commander])
            .call("codec.decode", args)
            .title(title)
            .because("Decoding builds the command with the given `t`, `seq`, `frame_id` and mode.");
        let expected = object! { "command" => command };
        cases.push(if t.is_finite() {
            case.shows(expected)
        } else {
            case.shows_or_refuses(any(vec![expected, object! { "command" => Json::object() }]))
        });
    };
    for mode in ["init", "active", "hold", "estop"] {
        add(format!("mode-{mode}"), 2.5, 42, "world", mode, format!("Decoding builds a command in mode `{mode}`."));
    }
    for seq in [0, 1, -3, 9_007_199_254_740_991] {
        add(
            format!("seq/{seq}").replace("/-", "/minus-"),
            2.5,
            seq,
            "world",
            "active",
            format!("Decoding builds a command of seq {seq}."),
        );
    }
    for t in [0.0, -0.0, -1.5, 1e9, 1e308, 5e-324, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        add(
            format!("t/{}", name_of(t)),
            t,
            42,
            "world",
            "active",
            format!("Decoding builds a command of the time {}.", name_of(t)),
        );
    }
    for (name, frame_id) in [("body", "body"), ("empty", ""), ("unusual", "map/odom \u{e9}")] {
        add(
            format!("frame-id/{name}"),
            2.5,
            42,
            frame_id,
            "active",
            format!("Decoding builds a command in a frame of reference ({name})."),
        );
    }
    cases
}

/// A population that the encoder drives and the decoder reads, with ranges of its own on each side.
fn both_ways() -> Case {
    case("both-ways".to_owned(), &["NCP-CODEC-003"], codec_of_both_ways(), &[(PLAIN.population, 300.0)])
        .shows(channels(vec![(PLAIN.channel, vec![4.0])]))
        .title("The decoder maps by its own ranges from a population that the encoder drives by others.")
        .because(OF_ITS_OWN)
}

/// Channels, and populations, of all names that are alike.
fn of_all_names() -> [Case; 2] {
    let hertz: Vec<f64> = (1_u32..).zip(names::alike()).map(|(nth, _)| 100.0 + f64::from(nth) / 2.0).collect();
    let values: Vec<f64> = hertz.iter().map(|rate| map(*rate, PLAIN.rate, PLAIN.value)).collect();
    let of = |are_channels| {
        object! { "encoders" => Json::Array(Vec::new()), "decoders" => mappings_of_names(are_channels) }
    };
    let all: Vec<&str> = names::alike().map(|(name, _)| name).collect();
    let numbered: Vec<String> = (0..all.len()).map(|nth| format!("p{nth}")).collect();
    let by_number: Vec<(&str, f64)> = numbered.iter().map(String::as_str).zip(hertz.iter().copied()).collect();
    let by_name: Vec<(&str, f64)> = all.iter().copied().zip(hertz.iter().copied()).collect();
    let each = all.iter().copied().zip(values.iter().map(|value| vec![*value])).collect();
    [("targets", true, by_number, channels(each)), ("populations", false, by_name, channels(vec![("x", values)]))].map(
        |(what, are_channels, rates, expected)| {
            case(format!("alike/{what}/all"), &["NCP-CODEC-003", "NCP-CODEC-010"], of(are_channels), &rates)
                .shows(expected)
                .title(format!("Each of {} {what} whose names are alike is built of its own rate.", all.len()))
                .because("Names are compared letter for letter, and a mapping is of those that it names.")
        },
    )
}

/// Targets, and populations, that a careless name for them confuses.
fn alike() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, components, words) in ALIKE {
        let mut built: Vec<(&str, Vec<f64>)> = Vec::new();
        let mut of_targets: (Vec<Mapping>, Vec<(&str, f64)>) = (Vec::new(), Vec::new());
        let mut of_populations: (Vec<Mapping>, Vec<(&str, f64)>, Vec<f64>) = (Vec::new(), Vec::new(), Vec::new());
        for ((nth, (channel, component)), population) in (0_u32..).zip(components.iter().copied()).zip(POPULATIONS) {
            let rate = 110.0 + 5.0 * f64::from(nth);
            let value = map(rate, PLAIN.rate, PLAIN.value);
            of_targets.0.push(Mapping { channel, component, population, ..PLAIN });
            of_targets.1.push((population, rate));
            let at = built.iter().position(|(known, _)| *known == channel).unwrap_or_else(|| {
                built.push((channel, Vec::new()));
                built.len() - 1
            });
            let width = component as usize + 1;
            if let Some((_, data)) = built.get_mut(at) {
                data.resize(data.len().max(width), 0.0);
                data[width - 1] = value;
            }
            // The same names of populations, each of which drives a component of one channel.
            if of_populations.1.iter().all(|(known, _)| *known != channel) {
                of_populations.0.push(Mapping { component: nth, population: channel, ..PLAIN });
                of_populations.1.push((channel, rate));
                of_populations.2.resize(nth as usize, 0.0);
                of_populations.2.push(value);
            }
        }
        cases.push(
            between_mappings(
                case(
                    format!("alike/targets/{name}"),
                    &["NCP-CODEC-003", "NCP-CODEC-010"],
                    codec(&[], &of_targets.0),
                    &of_targets.1,
                ),
                &of_targets.0,
            )
            .shows(channels(built))
            .title(format!("Each of several components {words} is built of its own rate."))
            .because("The decoder maps the rate of the mapping's population to the component that it names."),
        );
        if name.starts_with("joined") {
            continue;
        }
        cases.push(
            case(
                format!("alike/populations/{name}"),
                &["NCP-CODEC-003", "NCP-CODEC-010"],
                codec(&[], &of_populations.0),
                &of_populations.1,
            )
            .shows(channels(vec![("x", of_populations.2)]))
            .title(format!(
                "Each of several populations with names {} has its own rate.",
                words.replace("of channels whose names", "that").replace("of channels whose long names", "that")
            ))
            .because("The decoder maps the rate of the mapping's population, and of no other."),
        );
    }
    cases
}
