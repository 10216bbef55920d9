/**
 * The safety governor: the last gate of a commander, which lets a command through only when it is safe
 * by all that is known there (chapter 7). What it cannot decide is a HOLD.
 *
 * @module
 */

import {
  METRES,
  METRES_PER_SECOND,
  POSE_POSITION,
  SPACE,
  usableVector,
  VELOCITY_SETPOINT,
  zeroVelocity,
} from "./channels.js";
import { create } from "./encode.js";
import { isWithin, ticksWithin } from "./geofence.js";
import type { Capabilities, ChannelSpec, ChannelValue, CommandFrame, SafetyLimits, SensorFrame } from "./messages.js";
import { allFinite, limited } from "./vector.js";
import { enforcedTtlMs, isPast } from "./watchdog.js";

/** The channels that two peers agreed on. */
export type NegotiatedChannels = Pick<Capabilities, "sensor_channels" | "command_channels">;

type Channels = ReadonlyMap<string, ChannelValue>;

/** Governs the commands of one control loop. */
export class SafetyGovernor {
  readonly #maxSpeed: Limit;
  readonly #radius: Limit;
  readonly #timeoutMs: number;
  /** The unit of each negotiated channel of a command. */
  readonly #units: ReadonlyMap<string, string | null>;
  readonly #configFault: string | null;
  #stopped = false;

  /**
   * @param limits - what to enforce; `max_tilt_rad` is the plant's matter [NCP-SAFE-019]
   * @param channels - what was negotiated; `null` or nothing for the canonical channels
   */
  constructor(limits: Partial<SafetyLimits>, channels: NegotiatedChannels | null = null) {
    const { sensor_channels: sensors, command_channels: commands } = channels ?? CANONICAL;
    this.#maxSpeed = limitOf(limits.max_speed_mps);
    this.#radius = limitOf(limits.geofence_radius_m);
    this.#timeoutMs = limits.command_timeout_ms ?? 500;
    // Of a channel that is declared twice the first declaration says the unit. [NCP-SAFE-042]
    const units = new Map<string, string | null>();
    for (const { name, unit } of commands) if (!units.has(name)) units.set(name, unit);
    this.#units = units;
    this.#configFault =
      faultOf("geofence_radius_m", this.#radius, POSE_POSITION, METRES, sensors) ??
      faultOf("max_speed_mps", this.#maxSpeed, VELOCITY_SETPOINT, METRES_PER_SECOND, commands);
  }

  /** Whether an ESTOP is latched. */
  get stopped(): boolean {
    return this.#stopped;
  }

  /** Why the governor answers every command with a HOLD for as long as it exists, or `null`. [NCP-SAFE-018] */
  get configFault(): string | null {
    return this.#configFault;
  }

  /** Takes note of what the link monitor says: a burst latches ESTOP. [NCP-SAFE-006] [NCP-SAFE-007] */
  noteLink(burst: boolean): void {
    this.#stopped ||= burst;
  }

  /** Clears the latch of the ESTOP. What is wrong with the configuration stays. [NCP-SAFE-008] [NCP-SAFE-009] */
  reset(): void {
    this.#stopped = false;
  }

  /**
   * Decides what is sent instead of a command: the command itself, clamped and its horizon truncated
   * where they must be, or a HOLD or an ESTOP frame. The command is left as it is.
   *
   * @param nowS - the governor's clock, s
   * @param sensor - the newest sensor frame, if there is one
   * @param lastSensorS - when it was received, on the same clock; `null` when none was
   */
  govern(command: CommandFrame, nowS: number, sensor: SensorFrame | null, lastSensorS: number | null): CommandFrame {
    // The gates in their order; the first that closes decides. [NCP-SAFE-020]
    if (command.mode === "estop") this.#stopped = true; // [NCP-SAFE-004]
    if (this.#stopped) return this.#zeroed(command, "estop"); // [NCP-SAFE-003] [NCP-SAFE-005]
    const hold = (): CommandFrame => this.#zeroed(command, "hold");
    if (this.#configFault !== null) return hold(); // [NCP-SAFE-017]
    if (this.#isStale(nowS, lastSensorS)) return hold();

    const radius = this.#radius.enabled ? this.#radius.value : null; // [NCP-SAFE-012]
    const position = radius === null ? null : positionIn(sensor);
    if (radius !== null) {
      if (position === null) return hold();
      if (!isWithin(radius, position)) {
        this.#stopped = true; // [NCP-SAFE-043] [NCP-SAFE-044]
        return this.#zeroed(command, "estop");
      }
    }

    if (command.mode !== "active") return hold(); // [NCP-SAFE-002]

    const channels = this.#clamped(command.channels);
    if (channels === null) return hold();
    const tickMs = command.horizon_dt_ms ?? NaN;
    if (command.horizon.length > 0 && !(Number.isFinite(tickMs) && tickMs > 0)) return hold(); // [NCP-SAFE-068]
    let horizon = this.#clampedSteps(command.horizon);

    if (radius !== null && position !== null) {
      const velocities = this.#velocities(channels, horizon);
      if (velocities === null) return hold(); // [NCP-SAFE-052]
      const plan = { velocities, tickMs, ttlMs: enforcedTtlMs(command.ttl_ms) };
      const ticks = ticksWithin(radius, position, plan);
      if (ticks === null) return hold(); // [NCP-SAFE-051] [NCP-SAFE-053]
      horizon = horizon.slice(0, ticks); // [NCP-SAFE-050]
    }
    return { ...command, channels, horizon }; // [NCP-SAFE-021] [NCP-SAFE-022]
  }

  #isStale(nowS: number, lastSensorS: number | null): boolean {
    if (lastSensorS === null) return true; // [NCP-SAFE-030]
    if (!Number.isFinite(nowS) || !Number.isFinite(lastSensorS)) return true; // [NCP-SAFE-031]
    if (!Number.isFinite(this.#timeoutMs) || this.#timeoutMs <= 0) return true; // [NCP-SAFE-032]
    const ageS = nowS - lastSensorS;
    return ageS < 0 || isPast(ageS, this.#timeoutMs); // [NCP-SAFE-035] [NCP-SAFE-033] [NCP-SAFE-034]
  }

  /** The channels of one tick with the speed limit applied, or `null` when that cannot be. */
  #clamped(channels: Channels): Map<string, ChannelValue> | null {
    for (const { data } of channels.values()) if (!allFinite(data)) return null; // [NCP-SAFE-064]
    if (!this.#maxSpeed.enabled) return new Map(channels);
    // [NCP-SAFE-011] [NCP-SAFE-063]
    if (this.#velocityIn(channels) === null) return null;
    const clamped = new Map<string, ChannelValue>();
    for (const [name, value] of channels) {
      const isSpeed = this.#unitOf(name, value) === METRES_PER_SECOND; // [NCP-SAFE-065]
      clamped.set(name, isSpeed ? { ...value, data: limited(value.data, this.#maxSpeed.value) } : value);
    }
    return clamped;
  }

  /** The steps of a horizon, clamped, up to the first for which that cannot be. [NCP-SAFE-066] [NCP-SAFE-067] */
  #clampedSteps(steps: readonly Channels[]): Map<string, ChannelValue>[] {
    const clamped: Map<string, ChannelValue>[] = [];
    for (const step of steps) {
      const channels = this.#clamped(step);
      if (channels === null) break;
      clamped.push(channels);
    }
    return clamped;
  }

  /**
   * The velocities of tick 0 and of the horizon up to the first step without a usable one, from which on
   * it is not known where the plant goes; `null` when tick 0 has none.
   */
  #velocities(channels: Channels, horizon: readonly Channels[]): Float64Array[] | null {
    const velocities: Float64Array[] = [];
    for (const tick of [channels, ...horizon]) {
      const velocity = this.#velocityIn(tick);
      if (velocity === null) break;
      velocities.push(velocity);
    }
    return velocities.length === 0 ? null : velocities;
  }

  /** The velocity of a tick: there, 3 wide, finite and in `m/s`; or `null`. */
  #velocityIn(channels: Channels): Float64Array | null {
    const value = channels.get(VELOCITY_SETPOINT);
    if (value === undefined || this.#unitOf(VELOCITY_SETPOINT, value) !== METRES_PER_SECOND) return null;
    return usableVector(value);
  }

  /** The unit of a channel of the command, which is the negotiated one when the command says none. [NCP-SAFE-042] */
  #unitOf(name: string, value: ChannelValue): string | null {
    return value.unit ?? this.#units.get(name) ?? null;
  }

  /** The HOLD or ESTOP frame for a command. [NCP-SAFE-070] [NCP-SAFE-074] */
  #zeroed(command: CommandFrame, mode: "hold" | "estop"): CommandFrame {
    const { t, seq, frame_id, ttl_ms } = command;
    const channels = new Map<string, ChannelValue>(); // [NCP-SAFE-071]
    for (const [name, { data, unit }] of command.channels) {
      channels.set(name, { data: new Float64Array(data.length), unit }); // [NCP-SAFE-072]
    }
    for (const name of this.#units.keys()) {
      if (channels.has(name)) continue;
      // [NCP-SAFE-073]
      channels.set(name, name === VELOCITY_SETPOINT ? zeroVelocity() : { data: new Float64Array(1), unit: null });
    }
    return create("command_frame", { t, seq, frame_id, ttl_ms, mode, channels });
  }
}

/** A limit: what it is, if it is enabled, and whether it is one at all. */
interface Limit {
  readonly value: number;
  readonly enabled: boolean;
  readonly valid: boolean;
}

/** An absent limit and one of 0 are disabled; a negative one and one that is not finite are none. */
function limitOf(given: number | null | undefined): Limit {
  const value = given ?? 0;
  const valid = Number.isFinite(value) && value >= 0;
  return { value, valid, enabled: valid && value > 0 }; // [NCP-SAFE-012]
}

/** Why a limit cannot be enforced, or `null`. Every declaration of its channel must fit. */
function faultOf(
  name: string,
  limit: Limit,
  channel: string,
  unit: string,
  declared: readonly ChannelSpec[],
): string | null {
  if (!limit.valid) return `${name} is ${limit.value}`; // [NCP-SAFE-013]
  if (!limit.enabled) return null;
  const specs = declared.filter((spec) => spec.name === channel); // [NCP-SAFE-010] [NCP-SAFE-011]
  if (specs.length === 0) return `${name} needs the channel ${channel}`; // [NCP-SAFE-014]
  if (specs.some((spec) => spec.unit !== unit)) return `${name} needs ${channel} in ${unit}`; // [NCP-SAFE-015]
  if (!specs.every(isSpatial)) return `${name} needs ${channel} ${SPACE} wide`; // [NCP-SAFE-016]
  return null;
}

/** Whether a channel is declared with three components. */
function isSpatial({ kind, size }: ChannelSpec): boolean {
  return size === SPACE ? kind === "vec3" || kind === "array" : size === null && kind === "vec3";
}

/** The measured position in m, its components finite or not, or `null` when there is none. [NCP-SAFE-010] */
function positionIn(sensor: SensorFrame | null): Float64Array | null {
  const value = sensor?.channels.get(POSE_POSITION);
  if (value === undefined || value.data.length !== SPACE) return null; // [NCP-SAFE-040]
  // The negotiated unit is `m`, or the fence would be a config fault. [NCP-SAFE-041] [NCP-SAFE-042]
  return value.unit === null || value.unit === METRES ? value.data : null;
}

/** The channels of a governor that was told of none. */
const CANONICAL: NegotiatedChannels = create("capabilities", {
  controller_id: "",
  sensor_channels: [{ name: POSE_POSITION, kind: "vec3", unit: METRES }],
  command_channels: [{ name: VELOCITY_SETPOINT, kind: "vec3", unit: METRES_PER_SECOND }],
});
