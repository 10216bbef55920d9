//! Columns outside a block: owned and borrowed values, and their types. `[NCP-BULK-007] [NCP-BULK-023]`

use std::fmt;

use super::ColumnView;

/// The type of a column's values.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Dtype {
    /// IEEE 754 binary32, code 1.
    F32,
    /// IEEE 754 binary64, code 2.
    F64,
    /// Two's complement, 32 bits, code 3.
    I32,
    /// Two's complement, 64 bits, code 4.
    I64,
}

impl Dtype {
    /// All types, in the order of their codes.
    pub const ALL: [Self; 4] = [Self::F32, Self::F64, Self::I32, Self::I64];

    /// The type's code in a directory entry.
    #[must_use]
    pub const fn code(self) -> u8 {
        match self {
            Self::F32 => 1,
            Self::F64 => 2,
            Self::I32 => 3,
            Self::I64 => 4,
        }
    }

    /// The type with this code, or `None` outside 1 to 4.
    #[must_use]
    pub const fn from_code(code: u8) -> Option<Self> {
        match code {
            1 => Some(Self::F32),
            2 => Some(Self::F64),
            3 => Some(Self::I32),
            4 => Some(Self::I64),
            _ => None,
        }
    }

    /// Bytes a value.
    #[must_use]
    pub const fn size(self) -> usize {
        match self {
            Self::F32 | Self::I32 => 4,
            Self::F64 | Self::I64 => 8,
        }
    }

    /// The type's name: `f32`, `f64`, `i32` or `i64`.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
            Self::I32 => "i32",
            Self::I64 => "i64",
        }
    }

    /// The type with this name, or `None`.
    #[must_use]
    pub fn parse(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|dtype| dtype.as_str() == name)
    }
}

impl fmt::Display for Dtype {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

/// A Rust type whose values fill a column: `f32`, `f64`, `i32` or `i64`.
pub trait Element: sealed::Sealed {
    /// The column type that holds it.
    const DTYPE: Dtype;
}

/// A named column that owns its values.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Column {
    /// The name, distinct within a block.
    pub name: String,
    /// The values.
    pub data: ColumnData,
}

impl Column {
    /// A column of these values.
    #[must_use]
    pub fn new(name: impl Into<String>, data: impl Into<ColumnData>) -> Self {
        Self { name: name.into(), data: data.into() }
    }
}

/// Owned values of one column.
///
/// Equality is that of the bytes on the wire: a NaN equals itself, another NaN
/// payload does not, and −0 is not 0.
#[derive(Clone)]
pub enum ColumnData {
    /// Values of type [`Dtype::F32`].
    F32(Vec<f32>),
    /// Values of type [`Dtype::F64`].
    F64(Vec<f64>),
    /// Values of type [`Dtype::I32`].
    I32(Vec<i32>),
    /// Values of type [`Dtype::I64`].
    I64(Vec<i64>),
}

impl ColumnData {
    /// The same values, borrowed.
    #[must_use]
    pub fn as_data_ref(&self) -> DataRef<'_> {
        match self {
            Self::F32(values) => DataRef::F32(values),
            Self::F64(values) => DataRef::F64(values),
            Self::I32(values) => DataRef::I32(values),
            Self::I64(values) => DataRef::I64(values),
        }
    }

    /// The values' type.
    #[must_use]
    pub fn dtype(&self) -> Dtype {
        self.as_data_ref().dtype()
    }

    /// Number of rows.
    #[must_use]
    pub fn len(&self) -> usize {
        self.as_data_ref().len()
    }

    /// Whether there are no rows.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Copies the values of a view.
    pub(super) fn from_view(view: &ColumnView<'_>) -> Self {
        match view.dtype() {
            Dtype::F32 => Self::F32(read_all(view.bytes())),
            Dtype::F64 => Self::F64(read_all(view.bytes())),
            Dtype::I32 => Self::I32(read_all(view.bytes())),
            Dtype::I64 => Self::I64(read_all(view.bytes())),
        }
    }
}

impl PartialEq for ColumnData {
    fn eq(&self, other: &Self) -> bool {
        self.as_data_ref() == other.as_data_ref()
    }
}

impl Eq for ColumnData {}

impl fmt::Debug for ColumnData {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.as_data_ref().fmt(f)
    }
}

/// A named column whose values belong to somebody else; what [`encode`](super::encode) takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ColumnRef<'a> {
    /// The name, distinct within a block.
    pub name: &'a str,
    /// The values.
    pub data: DataRef<'a>,
}

impl<'a> ColumnRef<'a> {
    /// A column of these values.
    #[must_use]
    pub fn new(name: &'a str, data: impl Into<DataRef<'a>>) -> Self {
        Self { name, data: data.into() }
    }
}

impl<'a> From<&'a Column> for ColumnRef<'a> {
    fn from(column: &'a Column) -> Self {
        Self { name: &column.name, data: column.data.as_data_ref() }
    }
}

impl<'a> From<&ColumnRef<'a>> for ColumnRef<'a> {
    fn from(column: &ColumnRef<'a>) -> Self {
        *column
    }
}

/// Borrowed values of one column. Equality is as for [`ColumnData`].
#[derive(Clone, Copy)]
pub enum DataRef<'a> {
    /// Values of type [`Dtype::F32`].
    F32(&'a [f32]),
    /// Values of type [`Dtype::F64`].
    F64(&'a [f64]),
    /// Values of type [`Dtype::I32`].
    I32(&'a [i32]),
    /// Values of type [`Dtype::I64`].
    I64(&'a [i64]),
}

impl DataRef<'_> {
    /// The values' type.
    #[must_use]
    pub fn dtype(&self) -> Dtype {
        match self {
            Self::F32(_) => Dtype::F32,
            Self::F64(_) => Dtype::F64,
            Self::I32(_) => Dtype::I32,
            Self::I64(_) => Dtype::I64,
        }
    }

    /// Number of rows.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::F32(values) => values.len(),
            Self::F64(values) => values.len(),
            Self::I32(values) => values.len(),
            Self::I64(values) => values.len(),
        }
    }

    /// Whether there are no rows.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Appends the values' bytes, little-endian.
    pub(super) fn write(self, out: &mut Vec<u8>) {
        match self {
            Self::F32(values) => write_all(values, out),
            Self::F64(values) => write_all(values, out),
            Self::I32(values) => write_all(values, out),
            Self::I64(values) => write_all(values, out),
        }
    }

    /// The values as they lie in memory: on one machine, equal for equal bits.
    fn bits(&self) -> &[u8] {
        match self {
            Self::F32(values) => bytemuck::cast_slice(values),
            Self::F64(values) => bytemuck::cast_slice(values),
            Self::I32(values) => bytemuck::cast_slice(values),
            Self::I64(values) => bytemuck::cast_slice(values),
        }
    }
}

impl PartialEq for DataRef<'_> {
    fn eq(&self, other: &Self) -> bool {
        self.dtype() == other.dtype() && self.bits() == other.bits()
    }
}

impl Eq for DataRef<'_> {}

impl fmt::Debug for DataRef<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ", self.dtype())?;
        match self {
            Self::F32(values) => values.fmt(f),
            Self::F64(values) => values.fmt(f),
            Self::I32(values) => values.fmt(f),
            Self::I64(values) => values.fmt(f),
        }
    }
}

/// Copies all values out of a column's bytes, aligned or not. [NCP-BULK-018] [NCP-BULK-023]
pub(super) fn read_all<T: Element>(bytes: &[u8]) -> Vec<T> {
    T::chunks(bytes).iter().map(|raw| T::from_le(*raw)).collect()
}

/// Appends values to a block.
fn write_all<T: Element>(values: &[T], out: &mut Vec<u8>) {
    if cfg!(target_endian = "little") {
        out.extend_from_slice(bytemuck::cast_slice(values));
    } else {
        for value in values {
            out.extend_from_slice(value.to_le().as_ref());
        }
    }
}

pub(super) mod sealed {
    /// How a value's bytes become the value, and back. Closed: the wire knows four types.
    /// [NCP-BULK-022]
    pub trait Sealed: bytemuck::Pod {
        /// The value's bytes, little-endian.
        type Raw: Copy + AsRef<[u8]>;
        /// Cuts whole values out of a column's bytes.
        fn chunks(bytes: &[u8]) -> &[Self::Raw];
        /// Reads one value.
        fn from_le(raw: Self::Raw) -> Self;
        /// Writes one value.
        fn to_le(self) -> Self::Raw;
    }
}

macro_rules! element {
    ($type:ty, $variant:ident) => {
        impl sealed::Sealed for $type {
            type Raw = [u8; size_of::<$type>()];

            fn chunks(bytes: &[u8]) -> &[Self::Raw] {
                bytes.as_chunks().0
            }

            fn from_le(raw: Self::Raw) -> Self {
                Self::from_le_bytes(raw)
            }

            fn to_le(self) -> Self::Raw {
                self.to_le_bytes()
            }
        }

        impl Element for $type {
            const DTYPE: Dtype = Dtype::$variant;
        }

        impl From<Vec<$type>> for ColumnData {
            fn from(values: Vec<$type>) -> Self {
                Self::$variant(values)
            }
        }

        impl<'a> From<&'a [$type]> for DataRef<'a> {
            fn from(values: &'a [$type]) -> Self {
                Self::$variant(values)
            }
        }
    };
}

element!(f32, F32);
element!(f64, F64);
element!(i32, I32);
element!(i64, I64);
