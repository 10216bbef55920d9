/**
 * The neurons of the reference backend, on the grid of `dt_ms` (chapter 4.4).
 *
 * @module
 */

import { SessionError } from "./errors.js";

/** The number of steps nearest to a time, the greater of two that are equally near. */
export function stepsOf(timeMs: number, dtMs: number): number {
  return Math.round(timeMs / dtMs);
}

/** One population of equal neurons. */
export abstract class Neurons {
  readonly size: number;
  /** The quantity that is sampled, of each neuron. */
  readonly state: Float64Array;
  /** 1 for each neuron that spiked at the end of the last step. */
  readonly spiked: Uint8Array;
  /** The sum of the stimuli of each neuron. */
  protected readonly input: Float64Array;
  /** What each source drives, and by how much. */
  readonly #drives: { indices: readonly number[]; value: number }[] = [];

  protected constructor(size: number, begin: number) {
    this.size = size;
    this.state = new Float64Array(size).fill(begin);
    this.spiked = new Uint8Array(size);
    this.input = new Float64Array(size);
  }

  /** The steps from one spike of a neuron to its next, at least. */
  abstract readonly stepsBetweenSpikes: number;

  /** Integrates one step. */
  abstract step(): void;

  /** What brings the neurons back to where they are now. */
  save(): () => void {
    const state = this.state.slice();
    const spiked = this.spiked.slice();
    return () => {
      this.state.set(state);
      this.spiked.set(spiked);
    };
  }

  /** A new source of input, which drives nothing yet. */
  newSource(): number {
    return this.#drives.push({ indices: [], value: 0 }) - 1;
  }

  /** Sets what a source drives its neurons by from now on. Sources add up. */
  drive(source: number, indices: readonly number[], value: number): void {
    this.#drives[source] = { indices, value };
    // Summed up anew, so that no rounding error stays when a value goes.
    this.input.fill(0);
    for (const drive of this.#drives) {
      for (const index of drive.indices) this.input[index]! += drive.value;
    }
  }
}

/** Leaky integrate-and-fire neurons; the state is V in mV, the input a current in pA. [NCP-SESS-050] */
export class LifNeurons extends Neurons {
  readonly stepsBetweenSpikes: number;
  readonly #decay: number;
  readonly #drift: number;
  readonly #rest: number;
  readonly #threshold: number;
  readonly #reset: number;
  readonly #current: number;
  readonly #refractorySteps: number;
  /** The steps for which each neuron is still refractory. */
  readonly #refractory: Float64Array;

  /** @throws {@link SessionError} when a parameter is not one */
  constructor(size: number, dtMs: number, given: ReadonlyMap<string, number>) {
    const params = { C_m: 250, tau_m: 10, E_L: -70, V_th: -55, V_reset: -70, t_ref: 2, I_e: 0 };
    setParams(params, given);
    checkPositive(params, "C_m", "tau_m");
    if (params.t_ref < 0) throw new SessionError(`t_ref is ${params.t_ref}`);
    super(size, params.E_L);
    this.#decay = Math.exp(-dtMs / params.tau_m);
    this.#drift = (params.tau_m / params.C_m) * -Math.expm1(-dtMs / params.tau_m);
    this.#rest = params.E_L;
    this.#threshold = params.V_th;
    this.#reset = params.V_reset;
    this.#current = params.I_e;
    this.#refractorySteps = stepsOf(params.t_ref, dtMs);
    this.#refractory = new Float64Array(size);
    this.stepsBetweenSpikes = this.#refractorySteps + 1;
  }

  override save(): () => void {
    const restore = super.save();
    const refractory = this.#refractory.slice();
    return () => {
      restore();
      this.#refractory.set(refractory);
    };
  }

  step(): void {
    const { state, spiked, input } = this;
    const refractory = this.#refractory;
    for (let n = 0; n < this.size; n++) {
      spiked[n] = 0;
      if (refractory[n]! > 0) {
        refractory[n]!--;
        continue;
      }
      const v = this.#rest + (state[n]! - this.#rest) * this.#decay + (this.#current + input[n]!) * this.#drift;
      const spikes = v >= this.#threshold && Number.isFinite(v); // what left the doubles is none [NCP-SESS-057]
      state[n] = spikes ? this.#reset : v;
      if (spikes) {
        spiked[n] = 1;
        refractory[n] = this.#refractorySteps;
      }
    }
  }
}

/** Linear rate neurons; the state is r in Hz, and so is the input. [NCP-SESS-051] */
export class RateNeurons extends Neurons {
  readonly stepsBetweenSpikes = Infinity;
  readonly #decay: number;
  readonly #gain: number;
  readonly #mean: number;

  /** @throws {@link SessionError} when a parameter is not one */
  constructor(size: number, dtMs: number, given: ReadonlyMap<string, number>) {
    const params = { tau: 10, mu: 0 };
    setParams(params, given);
    checkPositive(params, "tau");
    super(size, 0);
    this.#decay = Math.exp(-dtMs / params.tau);
    this.#gain = -Math.expm1(-dtMs / params.tau);
    this.#mean = params.mu;
  }

  step(): void {
    for (let n = 0; n < this.size; n++) {
      this.state[n] = this.state[n]! * this.#decay + (this.#mean + this.input[n]!) * this.#gain;
    }
  }
}

function setParams(params: Record<string, number>, given: ReadonlyMap<string, number>): void {
  for (const [name, value] of given) {
    if (!Object.hasOwn(params, name)) throw new SessionError(`the network has no parameter ${name}`);
    params[name] = value;
  }
}

function checkPositive(params: Record<string, number>, ...names: string[]): void {
  for (const name of names) if (!(params[name]! > 0)) throw new SessionError(`${name} is ${params[name]}`);
}
