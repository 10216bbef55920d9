//! The properties of what reads blocks, versions and keys: what is claimed, in words and in symbols, and the
//! harness that says it.

pub mod bulk;
pub mod keys;
pub mod strings;
mod table;
pub mod version;

use ncp_proofs::provers::native::{Enumerate, Native, Replay, Sample};
use serde_json::{Value, json};

use crate::readers::{Production, Readers};
pub use table::PROPERTIES;

/// What a property is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// The decoder and the encoder of blocks.
    Bulk,
    /// The version guard.
    Version,
    /// The segments of keys.
    Keys,
}

impl Family {
    /// Its name in reports, which begins the names of its broken readers.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Bulk => "bulk",
            Self::Version => "version",
            Self::Keys => "keys",
        }
    }
}

/// A property of the readers.
#[derive(Debug, Clone, Copy)]
pub struct Property {
    /// Its name: family and subject.
    pub id: &'static str,
    /// What it is about.
    pub family: Family,
    /// The rules for which it is evidence.
    pub rules: &'static [&'static str],
    /// The claim in words.
    pub sentence: &'static str,
    /// The claim in symbols.
    pub statement: &'static str,
    /// The inputs for which it is claimed.
    pub bounds: &'static str,
    /// What is assumed.
    pub assumptions: &'static [&'static str],
    /// How often Kani unwinds a loop.
    pub unwind: u32,
    /// The longest strings, in bytes; the most columns; the last context: what the harness takes for its length.
    pub length: usize,
}

/// One harness on the readers of production, ready for each kind of prover.
#[derive(Debug, Clone, Copy)]
pub struct Harness {
    /// On samples.
    pub sample: fn(&mut Native<Sample>),
    /// On every combination of choices.
    pub enumerate: Enumerated,
    /// On given choices.
    pub replay: fn(&mut Native<Replay>),
}

/// A harness that draws every combination of choices.
pub type Enumerated = fn(&mut Native<Enumerate>);

/// The harnesses of a reader, by family and by the ids of their properties.
macro_rules! harnesses {
    ($($family:ident { $($id:literal => $harness:path,)* })*) => {
        /// The harness of a property on the readers of production.
        #[must_use]
        pub fn harness(id: &str) -> Option<Harness> {
            match id {
                $($($id => {
                    use $harness as body;
                    Some(Harness {
                        sample: body::<Production, Native<Sample>>,
                        enumerate: body::<Production, Native<Enumerate>>,
                        replay: body::<Production, Native<Replay>>,
                    })
                })*)*
                _ => None,
            }
        }

        /// The harnesses of each family for any reader.
        pub mod enumerated {
            use super::*;

            $(
                /// The harness of a property of this family.
                #[must_use]
                pub fn $family<R: Readers>(id: &str) -> Option<Enumerated> {
                    match id {
                        $($id => {
                            use $harness as body;
                            Some(body::<R, Native<Enumerate>>)
                        })*
                        _ => None,
                    }
                }
            )*
        }

        #[cfg(any(kani, test))]
        pub(crate) fn kani_harness(id: &str, p: &mut Native<ncp_proofs::kani_engine::Any>) {
            match id {
                $($($id => {
                    use $harness as body;
                    body::<Production, Native<ncp_proofs::kani_engine::Any>>(p);
                })*)*
                _ => {}
            }
        }
    };
}

harnesses! {
    bulk {
        "bulk/header" => crate::properties::bulk::header,
        "bulk/entry" => crate::properties::bulk::entry,
        "bulk/directories" => crate::properties::bulk::directories,
        "bulk/columns" => crate::properties::bulk::columns,
    }
    version {
        "version/bytes" => crate::properties::version::bytes,
        "version/scalars" => crate::properties::version::scalars,
        "version/classes" => crate::properties::version::classes,
    }
    keys {
        "keys/bytes" => crate::properties::keys::bytes,
        "keys/scalars" => crate::properties::keys::scalars,
        "keys/segment" => crate::properties::keys::segment,
        "keys/realm" => crate::properties::keys::realm,
        "keys/builders" => crate::properties::keys::builders,
    }
}

/// Whether the case that a property's inputs make shows that a check fails: it calls what the check is about.
#[must_use]
pub fn is_shown(property: &Property, check: &str) -> bool {
    match check {
        "answers alike within a class"
        | "what is encoded decodes to the same"
        | "what is encoded reads as the same by the text" => false,
        "a realm by the grammar" => property.id == "keys/realm",
        _ => true,
    }
}

/// The inputs of a harness, its choices in order, as a case of the corpus: what the text says of them.
#[must_use]
pub fn vector(property: &Property, name: &str, choices: &[usize]) -> Option<Value> {
    let mut p = Native::new(Replay {
        choices: choices.iter().copied().collect(),
        length: strings::LONGEST,
        ..Replay::default()
    });
    let case = match property.family {
        Family::Bulk => bulk::vector(property.id, &mut p),
        Family::Version => version::vector(property.id, &mut p),
        Family::Keys => keys::vector(property.id, &mut p),
    }?;
    let mut whole = json!({
        "id": format!("{}/proofs/{name}", property.family.as_str()),
        "title": format!("What refutes {name}."),
        "requirements": property.rules,
        "flags": [],
    });
    for (member, value) in case.as_object()? {
        whole[member] = value.clone();
    }
    whole["why"] = json!(property.sentence);
    Some(whole)
}
