//! Traces of the action buffer, against a small model of sections 8.1 and 8.2.

use ncp_spec::resilience::ActionBuffer;
use ncp_spec::wire::{ChannelMap, ChannelValue, CommandFrame, Frame, Mode};

use crate::governor::{ModeName, mode};
use crate::plain::{plain, read};

plain! {
    /// How a frame is damaged on its way.
    words Damage = ["nothing", "mode twice", "no number", "cut"];
}
plain! {
    /// A command that arrives.
    struct Arrival {
        /// The plant's clock in s.
        now_s: f64,
        /// Its mode.
        mode: ModeName,
        /// Its seq.
        seq: i64,
        /// Its ttl in ms.
        ttl_ms: f64,
        /// How many steps its horizon has, of 17 lengths.
        steps: u8,
        /// The length of a tick in ms.
        dt_ms: Option<f64>,
        /// What happens to it, if it travels as a frame.
        damage: Option<Damage>,
    }
}
plain! {
    /// A step of a trace.
    enum Step {
        /// A command arrives.
        0 Command(Arrival),
        /// The plant asks what to do, at this time in s.
        1 Active(f64),
        /// A supervisor's reset.
        2 Reset(()),
    }
}
plain! {
    /// What happens to a buffer.
    struct Trace {
        /// In this order.
        steps: Vec<Step>,
    }
}

/// The most steps of a trace that are judged: each may bring a horizon.
const MOST: usize = 64;
/// The most steps of a horizon.
const LONGEST: u8 = 16;

/// The plant does at any time what a small model of the text says, command by command and tick by tick.
///
/// It would find a deadline that a stale command refreshes, a clock that runs back and revives one, an
/// ESTOP that a damaged frame hides, and a horizon that is replayed past its end or its ttl.
// [NCP-RES-001] [NCP-RES-002] [NCP-RES-003] [NCP-RES-004] [NCP-RES-005] [NCP-RES-006] [NCP-RES-007]
// [NCP-RES-008] [NCP-RES-009] [NCP-RES-010] [NCP-RES-020] [NCP-RES-021] [NCP-RES-022] [NCP-RES-023]
// [NCP-RES-024] [NCP-RES-025] [NCP-RES-026] [NCP-RES-027] [NCP-RES-028] [NCP-RES-029] [NCP-RES-030]
// [NCP-RES-031] [NCP-RES-032] [NCP-SAFE-001]
pub fn action_buffer_trace(input: &[u8]) {
    let trace = read::<Trace>(input);
    let mut buffer = ActionBuffer::new();
    let mut model = Model::default();
    for (number, step) in trace.steps.iter().take(MOST).enumerate() {
        match step {
            Step::Reset(()) => {
                buffer.reset();
                model = Model::default();
            }
            Step::Active(now_s) => {
                let active = buffer.active(*now_s).map(marks);
                assert_eq!(active, model.active(*now_s), "at {now_s} s");
            }
            Step::Command(arrival) => {
                let command = arrival.build(number);
                let frame = arrival.damage.and_then(|damage| Some((damage, command.encode().ok()?)));
                match frame {
                    None => {
                        buffer.on_command(command, arrival.now_s);
                        model.on_command(arrival, number);
                    }
                    Some((Damage("nothing"), text)) => {
                        assert!(buffer.on_frame(text.as_bytes(), arrival.now_s).is_ok());
                        model.on_command(arrival, number);
                    }
                    Some((damage, text)) => {
                        let stops = mode(arrival.mode) == Mode::Estop;
                        let read = buffer.on_frame(damage.apply(&text).as_bytes(), arrival.now_s);
                        assert_eq!(read.is_ok(), stops, "a damaged frame is read");
                        model.stopped |= stops;
                    }
                }
            }
        }
        assert_eq!(buffer.is_stopped(), model.stopped);
    }
}

/// The rules of the text, with numbers for setpoints.
#[derive(Default)]
struct Model {
    stopped: bool,
    last_seq: Option<i64>,
    /// The command that the plant may act upon, and its number.
    current: Option<(Arrival, usize)>,
}

impl Model {
    fn on_command(&mut self, arrival: &Arrival, number: usize) {
        let seq = arrival.seq;
        let advances = self.last_seq.is_none_or(|last| seq > last);
        match mode(arrival.mode) {
            Mode::Estop => self.stopped = true,
            Mode::Active if advances => {
                self.last_seq = Some(seq);
                self.current = Some((arrival.clone(), number));
            }
            Mode::Active => {}
            Mode::Hold | Mode::Init => {
                if advances || seq == 0 || self.last_seq == Some(seq) {
                    self.current = None;
                }
                if advances && seq != 0 {
                    self.last_seq = Some(seq);
                }
            }
        }
    }

    /// The number of the command and its tick, unless the plant holds; a hold persists.
    fn active(&mut self, now_s: f64) -> Option<Marks> {
        let (command, number) = self.current.as_ref()?;
        let age_ms = (now_s - command.now_s) * 1000.0;
        let in_time = command.ttl_ms > 0.0
            && command.ttl_ms.is_finite()
            && now_s.is_finite()
            && command.now_s <= now_s
            && age_ms <= command.ttl_ms.min(60_000.0);
        let steps = f64::from(command.length());
        let tick = match command.dt_ms {
            Some(dt) if steps > 0.0 && dt.is_finite() && dt > 0.0 => (age_ms / dt).floor(),
            _ => 0.0,
        };
        let answer = (*number as f64, tick);
        if self.stopped {
            // Nothing but a reset leads back, and it forgets the command.
            None
        } else if !in_time || tick > steps {
            self.current = None;
            None
        } else {
            Some(answer)
        }
    }
}

/// The number of a command and a tick of it.
type Marks = (f64, f64);

impl Arrival {
    /// How many steps its horizon has.
    fn length(&self) -> u8 {
        self.steps % (LONGEST + 1)
    }

    fn build(&self, number: usize) -> CommandFrame {
        let tick = |tick: u8| {
            let marks = ChannelValue::without_unit([number as f64, f64::from(tick)]);
            ChannelMap::from_iter([("arm", marks)])
        };
        CommandFrame {
            seq: self.seq,
            mode: mode(self.mode),
            ttl_ms: self.ttl_ms,
            channels: tick(0),
            horizon: (0..self.length()).map(|step| tick(step.saturating_add(1))).collect(),
            horizon_dt_ms: self.dt_ms,
            ..CommandFrame::default()
        }
    }
}

impl Damage {
    /// A frame that no decoder may read, and that says `estop` as before.
    fn apply(self, text: &str) -> String {
        match self.0 {
            "mode twice" => text.replacen('{', r#"{"mode":"active","#, 1),
            "no number" => text.replacen(r#""t":0.0"#, r#""t":nought"#, 1),
            _ => text.replacen(r#","channels":"#, r#","channels"#, 1),
        }
    }
}

fn marks(channels: &ChannelMap) -> Marks {
    let data = &channels.get("arm").expect("the channel of every command").data;
    (data[0], data[1])
}
