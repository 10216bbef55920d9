//! A whole adapter to copy: an implementation that has a version guard and a watchdog, and nothing else.
//!
//! `ncp-verify run --peer-cmd target/debug/examples/small` judges these calls; all others come back as unsupported.

use std::process::ExitCode;

use ncp_adapter::reply::{Description, StepReply};
use ncp_adapter::steps::{Stamp, WatchdogStep, run};
use ncp_adapter::{CallError, Peer, args};

/// The implementation under test. Yours is a crate of its own: put its calls below in the place of these.
mod flight_stack {
    pub(crate) use ncp_text::{CONTRACT_HASH, WIRE_VERSION};

    /// Not a version.
    pub(crate) struct Malformed;

    pub(crate) fn is_compatible(version: &str) -> Result<bool, Malformed> {
        Ok(numbers(version)? == numbers(WIRE_VERSION)?)
    }

    /// Major and minor, without leading zeros.
    fn numbers(version: &str) -> Result<(&str, &str), Malformed> {
        let is_number = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
        let (major, minor) = version.split_once('.').unwrap_or((version, "0"));
        if is_number(major) && is_number(minor) {
            Ok((major.trim_start_matches('0'), minor.trim_start_matches('0')))
        } else {
            Err(Malformed)
        }
    }

    #[derive(Default)]
    pub(crate) struct Watchdog {
        last_seq: Option<i64>,
        received_s: f64,
        ttl_ms: Option<f64>,
    }

    impl Watchdog {
        pub(crate) fn on_command(&mut self, now_s: f64, ttl_ms: f64, seq: i64) {
            if self.last_seq.is_none_or(|last| seq > last) {
                let usable = now_s.is_finite() && ttl_ms.is_finite() && ttl_ms > 0.0;
                self.ttl_ms = usable.then(|| ttl_ms.min(60_000.0));
                (self.last_seq, self.received_s) = (Some(seq), now_s);
            }
        }

        pub(crate) fn should_hold(&mut self, now_s: f64) -> bool {
            let age_s = now_s - self.received_s;
            self.ttl_ms = self.ttl_ms.filter(|ttl_ms| age_s >= 0.0 && age_s * 1000.0 <= *ttl_ms);
            self.ttl_ms.is_none()
        }
    }
}

struct FlightStack;

impl Peer for FlightStack {
    type Error = CallError;

    fn describe(&self) -> Result<Description<'_>, CallError> {
        Ok(Description {
            name: "flight-stack".into(),
            version: "3.1.0".into(),
            language: "Rust".into(),
            wire_version: flight_stack::WIRE_VERSION.into(),
            contract_hash: flight_stack::CONTRACT_HASH.into(),
            roles: vec!["body".into()],
            reference_networks: false,
        })
    }

    fn version_check(&self, args: &args::VersionCheck<'_>) -> Result<bool, CallError> {
        match flight_stack::is_compatible(&args.version) {
            Ok(false) if args.strict => Err(CallError::refused("version", "not compatible")),
            Ok(compatible) => Ok(compatible),
            Err(flight_stack::Malformed) => Err(CallError::refused("version", "not a version")),
        }
    }

    fn contract_status(&self, args: &args::Contract<'_>) -> Result<&'static str, CallError> {
        Ok(match args.peer_hash.as_deref() {
            None => "not_advertised",
            Some(flight_stack::CONTRACT_HASH) => "match",
            Some(_) => "mismatch",
        })
    }

    fn watchdog_run(&self, args: &args::Watchdog<'_>) -> Result<Vec<StepReply>, CallError> {
        let mut watchdog = flight_stack::Watchdog::default();
        run(&args.steps, |step| {
            match step {
                WatchdogStep::Command(Stamp { now_s, ttl_ms, seq }) => watchdog.on_command(now_s.0, ttl_ms.0, seq),
                WatchdogStep::ShouldHold(now) => {
                    return Ok(StepReply::Hold { hold: watchdog.should_hold(now.seconds()) });
                }
                // It has no `reset`: whoever uses it makes a new one, and that is its reset.
                WatchdogStep::Reset => watchdog = flight_stack::Watchdog::default(),
            }
            Ok::<_, CallError>(StepReply::Nothing {})
        })
    }
}

fn main() -> ExitCode {
    if ncp_adapter::serve(&FlightStack).is_ok() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
