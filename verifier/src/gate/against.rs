//! What went out before: a commit of git, a folder, an image, or the baseline of the tree.

use std::cell::OnceCell;
use std::fs;
use std::path::{Path, PathBuf};

use ncp_spec::contract::hash_of;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::tools::{ToolError, Tools};
use super::{Against, CORPUS, GateError, PROTO};

/// What a tree is held against.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// The latest tag of git.
    Tag,
    /// A commit of git.
    Commit,
    /// A folder: a tree, or its `proto`.
    Folder,
    /// A buf image.
    Image,
    /// The frozen image in the tree itself.
    Baseline,
}

impl Kind {
    /// As people read it.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Tag => "the tag",
            Self::Commit => "the commit",
            Self::Folder => "the folder",
            Self::Image => "the image",
            Self::Baseline => "the baseline",
        }
    }
}

/// What went out before, as far as it is known.
#[derive(Debug)]
pub(super) struct Base {
    kind: Kind,
    name: String,
    /// The folder of its proto.
    proto: Option<PathBuf>,
    /// Its proto as an image, once that is made.
    image: OnceCell<PathBuf>,
    /// The file of its projection.
    pub(super) projection: Option<PathBuf>,
    /// The folder of its cases.
    pub(super) corpus: Option<PathBuf>,
    /// Its wire version.
    pub(super) wire: Option<String>,
    /// Its contract hash.
    pub(super) hash: Option<String>,
}

/// The frozen image, from the root of a tree.
const BASELINE: &str = "proto/baseline";

impl Base {
    /// What somebody asked for; else the latest tag, or without one the baseline.
    pub(super) fn find(root: &Path, asked: Option<&str>, tools: &Tools<'_>) -> Result<Self, GateError> {
        let Some(asked) = asked else {
            return match latest_tag(tools) {
                Some(tag) => Self::commit(Kind::Tag, &tag, tools),
                None => Self::baseline(root),
            };
        };
        let path = Path::new(asked);
        if path.is_dir() {
            return Self::folder(Kind::Folder, asked, path);
        }
        if path.is_file() {
            return Self::image(Kind::Image, asked, path);
        }
        let commit = format!("{asked}^{{commit}}");
        match tools.asks_git(&["rev-parse", "--verify", "--quiet", "--end-of-options", &commit]) {
            Some(_) => Self::commit(Kind::Commit, asked, tools),
            None => Err(GateError::NoSuch(asked.to_owned())),
        }
    }

    /// What a report says of it.
    pub(super) fn told(&self) -> Against {
        Against {
            kind: self.kind,
            name: self.name.clone(),
            wire_version: self.wire.clone(),
            contract_hash: self.hash.clone(),
        }
    }

    /// Whether it is of another wire version than the one that is given. Who says none is of the same.
    pub(super) fn is_of_another_wire(&self, wire: &str) -> bool {
        self.wire.as_deref().is_some_and(|before| before != wire)
    }

    /// Its proto as an image, which buf makes of a folder.
    pub(super) fn as_image(&self, tools: &Tools<'_>) -> Result<PathBuf, ImageError> {
        if let (None, Some(proto)) = (self.image.get(), &self.proto) {
            let image = tools.scratch().path("base.binpb");
            let (from, to) = (proto.display().to_string(), image.display().to_string());
            let ended = tools.run(tools.buf(&["build", &from, "-o", &to], ""), "buf-build")?;
            if ended.code != Some(0) {
                return Err(ImageError::Build(ended.last_words()));
            }
            let _ = self.image.set(image);
        }
        self.image.get().cloned().ok_or(ImageError::None)
    }

    /// A commit, whose files git writes out.
    fn commit(kind: Kind, name: &str, tools: &Tools<'_>) -> Result<Self, GateError> {
        let folder = tools.scratch().path("tree");
        fs::create_dir_all(&folder).map_err(|source| GateError::File { path: folder.clone(), source })?;
        let archive = tools.scratch().path("tree.tar");
        let (to, into) = (archive.display().to_string(), folder.display().to_string());
        let carry_out = |command| {
            let ended = tools.run(command, "git").map_err(|error| match error {
                ToolError::Interrupted => GateError::Interrupted,
                other => GateError::Program { command: "git archive".to_owned(), output: other.to_string() },
            })?;
            let failed = || GateError::Program { command: ended.shown.clone(), output: ended.stderr.trim().to_owned() };
            if ended.code == Some(0) { Ok(()) } else { Err(failed()) }
        };
        // What an older commit does not have is not asked of it.
        let has = |path: &&str| tools.asks_git(&["cat-file", "-e", &format!("{name}:./{path}")]).is_some();
        let paths: Vec<&str> = ["proto", CORPUS].into_iter().filter(has).collect();
        if !paths.contains(&"proto") {
            return Err(GateError::Lacks { name: name.to_owned(), what: PROTO });
        }
        carry_out(tools.git(&[&["archive", "--format=tar", "-o", &to, name, "--"][..], &paths].concat()))?;
        carry_out(tools.program(Path::new("tar"), &["-xf", &to, "-C", &into], ""))?;
        Self::folder(kind, name, &folder)
    }

    /// A tree, or the folder of a proto.
    fn folder(kind: Kind, name: &str, folder: &Path) -> Result<Self, GateError> {
        let folder = std::path::absolute(folder).unwrap_or_else(|_| folder.to_owned());
        let proto = [folder.join("proto"), folder.clone()].into_iter().find(|at| at.join("ncp.proto").is_file());
        let proto = proto.ok_or_else(|| GateError::Lacks { name: name.to_owned(), what: PROTO })?;
        let file = proto.join("ncp.proto");
        let text = fs::read_to_string(&file).map_err(|source| GateError::File { path: file, source })?;
        let projection = Some(proto.join("projection.json")).filter(|file| file.is_file());
        let (wire, _) = projection.as_deref().map(identity_of).transpose()?.unwrap_or_default();
        Ok(Self {
            kind,
            name: name.to_owned(),
            proto: Some(proto),
            image: OnceCell::new(),
            projection,
            corpus: Some(folder.join(CORPUS)).filter(|corpus| corpus.is_dir()),
            wire,
            hash: Some(hash_of(&text)),
        })
    }

    /// An image; beside `ncp-0.5.binpb` may stand `projection-0.5.json`, or `projection.json`.
    fn image(kind: Kind, name: &str, file: &Path) -> Result<Self, GateError> {
        let file = std::path::absolute(file).unwrap_or_else(|_| file.to_owned());
        let stem = file.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        let own = stem.split_once('-').map(|(_, wire)| format!("projection-{wire}.json"));
        let names = own.into_iter().chain(["projection.json".to_owned()]);
        let projection = names.map(|name| file.with_file_name(name)).find(|file| file.is_file());
        let (wire, hash) = projection.as_deref().map(identity_of).transpose()?.unwrap_or_default();
        let base = Self {
            kind,
            name: name.to_owned(),
            proto: None,
            image: OnceCell::new(),
            projection,
            corpus: None,
            wire,
            hash,
        };
        let _ = base.image.set(file);
        Ok(base)
    }

    fn baseline(root: &Path) -> Result<Self, GateError> {
        let lacks = || GateError::Lacks { name: BASELINE.to_owned(), what: "image, and there is no tag" };
        let entries = fs::read_dir(root.join(BASELINE)).map_err(|_| lacks())?;
        let mut images: Vec<PathBuf> = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
        images.retain(|file| file.extension().is_some_and(|extension| extension == "binpb"));
        images.sort();
        let image = images.pop().ok_or_else(lacks)?;
        let name = image.strip_prefix(root).unwrap_or(&image).display().to_string();
        Self::image(Kind::Baseline, &name, &image)
    }
}

/// Why there is no image.
#[derive(Debug, thiserror::Error)]
pub(super) enum ImageError {
    /// buf could not be run.
    #[error(transparent)]
    Tool(#[from] ToolError),
    /// buf refuses the proto.
    #[error("{0}")]
    Build(String),
    /// There is no proto to make one of.
    #[error("there is no proto")]
    None,
}

/// The latest tag behind the tree: not the one that it is itself being released as.
fn latest_tag(tools: &Tools<'_>) -> Option<String> {
    let before = |commit: &str| tools.asks_git(&["describe", "--tags", "--abbrev=0", commit]);
    let tag = before("HEAD")?;
    let of = |name: &str| tools.asks_git(&["rev-parse", &format!("{name}^{{commit}}")]);
    let is_this = of(&tag) == of("HEAD") && tools.asks_git(&["status", "--porcelain"])?.is_empty();
    if is_this { before("HEAD^") } else { Some(tag) }
}

/// The wire version and the contract hash that a projection states.
pub(super) fn identity_of(projection: &Path) -> Result<(Option<String>, Option<String>), GateError> {
    let file = || projection.to_owned();
    let text = fs::read_to_string(projection).map_err(|source| GateError::File { path: file(), source })?;
    let value: Value =
        serde_json::from_str(&text).map_err(|error| GateError::Form { path: file(), problem: error.to_string() })?;
    let member = |name: &str| value.get(name).and_then(Value::as_str).map(str::to_owned);
    Ok((member("wire"), member("contract_hash")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gate::PROJECTION;
    use crate::gate::tools::Scratch;
    use crate::stop::Stop;

    const PROJECTED: &str = r#"{"wire": "0.4", "contract_hash": "2cf0763ad61e4f1c"}"#;

    fn find(root: &Path, asked: Option<&str>) -> Result<Against, GateError> {
        let (scratch, stop) = (Scratch::make(root).unwrap(), Stop::default());
        Base::find(root, asked, &Tools::new(root, &scratch, &stop)).map(|base| base.told())
    }

    fn write(root: &Path, file: &str, text: &str) {
        let file = root.join(file);
        fs::create_dir_all(file.parent().unwrap()).unwrap();
        fs::write(file, text).unwrap();
    }

    fn git(root: &Path, args: &[&str]) {
        let own = ["-c", "user.name=n", "-c", "user.email=e", "-c", "commit.gpgsign=false", "-c", "tag.gpgsign=false"];
        let ended = std::process::Command::new("git").args(own).args(args).current_dir(root).output().unwrap();
        assert!(ended.status.success(), "{ended:?}");
    }

    #[test]
    fn without_a_tag_a_tree_is_held_against_its_baseline() {
        let root = tempfile::tempdir().unwrap();
        git(root.path(), &["init", "--quiet"]);
        assert!(matches!(find(root.path(), None), Err(GateError::Lacks { .. })));
        write(root.path(), "proto/baseline/ncp-0.4.binpb", "");
        write(root.path(), "proto/baseline/projection-0.4.json", PROJECTED);
        let found = find(root.path(), None).unwrap();
        assert_eq!((found.kind, &*found.name), (Kind::Baseline, "proto/baseline/ncp-0.4.binpb"));
        assert_eq!(found.wire_version.as_deref(), Some("0.4"));
        assert_eq!(found.contract_hash.as_deref(), Some("2cf0763ad61e4f1c"));
    }

    #[test]
    fn a_tree_is_held_against_the_latest_tag_but_for_the_one_that_it_is_released_as() {
        let root = tempfile::tempdir().unwrap();
        git(root.path(), &["init", "--quiet"]);
        write(root.path(), ".gitignore", ".tools\n");
        for tag in ["v1", "v2"] {
            write(root.path(), PROTO, &format!("message M{tag} {{\n}}\n"));
            git(root.path(), &["add", "-A"]);
            git(root.path(), &["commit", "--quiet", "-m", tag]);
            git(root.path(), &["tag", tag]);
        }
        let name = |root: &Path| find(root, None).unwrap().name;
        assert_eq!(name(root.path()), "v1");
        write(root.path(), PROTO, "message M {\n}\n");
        assert_eq!(name(root.path()), "v2");
        let found = find(root.path(), Some("v1")).unwrap();
        assert_eq!((found.kind, found.contract_hash), (Kind::Commit, Some(hash_of("message Mv1 {\n}\n"))));
        assert!(matches!(find(root.path(), Some("v3")), Err(GateError::NoSuch(_))));
    }

    #[test]
    fn a_folder_is_a_tree_or_its_proto_and_a_file_is_an_image() {
        let root = tempfile::tempdir().unwrap();
        write(root.path(), PROTO, "message M {\n}\n");
        write(root.path(), PROJECTION, PROJECTED);
        let shown = |path: &Path| path.display().to_string();
        let of_tree = find(root.path(), Some(&shown(root.path()))).unwrap();
        let of_proto = find(root.path(), Some(&shown(&root.path().join("proto")))).unwrap();
        assert_eq!(of_tree.kind, Kind::Folder);
        assert_eq!(of_tree.contract_hash, of_proto.contract_hash);
        assert_eq!((of_tree.wire_version.as_deref(), of_proto.wire_version.as_deref()), (Some("0.4"), Some("0.4")));
        write(root.path(), "elsewhere/ncp-0.4.binpb", "");
        let image = find(root.path(), Some(&shown(&root.path().join("elsewhere/ncp-0.4.binpb")))).unwrap();
        assert_eq!((image.kind, image.wire_version), (Kind::Image, None));
        let empty = root.path().join("elsewhere");
        assert!(matches!(find(root.path(), Some(&shown(&empty))), Err(GateError::Lacks { .. })));
    }
}
