/**
 * What a stream loses, and when its losses bunch up (chapter 8.3).
 *
 * @module
 */

import { ConfigError } from "./errors.js";

/** How a stream arrives; the fields of a `link_status` that a monitor knows. */
export interface LinkReport {
  /** The highest seq seen; −1: none. */
  readonly last_seq: number;
  /** Frames that arrived. */
  readonly received: number;
  /** Frames that did not. */
  readonly lost: number;
  /** Lost over expected, 0 to 1. */
  readonly loss_rate: number;
  /** The loss detector is above its threshold. */
  readonly burst: boolean;
}

/** The loss that the detector takes for healthy. */
export const DEFAULT_REF_LOSS = 0.05;

/** What the detector must exceed for a burst. */
export const DEFAULT_THRESHOLD = 5;

/** Watches the seq of every frame that arrives on one stream. [NCP-RES-053] */
export class LinkMonitor {
  readonly #refLoss: number;
  readonly #threshold: number;
  #first = 0;
  /** One more than the highest seq seen; `null` before the first frame. */
  #expected: number | null = null;
  #received = 0;
  #lost = 0;
  /** The newest missing seqs, in rising order. */
  readonly #missing = new Set<number>();
  /** The one-sided CUSUM over the slots of the stream. */
  #cusum = 0;

  /**
   * @param refLoss - the share of frames whose loss is nothing to worry about, clamped to 0 … 0.99
   * @param threshold - what the detector must exceed for a burst
   */
  constructor(refLoss = DEFAULT_REF_LOSS, threshold = DEFAULT_THRESHOLD) {
    this.#refLoss = Number.isFinite(refLoss) ? Math.min(Math.max(refLoss, 0), 0.99) : DEFAULT_REF_LOSS; // [NCP-RES-051]
    this.#threshold = Number.isFinite(threshold) && threshold > 0 ? threshold : DEFAULT_THRESHOLD; // [NCP-RES-052]
  }

  /**
   * Takes note of a frame.
   *
   * @param seq - an integer; beyond those of the wire, it counts as the last of them
   * @throws {@link ConfigError} when it is not an integer
   */
  onFrame(seq: number): LinkReport {
    if (!Number.isInteger(seq)) throw new ConfigError(`the seq ${seq} is not an integer`);
    const at = Math.min(Math.max(seq, Number.MIN_SAFE_INTEGER), Number.MAX_SAFE_INTEGER);
    if (this.#expected === null) {
      this.#first = at;
      this.#arrive();
      this.#expected = at + 1;
    } else if (at >= this.#expected) {
      this.#lose(this.#expected, at);
      this.#arrive();
      this.#expected = at + 1; // [NCP-RES-043]
    } else if (this.#missing.delete(at)) {
      this.#lost--; // [NCP-RES-041]
      this.#arrive();
    } // What is left is a duplicate. [NCP-RES-042]
    return this.report();
  }

  /** How the stream arrives so far. */
  report(): LinkReport {
    const expected = this.#expected;
    return {
      last_seq: expected === null ? -1 : expected - 1,
      received: this.#received,
      lost: this.#lost,
      // [NCP-RES-044] [NCP-RES-045]
      loss_rate: expected === null ? 0 : Math.min(this.#lost / saturated(expected - this.#first), 1),
      burst: this.#cusum > this.#threshold, // [NCP-RES-046]
    };
  }

  #arrive(): void {
    this.#received = saturated(this.#received + 1);
    this.#cusum = Math.max(this.#cusum - this.#refLoss, 0);
  }

  /** Counts the seqs from `begin` to before `end` as lost. [NCP-RES-040] */
  #lose(begin: number, end: number): void {
    const gap = saturated(end - begin);
    this.#lost = saturated(this.#lost + gap);
    for (let n = Math.min(gap, GAP_UPDATES); n > 0; n--) {
      this.#cusum = Math.min(this.#cusum + (1 - this.#refLoss), 2 * this.#threshold); // [NCP-RES-047] [NCP-RES-049]
    }
    for (let seq = end - Math.min(gap, MISSING); seq < end; seq++) this.#missing.add(seq);
    // The oldest are the least likely to come still. [NCP-RES-048] [NCP-RES-056] [NCP-RES-057]
    for (const seq of this.#missing) {
      if (this.#missing.size <= MISSING) break;
      this.#missing.delete(seq);
    }
  }
}

/** Updates of the detector that one gap makes at most. */
const GAP_UPDATES = 256;

/** Missing seqs that are remembered at most. */
const MISSING = 4_096;

/** A count, kept among the integers of the wire. [NCP-RES-050] */
function saturated(count: number): number {
  return Math.min(count, Number.MAX_SAFE_INTEGER);
}
