/**
 * A strict JSON reader over the bytes of one frame.
 *
 * It is driven by the caller, who knows which type stands where, so that no tree is built: what the
 * tables list goes straight into the message, and what they do not list is checked and skipped.
 * Every step is linear in the bytes that it reads.
 *
 * @module
 */

import { DecodeError, type ErrorCode } from "./errors.js";
import { sequenceLength, SHORT_ESCAPES, stringText, unitAt } from "./json-text.js";
import { LEVELS } from "./limits.js";
import { Names } from "./names.js";
import { isWellFormed } from "./unicode.js";

/** What stands at the reader's position, as far as its first byte tells. */
export type JsonType = "object" | "array" | "string" | "number" | "boolean" | "null";

/** Reads one JSON document, front to back. Every method throws {@link DecodeError} on malformed input. */
export class JsonReader {
  private readonly bytes: Uint8Array;
  private readonly end: number;
  private pos = 0;
  private levels = 0;
  /** Where the value at the position stands: the member names and indices that lead to it. */
  private readonly path: (string | number)[] = [];

  // The string that `scanString` found last, without its quotes.
  private stringStart = 0;
  private stringEnd = 0;
  private escaped = false;

  // The number that `scanNumber` found last.
  private value = 0;
  private plainInteger = false;

  constructor(bytes: Uint8Array) {
    this.bytes = bytes;
    this.end = bytes.length;
  }

  /** The error for the value at the position. */
  error(code: ErrorCode, message: string): DecodeError {
    return new DecodeError(code, message, this.path);
  }

  /** The type of the value that comes next. */
  peek(): JsonType {
    this.skipSpace();
    const byte = this.pos < this.end ? this.bytes[this.pos]! : -1;
    switch (byte) {
      case OPEN_BRACE:
        return "object";
      case OPEN_BRACKET:
        return "array";
      case QUOTE:
        return "string";
      case LOWER_T:
      case LOWER_F:
        return "boolean";
      case LOWER_N:
        return "null";
      default:
        if (byte === MINUS || isDigit(byte)) return "number";
        throw this.malformed("a value is expected");
    }
  }

  /** Steps into the object that comes next. */
  enterObject(): void {
    this.enter();
  }

  /** Steps into the array that comes next. */
  enterArray(): void {
    this.enter();
  }

  /**
   * Goes to the next member of the object that was entered, before its value.
   *
   * @param first - whether it would be the first
   * @returns its name, or `undefined` when the object has ended
   */
  nextMember(first: boolean): string | undefined {
    if (!first) this.path.pop();
    if (!this.nextName(first)) return undefined;
    const name = stringText(this.bytes, this.stringStart, this.stringEnd, this.escaped);
    this.path.push(name);
    return name;
  }

  /** No names yet, of an object of this document. */
  newNames(): Names {
    return new Names(this.bytes);
  }

  /** Adds the name of the member that was just gone to; answers false when it was there. */
  addName(names: Names): boolean {
    return names.add(this.stringStart, this.stringEnd, this.escaped);
  }

  /**
   * Goes to the next item of the array that was entered.
   *
   * @param index - the item's index
   * @returns whether there is one
   */
  nextItem(index: number): boolean {
    if (index > 0) this.path.pop();
    if (!this.hasItem(index === 0)) return false;
    this.path.push(index);
    return true;
  }

  /** Reads the string that comes next. */
  string(): string {
    this.scanString();
    return stringText(this.bytes, this.stringStart, this.stringEnd, this.escaped);
  }

  /** Reads `true` or `false`. */
  boolean(): boolean {
    const value = this.at() === LOWER_T;
    this.literal(value ? "true" : "false");
    return value;
  }

  /** Reads `null`. */
  null(): void {
    this.literal("null");
  }

  /** Reads the number that comes next as the nearest double. [NCP-WIRE-012] [NCP-WIRE-013] */
  number(): number {
    this.scanNumber();
    return this.value;
  }

  /** Reads the number that comes next as an integer. */
  integer(): number {
    this.scanNumber();
    if (!this.plainInteger) throw this.error("type", "the number is not spelled as an integer"); // [NCP-WIRE-010]
    // [NCP-WIRE-011]
    if (!Number.isSafeInteger(this.value)) throw this.error("value", "the integer is beyond ±(2^53 − 1)");
    return this.value;
  }

  /** Reads the array of numbers that comes next into 8 bytes an item. [NCP-WIRE-069] [NCP-WIRE-070] */
  numbers(integers: boolean): Float64Array {
    this.enterArray();
    const values = new Float64Array(this.itemsAhead());
    let n = 0;
    for (; this.nextItem(n); n++) {
      const found = this.peek();
      if (found !== "number") throw this.error("type", `number expected, ${found} found`); // [NCP-WIRE-050]
      values[n] = integers ? this.integer() : this.number();
    }
    return n === values.length ? values : values.subarray(0, n);
  }

  /** Checks the value that comes next and leaves it out. [NCP-WIRE-026] */
  skip(): void {
    switch (this.peek()) {
      case "object": {
        const names = this.newNames();
        this.enterObject();
        for (let first = true; this.nextName(first); first = false) {
          if (!this.addName(names)) throw this.malformed("a member name is repeated"); // [NCP-WIRE-007]
          this.skip();
        }
        return;
      }
      case "array":
        this.enterArray();
        for (let first = true; this.hasItem(first); first = false) this.skip();
        return;
      case "string":
        this.scanString();
        return;
      case "number":
        this.scanNumber(); // [NCP-WIRE-014]
        return;
      case "boolean":
        this.boolean();
        return;
      case "null":
        this.null();
        return;
    }
  }

  /** Accepts the end of the document, after white space at most. [NCP-WIRE-004] */
  finish(): void {
    this.skipSpace();
    if (this.pos < this.end) throw this.malformed("something follows the object");
  }

  private malformed(message: string): DecodeError {
    return this.error("malformed", `${message} at byte ${this.pos}`); // [NCP-WIRE-002]
  }

  /** The byte at the position, or −1 at the end. */
  private at(): number {
    return this.pos < this.end ? this.bytes[this.pos]! : -1;
  }

  private skipSpace(): void {
    // [NCP-WIRE-005]
    const { bytes, end } = this;
    let pos = this.pos;
    while (pos < end) {
      const byte = bytes[pos]!;
      if (byte !== SPACE && byte !== LINE_FEED && byte !== CARRIAGE_RETURN && byte !== TAB) break;
      pos++;
    }
    this.pos = pos;
  }

  private enter(): void {
    // [NCP-WIRE-064] [NCP-WIRE-065]
    if (++this.levels > LEVELS) throw this.error("limit", `there are more than ${LEVELS} levels`);
    this.pos++;
  }

  /** Goes over the next member's name and its colon, or over the end of the object. */
  private nextName(first: boolean): boolean {
    if (this.take(CLOSE_BRACE, first)) return false;
    if (this.at() !== QUOTE) throw this.malformed("a member name is expected");
    this.scanString();
    this.skipSpace();
    if (this.at() !== COLON) throw this.malformed("a colon is expected");
    this.pos++;
    return true;
  }

  private hasItem(first: boolean): boolean {
    return !this.take(CLOSE_BRACKET, first);
  }

  /** Takes the closing byte and answers true, or takes the comma before the next element. */
  private take(close: number, first: boolean): boolean {
    this.skipSpace();
    const byte = this.at();
    if (byte === close) {
      this.pos++;
      this.levels--;
      return true;
    }
    if (first) return false;
    if (byte !== COMMA) throw this.malformed(`a comma or ${String.fromCharCode(close)} is expected`);
    this.pos++;
    this.skipSpace();
    return false;
  }

  private literal(word: string): void {
    for (let i = 0; i < word.length; i++) {
      if (this.at() !== word.charCodeAt(i)) throw this.malformed(`${word} is expected`);
      this.pos++;
    }
  }

  /** How many items the array that was entered has, if it is one of numbers; at most one more if it is empty. */
  private itemsAhead(): number {
    const close = this.bytes.indexOf(CLOSE_BRACKET, this.pos);
    if (close < 0) throw this.malformed("the array does not end");
    let items = 1;
    for (let i = this.pos; i < close; i++) if (this.bytes[i] === COMMA) items++;
    // An item takes a digit and a comma, which bounds the memory that commas alone can claim.
    return Math.min(items, Math.ceil((close - this.pos) / 2));
  }

  /** Goes over a string and checks it. */
  private scanString(): void {
    const { bytes, end } = this;
    const start = this.pos + 1;
    let pos = start;
    let escaped = false;
    for (;;) {
      const byte = pos < end ? bytes[pos]! : -1;
      if (byte === QUOTE) break;
      if (byte === BACKSLASH) {
        this.pos = pos;
        this.scanEscape();
        pos = this.pos;
        escaped = true;
      } else if (byte >= 0x80) {
        const length = sequenceLength(bytes, pos);
        if (length === 0) {
          this.pos = pos;
          throw this.malformed("the frame is not UTF-8"); // [NCP-WIRE-001]
        }
        pos += length;
      } else if (byte >= 0x20) {
        pos++;
      } else {
        this.pos = pos;
        throw this.malformed(byte < 0 ? "the string does not end" : "a string holds a control character");
      }
    }
    this.pos = pos + 1;
    this.stringStart = start;
    this.stringEnd = pos;
    this.escaped = escaped;
  }

  private scanEscape(): void {
    const letter = this.bytes[this.pos + 1];
    if (letter !== LOWER_U) {
      if (letter === undefined || SHORT_ESCAPES[letter] === 0) throw this.malformed("an escape is not known");
      this.pos += 2;
      return;
    }
    const unit = this.scanUnit();
    if (unit < 0xd800 || unit > 0xdfff) return;
    // [NCP-WIRE-008]
    const pair = unit < 0xdc00 && this.at() === BACKSLASH && this.bytes[this.pos + 1] === LOWER_U;
    const low = pair ? this.scanUnit() : 0;
    if (low < 0xdc00 || low > 0xdfff) throw this.malformed("an escaped surrogate lacks its partner");
  }

  /** Reads `\uXXXX`. */
  private scanUnit(): number {
    const unit = unitAt(this.bytes, this.pos + 2);
    if (unit < 0) throw this.malformed("an escape lacks its four hexadecimal digits");
    this.pos += 6;
    return unit;
  }

  /** Reads a number into `value` and `plainInteger`. */
  private scanNumber(): void {
    const { bytes, end } = this;
    const start = this.pos;
    let pos = start;
    const negative = bytes[pos] === MINUS;
    if (negative) pos++;

    // The digits without the point make the integer `digits`; the number is digits · 10^scale.
    let digits = 0;
    let scale = 0;
    let significant = 0;
    const whole = pos;
    let byte = pos < end ? bytes[pos]! : -1;
    for (; isDigit(byte); byte = ++pos < end ? bytes[pos]! : -1) {
      digits = digits * 10 + (byte - ZERO);
      if (digits > 0) significant++;
    }
    const wholeDigits = pos - whole;
    if (wholeDigits === 0 || (wholeDigits > 1 && bytes[whole] === ZERO)) {
      this.pos = pos;
      throw this.malformed("a number is not spelled as JSON spells it");
    }
    let plain = true;
    if (byte === POINT) {
      plain = false;
      byte = ++pos < end ? bytes[pos]! : -1;
      const fraction = pos;
      for (; isDigit(byte); byte = ++pos < end ? bytes[pos]! : -1) {
        digits = digits * 10 + (byte - ZERO);
        if (digits > 0) significant++;
      }
      scale = fraction - pos;
      if (pos === fraction) {
        this.pos = pos;
        throw this.malformed("a number lacks the digits after its point");
      }
    }
    if (byte === LOWER_E || byte === UPPER_E) {
      plain = false;
      byte = ++pos < end ? bytes[pos]! : -1;
      const minus = byte === MINUS;
      if (minus || byte === PLUS) byte = ++pos < end ? bytes[pos]! : -1;
      const first = pos;
      let exponent = 0;
      for (; isDigit(byte); byte = ++pos < end ? bytes[pos]! : -1) exponent = exponent * 10 + (byte - ZERO);
      if (pos === first) {
        this.pos = pos;
        throw this.malformed("a number lacks the digits of its exponent");
      }
      scale += minus ? -exponent : exponent;
    }

    let value: number;
    if (significant <= 15 && scale >= -22 && scale <= 22) {
      // Both operands are exact doubles, so the one operation rounds as the nearest double does.
      value = scale < 0 ? digits / POWERS[-scale]! : digits * POWERS[scale]!;
      if (negative) value = -value; // [NCP-WIRE-015]
    } else {
      value = Number(stringText(bytes, start, pos, false));
      if (!Number.isFinite(value)) {
        throw this.error("malformed", "the number is beyond the largest double"); // [NCP-WIRE-013] [NCP-WIRE-014]
      }
    }
    this.pos = pos;
    this.value = value;
    this.plainInteger = plain && !(negative && digits === 0);
  }
}

/**
 * The UTF-8 bytes of a frame that came as text.
 *
 * @throws {@link DecodeError} when the text has no UTF-8 form, or more than `limit` bytes
 */
export function frameBytesOf(frame: string | Uint8Array, limit: number): Uint8Array {
  const tooLong = (): DecodeError => new DecodeError("limit", `the frame has more than ${limit} bytes`);
  // The units of a text are at most as many as its bytes, so a longer text need not be converted.
  if (frame.length > limit) throw tooLong();
  if (typeof frame !== "string") return frame;
  if (!isWellFormed(frame)) throw new DecodeError("malformed", "the frame holds a surrogate without its partner");
  const bytes = new TextEncoder().encode(frame);
  if (bytes.length > limit) throw tooLong();
  return bytes;
}

const TAB = 0x09;
const LINE_FEED = 0x0a;
const CARRIAGE_RETURN = 0x0d;
const SPACE = 0x20;
const QUOTE = 0x22;
const PLUS = 0x2b;
const COMMA = 0x2c;
const MINUS = 0x2d;
const POINT = 0x2e;
const ZERO = 0x30;
const NINE = 0x39;
const COLON = 0x3a;
const UPPER_E = 0x45;
const OPEN_BRACKET = 0x5b;
const BACKSLASH = 0x5c;
const CLOSE_BRACKET = 0x5d;
const LOWER_E = 0x65;
const LOWER_F = 0x66;
const LOWER_N = 0x6e;
const LOWER_T = 0x74;
const LOWER_U = 0x75;
const OPEN_BRACE = 0x7b;
const CLOSE_BRACE = 0x7d;

/** The powers of ten that are exact doubles. */
const POWERS = Array.from({ length: 23 }, (_, n) => Number(`1e${n}`));

function isDigit(byte: number): boolean {
  return byte >= ZERO && byte <= NINE;
}
