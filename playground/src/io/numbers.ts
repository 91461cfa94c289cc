/** Random numbers that are the same on every machine: mulberry32. */
export class Random {
  private state: number;

  constructor(seed: number) {
    this.state = seed;
  }

  /** Returns a whole number from 0 to count - 1. */
  below(count: number): number {
    this.state = (this.state + 0x6d2b79f5) | 0;
    let t = this.state;
    t = Math.imul(t ^ (t >>> 15), t | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) % count;
  }

  /** Returns a whole number from `low` to `high`. */
  between(low: number, high: number): number {
    return low + this.below(high - low + 1);
  }
}

/** Returns the multiple of 1 / `divisor` that is nearest to a value, and 0 instead of -0. */
export function rounded(value: number, divisor: number): number {
  return Math.round(value * divisor) / divisor + 0;
}

const PI = 3.141592653589793;

/**
 * Returns the point at an angle on the unit circle, in turns. Math.sin and Math.cos may differ between browsers; this sum
 * does not.
 */
export function onCircle(turns: number): readonly [number, number] {
  const quarter = Math.round(4 * turns);
  const angle = (turns - quarter / 4) * 2 * PI;
  let [cosine, sine, term] = [1, angle, angle];
  for (let n = 2; n < 24; n += 2) {
    const even = (term * angle) / n;
    term = -(even * angle) / (n + 1);
    cosine -= even;
    sine += term;
  }
  return rotated([cosine, sine], quarter);
}

/** Returns a point after `quarters` quarter turns about the origin. */
function rotated([x, y]: readonly [number, number], quarters: number): readonly [number, number] {
  switch (((quarters % 4) + 4) % 4) {
    case 1:
      return [-y, x];
    case 2:
      return [-x, -y];
    case 3:
      return [y, -x];
    default:
      return [x, y];
  }
}
