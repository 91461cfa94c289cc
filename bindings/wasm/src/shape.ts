import { arena, copyList, copyNumbers, flatten, packPoints, packSizes, type Point, type Points, readList, toSize } from './buffers.js';
import { refuse, toNumber, toObject } from './errors.js';
import { ww_shape } from './generated/abi.js';
import { check, lib, scratch } from './runtime.js';
import { answer, type Box, put, readBox, readPoint, toEnum, writeBox, writePoint } from './values.js';

/** The kind of an item. */
export type ItemKind = 'point' | 'segment' | 'polyline' | 'polygon';
/** Which positions lie inside a polygon: those with an odd winding number, or those whose winding number is not 0. */
export type FillRule = 'even-odd' | 'nonzero';

export const ITEM_KINDS = ['point', 'segment', 'polyline', 'polygon'] as const;
export const FILL_RULES = ['even-odd', 'nonzero'] as const;

/** The form of an item. */
export interface Shape {
  readonly kind: ItemKind;
  /** All points. The rings of a polygon follow one after the other. */
  readonly points: Points;
  /** The number of points of each ring. The default is one ring. */
  readonly ringSizes?: ArrayLike<number>;
  /** For a polygon. The default is `even-odd`. */
  readonly fill?: FillRule;
}

function isRings(points: Points | readonly Points[]): points is readonly Points[] {
  const first = toObject(points, 'a list of points')[0];
  return typeof first === 'object' && first !== null && 'length' in first;
}

/** Refuses [[0, 0], [4, 0], [4, 4]]: this would be three rings of one corner each. */
function refusePairs(rings: readonly Points[]): void {
  const arePairs = rings.every((ring) => Array.isArray(ring) && ring.length === 2 && typeof ring[0] === 'number');
  if (arePairs) refuse('a list of [x, y] would be a list of rings with one corner each: write each point as { x, y }');
}

/** Functions that make shapes. */
export const Shape = {
  point: (point: Point): Shape => ({ kind: 'point', points: [point] }),
  segment: (a: Point, b: Point): Shape => ({ kind: 'segment', points: [a, b] }),
  polyline: (points: Points): Shape => ({ kind: 'polyline', points }),
  /** A polygon of one ring, or of a list of rings. */
  polygon(points: Points | readonly Points[], fill: FillRule = 'even-odd'): Shape {
    if (!isRings(points)) return { kind: 'polygon', points, fill };
    refusePairs(points);
    const rings = copyList(points, 'a list of rings', flatten);
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
    const given = writeBox(scratch.box, box);
    const list = readList(16, (buffer, capacity, count) => lib.ww_rectangle(given, buffer, capacity, count));
    return { kind: 'polygon', points: copyNumbers(list.address, 2 * list.count) };
  },
  /** A regular polygon, counter-clockwise from the corner to the right. A polygon has 3 corners or more: for fewer, the
      shape has no points, and a world refuses it with the code `bad-shape`. */
  regularPolygon(centre: Point, radius: number, cornerCount: number): Shape {
    const [at, size, corners] = [writePoint(scratch.a, centre), toNumber(radius, 'the radius'), toSize(cornerCount)];
    const list = readList(16, (buffer, capacity, count) =>
      lib.ww_regular_polygon(at, size, corners, buffer, capacity, count),
    );
    return { kind: 'polygon', points: copyNumbers(list.address, 2 * list.count) };
  },
};

/** A copy of a shape that a caller has given. */
export interface ShapeCopy {
  readonly kind: number;
  readonly fill: number;
  readonly coordinates: Float64Array;
  readonly sizes: readonly number[] | null;
}

export function copyShape(shape: Shape): ShapeCopy {
  const { kind, points, ringSizes, fill = 'even-odd' } = toObject(shape, 'a shape');
  return {
    kind: toEnum(ITEM_KINDS, kind),
    fill: toEnum(FILL_RULES, fill),
    coordinates: flatten(points),
    sizes: ringSizes === undefined ? null : copyList(ringSizes, 'a list of ring sizes', toSize),
  };
}

/** Writes a shape to a struct of the module. Its points go into the arena. */
export function packCopy({ kind, fill, coordinates, sizes: given }: ShapeCopy, struct: number): number {
  const points = packPoints(coordinates);
  const sizes = given === null ? { address: 0, count: 0 } : packSizes(given);
  check(lib.ww_shape_init(struct, ww_shape.size_));
  put.int(struct + ww_shape.kind, kind);
  put.int(struct + ww_shape.fill, fill);
  put.size(struct + ww_shape.points, points.address);
  put.size(struct + ww_shape.pointCount, points.count);
  // A list of no rings is not the same as the default.
  put.size(struct + ww_shape.ringSizes, sizes.address);
  put.size(struct + ww_shape.ringCount, sizes.count);
  return struct;
}

/** Starts a call, and writes its only shape to a struct of the module. */
export function packShape(shape: Shape): number {
  const copy = copyShape(shape);
  arena.reset();
  return packCopy(copy, scratch.struct2);
}

/** Returns a shape, moved by (dx, dy). */
export function translated(shape: Shape, dx: number, dy: number): Shape {
  const [right, up] = [toNumber(dx, 'dx'), toNumber(dy, 'dy')];
  const given = packShape(shape);
  const list = readList(16, (buffer, capacity, count) => lib.ww_translated(given, right, up, buffer, capacity, count));
  const points = copyNumbers(list.address, 2 * list.count);
  return { ...shape, points };
}

/** Returns the centroid of a shape with a point, in plain doubles. */
export function centroid(shape: Shape): Point {
  check(lib.ww_centroid(packShape(shape), scratch.a));
  return readPoint(scratch.a);
}

/** Returns the smallest box that contains the points, one or more. */
export function boundingBox(points: Points): Box {
  const coordinates = flatten(points);
  arena.reset();
  const { address, count } = packPoints(coordinates);
  check(lib.ww_bounding_box(address, count, scratch.box));
  return readBox(scratch.box);
}

/** Many shapes of one kind in two arrays: the points of shape i are `offsets[i]` to `offsets[i + 1] - 1`. */
export interface RaggedPoints {
  readonly points: Float64Array;
  readonly offsets: ArrayLike<number>;
}

/** Calls `use` with the address of a struct for each of many shapes. */
export function forEachShape(kind: ItemKind, shapes: RaggedPoints, use: (struct: number) => void): void {
  const { points, offsets: given } = toObject(shapes, 'the shapes');
  const [coordinates, offsets] = [flatten(points), copyList(given, 'the offsets', toSize)];
  const kindNumber = toEnum(ITEM_KINDS, kind);
  arena.reset();
  const { address, count } = packPoints(coordinates);
  const struct = answer(ww_shape, scratch.struct2);
  check(lib.ww_shape_init(struct, ww_shape.size_));
  put.int(struct + ww_shape.kind, kindNumber);
  offsets.forEach((to, i) => {
    if (to > count || to < (offsets[i - 1] ?? 0)) {
      refuse(`offset ${i} of ${offsets.length} is not between the offset before it and ${count}`);
    }
  });
  for (let i = 0; i + 1 < offsets.length; ++i) {
    const [from, to] = [offsets[i]!, offsets[i + 1]!];
    put.size(struct + ww_shape.points, address + 16 * from);
    put.size(struct + ww_shape.pointCount, to - from);
    use(struct);
  }
}

