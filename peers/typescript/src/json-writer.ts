/**
 * The spelling of JSON values.
 *
 * @module
 */

/** A finite double, so that reading it gives the same bits. [NCP-WIRE-084] [NCP-WIRE-015] */
export function numberText(value: number): string {
  // JavaScript spells the negative zero `0`. A fraction keeps its sign also in readers that tell integers apart.
  return value === 0 && 1 / value < 0 ? "-0.0" : String(value);
}

/** A safe integer, without fraction and exponent. [NCP-WIRE-085] */
export function integerText(value: number): string {
  return String(value);
}

/** A well-formed string. */
export function stringText(value: string): string {
  return JSON.stringify(value);
}

/** The items of a numeric array, written by `item`, without its brackets. */
export function itemsText(values: ArrayLike<number>, item: (value: number, index: number) => string): string {
  // In pieces, so that a long array makes a few flat strings and no deep rope.
  const pieces: string[] = [];
  for (let from = 0; from < values.length; from += PIECE) {
    const items: string[] = [];
    for (let i = from; i < Math.min(from + PIECE, values.length); i++) items.push(item(values[i]!, i));
    pieces.push(items.join(","));
  }
  return pieces.join(",");
}

const PIECE = 4_096;
