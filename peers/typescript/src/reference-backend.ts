/**
 * The reference backend: two small built-in networks, integrated exactly, so that servers can be compared
 * by their numbers (chapter 4.4).
 *
 * @module
 */

import { SessionError } from "./errors.js";
import type {
  ChannelValue,
  Observation,
  OpenSession,
  RecordTarget,
  SimProvenance,
  StimulusTarget,
} from "./messages.js";
import { LifNeurons, RateNeurons, stepsOf, type Neurons } from "./reference-neurons.js";
import type { Backend, Simulation } from "./session-service.js";

/** Offers `ncp.reference.lif` and `ncp.reference.rate`. */
export class ReferenceBackend implements Backend {
  readonly name = "ncp.reference";

  /** [NCP-SESS-060] */
  open(request: OpenSession): Simulation {
    return new ReferenceSimulation(request);
  }
}

/** What a network is made of, and what it can be driven by and tell. */
interface Model {
  readonly neurons: typeof LifNeurons | typeof RateNeurons;
  /** The stimulus kind that it takes, and its unit, if it has one. */
  readonly stimulus: { readonly kind: string; readonly unit: string | null };
  /** The quantities that it records, by observable. */
  readonly records: ReadonlyMap<string, Quantity>;
}

interface Quantity {
  readonly unit: string | null;
  /** The simulator's name; `null` for spikes, which are no sampled quantity. */
  readonly recordable: string | null;
}

const MODELS: ReadonlyMap<string, Model> = new Map<string, Model>([
  [
    "ncp.reference.lif",
    {
      neurons: LifNeurons,
      stimulus: { kind: "current_pA", unit: "pA" },
      records: new Map([
        ["V_m", { unit: "mV", recordable: "V_m" }],
        ["spikes", { unit: null, recordable: null }],
      ]),
    },
  ],
  [
    "ncp.reference.rate",
    {
      neurons: RateNeurons,
      stimulus: { kind: "rate_inject", unit: null },
      records: new Map([["rate", { unit: "Hz", recordable: "rate" }]]),
    },
  ],
]);

class ReferenceSimulation implements Simulation {
  readonly resolved: ReadonlyMap<string, number>;
  readonly provenance: Partial<SimProvenance>;

  readonly #dtMs: number;
  readonly #populations: ReadonlyMap<string, Neurons>;
  readonly #inputs: ReadonlyMap<string, InputPort>;
  readonly #records: readonly RecordPort[];
  readonly #size: number;
  /** Steps that were done. */
  #step = 0;

  constructor({ network, record, stimulus, sim }: OpenSession) {
    const model = network.kind === "builtin" ? MODELS.get(network.ref) : undefined;
    if (model === undefined) throw new SessionError(`there is no network ${network.kind} ${network.ref}`);
    if (!(sim.dt_ms > 0)) throw new SessionError(`dt_ms is ${sim.dt_ms}`);
    this.#dtMs = sim.dt_ms;
    this.#size = sizeOf(network.population_sizes);
    this.#populations = new Map(
      Array.from(network.population_sizes, ([name, size]) => [
        name,
        new model.neurons(size, sim.dt_ms, network.params),
      ]),
    );
    const populationOf = (target: string): Neurons => {
      const neurons = this.#populations.get(target);
      if (neurons === undefined) throw new SessionError(`there is no population ${target}`);
      return neurons;
    };
    this.#inputs = new Map(stimulus.targets.map((target) => inputOf(target, model, populationOf(target.target))));
    if (this.#inputs.size < stimulus.targets.length) throw new SessionError("two stimulus targets have one port");
    this.#records = record.targets.map(
      (target) => new RecordPort(target, model, populationOf(target.target), sim.dt_ms),
    );
    if (new Set(record.targets.map(({ port }) => port)).size < record.targets.length) {
      throw new SessionError("two record targets have one port");
    }
    this.resolved = network.population_sizes;
    this.provenance = {
      network_ref: network.ref,
      backend: "ncp.reference",
      seed: sim.seed,
      note: "Raw output of a specified model, integrated exactly and without random numbers.",
    };
  }

  get timeMs(): number {
    return this.#step * this.#dtMs; // [NCP-SESS-033]
  }

  advance(forMs: number, stimulus: ReadonlyMap<string, ChannelValue>): Map<string, Observation> {
    const steps = stepsOf(forMs, this.#dtMs); // [NCP-SESS-058]
    if (!(steps * Math.max(this.#size, 1) <= WORK)) throw new SessionError(`${forMs} ms is too long for one request`);
    let samples = 0;
    for (const record of this.#records) samples += record.mostSamples(this.#step, steps);
    if (!(samples <= SAMPLES)) throw new SessionError(`${forMs} ms gives too many samples for one reply`);
    // [NCP-SESS-057]
    if (!Number.isFinite((this.#step + steps) * this.#dtMs)) throw new SessionError("the time leaves the doubles");
    const values = Array.from(stimulus, ([port, value]) => this.#valueFor(port, value));

    // From here on only a number that leaves the doubles is refused. [NCP-SESS-054]
    for (const [port, value] of values) port.set(value);
    const stepBefore = this.#step;
    const before = Array.from(this.#populations.values(), (neurons) => neurons.save());
    for (let n = 0; n < steps; n++) {
      this.#step++;
      for (const neurons of this.#populations.values()) neurons.step();
      if (!this.#isWithinDoubles()) {
        for (const restore of before) restore(); // [NCP-SESS-057]
        for (const record of this.#records) record.take();
        this.#step = stepBefore;
        throw new SessionError("a number of the network leaves the doubles");
      }
      for (const record of this.#records) record.sample(this.#step);
    }
    return new Map(this.#records.map((record) => [record.port, record.take()])); // [NCP-SESS-038]
  }

  #isWithinDoubles(): boolean {
    for (const { state } of this.#populations.values()) if (!state.every(Number.isFinite)) return false;
    return true;
  }

  #valueFor(name: string, { data, unit }: ChannelValue): [InputPort, number] {
    const port = this.#inputs.get(name);
    if (port === undefined) throw new SessionError(`there is no stimulus port ${name}`);
    if (data.length !== 1) throw new SessionError(`the port ${name} takes one value`);
    if (unit !== null && port.unit !== null && unit !== port.unit) {
      throw new SessionError(`the port ${name} takes ${port.unit}`);
    }
    return [port, data[0]!];
  }
}

/** A stimulus port: one value into each of its neurons. [NCP-SESS-055] */
class InputPort {
  readonly unit: string | null;
  readonly #neurons: Neurons;
  readonly #indices: readonly number[];
  readonly #source: number;

  constructor(unit: string | null, neurons: Neurons, indices: readonly number[]) {
    this.unit = unit;
    this.#neurons = neurons;
    this.#indices = indices;
    this.#source = neurons.newSource();
  }

  set(value: number): void {
    this.#neurons.drive(this.#source, this.#indices, value);
  }
}

/** A port that is recorded, and its samples since they were taken last. */
class RecordPort {
  readonly port: string;
  readonly #target: RecordTarget;
  readonly #quantity: Quantity;
  readonly #neurons: Neurons;
  readonly #indices: readonly number[];
  readonly #dtMs: number;
  /** The cadence in steps. */
  readonly #every: number;
  #times: number[] = [];
  #values: number[] = [];
  #senders: number[] = [];

  constructor(target: RecordTarget, model: Model, neurons: Neurons, dtMs: number) {
    const { port, observable, recordables, cadence_ms } = target;
    const quantity = model.records.get(observable);
    if (quantity === undefined) throw new SessionError(`the network does not record ${observable}`);
    const stranger = recordables.find((name) => name !== quantity.recordable);
    if (stranger !== undefined) throw new SessionError(`${observable} has no recordable ${stranger}`);
    if (!(cadence_ms > 0)) throw new SessionError(`cadence_ms is ${cadence_ms}`);
    this.port = port;
    this.#target = target;
    this.#quantity = quantity;
    this.#neurons = neurons;
    this.#indices = indicesOf(target.ids, neurons);
    this.#dtMs = dtMs;
    this.#every = Math.max(stepsOf(cadence_ms, dtMs), 1);
  }

  /** The samples that so many steps give behind those before them; of spikes the most. */
  mostSamples(before: number, steps: number): number {
    const reached = (step: number): number => Math.floor(step / this.#every);
    const times =
      this.#quantity.recordable === null
        ? Math.min(steps, 1 + Math.floor(steps / this.#neurons.stepsBetweenSpikes))
        : reached(before + steps) - reached(before);
    return times * this.#indices.length;
  }

  /** Samples the end of a step, if it is due. */
  sample(step: number): void {
    const timeMs = step * this.#dtMs;
    if (this.#quantity.recordable === null) {
      for (const index of this.#indices) if (this.#neurons.spiked[index] === 1) this.#add(timeMs, index);
      return;
    }
    if (step % this.#every !== 0) return; // [NCP-SESS-053]
    for (const index of this.#indices) {
      this.#add(timeMs, index);
      this.#values.push(this.#neurons.state[index]!);
    }
  }

  /** The observation of all samples since the last call, with its unit. [NCP-SESS-056] */
  take(): Observation {
    const { port, target, observable } = this.#target;
    const observation = {
      port,
      target,
      observable,
      times: Float64Array.from(this.#times),
      values: Float64Array.from(this.#values),
      senders: Float64Array.from(this.#senders),
      ...this.#quantity,
    };
    this.#times = [];
    this.#values = [];
    this.#senders = [];
    return observation;
  }

  #add(timeMs: number, index: number): void {
    this.#times.push(timeMs);
    this.#senders.push(index + 1); // [NCP-SESS-052]
  }
}

function inputOf({ port, kind, ids }: StimulusTarget, model: Model, neurons: Neurons): [string, InputPort] {
  if (kind !== model.stimulus.kind) throw new SessionError(`the network is not driven by ${kind}`);
  return [port, new InputPort(model.stimulus.unit, neurons, indicesOf(ids, neurons))];
}

/** The neurons that the ids name, from 1; all when there are none. [NCP-SESS-052] */
function indicesOf(ids: Float64Array, neurons: Neurons): number[] {
  if (ids.length === 0) return Array.from({ length: neurons.size }, (_, index) => index);
  return Array.from(ids, (id) => {
    if (id < 1 || id > neurons.size) throw new SessionError(`there is no neuron ${id} of ${neurons.size}`);
    return id - 1;
  });
}

/** The neurons of all populations. */
function sizeOf(populations: ReadonlyMap<string, number>): number {
  let size = 0;
  for (const [name, neurons] of populations) {
    if (neurons < 0) throw new SessionError(`the population ${name} has ${neurons} neurons`);
    size += neurons;
  }
  if (size > NEURONS) throw new SessionError(`${size} neurons are too many`);
  return size;
}

/** Neurons of a session. */
const NEURONS = 1_000_000;
/** Steps times neurons of one request: some seconds at most. */
const WORK = 100_000_000;
/** Samples of one reply, so that it fits into a frame. */
const SAMPLES = 1_000_000;
