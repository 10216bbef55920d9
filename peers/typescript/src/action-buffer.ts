/**
 * The plant's buffer: the newest command, its horizon, and the latch of an ESTOP (chapter 8.2).
 *
 * @module
 */

import { decode } from "./decode.js";
import { asksForStop } from "./estop.js";
import { ENTRIES } from "./limits.js";
import type { ChannelValue, CommandFrame } from "./messages.js";
import { CommandWatchdog } from "./watchdog.js";

/** Holds the newest command and says what a plant is to do at any time. */
export class ActionBuffer {
  readonly #strict: boolean;
  readonly #watchdog = new CommandWatchdog();
  /** The active command that set the deadline; `null` when there is nothing to do. */
  #command: CommandFrame | null = null;
  #stopped = false;

  /** @param strict - whether the strict profile holds, by agreement with the commander */
  constructor(strict = false) {
    this.#strict = strict;
  }

  /** Whether an ESTOP is latched. */
  get stopped(): boolean {
    return this.#stopped;
  }

  /**
   * Takes a frame of the action plane as it arrives.
   *
   * @param nowS - when it arrived, on the plant's clock
   * @throws {@link DecodeError} when the frame is rejected; an ESTOP that can be made out in it is latched nevertheless
   */
  receive(frame: string | Uint8Array, nowS: number): void {
    let command: CommandFrame;
    try {
      command = decode("command_frame", frame, this.#strict);
    } catch (error) {
      if (asksForStop(frame)) this.#stop(); // [NCP-RES-022]
      throw error;
    }
    this.accept(command, nowS);
  }

  /**
   * Takes a command that was decoded.
   *
   * @param nowS - when it arrived, on the plant's clock
   */
  accept(command: CommandFrame, nowS: number): void {
    const { mode, seq, ttl_ms } = command;
    if (mode === "estop") {
      this.#stop(); // [NCP-RES-021]
    } else if (this.#strict && seq < 1) {
      return; // [NCP-STRICT-004]
    } else if (mode !== "active") {
      // As of the governor, whatever is not `active` is a HOLD. [NCP-SAFE-001] [NCP-SAFE-002]
      if (this.#watchdog.onHold(seq, this.#strict)) this.#command = null; // [NCP-RES-023] [NCP-STRICT-005]
    } else if (this.#watchdog.onCommand(nowS, ttl_ms, seq)) {
      this.#command = command; // [NCP-RES-020]
    }
  }

  /** What to do at the time: the values of the channels, or `null` when the plant must hold. [NCP-RES-025] */
  active(nowS: number): Map<string, ChannelValue> | null {
    const command = this.#command;
    if (this.#watchdog.shouldHold(nowS) || this.#stopped || command === null) return null;
    const { channels, horizon, horizon_dt_ms: tickMs } = command;
    // [NCP-RES-026] [NCP-RES-027]
    if (horizon.length === 0 || tickMs === null || !Number.isFinite(tickMs) || tickMs <= 0) return channels;
    const tick = Math.floor(((nowS - this.#watchdog.receivedS) * 1000) / tickMs); // [NCP-RES-028]
    if (tick === 0) return channels;
    const step = horizon[tick - 1] ?? null; // [NCP-RES-029]
    // Past the end the plant holds, and a hold stays one when the clock steps back. [NCP-RES-010]
    if (step === null) this.#command = null;
    return step;
  }

  /** Clears the latch and forgets every command. Nothing moves until another one comes. [NCP-RES-030] [NCP-RES-031] */
  reset(): void {
    this.#watchdog.reset();
    this.#command = null;
    this.#stopped = false;
  }

  #stop(): void {
    this.#stopped = true;
    this.#command = null;
  }
}

/**
 * How many ticks fit into a ttl: a longer horizon would not be replayed. [NCP-RES-033]
 *
 * @returns 0 when either time is not finite or not positive; at most what a frame may have [NCP-RES-034]
 */
export function maxHorizonLen(ttlMs: number, dtMs: number): number {
  const usable = Number.isFinite(ttlMs) && ttlMs > 0 && Number.isFinite(dtMs) && dtMs > 0;
  return usable ? Math.min(Math.floor(ttlMs / dtMs), ENTRIES) : 0;
}
