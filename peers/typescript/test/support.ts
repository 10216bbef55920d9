import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import {
  type CommandFrame,
  create,
  decode,
  type ErrorCode,
  type Input,
  type Kind,
  NcpError,
  type SensorFrame,
} from "@ncp-conformance/peer";

/** A small generator of random numbers with a fixed seed, so that a failure comes back on the next run. */
export class Random {
  #state: number;

  constructor(seed: number) {
    this.#state = seed >>> 0;
  }

  /** 32 random bits (mulberry32). */
  bits(): number {
    this.#state = (this.#state + 0x6d2b79f5) >>> 0;
    let x = Math.imul(this.#state ^ (this.#state >>> 15), 1 | this.#state);
    x = (x + Math.imul(x ^ (x >>> 7), 61 | x)) ^ x;
    return (x ^ (x >>> 14)) >>> 0;
  }

  /** An integer from 0 to below `end`. */
  below(end: number): number {
    return this.bits() % end;
  }

  chance(oneIn: number): boolean {
    return this.below(oneIn) === 0;
  }

  pick<T>(from: readonly T[]): T {
    return from[this.below(from.length)]!;
  }

  shuffled<T>(items: readonly T[]): T[] {
    return items
      .map((item) => ({ item, rank: this.bits() }))
      .sort((a, b) => a.rank - b.rank)
      .map(({ item }) => item);
  }

  /** Any finite double: every bit pattern is as likely as another. */
  double(): number {
    const view = new DataView(new ArrayBuffer(8));
    for (;;) {
      view.setUint32(0, this.bits());
      view.setUint32(4, this.bits());
      const value = view.getFloat64(0);
      if (Number.isFinite(value)) return value;
    }
  }

  /** A number from `low` to below `high`. */
  between(low: number, high: number): number {
    return low + (high - low) * (this.bits() / 2 ** 32);
  }

  /** A vector of any direction, with components up to `most` in size. */
  vector(most: number): number[] {
    return [0, 1, 2].map(() => this.between(-most, most));
  }

  /** An integer within ±(2^53 − 1), of any magnitude. */
  integer(): number {
    const magnitude = Math.floor((this.bits() * 2 ** 21 + (this.bits() >>> 11)) / 2 ** this.below(53));
    return this.chance(2) ? magnitude : 0 - magnitude;
  }

  /** A string of some code points of all sorts, each well formed. */
  text(most = 8): string {
    let text = "";
    for (let n = this.below(most + 1); n > 0; n--) text += this.pick(CHARACTERS);
    return text;
  }
}

const CHARACTERS = [
  ...'abcXYZ019_- /"\\',
  "\0",
  "\b",
  "\t",
  "\n",
  "\u001f",
  "\u007f",
  "\u0080",
  "é",
  "ß",
  "߿",
  "ࠀ",
  "\u2028",
  "€",
  "\ud7ff",
  "\ue000",
  "\ufeff",
  "\uff5e",
  "\uffff",
  "😀",
  "\u{10ffff}",
];

/** Asserts that the action throws an error of the library with this code. */
export function refuses(code: ErrorCode, action: () => unknown): void {
  assert.throws(action, (error) => {
    assert.ok(error instanceof NcpError, `not an error of the library: ${String(error)}`);
    assert.equal(error.code, code, error.message);
    return true;
  });
}

/** Asserts that the frame is rejected with this code. */
export function rejects(kind: Kind, frame: string | Uint8Array, code: ErrorCode): void {
  refuses(code, () => decode(kind, frame));
}

/** A command with a velocity. */
export function moving(velocity: readonly number[], fields: Input<"command_frame"> = {}): CommandFrame {
  return create("command_frame", {
    seq: 1,
    channels: { velocity_setpoint: { data: velocity, unit: "m/s" } },
    ...fields,
  });
}

/** A sensor frame with a position. */
export function at(position: readonly number[], fields: Input<"sensor_frame"> = {}): SensorFrame {
  return create("sensor_frame", { seq: 1, channels: { pose_position: { data: position, unit: "m" } }, ...fields });
}

export function bytes(...parts: (string | readonly number[])[]): Uint8Array {
  return Buffer.concat(parts.map((part) => (typeof part === "string" ? Buffer.from(part) : Uint8Array.from(part))));
}

/** The text of a file of the repository. */
export function repositoryFile(path: string): string {
  return readFileSync(new URL(`../../../../${path}`, import.meta.url), "utf8");
}

/** A message as `proto/projection.json` has it, which is generated from the proto and the tables of the text. */
export interface ProjectedMessage {
  readonly kind?: string;
  readonly transparent?: boolean;
  readonly required?: readonly string[];
  readonly fields: Readonly<Record<string, ProjectedField>>;
}

/** A field: its type in the notation of the text, and what it is read as when it is absent. */
export interface ProjectedField {
  readonly type: string;
  readonly default?: unknown;
}

/** The contract's messages, enums and identity. */
export function projection(): {
  readonly wire: string;
  readonly contract_hash: string;
  readonly enums: Readonly<Record<string, { readonly values: Readonly<Record<string, string>>; readonly unknown: unknown }>>;
  readonly messages: Readonly<Record<string, ProjectedMessage>>;
  readonly error_frame: ProjectedMessage;
} {
  return JSON.parse(repositoryFile("proto/projection.json")) as ReturnType<typeof projection>;
}

/** What a frame of this message reads as, plain, that gives nothing but its kind. */
export function defaultsOf(message: string): Record<string, unknown> {
  const { kind, fields } = projection().messages[message]!;
  return { ...Object.fromEntries(Object.entries(fields).map(([name, field]) => [name, field.default])), kind };
}
