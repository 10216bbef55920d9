/**
 * The reflex controller: proportional with damping, without a network (chapter 10.1).
 *
 * @module
 */

import {
  METRES_PER_SECOND,
  POSE_POSITION,
  POSE_VELOCITY,
  SPACE,
  usableVector,
  VELOCITY_SETPOINT,
  zeroVelocity,
} from "./channels.js";
import type { Controller } from "./control-loop.js";
import { create } from "./encode.js";
import { ConfigError } from "./errors.js";
import type { CommandFrame, SensorFrame } from "./messages.js";
import { allFinite } from "./vector.js";

/** How a reflex controller flies. */
export interface ReflexConfig {
  /** Where to, m; the origin when it is not named. */
  readonly target?: ArrayLike<number> | undefined;
  /** 1/s; 1 when it is not named. [NCP-CTRL-002] */
  readonly kp?: number | undefined;
  /** 0.3 when it is not named. [NCP-CTRL-002] */
  readonly kd?: number | undefined;
  /** The most on each axis, m/s; 1.5 when it is not named. [NCP-CTRL-002] */
  readonly max_speed?: number | undefined;
}

/** Flies to a target and stays there. */
export class ReflexController implements Controller {
  readonly #target: Float64Array;
  readonly #kp: number;
  readonly #kd: number;
  readonly #maxSpeed: number;

  /** @throws {@link ConfigError} when a gain, the target or the speed is not one [NCP-CTRL-005] */
  constructor(config: ReflexConfig = {}) {
    const { target = [0, 0, 0], kp = 1, kd = 0.3, max_speed = 1.5 } = config;
    if (target.length !== SPACE || !allFinite(target)) throw new ConfigError("the target is not a position");
    for (const [name, value] of Object.entries({ kp, kd, max_speed })) {
      if (!Number.isFinite(value) || value < 0) throw new ConfigError(`${name} is ${value}`);
    }
    this.#target = Float64Array.from(target);
    this.#kp = kp;
    this.#kd = kd;
    this.#maxSpeed = max_speed;
  }

  /** The command for a sensor frame. */
  step(sensor: SensorFrame | null): CommandFrame {
    const velocity = sensor === null ? null : this.#velocity(sensor);
    return create("command_frame", {
      seq: sensor?.seq, // [NCP-PLANE-006]
      frame_id: sensor?.frame_id,
      mode: velocity === null ? "hold" : "active", // [NCP-CTRL-003]
      channels: {
        [VELOCITY_SETPOINT]: velocity === null ? zeroVelocity() : { data: velocity, unit: METRES_PER_SECOND },
      },
    });
  }

  /** Where to go, or `null` when that cannot be told. [NCP-CTRL-001] */
  #velocity({ channels }: SensorFrame): Float64Array | null {
    const position = usableVector(channels.get(POSE_POSITION));
    if (position === null) return null;
    const damped = usableVector(channels.get(POSE_VELOCITY)) ?? new Float64Array(SPACE); // [NCP-CTRL-004]
    const velocity = position.map((at, axis) => {
      const wanted = this.#kp * (this.#target[axis]! - at) - this.#kd * damped[axis]!;
      return Math.min(Math.max(wanted, -this.#maxSpeed), this.#maxSpeed);
    });
    // Two infinite terms that cancel out say nothing.
    return allFinite(velocity) ? velocity : null;
  }
}
