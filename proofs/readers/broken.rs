/// A broken reader: the source of a real one with one edit.
#[derive(Debug, Clone, Copy)]
pub struct Broken {
    /// Its name, of the family that has to notice it.
    pub id: &'static str,
    /// The file, within `spec/src`.
    pub file: &'static str,
    /// Some text of it that occurs once.
    pub from: &'static str,
    /// What stands there instead.
    pub to: &'static str,
    /// The property that has to refute it.
    pub property: &'static str,
}

#[rustfmt::skip]
const fn broken(
    id: &'static str,
    file: &'static str,
    from: &'static str,
    to: &'static str,
    property: &'static str,
) -> Broken {
    Broken { id, file, from, to, property }
}

/// All of them.
#[rustfmt::skip]
pub const BROKEN: &[Broken] = &[
    broken("version_plus_sign", "version.rs", "part.bytes().all", "part.trim_start_matches('+').bytes().all", "version/bytes"),
    broken("version_empty_part", "version.rs", "!part.is_empty() && part", "part", "version/classes"),
    broken("version_third_part", "version.rs", "integer(minor)?", "integer(minor.split('.').next()?)?", "version/classes"),
    broken("version_other_script", "version.rs", "part.bytes().all(|b| b.is_ascii_digit())", "part.chars().all(char::is_numeric)", "version/classes"),
    broken("version_one_more_digit", "version.rs", "part.bytes().all(|b| b.is_ascii_digit())", "part.chars().all(|c| c.is_ascii_digit() || c == '\u{1d7ce}')", "version/scalars"),
    broken("version_missing_minor", "version.rs", "(version, \"0\")", "(version, \"5\")", "version/classes"),
    broken("version_trailing_zeros", "version.rs", "part.trim_start_matches('0')", "part.trim_matches('0')", "version/classes"),
    broken("version_no_leading_zeros", "version.rs", "part.trim_start_matches('0')", "part.strip_prefix('0').unwrap_or(part)", "version/classes"),
    broken("version_later_minor", "version.rs", "self.minor == other.minor", "self.minor >= other.minor", "version/classes"),
    broken("version_other_major", "version.rs", "_ => false,", "_ => true,", "version/classes"),
    broken("version_strict_alone", "version.rs", "strict && !compatible", "strict || !compatible", "version/classes"),
    broken("version_trimmed", "version.rs", "Version::parse(version).ok", "Version::parse(version.trim_ascii()).ok", "version/bytes"),
    broken("version_five_digits", "version.rs", "is_integer.then(", "(is_integer && part.len() < 5).then(", "version/classes"),

    broken("keys_question_mark", "keys.rs", "'#' | '?' => Some", "'#' => Some", "keys/bytes"),
    broken("keys_slash", "keys.rs", "'/' | '*'", "'*'", "keys/segment"),
    broken("keys_space", "keys.rs", "' ' | '\\t'..='\\r'", "'\\t'..='\\r'", "keys/segment"),
    broken("keys_c1", "keys.rs", "_ if c.is_control()", "_ if c.is_ascii_control()", "keys/scalars"),
    broken("keys_delete", "keys.rs", "_ if c.is_control()", "_ if c < ' ' || ('\\u{80}'..'\\u{a0}').contains(&c)", "keys/bytes"),
    broken("keys_other_space", "keys.rs", "_ if c.is_control()", "_ if c.is_control() || c.is_whitespace()", "keys/scalars"),
    broken("keys_beyond_16_bits", "keys.rs", "_ if c.is_control()", "_ if c.is_control() || c > '\\u{ffff}'", "keys/segment"),
    broken("keys_any_at", "keys.rs", "segment.starts_with('@')", "segment.contains('@')", "keys/segment"),
    broken("keys_only_at", "keys.rs", "segment.starts_with('@')", "segment == \"@\"", "keys/segment"),
    broken("keys_two_dots", "keys.rs", "segment == \".\" || segment == \"..\"", "segment == \".\"", "keys/segment"),
    broken("keys_leading_dot", "keys.rs", "segment == \".\" || segment == \"..\"", "segment.starts_with('.')", "keys/segment"),
    broken("keys_empty", "keys.rs", "if segment.is_empty()", "if false", "keys/segment"),
    broken("keys_short", "keys.rs", "MAX_SEGMENT_BYTES: usize = 256", "MAX_SEGMENT_BYTES: usize = 7", "keys/segment"),
    broken("keys_realm_end", "keys.rs", "realm.split('/')", "realm.split_terminator('/')", "keys/realm"),
    broken("keys_realm_two_parts", "keys.rs", "realm.split('/').try", "realm.split('/').take(2).try", "keys/realm"),
    broken("keys_lower_case", "keys.rs", "key.push_str(name)", "key.push_str(&name.to_lowercase())", "keys/builders"),
    broken("keys_unchecked_name", "keys.rs", "validate_segment(name)?;", "", "keys/builders"),
    broken("keys_unchecked_glob", "keys.rs", "validate_segment(id)?;\n        Ok(", "Ok(", "keys/builders"),

    broken("bulk_flags", "bulk/layout.rs", "flags != 0", "flags > 1", "bulk/header"),
    broken("bulk_version", "bulk/layout.rs", "version != VERSION", "version > VERSION", "bulk/header"),
    broken("bulk_longer_buffer", "bulk/layout.rs", "usize::try_from(stated) != Ok(block.len())", "stated as usize > block.len()", "bulk/header"),
    broken("bulk_pad", "bulk/layout.rs", "pad != 0", "pad > 1", "bulk/entry"),
    broken("bulk_dtype", "bulk/column.rs", "4 => Some(Self::I64)", "4 | 5 => Some(Self::I64)", "bulk/entry"),
    broken("bulk_rows_in_32_bits", "bulk/layout.rs", "u64::from(self.rows) * self.dtype.size() as u64", "u64::from(self.rows.wrapping_mul(self.dtype.size() as u32))", "bulk/entry"),
    broken("bulk_one_beyond", "bulk/block.rs", "if span.end() > len", "if span.end() > len + 1", "bulk/entry"),
    broken("bulk_empty_beyond", "bulk/block.rs", "if span.end() > len", "if span.len > 0 && span.end() > len", "bulk/entry"),
    broken("bulk_in_directory", "bulk/block.rs", "span.start < directory_end", "span.start < 12", "bulk/entry"),
    broken("bulk_empty_in_header", "bulk/block.rs", "span.len > 0 && span.start", "span.start", "bulk/entry"),
    broken("bulk_first_name", "bulk/block.rs", "for column in 0..self.len() {\n            str", "for column in 1..self.len() {\n            str", "bulk/entry"),
    broken("bulk_big_endian", "bulk/layout.rs", "data_off: u32::from_le_bytes", "data_off: u32::from_be_bytes", "bulk/entry"),
    broken("bulk_overlap", "bulk/block.rs", "b.start < a.end()", "b.start < a.start", "bulk/directories"),
    broken("bulk_touching", "bulk/block.rs", "b.start < a.end()", "b.start <= a.end()", "bulk/entry"),
    broken("bulk_names_apart", "bulk/block.rs", "names.chain(data).filter_map", "data.filter_map", "bulk/directories"),
    broken("bulk_unsorted_regions", "bulk/block.rs", "starts.sort_unstable();", "", "bulk/directories"),
    broken("bulk_empty_inside", "bulk/block.rs", "(span.len > 0).then_some(", "true.then_some(", "bulk/entry"),
    broken("bulk_unsorted_names", "bulk/layout.rs", "keys.sort_unstable();", "", "bulk/directories"),
    broken("bulk_panics", "bulk/layout.rs", "&mut room[..filled]", "&mut room[..filled * 17]", "bulk/entry"),
    broken("bulk_values_turned", "bulk/column.rs", "Self::from_le_bytes(raw)", "Self::from_be_bytes(raw)", "bulk/entry"),
    broken("bulk_encoder_align", "bulk/layout.rs", "DATA_ALIGN: u32 = 8", "DATA_ALIGN: u32 = 4", "bulk/columns"),
    broken("bulk_encoder_data", "bulk/encode.rs", "data_off = entry.data().end() as u32", "data_off = entry.data().start as u32", "bulk/columns"),
    broken("bulk_encoder_duplicates", "bulk/encode.rs", "find_duplicate(columns.len(), &mut scratch, name)", "find_duplicate(columns.len().min(2), &mut scratch, name)", "bulk/columns"),
];
