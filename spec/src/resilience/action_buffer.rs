//! The action buffer: the newest command, and what of it a plant does now.

use super::CommandWatchdog;
use crate::safety::kernel;
use crate::wire::{ChannelMap, CommandFrame, DecodeError, Frame, Mode};

/// Keeps the newest command and replays its horizon. All times are seconds on the plant's own clock.
#[derive(Debug, Clone, Default)]
pub struct ActionBuffer {
    command: CommandFrame,
    watchdog: CommandWatchdog,
    estop: bool,
    is_strict: bool,
}

/// What became of a command.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Received {
    /// It is the one that the plant follows now.
    Accepted,
    /// The plant holds.
    Held,
    /// ESTOP is latched.
    Stopped,
    /// It is stale, a duplicate or reordered, and changes nothing.
    Dropped,
}

impl ActionBuffer {
    /// An empty buffer.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// An empty buffer that keeps the strict profile (chapter 12.1): every command has a version and
    /// a stamp, and advances, a HOLD too.
    #[must_use]
    pub fn strict() -> Self {
        Self {
            is_strict: true,
            ..Self::default()
        }
    }

    /// Takes a frame from the wire, received at `now_s`. One that is rejected changes nothing, an
    /// ESTOP aside. `[NCP-STRICT-011]`
    ///
    /// # Errors
    /// The frame cannot be decoded. If it is an ESTOP for all that, it latches.
    pub fn on_frame(&mut self, frame: &[u8], now_s: f64) -> Result<Received, DecodeError> {
        let decoded = if self.is_strict {
            CommandFrame::decode_strict(frame)
        } else {
            CommandFrame::decode(frame)
        };
        match decoded {
            Ok(command) => Ok(self.on_command(command, now_s)),
            // [NCP-RES-022] [NCP-STRICT-010]
            Err(_) if is_estop(frame) => {
                self.estop = true;
                Ok(Received::Stopped)
            }
            Err(error) => Err(error),
        }
    }

    /// Takes a command received at `now_s`.
    pub fn on_command(&mut self, command: CommandFrame, now_s: f64) -> Received {
        match command.mode {
            // [NCP-RES-021]
            Mode::Estop => {
                self.estop = true;
                Received::Stopped
            }
            // [NCP-STRICT-004] [NCP-STRICT-005] The stamp of a decoded command is that of its frame.
            _ if self.is_strict && (command.seq < 1 || !self.watchdog.advances(command.seq)) => {
                Received::Dropped
            }
            // [NCP-RES-020] [NCP-RES-009]
            Mode::Active => {
                if !self.watchdog.on_command(now_s, command.ttl_ms, command.seq) {
                    return Received::Dropped;
                }
                self.command = command;
                if self.estop {
                    Received::Stopped
                } else {
                    Received::Accepted
                }
            }
            // [NCP-SAFE-001] [NCP-RES-023] [NCP-RES-024]
            Mode::Init | Mode::Hold => {
                if self.watchdog.on_hold(command.seq) {
                    Received::Held
                } else {
                    Received::Dropped
                }
            }
        }
    }

    /// The channels that the plant actuates at `now_s`, or none when it holds. `[NCP-RES-025]`
    pub fn active(&mut self, now_s: f64) -> Option<&ChannelMap> {
        if self.watchdog.should_hold(now_s) || self.estop {
            return None;
        }
        let received_s = self.watchdog.received_s()?;
        // [NCP-RES-026] [NCP-RES-027]
        let dt_ms = self
            .command
            .horizon_dt_ms
            .filter(|&dt_ms| kernel::is_duration(dt_ms));
        let Some(dt_ms) = dt_ms.filter(|_| !self.command.horizon.is_empty()) else {
            return Some(&self.command.channels);
        };
        // [NCP-RES-028] A conversion from a float saturates.
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let tick = (kernel::age_ms(now_s, received_s) / dt_ms).floor() as usize;
        match tick.checked_sub(1) {
            None => Some(&self.command.channels),
            // [NCP-RES-029]
            Some(step) => {
                if step >= self.command.horizon.len() {
                    self.watchdog.hold();
                }
                self.command.horizon.get(step)
            }
        }
    }

    /// Clears the latch, the held command and the last seq, by a supervisor's decision: nothing moves
    /// until a new command comes. `[NCP-RES-030] [NCP-RES-031] [NCP-RES-032]`
    pub fn reset(&mut self) {
        self.watchdog.reset();
        self.estop = false;
    }

    /// Whether ESTOP is latched.
    #[must_use]
    pub const fn is_stopped(&self) -> bool {
        self.estop
    }
}

/// Whether a frame, however malformed, is an ESTOP: an object with a member `kind` of value
/// `command_frame` and a member `mode` of value `estop`. `[NCP-RES-022]`
///
/// It reads as far as it can make sense of the bytes and no further: a member that is broken ends
/// the search, since what follows it cannot be told from its value.
#[must_use]
pub fn is_estop(frame: &[u8]) -> bool {
    let mut scan = Scan {
        bytes: frame,
        at: 0,
    };
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
                    let unit = u32::from_str_radix(&digits, 16)
                        .ok()
                        .and_then(char::from_u32);
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
