//! The rate codec, rule by rule: chapter 9.

use ncp_spec::codec::{MAX_COMPONENTS, Mapping, RATE_CODEC_ID, RateCodec, Rates};
use ncp_spec::wire::{ChannelMap, ChannelValue, CommandFrame, Frame, Mode, SensorFrame};

const NOT_FINITE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
const TINY: f64 = 5e-324;

/// From −1 … 1 to 0 … 200 Hz.
fn plain() -> Mapping {
    Mapping::new("stick", 0, "drive")
}

fn mapping(value_range: (f64, f64), rate_range: (f64, f64)) -> Mapping {
    Mapping { value_range, rate_range, ..plain() }
}

fn sensed(channel: &'static str, data: &[f64]) -> SensorFrame {
    let mut frame = SensorFrame::default();
    frame.channels.insert(channel, ChannelValue::without_unit(data));
    frame
}

fn rates(of: &[(&str, f64)]) -> Rates {
    of.iter().map(|(name, rate)| ((*name).to_owned(), *rate)).collect()
}

fn decode(codec: &RateCodec, of: &[(&str, f64)]) -> ChannelMap {
    codec.decode(&rates(of), 0.0, 0, "world", Mode::Active).channels
}

/// [NCP-CODEC-001] [NCP-CODEC-003] The defaults are −1 … 1 and 0 … 200 Hz.
#[test]
fn both_ways_are_linear_and_exact_at_the_ends_and_in_the_middle() {
    for (value, rate) in [(-1.0, 0.0), (-0.5, 50.0), (0.0, 100.0), (0.25, 125.0), (1.0, 200.0)] {
        assert_eq!(plain().encode(Some(value)), rate);
        assert_eq!(plain().decode(Some(rate)), value);
    }
    let shifted = mapping((10.0, 14.0), (20.0, 60.0));
    assert_eq!(shifted.encode(Some(11.0)), 30.0);
    assert_eq!(shifted.decode(Some(30.0)), 11.0);
}

/// [NCP-CODEC-001] [NCP-CODEC-003] A range may fall.
#[test]
fn a_falling_range_maps_the_other_way_round() {
    let falling = mapping((1.0, -1.0), (0.0, 200.0));
    assert_eq!(falling.encode(Some(1.0)), 0.0);
    assert_eq!(falling.encode(Some(-0.5)), 150.0);
    assert_eq!(falling.decode(Some(150.0)), -0.5);
    assert_eq!(falling.decode(Some(900.0)), -1.0);
    assert_eq!(falling.encode(Some(9.0)), 0.0);
}

/// [NCP-CODEC-002] [NCP-CODEC-004]
#[test]
fn what_lies_beyond_a_range_is_clamped_to_its_end() {
    for (value, rate) in [
        (1.0_f64.next_up(), 200.0),
        (2.0, 200.0),
        (f64::MAX, 200.0),
        ((-1.0_f64).next_down(), 0.0),
        (-2.0, 0.0),
        (f64::MIN, 0.0),
    ] {
        assert_eq!(plain().encode(Some(value)), rate, "{value}");
    }
    for (rate, value) in [(200.0_f64.next_up(), 1.0), (f64::MAX, 1.0), (-TINY, -1.0), (-1.0, -1.0), (f64::MIN, -1.0)] {
        assert_eq!(plain().decode(Some(rate)), value, "{rate}");
    }
}

/// [NCP-CODEC-005] L06: a missing sensor is no extreme.
#[test]
fn what_is_not_sensed_is_the_middle_of_the_rates() {
    let codec = RateCodec { encoders: vec![Mapping { component: 1, ..plain() }], decoders: vec![] };
    let encode = |sensor: Option<&SensorFrame>| codec.encode(sensor)["drive"];
    assert_eq!(encode(None), 100.0);
    assert_eq!(encode(Some(&SensorFrame::default())), 100.0);
    assert_eq!(encode(Some(&sensed("another", &[1.0, 1.0]))), 100.0);
    assert_eq!(encode(Some(&sensed("stick", &[]))), 100.0);
    assert_eq!(encode(Some(&sensed("stick", &[1.0]))), 100.0);
    assert_eq!(encode(Some(&sensed("stick", &[-1.0, 1.0]))), 200.0);
    for bad in NOT_FINITE {
        assert_eq!(encode(Some(&sensed("stick", &[0.0, bad]))), 100.0, "{bad}");
    }
}

/// [NCP-CODEC-006]
#[test]
fn what_is_not_read_out_is_the_middle_of_the_values() {
    let codec = RateCodec { encoders: vec![], decoders: vec![mapping((2.0, 6.0), (0.0, 200.0))] };
    assert_eq!(decode(&codec, &[])["stick"].data, [4.0]);
    assert_eq!(decode(&codec, &[("another", 200.0)])["stick"].data, [4.0]);
    for bad in NOT_FINITE {
        assert_eq!(decode(&codec, &[("drive", bad)])["stick"].data, [4.0], "{bad}");
    }
}

/// [NCP-CODEC-007]
#[test]
fn a_degenerate_source_range_gives_the_middle_of_the_target() {
    let degenerate = [
        (1.0, 1.0),
        (0.0, -0.0),
        (0.0, f64::INFINITY),
        (f64::NEG_INFINITY, f64::INFINITY),
        (f64::NAN, 1.0),
        (0.0, f64::NAN),
        (f64::MIN, f64::MAX),
    ];
    for range in degenerate {
        for x in [0.0, -0.0, 0.5, 1.0, TINY, f64::MAX] {
            assert_eq!(mapping(range, (0.0, 200.0)).encode(Some(x)), 100.0, "{range:?} {x}");
            assert_eq!(mapping((-1.0, 3.0), range).decode(Some(x)), 1.0, "{range:?} {x}");
        }
    }
}

/// [NCP-CODEC-001] [NCP-CODEC-003] [NCP-CODEC-007] Only the source's length can be degenerate.
#[test]
fn a_target_wider_than_any_double_is_still_mapped_to() {
    let wide = mapping((-1.0, 1.0), (f64::MIN, f64::MAX));
    assert_eq!(wide.encode(Some(-1.0)), f64::MIN);
    assert_eq!(wide.encode(Some(0.0)), 0.0);
    assert_eq!(wide.encode(Some(1.0)), f64::MAX);
    let quarter = wide.encode(Some(0.5)) / (f64::MAX / 2.0);
    assert!((quarter - 1.0).abs() < 1e-15, "{quarter}");
    let point = mapping((-1.0, 1.0), (7.0, 7.0));
    assert_eq!(point.encode(Some(f64::MAX)), 7.0);
}

/// [NCP-CODEC-001] [NCP-CODEC-002] Whatever is finite stays within the target.
#[test]
fn no_finite_range_or_sample_makes_a_rate_outside_its_range() {
    let numbers = [0.0, -0.0, TINY, -TINY, 1.0, -1.0, 1e160, -1e160, f64::MAX, f64::MIN];
    for (v0, v1) in numbers.iter().flat_map(|&a| numbers.map(|b| (a, b))) {
        for (r0, r1) in numbers.iter().flat_map(|&a| numbers.map(|b| (a, b))) {
            for x in numbers {
                let rate = mapping((v0, v1), (r0, r1)).encode(Some(x));
                assert!(r0.min(r1) <= rate && rate <= r0.max(r1), "{v0} … {v1}, {r0} … {r1}: {x} gave {rate}");
            }
        }
    }
}

/// [NCP-CODEC-008]
#[test]
fn a_mapping_of_component_4096_or_more_is_ignored() {
    for (component, counts) in [(4_095, true), (4_096, false), (4_097, false), (usize::MAX, false)] {
        let far = Mapping { component, ..plain() };
        let codec = RateCodec { encoders: vec![far.clone()], decoders: vec![far] };
        assert_eq!(codec.encode(None).contains_key("drive"), counts, "{component}");
        let channels = decode(&codec, &[("drive", 200.0)]);
        assert_eq!(
            channels.get("stick").map(|stick| stick.data.len()),
            counts.then_some(MAX_COMPONENTS),
            "{component}"
        );
    }
}

/// [NCP-CODEC-009]
#[test]
fn a_decoded_command_has_the_stamps_and_the_mode_that_it_was_given() {
    for mode in [Mode::Init, Mode::Active, Mode::Hold, Mode::Estop] {
        let command = RateCodec::uav().decode(&Rates::new(), 12.5, -3, "base_link", mode);
        let CommandFrame { t, seq, frame_id, mode: found, ttl_ms, horizon, .. } = command;
        assert_eq!((t, seq, &*frame_id, found), (12.5, -3, "base_link", mode));
        assert_eq!((ttl_ms, horizon.len()), (200.0, 0));
    }
}

/// [NCP-CODEC-010]
#[test]
fn a_component_between_those_that_are_mapped_is_zero() {
    let decoders = [3, 1].map(|component| Mapping { component, ..mapping((5.0, 7.0), (0.0, 1.0)) });
    let codec = RateCodec { encoders: vec![], decoders: decoders.to_vec() };
    assert_eq!(decode(&codec, &[("drive", 1.0)])["stick"].data, [0.0, 7.0, 0.0, 7.0]);
}

#[test]
fn the_first_mapping_of_a_channel_that_names_a_unit_decides_on_it() {
    let unit = |units: [Option<&'static str>; 3]| {
        let decoders =
            (0..).zip(units).map(|(component, unit)| Mapping { component, unit: unit.map(Into::into), ..plain() });
        let codec = RateCodec { encoders: vec![], decoders: decoders.collect() };
        decode(&codec, &[])["stick"].unit.clone()
    };
    assert_eq!(unit([None, None, None]), None);
    assert_eq!(unit([Some("m"), None, Some("rad")]).as_deref(), Some("m"));
    assert_eq!(unit([None, Some("rad"), Some("m")]).as_deref(), Some("rad"));
    assert_eq!(unit([None, None, Some("m")]).as_deref(), Some("m"));
}

/// [NCP-CODEC-013] Against the formula in numbers of twice the digits: a double and what it misses.
#[test]
fn a_result_is_the_formula_to_a_rounding_of_the_greater_end() {
    let ends = [0.0, 1e-9, 0.1, 0.3, 1.0 / 3.0, 7.7, 200.0, 1e6 + 0.1, 1e12];
    let signed: Vec<f64> = ends.iter().flat_map(|end| [*end, -end]).collect();
    let mut checked = 0;
    for from in signed.iter().flat_map(|a| signed.iter().map(move |b| (*a, *b))).filter(|(a, b)| a < b) {
        for to in signed.iter().flat_map(|a| signed.iter().map(move |b| (*a, *b))) {
            for share in [0.1, 0.7, 0.999_999] {
                let x = from.0 + share * (from.1 - from.0);
                let parts = Exact::from(x).less(from.0).over(Exact::from(from.1).less(from.0));
                let exact = parts.times(Exact::from(to.1).less(to.0)).plus(to.0);
                let off = 1e-12 * to.0.abs().max(to.1.abs());
                let near = |got: f64| (got - exact.0).abs() <= off;
                assert!(near(mapping(from, to).encode(Some(x))), "{x} in {from:?} to {to:?}");
                assert!(near(mapping(to, from).decode(Some(x))), "{x} in {from:?} to {to:?}");
                checked += 1;
            }
        }
    }
    assert!(checked > 100_000, "{checked}");
}

/// A number as the sum of two doubles, the first its rounding.
#[derive(Clone, Copy)]
struct Exact(f64, f64);

impl From<f64> for Exact {
    fn from(value: f64) -> Self {
        Self(value, 0.0)
    }
}

impl Exact {
    fn of(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self(sum, low - (sum - high))
    }

    fn plus(self, other: f64) -> Self {
        let sum = self.0 + other;
        let virtual_other = sum - self.0;
        let lost = (self.0 - (sum - virtual_other)) + (other - virtual_other);
        Self::of(sum, lost + self.1)
    }

    fn less(self, other: f64) -> Self {
        self.plus(-other)
    }

    fn times(self, other: Self) -> Self {
        let product = self.0 * other.0;
        let lost = self.0.mul_add(other.0, -product);
        Self::of(product, lost + self.0 * other.1 + self.1 * other.0)
    }

    fn over(self, other: Self) -> Self {
        let quotient = self.0 / other.0;
        let rest = other.times(Self::from(quotient));
        let missing = self.plus(-rest.0).0 - rest.1;
        Self::of(quotient, missing / other.0)
    }
}

/// [NCP-CODEC-020] Every cell of the table.
#[test]
fn the_default_uav_codec_is_the_one_of_the_table() {
    assert_eq!(RATE_CODEC_ID, "ncp.codec.rate.v0");
    let uav = RateCodec::uav();
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        for (error, rate) in [(-2.0, 0.0), (-1.0, 50.0), (0.0, 100.0), (2.0, 200.0), (3.0, 200.0)] {
            let mut errors = [0.0; 3];
            errors[axis] = error;
            let encoded = uav.encode(Some(&sensed("pose_error", &errors)));
            let want = ["x", "y", "z"].map(|other| (format!("err_{other}"), if other == name { rate } else { 100.0 }));
            assert_eq!(encoded, Rates::from(want));
        }
        for (rate, speed) in [(0.0, -1.5), (50.0, -0.75), (100.0, 0.0), (200.0, 1.5), (999.0, 1.5)] {
            let mut want = [0.0; 3];
            want[axis] = speed;
            let channels = decode(&uav, &[(&format!("vel_{name}"), rate)]);
            assert_eq!(channels, ChannelMap::from_iter([("velocity_setpoint", ChannelValue::new(want, "m/s"))]));
        }
    }
    assert_eq!((uav.encoders.len(), uav.decoders.len()), (3, 3));
}

/// [NCP-CODEC-005] [NCP-CODEC-006] Nothing sensed and nothing read out is a plant that stands still.
#[test]
fn a_uav_without_a_sensor_and_without_a_network_is_commanded_to_stand_still() {
    let uav = RateCodec::uav();
    assert!(uav.encode(None).values().all(|&rate| rate == 100.0));
    let command = uav.decode(&Rates::new(), 0.0, 1, "world", Mode::Active);
    assert_eq!(command.channels["velocity_setpoint"].data, [0.0; 3]);
    assert_eq!(CommandFrame::decode(command.encode().unwrap().as_bytes()).unwrap(), command);
}
