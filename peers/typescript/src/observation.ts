/**
 * The samples of one port as a block, and back (chapter 5.2).
 *
 * @module
 */

import { fromBase64, toBase64 } from "./base64.js";
import { decodeBlock, encodeBlock, type Column } from "./bulk.js";
import { create } from "./encode.js";
import { BulkError } from "./errors.js";
import type { BulkObservation, Observation } from "./messages.js";

/** Samples to be packed: the arrays of an `Observation`, of one length where they are not empty. */
export interface Samples {
  /** A time a sample, ms of simulation time. */
  readonly times: ArrayLike<number>;
  /** A value a sample. */
  readonly values: ArrayLike<number>;
  /** The neuron of each sample. */
  readonly senders: ArrayLike<number> | BigInt64Array;
}

/** Samples as they come out of a block, as views into it where it is aligned. */
export interface UnpackedSamples {
  /** A time a sample, ms of simulation time. */
  times: Float64Array;
  /** A value a sample. */
  values: Float64Array;
  /** The neuron of each sample. */
  senders: BigInt64Array;
}

/**
 * Packs samples into a block. Without any sample the block has no columns.
 *
 * @throws {@link BulkError} when arrays that are not empty differ in length
 */
export function pack(samples: Samples): Uint8Array<ArrayBuffer> {
  const { times, values, senders } = samples;
  checkLengths([times.length, values.length, senders.length]); // [NCP-OBS-003]
  const columns: Column[] = [
    { name: "times", dtype: "f64", data: doubles(times) },
    { name: "values", dtype: "f64", data: doubles(values) },
    { name: "senders", dtype: "i64", data: bigints(senders) },
  ];
  return encodeBlock(columns.filter(({ data }) => data.length > 0)); // [NCP-OBS-001] [NCP-OBS-002]
}

/**
 * Unpacks the samples of a block. Columns of other names are ignored. [NCP-OBS-007] [NCP-OBS-008]
 *
 * @throws {@link BulkError} when the block is rejected, or its columns are not those of an observation
 */
export function unpack(block: Uint8Array): UnpackedSamples {
  // [NCP-OBS-005]
  const samples: UnpackedSamples = {
    times: new Float64Array(0),
    values: new Float64Array(0),
    senders: new BigInt64Array(0),
  };
  for (const column of decodeBlock(block)) {
    const { name, dtype } = column;
    if (name === "times" || name === "values") {
      if (dtype !== "f64") throw new BulkError(`the column ${name} is ${dtype}, not f64`); // [NCP-OBS-006]
      samples[name] = column.data;
    } else if (name === "senders") {
      if (dtype !== "i64") throw new BulkError(`the column senders is ${dtype}, not i64`); // [NCP-OBS-006]
      samples.senders = column.data;
    }
  }
  checkLengths([samples.times.length, samples.values.length, samples.senders.length]); // [NCP-OBS-004]
  return samples;
}

/**
 * An observation with its samples packed, for the observation plane and no other. [NCP-OBS-010] [NCP-OBS-011]
 *
 * @throws {@link BulkError} when the arrays that are not empty differ in length
 */
export function toBulkObservation(observation: Observation): BulkObservation {
  const { port, target, observable, unit, recordable } = observation;
  const block = toBase64(pack(observation));
  return create("bulk_observation", { port, target, observable, unit, recordable, block });
}

/**
 * What a packed observation says of its port, and its samples.
 *
 * @throws {@link BulkError} when its block is not base64 [NCP-OBS-012], or is rejected
 */
export function fromBulkObservation(
  message: BulkObservation,
): Omit<Observation, keyof UnpackedSamples> & UnpackedSamples {
  const { port, target, observable, unit, recordable } = message;
  const block = fromBase64(message.block);
  if (block === undefined) throw new BulkError("the block is not base64");
  return { port, target, observable, unit, recordable, ...unpack(block) };
}

function checkLengths(lengths: readonly number[]): void {
  const filled = new Set(lengths.filter((length) => length > 0));
  if (filled.size > 1) throw new BulkError(`the arrays have the lengths ${lengths.join(", ")}`);
}

function doubles(values: ArrayLike<number>): Float64Array {
  return values instanceof Float64Array ? values : Float64Array.from(values);
}

function bigints(values: ArrayLike<number> | BigInt64Array): BigInt64Array {
  if (values instanceof BigInt64Array) return values;
  const out = new BigInt64Array(values.length);
  for (let n = 0; n < out.length; n++) {
    const value = values[n]!;
    if (!Number.isSafeInteger(value)) throw new BulkError(`sender ${n} is not an integer within ±(2^53 − 1)`);
    out[n] = BigInt(value);
  }
  return out;
}
