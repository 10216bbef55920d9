//! What reads text and bytes of strangers, as a harness calls it: that of production, or a broken copy.

/// A column: its name, the code of its dtype, and its values as little-endian bytes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Column {
    /// The name.
    pub name: String,
    /// 1 to 4.
    pub dtype: u8,
    /// The values, one after the other.
    pub values: Vec<u8>,
}

/// The keys that can be built, in the order of the table of 3.2.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs, reason = "each is the key of its name")]
pub enum Key {
    Rpc,
    Sensor,
    Command,
    Observation,
    SensorGlob,
    CommandGlob,
    SessionGlob,
    FleetGlob,
}

/// Everything that the readers decide.
pub trait Readers {
    /// Whether a segment is accepted.
    fn segment(segment: &str) -> bool;
    /// Whether a realm is accepted.
    fn realm(realm: &str) -> bool;
    /// A key, or none where it is refused.
    fn key(key: Key, realm: Option<&str>, session: &str, name: Option<&str>) -> Option<String>;
    /// Whether a version is compatible, or none for an error.
    fn version(version: &str, strict: bool) -> Option<bool>;
    /// The columns of a block, or none where it is rejected.
    fn decode(block: &[u8]) -> Option<Vec<Column>>;
    /// The block of some columns, or none for an error.
    fn encode(columns: &[Column]) -> Option<Vec<u8>>;
}

/// The readers of the modules `version`, `keys` and `bulk` in scope.
macro_rules! readers {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy)]
        pub struct $name;

        impl crate::readers::Readers for $name {
            fn segment(segment: &str) -> bool {
                keys::validate_segment(segment).is_ok()
            }
            fn realm(realm: &str) -> bool {
                keys::validate_realm(realm).is_ok()
            }
            fn key(
                key: crate::readers::Key,
                realm: Option<&str>,
                session: &str,
                name: Option<&str>,
            ) -> Option<String> {
                use crate::readers::Key;
                let keys = keys::Keys::new(realm).ok()?;
                match key {
                    Key::Rpc => keys.rpc(),
                    Key::Sensor => keys.sensor(session, name),
                    Key::Command => keys.command(session, name),
                    Key::Observation => keys.observation(session),
                    Key::SensorGlob => keys.sensor_glob(session),
                    Key::CommandGlob => keys.command_glob(session),
                    Key::SessionGlob => keys.session_glob(session),
                    Key::FleetGlob => keys.fleet_glob(),
                }
                .ok()
            }
            fn version(version: &str, strict: bool) -> Option<bool> {
                version::check_version(version, strict).ok()
            }
            fn decode(block: &[u8]) -> Option<Vec<crate::readers::Column>> {
                let block = bulk::Block::parse(block).ok()?;
                let columns = block.to_columns().into_iter().map(|column| {
                    let (dtype, values) = match &column.data {
                        bulk::ColumnData::F32(v) => (1, v.iter().flat_map(|x| x.to_le_bytes()).collect()),
                        bulk::ColumnData::F64(v) => (2, v.iter().flat_map(|x| x.to_le_bytes()).collect()),
                        bulk::ColumnData::I32(v) => (3, v.iter().flat_map(|x| x.to_le_bytes()).collect()),
                        bulk::ColumnData::I64(v) => (4, v.iter().flat_map(|x| x.to_le_bytes()).collect()),
                    };
                    crate::readers::Column { name: column.name, dtype, values }
                });
                Some(columns.collect())
            }
            fn encode(columns: &[crate::readers::Column]) -> Option<Vec<u8>> {
                use crate::readers::numbers;
                let columns: Vec<bulk::Column> = columns
                    .iter()
                    .map(|column| {
                        let name = column.name.as_str();
                        let values = column.values.as_slice();
                        match column.dtype {
                            1 => bulk::Column::new(name, numbers(values, f32::from_le_bytes)),
                            2 => bulk::Column::new(name, numbers(values, f64::from_le_bytes)),
                            3 => bulk::Column::new(name, numbers(values, i32::from_le_bytes)),
                            _ => bulk::Column::new(name, numbers(values, i64::from_le_bytes)),
                        }
                    })
                    .collect();
                bulk::encode(&columns).ok()
            }
        }
    };
}
#[cfg(feature = "broken")]
pub(crate) use readers;

/// Values of `N` bytes.
pub(crate) fn numbers<T, const N: usize>(bytes: &[u8], read: fn([u8; N]) -> T) -> Vec<T> {
    bytes.as_chunks().0.iter().map(|raw| read(*raw)).collect()
}

mod production {
    use ncp_spec::{bulk, keys, version};

    readers! {
        /// The readers of production.
        Production
    }
}

pub use production::Production;
