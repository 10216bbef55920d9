/**
 * The deadline of a command, on the plant's own clock (chapter 8.1).
 *
 * @module
 */

import { TTL_MS } from "./limits.js";

/** How long a plant acts upon a command, ms; 0 is not at all. [NCP-RES-004] [NCP-RES-005] */
export function enforcedTtlMs(ttlMs: number): number {
  return Number.isFinite(ttlMs) && ttlMs > 0 ? Math.min(ttlMs, TTL_MS) : 0;
}

/** Below it a limit in ms over 1000 may lose digits, since it is next to the smallest double. */
const TINY_MS = 1e-300;

/**
 * Whether an age is more than a limit in ms. Compared in seconds, since a whole number of ms over 1000 is the very
 * double that a clock in seconds reads; next to 0 in ms.
 */
export function isPast(ageS: number, limitMs: number): boolean {
  return limitMs < TINY_MS ? ageS * 1000 > limitMs : ageS > limitMs / 1000;
}

/**
 * Tells a plant when to hold. It holds unless a command that advanced, of a clock that can be trusted,
 * is not older than its enforced ttl.
 */
export class CommandWatchdog {
  /** The seq of the last command that advanced. */
  #lastSeq: number | null = null;
  #receivedS = NaN;
  #ttlMs = 0;
  #holding = true; // [NCP-RES-006]

  /** When the last command that set the deadline was received, s; NaN when there is none. */
  get receivedS(): number {
    return this.#receivedS;
  }

  /**
   * Takes note of a command. Only one that advances sets the deadline. [NCP-RES-009]
   *
   * @param nowS - when it was received, on the plant's clock [NCP-RES-001]
   * @returns whether it advanced
   */
  onCommand(nowS: number, ttlMs: number, seq: number): boolean {
    if (!this.#advance(seq)) return false;
    this.#receivedS = nowS;
    this.#ttlMs = enforcedTtlMs(ttlMs);
    this.#holding = false;
    return true;
  }

  /**
   * Takes note of a command to hold, which sets no deadline and is obeyed at once. [NCP-RES-024]
   *
   * @param rising - whether it is obeyed only if it advances
   * @returns whether it is obeyed
   */
  onHold(seq: number, rising = false): boolean {
    const older = this.#lastSeq !== null && seq < this.#lastSeq && seq !== 0;
    if (!this.#advance(seq) && (rising || older)) return false; // [NCP-RES-023]
    this.#holding = true;
    return true;
  }

  /** Whether the plant must hold. Once it must, it must until a command advances. [NCP-RES-010] */
  shouldHold(nowS: number): boolean {
    const ageS = nowS - this.#receivedS;
    const live =
      this.#ttlMs > 0 && // [NCP-RES-005]
      Number.isFinite(nowS) && // [NCP-RES-007]
      Number.isFinite(this.#receivedS) && // [NCP-RES-007]
      ageS >= 0 && // [NCP-RES-008]
      !isPast(ageS, this.#ttlMs); // [NCP-RES-002] [NCP-RES-003]
    this.#holding ||= !live;
    return this.#holding;
  }

  /** Forgets everything: it holds until a command comes, of whatever seq. [NCP-RES-011] [NCP-RES-012] */
  reset(): void {
    this.#lastSeq = null;
    this.#receivedS = NaN;
    this.#ttlMs = 0;
    this.#holding = true;
  }

  #advance(seq: number): boolean {
    const advances = Number.isSafeInteger(seq) && (this.#lastSeq === null || seq > this.#lastSeq);
    if (advances) this.#lastSeq = seq;
    return advances;
  }
}
