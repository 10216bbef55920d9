//! A plain archive: to be unpacked over a prefix such as `~/.local`, or anywhere.

use std::env;
use std::fs::File;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use flate2::Compression;
use flate2::write::GzEncoder;
use tar::{Builder, HeaderMode};

use super::{Contents, PROGRAM, PackageError, VERSION};

pub(super) fn make(contents: &Contents<'_>, folder: &Path) -> Result<PathBuf, PackageError> {
    let name = format!("ncp-verify-{VERSION}-{}-{}", env::consts::OS, env::consts::ARCH);
    let path = folder.join(format!("{name}.tar.gz"));
    let pack = || -> io::Result<()> {
        let mut tar = Builder::new(GzEncoder::new(File::create(&path)?, Compression::best()));
        tar.mode(HeaderMode::Deterministic);
        tar.append_path_with_name(&contents.program, format!("{name}/bin/{PROGRAM}"))?;
        tar.append_dir_all(format!("{name}/share"), &contents.shared)?;
        tar.into_inner()?.finish()?.flush()
    };
    pack().map_err(|source| PackageError::File { path: path.clone(), source })?;
    Ok(path)
}
