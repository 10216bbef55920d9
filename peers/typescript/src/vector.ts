/**
 * Vectors of doubles of any finite size: no intermediate result overflows where the result itself does not.
 *
 * @module
 */

/** The Euclidean norm, infinite when it is beyond the largest double, NaN when a component is. */
export function norm(of: ArrayLike<number>): number {
  const [root, scale] = scaledNorm(of);
  return root / scale;
}

/** Whether the norm is not above a limit. Both are compared at one scale, at which the norm has lost no digit. */
export function isAtMost(of: ArrayLike<number>, limit: number): boolean {
  const [root, scale] = scaledNorm(of);
  return root <= limit * scale;
}

/** The norm times a power of two at which no square that counts leaves the doubles, and that power. */
function scaledNorm(of: ArrayLike<number>): [number, number] {
  const squares = sumOfSquares(of, 1);
  if (squares >= SAFE_LEAST && squares <= SAFE_MOST) return [Math.sqrt(squares), 1];
  let most = 0;
  for (let n = 0; n < of.length; n++) most = Math.max(most, Math.abs(of[n]!));
  if (most === 0 || !Number.isFinite(most)) return [most, 1];
  // Powers of two change no digit of what they scale.
  const scale = most < 1 ? SCALE : 1 / SCALE;
  return [Math.sqrt(sumOfSquares(of, scale)), scale];
}

/** Whether every component is finite. */
export function allFinite(of: ArrayLike<number>): boolean {
  for (let n = 0; n < of.length; n++) if (!Number.isFinite(of[n])) return false;
  return true;
}

/**
 * A finite vector, scaled so that its norm is not above the limit. One that is not longer is answered as it is.
 *
 * @param limit - finite and positive
 */
export function limited(vector: Float64Array, limit: number): Float64Array {
  if (isAtMost(vector, limit)) return vector; // [NCP-SAFE-062]
  const [root, scale] = scaledNorm(vector);
  const factor = (limit * scale) / root;
  // A quotient that has lost digits would take a component with it, and so would a small one over a huge norm: each is
  // reckoned where the other cannot be. [NCP-SAFE-061]
  const times = (component: number) =>
    factor >= SAFE_LEAST ? component * factor : ((component * scale) / root) * limit;
  for (let shrink = 0; ; shrink = Math.max(shrink * 2, Number.EPSILON)) {
    const scaled = vector.map((component) => times(component) * (1 - Math.min(shrink, 1)));
    // Rounding may leave the norm a little above the limit. At the latest, the zero vector is not. [NCP-SAFE-060] [NCP-SAFE-069]
    if (isAtMost(scaled, limit)) return scaled;
  }
}

/** With what each addition loses kept beside the sum: of many small squares behind a great one each would be lost. */
function sumOfSquares(of: ArrayLike<number>, scale: number): number {
  let sum = 0;
  let lost = 0;
  for (let n = 0; n < of.length; n++) {
    const component = of[n]! * scale;
    const square = component * component;
    const next = sum + square;
    lost += sum >= square ? sum - next + square : square - next + sum;
    sum = next;
  }
  return Number.isFinite(sum) ? sum + lost : sum;
}

/** Between these, a sum of squares has lost nothing that counts to an underflow or an overflow. */
const SAFE_LEAST = 2 ** -900;
const SAFE_MOST = Number.MAX_VALUE;
const SCALE = 2 ** 600;
