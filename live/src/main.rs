//! Judges running NCP programs over Zenoh, as a black box: rule by rule of the text, with the evidence that there was.
//!
//! | module | what it does |
//! |---|---|
//! | [`scenario`] | the scenarios, as data |
//! | [`target`] | the system under test, and what runs beside it |
//! | [`judge`] | sets scenarios up, looks, and rules |
//! | [`actors`] | a reference system, and the defects that can be planted in it |
//! | [`relay`] | a hostile link |
//! | [`simulator`] | the NEST service, as a process of its own |
//! | [`soak`] | the reference system over it, judged all the time |
//! | [`demo`] | the whole system on one machine, with a network on NEST as the brain |
//! | [`bench`] | what judging costs |
//! | [`mutants`] | asks whether each planted defect fails its scenario, by its rule |
//! | [`verdict`] | passed, failed or inconclusive |
//! | [`report`] | shows verdicts, and computes none |

mod actors;
mod bench;
mod demo;
mod judge;
mod mutants;
mod relay;
mod report;
mod scenario;
mod simulator;
mod soak;
mod target;
mod verdict;

use std::fs::{self, File};
use std::io::{BufRead, BufReader, BufWriter, Write};
use std::net::SocketAddr;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use clap::{Args, Parser, Subcommand};
use ncp_text::Catalogue;
use ncp_zenoh::{Bus, BusError, Link};
use thiserror::Error;

use actors::{Care, Planted};
use judge::road::{AskError, Road};
use judge::{Parts, traffic};
use scenario::{Role, Scenario, scenarios};
use simulator::Simulator;
use target::{GatewayPlace, Mapping, Target};
use verdict::{Ruling, Rulings, Verdict};

#[derive(Debug, Parser)]
#[command(name = "ncp-live", version, about = "Judge running NCP programs over Zenoh, rule by rule")]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Start a router, the reference actors and a NEST service behind a gateway on loopback, run every scenario, and
    /// end what was started
    All(All),
    /// Judge what the samples of each plane really carry
    Qos(Deployed),
    /// Drive the session service of a deployment, over Zenoh or on another road
    Server(OfServer),
    /// Act as commander against a plant; the scenarios at the end latch its ESTOP
    Body(Deployed),
    /// Act as plant against a commander; the last scenario latches its ESTOP
    Commander(Deployed),
    /// Act as plant and commander beside an observer
    Observer(Deployed),
    /// Act as clients and as the simulation service of a gateway; the service of the deployment has to be stopped
    Gateway(BeforeService),
    /// Judge the traffic of a running system, and change nothing
    Watch(Watch),
    /// Judge a capture of `watch` again
    Replay(Replay),
    /// Ask whether each planted defect fails its scenario, by its rule
    Mutants(Mutants),
    /// Judge the access rules of a router, or say which of them decides on what
    Acl(judge::Acl),
    /// Run the reference system over a hostile link, for long, and judge it all the time
    Soak(soak::Soak),
    /// Fly a quad by a network on NEST through hold, ESTOP, dropouts and a jam, and judge both its ends
    Demo(demo::Demo),
    /// Measure what judging costs, and how fast commands are obeyed
    Bench(bench::Bench),
    /// List the scenarios
    List,
    /// What a scenario starts to see the program of the gateway start
    #[command(hide = true)]
    GatewayProgram(OfGateway),
}

#[derive(Debug, Args)]
struct All {
    /// Only scenarios whose name contains this
    #[arg(long, value_name = "TEXT")]
    only: Option<String>,
    /// Without a NEST service, which a first run installs
    #[arg(long)]
    without_nest: bool,
    /// The Python that has NEST [default: the repository's own, made by peers/nest/build.py]
    #[arg(long, value_name = "FILE")]
    python: Option<PathBuf>,
    /// Plant a defect in the actors
    #[arg(long, value_name = "NAME")]
    defect: Option<String>,
    /// Write every verdict as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

#[derive(Debug, Args)]
struct Deployed {
    #[command(flatten)]
    place: Place,
    /// The session whose planes are looked at
    #[arg(long, default_value = "s1")]
    session: String,
    /// The built-in network that a server is asked to open
    #[arg(long, default_value = "ncp.reference.lif")]
    network: String,
    /// How the plant's motion is read from its sensor stream (TOML)
    #[arg(long, value_name = "FILE")]
    mapping: Option<PathBuf>,
    /// Where the observer writes its pairs: `[command seq, sensor seq]`, one a line
    #[arg(long, value_name = "FILE", default_value = "joined.jsonl")]
    joined: PathBuf,
}

#[derive(Debug, Args)]
struct OfServer {
    #[command(flatten)]
    deployed: Deployed,
    #[command(flatten)]
    road: OtherRoad,
}

/// The road to a session service that is not asked over Zenoh.
#[derive(Debug, Args)]
#[group(multiple = false)]
struct OtherRoad {
    /// Ask over a WebSocket
    #[arg(long, value_name = "ADDRESS")]
    websocket: Option<SocketAddr>,
    /// Ask by gRPC, the service NeuroSim
    #[arg(long, value_name = "ADDRESS")]
    grpc: Option<SocketAddr>,
    /// Ask on the line of a bridge: a JSON document a line, over TCP
    #[arg(long, value_name = "ADDRESS")]
    lines: Option<SocketAddr>,
}

impl From<OtherRoad> for Road {
    fn from(OtherRoad { websocket, grpc, lines }: OtherRoad) -> Self {
        let websocket = websocket.map(Self::WebSocket);
        websocket.or_else(|| grpc.map(Self::Grpc)).or_else(|| lines.map(Self::Lines)).unwrap_or_default()
    }
}

#[derive(Debug, Args)]
struct BeforeService {
    #[command(flatten)]
    place: Place,
    /// Where the gateway looks for the simulation service
    #[arg(long, value_name = "ADDRESS", default_value = "127.0.0.1:28474")]
    bridge: SocketAddr,
    /// Where the gateway serves WebSockets [default: nowhere]
    #[arg(long, value_name = "ADDRESS")]
    websocket: Option<SocketAddr>,
    /// The program of the gateway, to see it start [default: none]
    #[arg(long, value_name = "FILE")]
    program: Option<PathBuf>,
    /// How long the clients of the deployment wait for a reply, in ms
    #[arg(long, value_name = "MS", default_value_t = 10_000)]
    query_ms: u64,
}

#[derive(Debug, Args)]
struct OfGateway {
    #[command(flatten)]
    settings: ncp_gateway::Settings,
    #[arg(long)]
    defect: Option<String>,
}

#[derive(Debug, Args)]
struct Place {
    /// A router or a peer of the deployment
    #[arg(long, value_name = "ENDPOINT", default_value = "tcp/127.0.0.1:7447")]
    connect: String,
    /// The realm
    #[arg(long, default_value = "ncp")]
    realm: String,
    /// Write every verdict as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

#[derive(Debug, Args)]
struct Watch {
    #[command(flatten)]
    place: Place,
    /// For how long, in seconds
    #[arg(long, value_name = "SECONDS", default_value_t = 10.0)]
    time: f64,
    /// Write the samples, one JSON object a line
    #[arg(long, value_name = "FILE")]
    capture: Option<PathBuf>,
}

#[derive(Debug, Args)]
struct Replay {
    /// What `watch --capture` wrote
    file: PathBuf,
    /// The realm
    #[arg(long, default_value = "ncp")]
    realm: String,
    /// Write every verdict as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

#[derive(Debug, Args)]
struct Mutants {
    /// Only these defects [default: all]
    #[arg(long, value_name = "NAME")]
    only: Vec<String>,
    /// Write every verdict as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// Why there is no verdict.
#[derive(Debug, Error)]
pub(crate) enum LiveError {
    /// The bus, or somebody on it.
    #[error(transparent)]
    Bus(#[from] BusError),
    /// A session service.
    #[error(transparent)]
    Ask(#[from] AskError),
    /// A file, or the operating system.
    #[error(transparent)]
    Io(#[from] std::io::Error),
    /// The text.
    #[error(transparent)]
    Text(#[from] ncp_text::catalogue::CatalogueError),
    /// The scenarios.
    #[error(transparent)]
    Scenario(#[from] scenario::ScenarioError),
    /// Access rules that cannot be explained.
    #[error(transparent)]
    Rules(#[from] judge::RulesError),
    /// The schedule of a link.
    #[error(transparent)]
    Schedule(#[from] relay::schedule::ScheduleError),
    /// A plot.
    #[error("the plot: {0}")]
    Plot(String),
    /// The story of a flight.
    #[error("the flight: {0}")]
    Story(toml::de::Error),
    /// The simulator.
    #[error("NEST: {0}")]
    Nest(String),
    /// The table of defects.
    #[error("defects.toml: {0}")]
    Defects(toml::de::Error),
    /// The mapping of a plant.
    #[error("{path}: {source}")]
    Mapping {
        /// The file.
        path: PathBuf,
        /// Why.
        source: toml::de::Error,
    },
    /// A capture.
    #[error("{path}:{line}: {source}")]
    Capture {
        /// The file.
        path: PathBuf,
        /// The line, from 1.
        line: usize,
        /// Why.
        source: serde_json::Error,
    },
    /// The reflex controller of an actor.
    #[error(transparent)]
    Reflex(#[from] ncp_spec::control::ReflexError),
    /// The loop of an actor.
    #[error(transparent)]
    Loop(#[from] ncp_spec::control::LoopError),
    /// A number of seconds that is none.
    #[error("{0} s is no time to watch")]
    Time(f64),
    /// No such scenario or defect.
    #[error("there is no {0:?}")]
    Unknown(String),
    /// The tap was too slow.
    #[error("the tap lost {0} samples itself, so it says nothing of the rest")]
    Overrun(u64),
    /// The gateway of an actor.
    #[error(transparent)]
    Gateway(#[from] ncp_gateway::GatewayError),
    /// A certificate.
    #[error(transparent)]
    Certificate(#[from] rcgen::Error),
    /// A result cannot be written as JSON, or the access rules cannot be read.
    #[error(transparent)]
    Json(#[from] serde_json::Error),
}

fn main() -> ExitCode {
    let command = match Cli::parse().command {
        Command::GatewayProgram(OfGateway { settings, defect }) => {
            return actors::gateway::program(&settings, &Planted(defect));
        }
        command => command,
    };
    match run(command) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("ncp-live: {error}");
            ExitCode::from(3)
        }
    }
}

/// Whether nothing failed.
fn run(command: Command) -> Result<bool, LiveError> {
    match command {
        Command::All(all) => own(&all),
        Command::Qos(deployed) => deployment(&deployed, Road::Zenoh, "qos/"),
        Command::Server(OfServer { deployed, road }) => deployment(&deployed, road.into(), "server/"),
        Command::Body(deployed) => deployment(&deployed, Road::Zenoh, "body/"),
        Command::Commander(deployed) => deployment(&deployed, Road::Zenoh, "commander/"),
        Command::Observer(deployed) => deployment(&deployed, Road::Zenoh, "observer/"),
        Command::Gateway(before) => gateway(&before),
        Command::Watch(watch) => look(&watch),
        Command::Replay(Replay { file, realm, json }) => {
            finish(&of_traffic(&captured(&file)?, &realm)?, json.as_deref())
        }
        Command::Mutants(Mutants { only, json }) => {
            let found = mutants::run(&only)?;
            write_json(json.as_deref(), &found)?;
            Ok(found.iter().all(mutants::Found::is_caught))
        }
        Command::Acl(acl) => judge::acl(&acl),
        Command::Soak(soak) => soak::run(&soak),
        Command::Demo(demo) => demo::run(&demo),
        Command::Bench(bench) => bench::run(&bench),
        Command::List => {
            for Scenario { name, about, rules, .. } in scenarios()? {
                println!("{name}\n  {about}\n  {}", rules.join(", "));
            }
            Ok(true)
        }
        // The program that runs is another one.
        Command::GatewayProgram(_) => Ok(false),
    }
}

/// A router and the target of the reference actors, which live until it is dropped.
pub(crate) struct OwnNet {
    target: Target,
    _router: Bus,
    _folder: tempfile::TempDir,
    scenarios: usize,
}

impl OwnNet {
    /// Starts a router on loopback.
    pub(crate) fn start() -> Result<Self, LiveError> {
        let endpoint = target::free_endpoint("tcp")?;
        let _router = Bus::open(&Link::Router(endpoint.clone()), None)?;
        let _folder = tempfile::tempdir()?;
        let target = Target {
            endpoint,
            realm: "ncp".to_owned(),
            session: "live".to_owned(),
            road: Road::Zenoh,
            network: "ncp.reference.lif".to_owned(),
            joined: _folder.path().join("joined.jsonl"),
            mapping: Mapping::default(),
            gateway: GatewayPlace::free()?,
        };
        Ok(Self { target, _router, _folder, scenarios: 0 })
    }

    /// Runs a scenario in a realm of its own, so that nothing of the one before is seen.
    pub(crate) fn judge(
        &mut self,
        scenario: &Scenario,
        planted: &Planted,
        catalogue: &Catalogue,
    ) -> Result<Vec<Ruling>, LiveError> {
        self.scenarios += 1;
        let realm = format!("live/{}", self.scenarios);
        let target = Target { realm, gateway: GatewayPlace::free()?, ..self.target.clone() };
        judge::judge(scenario, &target, &Parts::Actors(planted.clone()), catalogue)
    }

    /// Runs the scenarios of a server against the NEST service, through a gateway and on its own line.
    fn judge_nest(
        &self,
        is_asked: impl Fn(&str) -> bool,
        python: Option<&Path>,
        catalogue: &Catalogue,
    ) -> Result<Vec<Ruling>, LiveError> {
        let scenarios = scenarios()?;
        let of_server = || scenarios.iter().filter(|scenario| scenario.name.starts_with("server/"));
        let named = ON_NEST
            .iter()
            .flat_map(|on| of_server().map(move |scenario| (on, scenario, format!("{on}/{}", scenario.name))));
        let asked: Vec<_> = named.filter(|(.., name)| is_asked(name)).collect();
        if asked.is_empty() {
            return Ok(Vec::new());
        }
        let simulator = Simulator::start(python)?;
        let gateway = GatewayPlace { bridge: simulator.address, query: simulator::PATIENCE, ..GatewayPlace::free()? };
        let target = Target { realm: "nest".to_owned(), gateway, ..self.target.clone() };
        let _gateway = actors::start(Role::Gateway, &target, &Planted::default(), &Care::default())?;
        let mut rulings = Vec::new();
        for (on, scenario, name) in asked {
            let road = match (*on, target.gateway.websocket, target.gateway.grpc) {
                ("nest-websocket", Some(address), _) => Road::WebSocket(address),
                ("nest-grpc", _, Some(address)) => Road::Grpc(address),
                ("nest-lines", ..) => Road::Lines(simulator.address),
                _ => Road::Zenoh,
            };
            let target = Target { road, session: on.to_string(), ..target.clone() };
            let found = judge::judge(scenario, &target, &Parts::Deployed, catalogue)?;
            // What a road has no form for is not asked on it.
            if !found.is_empty() {
                let named = found.into_iter().map(|ruling| Ruling { scenario: name.clone(), ..ruling });
                let found: Vec<Ruling> = named.collect();
                report::progress(&name, &found);
                rulings.extend(found);
            }
        }
        Ok(rulings)
    }
}

/// How the scenarios of a server are named when it is a NEST service, by the road to it.
const ON_NEST: [&str; 4] = ["nest", "nest-websocket", "nest-grpc", "nest-lines"];

fn own(All { only, without_nest, python, defect, json }: &All) -> Result<bool, LiveError> {
    let planted = Planted(defect.clone());
    if let Some(name) = defect {
        mutants::defects()?.iter().find(|known| known.name == *name).ok_or_else(|| LiveError::Unknown(name.clone()))?;
    }
    let catalogue = Catalogue::load()?;
    let mut net = OwnNet::start()?;
    let mut rulings = Vec::new();
    let is_asked = |name: &str| only.as_ref().is_none_or(|text| name.contains(text.as_str()));
    for scenario in scenarios()?.into_iter().filter(|scenario| is_asked(&scenario.name)) {
        let found = net.judge(&scenario, &planted, &catalogue)?;
        report::progress(&scenario.name, &found);
        rulings.extend(found);
    }
    if !without_nest && defect.is_none() {
        rulings.extend(net.judge_nest(is_asked, python.as_deref(), &catalogue)?);
    }
    finish(&rulings, json.as_deref())
}

fn deployment(deployed: &Deployed, road: Road, group: &str) -> Result<bool, LiveError> {
    let Deployed { place, session, network, mapping, joined } = deployed;
    let mapping = match mapping {
        None => Mapping::default(),
        Some(path) => toml::from_str(&fs::read_to_string(path)?)
            .map_err(|source| LiveError::Mapping { path: path.clone(), source })?,
    };
    let target = Target {
        endpoint: place.connect.clone(),
        realm: place.realm.clone(),
        session: session.clone(),
        road,
        network: network.clone(),
        joined: joined.clone(),
        mapping,
        gateway: GatewayPlace::free()?,
    };
    of_group(&target, group, place.json.as_deref())
}

fn gateway(BeforeService { place, bridge, websocket, program, query_ms }: &BeforeService) -> Result<bool, LiveError> {
    let target = Target {
        endpoint: place.connect.clone(),
        realm: place.realm.clone(),
        session: "live".to_owned(),
        road: Road::Zenoh,
        network: "ncp.reference.lif".to_owned(),
        joined: PathBuf::new(),
        mapping: Mapping::default(),
        gateway: GatewayPlace {
            bridge: *bridge,
            websocket: *websocket,
            grpc: None,
            program: program.clone(),
            query: Duration::from_millis(*query_ms),
        },
    };
    of_group(&target, "gateway/", place.json.as_deref())
}

/// Runs the scenarios of a group against a deployment.
fn of_group(target: &Target, group: &str, json: Option<&Path>) -> Result<bool, LiveError> {
    let catalogue = Catalogue::load()?;
    let mut rulings = Vec::new();
    for scenario in scenarios()?.into_iter().filter(|scenario| scenario.name.starts_with(group)) {
        let found = judge::judge(&scenario, target, &Parts::Deployed, &catalogue)?;
        report::progress(&scenario.name, &found);
        rulings.extend(found);
    }
    finish(&rulings, json)
}

fn look(Watch { place, time, capture }: &Watch) -> Result<bool, LiveError> {
    let longest = Duration::try_from_secs_f64(*time).map_err(|_| LiveError::Time(*time))?;
    let bus = Bus::open(&Link::Connect(place.connect.clone()), Some(&place.realm))?;
    let mut samples = Vec::new();
    let lost = traffic::tap_into(&bus, longest, |sample| samples.push(sample))?;
    println!("{} samples, {lost} lost by the tap", samples.len());
    if let Some(path) = capture {
        let mut file = BufWriter::new(File::create(path)?);
        for sample in &samples {
            writeln!(file, "{}", serde_json::to_string(sample)?)?;
        }
        file.flush()?;
    }
    if lost > 0 {
        return Err(LiveError::Overrun(lost));
    }
    finish(&of_traffic(&samples, &place.realm)?, place.json.as_deref())
}

fn captured(path: &Path) -> Result<Vec<traffic::Sample>, LiveError> {
    let lines = BufReader::new(File::open(path)?).lines();
    let samples = (1..).zip(lines).map(|(line, text)| {
        serde_json::from_str(&text?).map_err(|source| LiveError::Capture { path: path.to_owned(), line, source })
    });
    samples.collect()
}

/// Judges traffic by all rules that traffic alone shows.
fn of_traffic(samples: &[traffic::Sample], realm: &str) -> Result<Vec<Ruling>, LiveError> {
    let of_tap = ["qos/planes", "watch/loop", "watch/server"];
    let scenarios = scenarios()?.into_iter().filter(|scenario| of_tap.contains(&scenario.name.as_str()));
    let rules: Vec<String> = scenarios.flat_map(|scenario| scenario.rules).collect();
    let catalogue = Catalogue::load()?;
    let mut rulings = Rulings::new(&rules);
    traffic::judge(samples, realm, &mut rulings);
    let sentence = |rule: &str| catalogue.get(rule).map(|rule| rule.sentence.clone()).unwrap_or_default();
    Ok(rulings.verdicts("watch", sentence))
}

/// Shows the verdicts; whether none failed.
fn finish(rulings: &[Ruling], json: Option<&Path>) -> Result<bool, LiveError> {
    report::matrix(rulings);
    write_json(json, rulings)?;
    Ok(rulings.iter().all(|ruling| ruling.verdict != Verdict::Failed))
}

fn write_json(path: Option<&Path>, content: &(impl serde::Serialize + ?Sized)) -> Result<(), LiveError> {
    if let Some(path) = path {
        fs::write(path, serde_json::to_string_pretty(content)? + "\n")?;
    }
    Ok(())
}
