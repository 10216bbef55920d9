/**
 * The channels that this text knows by name, and what a value on one of them is worth.
 *
 * @module
 */

import type { ChannelValue } from "./messages.js";
import { allFinite } from "./vector.js";

/** The sensor channel of the position, 3 wide, in `m`. */
export const POSE_POSITION = "pose_position";

/** The sensor channel of the velocity, 3 wide, in `m/s`. */
export const POSE_VELOCITY = "pose_velocity";

/** The command channel of the velocity, 3 wide, in `m/s`. */
export const VELOCITY_SETPOINT = "velocity_setpoint";

export const METRES = "m";
export const METRES_PER_SECOND = "m/s";

/** The components of a vector in space. */
export const SPACE = 3;

/** No velocity at all. */
export function zeroVelocity(): ChannelValue {
  return { data: new Float64Array(SPACE), unit: METRES_PER_SECOND };
}

/** The components of a channel that is there, 3 wide and finite, or `null`. */
export function usableVector(of: ChannelValue | undefined): Float64Array | null {
  return of !== undefined && of.data.length === SPACE && allFinite(of.data) ? of.data : null;
}
