//! The reference backend: two small networks, integrated by exact propagation. Section 4.4.

use super::backend::{BackendError, Opened, Simulation, SimulationBackend};
use crate::wire::{
    ChannelMap, NetworkRef, NetworkRefKind, Observable, Observation, OpenSession, RecordTarget, SortedMap,
    StimulusKind, Text,
};
use ncp_kernel::is_duration;

/// The most neurons of a session: a request is no way to fill a server's memory.
const MAX_NEURONS: i64 = 100_000;
/// The most integration steps of a request.
const MAX_STEPS: f64 = 2e7;
/// The most samples that a request records.
const MAX_SAMPLES: f64 = 1e6;
/// The most neuron steps of a request, what records look at included: some seconds of work.
const MAX_WORK: f64 = 1e9;

/// Offers `ncp.reference.lif` and `ncp.reference.rate`.
#[derive(Debug, Clone, Default)]
pub struct ReferenceBackend;

impl SimulationBackend for ReferenceBackend {
    fn name(&self) -> &'static str {
        "ncp.reference"
    }

    fn open(&mut self, request: &OpenSession) -> Result<Opened, BackendError> {
        let network = Network::build(request)?;
        let resolved = network
            .populations
            .iter()
            .map(|population| (population.name.clone(), to_i64(population.neurons.len())))
            .collect();
        Ok(Opened { simulation: Box::new(network), resolved, seed: None })
    }
}

struct Network {
    model: Model,
    dt_ms: f64,
    steps: u64,
    populations: Vec<Population>,
    stimuli: Vec<Port>,
    records: Vec<Record>,
}

#[derive(Clone)]
struct Population {
    name: Text,
    neurons: Vec<Neuron>,
}

#[derive(Clone, Copy)]
struct Neuron {
    /// V_m in mV, or the rate in Hz.
    state: f64,
    /// Steps for which the neuron stays refractory.
    refractory: u64,
    /// The current in pA, or the input of a rate neuron, of each step.
    input: f64,
    spiked: bool,
}

/// The neurons of a port: a population and the indices within it. `[NCP-SESS-055]`
struct Port {
    name: Text,
    population: usize,
    neurons: Vec<usize>,
    /// What the port gives each of its neurons now.
    values: Vec<f64>,
}

struct Record {
    port: Port,
    target: RecordTarget,
    /// The cadence in steps.
    every: u64,
}

impl Record {
    fn new(port: Port, target: &RecordTarget, dt_ms: f64) -> Result<Self, BackendError> {
        let every = (target.cadence_ms / dt_ms).round().max(1.0);
        if !is_duration(target.cadence_ms) || !every.is_finite() {
            return Err(BackendError::Time { name: "cadence_ms", value_ms: target.cadence_ms });
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // 1 at least; so many steps never come
        Ok(Self { port, target: target.clone(), every: every as u64 })
    }

    /// Whether this step, counted from 1, reaches a multiple of the cadence. `[NCP-SESS-053]`
    fn is_due(&self, step: u64) -> bool {
        let reached = |step: u64| step / self.every;
        reached(step) > reached(step - 1)
    }

    fn is_of_spikes(&self) -> bool {
        self.target.observable == Observable::Spikes
    }

    /// The samples of `steps` steps behind `before` others; of spikes the most, in a network whose neurons rest for
    /// `rest` steps after one.
    #[expect(clippy::cast_precision_loss)] // steps stay far below 2^53, and a cadence beyond gives no sample
    fn most_samples(&self, before: f64, steps: f64, rest: f64) -> f64 {
        let times = if self.is_of_spikes() {
            (steps / (1.0 + rest) + 1.0).min(steps)
        } else {
            let every = self.every as f64;
            ((before + steps) / every).floor() - (before / every).floor()
        };
        times * count(self.port.neurons.len())
    }
}

enum Model {
    Lif { propagator: f64, rise: f64, gain: f64, e_l: f64, v_th: f64, v_reset: f64, i_e: f64, t_ref: u64 },
    Rate { propagator: f64, rise: f64, mu: f64 },
}

/// P = exp(−x) and 1 − P, which a difference of doubles would lose the digits of for a small x.
fn propagation(x: f64) -> (f64, f64) {
    ((-x).exp(), -(-x).exp_m1())
}

#[expect(clippy::cast_precision_loss)] // steps stay far below 2^53
fn count_of(steps: u64) -> f64 {
    steps as f64
}

impl Model {
    /// `[NCP-SESS-050] [NCP-SESS-051]`
    fn build(network: &NetworkRef, dt_ms: f64) -> Result<Self, BackendError> {
        let known: &[(&str, f64)] = match (&network.kind, network.reference.as_ref()) {
            (NetworkRefKind::Builtin, "ncp.reference.lif") => &[
                ("C_m", 250.0),
                ("tau_m", 10.0),
                ("E_L", -70.0),
                ("V_th", -55.0),
                ("V_reset", -70.0),
                ("t_ref", 2.0),
                ("I_e", 0.0),
            ],
            (NetworkRefKind::Builtin, "ncp.reference.rate") => &[("tau", 10.0), ("mu", 0.0)],
            (kind, reference) => {
                return Err(BackendError::UnknownNetwork {
                    kind: kind.as_str().to_owned(),
                    reference: reference.to_owned(),
                });
            }
        };
        let refuse = |name: &str, value| BackendError::Parameter { name: name.to_owned(), value };
        for (name, &value) in network.params.iter() {
            if !known.iter().any(|(known, _)| *known == name) {
                return Err(refuse(name, value));
            }
        }
        let param = |name: &str| {
            network
                .params
                .get(name)
                .copied()
                .or_else(|| known.iter().find(|(known, _)| *known == name).map(|(_, default)| *default))
        };
        let positive = |name| {
            let value = param(name).unwrap_or(f64::NAN);
            if is_duration(value) { Ok(value) } else { Err(refuse(name, value)) }
        };
        let plain = |name| param(name).unwrap_or(0.0);
        if network.reference == "ncp.reference.rate" {
            let tau = positive("tau")?;
            let (propagator, rise) = propagation(dt_ms / tau);
            return Ok(Self::Rate { propagator, rise, mu: plain("mu") });
        }
        let (tau, c_m) = (positive("tau_m")?, positive("C_m")?);
        let t_ref = plain("t_ref");
        let steps = (t_ref / dt_ms).round();
        if !(0.0..f64::INFINITY).contains(&steps) {
            return Err(refuse("t_ref", t_ref));
        }
        let (propagator, rise) = propagation(dt_ms / tau);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // more than any session runs is for ever
        Ok(Self::Lif {
            propagator,
            rise,
            gain: tau / c_m,
            e_l: plain("E_L"),
            v_th: plain("V_th"),
            v_reset: plain("V_reset"),
            i_e: plain("I_e"),
            t_ref: steps as u64,
        })
    }

    fn rest(&self) -> f64 {
        match self {
            Self::Lif { e_l, .. } => *e_l,
            Self::Rate { .. } => 0.0,
        }
    }

    /// For how many steps a neuron rests after a spike.
    #[expect(clippy::cast_precision_loss)] // it bounds a count of samples
    fn rest_steps(&self) -> f64 {
        match self {
            Self::Lif { t_ref, .. } => *t_ref as f64,
            Self::Rate { .. } => 0.0,
        }
    }

    fn step(&self, neuron: &mut Neuron) {
        neuron.spiked = false;
        match *self {
            Self::Rate { propagator, rise, mu } => {
                neuron.state = neuron.state * propagator + (mu + neuron.input) * rise;
            }
            Self::Lif { v_reset, .. } if neuron.refractory > 0 => {
                neuron.refractory -= 1;
                neuron.state = v_reset;
            }
            Self::Lif { propagator, rise, gain, e_l, v_th, v_reset, i_e, t_ref } => {
                neuron.state = e_l + (neuron.state - e_l) * propagator + (i_e + neuron.input) * gain * rise;
                // What left the doubles is no spike. [NCP-SESS-057]
                if neuron.state >= v_th && neuron.state.is_finite() {
                    neuron.spiked = true;
                    neuron.state = v_reset;
                    neuron.refractory = t_ref;
                }
            }
        }
    }

    fn records(&self, observable: &Observable) -> bool {
        match self {
            Self::Lif { .. } => matches!(observable, Observable::Vm | Observable::Spikes),
            Self::Rate { .. } => matches!(observable, Observable::Rate),
        }
    }

    fn takes(&self, kind: &StimulusKind) -> bool {
        match self {
            Self::Lif { .. } => matches!(kind, StimulusKind::CurrentPa),
            Self::Rate { .. } => matches!(kind, StimulusKind::RateInject),
        }
    }
}

impl Network {
    /// `[NCP-SESS-060]`
    fn build(request: &OpenSession) -> Result<Self, BackendError> {
        let dt_ms = request.sim.dt_ms;
        if !is_duration(dt_ms) {
            return Err(BackendError::Time { name: "dt_ms", value_ms: dt_ms });
        }
        // A chunk of no time is one: its requests come to no step.
        if !(request.sim.chunk_ms.is_finite() && request.sim.chunk_ms >= 0.0) {
            return Err(BackendError::Time { name: "chunk_ms", value_ms: request.sim.chunk_ms });
        }
        let model = Model::build(&request.network, dt_ms)?;
        let rest = Neuron { state: model.rest(), refractory: 0, input: 0.0, spiked: false };
        let mut populations = Vec::new();
        let mut room = MAX_NEURONS;
        for (name, &size) in request.network.population_sizes.iter() {
            let neurons = usize::try_from(size)
                .ok()
                .filter(|_| size <= room)
                .ok_or_else(|| BackendError::PopulationSize { name: name.to_owned(), size })?;
            room -= size;
            populations.push(Population { name: name.to_owned().into(), neurons: vec![rest; neurons] });
        }
        let mut network = Self { model, dt_ms, steps: 0, populations, stimuli: Vec::new(), records: Vec::new() };
        for target in &request.stimulus.targets {
            if !network.model.takes(&target.kind) {
                return Err(unsupported(&target.port, target.kind.as_str()));
            }
            if network.stimuli.iter().any(|other| other.name == target.port) {
                return Err(BackendError::PortTwice { port: target.port.to_string() });
            }
            let port = network.port(&target.port, &target.target, &target.ids)?;
            network.stimuli.push(port);
        }
        for target in &request.record.targets {
            if !network.model.records(&target.observable) {
                return Err(unsupported(&target.port, target.observable.as_str()));
            }
            if network.records.iter().any(|other| other.port.name == target.port) {
                return Err(BackendError::PortTwice { port: target.port.to_string() });
            }
            let port = network.port(&target.port, &target.target, &target.ids)?;
            network.records.push(Record::new(port, target, dt_ms)?);
        }
        Ok(network)
    }

    /// Ids count from 1 within a population. `[NCP-SESS-052]`
    fn port(&self, name: &Text, target: &str, ids: &[i64]) -> Result<Port, BackendError> {
        let named = |(_, population): &(usize, &Population)| population.name == target;
        let (population, neurons) = self
            .populations
            .iter()
            .enumerate()
            .find(named)
            .map(|(at, population)| (at, population.neurons.len()))
            .ok_or_else(|| BackendError::UnknownTarget { port: name.to_string(), target: target.to_owned() })?;
        let neurons = if ids.is_empty() {
            (0..neurons).collect()
        } else {
            ids.iter()
                .map(|&id| {
                    usize::try_from(id.saturating_sub(1))
                        .ok()
                        .filter(|&at| at < neurons)
                        .ok_or_else(|| BackendError::UnknownNeuron { port: name.to_string(), id })
                })
                .collect::<Result<Vec<_>, _>>()?
        };
        let values = vec![0.0; neurons.len()];
        Ok(Port { name: name.clone(), population, neurons, values })
    }

    /// What all ports together give each neuron.
    fn apply_stimuli(&mut self) {
        for population in &mut self.populations {
            for neuron in &mut population.neurons {
                neuron.input = 0.0;
            }
        }
        for port in &self.stimuli {
            let Some(population) = self.populations.get_mut(port.population) else {
                continue;
            };
            for (at, value) in port.neurons.iter().zip(&port.values) {
                if let Some(neuron) = population.neurons.get_mut(*at) {
                    neuron.input += value;
                }
            }
        }
    }

    /// How many steps a request makes. `[NCP-SESS-058]`
    fn steps_of(&self, advance_ms: f64) -> f64 {
        (advance_ms / self.dt_ms).round()
    }

    fn is_within_doubles(&self) -> bool {
        let mut neurons = self.populations.iter().flat_map(|p| &p.neurons);
        neurons.all(|neuron| neuron.state.is_finite())
    }

    fn time_of(&self, step: u64) -> f64 {
        count_of(step) * self.dt_ms
    }
}

impl Simulation for Network {
    fn stimulate(&mut self, values: &ChannelMap) -> Result<(), BackendError> {
        let mut changed = Vec::with_capacity(values.len());
        for (name, value) in values.iter() {
            let at = self
                .stimuli
                .iter()
                .position(|port| port.name == name)
                .ok_or_else(|| BackendError::UnknownPort { port: name.to_owned() })?;
            let expected = self.stimuli.get(at).map_or(0, |port| port.neurons.len());
            let per_neuron = match value.data.as_slice() {
                [one] => vec![*one; expected],
                many if many.len() == expected => many.to_vec(),
                many => {
                    return Err(BackendError::StimulusWidth { port: name.to_owned(), expected, found: many.len() });
                }
            };
            changed.push((at, per_neuron));
        }
        for (at, per_neuron) in changed {
            if let Some(port) = self.stimuli.get_mut(at) {
                port.values = per_neuron;
            }
        }
        self.apply_stimuli();
        Ok(())
    }

    fn check_advance(&self, advance_ms: f64) -> Result<(), BackendError> {
        let steps = self.steps_of(advance_ms);
        let neurons: f64 = self.populations.iter().map(|p| count(p.neurons.len())).sum();
        let watched: f64 = self.records.iter().map(|r| count(r.port.neurons.len())).sum();
        let rest = self.model.rest_steps();
        let before = count_of(self.steps);
        let samples: f64 = self.records.iter().map(|r| r.most_samples(before, steps, rest)).sum();
        let can = advance_ms >= 0.0
            && steps <= MAX_STEPS
            && steps * (neurons + watched) <= MAX_WORK
            && samples <= MAX_SAMPLES;
        if !can {
            return Err(BackendError::Time { name: "advance_ms", value_ms: advance_ms });
        }
        // [NCP-SESS-057]
        if ((before + steps) * self.dt_ms).is_finite() { Ok(()) } else { Err(BackendError::Overflow) }
    }

    fn advance(&mut self, advance_ms: f64) -> Result<SortedMap<Observation>, BackendError> {
        self.check_advance(advance_ms)?;
        let before = (self.populations.clone(), self.steps);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // within 0 and 2e7
        let steps_now = self.steps_of(advance_ms) as u64;
        let mut observations: Vec<Observation> =
            self.records.iter().map(|record| empty_observation(&record.target)).collect();
        for _ in 0..steps_now {
            for population in &mut self.populations {
                for neuron in &mut population.neurons {
                    self.model.step(neuron);
                }
            }
            if !self.is_within_doubles() {
                (self.populations, self.steps) = before; // [NCP-SESS-057]
                return Err(BackendError::Overflow);
            }
            self.steps += 1;
            let time_ms = self.time_of(self.steps);
            for (record, observation) in self.records.iter().zip(&mut observations) {
                let Some(population) = self.populations.get(record.port.population) else {
                    continue;
                };
                let spikes = record.is_of_spikes();
                if !spikes && !record.is_due(self.steps) {
                    continue; // [NCP-SESS-053]
                }
                for &at in &record.port.neurons {
                    let Some(neuron) = population.neurons.get(at) else {
                        continue;
                    };
                    if spikes && !neuron.spiked {
                        continue;
                    }
                    observation.times.push(time_ms);
                    observation.senders.push(to_i64(at + 1));
                    if !spikes {
                        observation.values.push(neuron.state);
                    }
                }
            }
        }
        // [NCP-SESS-038]
        Ok(self
            .records
            .iter()
            .zip(observations)
            .map(|(record, observation)| (record.port.name.clone(), observation))
            .collect())
    }

    fn time_ms(&self) -> f64 {
        self.time_of(self.steps)
    }
}

/// `[NCP-SESS-056]`
fn empty_observation(target: &RecordTarget) -> Observation {
    let (unit, recordable) = match target.observable {
        Observable::Vm => (Some(Text::Borrowed("mV")), Some(Text::Borrowed("V_m"))),
        Observable::Rate => (Some(Text::Borrowed("Hz")), Some(Text::Borrowed("rate"))),
        _ => (None, None),
    };
    Observation {
        port: target.port.clone(),
        target: target.target.clone(),
        observable: target.observable.clone(),
        unit,
        recordable,
        ..Observation::default()
    }
}

fn unsupported(port: &str, what: &str) -> BackendError {
    BackendError::Unsupported { port: port.to_owned(), what: what.to_owned() }
}

#[expect(clippy::cast_precision_loss)] // far below 2^53
fn count(items: usize) -> f64 {
    items as f64
}

fn to_i64(count: usize) -> i64 {
    i64::try_from(count).unwrap_or(i64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::session::SessionService;
    use crate::wire::{
        ChannelValue, Frame, Message, RecordSpec, RunRequest, StimulusFrame, StimulusSpec, StimulusTarget, decode_any,
    };

    /// Neurons of `reference`, each observable recorded with its cadence in ms.
    fn session(reference: &'static str, neurons: i64, records: &[(Observable, f64)]) -> OpenSession {
        let targets = records
            .iter()
            .map(|(observable, cadence_ms)| RecordTarget {
                port: observable.as_str().to_owned().into(),
                target: "p".into(),
                observable: observable.clone(),
                cadence_ms: *cadence_ms,
                ..RecordTarget::default()
            })
            .collect();
        OpenSession {
            session_id: "s".into(),
            network: NetworkRef {
                reference: reference.into(),
                population_sizes: SortedMap::from_iter([("p", neurons)]),
                ..NetworkRef::default()
            },
            record: RecordSpec { targets },
            stimulus: StimulusSpec {
                targets: vec![StimulusTarget { port: "i".into(), target: "p".into(), ..StimulusTarget::default() }],
            },
            ..OpenSession::default()
        }
    }

    fn network(request: &OpenSession) -> Network {
        Network::build(request).unwrap()
    }

    /// The times of a port, in steps of 0.1 ms.
    fn times(observations: &SortedMap<Observation>, port: &str) -> Vec<i64> {
        let in_steps = |t: &f64| (t * 10.0).round() as i64;
        observations[port].times.iter().map(in_steps).collect()
    }

    /// [NCP-SESS-053] 0.3 / 0.1 is not 3 in doubles, and 0.25 / 0.1 is 2.5.
    #[test]
    fn a_cadence_is_the_nearest_number_of_steps_and_one_at_least() {
        for (cadence_ms, every) in [
            (0.1, 1),
            (5e-324, 1),
            (0.04, 1),
            (0.14, 1),
            (0.16, 2),
            (0.24, 2),
            (0.25, 3),
            (0.3, 3),
            (0.34, 3),
            (0.36, 4),
        ] {
            let mut network = network(&session("ncp.reference.lif", 1, &[(Observable::Vm, cadence_ms)]));
            let mut sampled = times(&network.advance(1_000.0).unwrap(), "V_m");
            sampled.extend(times(&network.advance(1.0).unwrap(), "V_m"));
            assert!(sampled.iter().copied().eq((every..=10_010).step_by(every as usize)), "{cadence_ms}");
        }
    }

    /// [NCP-SESS-058] Nothing is left over for the next request.
    #[test]
    fn a_duration_is_the_nearest_number_of_steps() {
        for (duration_ms, steps) in [
            (0.04, 0),
            (0.05, 1),
            (0.1, 1),
            (0.14, 1),
            (0.15, 1), // 1.4999999999999998 steps
            (0.25, 3),
            (0.3, 3),
            (0.34, 3),
            (0.45, 5),
        ] {
            let mut network = network(&session("ncp.reference.lif", 1, &[(Observable::Vm, 0.1)]));
            for nth in 1..=40 {
                let sampled = times(&network.advance(duration_ms).unwrap(), "V_m");
                assert!(sampled.iter().copied().eq((nth - 1) * steps + 1..=nth * steps), "{duration_ms}: {sampled:?}");
                assert_eq!(network.time_ms(), (nth * steps) as f64 * 0.1);
            }
        }
    }

    #[test]
    fn a_cadence_that_is_no_time_is_refused() {
        for cadence_ms in [0.0, -1.0, f64::NAN, f64::INFINITY, 5e-324, f64::MAX] {
            let request = session("ncp.reference.lif", 1, &[(Observable::Vm, cadence_ms)]);
            let refused = matches!(Network::build(&request), Err(BackendError::Time { name: "cadence_ms", .. }));
            // The least double is a cadence; the largest is no number of steps.
            assert_eq!(refused, cadence_ms != 5e-324, "{cadence_ms}");
        }
    }

    /// [NCP-SESS-037] A stimulus of a request that cannot be run is not left behind.
    #[test]
    fn a_request_that_fails_leaves_its_stimulus_out() {
        let mut service = SessionService::new(ReferenceBackend);
        let request = session("ncp.reference.lif", 1, &[(Observable::Vm, 1.0)]);
        service.serve(request.encode().unwrap().as_bytes());
        for duration_ms in [-1.0, 1e300, 1e9] {
            let run = RunRequest {
                session_id: "s".into(),
                duration_ms,
                stimulus: Some(StimulusFrame {
                    session_id: "s".into(),
                    values: ChannelMap::from_iter([("i", ChannelValue::new([900.0], "pA"))]),
                    ..StimulusFrame::default()
                }),
                ..RunRequest::default()
            };
            let reply = service.serve(run.encode().unwrap().as_bytes());
            assert!(matches!(decode_any(reply.as_bytes()), Ok(Message::Error(_))), "{duration_ms}");
        }
        let run = RunRequest { session_id: "s".into(), duration_ms: 5.0, ..RunRequest::default() };
        let reply = service.serve(run.encode().unwrap().as_bytes());
        let Ok(Message::ObservationFrame(frame)) = decode_any(reply.as_bytes()) else {
            panic!("{reply}");
        };
        assert_eq!((frame.seq, frame.sim_time_ms), (1, 5.0));
        assert_eq!(frame.records["V_m"].values, [-70.0; 5]);
    }

    /// A request may not fill the server's memory with spikes, whatever the cadence says, nor keep it
    /// busy for hours.
    #[test]
    fn a_request_of_too_many_samples_or_too_much_work_is_refused_at_once() {
        let mut rested = session("ncp.reference.lif", 1_000, &[(Observable::Spikes, 1e6)]);
        rested.network.params.extend([("I_e", 1e9), ("t_ref", 0.0)]);
        // Every neuron spikes in every step: 1,000 steps are a million spikes.
        assert!(network(&rested).check_advance(100.0).is_ok());
        assert!(network(&rested).check_advance(100.1).is_err());
        let spikes = network(&rested).advance(1.0).unwrap();
        assert_eq!(spikes["spikes"].times.len(), 10_000);

        let busy = session("ncp.reference.rate", 100_000, &[]);
        assert!(
            network(&OpenSession { stimulus: StimulusSpec::default(), ..busy.clone() }).check_advance(1_000.0).is_ok()
        );
        assert!(network(&OpenSession { stimulus: StimulusSpec::default(), ..busy }).check_advance(1_000.1).is_err());
    }

    /// A sample is one by the cadence: what is not due in a request costs it nothing.
    #[test]
    fn as_many_samples_as_a_server_bears_are_counted_by_the_cadence_since_the_opening() {
        let mut network = network(&session("ncp.reference.lif", 100_000, &[(Observable::Vm, 1.0)]));
        assert!(network.check_advance(10.9).is_ok(), "ten samples of 100,000 neurons in 109 steps");
        assert!(network.check_advance(11.0).is_err(), "eleven in 110");
        network.advance(0.5).unwrap();
        assert!(network.check_advance(10.4).is_ok(), "ten from step 5 to 109");
        assert!(network.check_advance(10.5).is_err(), "eleven from step 5 to 110");
    }
}
