import type { Domain, FillRule, Item, ItemKind, XY } from './types';
import { LARGEST_COORDINATE } from './types';

/** A shape as the npm package `waywright` takes it. */
export interface PackedShape {
  readonly kind: ItemKind;
  readonly points: Float64Array;
  readonly ringSizes: number[];
  readonly fill: FillRule;
}

/** Returns the rings of an item. A point, a segment and a polyline have one. */
export function ringsOf(item: Item): readonly (readonly XY[])[] {
  if (item.kind === 'polygon') return item.rings;
  return item.kind === 'point' ? [[item.xy]] : [item.points];
}

/** Returns an item as the engine takes it. */
export function toShape(item: Item): PackedShape {
  const rings = ringsOf(item);
  const ringSizes = rings.map((ring) => ring.length);
  const points = new Float64Array(2 * ringSizes.reduce((sum, size) => sum + size, 0));
  let at = 0;
  for (const ring of rings) {
    for (const [x, y] of ring) {
      points[at++] = x;
      points[at++] = y;
    }
  }
  const fill = item.kind === 'polygon' ? (item.fill ?? 'even-odd') : 'even-odd';
  return { kind: item.kind, points, ringSizes, fill };
}

/** Returns an item from its rings. A point takes the first corner, a segment the first two. */
export function makeItem(kind: ItemKind, rings: XY[][], fill: FillRule = 'even-odd'): Item {
  const [first = []] = rings;
  const corner = (index: number): XY => first[index] ?? first[0] ?? [0, 0];
  if (kind === 'polygon') return fill === 'nonzero' ? { kind, rings, fill } : { kind, rings };
  if (kind === 'polyline') return { kind, points: first };
  return kind === 'segment' ? { kind, points: [corner(0), corner(1)] } : { kind, xy: corner(0) };
}

/** Returns the exponent of a positive normal number: the largest e with 2^e <= value. */
function exponentOf(value: number): number {
  const bits = new DataView(new ArrayBuffer(8));
  bits.setFloat64(0, value);
  return ((bits.getUint16(0) >>> 4) & 0x7ff) - 1023;
}

function powerOfTwo(exponent: number): number {
  const bits = new DataView(new ArrayBuffer(8));
  bits.setUint16(0, (exponent + 1023) << 4);
  return bits.getFloat64(0);
}

/** Returns the smallest box that contains all corners, or null if there is none. */
export function boundsOf(items: readonly Item[]): [number, number, number, number] | null {
  const box: [number, number, number, number] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const item of items) {
    for (const ring of ringsOf(item)) {
      for (const [x, y] of ring) {
        box[0] = Math.min(box[0], x);
        box[1] = Math.min(box[1], y);
        box[2] = Math.max(box[2], x);
        box[3] = Math.max(box[3], y);
      }
    }
  }
  return box[0] <= box[2] ? box : null;
}

/**
 * Returns a domain with a margin around all corners. Its bounds are multiples of a power of two, and never out of range.
 * The native command chooses the same domain for a `.poly`.
 */
export function domainAround(items: readonly Item[]): Domain {
  const [minX, minY, maxX, maxY] = boundsOf(items) ?? [0, 0, 0, 0];
  const extent = Math.max(maxX - minX, maxY - minY);
  const size = Math.max(Math.abs(minX), Math.abs(minY), Math.abs(maxX), Math.abs(maxY));
  // Far from the origin, rounding would swallow a margin of 1. There the least margin depends on the distance of
  // neighbouring doubles.
  const margin = Math.max(1, extent / 8, size * powerOfTwo(-48));
  const unit = powerOfTwo(Math.max(0, exponentOf(margin) - 1));
  const low = (value: number): number => Math.max(Math.floor((value - margin) / unit) * unit, -LARGEST_COORDINATE);
  const high = (value: number): number => Math.min(Math.ceil((value + margin) / unit) * unit, LARGEST_COORDINATE);
  return [low(minX), low(minY), high(maxX), high(maxY)];
}
