/**
 * The identity of the schema: the contract hash, and what a peer's hash means (chapters 2.2 and 2.3).
 *
 * @module
 */

import { ContractError } from "./errors.js";
import { NCP_CONTRACT_HASH } from "./identity.js";
import { checkVersion } from "./version.js";

/** What a peer's contract hash says: the same schema, another one, or nothing. */
export type ContractStatus = "match" | "mismatch" | "not_advertised";

/**
 * Compares a peer's contract hash with this library's. The answer is advice: a mismatch is to be
 * logged and is no reason to refuse the peer. [NCP-VER-025]
 *
 * @param peerHash - the peer's hash; `null` or `undefined` when it stated none
 */
export function contractStatus(peerHash: string | null | undefined): ContractStatus {
  if (peerHash === null || peerHash === undefined) return "not_advertised"; // [NCP-VER-022]
  return peerHash === NCP_CONTRACT_HASH ? "match" : "mismatch"; // [NCP-VER-023] [NCP-VER-024]
}

/**
 * Accepts only this library's contract hash: the strict opt-in of a deployment that wants one schema.
 *
 * @throws {@link ContractError} when the hash is another, or absent
 */
export function verifyContract(peerHash: string | null | undefined): void {
  const status = contractStatus(peerHash);
  if (status === "match") return; // [NCP-VER-027]
  if (status === "not_advertised") throw new ContractError("the peer states no contract hash"); // [NCP-VER-028]
  throw new ContractError(`the peer's contract hash is not ${NCP_CONTRACT_HASH}`); // [NCP-VER-026]
}

/**
 * The version guard, strict, and then the contract status.
 *
 * @throws {@link VersionError} when the version is malformed or incompatible, whatever the hash
 */
export function negotiate(version: string, peerHash: string | null | undefined): ContractStatus {
  checkVersion(version, true); // [NCP-VER-030]
  return contractStatus(peerHash); // [NCP-VER-031]
}

/** The contract hash of a schema: FNV-1a, 64 bits, over its canonical text. */
export function contractHashOf(proto: string): string {
  let hash = 0xcbf29ce484222325n;
  for (const byte of new TextEncoder().encode(canonicalText(proto))) {
    hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n);
  }
  return hash.toString(16).padStart(16, "0");
}

/** The text of a schema without what does not change its meaning: comments, layout, file options. */
export function canonicalText(proto: string): string {
  return withoutComments(proto)
    .split("\n")
    .map((line) => line.trim())
    .filter((line) => line !== "" && !/^(?:syntax|package |import |option )/.test(line))
    .join("\n");
}

function withoutComments(proto: string): string {
  // A quoted string comes first, so that what looks like a comment within it is kept.
  const token = /"(?:\\[^]|[^"\\])*"?|'(?:\\[^]|[^'\\])*'?|\/\/[^\n]*|\/\*[^]*?(?:\*\/|$)/g;
  return proto.replace(token, (found) => (found.startsWith("/") ? "" : found));
}
