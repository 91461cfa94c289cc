import { arena, copyIntegers, copyNumbers, copyPoint, packSizes, type Point, readList, readTwoLists, toSize } from './buffers.js';
import { type PathStatus } from './enums.js';
import { refuse, shown, toNumber, toObject, WaywrightError } from './errors.js';
import * as abi from './generated/abi.js';
import { Address, addressOf, contextAddress, Handle, make, ownAddressOf, type QueryContext } from './handle.js';
import { allocate, check, f64, lib, release, scratch, u32, u8 } from './runtime.js';
import { copyPathQuery, packPathQuery, type PathInfo, type PathPiece, type PathQuery, readPathInfo, readPathPiece, readWidestPath, type WidestPath } from './structs.js';
import { answer, askSize, get, isInRange, type ItemId, put, readIds, readPoint, toEnum, writePoint } from './values.js';

export type Precision = 'float64' | 'float32';

const PRECISIONS = ['float64', 'float32'] as const;

/** The straight connection between two walls at the gap between them. */
export interface Bridge {
  readonly from: Point;
  readonly to: Point;
  /** The largest radius of a disc that passes. */
  readonly radius: number;
  /** Whether the bridge ends strictly inside a wall. */
  readonly hasFoot: boolean;
  /** The items at its two ends. 0 is the border. */
  readonly fromItems: readonly ItemId[];
  readonly toItems: readonly ItemId[];
}

type BridgesCall = (a: number, roomA: number, countA: number, b: number, roomB: number, countB: number) => number;

export function readBridges(call: BridgesCall): Bridge[] {
  const { ww_bridge: layout } = abi;
  const [list, idList] = readTwoLists(layout.size_, call);
  const ids = readIds(idList);
  return Array.from({ length: list.count }, (_, i) => {
    const struct = list.address + i * layout.size_;
    const first = get.size(struct + layout.firstId);
    const middle = first + get.size(struct + layout.fromCount);
    return {
      from: readPoint(struct + layout.from),
      to: readPoint(struct + layout.to),
      radius: get.float(struct + layout.radius),
      hasFoot: get.flag(struct + layout.hasFoot),
      fromItems: ids.slice(first, middle),
      toItems: ids.slice(middle, middle + get.size(struct + layout.toCount)),
    };
  });
}

type WidestCall = (
  struct: number, a: number, roomA: number, countA: number, b: number, roomB: number, countB: number,
) => number;

export function readWidest(call: WidestCall): WidestPath {
  const struct = answer(abi.ww_widest_path);
  const [from, to] = readTwoLists(8, (a, roomA, countA, b, roomB, countB) =>
    call(answer(abi.ww_widest_path), a, roomA, countA, b, roomB, countB),
  );
  return readWidestPath(struct, readIds(from), readIds(to));
}

/** A position on a path. `Path.advance` changes it. */
export interface PathPosition {
  readonly at: { x: number; y: number };
  /** The direction of the path there, of length 1. */
  readonly heading: { x: number; y: number };
  /** The position lies between the points `segment` and `segment + 1`, or on this piece. */
  segment: number;
  /** The length of the path from its start to the start of this segment. */
  before: number;
  /** The length of the path from its start to this position. */
  distance: number;
}

function newPosition(): PathPosition {
  return { at: { x: 0, y: 0 }, heading: { x: 0, y: 0 }, segment: 0, before: 0, distance: 0 };
}

function writePosition(struct: number, position: PathPosition): void {
  const { ww_path_position: layout } = abi;
  const { at: givenAt, heading: givenHeading, segment, before, distance } = toObject(position, 'a position');
  const [at, heading] = [copyPoint(givenAt), copyPoint(givenHeading)];
  answer(layout, struct);
  writePoint(struct + layout.at, at);
  writePoint(struct + layout.heading, heading);
  put.size(struct + layout.segment, toSize(segment));
  put.float(struct + layout.before, toDistance(before));
  put.float(struct + layout.distance, toDistance(distance));
}

/** Returns a length along a path, or throws. */
function toDistance(value: number): number {
  if (!Number.isNaN(value)) return toNumber(value, 'a distance');
  throw new WaywrightError('bad-distance', 'a distance is NaN');
}

function readPosition(struct: number, position: PathPosition): PathPosition {
  const { ww_path_position: layout } = abi;
  const at = struct >>> 3;
  position.at.x = f64[at + (layout.at >>> 3)]!;
  position.at.y = f64[at + (layout.at >>> 3) + 1]!;
  position.heading.x = f64[at + (layout.heading >>> 3)]!;
  position.heading.y = f64[at + (layout.heading >>> 3) + 1]!;
  position.segment = get.size(struct + layout.segment);
  position.before = get.float(struct + layout.before);
  position.distance = get.float(struct + layout.distance);
  return position;
}

function readInfo(path: number): PathInfo {
  const struct = answer(abi.ww_path_info);
  check(lib.ww_path_get_info(path, struct));
  return readPathInfo(struct);
}

/**
 * The answer to a path query. Use one object for many queries: it keeps its memory. A function with a parameter `into`
 * writes to this array if the answer fits there, and returns the part with the answer; otherwise it returns a new array.
 */
export class Path extends Handle {
  private info_: PathInfo | null = null;
  private answers_ = 0;

  constructor();
  /** @internal */
  constructor(given: Address);
  constructor(given?: Address) {
    if (given instanceof Address) super(given.value, given.owner!);
    else super(make((at) => lib.ww_path_create(at)), (at) => lib.ww_path_destroy(at));
  }

  /** @internal Forgets what the wrapper knows of the last answer. */
  renew(): void {
    this.info_ = null;
    this.answers_ += 1;
  }

  /** @internal How many answers the object has had. */
  get answers(): number {
    return this.answers_;
  }

  /** All facts about the path. */
  get info(): PathInfo {
    const { address } = this;
    return (this.info_ ??= readInfo(address));
  }
  get status(): PathStatus {
    return this.info.status;
  }
  get isFound(): boolean {
    return this.info.status === 'found';
  }
  get length(): number {
    return this.info.length;
  }

  /** A copy, for example of a path that belongs to a list or a search. */
  copy(into: Path = new Path()): Path {
    const [from, to] = [this.address, ownAddressOf(Path, into)];
    into.renew();
    check(lib.ww_path_copy(from, to));
    return into;
  }

  /** The start, the turns and the goal. Empty if there is no path, or if the query has a radius above 0. */
  points(into?: Float64Array): Float64Array {
    const { address } = this;
    const list = readList(16, (buffer, capacity, count) => lib.ww_path_points(address, buffer, capacity, count));
    return copyNumbers(list.address, 2 * list.count, into);
  }

  /** The lines and arcs of the path of a disc. */
  pieces(): PathPiece[] {
    const { address } = this;
    const size = abi.ww_path_piece.size_;
    const list = readList(size, (buffer, capacity, count) => lib.ww_path_pieces(address, buffer, capacity, count));
    return Array.from({ length: list.count }, (_, i) => readPathPiece(list.address + i * size));
  }

  /** The edges that the path crosses, four numbers for each: its ends on the left and on the right, seen on the path. */
  channel(into?: Float64Array): Float64Array {
    const { address } = this;
    const list = readList(32, (buffer, capacity, count) => lib.ww_path_channel(address, buffer, capacity, count));
    return copyNumbers(list.address, 4 * list.count, into);
  }

  /** The items that block an end. */
  blockers(): ItemId[] {
    const { address } = this;
    return readIds(readList(8, (buffer, capacity, count) => lib.ww_path_blockers(address, buffer, capacity, count)));
  }

  /** The largest disc that can move from start to goal, if no path for the disc of the query exists; otherwise null. */
  widest(): WidestPath | null {
    const { address } = this;
    if (!this.info.hasWidest) return null;
    return readWidest((struct, ...lists) => lib.ww_path_widest(address, struct, ...lists));
  }

  /** The position at a distance from the start. Like the functions below, it needs a path that is found. */
  at(distance: number, precision: Precision = 'float64', into: PathPosition = newPosition()): PathPosition {
    const [wanted, kind] = [toDistance(distance), toEnum(PRECISIONS, precision)];
    const struct = answer(abi.ww_path_position);
    check(lib.ww_path_at(this.address, wanted, kind, struct));
    return readPosition(struct, into);
  }

  /** Moves a position of this path farther along the path by `step`. Returns the same object. */
  advance(position: PathPosition, step: number, precision: Precision = 'float64'): PathPosition {
    const [farther, kind] = [toDistance(step), toEnum(PRECISIONS, precision)];
    writePosition(scratch.struct, position);
    check(lib.ww_path_advance(this.address, farther, kind, scratch.struct));
    return readPosition(scratch.struct, position);
  }

  /** The position on the path that is nearest to a point. */
  nearest(point: Point, precision: Precision = 'float64', into: PathPosition = newPosition()): PathPosition {
    const [given, kind] = [copyPoint(point), toEnum(PRECISIONS, precision)];
    for (const each of [given.x, given.y]) {
      if (!isInRange(each)) throw new WaywrightError('coordinate-range', `no world accepts the coordinate ${each}`);
    }
    const [at, struct] = [writePoint(scratch.a, given), answer(abi.ww_path_position)];
    check(lib.ww_path_nearest(this.address, at, kind, struct));
    return readPosition(struct, into);
  }

  /** The path as points that are not farther than `tolerance` from it. */
  polyline(tolerance: number, into?: Float64Array): Float64Array {
    const [address, allowed] = [this.address, toNumber(tolerance, 'the tolerance')];
    const list = readList(16, (buffer, capacity, count) =>
      lib.ww_path_polyline(address, allowed, buffer, capacity, count),
    );
    return copyNumbers(list.address, 2 * list.count, into);
  }
}

/** The points of many paths: the points `offsets[i]` to `offsets[i + 1] - 1` belong to path i. */
export interface PathsPoints {
  readonly points: Float64Array;
  readonly offsets: Uint32Array;
}

/** The answers to several path queries. */
export class Paths extends Handle {
  constructor() {
    super(make((address) => lib.ww_paths_create(address)), (address) => lib.ww_paths_destroy(address));
  }

  /** @internal Invalidates the paths of the last answer. */
  renew(): void {
    this.changed();
  }

  /** The number of paths. */
  get length(): number {
    return askSize((count) => lib.ww_paths_count(this.address, count));
  }

  /** A path of the list. It belongs to the list, and is valid until the list changes. */
  get(index: number): Path {
    check(lib.ww_paths_get(this.address, toSize(index), scratch.pointer));
    return new Path(new Address(u32[scratch.pointer >>> 2]!, this));
  }

  /** The length of each path: 0 for a path without length, NaN for a path that is not found. */
  lengths(into?: Float64Array): Float64Array {
    const count = this.length;
    arena.reset();
    const lengths = arena.take(8 * count);
    const statuses = arena.take(count);
    check(lib.ww_js_paths_info(this.address, statuses, lengths));
    for (let i = 0; i < count; ++i) {
      if (u8[statuses + i] !== abi.WW_PATH_FOUND) f64[(lengths >>> 3) + i] = NaN;
    }
    return copyNumbers(lengths, count, into);
  }

  /** The points of all paths. */
  points(into?: Float64Array, offsetsInto?: Uint32Array): PathsPoints {
    const { address, length } = this;
    arena.reset();
    const offsets = arena.take(4 * (length + 1));
    const list = readList(16, (buffer, capacity, count) =>
      lib.ww_js_paths_points(address, offsets, buffer, capacity, count),
    );
    return {
      points: copyNumbers(list.address, 2 * list.count, into),
      offsets: copyIntegers(offsets, length + 1, offsetsInto),
    };
  }
}

/** The agents of a crowd: each walks along a path of its own. One call moves all of them. */
export class Walkers extends Handle {
  private readonly paths: (Path | null)[];
  /** How many answers each path had when its agent came onto it. */
  private readonly answers: number[];

  /** Makes `count` agents without paths. */
  constructor(readonly count: number) {
    const size = abi.ww_path_position.size_;
    const bytes = toSize(count) * size;
    if (bytes >= 2 ** 31) throw new WaywrightError('out-of-memory', `there is no memory for ${count} agents`);
    super(allocateZeroed(bytes), release);
    this.paths = new Array<Path | null>(count).fill(null);
    this.answers = new Array<number>(count).fill(0);
    for (let i = 0; i < count; ++i) answer(abi.ww_path_position, this.address + i * size);
  }

  private slot(index: number): number {
    if (!(Number.isInteger(index) && index >= 0 && index < this.count)) refuse(`there is no agent ${shown(index)}`);
    return this.address + index * abi.ww_path_position.size_;
  }

  private pathAddress(index: number): number {
    const path = this.paths[index] ?? null;
    if (path === null) return 0;
    if (path.answers === this.answers[index]) return path.address;
    return refuse(`the path of agent ${index} has another answer since: call set() again`);
  }

  /** Puts an agent on a path that is found, at its start or farther along it. Null takes it off its path. */
  set(index: number, path: Path | null, distance = 0): void {
    const [slot, wanted] = [this.slot(index), toDistance(distance)];
    if (path !== null) {
      check(lib.ww_path_at(addressOf(Path, path), wanted, abi.WW_FLOAT64, answer(abi.ww_path_position, slot)));
      this.answers[index] = path.answers;
    }
    this.paths[index] = path;
  }

  /** The position of an agent. */
  position(index: number, into: PathPosition = newPosition()): PathPosition {
    return readPosition(this.slot(index), into);
  }

  /** Moves all agents by `step`. Returns x, y and the heading x, y of each; an agent without a path stays where it is. */
  advance(step: number, into?: Float64Array): Float64Array {
    const [positions, farther] = [this.address, toDistance(step)];
    arena.reset();
    const addresses = packSizes(this.paths.map((_, i) => this.pathAddress(i)));
    const states = arena.take(32 * this.count);
    check(lib.ww_js_paths_advance(addresses.address, this.count, positions, farther, states));
    return copyNumbers(states, 4 * this.count, into);
  }
}

function allocateZeroed(bytes: number): number {
  const address = allocate(Math.max(bytes, 1));
  u8.fill(0, address, address + bytes);
  return address;
}

/** Makes a path query. Returns the given path, or a new one. */
export function findPath(world: Handle, query: PathQuery, path: Path, context: QueryContext | undefined): Path {
  const asked = packPathQuery(copyPathQuery(query));
  const [within, used, into] = [world.address, contextAddress(context), ownAddressOf(Path, path)];
  path.renew();
  check(lib.ww_world_find_path(within, asked, used, into));
  return path;
}
