/**
 * Base64 by RFC 4648 section 4, padded, as strict as an encoder that wrote it.
 *
 * @module
 */

/** The base64 text of some bytes. */
export function toBase64(bytes: Uint8Array): string {
  const pieces: string[] = [];
  // A multiple of 3, so that only the last piece is padded.
  for (let from = 0; from < bytes.length; from += 12_288) {
    const piece = bytes.subarray(from, from + 12_288);
    pieces.push(btoa(String.fromCharCode.apply(null, piece as unknown as number[])));
  }
  return pieces.join("");
}

/** The bytes of a base64 text, or `undefined` when it is not one that {@link toBase64} writes. */
export function fromBase64(text: string): Uint8Array<ArrayBuffer> | undefined {
  let decoded: string;
  try {
    decoded = atob(text);
  } catch {
    return undefined;
  }
  const bytes = new Uint8Array(decoded.length);
  for (let i = 0; i < bytes.length; i++) bytes[i] = decoded.charCodeAt(i);
  // `atob` forgives white space, absent padding and stray bits; writing them again shows them.
  return toBase64(bytes) === text ? bytes : undefined;
}
