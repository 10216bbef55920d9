//! The rate codec `ncp.codec.rate.v0`: chapter 9.

use std::collections::BTreeMap;

use crate::safety::{METRES_PER_SECOND, VELOCITY_CHANNEL};
use crate::wire::{ChannelValue, CommandFrame, Mode, SensorFrame, Text};

/// The codec's id in `Capabilities.codec_id`.
pub const RATE_CODEC_ID: &str = "ncp.codec.rate.v0";
/// A mapping of this component or a higher one is ignored. `[NCP-CODEC-008]`
pub const MAX_COMPONENTS: usize = 4_096;

/// Rates in Hz by population.
pub type Rates = BTreeMap<String, f64>;

/// Ties components of channels to populations of neurons, both ways.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RateCodec {
    /// From sensor channels to populations.
    pub encoders: Vec<Mapping>,
    /// From populations to command channels.
    pub decoders: Vec<Mapping>,
}

/// One component of a channel and one population.
#[derive(Debug, Clone, PartialEq)]
pub struct Mapping {
    /// The channel's name.
    pub channel: Text,
    /// The component, from 0.
    pub component: usize,
    /// The population's name.
    pub population: Text,
    /// The range of the component, in the channel's unit.
    pub value_range: (f64, f64),
    /// The range of the rate, in Hz.
    pub rate_range: (f64, f64),
    /// The unit of a decoded channel: the first of its mappings that names one decides.
    pub unit: Option<Text>,
}

impl Mapping {
    /// A mapping with the default ranges, −1 … 1 and 0 … 200 Hz.
    pub fn new(channel: impl Into<Text>, component: usize, population: impl Into<Text>) -> Self {
        Self {
            channel: channel.into(),
            component,
            population: population.into(),
            value_range: (-1.0, 1.0),
            rate_range: (0.0, 200.0),
            unit: None,
        }
    }

    /// The rate of the population for a component's value. `[NCP-CODEC-001] [NCP-CODEC-002]`
    #[must_use]
    pub fn encode(&self, value: Option<f64>) -> f64 {
        map(value, self.value_range, self.rate_range)
    }

    /// The value of the component for a population's rate. `[NCP-CODEC-003] [NCP-CODEC-004]`
    #[must_use]
    pub fn decode(&self, rate: Option<f64>) -> f64 {
        map(rate, self.rate_range, self.value_range)
    }
}

impl RateCodec {
    /// The default UAV codec: the error of the pose in, a velocity out. `[NCP-CODEC-020]`
    #[must_use]
    pub fn uav() -> Self {
        let mapping = |channel, component, population, reach: f64| Mapping {
            value_range: (-reach, reach),
            ..Mapping::new(channel, component, population)
        };
        let error = |component, population| mapping("pose_error", component, population, 2.0);
        let velocity = |component, population| Mapping {
            unit: Some(Text::Borrowed(METRES_PER_SECOND)),
            ..mapping(VELOCITY_CHANNEL, component, population, 1.5)
        };
        Self {
            encoders: vec![error(0, "err_x"), error(1, "err_y"), error(2, "err_z")],
            decoders: vec![velocity(0, "vel_x"), velocity(1, "vel_y"), velocity(2, "vel_z")],
        }
    }

    /// The rates of the populations for what is sensed. `[NCP-CODEC-005] [NCP-CODEC-014]`
    #[must_use]
    pub fn encode(&self, sensor: Option<&SensorFrame>) -> Rates {
        usable(&self.encoders)
            .map(|mapping| {
                let value = sensor
                    .and_then(|frame| frame.channels.get(&mapping.channel))
                    .and_then(|channel| channel.data.get(mapping.component).copied());
                (mapping.population.to_string(), mapping.encode(value))
            })
            .collect()
    }

    /// The command for the rates of the populations. `[NCP-CODEC-006] [NCP-CODEC-009] [NCP-CODEC-014]`
    pub fn decode(&self, rates: &Rates, t: f64, seq: i64, frame_id: impl Into<Text>, mode: Mode) -> CommandFrame {
        let mut command = CommandFrame { t, seq, frame_id: frame_id.into(), mode, ..CommandFrame::default() };
        for mapping in usable(&self.decoders) {
            let value = mapping.decode(rates.get(mapping.population.as_ref()).copied());
            if !command.channels.contains_key(&mapping.channel) {
                let empty = ChannelValue::default();
                command.channels.insert(mapping.channel.clone(), empty);
            }
            let Some(channel) = command.channels.get_mut(&mapping.channel) else {
                continue;
            };
            // [NCP-CODEC-011]
            if channel.unit.is_none() {
                channel.unit.clone_from(&mapping.unit);
            }
            if channel.data.len() <= mapping.component {
                channel.data.resize(mapping.component + 1, 0.0); // [NCP-CODEC-010]
            }
            if let Some(component) = channel.data.get_mut(mapping.component) {
                *component = value;
            }
        }
        command
    }
}

/// `[NCP-CODEC-008]`
fn usable(mappings: &[Mapping]) -> impl Iterator<Item = &Mapping> {
    mappings.iter().filter(|mapping| mapping.component < MAX_COMPONENTS)
}

/// The linear map from one range to the other, clamped; the middle of the target for what cannot be
/// mapped. `[NCP-CODEC-005] [NCP-CODEC-006] [NCP-CODEC-007]`
fn map(value: Option<f64>, from: (f64, f64), to: (f64, f64)) -> f64 {
    let middle = f64::midpoint(to.0, to.1);
    let span = from.1 - from.0;
    let Some(value) = value.filter(|value| value.is_finite() && span.is_finite() && span != 0.0) else {
        return middle;
    };
    let share = (value - from.0) / span;
    let width = to.1 - to.0;
    // The same map, for a range that is wider than any double.
    let mapped = if width.is_finite() { to.0 + share * width } else { to.0 * (1.0 - share) + to.1 * share };
    let (low, high) = if to.0 <= to.1 { to } else { (to.1, to.0) };
    // `max` and `min` choose the bound over a NaN, and never panic as `clamp` does.
    if mapped.is_nan() { middle } else { mapped.max(low).min(high) }
}
