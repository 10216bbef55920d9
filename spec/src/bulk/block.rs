//! Reading a block without copying it. `[NCP-BULK-021] [NCP-BULK-023] [NCP-BULK-024]`

use super::column::read_all;
use super::layout::{ENTRY_LEN, Entry, Scratch, Span, directory_end, find_duplicate, read_directory};
use super::{BulkError, Column, ColumnData, Dtype, Element, Region};

/// A checked block: a view of a buffer that keeps every rule of the format.
///
/// Its columns are cut out of the buffer when they are asked for; nothing is copied.
#[derive(Clone, Copy)]
pub struct Block<'a> {
    bytes: &'a [u8],
    directory: &'a [[u8; ENTRY_LEN]],
}

impl<'a> Block<'a> {
    /// Checks a whole buffer, header, directory and names, and returns its view.
    ///
    /// The cost depends on the number of columns and the length of their names,
    /// never on the number of rows. Up to eight columns nothing is allocated;
    /// beyond that, once, 16 bytes a column: no more than the directory has.
    /// The buffer may lie at any address.
    ///
    /// # Errors
    /// The first rule that the buffer breaks, of NCP-BULK-001 to NCP-BULK-016. Entries
    /// are checked in order, then whether regions overlap, then the names.
    pub fn parse(bytes: &'a [u8]) -> Result<Self, BulkError> {
        let block = Self { bytes, directory: read_directory(bytes)? };
        for (column, raw) in block.directory.iter().enumerate() {
            let entry = Entry::read(raw, column)?;
            block.check_bounds(Region::Name(column), entry.name())?;
            block.check_bounds(Region::Data(column), entry.data())?;
        }
        let mut scratch = Scratch::for_columns(block.len());
        block.check_disjoint(&mut scratch)?;
        // Only now: disjoint names are together no longer than the buffer.
        block.check_names(&mut scratch)?;
        Ok(block)
    }

    /// Number of columns.
    #[must_use]
    pub fn len(&self) -> usize {
        self.directory.len()
    }

    /// Whether there are no columns.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.directory.is_empty()
    }

    /// The whole block's bytes.
    #[must_use]
    pub fn bytes(&self) -> &'a [u8] {
        self.bytes
    }

    /// A column by its place in the directory, or `None` past the last.
    #[must_use]
    pub fn column(&self, index: usize) -> Option<ColumnView<'a>> {
        let entry = Entry::read(self.directory.get(index)?, index).ok()?;
        Some(ColumnView {
            name: str::from_utf8(entry.name().of(self.bytes)?).ok()?,
            dtype: entry.dtype,
            bytes: entry.data().of(self.bytes)?,
        })
    }

    /// A column by its name, with its place in the directory, or `None`.
    #[must_use]
    pub fn find(&self, name: &str) -> Option<(usize, ColumnView<'a>)> {
        let index = (0..self.len()).find(|index| self.name_bytes(*index) == name.as_bytes())?;
        Some((index, self.column(index)?))
    }

    /// The columns in the directory's order. Requirement: NCP-BULK-021.
    pub fn columns(&self) -> impl DoubleEndedIterator<Item = ColumnView<'a>> + Clone + use<'a> {
        let block = *self;
        (0..self.len()).filter_map(move |index| block.column(index))
    }

    /// Copies every column.
    ///
    /// Names and values take no more bytes than the block has, as its regions are
    /// disjoint; to that comes the size of a [`Column`] each. Requirement: NCP-BULK-024.
    #[must_use]
    pub fn to_columns(&self) -> Vec<Column> {
        let mut columns = Vec::with_capacity(self.len());
        columns.extend(self.columns().map(|view| view.to_column()));
        columns
    }

    /// A region lies within the buffer, and behind the directory unless it is empty.
    fn check_bounds(&self, region: Region, span: Span) -> Result<(), BulkError> {
        let len = self.bytes.len() as u64;
        // [NCP-BULK-009] [NCP-BULK-011] [NCP-BULK-014]
        if span.end() > len {
            return Err(BulkError::OutOfBounds { region, start: span.start, end: span.end(), len });
        }
        let directory_end = directory_end(self.len()) as u64;
        // [NCP-BULK-012] [NCP-BULK-019]
        if span.len > 0 && span.start < directory_end {
            return Err(BulkError::InDirectory { region, start: span.start, directory_end });
        }
        Ok(())
    }

    /// No two non-empty regions share a byte; header and directory were checked before.
    /// Bytes between regions are nobody's. [NCP-BULK-012] [NCP-BULK-020]
    fn check_disjoint(&self, scratch: &mut Scratch) -> Result<(), BulkError> {
        let (names, data) = ((0..self.len()).map(Region::Name), (0..self.len()).map(Region::Data));
        // Sorted by start, two neighbours overlap if any two regions do. A key is the
        // start over the region's number; a start fits 32 bits by its field.
        let starts = scratch.fill(names.chain(data).filter_map(|region| {
            let span = self.span(region)?;
            (span.len > 0).then_some(span.start << 32 | self.number(region))
        }));
        starts.sort_unstable();
        for (first, second) in starts.iter().zip(starts.iter().skip(1)) {
            let (first, second) = (self.region(*first), self.region(*second));
            if let (Some(a), Some(b)) = (self.span(first), self.span(second))
                && b.start < a.end()
            {
                return Err(BulkError::Overlap { first, second, at: b.start });
            }
        }
        Ok(())
    }

    /// Names are UTF-8 and distinct. [NCP-BULK-010] [NCP-BULK-013]
    fn check_names(&self, scratch: &mut Scratch) -> Result<(), BulkError> {
        for column in 0..self.len() {
            str::from_utf8(self.name_bytes(column))
                .map_err(|error| BulkError::NameNotUtf8 { column, valid_up_to: error.valid_up_to() })?;
        }
        match find_duplicate(self.len(), scratch, |column| self.name_bytes(column)) {
            Some((first, second)) => Err(BulkError::DuplicateName { first, second }),
            None => Ok(()),
        }
    }

    /// The name of a column whose bounds have been checked.
    fn name_bytes(&self, column: usize) -> &'a [u8] {
        self.span(Region::Name(column)).and_then(|span| span.of(self.bytes)).unwrap_or_default()
    }

    fn span(&self, region: Region) -> Option<Span> {
        let (Region::Name(column) | Region::Data(column)) = region;
        let entry = Entry::read(self.directory.get(column)?, column).ok()?;
        Some(match region {
            Region::Name(_) => entry.name(),
            Region::Data(_) => entry.data(),
        })
    }

    /// Numbers the regions: first the names, then the data.
    fn number(&self, region: Region) -> u64 {
        match region {
            Region::Name(column) => column as u64,
            Region::Data(column) => (self.len() + column) as u64,
        }
    }

    /// The region whose number a sort key holds in its lower half.
    fn region(&self, key: u64) -> Region {
        let number = (key & 0xffff_ffff) as usize;
        match number.checked_sub(self.len()) {
            None => Region::Name(number),
            Some(column) => Region::Data(column),
        }
    }
}

impl std::fmt::Debug for Block<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_list().entries(self.columns()).finish()
    }
}

/// One column of a [`Block`]: its name and its values, still in the block's bytes.
#[derive(Clone, Copy)]
pub struct ColumnView<'a> {
    name: &'a str,
    dtype: Dtype,
    bytes: &'a [u8],
}

impl<'a> ColumnView<'a> {
    /// The name.
    #[must_use]
    pub fn name(&self) -> &'a str {
        self.name
    }

    /// The type of the values.
    #[must_use]
    pub fn dtype(&self) -> Dtype {
        self.dtype
    }

    /// Number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.bytes.len() / self.dtype.size()
    }

    /// The values' bytes, little-endian, at whatever address the block puts them.
    #[must_use]
    pub fn bytes(&self) -> &'a [u8] {
        self.bytes
    }

    /// The value in a row; `None` past the last row or when `T` is not the column's type.
    #[must_use]
    pub fn get<T: Element>(&self, row: usize) -> Option<T> {
        self.chunks::<T>()?.get(row).map(|raw| T::from_le(*raw))
    }

    /// The values in order; `None` when `T` is not the column's type.
    #[must_use]
    pub fn iter<T: Element>(
        &self,
    ) -> Option<impl ExactSizeIterator<Item = T> + DoubleEndedIterator + Clone + use<'a, T>> {
        Some(self.chunks::<T>()?.iter().map(|raw| T::from_le(*raw)))
    }

    /// The values as a slice of the block itself.
    ///
    /// `None` when `T` is not the column's type, when the values do not lie at a
    /// multiple of its alignment in memory, or on a big-endian machine.
    #[must_use]
    pub fn as_slice<T: Element>(&self) -> Option<&'a [T]> {
        if T::DTYPE != self.dtype || cfg!(target_endian = "big") {
            return None;
        }
        if self.bytes.is_empty() {
            return Some(&[]);
        }
        bytemuck::try_cast_slice(self.bytes).ok()
    }

    /// A copy of the values; `None` when `T` is not the column's type.
    #[must_use]
    pub fn to_vec<T: Element>(&self) -> Option<Vec<T>> {
        (T::DTYPE == self.dtype).then(|| read_all(self.bytes))
    }

    /// A copy of the column.
    #[must_use]
    pub fn to_column(&self) -> Column {
        Column { name: self.name.to_owned(), data: ColumnData::from_view(self) }
    }

    fn chunks<T: Element>(&self) -> Option<&'a [T::Raw]> {
        (T::DTYPE == self.dtype).then(|| T::chunks(self.bytes))
    }
}

impl std::fmt::Debug for ColumnView<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("ColumnView")
            .field("name", &self.name)
            .field("dtype", &self.dtype)
            .field("rows", &self.rows())
            .finish()
    }
}
