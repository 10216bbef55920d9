//! A vector file as the program holds it: deflated by the build script, which leaves a twelfth of it.

use std::borrow::Cow;
use std::io::Read as _;

use flate2::read::DeflateDecoder;

use super::SuiteError;

/// A packed file.
#[derive(Debug)]
pub(super) struct Packed {
    pub(super) name: &'static str,
    /// The bytes of the text.
    pub(super) length: usize,
    pub(super) bytes: &'static [u8],
}

impl Packed {
    /// Its name and its text.
    pub(super) fn unpack(&self) -> Result<(&'static str, Cow<'static, str>), SuiteError> {
        let wrong = |message: String| SuiteError::File { file: self.name.to_owned(), message };
        let mut text = String::with_capacity(self.length);
        DeflateDecoder::new(self.bytes).read_to_string(&mut text).map_err(|error| wrong(error.to_string()))?;
        if text.len() != self.length {
            return Err(wrong(format!("is {} bytes long, not {}", text.len(), self.length)));
        }
        Ok((self.name, text.into()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::suite::{EMBEDDED, EMBEDDED_DEEP};

    #[test]
    fn what_is_unpacked_is_what_lies_in_the_folder() {
        let vectors = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../vectors");
        for (folder, files) in [(vectors.join("corpus"), EMBEDDED), (vectors, EMBEDDED_DEEP)] {
            assert!(files.len() > 10, "{}", folder.display());
            for file in files {
                let (name, text) = file.unpack().unwrap();
                assert!(std::fs::read_to_string(folder.join(name)).unwrap() == text, "{name}");
            }
        }
    }

    #[test]
    fn a_packed_file_that_lost_its_end_is_refused() {
        let [first, ..] = EMBEDDED else { panic!() };
        let cut = Packed { name: "cut", length: first.length, bytes: &first.bytes[..first.bytes.len() / 2] };
        let longer = Packed { name: "longer", length: first.length + 1, bytes: first.bytes };
        for file in [cut, longer] {
            let error = file.unpack().unwrap_err().to_string();
            assert!(error.starts_with(&format!("{}: ", file.name)), "{error}");
        }
    }
}
