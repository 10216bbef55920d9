/**
 * What stands in a JSON string: UTF-8 sequences and escapes.
 *
 * @module
 */

/**
 * The text of a string that was checked.
 *
 * @param start - where it begins, after its quote
 * @param end - where it ends, before its quote
 * @param escaped - whether it holds escapes
 */
export function stringText(bytes: Uint8Array, start: number, end: number, escaped: boolean): string {
  const raw = bytes.subarray(start, end);
  if (escaped) return UTF8.decode(unescape(raw));
  if (raw.length > 64 || !isAscii(raw)) return UTF8.decode(raw);
  return String.fromCharCode.apply(null, raw as unknown as number[]);
}

/** The UTF-8 form of a scanned string with escapes. The form of an escape is never longer than the escape. */
export function unescape(raw: Uint8Array): Uint8Array {
  const out = new Uint8Array(raw.length);
  let length = 0;
  for (let pos = 0; pos < raw.length;) {
    const byte = raw[pos]!;
    if (byte !== BACKSLASH) {
      out[length++] = byte;
      pos++;
      continue;
    }
    const letter = raw[pos + 1]!;
    if (letter !== LOWER_U) {
      out[length++] = SHORT_ESCAPES[letter]!;
      pos += 2;
      continue;
    }
    let point = unitAt(raw, pos + 2);
    pos += 6;
    if (point >= 0xd800 && point <= 0xdfff) {
      point = 0x10000 + ((point - 0xd800) << 10) + (unitAt(raw, pos + 2) - 0xdc00);
      pos += 6;
    }
    if (point < 0x80) {
      out[length++] = point;
    } else if (point < 0x800) {
      out[length++] = 0xc0 | (point >> 6);
      out[length++] = 0x80 | (point & 0x3f);
    } else if (point < 0x10000) {
      out[length++] = 0xe0 | (point >> 12);
      out[length++] = 0x80 | ((point >> 6) & 0x3f);
      out[length++] = 0x80 | (point & 0x3f);
    } else {
      out[length++] = 0xf0 | (point >> 18);
      out[length++] = 0x80 | ((point >> 12) & 0x3f);
      out[length++] = 0x80 | ((point >> 6) & 0x3f);
      out[length++] = 0x80 | (point & 0x3f);
    }
  }
  return out.subarray(0, length);
}

/** The UTF-16 unit that four hexadecimal digits spell, or −1 when they are not there. */
export function unitAt(bytes: Uint8Array, at: number): number {
  let unit = 0;
  for (let i = at; i < at + 4; i++) {
    const byte = bytes[i] ?? 0;
    const lower = byte | 0x20;
    if (isDigit(byte)) unit = unit * 16 + (byte - ZERO);
    else if (lower >= 0x61 && lower <= 0x66) unit = unit * 16 + (lower - 0x57);
    else return -1;
  }
  return unit;
}

/** The length of the well-formed UTF-8 sequence of two bytes or more at `at`, or 0 when there is none. */
export function sequenceLength(bytes: Uint8Array, at: number): number {
  const lead = bytes[at]!;
  const second = bytes[at + 1] ?? 0;
  if (lead < 0xc2 || lead > 0xf4) return 0;
  if (lead < 0xe0) return isTail(second) ? 2 : 0;
  const third = bytes[at + 2] ?? 0;
  if (lead < 0xf0) {
    // E0 begins no overlong form, ED no surrogate.
    const low = lead === 0xe0 ? 0xa0 : 0x80;
    const high = lead === 0xed ? 0x9f : 0xbf;
    return second >= low && second <= high && isTail(third) ? 3 : 0;
  }
  // F0 begins no overlong form, F4 nothing beyond U+10FFFF.
  const low = lead === 0xf0 ? 0x90 : 0x80;
  const high = lead === 0xf4 ? 0x8f : 0xbf;
  return second >= low && second <= high && isTail(third) && isTail(bytes[at + 3] ?? 0) ? 4 : 0;
}

function isTail(byte: number): boolean {
  return (byte & 0xc0) === 0x80;
}

function isAscii(bytes: Uint8Array): boolean {
  for (let i = 0; i < bytes.length; i++) if (bytes[i]! >= 0x80) return false;
  return true;
}

function isDigit(byte: number): boolean {
  return byte >= ZERO && byte <= 0x39;
}

const ZERO = 0x30;
const BACKSLASH = 0x5c;
const LOWER_U = 0x75;

/** What `\b` and the like stand for; 0 for letters that escape nothing. */
export const SHORT_ESCAPES = new Uint8Array(256);
for (const [letter, meaning] of ['""', "\\\\", "//", "b\b", "f\f", "n\n", "r\r", "t\t"]) {
  SHORT_ESCAPES[letter!.charCodeAt(0)] = meaning!.charCodeAt(0);
}

// Without `ignoreBOM`, the decoder would drop a U+FEFF at the begin of a string.
const UTF8 = new TextDecoder("utf-8", { ignoreBOM: true });
