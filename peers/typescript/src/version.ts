/**
 * The wire version and its guard (chapter 2.1).
 *
 * @module
 */

import { VersionError } from "./errors.js";
import { NCP_VERSION } from "./identity.js";

/**
 * Compares a peer's wire version with this library's.
 *
 * @param version - the peer's, such as `"1.2"`; a missing minor is 0
 * @param strict - whether an incompatible version is an error instead of `false`
 * @returns whether the two can speak with each other
 * @throws {@link VersionError} when the version is malformed, or incompatible and `strict`
 *
 * Rules: NCP-VER-001 to NCP-VER-009.
 */
export function checkVersion(version: string, strict = false): boolean {
  const theirs = parse(version);
  const ours = parse(NCP_VERSION);
  const sameMajor = theirs.major === ours.major; // [NCP-VER-004] [NCP-VER-005]
  const compatible = sameMajor && (ours.major !== "0" || theirs.minor === ours.minor); // [NCP-VER-003]
  if (!compatible && strict) {
    throw new VersionError(`version ${shown(version)} is not compatible with ${NCP_VERSION}`); // [NCP-VER-006]
  }
  return compatible; // [NCP-VER-007] [NCP-VER-008]
}

function parse(version: string): { major: string; minor: string } {
  // [NCP-VER-001] Without the flag `m`, `$` is the end of the string and no line feed before it.
  const parts = typeof version === "string" ? /^([0-9]+)(?:\.([0-9]+))?$/.exec(version) : null;
  if (parts === null) throw new VersionError(`${shown(version)} is not a version`);
  // [NCP-VER-002] [NCP-VER-009]
  return { major: withoutLeadingZeros(parts[1] ?? "0"), minor: withoutLeadingZeros(parts[2] ?? "0") };
}

function withoutLeadingZeros(digits: string): string {
  return digits.replace(/^0+(?=[0-9])/, "");
}

function shown(version: string): string {
  const text = String(version);
  return JSON.stringify(text.length > 40 ? `${text.slice(0, 40)}…` : text);
}
