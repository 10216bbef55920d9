//! A run while it goes on: a bar on stderr, if that is a terminal.

use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::run::{Event, Listener};

/// Shows a run while it goes on, and says its faults at once.
#[derive(Debug)]
pub struct Progress {
    bar: ProgressBar,
    wrong: AtomicU64,
    faults: AtomicU64,
}

/// How many faults are said one by one.
const FAULTS_SAID: u64 = 5;

impl Progress {
    /// A bar for `total` answers of a peer. Without `visible` nothing is shown.
    #[must_use]
    pub fn new(peer: &str, total: u64, visible: bool) -> Self {
        let target = if visible { ProgressDrawTarget::stderr_with_hz(10) } else { ProgressDrawTarget::hidden() };
        let bar = ProgressBar::with_draw_target(Some(total), target);
        if let Ok(style) = ProgressStyle::with_template("{prefix} {bar:24} {pos}/{len} {elapsed} {msg}") {
            bar.set_style(style);
        }
        bar.set_prefix(peer.to_owned());
        Self { bar, wrong: AtomicU64::new(0), faults: AtomicU64::new(0) }
    }

    /// A line that says what is being done, until [`done`](Self::done).
    #[must_use]
    pub fn spinner(text: String, visible: bool) -> Self {
        let bar = if visible { ProgressBar::new_spinner() } else { ProgressBar::hidden() };
        if visible {
            if let Ok(style) = ProgressStyle::with_template("{spinner} {msg} {elapsed}") {
                bar.set_style(style);
            }
            bar.set_message(text);
            bar.enable_steady_tick(Duration::from_millis(100));
        } else {
            eprintln!("{text}");
        }
        Self { bar, wrong: AtomicU64::new(0), faults: AtomicU64::new(0) }
    }

    /// Says a line, beside what is shown.
    pub fn say(&self, line: &str) {
        if self.bar.is_hidden() {
            eprintln!("{line}");
        } else {
            self.bar.println(line);
        }
    }

    /// Takes the bar away.
    pub fn done(&self) {
        self.bar.finish_and_clear();
    }
}

impl Listener for Progress {
    fn on(&self, event: Event<'_>) {
        match event {
            Event::Judged { answers, wrong } => {
                self.bar.inc(answers);
                if wrong > 0 {
                    let wrong = self.wrong.fetch_add(wrong, Ordering::Relaxed) + wrong;
                    self.bar.set_message(format!("{wrong} not right"));
                }
            }
            Event::Fault { case, what } => match self.faults.fetch_add(1, Ordering::Relaxed) {
                said if said < FAULTS_SAID => self.say(&format!("{case}: it {what}")),
                FAULTS_SAID => self.say("further faults are in the report"),
                _ => {}
            },
            Event::Recorded { .. } | Event::Opened => {}
            Event::GivenUp { why } => self.say(&format!("given up: {why}")),
        }
    }
}
