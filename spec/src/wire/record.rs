//! One declaration of a message makes its struct, its defaults, its decoder, its encoder and its
//! table, so that none of them can drift from the others.

/// Declares a message.
///
/// ```text
/// record! {
///     /// Documentation.
///     frame Name of Kind "kind" {
///         /// Documentation.
///         [required] field "wire name, if it is another": Type = what a program gets, absent what a receiver reads;
///     }
/// }
/// ```
///
/// A `frame` has `ncp_version` and `kind` before its fields, a `message` has neither.
macro_rules! record {
    ($(#[$meta:meta])* frame $name:ident of $kind:ident $wire_kind:literal { $($fields:tt)* }) => {
        record! { @all $(#[$meta])* $name [$kind $wire_kind] {
            /// The wire version of the sender. Decoding does not judge it: see
            /// [`check_version`](crate::version::check_version).
            ncp_version: Text = Text::Borrowed(WIRE_VERSION); // [NCP-WIRE-032] [NCP-WIRE-033]
            $($fields)*
        } }

        impl Frame for $name {
            const KIND: Kind = Kind::$kind;

            fn decode(frame: &[u8]) -> Result<Self, DecodeError> {
                Self::receive(frame, Purpose::Receive)
            }

            fn decode_strict(frame: &[u8]) -> Result<Self, DecodeError> {
                let message = Self::receive(frame, Purpose::ReceiveStrict)?;
                message.check_strict()?;
                Ok(message)
            }

            // [NCP-WIRE-093]
            fn encode(&self) -> Result<String, EncodeError> {
                self.check()?; // [NCP-WIRE-091]
                let mut w = Writer::new();
                self.write_members(&mut w)?;
                w.finish(Self::KIND)
            }
        }

        impl $name {
            fn receive(frame: &[u8], purpose: Purpose) -> Result<Self, DecodeError> {
                Self::KIND.check_len(frame.len())?;
                let mut r = Reader::new(frame, purpose)?;
                r.begin()?;
                let mut message = Self::read_members(&mut r)?;
                r.end()?;
                message.inherit(r.left_out);
                message.check()?;
                Ok(message)
            }

            /// What the strict profile asks of a frame beyond its version being there.
            fn check_strict(&self) -> Result<(), Breach> {
                // [NCP-STRICT-003] [NCP-STRICT-012]
                if !check_version(&self.ncp_version, false).unwrap_or(false) {
                    return Err(Breach { field: "ncp_version", rule: Rule::Version });
                }
                self.check_stamp()
            }
        }

        impl Fields for $name {
            fn build(fields: &[u8]) -> Result<Self, DecodeError> {
                let mut r = Reader::new(fields, Purpose::Build)?;
                r.begin()?;
                let message = Self::read_members(&mut r)?;
                r.end()?;
                Ok(message)
            }

            fn show(&self, w: &mut Writer) -> Result<(), EncodeError> {
                self.write_members(w)
            }
        }
    };

    ($(#[$meta:meta])* message $name:ident { $($fields:tt)* }) => {
        record! { @all $(#[$meta])* $name [] { $($fields)* } }

        impl Value for $name {
            const JSON: JsonType = JsonType::Object(stringify!($name));

            fn read(r: &mut Reader<'_>) -> Result<Self, DecodeError> {
                Self::read_members(r)
            }

            fn write(&self, w: &mut Writer) -> Result<(), EncodeError> {
                self.write_members(w)
            }
        }

        impl Item for $name {}
    };

    // The first field stands apart: it opens the object, and `kind` comes after it.
    (@all $(#[$meta:meta])* $name:ident [$($kind:ident $wire_kind:literal)?] {
        $(#[$first_meta:meta])* $([$first_flag:ident])? $first:ident $($first_wire:literal)?
            : $first_type:ty = $first_built:expr $(, absent $first_absent:expr)?;
        $($(#[$field_meta:meta])* $([$flag:ident])? $field:ident $($wire:literal)?
            : $type:ty = $built:expr $(, absent $absent:expr)?;)*
    }) => {
        $(#[$meta])*
        #[derive(Debug, Clone, PartialEq)]
        pub struct $name {
            $(#[$first_meta])*
            pub $first: $first_type,
            $($(#[$field_meta])* pub $field: $type,)*
        }

        impl Default for $name {
            /// What a program gets that names no field.
            fn default() -> Self {
                // [NCP-WIRE-088] [NCP-WIRE-089] [NCP-WIRE-090]
                Self { $first: $first_built, $($field: $built,)* }
            }
        }

        impl $name {
            /// The message's table.
            pub const TABLE: Table = Table {
                message: stringify!($name),
                kind: record!(@kind $($kind)?),
                fields: &[
                    Field {
                        name: record!(@name $first $($first_wire)?),
                        json: <$first_type as Value>::JSON,
                        required: record!(@required $($first_flag)?),
                    },
                    $(Field { name: record!(@kind_name $kind), json: JsonType::String, required: true },)?
                    $(Field {
                        name: record!(@name $field $($wire)?),
                        json: <$type as Value>::JSON,
                        required: record!(@required $($flag)?),
                    },)*
                ],
            };

            /// Reads the object that the reader stands at.
            ///
            /// Members in their usual order are taken one after the other; whatever comes
            /// otherwise is looked up by its name.
            fn read_members(r: &mut Reader<'_>) -> Result<Self, DecodeError> {
                let mut $first: Option<$first_type> = None;
                $(let mut has_kind = record!(@no $kind);)?
                $(let mut $field: Option<$type> = None;)*

                let mark = r.mark();
                let mut more = r.open_object(JsonType::Object(stringify!($name)))?;
                if more && r.eat_name(record!(@quoted $first $($first_wire)?)) {
                    r.fill(&mut $first, record!(@name $first $($first_wire)?))?;
                    more = r.next_member()?;
                }
                $(if more && r.eat_name("\"kind\":") {
                    r.fill_kind(&mut has_kind, Kind::$kind)?;
                    more = r.next_member()?;
                })?
                $(if more && r.eat_name(record!(@quoted $field $($wire)?)) {
                    r.fill(&mut $field, record!(@name $field $($wire)?))?;
                    more = r.next_member()?;
                })*
                while more {
                    let name_at = r.at();
                    let name = r.name()?;
                    if name == record!(@name $first $($first_wire)?) {
                        r.fill(&mut $first, record!(@name $first $($first_wire)?))?;
                    }
                    $(else if name == "kind" { r.fill_kind(&mut has_kind, Kind::$kind)?; })?
                    $(else if name == record!(@name $field $($wire)?) {
                        r.fill(&mut $field, record!(@name $field $($wire)?))?;
                    })*
                    else {
                        r.ignore(&name, name_at)?;
                    }
                    more = r.next_member()?;
                }
                r.no_repeats(mark)?;

                $(record!(@settle $kind r has_kind $first);)?
                // [NCP-WIRE-023] [NCP-WIRE-024] [NCP-WIRE-025] [NCP-PROV-005]
                Ok(Self {
                    $first: match $first {
                        Some(value) => value,
                        None => record!(@absent r $([$first_flag])? $first, $first_built $(, $first_absent)?),
                    },
                    $($field: match $field {
                        Some(value) => value,
                        None => record!(@absent r $([$flag])? $field, $built $(, $absent)?),
                    },)*
                })
            }

            /// Writes all fields in order. `// [NCP-WIRE-080] [NCP-WIRE-081]`
            fn write_members(&self, w: &mut Writer) -> Result<(), EncodeError> {
                w.literal(concat!("{", record!(@quoted $first $($first_wire)?)));
                self.$first.write(w).map_err(|e| e.inside(record!(@name $first $($first_wire)?)))?;
                $(w.literal(concat!(",\"kind\":\"", $wire_kind, "\""));)?
                $(
                    w.literal(concat!(",", record!(@quoted $field $($wire)?)));
                    self.$field.write(w).map_err(|e| e.inside(record!(@name $field $($wire)?)))?;
                )*
                w.literal("}");
                Ok(())
            }
        }
    };

    (@kind) => { None };
    (@kind $kind:ident) => { Some(Kind::$kind) };
    (@kind_name $kind:ident) => { "kind" };
    (@no $kind:ident) => { false };
    (@settle $kind:ident $r:ident $has_kind:ident $version:ident) => {
        $r.settle_header($has_kind, $version.is_some())?
    };
    (@name $field:ident) => { stringify!($field) };
    (@name $field:ident $wire:literal) => { $wire };
    (@quoted $field:ident) => { concat!("\"", stringify!($field), "\":") };
    (@quoted $field:ident $wire:literal) => { concat!("\"", $wire, "\":") };
    (@required) => { false };
    (@required required) => { true };
    (@absent $r:ident [required] $field:ident, $built:expr) => {{
        $r.lacks(stringify!($field))?;
        $built
    }};
    (@absent $r:ident $field:ident, $built:expr) => { $built };
    (@absent $r:ident $field:ident, $built:expr, $absent:expr) => {
        if $r.is_building() { $built } else { $absent }
    };
}

pub(super) use record;
