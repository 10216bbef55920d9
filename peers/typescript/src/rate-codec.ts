/**
 * The rate codec `ncp.codec.rate.v0`: channels as the rates of neuron populations, and back (chapter 9).
 *
 * @module
 */

import { METRES_PER_SECOND, VELOCITY_SETPOINT } from "./channels.js";
import { create } from "./encode.js";
import { ConfigError } from "./errors.js";
import { COMPONENTS } from "./limits.js";
import type { CommandFrame, SensorFrame } from "./messages.js";
import type { Entries } from "./table.js";

/** The name under which capabilities state this codec. */
export const RATE_CODEC_ID = "ncp.codec.rate.v0";

/** Two ends; the second may be the smaller one. */
export type Range = readonly [number, number];

/** Ties one component of a channel to one population. */
export interface Mapping {
  readonly channel: string;
  /** Which component, from 0. A mapping of 4,096 or more is ignored. [NCP-CODEC-008] */
  readonly component: number;
  readonly population: string;
  /** In the channel's unit; −1 … 1 when it is not named. */
  readonly value_range?: Range | undefined;
  /** Hz; 0 … 200 when it is not named. */
  readonly rate_range?: Range | undefined;
}

/** A mapping from a population to a command channel. */
export interface DecoderMapping extends Mapping {
  /** The unit of the channel. The first mapping of a channel that names one decides. */
  readonly unit?: string | null | undefined;
}

/** What a codec maps. Where two mappings have one target, the later one counts. [NCP-CODEC-014] */
export interface RateCodecSpec {
  /** From sensor channels to populations. */
  readonly encoders: readonly Mapping[];
  /** From populations to command channels. */
  readonly decoders: readonly DecoderMapping[];
}

/** What a decoded command says besides its channels. [NCP-CODEC-009] */
export type CommandHead = Pick<CommandFrame, "t" | "seq" | "frame_id" | "mode">;

/** Maps sensor channels to rates, and rates to command channels. */
export class RateCodec {
  readonly #encoders: readonly (Mapping & Lines)[];
  readonly #decoders: readonly (DecoderMapping & Lines)[];

  /** @throws {@link ConfigError} when a component is not a number of one, or a mapping has no range to map to */
  constructor({ encoders, decoders }: RateCodecSpec) {
    this.#encoders = encoders.filter(isMapped).map((mapping) => withLines(mapping, "rates"));
    this.#decoders = decoders.filter(isMapped).map((mapping) => withLines(mapping, "values"));
  }

  /** The rate of each population, Hz. A missing sensor is no extreme but the middle. [NCP-CODEC-005] */
  encode(sensor: SensorFrame | null): Map<string, number> {
    const rates = new Map<string, number>();
    for (const { channel, component, population, values, rates: range } of this.#encoders) {
      const sample = sensor?.channels.get(channel)?.data[component];
      rates.set(population, mapped(sample, values, range)); // [NCP-CODEC-001]
    }
    return rates;
  }

  /**
   * The command that the rates stand for.
   *
   * @param rates - the rate of each population, Hz; one that is absent stands for the middle [NCP-CODEC-006]
   */
  decode(rates: Entries<number>, head: CommandHead): CommandFrame {
    const rateOf = rates instanceof Map ? (rates as ReadonlyMap<string, number>) : new Map(Object.entries(rates));
    const channels = new Map<string, { data: number[]; unit: string | null }>();
    for (const { channel, component, population, values, rates: range, unit } of this.#decoders) {
      const value = channels.get(channel) ?? { data: [], unit: null };
      while (value.data.length <= component) value.data.push(0); // [NCP-CODEC-010]
      value.data[component] = mapped(rateOf.get(population), range, values); // [NCP-CODEC-003]
      value.unit ??= unit ?? null; // [NCP-CODEC-011]
      channels.set(channel, value);
    }
    const { t, seq, frame_id, mode } = head;
    return create("command_frame", { t, seq, frame_id, mode, channels });
  }
}

/** The default UAV codec. [NCP-CODEC-020] */
export const UAV_CODEC: RateCodecSpec = {
  encoders: ["err_x", "err_y", "err_z"].map((population, component) => ({
    channel: "pose_error",
    component,
    population,
    value_range: [-2, 2],
  })),
  decoders: ["vel_x", "vel_y", "vel_z"].map((population, component) => ({
    channel: VELOCITY_SETPOINT,
    component,
    population,
    value_range: [-1.5, 1.5],
    unit: METRES_PER_SECOND,
  })),
};

/** The two ranges of a mapping, named or not. */
interface Lines {
  readonly values: Range;
  readonly rates: Range;
}

function isMapped({ component }: Mapping): boolean {
  if (!Number.isInteger(component) || component < 0) throw new ConfigError(`${component} is not a component`);
  return component < COMPONENTS; // [NCP-CODEC-008]
}

function withLines<M extends Mapping>(mapping: M, target: keyof Lines): M & Lines {
  const lines = { values: mapping.value_range ?? VALUES, rates: mapping.rate_range ?? RATES };
  const [begin, end] = lines[target];
  if (!Number.isFinite(begin) || !Number.isFinite(end)) throw new ConfigError(`there is no way to map to ${begin} … ${end}`);
  return { ...mapping, ...lines };
}

/** Maps a value linearly from one range to another and clamps it there; the middle stands for what cannot be told. */
function mapped(value: number | undefined, from: Range, to: Range): number {
  const length = from[1] - from[0];
  const degenerate = length === 0 || !Number.isFinite(length); // [NCP-CODEC-007]
  if (value === undefined || !Number.isFinite(value) || degenerate) return middle(to);
  const share = (clamped(value, from) - from[0]) / length;
  const width = to[1] - to[0];
  // Between ends that are further apart than a double can say, each end has its share.
  const result = Number.isFinite(width) ? to[0] + share * width : to[0] * (1 - share) + to[1] * share;
  return clamped(result, to); // [NCP-CODEC-002] [NCP-CODEC-004]
}

/** The middle as of real numbers: no sum overflows, and no half of a subnormal rounds. */
function middle([begin, end]: Range): number {
  const both = begin + end;
  return Number.isFinite(both) ? both / 2 : begin / 2 + end / 2;
}

/** Clamping the source first changes no result, and keeps every step of the computation finite. */
function clamped(value: number, [begin, end]: Range): number {
  return Math.min(Math.max(value, Math.min(begin, end)), Math.max(begin, end));
}

const VALUES: Range = [-1, 1];
const RATES: Range = [0, 200];
