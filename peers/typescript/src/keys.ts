/**
 * Keys: how they are built, what may stand in them, and which of them a pattern covers (chapter 3).
 *
 * @module
 */

import { KeyError } from "./errors.js";
import { SEGMENT_BYTES } from "./limits.js";
import { isRequestKind, type RequestKind } from "./requests.js";
import { isWellFormed, utf8Length } from "./unicode.js";

/** The realm of a deployment that names none. [NCP-KEY-006] */
export const DEFAULT_REALM = "ncp";

/** Builds the keys of one realm. Every method throws {@link KeyError} for an id or a name that no key may hold. */
export class Keys {
  /** The first part of every key. */
  readonly realm: string;

  /**
   * @param realm - one segment or more, joined with `/`; `null` or nothing for {@link DEFAULT_REALM}
   * @throws {@link KeyError} when a segment of the realm is invalid
   */
  constructor(realm?: string | null) {
    this.realm = realm ?? DEFAULT_REALM;
    validateRealm(this.realm);
  }

  /** The key of the control plane. [NCP-KEY-001] */
  rpc(): string {
    return `${this.realm}/rpc`;
  }

  /**
   * The strict profile's key of one verb of the control plane, so that access rules can tell the verbs apart.
   * [NCP-STRICT-001]
   *
   * @param kind - the kind of the request
   * @throws {@link KeyError} for anything but the kind of a request [NCP-STRICT-006]
   */
  rpcVerb(kind: RequestKind): string {
    if (!isRequestKind(kind)) throw new KeyError("a verb of the control plane is the kind of a request");
    return `${this.rpc()}/${kind}`;
  }

  /** The key of a session's sensor frames, or of one named stream of them. [NCP-KEY-002] */
  sensor(session: string, name?: string | null): string {
    return this.#stream(session, "sensor", name);
  }

  /** The key of a session's command frames, or of one named stream of them. [NCP-KEY-003] */
  command(session: string, name?: string | null): string {
    return this.#stream(session, "command", name);
  }

  /** The key of a session's observation frames. [NCP-KEY-004] */
  observation(session: string): string {
    return `${this.#session(session)}/observation`;
  }

  /** Covers all sensor streams of a session. [NCP-KEY-005] */
  sensorGlob(session: string): string {
    return `${this.#session(session)}/sensor/**`;
  }

  /** Covers all command streams of a session. [NCP-KEY-005] */
  commandGlob(session: string): string {
    return `${this.#session(session)}/command/**`;
  }

  /** Covers everything of a session. [NCP-KEY-005] */
  sessionGlob(session: string): string {
    return `${this.#session(session)}/**`;
  }

  /** Covers all sessions of the realm. [NCP-KEY-005] */
  fleetGlob(): string {
    return `${this.realm}/session/**`;
  }

  #stream(session: string, plane: "sensor" | "command", name: string | null | undefined): string {
    const key = `${this.#session(session)}/${plane}`;
    if (name === null || name === undefined) return key;
    validateSegment(name);
    return `${key}/${name}`; // [NCP-KEY-007]
  }

  #session(session: string): string {
    validateSegment(session);
    return `${this.realm}/session/${session}`; // [NCP-KEY-007]
  }
}

/**
 * Accepts what may stand between two slashes of a key: an id, a name, a part of a realm.
 *
 * @throws {@link KeyError} with the reason
 */
export function validateSegment(segment: string): void {
  const fault = faultOf(segment);
  if (fault !== undefined) throw new KeyError(`a segment ${fault}`); // [NCP-KEY-019]
}

/** Whether {@link validateSegment} accepts the text. */
export function isSegment(text: string): boolean {
  return faultOf(text) === undefined;
}

/**
 * Accepts one segment or more, joined with `/`. [NCP-KEY-018]
 *
 * @throws {@link KeyError} with the reason
 */
export function validateRealm(realm: string): void {
  if (typeof realm !== "string") throw new KeyError("a realm is not a string");
  for (const segment of realm.split("/")) validateSegment(segment);
}

/**
 * Whether a key expression covers a key, by Zenoh's rules for `*`, `**`, `$*` and `@`.
 *
 * @param pattern - a key expression, with or without wildcards
 * @param key - a key without wildcards
 * @throws {@link KeyError} when one of them is not a valid key expression [NCP-KEY-036]
 */
export function matches(pattern: string, key: string): boolean {
  const wanted = chunksOf(pattern);
  const given = chunksOf(key);
  if (key.includes("*")) throw new KeyError("a key holds a wildcard");
  // Each `**` takes as little as it can; on a mismatch the last one takes one chunk more.
  let w = 0;
  let g = 0;
  let afterAny = -1;
  let taken = 0;
  while (g < given.length) {
    const chunk = wanted[w];
    if (chunk === "**") {
      afterAny = ++w; // [NCP-KEY-032]
      taken = g;
    } else if (chunk !== undefined && chunkMatches(chunk, given[g]!)) {
      w++;
      g++;
    } else if (afterAny >= 0 && !given[taken]!.startsWith("@")) {
      g = ++taken;
      w = afterAny;
    } else {
      return false; // [NCP-KEY-030]
    }
  }
  while (wanted[w] === "**") w++;
  return w === wanted.length;
}

/** What makes the text unfit as a segment, or nothing. */
function faultOf(segment: string): string | undefined {
  if (typeof segment !== "string") return "is not a string";
  if (segment === "") return "is empty"; // [NCP-KEY-010]
  if (/[/*$#?]/.test(segment)) return "holds /, *, $, # or ?"; // [NCP-KEY-011]
  if (/[ \t\n\v\f\r]/.test(segment)) return "holds white space"; // [NCP-KEY-012]
  if (segment.startsWith("@")) return "begins with @"; // [NCP-KEY-013]
  if (segment === "." || segment === "..") return "is . or .."; // [NCP-KEY-014]
  if (/[\x00-\x1f\x7f]/.test(segment)) return "holds a control character"; // [NCP-KEY-015]
  if (/[\x80-\x9f]/.test(segment)) return "holds a control character"; // [NCP-KEY-016]
  if (!isWellFormed(segment)) return "holds a surrogate without its partner";
  if (utf8Length(segment) > SEGMENT_BYTES) return `has more than ${SEGMENT_BYTES} bytes`; // [NCP-KEY-017]
  return undefined; // [NCP-KEY-020]
}

/** The chunks of a valid key expression. */
function chunksOf(expression: string): string[] {
  if (typeof expression !== "string") throw new KeyError("a key expression is not a string");
  if (!isWellFormed(expression)) throw new KeyError("a key expression has no UTF-8 form");
  const chunks = expression.split("/");
  for (const chunk of chunks) {
    if (chunk === "") throw new KeyError("a key expression has an empty chunk");
    if (/[#?]/.test(chunk)) throw new KeyError("a key expression holds # or ?");
    if (chunk === "*" || chunk === "**") continue;
    if (/[*$]/.test(chunk.replaceAll("$*", ""))) {
      throw new KeyError("within a chunk of a key expression, * and $ stand only as $*");
    }
  }
  return chunks;
}

function chunkMatches(pattern: string, chunk: string): boolean {
  if (pattern === chunk) return true; // [NCP-KEY-035]
  if (chunk.startsWith("@")) return false; // [NCP-KEY-034]
  if (pattern === "*") return true; // [NCP-KEY-031]
  return pattern.includes("$*") && runMatches(pattern.split("$*"), chunk);
}

/** Whether the pieces stand in the chunk in their order, the first at its begin and the last at its end. */
function runMatches(pieces: readonly string[], chunk: string): boolean {
  const first = pieces[0]!;
  const last = pieces[pieces.length - 1]!;
  if (!chunk.startsWith(first)) return false;
  let from = first.length;
  for (const piece of pieces.slice(1, -1)) {
    const found = chunk.indexOf(piece, from); // [NCP-KEY-033]
    if (found < 0) return false;
    from = found + piece.length;
  }
  return chunk.length - last.length >= from && chunk.endsWith(last);
}
