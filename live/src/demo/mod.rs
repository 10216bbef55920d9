//! The whole system on one machine: a quad that a NEST network flies over the four planes, through hold, ESTOP,
//! dropouts and a jam, and the judges of both its ends.
//!
//! | module | what it does |
//! |---|---|
//! | [`story`] | what happens when, as `demo.toml` has it |
//! | [`brain`] | a control loop whose commands are decoded from spikes |
//! | [`quad`] | the plant |
//! | [`flight`] | what was flown: a log, a trajectory and a plot |

mod brain;
mod flight;
mod quad;
mod story;

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};
use std::{fs, mem};

use clap::Args;
use ncp_spec::resilience::LinkMonitor;
use ncp_text::Catalogue;
use ncp_zenoh::{Bus, Link};
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;

use crate::actors::{self, Care, Planted};
use crate::judge::road::Road;
use crate::judge::{self, Parts, traffic};
use crate::relay::Relay;
use crate::scenario::{Role, scenarios};
use crate::simulator::{PATIENCE, Simulator};
use crate::target::{GatewayPlace, Running, Target, free_endpoint};
use crate::verdict::{Ruling, Verdict};
use crate::{LiveError, of_traffic, report, write_json};
use brain::lock;
use flight::Flight;
use story::Story;

/// How the demonstration is run.
#[derive(Debug, Args)]
pub(crate) struct Demo {
    /// Where log, trajectory, plot and verdicts go
    #[arg(long, value_name = "FOLDER", default_value = "demo")]
    out: PathBuf,
    /// Another flight (TOML) [default: `live/demo.toml`]
    #[arg(long, value_name = "FILE")]
    story: Option<PathBuf>,
    /// The Python that has NEST and `ncp_nest` [default: that of `peers/nest/build.py`, which is run]
    #[arg(long, value_name = "FILE")]
    python: Option<PathBuf>,
    /// Only fly, and judge what was seen on the way; not each end by its scenarios
    #[arg(long)]
    only_fly: bool,
}

/// The realm and the session of the flight.
const REALM: &str = "demo";
const SESSION: &str = "quad";

/// How long commander and plant are left to themselves around a reset.
const SETTLES: Duration = Duration::from_millis(300);

/// Flies, judges, and writes what was seen; whether nothing failed.
///
/// # Errors
/// NEST cannot be set up or started, Zenoh refuses, or a file cannot be written.
pub(crate) fn run(demo: &Demo) -> Result<bool, LiveError> {
    let story = match &demo.story {
        Some(path) => Story::parse(&fs::read_to_string(path)?)?,
        None => Story::parse(story::OWN)?,
    };
    fs::create_dir_all(&demo.out)?;
    let ends = Arc::new(AtomicBool::new(false));
    for signal in [SIGINT, SIGTERM] {
        flag::register(signal, Arc::clone(&ends))?;
    }

    println!("NEST, behind a gateway …");
    let simulator = Simulator::start(demo.python.as_deref())?;
    let system = System::start(&story, &simulator, demo)?;
    let (flight, mut rulings) = system.fly(&story, &ends)?;
    flight.write(&demo.out, &story)?;
    if !demo.only_fly && !ends.load(Ordering::Relaxed) {
        rulings.extend(both_ends(&story, &simulator, demo)?);
    }
    report::matrix(&rulings);
    write_json(Some(&demo.out.join("verdicts.json")), &rulings)?;
    println!("{}", flight.summary());
    println!("{}: log.jsonl, trajectory.csv, flight.svg, verdicts.json, joined.jsonl", demo.out.display());
    Ok(flight.arrived() && rulings.iter().all(|ruling| ruling.verdict != Verdict::Failed))
}

/// Two routers with a hostile link between them: commander, gateway and observer on the left, the quad on the right.
struct System {
    // In the order in which they end: who talks, the link, the routers.
    running: Vec<Running>,
    relay: Relay,
    left: Target,
    right: Target,
    _routers: [Bus; 2],
}

impl System {
    fn start(story: &Story, simulator: &Simulator, demo: &Demo) -> Result<Self, LiveError> {
        let (left, right) = (free_endpoint("tcp")?, free_endpoint("tcp")?);
        let _routers = [router(&left)?, router(&right)?];
        let relay = Relay::start(&left, &right, REALM, story.link()?)?;
        let (left, right) = (target(left, story, simulator, demo)?, target(right, story, simulator, demo)?);
        let mut running = Vec::new();
        for role in [Role::Gateway, Role::Observer] {
            running.push(actors::start(role, &left, &Planted::default(), &Care::default())?);
        }
        Ok(Self { running, relay, left, right, _routers })
    }

    /// Flies the story, or until it is to end; what was flown, and what the traffic beside the commander shows.
    fn fly(mut self, story: &Story, ends: &Arc<AtomicBool>) -> Result<(Flight, Vec<Ruling>), LiveError> {
        let wishes = Arc::<Wishes>::default();
        // The link's clock is that of the story.
        let began = self.relay.began();
        let (quad, quad_log) = quad::quad(&self.right, &wishes, began)?;
        // A short dropout is no burst; a jam is.
        let link = LinkMonitor::new(0.2, 36.0);
        let (brain, brain_log) = brain::brain(&self.left, story, &wishes, link, began)?;
        let tap = self.left.bus()?;
        let longest = Duration::try_from_secs_f64(story.time_s).map_err(|_| LiveError::Time(story.time_s))?;
        let tapped = thread::spawn(move || {
            let mut samples = Vec::new();
            traffic::tap_into(&tap, longest, |sample| samples.push(sample)).map(|lost| (samples, lost))
        });
        let mut told = story.told();
        while began.elapsed() < longest && !ends.load(Ordering::Relaxed) {
            let now_s = began.elapsed().as_secs_f64();
            for event in told.until(now_s) {
                println!("{now_s:5.1} s  {}: {}", event.name.as_str(), event.about);
                if event.name == story::Name::Reset {
                    // An ESTOP that is still on its way would latch the quad again.
                    self.relay.stop_commands(true);
                    thread::sleep(SETTLES);
                    wishes.reset();
                    thread::sleep(SETTLES);
                    self.relay.stop_commands(false);
                }
            }
            wishes.ask(story.asked(now_s));
            thread::sleep(Duration::from_millis(10));
        }
        let faults = self.relay.faults();
        self.running.extend([brain, quad]);
        // The brain closes its session before the gateway ends.
        while let Some(part) = self.running.pop() {
            drop(part);
        }
        let (samples, lost) = tapped.join().map_err(|_| LiveError::Unknown("tap".to_owned()))??;
        if lost > 0 {
            return Err(LiveError::Overrun(lost));
        }
        let flight = Flight {
            ticks: mem::take(&mut *lock(&brain_log)),
            places: mem::take(&mut *lock(&quad_log)),
            faults: faults.values().flat_map(|of| of.values()).sum(),
            goal: story.goal(story.time_s.next_down()),
        };
        Ok((flight, of_traffic(&samples, REALM)?))
    }
}

/// Holds the quad against the scenarios of a body, and the commander with its network against those of a commander.
fn both_ends(story: &Story, simulator: &Simulator, demo: &Demo) -> Result<Vec<Ruling>, LiveError> {
    let endpoint = free_endpoint("tcp")?;
    let _router = router(&endpoint)?;
    let at = target(endpoint, story, simulator, demo)?;
    let catalogue = Catalogue::load()?;
    let mut rulings = Vec::new();
    for group in ["body/", "commander/"] {
        println!(
            "ncp-live {} against the {}",
            group.trim_end_matches('/'),
            if group == "body/" { "quad" } else { "NEST commander" }
        );
        let (wishes, began) = (Arc::<Wishes>::default(), Instant::now());
        let mut running = Vec::new();
        if group == "body/" {
            running.push(quad::quad(&at, &wishes, began)?.0);
        } else {
            running.push(actors::start(Role::Gateway, &at, &Planted::default(), &Care::default())?);
            // The judge leaves out numbers, so that its stamps are those of no counter: that is no loss.
            let link = LinkMonitor::new(0.99, 1e6);
            running.push(brain::brain(&at, story, &wishes, link, began)?.0);
        }
        for scenario in scenarios()?.into_iter().filter(|scenario| scenario.name.starts_with(group)) {
            // Each scenario finds what the one before may have latched reset.
            wishes.reset();
            thread::sleep(SETTLES);
            let found = judge::judge(&scenario, &at, &Parts::Deployed, &catalogue)?;
            report::progress(&scenario.name, &found);
            rulings.extend(found);
        }
        while let Some(part) = running.pop() {
            drop(part);
        }
    }
    Ok(rulings)
}

fn router(endpoint: &str) -> Result<Bus, LiveError> {
    Ok(Bus::open(&Link::Router(endpoint.to_owned()), None)?)
}

fn target(endpoint: String, story: &Story, simulator: &Simulator, demo: &Demo) -> Result<Target, LiveError> {
    let place = GatewayPlace { bridge: simulator.address, query: PATIENCE, ..GatewayPlace::free()? };
    Ok(Target {
        endpoint,
        realm: REALM.to_owned(),
        session: SESSION.to_owned(),
        road: Road::Zenoh,
        network: String::new(),
        joined: demo.out.join("joined.jsonl"),
        mapping: story.mapping.clone(),
        gateway: place,
    })
}

/// What operator and supervisor ask of commander and plant.
#[derive(Debug, Default)]
struct Wishes {
    asked: Mutex<story::Asked>,
    resets: AtomicU64,
}

impl Wishes {
    fn ask(&self, asked: story::Asked) {
        *lock(&self.asked) = asked;
    }

    fn asked(&self) -> story::Asked {
        *lock(&self.asked)
    }

    fn reset(&self) {
        self.resets.fetch_add(1, Ordering::SeqCst);
    }

    /// How often a reset was asked for.
    fn resets(&self) -> u64 {
        self.resets.load(Ordering::SeqCst)
    }
}
