//! The rate codec: chapter 9.

use std::collections::BTreeMap;
use std::fmt;

use ncp_spec::ErrorCode;
use ncp_spec::codec::{self, Mapping, Rates};
use ncp_spec::wire::{Frame as _, Mode, SensorFrame, Text};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedStr;
use pyo3::types::PyDict;
use serde::de::{Deserialize, Deserializer, Error as _, IgnoredAny, MapAccess, Visitor};

use crate::argument::{Frame, double, index, integer, range};
use crate::error::{Error, Result};
use crate::message::{optional, to_dict};

/// Ties one component of a channel to a population of neurons.
///
/// `value_range` is in the channel's unit, `rate_range` in Hz; `unit` is that of a decoded channel.
#[pyclass(module = "ncp", frozen)]
#[derive(Clone)]
pub(crate) struct RateMapping(Mapping);

#[pymethods]
impl RateMapping {
    #[new]
    #[pyo3(
        signature = (channel, component, population, value_range=(-1.0, 1.0), rate_range=(0.0, 200.0), unit=None),
        text_signature = "(channel, component, population, value_range=(-1.0, 1.0), rate_range=(0.0, 200.0), unit=None)"
    )]
    fn new(
        channel: String,
        #[pyo3(from_py_with = index)] component: usize,
        population: String,
        #[pyo3(from_py_with = range)] value_range: (f64, f64),
        #[pyo3(from_py_with = range)] rate_range: (f64, f64),
        unit: Option<String>,
    ) -> Self {
        Self(Mapping {
            value_range,
            rate_range,
            unit: unit.map(Into::into),
            ..Mapping::new(channel, component, population)
        })
    }

    /// The channel's name.
    #[getter]
    fn channel(&self) -> &str {
        &self.0.channel
    }

    /// The component, from 0. One of 4096 or more is ignored.
    #[getter]
    fn component(&self) -> usize {
        self.0.component
    }

    /// The population's name.
    #[getter]
    fn population(&self) -> &str {
        &self.0.population
    }

    /// The range of the component, in the channel's unit.
    #[getter]
    fn value_range(&self) -> (f64, f64) {
        self.0.value_range
    }

    /// The range of the rate, in Hz.
    #[getter]
    fn rate_range(&self) -> (f64, f64) {
        self.0.rate_range
    }

    /// The unit of a decoded channel.
    #[getter]
    fn unit(&self) -> Option<&str> {
        self.0.unit.as_deref()
    }
}

/// The rate codec `ncp.codec.rate.v0`: channels to populations, and back.
#[pyclass(module = "ncp", frozen)]
pub(crate) struct RateCodec(codec::RateCodec);

#[pymethods]
impl RateCodec {
    #[new]
    #[pyo3(signature = (encoders, decoders))]
    fn new(encoders: Vec<Bound<'_, RateMapping>>, decoders: Vec<Bound<'_, RateMapping>>) -> Self {
        let mappings =
            |given: Vec<Bound<'_, RateMapping>>| given.iter().map(|mapping| mapping.get().0.clone()).collect();
        Self(codec::RateCodec { encoders: mappings(encoders), decoders: mappings(decoders) })
    }

    /// The default UAV codec: `pose_error` in, `velocity_setpoint` out.
    #[staticmethod]
    fn uav() -> Self {
        Self(codec::RateCodec::uav())
    }

    /// The codec of a JSON text, as `encode_rates` takes it.
    #[staticmethod]
    fn from_json(codec_json: PyBackedStr) -> Result<Self> {
        Ok(Self(codec_of(&codec_json)?))
    }

    /// The rate of each population in Hz, for what is sensed: a dict or a frame.
    #[pyo3(signature = (sensor=None))]
    fn encode<'py>(&self, py: Python<'py>, sensor: Option<&Bound<'py, PyAny>>) -> Result<Bound<'py, PyDict>> {
        let sensor: Option<SensorFrame> = optional(sensor)?;
        let rates = PyDict::new(py);
        for (population, rate) in self.0.encode(sensor.as_ref()) {
            rates.set_item(population, rate)?;
        }
        Ok(rates)
    }

    /// The fields of the command for the rates of the populations, in Hz.
    #[pyo3(
        signature = (rates, t=0.0, seq=0, frame_id=None, mode=None),
        text_signature = "($self, rates, t=0.0, seq=0, frame_id='world', mode='active')"
    )]
    fn decode<'py>(
        &self,
        py: Python<'py>,
        rates: &Bound<'py, PyDict>,
        #[pyo3(from_py_with = double)] t: f64,
        #[pyo3(from_py_with = integer)] seq: i64,
        frame_id: Option<PyBackedStr>,
        mode: Option<PyBackedStr>,
    ) -> Result<Bound<'py, PyAny>> {
        let mut read = Rates::new();
        // A copy: the conversion of a rate may run Python code that changes the dict.
        for item in rates.items() {
            let (population, rate) = item.extract::<(String, Bound<'_, PyAny>)>()?;
            read.insert(population, double(&rate)?);
        }
        let (frame_id, mode) = (frame_of(frame_id.as_deref()), mode_of(mode.as_deref())?);
        to_dict(py, self.0.decode(&read, t, seq, frame_id, mode))
    }
}

/// The rates of the populations in Hz, as JSON, for a sensor frame.
///
/// `codec_json` is that of every published build: an object with `encoder` and `decoder`, arrays of mappings with
/// `channel` (of a decoder `command_channel`), `population`, and optionally `component`, `value_range`,
/// `rate_range_hz` and `unit`. It may also be `"uav"`, or an object with `encoders` and `decoders`, arrays of
/// mappings by the arguments of `RateMapping`.
#[pyfunction]
#[pyo3(signature = (codec_json, sensor_json=None))]
pub(crate) fn encode_rates(codec_json: PyBackedStr, sensor_json: Option<Frame>) -> Result<String> {
    let codec = codec_of(&codec_json)?;
    let sensor = sensor_json.map(|frame| SensorFrame::decode(frame.bytes())).transpose()?;
    let rates = codec.encode(sensor.as_ref());
    // JSON has no other number than a finite one; where a range is not, neither may the rate be.
    if let Some((population, _)) = rates.iter().find(|(_, rate)| !rate.is_finite()) {
        let what = "the rate is not finite";
        return Err(Error::at(ErrorCode::NonFinite, population.clone(), &what));
    }
    serde_json::to_string(&rates).map_err(|error| Error::refused(ErrorCode::Internal, &error))
}

/// The command frame for the rates of the populations, both as JSON.
#[pyfunction]
#[pyo3(
    signature = (codec_json, rates_json, t=0.0, seq=0, frame_id=None, mode=None),
    text_signature = "(codec_json, rates_json, t=0.0, seq=0, frame_id='world', mode='active')"
)]
pub(crate) fn decode_command(
    codec_json: PyBackedStr,
    rates_json: PyBackedStr,
    #[pyo3(from_py_with = double)] t: f64,
    #[pyo3(from_py_with = integer)] seq: i64,
    frame_id: Option<PyBackedStr>,
    mode: Option<PyBackedStr>,
) -> Result<String> {
    let codec = codec_of(&codec_json)?;
    let RatesJson(rates) = parse("rates", &rates_json)?;
    let (frame_id, mode) = (frame_of(frame_id.as_deref()), mode_of(mode.as_deref())?);
    Ok(codec.decode(&rates, t, seq, frame_id, mode).encode()?)
}

fn frame_of(frame_id: Option<&str>) -> Text {
    frame_id.map_or(Text::Borrowed("world"), |frame_id| frame_id.to_owned().into())
}

fn mode_of(name: Option<&str>) -> Result<Mode> {
    name.map_or(Some(Mode::Active), Mode::parse).ok_or_else(|| {
        let what = "a mode is init, active, hold or estop";
        Error::at(ErrorCode::Value, "mode".to_owned(), &what)
    })
}

fn codec_of(json: &str) -> Result<codec::RateCodec> {
    if let Ok(Preset::Uav) = serde_json::from_str(json) {
        return Ok(codec::RateCodec::uav());
    }
    let Form { encoders, decoders } = parse("codec", json)?;
    if encoders.is_some() || decoders.is_some() {
        let OwnJson { encoders, decoders } = parse("codec", json)?;
        return Ok(codec::RateCodec {
            encoders: encoders.into_iter().map(mapping).collect(),
            decoders: decoders.into_iter().map(mapping).collect(),
        });
    }
    let PublishedJson { codec_id: RateCodecId::Rate, encoder, decoder } = parse("codec", json)?;
    Ok(codec::RateCodec {
        encoders: encoder.into_iter().map(EncoderJson::mapping).collect(),
        decoders: decoder.into_iter().map(DecoderJson::mapping).collect(),
    })
}

fn mapping(json: MappingJson) -> Mapping {
    let default = Mapping::new(json.channel, json.component, json.population);
    Mapping {
        value_range: json.value_range.unwrap_or(default.value_range),
        rate_range: json.rate_range.unwrap_or(default.rate_range),
        unit: json.unit.map(Into::into),
        ..default
    }
}

fn parse<'a, T: Deserialize<'a>>(what: &str, json: &'a str) -> Result<T> {
    serde_json::from_str(json).map_err(|error| {
        let code = if error.is_data() { ErrorCode::Value } else { ErrorCode::Malformed };
        Error::refused(code, &format_args!("{what}: {error}"))
    })
}

/// What tells our own form, in which a misspelt member is an error, from the published one.
#[derive(serde::Deserialize)]
struct Form {
    encoders: Option<IgnoredAny>,
    decoders: Option<IgnoredAny>,
}

/// The form that every published build reads: members that it does not know are ignored, and an empty object is a
/// codec without mappings.
#[derive(serde::Deserialize, Default)]
#[serde(default)]
struct PublishedJson {
    codec_id: RateCodecId,
    encoder: Vec<EncoderJson>,
    decoder: Vec<DecoderJson>,
}

/// The only codec that there is.
#[derive(serde::Deserialize, Default)]
enum RateCodecId {
    #[default]
    #[serde(rename = "ncp.codec.rate.v0")]
    Rate,
}

/// The only coding that there is.
#[derive(serde::Deserialize, Default)]
#[serde(rename_all = "snake_case")]
enum Coding {
    #[default]
    Rate,
}

#[derive(serde::Deserialize)]
struct EncoderJson {
    channel: String,
    #[serde(default)]
    component: usize,
    population: String,
    #[serde(default, rename = "coding")]
    _coding: Coding,
    value_range: Option<(f64, f64)>,
    rate_range_hz: Option<(f64, f64)>,
}

impl EncoderJson {
    fn mapping(self) -> Mapping {
        let Self { channel, component, population, value_range, rate_range_hz, .. } = self;
        mapping(MappingJson { channel, component, population, value_range, rate_range: rate_range_hz, unit: None })
    }
}

#[derive(serde::Deserialize)]
struct DecoderJson {
    population: String,
    #[serde(default, rename = "readout")]
    _readout: Coding,
    command_channel: String,
    #[serde(default)]
    component: usize,
    unit: Option<String>,
    rate_range_hz: Option<(f64, f64)>,
    value_range: Option<(f64, f64)>,
}

impl DecoderJson {
    fn mapping(self) -> Mapping {
        let Self { population, command_channel: channel, component, unit, rate_range_hz, value_range, .. } = self;
        mapping(MappingJson { channel, component, population, value_range, rate_range: rate_range_hz, unit })
    }
}

#[derive(serde::Deserialize)]
#[serde(rename_all = "snake_case")]
enum Preset {
    Uav,
}

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct OwnJson {
    encoders: Vec<MappingJson>,
    decoders: Vec<MappingJson>,
}

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct MappingJson {
    channel: String,
    component: usize,
    population: String,
    value_range: Option<(f64, f64)>,
    rate_range: Option<(f64, f64)>,
    unit: Option<String>,
}

/// An object of numbers without a repeated member.
struct RatesJson(Rates);

impl<'de> Deserialize<'de> for RatesJson {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        struct Members;

        impl<'de> Visitor<'de> for Members {
            type Value = RatesJson;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object of numbers")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut members: A) -> std::result::Result<RatesJson, A::Error> {
                let mut rates = BTreeMap::new();
                while let Some((population, rate)) = members.next_entry::<String, f64>()? {
                    if rates.insert(population, rate).is_some() {
                        return Err(A::Error::custom("a population occurs twice"));
                    }
                }
                Ok(RatesJson(rates))
            }
        }

        deserializer.deserialize_map(Members)
    }
}
