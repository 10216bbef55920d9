//! `ncp-verify attest` and `ncp-verify check-report`.

use std::path::{Path, PathBuf};

use clap::Args;

use super::check::{current_dir, write};
use super::workspace::{Workspace, target};
use super::{ATTEST_HELP, CHECK_REPORT_HELP, CliError, print};
use crate::attest::{Artefact, Believed, Key, Statement, open, seal};
use crate::peer::{Address, Launch, Manifest};
use crate::report::{Exit, PeerReport, Report, State};
use crate::suite::Suite;

#[derive(Debug, Args)]
#[command(after_help = ATTEST_HELP)]
pub(super) struct AttestArgs {
    /// A result
    #[arg(required_unless_present = "new_key")]
    result: Option<PathBuf>,
    /// The private key, ed25519 in PEM
    #[arg(long, value_name = "KEY", required_unless_present = "new_key")]
    key: Option<PathBuf>,
    /// A file that the peer consists of, beside those that its command names (may be repeated)
    #[arg(long, value_name = "FILE")]
    artefact: Vec<PathBuf>,
    /// Where to write the attestation
    #[arg(long, short, value_name = "FILE", required_unless_present = "new_key")]
    output: Option<PathBuf>,
    /// Write a new private key to KEY, and its public key to KEY.pub
    #[arg(long, value_name = "KEY", conflicts_with_all = ["result", "key", "artefact", "output"])]
    new_key: Option<PathBuf>,
}

#[derive(Debug, Args)]
#[command(after_help = CHECK_REPORT_HELP)]
pub(super) struct CheckReportArgs {
    /// An attestation
    file: PathBuf,
    /// The public key of the one whose signature is believed, ed25519 in PEM
    #[arg(long, value_name = "PUB")]
    key: PathBuf,
    /// A file that it has to be about (may be repeated)
    #[arg(long, value_name = "FILE")]
    artefact: Vec<PathBuf>,
}

/// Attests a result, or makes a key.
pub(super) fn attest(suite: &Suite, args: &AttestArgs) -> Result<Exit, CliError> {
    if let Some(file) = &args.new_key {
        return new_key(file);
    }
    let (Some(result), Some(key), Some(output)) = (&args.result, &args.key, &args.output) else {
        return Err(CliError::Usage("attest takes a result, --key and --output".to_owned()));
    };
    let key = Key::from_pem(&text(key)?)?;
    let report = Report::read(result)?;
    let mut subject: Vec<Artefact> = args.artefact.iter().map(|file| artefact(file)).collect::<Result<_, _>>()?;
    for peer in report.peers.iter().filter(|peer| peer.state == State::Checked) {
        for file in files(peer)? {
            let artefact = artefact(&file)?;
            if !subject.contains(&artefact) {
                subject.push(artefact);
            }
        }
    }
    let statement = Statement::new(subject, this_program()?, report, suite)?;
    write(output, &seal(&statement, &key)?)?;
    for subject in &statement.subject {
        print(&format!("about {} sha256:{}\n", subject.name, subject.digest.sha256))?;
    }
    print(&format!("attestation: {}\n", output.display()))?;
    Ok(Exit::Conformant)
}

/// Checks an attestation: exit code 1 if it is refused.
pub(super) fn check_report(suite: &Suite, args: &CheckReportArgs) -> Result<Exit, CliError> {
    let key = Believed::from_pem(&text(&args.key)?)?;
    let given: Vec<Artefact> = args.artefact.iter().map(|file| artefact(file)).collect::<Result<_, _>>()?;
    let opened = open(&text(&args.file)?, &key, suite)
        .and_then(|statement| given.iter().try_for_each(|file| statement.is_about(file)).map(|()| statement));
    let statement = match opened {
        Ok(statement) => statement,
        Err(refusal) => {
            eprintln!("refused: {refusal}");
            return Ok(Exit::NotConformant);
        }
    };
    let result = &statement.predicate.result;
    print(&format!("signed by {}\n", key.id()))?;
    print(&format!("vectors and text are those at hand; {} follows from its cases\n", count(&result.peers)))?;
    for peer in &result.peers {
        let level = peer.level.map_or(String::new(), |level| format!(" at level {level}"));
        let part = if result.asked.partial { ", of a part of the cases" } else { "" };
        print(&format!("{}: {}{level}{part}\n", peer.name, peer.verdict()))?;
    }
    for subject in &statement.subject {
        let held =
            if given.iter().any(|file| file.digest == subject.digest) { "held against the file" } else { "as stated" };
        print(&format!("about {} sha256:{}, {held}\n", subject.name, subject.digest.sha256))?;
    }
    let (verifier, here) = (&statement.predicate.verifier, this_program()?);
    let whose = if verifier.digest == here.digest { "this program" } else { "another build of ncp-verify" };
    print(&format!("judged by {whose}, sha256:{}\n", verifier.digest.sha256))?;
    Ok(Exit::Conformant)
}

fn count(peers: &[PeerReport]) -> String {
    if peers.len() == 1 { "the verdict".to_owned() } else { format!("each of {} verdicts", peers.len()) }
}

fn new_key(file: &Path) -> Result<Exit, CliError> {
    if file.exists() {
        return Err(CliError::Usage(format!("{} is there already", file.display())));
    }
    let key = Key::generate()?;
    private(file, &key.to_pem())
        .map_err(|error| CliError::Harness(format!("{} cannot be written: {error}", file.display())))?;
    let mut public = file.as_os_str().to_owned();
    public.push(".pub");
    write(Path::new(&public), &key.public().to_pem())?;
    print(&format!("private key: {}\npublic key: {}\n", file.display(), Path::new(&public).display()))?;
    Ok(Exit::Conformant)
}

/// Writes what nobody else may read.
fn private(file: &Path, text: &str) -> std::io::Result<()> {
    use std::io::Write as _;
    let mut options = std::fs::OpenOptions::new();
    options.write(true).create_new(true);
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
    options.open(file)?.write_all(text.as_bytes())
}

/// The files that the command of a peer names, and its `peer.toml`.
fn files(peer: &PeerReport) -> Result<Vec<PathBuf>, CliError> {
    let here = current_dir()?;
    let root = Workspace::above(&here).map_or_else(|| here.clone(), |workspace| workspace.root);
    let folders = [here.join(&peer.source), root.join(&peer.source)];
    match folders.into_iter().find(|folder| folder.join("peer.toml").is_file()) {
        Some(folder) => {
            let root = Workspace::above(&folder).map_or_else(|| folder.clone(), |workspace| workspace.root);
            let launch = Manifest::load(&folder, &root, &target(&root))?.launch;
            Ok(launch.files().into_iter().chain([folder.join("peer.toml")]).collect())
        }
        None if Address::parse(&peer.source).is_ok() => Ok(Vec::new()),
        None => Ok(Launch::from_command_line(&peer.source, &here)?.files()),
    }
}

fn artefact(file: &Path) -> Result<Artefact, CliError> {
    let bytes = std::fs::read(file).map_err(|error| CliError::Usage(format!("{}: {error}", file.display())))?;
    let here = current_dir()?;
    let shown = file.strip_prefix(&here).unwrap_or(file);
    Ok(Artefact::new(&shown.display().to_string(), &bytes))
}

fn this_program() -> Result<Artefact, CliError> {
    let bytes = std::env::current_exe().and_then(std::fs::read);
    let bytes = bytes.map_err(|error| CliError::Harness(format!("this program cannot be read: {error}")))?;
    Ok(Artefact::new("ncp-verify", &bytes))
}

fn text(file: &Path) -> Result<String, CliError> {
    std::fs::read_to_string(file).map_err(|error| CliError::Usage(format!("{}: {error}", file.display())))
}
