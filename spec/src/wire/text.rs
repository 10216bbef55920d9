//! Strings of messages.

use std::borrow::Cow;

use ncp_text::WIRE_VERSION;

/// A string of a message. One that the protocol itself names, such as `world` or `m/s`, is borrowed
/// from the program and costs no allocation when it is read.
pub type Text = Cow<'static, str>;

/// A [`Text`] of what was read.
#[inline]
pub(crate) fn keep(read: Cow<'_, str>) -> Text {
    match well_known(&read) {
        Some(known) => Text::Borrowed(known),
        None => Text::Owned(read.into_owned()),
    }
}

macro_rules! well_known {
    ($($known:literal)*) => {
        #[inline]
        fn well_known(read: &str) -> Option<&'static str> {
            match read {
                $($known => Some($known),)*
                WIRE_VERSION => Some(WIRE_VERSION),
                _ => None,
            }
        }
    };
}

well_known! {
    "" "world" "mock"
    "m" "m/s" "m/s^2" "s" "ms" "rad" "rad/s" "Hz" "mV" "pA" "nS" "1"
    "pose_position" "pose_velocity" "pose_error" "velocity_setpoint"
    "stimulus" "record"
}
