//! Writes the corpus and its manifest to the folder of this crate.

use std::path::Path;
use std::{fs, io};

fn main() -> io::Result<()> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let files = ncp_vectors::generate();
    let mut areas: Vec<_> = files.iter().filter_map(|(path, _)| path.split('/').next()).collect();
    areas.dedup();
    for area in areas {
        let folder = root.join(area);
        if folder.exists() {
            fs::remove_dir_all(&folder)?;
        }
        fs::create_dir(&folder)?;
    }
    for (path, text) in &files {
        fs::write(root.join(path), text)?;
    }
    fs::write(root.join("MANIFEST.sha256"), ncp_vectors::manifest(&files))?;
    println!("wrote {} files to {}", files.len(), root.display());
    Ok(())
}
