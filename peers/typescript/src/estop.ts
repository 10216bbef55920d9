/**
 * The search for an ESTOP in a frame that was rejected: an ESTOP is never lost.
 *
 * Here all that counts is that the bytes begin with one JSON object, and which members that object has.
 * Everything else that chapter 1 asks of a frame may be broken: members that repeat, types, limits,
 * numbers, the encoding within strings, a byte order mark before the object, whatever follows it.
 *
 * @module
 */

import { SHORT_ESCAPES, unitAt } from "./json-text.js";

/** Whether a frame is an object of kind `command_frame` with a member `mode` that is `estop`. [NCP-RES-022] */
export function asksForStop(frame: string | Uint8Array): boolean {
  const bytes = typeof frame === "string" ? new TextEncoder().encode(frame) : frame;
  const scan = new Scan(bytes);
  return scan.object() && scan.isCommand && scan.isStop;
}

/** Goes over one JSON object by its grammar alone, without recursion and in linear time. */
class Scan {
  /** Whether a member `kind` of the object is `command_frame`, and whether a member `mode` is `estop`. */
  isCommand = false;
  isStop = false;

  private readonly bytes: Uint8Array;
  private pos = 0;
  /** The name of the member of the outermost object that the position is in. */
  private member = "";

  constructor(bytes: Uint8Array) {
    this.bytes = bytes;
  }

  /** Whether there is an object, and it is complete. */
  object(): boolean {
    if (BYTE_ORDER_MARK.every((byte, n) => this.bytes[n] === byte)) this.pos = BYTE_ORDER_MARK.length;
    this.space();
    if (this.at() !== OPEN_BRACE) return false;
    /** The bytes that close the objects and arrays around the position. */
    const open = new Uint8Array(this.bytes.length);
    let levels = 0;
    for (;;) {
      // A value stands here.
      const byte = this.at();
      if (byte === OPEN_BRACE || byte === OPEN_BRACKET) {
        open[levels++] = byte === OPEN_BRACE ? CLOSE_BRACE : CLOSE_BRACKET;
        this.pos++;
        this.space();
        if (this.at() !== open[levels - 1]) {
          if (byte === OPEN_BRACE && !this.name(levels)) return false;
          continue;
        }
      } else if (!(byte === QUOTE ? this.stringValue(levels) : this.scalar())) {
        return false;
      }
      // What stood here has ended, and with it whatever closes now.
      for (this.space(); this.at() === open[levels - 1]; this.space()) {
        this.pos++;
        if (--levels === 0) return true;
      }
      if (!this.take(COMMA)) return false;
      this.space();
      if (open[levels - 1] === CLOSE_BRACE && !this.name(levels)) return false;
    }
  }

  /** Goes over a member's name and its colon. */
  private name(levels: number): boolean {
    const start = this.pos;
    if (this.at() !== QUOTE || !this.string()) return false;
    if (levels === 1) this.member = this.text(start);
    this.space();
    if (!this.take(COLON)) return false;
    this.space();
    return true;
  }

  private stringValue(levels: number): boolean {
    const start = this.pos;
    if (!this.string()) return false;
    if (levels === 1) {
      const text = this.text(start);
      if (this.member === "kind" && text === "command_frame") this.isCommand = true;
      if (this.member === "mode" && text === "estop") this.isStop = true;
    }
    return true;
  }

  private string(): boolean {
    for (this.pos++; ; this.pos++) {
      const byte = this.at();
      if (byte === QUOTE) break;
      if (byte < SPACE) return false; // A control character, or the end of the bytes.
      if (byte !== BACKSLASH) continue;
      this.pos++;
      const letter = this.at();
      if (letter === LOWER_U) {
        if (unitAt(this.bytes, this.pos + 1) < 0) return false;
        this.pos += 4;
      } else if (letter < 0 || SHORT_ESCAPES[letter] === 0) {
        return false;
      }
    }
    this.pos++;
    return true;
  }

  /** The string that begins at `start` and was just gone over; none if it is longer than any that counts here. */
  private text(start: number): string {
    if (this.pos - start > LONGEST) return "";
    return JSON.parse(String.fromCharCode(...this.bytes.subarray(start, this.pos))) as string;
  }

  /** Goes over a number, `true`, `false` or `null`. */
  private scalar(): boolean {
    for (const word of WORDS) {
      if (word.every((byte, n) => this.bytes[this.pos + n] === byte)) {
        this.pos += word.length;
        return true;
      }
    }
    this.take(MINUS);
    if (!this.take(ZERO) && !this.digits()) return false;
    if (this.take(POINT) && !this.digits()) return false;
    if (this.take(LOWER_E) || this.take(UPPER_E)) {
      if (!this.take(PLUS)) this.take(MINUS);
      return this.digits();
    }
    return true;
  }

  private digits(): boolean {
    const start = this.pos;
    while (this.at() >= ZERO && this.at() <= NINE) this.pos++;
    return this.pos > start;
  }

  private space(): void {
    while (this.take(SPACE) || this.take(LINE_FEED) || this.take(CARRIAGE_RETURN) || this.take(TAB));
  }

  private take(byte: number): boolean {
    const there = this.at() === byte;
    if (there) this.pos++;
    return there;
  }

  private at(): number {
    return this.bytes[this.pos] ?? -1;
  }
}

/** `"command_frame"` with every letter escaped. */
const LONGEST = 2 + 6 * "command_frame".length;

const BYTE_ORDER_MARK = [0xef, 0xbb, 0xbf];
const WORDS = ["true", "false", "null"].map((word) => Array.from(word, (letter) => letter.charCodeAt(0)));

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
const LOWER_U = 0x75;
const OPEN_BRACE = 0x7b;
const CLOSE_BRACE = 0x7d;
