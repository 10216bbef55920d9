//! The packages of `cargo xtask package` work where there is neither the project nor Rust: installed without a network
//! into empty folders outside of it, and run with little on the path. The check `packages` makes them before.

#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test that cannot go on has failed")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use tempfile::TempDir;

#[test]
#[ignore = "needs the packages, which the check `packages` makes"]
fn the_wheel_installs_a_program_that_needs_nothing_else() {
    let place = Place::new(&["python3"]);
    let python = place.folder().join("venv/bin/python");
    place.succeed("python3", &["-m", "venv", "venv"]);
    let wheel = package(".whl");
    place.succeed(&python, &["-m", "pip", "install", "--quiet", "--no-index", wheel.to_str().unwrap()]);
    place.holds_up(&[place.folder().join("venv/bin/ncp-verify").to_str().unwrap()]);

    let found = place.succeed(&python, &["-c", "import ncp_verify; print(ncp_verify.program())"]);
    assert_eq!(found.trim(), place.folder().join("venv/bin/ncp-verify").to_str().unwrap());
    let version = place.succeed(&python, &["-m", "ncp_verify", "--version"]);
    assert_eq!(version, place.succeed(found.trim(), &["--version"]));
    let named = "import sys, zipfile; wheel = zipfile.ZipFile(sys.argv[1]); \
                 print(*[name for name in wheel.namelist() if sys.argv[2].encode() in wheel.read(name)])";
    let files = place.succeed(&python, &["-c", named, wheel.to_str().unwrap(), root().to_str().unwrap()]);
    assert_eq!(files, "\n", "these files hold the path of the project");
    place.has_shared(&place.folder().join("venv/share"));
    place.is_small_and_anonymous(Path::new(found.trim()));
}

#[test]
#[ignore = "needs the packages, which the check `packages` makes"]
fn the_installed_wheel_gives_pytest_its_plugin() {
    let place = Place::new(&["python3"]);
    place.succeed("python3", &["-m", "venv", "venv"]);
    let python = place.folder().join("venv/bin/python");
    let install = ["-m", "pip", "install", "--quiet", "--no-index"];
    place.succeed(&python, &[&install[..], &[package(".whl").to_str().unwrap()]].concat());
    // There is no network to install pytest from: that of the project stands beside the wheel.
    let site = "import sysconfig; print(sysconfig.get_paths()['purelib'])";
    let of_the_project = Command::new(root().join(".tools/pytest-venv/bin/python")).args(["-c", site]).output();
    let of_the_project = String::from_utf8(of_the_project.expect("no pytest").stdout).unwrap();
    let beside = Path::new(place.succeed(&python, &["-c", site]).trim()).join("pytest.pth");
    fs::write(beside, of_the_project).unwrap();

    let pytest = |peer: &str| {
        let session = ["-m", "pytest", "-rA", "-p", "no:cacheprovider", "--ncp-filter", "version/", "--ncp-peer"];
        let output = place.run(&python, &[&session[..], &[peer]].concat());
        (output.status.code(), String::from_utf8(output.stdout).unwrap())
    };
    let (code, said) = pytest("python3 adapter.py");
    assert!(code == Some(0) && said.contains("PASSED ncp/peer::verdict"), "{said}");
    assert!(said.matches("PASSED ncp/version/").count() > 50, "{said}");
    let (code, said) = pytest("python3 PROTOCOL-starter.py");
    assert!(code == Some(1) && said.contains("FAILED ncp/peer::describe") && said.contains("NCP-VER-020"), "{said}");
}

#[test]
#[ignore = "needs the packages, which the check `packages` makes"]
fn a_wheel_that_is_installed_beside_other_packages_finds_its_program() {
    let place = Place::new(&["python3"]);
    let wheel = package(".whl");
    place.succeed("python3", &["-m", "venv", "venv"]);
    let install = ["-m", "pip", "install", "--quiet", "--no-index", "--target", "flat", wheel.to_str().unwrap()];
    place.succeed(place.folder().join("venv/bin/python"), &install);
    let find = "import sys; sys.path.insert(0, 'flat'); import ncp_verify; print(ncp_verify.program())";
    let found = place.succeed("python3", &["-c", find]);
    assert_eq!(found.trim(), place.folder().join("flat/bin/ncp-verify").to_str().unwrap());
}

#[test]
#[ignore = "needs the packages, which the check `packages` makes"]
fn the_packages_of_npm_install_a_program_that_needs_nothing_else() {
    let place = Place::new(&["python3", "node", "npm"]);
    let (launcher, platform) =
        (package_of_npm(|name| !name.contains("-x64-") && !name.contains("-arm64-")), platform());
    fs::write(place.folder().join("package.json"), "{\"private\":true}").unwrap();
    let install = ["install", "--offline", "--no-audit", "--no-fund"];
    place.succeed("npm", &[&install[..], &[launcher.to_str().unwrap(), platform.to_str().unwrap()]].concat());
    place.holds_up(&["npm", "exec", "--offline", "--", "ncp-verify"]);

    let conformed = |peer: &str| {
        let command = format!("{{ command: ['python3', '{peer}'], filter: 'version/' }}");
        let tests = format!("import {{ conform }} from 'ncp-verify/test';\nawait conform({command});\n");
        fs::write(place.folder().join("peer.test.mjs"), tests).unwrap();
        let output = place.run("node", &["--test", "--test-reporter=tap", "peer.test.mjs"]);
        (output.status.code(), String::from_utf8(output.stdout).unwrap())
    };
    let (code, said) = conformed("adapter.py");
    assert!(code == Some(0) && said.contains(" - verdict") && said.matches(" - version/").count() > 50, "{said}");
    let (code, said) = conformed("PROTOCOL-starter.py");
    assert!(code == Some(1) && said.contains(" - describe") && said.contains("NCP-VER-020"), "{said}");

    let find = "import('ncp-verify').then(({ program }) => console.log(program()))";
    let found = place.succeed("node", &["-e", find]);
    place.is_small_and_anonymous(Path::new(found.trim()));
}

#[test]
#[ignore = "needs the packages, which the check `packages` makes"]
fn the_launcher_names_the_package_that_it_lacks() {
    let place = Place::new(&["node", "npm"]);
    let launcher = package_of_npm(|name| !name.contains("-x64-") && !name.contains("-arm64-"));
    fs::write(place.folder().join("package.json"), "{\"private\":true}").unwrap();
    let install = ["install", "--offline", "--no-audit", "--no-fund", "--omit=optional"];
    place.succeed("npm", &[&install[..], &[launcher.to_str().unwrap()]].concat());
    let output = place.run("node_modules/.bin/ncp-verify", &["--version"]);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.code() == Some(4) && said.starts_with("error: the package @ncp-verify/"), "{output:?}");
}

#[test]
#[ignore = "needs the packages, which the check `packages` makes"]
fn the_archive_holds_a_program_that_needs_nothing_else() {
    let place = Place::new(&["python3"]);
    let mut tar = Command::new("tar");
    tar.arg("-xzf").arg(package(".tar.gz")).args(["--strip-components", "1", "-C"]).arg(place.folder());
    assert!(tar.status().unwrap().success());
    let program = place.folder().join("bin/ncp-verify");
    place.holds_up(&[program.to_str().unwrap()]);
    place.has_shared(&place.folder().join("share"));
    place.is_small_and_anonymous(&program);
}

#[test]
#[ignore = "needs the packages, which the check `packages` makes"]
fn every_package_has_less_than_15_megabytes() {
    let packages = packages();
    assert_eq!(packages.len(), 4, "{packages:?}");
    for package in packages {
        assert!(package.metadata().unwrap().len() < MOST, "{}", package.display());
    }
}

/// How large a package or a program may be, in bytes.
const MOST: u64 = 15_000_000;

/// An empty folder outside of the project, with only some programs on the path.
struct Place(TempDir);

impl Place {
    fn new(programs: &[&str]) -> Self {
        let place = Self(tempfile::tempdir().unwrap());
        let bin = place.folder().join("path");
        fs::create_dir(&bin).unwrap();
        for program in programs {
            std::os::unix::fs::symlink(real(program), bin.join(program)).unwrap();
        }
        for of_rust in ["cargo", "rustc", "rustup"] {
            assert!(!bin.join(of_rust).exists());
        }
        for file in ["peers/PROTOCOL-starter.py", "peers/python-pure/adapter.py"] {
            fs::copy(root().join(file), place.folder().join(Path::new(file).file_name().unwrap())).unwrap();
        }
        copy(&root().join("peers/python-pure/ncp_pure"), &place.folder().join("ncp_pure"));
        place
    }

    /// Its path, as programs that look where they are see it.
    fn folder(&self) -> PathBuf {
        self.0.path().canonicalize().unwrap()
    }

    fn run(&self, program: impl AsRef<Path>, args: &[&str]) -> Output {
        let program = program.as_ref();
        let on_path = self.folder().join("path").join(program);
        let program = if on_path.exists() { on_path } else { self.folder().join(program) };
        let mut command = Command::new(&program);
        command.args(args).current_dir(self.folder()).env_clear();
        // npm runs what is installed by a shell, and launchers begin with env: both are known by their paths.
        command.env("PATH", self.folder().join("path")).env("HOME", self.folder()).env("LANG", "C.UTF-8");
        command.env("npm_config_script_shell", "/bin/sh");
        command.output().unwrap_or_else(|error| panic!("{}: {error}", program.display()))
    }

    fn succeed(&self, program: impl AsRef<Path>, args: &[&str]) -> String {
        let output = self.run(&program, args);
        assert!(output.status.success(), "{} {args:?}: {output:?}", program.as_ref().display());
        String::from_utf8(output.stdout).unwrap()
    }

    /// Sees that the program, started by these words, does all that it does in the project.
    fn holds_up(&self, start: &[&str]) {
        let run = |args: &[&str]| self.run(start[0], &[&start[1..], args].concat());
        let ends = |args: &[&str], code: i32| {
            let output = run(args);
            assert_eq!(output.status.code(), Some(code), "{start:?} {args:?}: {output:?}");
            String::from_utf8(output.stdout).unwrap()
        };
        let version = ends(&["--version"], 0);
        let digest = Command::new("sha256sum").arg(root().join("vectors/MANIFEST.sha256")).output().unwrap().stdout;
        let digest = String::from_utf8(digest).unwrap();
        assert!(version.contains(&format!("sha256:{}", digest.split(' ').next().unwrap())), "{version}");
        let hash = version.lines().find_map(|line| line.strip_prefix("contract hash  ")).unwrap();
        let identity = fs::read_to_string(root().join("spec/text/02-version-and-identity.md")).unwrap();
        assert!(identity.contains(&format!("`{hash}`")), "{version}");

        // The starter does not know the contract hash yet; the implementation in pure Python keeps everything.
        let starter = ends(&["run", "--peer-cmd", "python3 PROTOCOL-starter.py"], 1);
        assert!(starter.contains("2 rules are broken") && starter.contains("NCP-VER-020"), "{starter}");
        assert!(self.folder().join("reports/run/result.json").is_file());
        let pure = ends(&["run", "--peer-cmd", "python3 adapter.py"], 0);
        assert!(pure.contains("conforms at level wire"), "{pure}");
        let deep =
            ["run", "--deep", "--filter", "deep/*", "--peer-cmd", "python3 PROTOCOL-starter.py", "--json", "deep.json"];
        ends(&deep, 1);
        assert!(fs::read_to_string(self.folder().join("deep.json")).unwrap().contains("\"deep/"));
        // What a search finds is not for the packages to say; that it asks is.
        let fuzz = run(&["fuzz", "--time", "3s", "--peer-cmd", "python3 adapter.py"]);
        let said = String::from_utf8_lossy(&fuzz.stdout).into_owned();
        assert!(matches!(fuzz.status.code(), Some(0 | 1)) && said.contains(" inputs of "), "{fuzz:?}");

        assert!(ends(&["explain", "NCP-WIRE-007"], 0).contains("MUST reject a frame"));
        assert!(ends(&["list"], 0).lines().count() > 5000);
        let starter = fs::read_to_string(root().join("peers/PROTOCOL-starter.py")).unwrap();
        assert_eq!(ends(&["starter"], 0), starter);
        assert!(ends(&["man"], 0).contains(".TH ncp-verify 1"));
        ends(&["man", "pages"], 0);
        assert!(self.folder().join("pages/ncp-verify-run.1").is_file());
        for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
            assert!(ends(&["completions", shell], 0).contains("peer-cmd"), "{shell}");
        }

        // Without the project there are no bundled peers, and it says what to do.
        let output = run(&[]);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() == Some(2) && said.contains("ncp-verify run --peer-cmd"), "{output:?}");
    }

    /// Sees that manual pages, completions, licences and the protocol lie below a prefix.
    fn has_shared(&self, share: &Path) {
        for file in [
            "man/man1/ncp-verify.1",
            "man/man1/ncp-verify-run.1",
            "bash-completion/completions/ncp-verify",
            "zsh/site-functions/_ncp-verify",
            "fish/vendor_completions.d/ncp-verify.fish",
            "doc/ncp-verify/LICENSE-MIT",
            "doc/ncp-verify/THIRD-PARTY.txt",
            "doc/ncp-verify/PROTOCOL.md",
        ] {
            assert!(share.join(file).metadata().is_ok_and(|file| file.len() > 100), "{file}");
        }
    }

    /// Sees that a program is small, and holds no path of the machine on which it was made.
    fn is_small_and_anonymous(&self, program: &Path) {
        let bytes = fs::read(program).unwrap();
        assert!((bytes.len() as u64) < MOST, "{} bytes", bytes.len());
        let root = root().to_str().unwrap();
        let home = std::env::home_dir().unwrap().join(".cargo");
        for path in [root, home.to_str().unwrap()] {
            let found = bytes.windows(path.len()).position(|window| window == path.as_bytes());
            let around = found.map(|at| String::from_utf8_lossy(&bytes[at..(at + 120).min(bytes.len())]).into_owned());
            assert_eq!(around, None);
        }
    }
}

/// A program as it is, and not as a version manager shows it.
fn real(program: &str) -> PathBuf {
    let ask = match program {
        "python3" => Command::new("python3").args(["-c", "import sys; print(sys.executable)"]).output(),
        _ => Command::new("sh").args(["-c", &format!("command -v {program}")]).output(),
    };
    let printed = String::from_utf8(ask.unwrap().stdout).unwrap();
    Path::new(printed.trim()).canonicalize().unwrap()
}

fn packages() -> Vec<PathBuf> {
    let folder = root().join("target/packages");
    let entries = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    entries.map(|entry| entry.unwrap().path()).collect()
}

/// The package whose name ends so.
fn package(end: &str) -> PathBuf {
    let found = packages().into_iter().find(|file| file.to_str().unwrap().ends_with(end));
    found.unwrap_or_else(|| panic!("no package {end}: {:?}", packages()))
}

fn package_of_npm(is_meant: fn(&str) -> bool) -> PathBuf {
    let of_npm = packages().into_iter().filter(|file| file.extension().is_some_and(|end| end == "tgz"));
    of_npm.into_iter().find(|file| is_meant(file.file_name().unwrap().to_str().unwrap())).expect("no package of npm")
}

fn platform() -> PathBuf {
    package_of_npm(|name| name.contains("-x64-") || name.contains("-arm64-"))
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let path = entry.unwrap().path();
        if path.is_file() {
            fs::copy(&path, to.join(path.file_name().unwrap())).unwrap();
        }
    }
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap()
}
