/**
 * The limits of section 1.6, where what is at a limit is read and what is beyond it is rejected, and
 * those of the chapters about behaviour.
 *
 * @module
 */

/** Bytes of a frame that is not an `observation_frame`: 1 MiB. */
export const FRAME_BYTES = 1_048_576;

/** Bytes of an `observation_frame`: 64 MiB. */
export const OBSERVATION_FRAME_BYTES = 67_108_864;

/** Levels of nested objects and arrays; the top-level object is the first. */
export const LEVELS = 64;

/** Entries of a map, and items of an array whose items are not numbers. */
export const ENTRIES = 4_096;

/** Bytes of UTF-8 of an id segment. */
export const SEGMENT_BYTES = 256;

/** Bytes of a BulkBlock: 64 MiB. */
export const BLOCK_BYTES = 67_108_864;

/** Columns of a BulkBlock. */
export const BLOCK_COLUMNS = 4_096;

/** The longest that a plant acts upon one command, ms. [NCP-RES-004] */
export const TTL_MS = 60_000;

/** Components of a channel that a rate codec maps. [NCP-CODEC-008] */
export const COMPONENTS = 4_096;

/** The bytes that a frame of this kind may have. [NCP-WIRE-060] [NCP-WIRE-062] */
export function frameBytes(kind: string): number {
  return kind === "observation_frame" ? OBSERVATION_FRAME_BYTES : FRAME_BYTES;
}
