//! Codecs, and what is put through them.

use super::{Draw, Tree};
use crate::fuzz::tree::{int, items, list, map, members, num, nums, object, or_null, set, string, text};

fn range(draw: &mut Draw<'_>) -> [f64; 2] {
    let end = |draw: &mut Draw<'_>| if draw.chance(75) { draw.plain() } else { draw.double() };
    let low = end(draw);
    draw.note(low);
    match draw.below(12) {
        0 => [low, low],
        1 => [low, if draw.chance(50) { low.next_up() } else { low + (low * draw.little()).abs() }],
        2 => [low, end(draw)],
        // Their sum, or their difference, leaves the doubles.
        3 => draw.one(&[[1e308, 1.5e308], [-1.5e308, 1.5e308], [-f64::MAX, -1e308], [f64::MAX / 2.0, f64::MAX]]),
        // Of any scale, so that the quotient of two lengths leaves the doubles, though no step of the formula does.
        4 | 5 => {
            let end = draw.range(1, 9) as f64 * 10_f64.powi(i32::try_from(draw.range(-280, 298)).unwrap_or(0));
            if draw.chance(50) { [0.0, end] } else { [-end, end] }
        }
        _ => {
            let high = end(draw);
            draw.note(high);
            if low <= high { [low, high] } else { [high, low] }
        }
    }
}

/// The mappings of one side: no population and no component twice.
fn mappings(decoders: bool, draw: &mut Draw<'_>) -> Vec<Tree> {
    let count = match draw.below(30) {
        0 => draw.size(16, 300),
        _ => draw.size(0, 6),
    };
    let channels = names(draw);
    let marked = draw.chance(10);
    let shared = draw.chance(15);
    let far = draw.one(&[4, 4, 64, 4095]);
    let mut next = [0_i64; 4];
    (0..count)
        .map(|nth| {
            let channel = draw.below(channels.len());
            let component = if draw.chance(70) { next[channel] } else { next[channel] + draw.range(1, far) };
            // One that is ignored is as if it were not there, whatever it shares with another (NCP-CODEC-008).
            let is_ignored = draw.chance(4);
            let component = if is_ignored { draw.one(&[4096, 4097, 8192, 65_536]) } else { component.min(4095) };
            if !is_ignored {
                next[channel] = next[channel].max(component + 1);
            }
            let of = if is_ignored && draw.chance(60) { draw.below(count) } else { nth };
            let population = if marked && nth % 3 == 1 { format!(" p{of} ") } else { format!("p{of}") };
            // Two that read the same, by ranges of their own.
            let population = if decoders && shared && nth % 2 == 1 { format!("p{}", nth - 1) } else { population };
            let mut mapping = object([
                ("channel", text(channels[channel].clone())),
                ("component", int(component)),
                ("population", text(population)),
            ]);
            for name in ["value_range", "rate_range"] {
                if draw.chance(70) {
                    set(&mut mapping, name, nums(&range(draw)));
                }
            }
            if decoders && draw.chance(40) {
                set(&mut mapping, "unit", text(draw.pick(&["m/s", "rad", "", "N"])));
            }
            mapping
        })
        .collect()
}

/// The channels of a codec: short ones, or such that are equal for long.
fn names(draw: &mut Draw<'_>) -> [String; 4] {
    if draw.chance(85) {
        return ["x", "pose_error", "velocity_setpoint", "y"].map(str::to_owned);
    }
    // Such as run together with the number of a component, or that are parts of each other.
    match draw.below(3) {
        0 => return ["motor", "motor1", "motor/1", "motor.1"].map(str::to_owned),
        1 => return ["arm/x", "x", "arm", "x/arm"].map(str::to_owned),
        _ => {}
    }
    let length = draw.size(4, 128);
    ["a", "b", "", "aa"].map(|end| "n".repeat(length) + end)
}

fn codec(draw: &mut Draw<'_>) -> Tree {
    if draw.chance(25) {
        return text("uav");
    }
    object([("encoders", list(mappings(false, draw))), ("decoders", list(mappings(true, draw)))])
}

/// A number within a source range of the codec.
fn within(codec: &Tree, side: &str, name: &str, draw: &mut Draw<'_>) -> f64 {
    let mappings = crate::fuzz::tree::items(codec.get(side));
    let Some(mapping) = mappings.get(draw.below(mappings.len())) else { return draw.plain() };
    match crate::fuzz::tree::doubles(mapping.get(name)).as_slice() {
        [from, to] if (to - from).is_finite() => from + draw.range(0, 32) as f64 / 32.0 * (to - from),
        _ => draw.plain(),
    }
}

/// The arguments of `codec.encode`.
pub(super) fn encode(draw: &mut Draw<'_>) -> Tree {
    let codec = codec(draw);
    let sensor = (!draw.chance(5)).then(|| {
        let mut own: Vec<String> = crate::fuzz::tree::items(codec.get("encoders"))
            .iter()
            .filter_map(|mapping| crate::fuzz::tree::string(mapping, "channel").map(str::to_owned))
            .collect();
        own.extend(["x", "pose_error", "velocity_setpoint", "y"].map(str::to_owned));
        let channels = own.into_iter().map(|name| {
            let width = if draw.chance(5) { draw.one(&[64, 65, 4095, 4096]) } else { draw.below(6) };
            let data: Vec<f64> = (0..width)
                .map(|_| match draw.below(10) {
                    0..=3 => draw.plain(),
                    4..=6 => within(&codec, "encoders", "value_range", draw),
                    _ => draw.double(),
                })
                .collect();
            (name, object([("data", nums(&data))]))
        });
        let channels: Vec<_> = channels.collect();
        let channels = channels.into_iter().filter(|_| draw.chance(80)).collect();
        object([("seq", int(3)), ("t", num(1.0)), ("channels", map(channels))])
    });
    object([("codec", codec), ("sensor", or_null(sensor))])
}

/// The arguments of `codec.decode`.
pub(super) fn decode(draw: &mut Draw<'_>) -> Tree {
    let codec = codec(draw);
    let mut names: Vec<String> = ["vel_x", "vel_y", "vel_z", "other"].map(str::to_owned).into();
    names.extend((0..crate::fuzz::tree::items(codec.get("decoders")).len()).map(|nth| format!("p{nth}")));
    names.extend(names.clone().into_iter().filter(|_| draw.chance(5)).map(|name| format!("{name} ")));
    let rates = names.into_iter().filter_map(|name| {
        let rate = match draw.below(10) {
            0..=3 => draw.range(-10, 220) as f64,
            4..=6 => within(&codec, "decoders", "rate_range", draw),
            _ => draw.double(),
        };
        draw.chance(85).then(|| (name, num(rate)))
    });
    let rates = map(rates.collect());
    object([
        ("codec", codec),
        ("rates", rates),
        ("t", num(draw.finite())),
        ("seq", int(draw.integer())),
        ("frame_id", text(draw.string())),
        ("mode", text(draw.pick(&["init", "active", "hold", "estop"]))),
    ])
}

/// Whether the arguments are such as PROTOCOL.md has, without a text that ends at U+0000 in C.
pub(super) fn is_said_by_all(args: &Tree) -> bool {
    const KNOWN: [&str; 6] = ["channel", "component", "population", "value_range", "rate_range", "unit"];
    const LISTS: [&str; 2] = ["encoders", "decoders"];
    let of = |name| items(args.get("codec").and_then(|codec| codec.get(name)));
    let lists = members(args.get("codec"));
    let mut mappings = LISTS.into_iter().flat_map(of);
    let is_whole =
        mappings.all(|mapping| members(Some(mapping)).iter().all(|(name, _)| KNOWN.contains(&name.as_ref())));
    let is_whole = is_whole && lists.iter().all(|(name, _)| LISTS.contains(&name.as_ref()));
    is_whole && !string(args, "frame_id").unwrap_or_default().contains('\0')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mapping_has_no_member_that_the_protocol_lacks_and_a_frame_id_no_end_within() {
        let asked = |member: &'static str, frame_id: &str| {
            let mapping = object([("channel", text("x")), (member, int(1))]);
            let codec = object([("encoders", list(vec![mapping])), ("decoders", list(Vec::new()))]);
            object([("codec", codec), ("frame_id", text(frame_id.to_owned()))])
        };
        assert!(is_said_by_all(&asked("component", "world")));
        assert!(!is_said_by_all(&asked("k0", "world")));
        assert!(!is_said_by_all(&asked("component", "wor\0ld")));
        assert!(is_said_by_all(&object([("codec", text("uav"))])));
        assert!(!is_said_by_all(&object([("codec", object([("z0", list(Vec::new()))]))])));
    }
}
