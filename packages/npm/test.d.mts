/** The peer, and what of the suite is asked of it. */
export interface Options {
  /** What starts the peer: its words, or one line in which quotes work as in a shell. */
  command?: readonly string[] | string;
  /** In its place, where the peer listens: `tcp://HOST:PORT` or `ws://HOST:PORT/PATH`. */
  connect?: string;
  /** Up to this level; `wire` unless named. */
  level?: "wire" | "safety" | "strict";
  /** Only the cases that fit, as `--filter` of the program. */
  filter?: string | readonly string[];
  /** A file of failures that are expected of the peer. */
  expected?: string;
  /** Run the deep set, too. */
  deep?: boolean;
}

/**
 * Has the program check the peer, and registers a test of `node:test` for each case, and one for the verdict.
 * Rejects where the peer cannot be started or the program is missing. The result follows `schemas/result.schema.json`.
 */
export function conform(options: Options): Promise<Record<string, unknown>>;
