//! The rate codec, against the formulas of chapter 9.

use std::collections::BTreeMap;

use ncp_spec::codec::{Mapping, RateCodec, Rates};
use ncp_spec::wire::{ChannelValue, Mode, SensorFrame};

use crate::plain::{plain, read};

plain! {
    /// Names of channels and of populations.
    words Name = ["a", "b", "velocity_setpoint", "vel_x"];
}
plain! {
    /// A mapping of either direction.
    struct Tie {
        /// The channel.
        channel: Name,
        /// The component; 250 and more stand for 4,090 and more.
        component: u8,
        /// The population.
        population: Name,
        /// The range of the component.
        value_range: (f64, f64),
        /// The range of the rate.
        rate_range: (f64, f64),
    }
}
plain! {
    /// A codec and what it is given.
    struct Run {
        /// The mappings of both directions.
        ties: Vec<Tie>,
        /// The channels of the sensor, if there is one.
        sensor: Option<Vec<(Name, Vec<f64>)>>,
        /// The rates.
        rates: Vec<(Name, f64)>,
    }
}

/// Both directions give the linear map, clamped to the range, and the middle where there is nothing to
/// map.
///
/// It would find an extreme for a missing input, a value outside its range, a NaN that comes through,
/// and a component that makes the decoder fill memory.
// [NCP-CODEC-001] [NCP-CODEC-002] [NCP-CODEC-003] [NCP-CODEC-004] [NCP-CODEC-005] [NCP-CODEC-006]
// [NCP-CODEC-007] [NCP-CODEC-008] [NCP-CODEC-009] [NCP-CODEC-010]
pub fn codec(input: &[u8]) {
    let run = read::<Run>(input);
    let ties: Vec<_> = run.ties.iter().map(Tie::build).collect();
    let codec = RateCodec { encoders: ties.clone(), decoders: ties.clone() };
    let usable: Vec<_> = ties.iter().filter(|tie| tie.component < 4_096).collect();

    let sensor = run.sensor.as_ref().map(|channels| SensorFrame {
        channels: channels.iter().map(|(name, data)| (name.0, ChannelValue::without_unit(data.clone()))).collect(),
        ..SensorFrame::default()
    });
    let rates = codec.encode(sensor.as_ref());
    let populations: BTreeMap<_, _> = usable.iter().map(|tie| (tie.population.to_string(), *tie)).collect();
    assert!(rates.keys().eq(populations.keys()));
    for (population, tie) in populations {
        let sensor = sensor.as_ref();
        let value = sensor.and_then(|frame| frame.channels.get(&tie.channel)?.data.get(tie.component));
        judge(value.copied(), tie.value_range, tie.rate_range, rates[&population]);
    }

    let rates: Rates = run.rates.iter().map(|(name, rate)| (name.0.to_owned(), *rate)).collect();
    let command = codec.decode(&rates, 2.5, 7, "world", Mode::Active);
    assert_eq!((command.t, command.seq, command.mode), (2.5, 7, Mode::Active));
    let mut components: BTreeMap<(&str, usize), &Mapping> = BTreeMap::new();
    for tie in usable {
        components.insert((tie.channel.as_ref(), tie.component), tie);
    }
    for (name, channel) in command.channels.iter() {
        let widest = components.keys().filter(|(of, _)| *of == name).map(|(_, nth)| nth + 1).max();
        assert_eq!(Some(channel.data.len()), widest);
        for (nth, component) in channel.data.iter().enumerate() {
            match components.get(&(name, nth)) {
                None => assert_eq!(*component, 0.0),
                Some(tie) => {
                    let rate = rates.get(tie.population.as_ref()).copied();
                    judge(rate, tie.rate_range, tie.value_range, *component);
                }
            }
        }
    }
    let named = components.keys().all(|(name, _)| command.channels.contains_key(name));
    assert!(named, "a channel is missing");
}

impl Tie {
    fn build(&self) -> Mapping {
        let component = usize::from(self.component);
        Mapping {
            value_range: self.value_range,
            rate_range: self.rate_range,
            ..Mapping::new(
                self.channel.0,
                if component < 250 { component } else { component + 3_840 },
                self.population.0,
            )
        }
    }
}

/// Whether a value is mapped from one range to another as the text says. A target range that is not
/// finite has no middle, and the text says nothing of it.
fn judge(value: Option<f64>, from: (f64, f64), to: (f64, f64), mapped: f64) {
    if !to.0.is_finite() || !to.1.is_finite() {
        return;
    }
    let (low, high) = (to.0.min(to.1), to.0.max(to.1));
    assert!((low..=high).contains(&mapped), "{mapped} is outside {low} … {high}");
    let length = from.1 - from.0;
    let usable = value.filter(|value| value.is_finite() && length.is_finite() && length != 0.0);
    let size = high.abs().max(low.abs());
    let Some(value) = usable else {
        let middle = to.0 / 2.0 + to.1 / 2.0;
        assert!((mapped - middle).abs() <= 1e-9 * size + 1e-300, "{mapped} is not the middle {middle}");
        return;
    };
    // Where every difference is exact to a few digits; elsewhere the range is what is checked.
    let tame = |x: f64| x == 0.0 || (1e-6..=1e9).contains(&x.abs());
    if [value, from.0, from.1, to.0, to.1, length].into_iter().all(tame) {
        let wanted = to.0 + (value - from.0) / length * (to.1 - to.0);
        let wanted = wanted.max(low).min(high);
        assert!((mapped - wanted).abs() <= 1e-6 * size.max(1.0), "{mapped} is not {wanted}");
    }
}
