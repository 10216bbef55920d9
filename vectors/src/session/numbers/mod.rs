//! The reference networks against their own closed solutions.

mod neurons;
mod ports;
mod sessions;
mod stimuli;
mod time;

use super::{observed, step};
use crate::case::{Case, File};
use crate::json::{Json, object};
use crate::trace::{nums, within};

pub(super) fn file() -> File {
    let mut cases = neurons::potentials();
    cases.extend(neurons::thresholds());
    cases.extend(neurons::spikes());
    cases.extend(neurons::spikes_apart());
    cases.extend(neurons::rests());
    cases.extend(neurons::rates());
    cases.extend(stimuli::stimuli());
    cases.push(sessions::same_values());
    cases.extend(sessions::swapped());
    cases.push(sessions::own_input());
    cases.extend(stimuli::lasting());
    cases.extend(stimuli::reach());
    cases.extend(stimuli::neurons_by_bits());
    cases.extend(ports::shared_names());
    cases.extend(ports::units());
    cases.extend(ports::ports());
    cases.extend(ports::many_ports());
    cases.extend(ports::cadences());
    cases.extend(sessions::refusals());
    cases.extend(time::durations());
    cases.extend(ports::orders());
    cases.extend(ports::orders_of_ports());
    cases.extend(ports::nearly_ranges());
    cases.extend(stimuli::sums());
    cases.extend(far());
    cases.extend(neurons::near());
    cases.extend(neurons::slow());
    cases.extend(sessions::alike());
    cases.extend(sessions::reopened());
    cases.extend(ports::beyond_32_bits());
    cases.extend(sessions::much_at_once());
    cases.extend(ports::no_neurons());
    cases.extend(ports::empty_names());
    cases.extend(ports::many_named());
    cases.extend(time::failures_behind_many_steps());
    cases.extend(sessions::failures_at_rest());
    cases.extend(sessions::large_together());
    cases.extend(time::exact_times());
    cases.extend(ports::own_ports());
    cases.extend(sessions::announced());
    cases.extend(neurons::rounded_rests());
    cases.extend(ports::of_no_step());
    cases.extend(ports::own_neurons());
    cases.extend(ports::joined_names());
    cases.extend(ports::many_cadences());
    cases.extend(ports::many_by_turns());
    cases.extend(stimuli::apart_then_alike());
    cases.extend(neurons::tiny());
    cases.extend(time::short_steps());
    cases.extend(time::long_steps());
    cases.extend(sessions::one_name_both_ways());
    cases.extend(sessions::ids_within());
    cases.extend(stimuli::nearly_runs());
    cases.extend(sessions::of_all_names());
    cases.extend(sessions::opened_otherwise());
    cases.extend(sessions::room());
    let about = "The numbers of the reference networks: membrane potentials, spikes and rates by exact propagation.";
    File::new("session", "reference", about, cases)
}

const WHY: &str =
    "Section 4.4: exact propagation on the grid of `dt_ms`; asked of servers that claim the reference networks.";

/// A leaky integrate-and-fire neuron, as section 4.4 writes it.
pub(super) struct Lif {
    pub(super) v: f64,
    resting: u32,
    propagator: f64,
    gain: f64,
    e_l: f64,
    v_th: f64,
    v_reset: f64,
    refractory: u32,
}

impl Lif {
    pub(super) fn new(params: &[(&str, f64)], dt: f64) -> Self {
        let param = |name: &str, default: f64| {
            params.iter().find(|(known, _)| *known == name).map_or(default, |(_, value)| *value)
        };
        let tau = param("tau_m", 10.0);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a handful of steps")]
        let refractory = (param("t_ref", 2.0) / dt).round() as u32;
        Self {
            v: param("E_L", -70.0),
            resting: 0,
            propagator: (-dt / tau).exp(),
            gain: tau / param("C_m", 250.0),
            e_l: param("E_L", -70.0),
            v_th: param("V_th", -55.0),
            v_reset: param("V_reset", -70.0),
            refractory,
        }
    }

    /// One step under a current; whether it spikes.
    pub(super) fn step(&mut self, current: f64) -> bool {
        if self.resting > 0 {
            self.resting -= 1;
            self.v = self.v_reset;
            return false;
        }
        self.v = self.e_l + (self.v - self.e_l) * self.propagator + current * self.gain * (1.0 - self.propagator);
        let spikes = self.v >= self.v_th;
        if spikes {
            self.v = self.v_reset;
            self.resting = self.refractory;
        }
        spikes
    }
}

/// The observation of one neuron, but for its id.
fn samples(times: &[f64], values: Option<&[f64]>) -> Json {
    object! { "times" => nums(times), "values" => nums(values.unwrap_or_default()) }
}

/// How often, and from whom.
fn sent(times: &[f64], senders: &[u32]) -> Json {
    object! { "times" => nums(times), "senders" => senders.iter().copied().collect::<Json>() }
}

/// A neuron run by the model: times and potentials at each step, and the times of its spikes.
pub(super) fn simulate(params: &[(&str, f64)], dt: f64, steps: u32, current: f64) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
    let mut neuron = Lif::new(params, dt);
    let (mut times, mut values, mut spikes) = (Vec::new(), Vec::new(), Vec::new());
    for nth in 1..=steps {
        let time = f64::from(nth) * dt;
        if neuron.step(current) {
            spikes.push(time);
        }
        times.push(time);
        values.push(neuron.v);
    }
    (times, values, spikes)
}

type Params = Vec<(&'static str, f64)>;

/// A step with values for several ports.
pub(super) fn driven_step(id: &str, advance: f64, values: &[(&str, f64)]) -> String {
    let request = Json::read(&step(id, Some(advance), None));
    if values.is_empty() {
        return request.text();
    }
    let value = |(port, value): &(&str, f64)| ((*port).to_owned(), object! { "data" => nums(&[*value]) });
    let values = Json::Object(values.iter().map(value).collect());
    request.with("stimulus", object! { "values" => values }).text()
}

/// Steps and neurons beyond the ends of small integers.
fn far() -> Vec<Case> {
    let mut cases = time::far_times();
    cases.push(ports::many_samples());
    cases.extend(ports::far_samples());
    cases.extend(neurons::far_spikes());
    cases.push(neurons::many_spikes());
    cases.extend(neurons::late_rests());
    cases.push(neurons::rests_beside());
    cases.extend(stimuli::far_neurons());
    cases
}

/// An observation of the session at a time, with these records.
fn recorded_at(id: &str, time: f64, records: Json) -> Json {
    observed(id, time).edit(&["$json"], |reply| reply.with("records", records))
}

/// A number that is right to a relative error of 1e-9, also where it is next to 0.
fn near_to(value: f64) -> Json {
    let error = value.abs() * 1e-9;
    within(value - error, value + error)
}

/// The samples of one neuron whose times and values are told from 0 however small they are.
fn small_samples(times: &[f64], values: &[f64]) -> Json {
    let all = |of: &[f64]| of.iter().copied().map(near_to).collect::<Json>();
    object! { "times" => all(times), "values" => all(values) }
}
