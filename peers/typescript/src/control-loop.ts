/**
 * The commander's control loop: from the newest sensor frame to a governed command, tick by tick (chapter 10.2).
 *
 * @module
 */

import { create } from "./encode.js";
import { ConfigError } from "./errors.js";
import type { SafetyGovernor } from "./governor.js";
import type { LinkMonitor } from "./link-monitor.js";
import type { CommandFrame, ControlStatus, SensorFrame } from "./messages.js";

/** Computes a command from the newest sensor frame, or from none. */
export interface Controller {
  step(sensor: SensorFrame | null): CommandFrame;
}

/** What a control loop is made of. */
export interface ControlLoopParts {
  /** The time between two ticks, ms. */
  readonly periodMs: number;
  readonly controller: Controller;
  readonly governor: SafetyGovernor;
  readonly monitor: LinkMonitor;
  /** The commander's monotonic clock, s. */
  readonly clock: () => number;
  /** Sends a command, at once and in the order of the calls. */
  readonly send: (command: CommandFrame) => void;
  /** Publishes how the loop is doing. */
  readonly publish: (status: ControlStatus) => void;
}

/**
 * One loop over one sensor stream and one command stream. Its owner calls {@link ControlLoop.onSensor} for
 * every frame that arrives and {@link ControlLoop.tick} once a period.
 */
export class ControlLoop {
  readonly #parts: ControlLoopParts;
  #sensor: SensorFrame | null = null;
  /** When the newest sensor frame arrived, s. */
  #sensorS: number | null = null;
  #ticks = 0;

  /** @throws {@link ConfigError} when the period is not finite and positive [NCP-CTRL-010] */
  constructor(parts: ControlLoopParts) {
    const { periodMs } = parts;
    if (!Number.isFinite(periodMs) || periodMs <= 0) throw new ConfigError(`the period is ${periodMs} ms`);
    this.#parts = parts;
  }

  /** Takes a sensor frame as it arrives. One that is not newer is counted, and nothing else. */
  onSensor(sensor: SensorFrame): void {
    this.#parts.monitor.onFrame(sensor.seq); // [NCP-RES-053]
    if (!isNewer(sensor, this.#sensor)) return;
    this.#sensor = sensor; // [NCP-CTRL-011]
    this.#sensorS = this.#parts.clock(); // [NCP-CTRL-012]
  }

  /** Sends one command and one status. */
  tick(): void {
    const { periodMs, controller, governor, monitor, clock, send, publish } = this.#parts;
    const nowS = clock();
    const sensor = this.#sensor;

    const wanted = controller.step(sensor);
    const leastTtlMs = 2 * periodMs;
    const command: CommandFrame = {
      ...wanted,
      t: nowS,
      seq: sensor?.seq ?? 0, // [NCP-CTRL-013]
      // Before it is governed, so that the projection sees the ttl that is sent. [NCP-CTRL-014]
      ttl_ms: wanted.ttl_ms >= leastTtlMs ? wanted.ttl_ms : leastTtlMs,
    };
    governor.noteLink(monitor.report().burst); // [NCP-CTRL-016]
    const sent = governor.govern(command, nowS, sensor, this.#sensorS);
    send(sent); // [NCP-CTRL-015] [NCP-CTRL-020]

    const latencyMs = (clock() - nowS) * 1000;
    // An `init` comes out of every governor as a hold.
    const passed = sent.mode === command.mode || (sent.mode === "hold" && command.mode === "init");
    const status = create("control_status", {
      seq: ++this.#ticks,
      t: nowS,
      mode: sent.mode,
      loop_latency_ms: latencyMs,
      safety_ok: passed, // [NCP-CTRL-018] [NCP-CTRL-021]
      // [NCP-CTRL-019]
      note: latencyMs > periodMs ? `the tick took ${latencyMs.toFixed(1)} ms of ${periodMs} ms` : null,
    });
    publish(status); // [NCP-CTRL-017]
  }

  /** Clears the governor's latch. */
  reset(): void {
    this.#parts.governor.reset();
  }
}

/** Whether a frame is newer than the one that is kept: by seq, or by t while neither is stamped. [NCP-CTRL-011] */
function isNewer(frame: SensorFrame, kept: SensorFrame | null): boolean {
  if (frame.seq === 0 && (kept === null || kept.seq === 0)) {
    // A first frame without a usable t would never be followed by a newer one.
    return Number.isFinite(frame.t) && (kept === null || frame.t > kept.t);
  }
  return kept === null || frame.seq > kept.seq;
}
