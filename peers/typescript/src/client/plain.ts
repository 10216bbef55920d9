/**
 * Messages as plain JSON values, the form of the types in `wire`.
 *
 * @module
 */

import type * as wire from "../wire.js";
import type { Kind, Messages } from "../messages.js";

/** The message with an object for every map, and an array of numbers for every typed array. */
export function plain<K extends Kind>(message: Messages[K] & { readonly kind: K }): wire.Messages[K] {
  return plainValue(message) as wire.Messages[K];
}

/** The value with every map and typed array within it made plain. */
export function plainValue(value: unknown): unknown {
  if (value instanceof Float64Array) return Array.from(value);
  if (Array.isArray(value)) return value.map(plainValue);
  if (typeof value !== "object" || value === null) return value;
  const entries = value instanceof Map ? [...(value as Map<string, unknown>)] : Object.entries(value);
  // Makes own properties of all names, also of `__proto__`.
  return Object.fromEntries(entries.map(([name, inner]) => [name, plainValue(inner)]));
}
