import { arena, copyNumbers, packPoints, packSizes, type Point, pointCount, type Points, readList, toSize } from './buffers.js';
import { refuse } from './errors.js';
import { ww_shape } from './generated/abi.js';
import { check, lib, slots } from './runtime.js';
import { answer, type Box, put, readBox, readPoint, toEnum, writeBox, writePoint } from './values.js';

/** The kind of an item: a vertex, a wall, an open chain of walls, or a solid obstacle. */
export type ItemKind = 'point' | 'segment' | 'polyline' | 'polygon';
/** Which positions lie inside a polygon: those with an odd winding number, or those whose winding number is not 0. */
export type FillRule = 'even-odd' | 'nonzero';

export const ITEM_KINDS = ['point', 'segment', 'polyline', 'polygon'] as const;
export const FILL_RULES = ['even-odd', 'nonzero'] as const;

/** The geometry of an item. */
export interface Shape {
  readonly kind: ItemKind;
  /** All points. The rings of a polygon follow one after the other. */
  readonly points: Points;
  /** The number of points of each ring. The default is one ring. */
  readonly ringSizes?: ArrayLike<number>;
  /** For a polygon. The default is `even-odd`. */
  readonly fill?: FillRule;
}

function flat(points: Points): Float64Array {
  const result = new Float64Array(2 * pointCount(points));
  for (let i = 0; i < points.length; ++i) {
    const value = points[i] as number | Point;
    if (typeof value === 'object') result.set([value.x, value.y], 2 * i);
    else result[i] = value;
  }
  return result;
}

function isRings(points: Points | readonly Points[]): points is readonly Points[] {
  const first = points[0];
  return typeof first === 'object' && 'length' in first;
}

/** Functions that make shapes. */
export const Shape = {
  point: (point: Point): Shape => ({ kind: 'point', points: [point] }),
  segment: (a: Point, b: Point): Shape => ({ kind: 'segment', points: [a, b] }),
  polyline: (points: Points): Shape => ({ kind: 'polyline', points }),
  /** A polygon of one ring, or of a list of rings. */
  polygon(points: Points | readonly Points[], fill: FillRule = 'even-odd'): Shape {
    if (!isRings(points)) return { kind: 'polygon', points, fill };
    const rings = points.map(flat);
    const ringSizes = rings.map((ring) => ring.length / 2);
    const all = new Float64Array(rings.reduce((sum, ring) => sum + ring.length, 0));
    let done = 0;
    for (const ring of rings) {
      all.set(ring, done);
      done += ring.length;
    }
    return { kind: 'polygon', points: all, ringSizes, fill };
  },
  /** A rectangle, counter-clockwise from its lower left corner. */
  rectangle(box: Box): Shape {
    const list = readList(16, (buffer, capacity, count) =>
      lib.ww_rectangle(writeBox(slots.box, box), buffer, capacity, count),
    );
    return { kind: 'polygon', points: copyNumbers(list.address, 2 * list.count) };
  },
  /** A regular polygon of 3 corners or more, counter-clockwise from the corner to the right. */
  regularPolygon(centre: Point, radius: number, cornerCount: number): Shape {
    const corners = toSize(cornerCount);
    const list = readList(16, (buffer, capacity, count) =>
      lib.ww_regular_polygon(writePoint(slots.a, centre), radius, corners, buffer, capacity, count),
    );
    return { kind: 'polygon', points: copyNumbers(list.address, 2 * list.count) };
  },
};

/** Writes a shape to a struct of the module. Its points go into the arena. */
export function packShape(shape: Shape, struct: number = slots.struct2): number {
  const points = packPoints(shape.points);
  const sizes = shape.ringSizes === undefined ? { address: 0, count: 0 } : packSizes(shape.ringSizes);
  check(lib.ww_shape_init(struct, ww_shape.size_));
  put.int(struct + ww_shape.kind, toEnum(ITEM_KINDS, shape.kind));
  put.int(struct + ww_shape.fill, toEnum(FILL_RULES, shape.fill ?? 'even-odd'));
  put.size(struct + ww_shape.points, points.address);
  put.size(struct + ww_shape.pointCount, points.count);
  // A list of no rings is not the same as the default.
  put.size(struct + ww_shape.ringSizes, sizes.address);
  put.size(struct + ww_shape.ringCount, sizes.count);
  return struct;
}

/** Returns a shape, moved by (dx, dy). */
export function translated(shape: Shape, dx: number, dy: number): Shape {
  arena.reset();
  const given = packShape(shape);
  const list = readList(16, (buffer, capacity, count) => lib.ww_translated(given, dx, dy, buffer, capacity, count));
  return { ...shape, points: copyNumbers(list.address, 2 * list.count) };
}

/** Returns the centroid of a shape with a point, in plain doubles. */
export function centroid(shape: Shape): Point {
  arena.reset();
  check(lib.ww_centroid(packShape(shape), slots.a));
  return readPoint(slots.a);
}

/** Returns the smallest box that contains the points, one or more. */
export function boundingBox(points: Points): Box {
  arena.reset();
  const { address, count } = packPoints(points);
  check(lib.ww_bounding_box(address, count, slots.box));
  return readBox(slots.box);
}

/** Many shapes of one kind in two arrays: the points of shape i are `offsets[i]` to `offsets[i + 1] - 1`. */
export interface RaggedPoints {
  readonly points: Float64Array;
  readonly offsets: ArrayLike<number>;
}

/** Calls `use` with the address of a struct for each of many shapes. */
export function forEachShape(kind: ItemKind, shapes: RaggedPoints, use: (struct: number) => void): void {
  const { points, offsets } = shapes;
  const { address, count } = packPoints(points);
  const struct = answer(ww_shape, slots.struct2);
  check(lib.ww_shape_init(struct, ww_shape.size_));
  put.int(struct + ww_shape.kind, toEnum(ITEM_KINDS, kind));
  for (let i = 0; i + 1 < offsets.length; ++i) {
    const [from, to] = [toSize(offsets[i]!), toSize(offsets[i + 1]!)];
    if (from > to || to > count) refuse(`offset ${i + 1} of ${offsets.length} is not between offset ${i} and ${count}`);
    put.size(struct + ww_shape.points, address + 16 * from);
    put.size(struct + ww_shape.pointCount, to - from);
    use(struct);
  }
}

