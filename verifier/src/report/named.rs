//! Values that a result writes by their names.

use ncp_text::catalogue::{Keyword, Level, Role};

use crate::check::Manner;
use crate::peer::Call;
use crate::run::OutcomeKind;
use crate::verdict::{Conclusion, Status};

/// What is written by its name.
pub(super) trait Named: Copy + 'static {
    /// All that there are.
    const ALL: &'static [Self];

    fn name(self) -> &'static str;

    /// Reads a name.
    fn named(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|value| value.name() == name)
    }
}

macro_rules! named {
    ($($type:ty: $all:expr),+ $(,)?) => {$(
        impl Named for $type {
            const ALL: &'static [Self] = &$all;

            fn name(self) -> &'static str {
                self.as_str()
            }
        }
    )+};
}

named! {
    Conclusion: [Self::Conformant, Self::AsExpected, Self::NotConformant],
    Keyword: Keyword::ALL,
    Level: Level::ALL,
    OutcomeKind: [
        Self::NotRun, Self::Pass, Self::Unsupported, Self::Fail, Self::Protocol, Self::Timeout, Self::Crash
    ],
    Role: Role::ALL,
    Status: [
        Self::Passed, Self::Failed, Self::Advice, Self::ExpectedFailure, Self::UnexpectedPass, Self::NotRun
    ],
}

impl Named for Call {
    const ALL: &'static [Self] = Self::ALL;

    fn name(self) -> &'static str {
        self.as_str()
    }
}

impl Named for Manner {
    const ALL: &'static [Self] = &[Self::Value, Self::Refusal, Self::Order, Self::Crash];

    fn name(self) -> &'static str {
        match self {
            Self::Value => "value",
            Self::Refusal => "refusal",
            Self::Order => "order",
            Self::Crash => "crash",
        }
    }
}

fn read<E: serde::de::Error, T: Named>(name: &str) -> Result<T, E> {
    T::named(name).ok_or_else(|| {
        let known: Vec<&str> = T::ALL.iter().map(|value| value.name()).collect();
        E::custom(format!("{name:?} is none of {}", known.join(", ")))
    })
}

/// One of them.
pub(super) mod by_name {
    use std::borrow::Cow;

    use serde::{Deserialize as _, Deserializer, Serializer};

    use super::{Named, read};

    pub(in crate::report) fn serialize<S: Serializer>(value: &impl Named, to: S) -> Result<S::Ok, S::Error> {
        to.serialize_str(value.name())
    }

    pub(in crate::report) fn deserialize<'de, D: Deserializer<'de>, T: Named>(from: D) -> Result<T, D::Error> {
        read(&Cow::<str>::deserialize(from)?)
    }
}

/// Any number of them.
pub(super) mod by_names {
    use std::borrow::Cow;

    use serde::{Deserialize as _, Deserializer, Serializer};

    use super::{Named, read};

    pub(in crate::report) fn serialize<S: Serializer>(values: &[impl Named], to: S) -> Result<S::Ok, S::Error> {
        to.collect_seq(values.iter().map(|value| value.name()))
    }

    pub(in crate::report) fn deserialize<'de, D: Deserializer<'de>, T: Named>(from: D) -> Result<Vec<T>, D::Error> {
        Vec::<Cow<'_, str>>::deserialize(from)?.iter().map(|name| read(name)).collect()
    }
}

/// One of them, or none.
pub(super) mod by_name_or_null {
    use std::borrow::Cow;

    use serde::{Deserialize as _, Deserializer, Serialize as _, Serializer};

    use super::{Named, read};

    #[expect(clippy::ref_option, reason = "serde passes a reference")]
    pub(in crate::report) fn serialize<S: Serializer>(value: &Option<impl Named>, to: S) -> Result<S::Ok, S::Error> {
        value.map(Named::name).serialize(to)
    }

    pub(in crate::report) fn deserialize<'de, D: Deserializer<'de>, T: Named>(from: D) -> Result<Option<T>, D::Error> {
        Option::<Cow<'_, str>>::deserialize(from)?.map(|name| read(&name)).transpose()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_name_is_read_as_what_it_was_written_for() {
        fn all<T: Named + PartialEq + std::fmt::Debug>(count: usize) {
            assert_eq!(T::ALL.len(), count);
            for value in T::ALL {
                assert_eq!(T::named(value.name()), Some(*value));
            }
            assert_eq!(T::named("no such name"), None);
        }
        all::<Conclusion>(3);
        all::<Keyword>(5);
        all::<Level>(3);
        all::<OutcomeKind>(7);
        all::<Role>(4);
        all::<Status>(6);
        all::<Manner>(4);
        all::<Call>(Call::ALL.len());
    }
}
