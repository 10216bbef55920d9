//! The JSON texts that are no frames: fields, limits, codecs, gains, rates, channels.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt;

use ncp_spec::ErrorCode;
use ncp_spec::codec::{Mapping, RateCodec, Rates};
use ncp_spec::control::ReflexConfig;
use ncp_spec::wire::{
    self, Capabilities, ChannelMap, CommandFrame, DecodeError, Kind, Message, SafetyLimits, SensorFrame,
};
use serde::de::{self, Deserializer, MapAccess, Visitor};
use serde::{Deserialize, Serialize, Serializer};
use serde_json::value::RawValue;

use crate::abi::Refusal;

/// A command as a program builds it. It has to say its mode: a program's default moves the plant, the
/// wire's does not, and nobody can tell here which of the two was meant.
pub(crate) fn command(fields: &str) -> Result<CommandFrame, Refusal> {
    #[derive(Deserialize)]
    struct Said {
        mode: Option<de::IgnoredAny>,
    }

    let message = wire::build(Kind::CommandFrame, fields.as_bytes())?;
    if serde_json::from_str::<Said>(fields)?.mode.is_none() {
        return Err(Refusal::new(ErrorCode::Missing, "mode: a command that is to be governed says its mode"));
    }
    match message {
        Message::CommandFrame(command) => Ok(command),
        other => Err(other_kind(&other)),
    }
}

/// A sensor frame as a program builds it.
pub(crate) fn sensor(fields: &str) -> Result<SensorFrame, Refusal> {
    match wire::build(Kind::SensorFrame, fields.as_bytes())? {
        Message::SensorFrame(sensor) => Ok(sensor),
        other => Err(other_kind(&other)),
    }
}

/// The same, if there is one.
pub(crate) fn optional_sensor(fields: Option<&str>) -> Result<Option<SensorFrame>, Refusal> {
    fields.map(sensor).transpose()
}

/// Limits. A field that they do not have is an error: a limit that is misspelt would limit nothing.
pub(crate) fn limits(fields: &str) -> Result<SafetyLimits, Refusal> {
    // One whole value, so that it cannot reach beyond its place.
    let fields: &RawValue = serde_json::from_str(fields)?;
    capabilities(&format!(r#"{{"safety":{fields}}}"#)).map(|capabilities| capabilities.safety)
}

/// Capabilities as a program builds them.
pub(crate) fn capabilities(fields: &str) -> Result<Capabilities, Refusal> {
    match wire::build(Kind::Capabilities, fields.as_bytes())? {
        Message::Capabilities(capabilities) => Ok(capabilities),
        other => Err(other_kind(&other)),
    }
}

/// A codec: `"uav"`, an object of mappings, or one in the form of every published build.
pub(crate) fn codec(text: &str) -> Result<RateCodec, Refusal> {
    if let Ok(Preset::Uav) = serde_json::from_str(text) {
        return Ok(RateCodec::uav());
    }
    let Form { encoders, decoders } = serde_json::from_str(text)?;
    if encoders.is_some() || decoders.is_some() {
        let Own { encoders, decoders } = serde_json::from_str(text)?;
        return Ok(RateCodec {
            encoders: encoders.into_iter().map(Into::into).collect(),
            decoders: decoders.into_iter().map(Into::into).collect(),
        });
    }
    let Published { codec_id: RateCodecId::Rate, encoder, decoder } = serde_json::from_str(text)?;
    Ok(RateCodec {
        encoders: encoder.into_iter().map(|encoder| MappingText::from(encoder).into()).collect(),
        decoders: decoder.into_iter().map(|decoder| MappingText::from(decoder).into()).collect(),
    })
}

/// The gains and the target of a reflex controller.
pub(crate) fn reflex(text: &str) -> Result<ReflexConfig, Refusal> {
    let text: ReflexText = serde_json::from_str(text)?;
    let default = ReflexConfig::default();
    let or = |value: Option<Double>, default| value.map_or(default, |Double(value)| value);
    Ok(ReflexConfig {
        target_m: text.target.map_or(default.target_m, |axes| axes.map(|Double(axis)| axis)),
        kp: or(text.kp, default.kp),
        kd: or(text.kd, default.kd),
        max_speed_mps: or(text.max_speed, default.max_speed_mps),
    })
}

/// Rates by population. A population that stands there twice is an error.
pub(crate) fn rates(text: &str) -> Result<Rates, Refusal> {
    let RatesText(rates) = serde_json::from_str(text)?;
    Ok(rates)
}

/// Rates as JSON; what JSON lacks as `"NaN"`, `"Infinity"`, `"-Infinity"`.
pub(crate) fn rates_out(rates: &Rates) -> Result<String, Refusal> {
    let rates: BTreeMap<&str, Double> = rates.iter().map(|(name, rate)| (name.as_str(), Double(*rate))).collect();
    Ok(serde_json::to_string(&rates)?)
}

/// Channels as JSON.
pub(crate) fn channels_out(channels: &ChannelMap) -> Result<String, Refusal> {
    #[derive(Serialize)]
    struct Channel<'a> {
        data: Vec<Double>,
        unit: Option<&'a str>,
    }

    let channels: BTreeMap<&str, Channel<'_>> = channels
        .iter()
        .map(|(name, value)| {
            let data = value.data.iter().copied().map(Double).collect();
            let unit = value.unit.as_deref();
            (name, Channel { data, unit })
        })
        .collect();
    Ok(serde_json::to_string(&channels)?)
}

/// A message is always of the kind that was asked for.
fn other_kind(message: &Message) -> Refusal {
    Refusal::new(ErrorCode::Internal, format_args!("{} was built", message.kind()))
}

/// A double: a JSON number, or one of the strings for those that JSON lacks.
#[derive(Clone, Copy)]
struct Double(f64);

impl<'de> Deserialize<'de> for Double {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged)]
        enum Spelling<'a> {
            Number(f64),
            #[serde(borrow)]
            Name(Cow<'a, str>),
        }

        match Spelling::deserialize(deserializer)? {
            Spelling::Number(value) => Ok(Self(value)),
            Spelling::Name(name) => match &*name {
                "NaN" => Ok(Self(f64::NAN)),
                "Infinity" => Ok(Self(f64::INFINITY)),
                "-Infinity" => Ok(Self(f64::NEG_INFINITY)),
                "-0" => Ok(Self(-0.0)),
                other => Err(de::Error::invalid_value(de::Unexpected::Str(other), &"a number")),
            },
        }
    }
}

impl Serialize for Double {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            value if value.is_nan() => serializer.serialize_str("NaN"),
            f64::INFINITY => serializer.serialize_str("Infinity"),
            f64::NEG_INFINITY => serializer.serialize_str("-Infinity"),
            value => serializer.serialize_f64(value),
        }
    }
}

/// What tells our own form, in which a misspelt member is an error, from the published one.
#[derive(Deserialize)]
struct Form {
    encoders: Option<de::IgnoredAny>,
    decoders: Option<de::IgnoredAny>,
}

/// The form that every published build reads: members that it does not know are ignored, and an empty object is a
/// codec without mappings.
#[derive(Deserialize, Default)]
#[serde(default)]
struct Published {
    codec_id: RateCodecId,
    encoder: Vec<EncoderText>,
    decoder: Vec<DecoderText>,
}

/// The only codec that there is.
#[derive(Deserialize, Default)]
enum RateCodecId {
    #[default]
    #[serde(rename = "ncp.codec.rate.v0")]
    Rate,
}

/// The only coding that there is.
#[derive(Deserialize, Default)]
#[serde(rename_all = "snake_case")]
enum Coding {
    #[default]
    Rate,
}

#[derive(Deserialize)]
struct EncoderText {
    channel: String,
    #[serde(default)]
    component: usize,
    population: String,
    #[serde(default, rename = "coding")]
    _coding: Coding,
    value_range: Option<[Double; 2]>,
    rate_range_hz: Option<[Double; 2]>,
}

impl From<EncoderText> for MappingText {
    fn from(text: EncoderText) -> Self {
        let EncoderText { channel, component, population, value_range, rate_range_hz, .. } = text;
        Self { channel, component, population, value_range, rate_range: rate_range_hz, unit: None }
    }
}

#[derive(Deserialize)]
struct DecoderText {
    population: String,
    #[serde(default, rename = "readout")]
    _readout: Coding,
    command_channel: String,
    #[serde(default)]
    component: usize,
    unit: Option<String>,
    rate_range_hz: Option<[Double; 2]>,
    value_range: Option<[Double; 2]>,
}

impl From<DecoderText> for MappingText {
    fn from(text: DecoderText) -> Self {
        let DecoderText { population, command_channel: channel, component, unit, rate_range_hz, value_range, .. } =
            text;
        Self { channel, component, population, value_range, rate_range: rate_range_hz, unit }
    }
}

#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
enum Preset {
    Uav,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Own {
    #[serde(default)]
    encoders: Vec<MappingText>,
    #[serde(default)]
    decoders: Vec<MappingText>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct MappingText {
    channel: String,
    component: usize,
    population: String,
    value_range: Option<[Double; 2]>,
    rate_range: Option<[Double; 2]>,
    unit: Option<String>,
}

impl From<MappingText> for Mapping {
    fn from(text: MappingText) -> Self {
        let range = |[Double(from), Double(to)]: [Double; 2]| (from, to);
        let default = Self::new(text.channel, text.component, text.population);
        Self {
            value_range: text.value_range.map_or(default.value_range, range),
            rate_range: text.rate_range.map_or(default.rate_range, range),
            unit: text.unit.map(Into::into),
            ..default
        }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ReflexText {
    target: Option<[Double; 3]>,
    kp: Option<Double>,
    kd: Option<Double>,
    max_speed: Option<Double>,
}

struct RatesText(Rates);

impl<'de> Deserialize<'de> for RatesText {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct RatesVisitor;

        impl<'de> Visitor<'de> for RatesVisitor {
            type Value = RatesText;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object of rates")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<RatesText, A::Error> {
                let mut rates = Rates::new();
                while let Some((name, Double(rate))) = map.next_entry::<String, Double>()? {
                    if rates.insert(name, rate).is_some() {
                        return Err(de::Error::custom("a population stands there twice"));
                    }
                }
                Ok(RatesText(rates))
            }
        }

        deserializer.deserialize_map(RatesVisitor)
    }
}

/// Reads a command from the wire.
pub(crate) fn received_command(frame: &str) -> Result<CommandFrame, DecodeError> {
    wire::Frame::decode(frame.as_bytes())
}

/// Reads a sensor frame from the wire.
pub(crate) fn received_sensor(frame: &str) -> Result<SensorFrame, DecodeError> {
    wire::Frame::decode(frame.as_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_cannot_reach_beyond_their_place() {
        let sneaky = r#"{"max_speed_mps":1},"sensor_channels":[],"safety":{}"#;
        assert!(limits(sneaky).is_err());
        assert_eq!(limits(r#"{"max_speed_mps":1.5}"#).unwrap().max_speed_mps, Some(1.5));
    }

    #[test]
    fn a_misspelt_limit_gain_or_range_is_refused() {
        assert!(limits(r#"{"max_sped_mps":1.5}"#).is_err());
        assert!(reflex(r#"{"max_sped":1.5}"#).is_err());
        let mapping = |range| {
            codec(&format!(
                r#"{{"encoders":[{{"channel":"c","component":0,"population":"p","{range}":[0,1]}}],"decoders":[]}}"#
            ))
        };
        assert!(mapping("value_range").is_ok());
        assert!(mapping("valu_range").is_err());
    }

    #[test]
    fn a_codec_is_read_in_the_form_of_every_published_build() {
        let uav = r#"{"codec_id":"ncp.codec.rate.v0","note":7,
            "encoder":[{"channel":"e","component":2,"population":"p","coding":"rate",
                "value_range":[-2,2],"n_neurons":9}],
            "decoder":[{"population":"q","readout":"rate","command_channel":"v","unit":"m/s",
                "rate_range_hz":[5,50]}]}"#;
        let RateCodec { encoders, decoders } = codec(uav).unwrap();
        let encoder = Mapping { value_range: (-2.0, 2.0), ..Mapping::new("e".to_owned(), 2, "p".to_owned()) };
        let decoder = Mapping::new("v".to_owned(), 0, "q".to_owned());
        let decoder = Mapping { rate_range: (5.0, 50.0), unit: Some("m/s".into()), ..decoder };
        assert_eq!((&encoders[..], &decoders[..]), (&[encoder][..], &[decoder][..]));
        assert_eq!(codec("{}").unwrap(), RateCodec { encoders: vec![], decoders: vec![] });
        for other in [r#"{"codec_id":"x"}"#, r#"{"encoder":[{"population":"p"}]}"#, r#"[]"#] {
            assert!(codec(other).is_err(), "{other}");
        }
    }

    #[test]
    fn a_command_without_a_mode_is_refused_and_not_taken_for_active() {
        assert_eq!(command(r#"{"seq":1}"#).unwrap_err().code, ErrorCode::Missing);
        assert!(command(r#"{"seq":1,"mode":"active"}"#).is_ok());
    }

    #[test]
    fn a_population_that_stands_there_twice_is_refused() {
        assert!(rates(r#"{"a":1,"a":2}"#).is_err());
        let read = rates(r#"{"a":"NaN","b":"-Infinity","c":2}"#).unwrap();
        assert_eq!(rates_out(&read).unwrap(), r#"{"a":"NaN","b":"-Infinity","c":2.0}"#);
    }
}
