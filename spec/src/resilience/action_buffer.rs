//! The action buffer: the newest command, and what of it a plant does now.

use crate::wire::{ChannelMap, CommandFrame, DecodeError, Frame, Mode};
use ncp_kernel::{Plant, Received, advances};

/// Keeps the newest command and replays its horizon. All times are seconds on the plant's own clock.
#[derive(Debug, Clone, Default)]
pub struct ActionBuffer {
    command: CommandFrame,
    plant: Plant<f64, i64>,
    is_strict: bool,
}

impl ActionBuffer {
    /// An empty buffer. `[NCP-RES-006]`
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// An empty buffer that keeps the strict profile (chapter 12.1): every command has a version and
    /// a stamp, and advances, a HOLD too. `[NCP-STRICT-004] [NCP-STRICT-005]`
    #[must_use]
    pub fn strict() -> Self {
        Self { is_strict: true, ..Self::default() }
    }

    /// Takes a frame from the wire, received at `now_s`. One that is rejected changes nothing, an
    /// ESTOP aside. `[NCP-STRICT-011]`
    ///
    /// # Errors
    /// The frame cannot be decoded. If it is an ESTOP for all that, it latches.
    pub fn on_frame(&mut self, frame: &[u8], now_s: f64) -> Result<Received, DecodeError> {
        let decoded = if self.is_strict { CommandFrame::decode_strict(frame) } else { CommandFrame::decode(frame) };
        match decoded {
            Ok(command) => Ok(self.on_command(command, now_s)),
            // [NCP-RES-022] [NCP-STRICT-010]
            Err(_) if is_estop(frame) => {
                self.plant.stop();
                Ok(Received::Stopped)
            }
            Err(error) => Err(error),
        }
    }

    /// Takes a command received at `now_s`. `[NCP-RES-020] [NCP-RES-021] [NCP-RES-023]`
    pub fn on_command(&mut self, command: CommandFrame, now_s: f64) -> Received {
        // [NCP-STRICT-004] [NCP-STRICT-005] The stamp of a decoded command is that of its frame.
        if self.is_strict && command.mode != Mode::Estop {
            let last = self.plant.watchdog().last_seq();
            if command.seq < 1 || !advances(last, command.seq) {
                return Received::Dropped;
            }
        }
        let received = self.plant.on_command(command.mode, now_s, command.ttl_ms, command.seq);
        if received == Received::Accepted {
            self.command = command;
        }
        received
    }

    /// The channels that the plant actuates at `now_s`, or none when it holds. `[NCP-RES-025]`
    pub fn active(&mut self, now_s: f64) -> Option<&ChannelMap> {
        let CommandFrame { channels, horizon, horizon_dt_ms, .. } = &self.command;
        let tick = self.plant.active(now_s, *horizon_dt_ms, horizon.len())?;
        // [NCP-RES-028]
        match tick.checked_sub(1) {
            None => Some(channels),
            Some(step) => horizon.get(step),
        }
    }

    /// Clears the latch, the held command and the last seq, by a supervisor's decision: nothing moves
    /// until a new command comes. `[NCP-RES-030] [NCP-RES-031] [NCP-RES-032]`
    pub fn reset(&mut self) {
        self.plant.reset();
    }

    /// Whether ESTOP is latched. `[NCP-RES-021]`
    #[must_use]
    pub const fn is_stopped(&self) -> bool {
        self.plant.is_stopped()
    }
}

/// Whether a frame, however malformed, is an ESTOP: an object with a member `kind` of value
/// `command_frame` and a member `mode` of value `estop`. `[NCP-RES-022]`
///
/// It reads as far as it can make sense of the bytes and no further: a member that is broken ends
/// the search, since what follows it cannot be told from its value.
#[must_use]
pub fn is_estop(frame: &[u8]) -> bool {
    let mut scan = Scan { bytes: frame, at: 0 };
    let (mut is_command, mut is_stop) = (false, false);
    scan.space();
    if !scan.eat(b'{') {
        return false;
    }
    loop {
        scan.space();
        let Some(name) = scan.string() else { break };
        scan.space();
        if !scan.eat(b':') {
            break;
        }
        scan.space();
        if scan.peek() == Some(b'"') {
            let Some(value) = scan.string() else { break };
            is_command |= name == "kind" && value == "command_frame";
            is_stop |= name == "mode" && value == "estop";
        } else if !scan.skip() {
            break;
        }
        scan.space();
        if !scan.eat(b',') {
            break;
        }
    }
    is_command && is_stop
}

/// A lenient walk over the members of an object: any depth, any number, any bytes in strings.
struct Scan<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl Scan<'_> {
    fn peek(&self) -> Option<u8> {
        self.bytes.get(self.at).copied()
    }

    fn eat(&mut self, byte: u8) -> bool {
        let found = self.peek() == Some(byte);
        self.at += usize::from(found);
        found
    }

    fn space(&mut self) {
        while matches!(self.peek(), Some(b' ' | b'\t' | b'\n' | b'\r')) {
            self.at += 1;
        }
    }

    /// A string with its escapes resolved; bytes that are not UTF-8 are replaced.
    fn string(&mut self) -> Option<String> {
        let start = self.at + 1;
        self.past_string()?;
        let inner = self.bytes.get(start..self.at - 1)?;
        let text = String::from_utf8_lossy(inner);
        if !text.contains('\\') {
            return Some(text.into_owned());
        }
        let mut plain = String::with_capacity(text.len());
        let mut rest = text.chars();
        while let Some(c) = rest.next() {
            if c != '\\' {
                plain.push(c);
                continue;
            }
            match rest.next() {
                Some('u') => {
                    let digits: String = rest.by_ref().take(4).collect();
                    let unit = u32::from_str_radix(&digits, 16).ok().and_then(char::from_u32);
                    plain.push(unit.unwrap_or(char::REPLACEMENT_CHARACTER));
                }
                // No other escape stands for a letter of the words that are looked for.
                Some(other) => plain.push(if other == '/' { '/' } else { '\u{0}' }),
                None => {}
            }
        }
        Some(plain)
    }

    fn past_string(&mut self) -> Option<()> {
        if !self.eat(b'"') {
            return None;
        }
        loop {
            match self.peek()? {
                b'"' => {
                    self.at += 1;
                    return Some(());
                }
                b'\\' => self.at += 2,
                _ => self.at += 1,
            }
        }
    }

    /// Walks past a value that is not a string; false when it has no end.
    fn skip(&mut self) -> bool {
        let mut level = 0_usize;
        loop {
            match self.peek() {
                None => return false,
                Some(b'"') => {
                    if self.past_string().is_none() {
                        return false;
                    }
                }
                Some(b'{' | b'[') => {
                    level += 1;
                    self.at += 1;
                }
                Some(b'}' | b']') if level > 0 => {
                    level -= 1;
                    self.at += 1;
                }
                Some(b',' | b'}' | b']') if level == 0 => return true,
                Some(_) => self.at += 1,
            }
        }
    }
}
