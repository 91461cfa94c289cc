// The shapes of items as the page keeps them, and the geometry that pointing at them needs.

export type Kind = 'point' | 'segment' | 'polyline' | 'polygon';

export interface Shape {
  readonly kind: Kind;
  /** x, y of all points, ring after ring. */
  readonly points: Float64Array;
  /** The number of points of each ring of a polygon with several rings. */
  readonly rings?: readonly number[];
  readonly fill?: 'nonzero';
}

export type Bounds = readonly [minX: number, minY: number, maxX: number, maxY: number];

export function makeShape(kind: Kind, points: ArrayLike<number>): Shape {
  return { kind, points: Float64Array.from(points) };
}

export function boundsOf({ points }: Shape): Bounds {
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i + 1 < points.length; i += 2) {
    const [x, y] = [points[i]!, points[i + 1]!];
    if (x < x0) x0 = x;
    if (x > x1) x1 = x;
    if (y < y0) y0 = y;
    if (y > y1) y1 = y;
  }
  return [x0, y0, x1, y1];
}

export function unite(a: Bounds, b: Bounds): Bounds {
  return [Math.min(a[0], b[0]), Math.min(a[1], b[1]), Math.max(a[2], b[2]), Math.max(a[3], b[3])];
}

export function overlap(a: Bounds, b: Bounds): boolean {
  return a[0] <= b[2] && b[0] <= a[2] && a[1] <= b[3] && b[1] <= a[3];
}

export function grow(box: Bounds, by: number): Bounds {
  return [box[0] - by, box[1] - by, box[2] + by, box[3] + by];
}

/** Returns a shape, moved by (dx, dy). */
export function translate(shape: Shape, dx: number, dy: number): Shape {
  return { ...shape, points: shape.points.map((value, i) => value + (i % 2 === 0 ? dx : dy)) };
}

/** Returns a shape with one point at another position. */
export function withPoint(shape: Shape, index: number, x: number, y: number): Shape {
  const points = shape.points.slice();
  points[2 * index] = x;
  points[2 * index + 1] = y;
  return { ...shape, points };
}

/** Returns the ranges of points of the rings of a shape: first, end, first, end, ... */
export function ringRanges(shape: Shape): number[] {
  if (shape.rings === undefined) return [0, shape.points.length / 2];
  const ranges: number[] = [];
  let first = 0;
  for (const size of shape.rings) {
    ranges.push(first, first + size);
    first += size;
  }
  return ranges;
}

function windingOf(shape: Shape, x: number, y: number): number {
  const { points } = shape;
  const ranges = ringRanges(shape);
  let winding = 0;
  for (let r = 0; r < ranges.length; r += 2) {
    const [first, end] = [ranges[r]!, ranges[r + 1]!];
    for (let i = first, j = end - 1; i < end; j = i++) {
      const [ax, ay, bx, by] = [points[2 * j]!, points[2 * j + 1]!, points[2 * i]!, points[2 * i + 1]!];
      if (ay <= y === by <= y) continue;
      const turn = (bx - ax) * (y - ay) - (x - ax) * (by - ay);
      if (ay <= y && turn > 0) ++winding;
      if (ay > y && turn < 0) --winding;
    }
  }
  return winding;
}

/** Whether a position lies inside a polygon, in plain doubles. */
export function isInside(shape: Shape, x: number, y: number): boolean {
  if (shape.kind !== 'polygon') return false;
  const winding = windingOf(shape, x, y);
  return shape.fill === 'nonzero' ? winding !== 0 : winding % 2 !== 0;
}

function segmentDistance(px: number, py: number, ax: number, ay: number, bx: number, by: number): number {
  const [dx, dy] = [bx - ax, by - ay];
  const square = dx * dx + dy * dy;
  const t = square === 0 ? 0 : Math.min(1, Math.max(0, ((px - ax) * dx + (py - ay) * dy) / square));
  return Math.hypot(px - ax - t * dx, py - ay - t * dy);
}

/** The distance from a position to a shape: 0 inside a polygon. */
export function distanceTo(shape: Shape, x: number, y: number): number {
  if (isInside(shape, x, y)) return 0;
  const { points, kind } = shape;
  if (points.length === 2) return Math.hypot(points[0]! - x, points[1]! - y);
  const ranges = ringRanges(shape);
  let least = Infinity;
  for (let r = 0; r < ranges.length; r += 2) {
    const [first, end] = [ranges[r]!, ranges[r + 1]!];
    for (let i = first; i + 1 < end + (kind === 'polygon' ? 1 : 0); ++i) {
      const next = i + 1 < end ? i + 1 : first;
      const [ax, ay] = [points[2 * i]!, points[2 * i + 1]!];
      least = Math.min(least, segmentDistance(x, y, ax, ay, points[2 * next]!, points[2 * next + 1]!));
    }
  }
  return least;
}

/** A regular polygon around a centre. */
export function regularPolygon(x: number, y: number, radius: number, corners: number, turn = 0): Shape {
  const points = new Float64Array(2 * corners);
  for (let i = 0; i < corners; ++i) {
    const angle = turn + (2 * Math.PI * i) / corners;
    points[2 * i] = x + radius * Math.cos(angle);
    points[2 * i + 1] = y + radius * Math.sin(angle);
  }
  return { kind: 'polygon', points };
}
