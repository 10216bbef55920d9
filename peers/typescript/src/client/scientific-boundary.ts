/**
 * The epistemic pins of a frame that a program already holds as an object (chapter 6).
 *
 * @module
 */

import { NcpScientificBoundaryError } from "../errors.js";
import { isKind } from "../messages.js";

/**
 * Asserts that a frame claims to be no more than the raw output of a model. `decode` and every client of
 * this library do so by themselves; this is for frames that came by another way, such as out of a file.
 *
 * An `observation_frame` has its pins itself, a `session_opened` in its `provenance`; frames of other kinds
 * have none. An absent pin holds. [NCP-PROV-005]
 *
 * @param frame - the parsed JSON of a frame, or a message of this library
 * @throws {@link NcpScientificBoundaryError} when a pin has another value, or this is no frame at all
 */
export function assertScientificBoundary(frame: unknown): void {
  if (!isObject(frame) || typeof frame["kind"] !== "string" || !isKind(frame["kind"])) {
    throw new NcpScientificBoundaryError("this is not a frame of a known kind");
  }
  if (frame["kind"] === "observation_frame") assertPins(frame); // [NCP-PROV-001] [NCP-PROV-002]
  if (frame["kind"] === "session_opened" && isObject(frame["provenance"])) {
    assertPins(frame["provenance"]); // [NCP-PROV-003] [NCP-PROV-004]
  }
}

function assertPins(holder: Record<string, unknown>): void {
  for (const [pin, value] of [
    ["calibrated_posterior", false],
    ["is_simulation_output", true],
  ] as const) {
    if (Object.hasOwn(holder, pin) && holder[pin] !== value) {
      throw new NcpScientificBoundaryError(`${pin} is not ${value}`);
    }
  }
}

function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}
