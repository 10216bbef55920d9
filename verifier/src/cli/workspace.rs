//! Where the bundled peers are.

use std::path::{Path, PathBuf};

use super::CliError;

/// A folder that holds `peers/*/peer.toml`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Workspace {
    /// The folder itself.
    pub(super) root: PathBuf,
    /// The peers' folders, sorted.
    pub(super) peers: Vec<PathBuf>,
}

impl Workspace {
    /// The nearest one at or above the current folder.
    pub(super) fn here() -> Option<Self> {
        Self::above(&std::env::current_dir().ok()?)
    }

    /// The nearest one at or above `from`.
    pub(super) fn above(from: &Path) -> Option<Self> {
        from.ancestors().find_map(Self::at)
    }

    /// The nearest one at or above `from`, whose bundled peers are meant when none is named.
    pub(super) fn of_bundled_peers(from: &Path, command: &str) -> Result<Self, CliError> {
        let none = || {
            CliError::Usage(format!(
                "no peer is named, and {} is not in a checkout of the project, whose bundled peers would be meant\n\
                 name yours:         ncp-verify {command} --peer-cmd 'python3 my_adapter.py'\n\
                 or begin with one:  ncp-verify starter > my_adapter.py",
                from.display()
            ))
        };
        Self::above(from).ok_or_else(none)
    }

    /// Cargo's target folder.
    pub(super) fn target(&self) -> PathBuf {
        target(&self.root)
    }

    fn at(root: &Path) -> Option<Self> {
        let mut peers: Vec<PathBuf> = std::fs::read_dir(root.join("peers"))
            .ok()?
            .filter_map(|entry| Some(entry.ok()?.path()))
            .filter(|folder| folder.join("peer.toml").is_file())
            .collect();
        peers.sort();
        (!peers.is_empty()).then(|| Self { root: root.to_owned(), peers })
    }
}

/// Cargo's target folder for a workspace at `root`.
pub(super) fn target(root: &Path) -> PathBuf {
    match std::env::var_os("CARGO_TARGET_DIR") {
        Some(folder) if !folder.is_empty() => std::path::absolute(&folder).unwrap_or_else(|_| folder.into()),
        _ => root.join("target"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_workspace_above_is_found_with_its_peers_sorted() {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path();
        for peer in ["b", "a", "no-manifest"] {
            std::fs::create_dir_all(root.join("peers").join(peer)).unwrap();
        }
        for peer in ["b", "a"] {
            std::fs::write(root.join("peers").join(peer).join("peer.toml"), "").unwrap();
        }
        let deep = root.join("x/y");
        std::fs::create_dir_all(&deep).unwrap();
        let found = Workspace::above(&deep).unwrap();
        assert_eq!(found.root, root);
        assert_eq!(found.peers, [root.join("peers/a"), root.join("peers/b")]);
        assert_eq!(Workspace::above(Path::new("/nowhere")), None);
    }
}
