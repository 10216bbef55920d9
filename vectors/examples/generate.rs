//! Writes the corpus and its manifest to the folder of this crate.

use std::error::Error;
use std::fs;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let files = ncp_vectors::generate()?;
    let corpus = root.join("corpus");
    if corpus.exists() {
        fs::remove_dir_all(&corpus)?;
    }
    for (path, text) in &files {
        let file = corpus.join(path);
        fs::create_dir_all(file.parent().unwrap_or(&corpus))?;
        fs::write(file, text)?;
    }
    fs::write(root.join("MANIFEST.sha256"), ncp_vectors::manifest(&files))?;
    println!("wrote {} files to {}", files.len(), root.display());
    Ok(())
}
