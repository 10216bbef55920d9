//! What an event shows: signs that something went wrong, or that something was tried at all.
//!
//! A model keeps the signs of the last event in its state, as `last`, and numbers them itself; its claims say
//! that no event shows one of the wrong ones, and its witnesses that some event shows each of the others.

/// Some signs, a bit each.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub(crate) struct Signs(u16);

impl Signs {
    /// Notes a sign, if there is a reason to.
    pub(crate) const fn tell(&mut self, when: bool, sign: u16) {
        if when {
            self.0 |= sign;
        }
    }

    /// Whether the sign is among them.
    pub(crate) const fn has(self, sign: u16) -> bool {
        self.0 & sign != 0
    }
}

/// The claim that no event shows a sign.
macro_rules! always {
    ($name:literal, $sign:expr) => {
        stateright::Property::always($name, |_: &Self, state: &State| !state.last.has($sign))
    };
}

/// The witness that some event shows a sign.
macro_rules! sometimes {
    ($name:literal, $sign:expr) => {
        stateright::Property::sometimes($name, |_: &Self, state: &State| state.last.has($sign))
    };
}

pub(crate) use {always, sometimes};
