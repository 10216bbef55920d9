//! Decoding and encoding the frames of the hot planes, against a plain serde-derive model of the
//! same messages: owned strings, `BTreeMap` channels, `serde_json`.
//!
//! `cargo bench -p ncp-spec --bench wire` prints the ratios, each of two works timed in turns in one
//! run. The model checks neither limits nor repeated members of a map.

use std::error::Error;
use std::hint::black_box;

use ncp_spec::wire::{CommandFrame, Frame, SensorFrame};

use paired::Bench;

mod paired;

/// What a short command holds, which is written in 215 bytes.
const COMMAND: &str = r#"{"kind":"command_frame","seq":7,"t":12.5,"mode":"active","channels":{
    "velocity_setpoint":{"data":[0.5,0.0,-0.2],"unit":"m/s"}}}"#;

/// What a sensor frame holds, which is written in 195 bytes.
const SENSOR: &str = r#"{"kind":"sensor_frame","seq":7,"t":0.5,"channels":{
    "pose_position":{"data":[1.0,2.0,-3.5],"unit":"m"},
    "pose_velocity":{"data":[0.1,0.0,-0.2],"unit":"m/s"}}}"#;

/// As [`COMMAND`], but nothing in it is short or well known.
const ODD_COMMAND: &str = r#"{"kind":"command_frame","seq":9007199254740991,"t":1763677412.0482714,
    "frame_id":"base_link_7","mode":"active","ttl_ms":133.33333333333334,"channels":{
    "gripper_left":{"data":[0.30000000000000004,-1.2345678901234567,2.718281828459045],"unit":"N·m"}}}"#;

fn main() -> Result<(), Box<dyn Error>> {
    let bench = Bench::from_args();
    against_serde::<CommandFrame, plain::CommandFrame>(&bench, "command-frame", COMMAND)?;
    against_serde::<SensorFrame, plain::SensorFrame>(&bench, "sensor-frame", SENSOR)?;
    against_serde::<CommandFrame, plain::CommandFrame>(&bench, "odd-command-frame", ODD_COMMAND)?;
    Ok(())
}

fn against_serde<F, P>(bench: &Bench, name: &str, sample: &str) -> Result<(), Box<dyn Error>>
where
    F: Frame,
    P: serde::Serialize + serde::de::DeserializeOwned,
{
    let frame = &F::decode(sample.as_bytes())?.encode()?;
    println!("note   {name}: {} bytes", frame.len());
    let (message, plain) = (F::decode(frame.as_bytes())?, serde_json::from_slice::<P>(frame.as_bytes())?);
    let plainly = serde_json::to_string(&plain)?;
    let fields = plainly.trim_end_matches('}');
    assert!(frame.starts_with(fields), "both sides write the same bytes, as far as the plain side knows the fields");
    let (against, aim) = ("serde", "≤ 1.0, aim 0.6");
    bench.ratio(
        &format!("wire/decode-{name}"),
        against,
        aim,
        || F::decode(black_box(frame.as_bytes())),
        || serde_json::from_slice::<P>(black_box(frame.as_bytes())),
    );
    bench.ratio(
        &format!("wire/encode-{name}"),
        against,
        aim,
        || black_box(&message).encode(),
        || serde_json::to_string(black_box(&plain)),
    );
    Ok(())
}

mod plain {
    use std::collections::BTreeMap;

    use serde::{Deserialize, Serialize};

    #[derive(Serialize, Deserialize)]
    pub(crate) struct ChannelValue {
        #[serde(default)]
        data: Vec<f64>,
        #[serde(default)]
        unit: Option<String>,
    }

    #[derive(Serialize, Deserialize)]
    #[serde(rename_all = "lowercase")]
    pub(crate) enum Mode {
        Init,
        Active,
        Hold,
        Estop,
    }

    #[derive(Serialize, Deserialize)]
    #[serde(default)]
    pub(crate) struct SensorFrame {
        ncp_version: String,
        kind: String,
        seq: i64,
        t: f64,
        frame_id: String,
        channels: BTreeMap<String, ChannelValue>,
    }

    #[derive(Serialize, Deserialize)]
    #[serde(default)]
    pub(crate) struct CommandFrame {
        ncp_version: String,
        kind: String,
        seq: i64,
        t: f64,
        frame_id: String,
        mode: Mode,
        ttl_ms: f64,
        channels: BTreeMap<String, ChannelValue>,
        horizon: Vec<BTreeMap<String, ChannelValue>>,
        horizon_dt_ms: Option<f64>,
    }

    impl Default for SensorFrame {
        fn default() -> Self {
            Self {
                ncp_version: ncp_spec::WIRE_VERSION.into(),
                kind: "sensor_frame".into(),
                seq: 0,
                t: 0.0,
                frame_id: "world".into(),
                channels: BTreeMap::new(),
            }
        }
    }

    impl Default for CommandFrame {
        fn default() -> Self {
            Self {
                ncp_version: ncp_spec::WIRE_VERSION.into(),
                kind: "command_frame".into(),
                seq: 0,
                t: 0.0,
                frame_id: "world".into(),
                mode: Mode::Hold,
                ttl_ms: 200.0,
                channels: BTreeMap::new(),
                horizon: Vec::new(),
                horizon_dt_ms: None,
            }
        }
    }
}
