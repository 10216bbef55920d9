/**
 * Finds a repeated member name among the names of one object, of which a frame can have millions.
 *
 * @module
 */

import { stringText, unescape } from "./json-text.js";

/**
 * The member names of one object, kept as places in the frame: no name is copied, so that they take a
 * small constant times the bytes that they have there. [NCP-WIRE-070]
 */
export class Names {
  private readonly bytes: Uint8Array;
  private count = 0;
  /** A hash table with open addressing: where the name of each slot begins (0: free), where it ends, its hash. */
  private slots = new Int32Array(0);

  /** @param bytes - the frame in which the names stand */
  constructor(bytes: Uint8Array) {
    this.bytes = bytes;
  }

  /**
   * Adds a name; answers false when an equal one was there. [NCP-WIRE-007]
   *
   * @param start - where it begins, after its quote
   * @param end - where it ends, before its quote
   * @param escaped - whether it holds escapes
   */
  add(start: number, end: number, escaped: boolean): boolean {
    if (this.count * 2 >= this.slots.length / SLOT) this.grow();
    const { bytes, slots } = this;
    const hash = escaped ? hashOfEscaped(bytes.subarray(start, end)) : hashOf(bytes, start, end);
    let at = firstSlot(hash, slots);
    for (; slots[at] !== 0; at = nextSlot(at, slots)) {
      if (slots[at + 2] === hash && this.text(slots[at]!, slots[at + 1]!) === this.text(start, end)) return false;
    }
    slots[at] = start;
    slots[at + 1] = end;
    slots[at + 2] = hash;
    this.count++;
    return true;
  }

  private grow(): void {
    const old = this.slots;
    const slots = new Int32Array(Math.max(4 * SLOT, old.length * 2));
    for (let from = 0; from < old.length; from += SLOT) {
      if (old[from] === 0) continue;
      let at = firstSlot(old[from + 2]!, slots);
      while (slots[at] !== 0) at = nextSlot(at, slots);
      slots[at] = old[from]!;
      slots[at + 1] = old[from + 1]!;
      slots[at + 2] = old[from + 2]!;
    }
    this.slots = slots;
  }

  private text(start: number, end: number): string {
    return stringText(this.bytes, start, end, this.bytes.subarray(start, end).includes(BACKSLASH));
  }
}

const SLOT = 3;
const BACKSLASH = 0x5c;

/** Random numbers, a byte value each: a sender who does not know them cannot make many names collide. */
const SECRET = Int32Array.from({ length: 256 }, () => Math.floor(Math.random() * 2 ** 32));

function hashOf(bytes: Uint8Array, start: number, end: number): number {
  let hash = 0;
  for (let i = start; i < end; i++) {
    hash = Math.imul(hash ^ SECRET[bytes[i]!]!, 0x9e3779b1);
    hash ^= hash >>> 15;
  }
  return hash;
}

function hashOfEscaped(raw: Uint8Array): number {
  const name = unescape(raw);
  return hashOf(name, 0, name.length);
}

/** The number of slots is a power of two. */
function firstSlot(hash: number, slots: Int32Array): number {
  return (hash & (slots.length / SLOT - 1)) * SLOT;
}

function nextSlot(at: number, slots: Int32Array): number {
  return at + SLOT === slots.length ? 0 : at + SLOT;
}
