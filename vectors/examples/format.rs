//! Lays out the scenario text of this crate.

use std::path::{Path, PathBuf};
use std::{fs, io};

fn main() -> io::Result<()> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios");
    for file in files(&root)?.iter().map(|area| files(area)).collect::<io::Result<Vec<_>>>()?.concat() {
        let text = fs::read_to_string(&file)?;
        let formatted = ncp_vectors::formatted(&text);
        if formatted != text {
            fs::write(&file, formatted)?;
            println!("formatted {}", file.display());
        }
    }
    Ok(())
}

fn files(folder: &Path) -> io::Result<Vec<PathBuf>> {
    fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect()
}
