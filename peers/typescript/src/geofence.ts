/**
 * The geofence: the closed ball about the origin, and where in it a command leads (chapter 7.5).
 *
 * @module
 */

import { isAtMost } from "./vector.js";

/** What a plant is told to do, as far as it moves. */
export interface Plan {
  /** The velocities of tick 0 and of the ticks of the horizon, m/s; at least one. */
  readonly velocities: readonly Float64Array[];
  /** The length of a tick, ms; of no meaning without a horizon. */
  readonly tickMs: number;
  /** For how long the plant follows the command, ms. */
  readonly ttlMs: number;
}

/** Whether a position lies within the fence or on it. One that cannot be computed does not. [NCP-SAFE-045] */
export function isWithin(radius: number, position: ArrayLike<number>): boolean {
  return isAtMost(position, radius);
}

/**
 * How many ticks of the horizon a plant can follow from a position without leaving the fence, or `null`
 * when it cannot even follow tick 0. The ball is convex, so the ends of the ticks decide. [NCP-SAFE-054]
 */
export function ticksWithin(radius: number, position: ArrayLike<number>, plan: Plan): number | null {
  const { velocities, tickMs, ttlMs } = plan;
  if (velocities.length > 1) {
    let at = position;
    let kept = velocities.length - 1;
    for (let tick = 0; tick < velocities.length; tick++) {
      const begin = tick * tickMs;
      if (begin >= ttlMs) break; // The plant holds before this tick.
      at = moved(at, velocities[tick]!, Math.min(begin + tickMs, ttlMs) - begin);
      if (isWithin(radius, at)) continue;
      if (tick === 0) return null; // [NCP-SAFE-051]
      kept = tick - 1; // [NCP-SAFE-050]
      break;
    }
    if (kept > 0) return kept;
  }
  // Without a horizon, the plant follows tick 0 to the end. [NCP-SAFE-051] [NCP-SAFE-053]
  return isWithin(radius, moved(position, velocities[0]!, ttlMs)) ? 0 : null;
}

function moved(from: ArrayLike<number>, velocity: Float64Array, forMs: number): Float64Array {
  return velocity.map((component, axis) => from[axis]! + component * (forMs / 1000));
}
