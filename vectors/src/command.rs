//! A command frame, as the plant receives it and as the governor is given it.

use ncp_text::WIRE_VERSION;

use crate::json::{Json, object};
use crate::scenario::{Place, ScenarioError, Step};
use crate::trace::{int, num, nums};

pub(crate) const POSITION: &str = "pose_position";
pub(crate) const VELOCITY: &str = "velocity_setpoint";
pub(crate) const M: &str = "m";
pub(crate) const MPS: &str = "m/s";

/// A sample of a channel.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Channel {
    pub(crate) name: String,
    pub(crate) data: Vec<f64>,
    pub(crate) unit: Option<String>,
}

impl Channel {
    pub(crate) fn is_finite(&self) -> bool {
        self.data.iter().all(|x| x.is_finite())
    }
}

pub(crate) fn channel(name: &str, data: &[f64], unit: Option<&str>) -> Channel {
    Channel { name: name.to_owned(), data: data.to_vec(), unit: unit.map(str::to_owned) }
}

pub(crate) fn velocity(data: &[f64]) -> Channel {
    channel(VELOCITY, data, Some(MPS))
}

/// Samples by the names of their channels.
pub(crate) fn channels_json(channels: &[Channel]) -> Json {
    let value = |channel: &Channel| {
        let value = object! { "data" => nums(&channel.data), "unit" => channel.unit.as_deref() };
        (channel.name.clone(), value)
    };
    Json::Object(channels.iter().map(value).collect())
}

/// The channels that a word says, with `&` between: samples of named channels, as `grip=0.5` or `tow=0,30,40[m/s]`,
/// and of
/// the one that needs no name, as `1,0,0`. A hyphen stands for no channel.
pub(crate) fn channels(
    place: Place,
    word: &str,
    nameless: impl Fn(&[f64]) -> Channel,
) -> Result<Vec<Channel>, ScenarioError> {
    let one = |word: &str| match word.split_once('=') {
        None => Ok(nameless(&place.doubles(word)?)),
        Some((name, sample)) => {
            let (data, unit) = match sample.split_once('[') {
                Some((data, unit)) => (data, Some(unit.trim_end_matches(']'))),
                None => (sample, None),
            };
            Ok(channel(name, &place.doubles(data)?, unit))
        }
    };
    word.split('&').filter(|word| !matches!(*word, "" | "-")).map(one).collect()
}

/// The fields of a command frame. What is `None` is absent.
#[derive(Debug, Clone)]
pub(crate) struct Command {
    pub(crate) version: Option<String>,
    pub(crate) seq: Option<i64>,
    /// The sender's time, s.
    pub(crate) t: f64,
    pub(crate) frame_id: &'static str,
    pub(crate) mode: Option<String>,
    /// In ms.
    pub(crate) ttl: f64,
    pub(crate) channels: Vec<Channel>,
    pub(crate) horizon: Vec<Vec<Channel>>,
    /// The length of a tick, ms.
    pub(crate) dt: Option<f64>,
}

/// A command of a quarter of a second that commands its own seq along x, so that it is told from others.
pub(crate) fn active(seq: i64) -> Command {
    #[expect(clippy::cast_precision_loss, reason = "a value is only to be told from others")]
    let x = seq as f64;
    Command { t: 3.0, ..Command::moving(&[x, 0.0, 0.0]).seq(seq) }
}

impl Command {
    /// With these channels.
    pub(crate) fn of(channels: Vec<Channel>) -> Self {
        Self {
            version: Some(WIRE_VERSION.to_owned()),
            seq: Some(7),
            t: 1.5,
            frame_id: "world",
            mode: Some("active".to_owned()),
            ttl: 250.0,
            channels,
            horizon: Vec::new(),
            dt: None,
        }
    }

    /// With that velocity and nothing else.
    pub(crate) fn moving(data: &[f64]) -> Self {
        Self::of(vec![velocity(data)])
    }

    pub(crate) fn mode(mut self, mode: &str) -> Self {
        self.mode = Some(mode.to_owned());
        self
    }

    pub(crate) fn ttl(mut self, ttl: f64) -> Self {
        self.ttl = ttl;
        self
    }

    pub(crate) fn seq(mut self, seq: i64) -> Self {
        self.seq = Some(seq);
        self
    }

    /// With that speed along x.
    pub(crate) fn x(mut self, x: f64) -> Self {
        self.channels = vec![velocity(&[x, 0.0, 0.0])];
        self
    }

    /// And further channels.
    pub(crate) fn and(mut self, more: Channel) -> Self {
        self.channels.push(more);
        self
    }

    /// And a horizon of velocities.
    pub(crate) fn then(mut self, dt: f64, velocities: &[[f64; 3]]) -> Self {
        self.horizon = velocities.iter().map(|data| vec![velocity(data)]).collect();
        self.dt = Some(dt);
        self
    }

    /// And a horizon of speeds along x.
    pub(crate) fn along_x(self, dt: f64, speeds: &[f64]) -> Self {
        let velocities: Vec<_> = speeds.iter().map(|x| [*x, 0.0, 0.0]).collect();
        self.then(dt, &velocities)
    }

    /// Changed as the settings of a step say.
    pub(crate) fn set(mut self, step: &Step) -> Result<Self, ScenarioError> {
        for word in step.words() {
            if let Some((name, value)) = word.split_once('=')
                && !self.setting(step.place, name, value)?
            {
                return Err(step.place.wants("setting of a command", word));
            }
        }
        Ok(self)
    }

    /// Changed as a setting says, if it is one of a command: `seq`, `ttl`, `dt`, `t`, `version`, `mode`, `x` for the
    /// speed along x, `v` for the channels, `then` for a horizon of speeds along x, and `horizon` for one of channels,
    /// with slashes between its ticks, of which `9*1,0,0` is nine.
    pub(crate) fn setting(&mut self, place: Place, name: &str, value: &str) -> Result<bool, ScenarioError> {
        let some = |text: &str| (text != "-").then(|| text.to_owned());
        match name {
            "version" => self.version = some(value),
            // A space within it is written `\\s`.
            "mode" => self.mode = some(&value.replace("\\s", " ")),
            "seq" => self.seq = Some(place.integer(value)?),
            "t" => self.t = place.double(value)?,
            "ttl" => self.ttl = place.double(value)?,
            "dt" => self.dt = if value == "-" { None } else { Some(place.double(value)?) },
            "x" => self.channels = vec![velocity(&[place.double(value)?, 0.0, 0.0])],
            "v" => self.channels = channels(place, value, velocity)?,
            "horizon" => {
                self.horizon.clear();
                for tick in value.split('/').filter(|tick| !tick.is_empty()) {
                    let (times, tick) = tick.split_once('*').unwrap_or(("1", tick));
                    let times = times.parse().map_err(|_| place.wants("number of ticks", times))?;
                    self.horizon.extend(std::iter::repeat_n(channels(place, tick, velocity)?, times));
                }
            }
            "then" => {
                let speeds = place.doubles(value)?;
                self.horizon = speeds.iter().map(|x| vec![velocity(&[*x, 0.0, 0.0])]).collect();
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    pub(crate) fn is(&self, mode: &str) -> bool {
        self.mode.as_deref() == Some(mode)
    }

    /// The fields, as a call takes them.
    pub(crate) fn fields(&self) -> Json {
        let mut fields = object! {
            "seq" => self.seq.map(int),
            "t" => num(self.t),
            "frame_id" => self.frame_id,
            "mode" => self.mode.as_deref(),
            "ttl_ms" => num(self.ttl),
            "channels" => channels_json(&self.channels),
        };
        if !self.horizon.is_empty() {
            fields = fields.and("horizon", self.horizon.iter().map(|step| channels_json(step)).collect());
        }
        match self.dt {
            Some(dt) => fields.and("horizon_dt_ms", num(dt)),
            None => fields,
        }
    }

    /// The frame as it travels, without what is absent.
    pub(crate) fn frame(&self) -> Json {
        // As a frame spells it, the sign of a zero included.
        let spelled = |value: f64| Json::literal(format!("{value:?}"));
        let frame = object! {
            "ncp_version" => self.version.as_deref(),
            "kind" => "command_frame",
            "seq" => self.seq.map(int),
            "t" => num(self.t),
            "frame_id" => self.frame_id,
            "mode" => self.mode.as_deref(),
            "ttl_ms" => spelled(self.ttl),
            "channels" => channels_json(&self.channels),
            "horizon" => self.horizon.iter().map(|step| channels_json(step)).collect::<Json>(),
            "horizon_dt_ms" => self.dt.map(spelled),
        };
        let absent =
            [("ncp_version", self.version.is_none()), ("seq", self.seq.is_none()), ("mode", self.mode.is_none())];
        absent.into_iter().fold(frame, |frame, (name, is)| if is { frame.without(name) } else { frame })
    }

    /// Whether a JSON text can hold it.
    pub(crate) fn is_writable(&self) -> bool {
        let all = |channels: &[Channel]| channels.iter().all(Channel::is_finite);
        all(&self.channels)
            && self.horizon.iter().all(|step| all(step))
            && self.ttl.is_finite()
            && self.t.is_finite()
            && self.dt.is_none_or(f64::is_finite)
    }
}
