import { arena, copyIntegers, copyNumbers, copyPoint, packSizes, type Point, readList, readTwoLists, toSize } from './buffers.js';
import { refuse, shown, toFlag, toNumber, toObject, WaywrightError } from './errors.js';
import * as abi from './generated/abi.js';
import { Address, addressOf, contextAddress, Handle, make, ownAddressOf, type QueryContext } from './handle.js';
import { allocate, check, f64, lib, release, scratch, u32, u8 } from './runtime.js';
import {
  type Agent, answer, askSize, copyAgent, fromEnum, get, isInRange, type ItemId, put, readAgent, readIds, readPoint, toEnum, writeAgent, writePoint,
} from './values.js';

/** `optimal` finds the shortest path. `ta` and `tra` take less time and may find longer paths. */
export type PathAlgorithm = 'ta' | 'tra' | 'optimal';
export type PathStatus = 'found' | 'start-blocked' | 'goal-blocked' | 'no-path';
export type Precision = 'float64' | 'float32';

export const PATH_ALGORITHMS = ['ta', 'tra', 'optimal'] as const;
export const PATH_STATUSES = ['found', 'start-blocked', 'goal-blocked', 'no-path'] as const;
const PRECISIONS = ['float64', 'float32'] as const;

/** The options of a path query: everything except its start and goal. */
export interface PathOptions {
  /** The default is `optimal`. */
  readonly algorithm?: PathAlgorithm;
  /** The default is a point. For a disc, the world must keep its bridges. */
  readonly agent?: Agent;
  /** How far the search may move an end that is blocked. The default is `World.defaultEndTolerance`. */
  readonly endTolerance?: number;
  /** Whether the answer contains the edges that the path crosses. */
  readonly wantsChannel?: boolean;
  /** Whether the answer contains the time that the search has taken. */
  readonly wantsTime?: boolean;
  /** For `ta`: the number of triangles that the search may enter. With 0, the default, the first path is the answer. */
  readonly budgetExpansions?: number;
  /** For `ta`: the largest time since the start of the search, in nanoseconds. The default is no limit. */
  readonly budgetNanoseconds?: number;
}

export interface PathQuery extends PathOptions {
  readonly start: Point;
  readonly goal: Point;
}

const NO_LIMIT = 2n ** 64n - 1n;
const ORIGIN: Point = { x: 0, y: 0 };

/** A copy of the options of a query that a caller has given. */
interface OptionsCopy {
  readonly algorithm: number;
  readonly agent: Required<Agent>;
  readonly endTolerance: number | null;
  readonly wantsChannel: boolean;
  readonly wantsTime: boolean;
  readonly expansions: bigint | null;
  readonly nanoseconds: bigint | null;
}

function toExpansions(budget: number): bigint {
  return budget === Infinity ? NO_LIMIT : BigInt(toSize(budget));
}

function toNanoseconds(budget: number): bigint | null {
  if (budget === Infinity) return null;
  if (Number.isSafeInteger(budget)) return BigInt.asUintN(64, BigInt(budget));
  return refuse(`a budget of ${shown(budget)} ns is not a whole number`);
}

export function copyOptions(given: PathOptions): OptionsCopy {
  const { algorithm = 'optimal', agent = {}, endTolerance, wantsChannel = false, wantsTime = false, ...rest } = toObject(given, 'a query');
  const { budgetExpansions, budgetNanoseconds } = rest;
  return {
    algorithm: toEnum(PATH_ALGORITHMS, algorithm),
    agent: copyAgent(agent),
    endTolerance: endTolerance === undefined ? null : toNumber(endTolerance, 'endTolerance'),
    wantsChannel: toFlag(wantsChannel, 'wantsChannel'),
    wantsTime: toFlag(wantsTime, 'wantsTime'),
    expansions: budgetExpansions === undefined ? null : toExpansions(budgetExpansions),
    nanoseconds: budgetNanoseconds === undefined ? null : toNanoseconds(budgetNanoseconds),
  };
}

/** Writes a query to a struct of the module. */
export function packQuery(options: OptionsCopy, start = ORIGIN, goal = ORIGIN): number {
  const { ww_path_query: layout } = abi;
  const struct = scratch.struct2;
  check(lib.ww_path_query_init(struct, layout.size_));
  writePoint(struct + layout.start, start);
  writePoint(struct + layout.goal, goal);
  put.int(struct + layout.algorithm, options.algorithm);
  writeAgent(struct + layout.agent, options.agent);
  if (options.endTolerance !== null) {
    put.flag(struct + layout.hasEndTolerance, true);
    put.float(struct + layout.endTolerance, options.endTolerance);
  }
  put.flag(struct + layout.wantsChannel, options.wantsChannel);
  put.flag(struct + layout.wantsTime, options.wantsTime);
  if (options.expansions !== null) put.long(struct + layout.budgetExpansions, options.expansions);
  if (options.nanoseconds !== null) put.long(struct + layout.budgetNanoseconds, options.nanoseconds);
  return struct;
}

/** Writes a whole query of a caller to a struct of the module. */
export function packPathQuery(query: PathQuery): number {
  const options = copyOptions(query);
  const [start, goal] = [copyPoint(query.start), copyPoint(query.goal)];
  return packQuery(options, start, goal);
}

/** An end that the search has moved. */
export interface MovedEnd {
  readonly from: Point;
  readonly to: Point;
}

/** A piece of the path of a disc's centre: a line, or an arc around a centre. */
export interface PathPiece {
  readonly kind: 'line' | 'arc';
  readonly from: Point;
  readonly to: Point;
  /** The centre and the radius of an arc. They have no meaning for a line. */
  readonly centre: Point;
  readonly radius: number;
  /** The angles of an arc, in radians. If `endAngle` is larger, the arc turns left. */
  readonly startAngle: number;
  readonly endAngle: number;
}

/** The radius of the largest disc that can move from start to goal, and the gap that limits it. */
export interface WidestPath {
  readonly isConnected: boolean;
  /** Whether a gap limits the disc. */
  readonly isLimited: boolean;
  /** The largest radius of a disc that passes all gaps. Infinity if no gap limits the disc. */
  readonly radius: number;
  readonly from: Point;
  readonly to: Point;
  /** The items at the two ends of the gap. 0 is the border of the domain. */
  readonly fromItems: readonly ItemId[];
  readonly toItems: readonly ItemId[];
}

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
  const { ww_widest_path: layout } = abi;
  const struct = answer(layout);
  const [from, to] = readTwoLists(8, (a, roomA, countA, b, roomB, countB) =>
    call(answer(layout), a, roomA, countA, b, roomB, countB),
  );
  return {
    isConnected: get.flag(struct + layout.isConnected),
    isLimited: get.flag(struct + layout.isLimited),
    radius: get.float(struct + layout.radius),
    from: readPoint(struct + layout.from),
    to: readPoint(struct + layout.to),
    fromItems: readIds(from),
    toItems: readIds(to),
  };
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

/** Facts about a path. */
export interface PathInfo {
  readonly status: PathStatus;
  /** The length; 0 if there is no path. */
  readonly length: number;
  /** A lower bound: no path is shorter than this number. */
  readonly lowerBound: number;
  /** The agent of the query. */
  readonly agent: Required<Agent>;
  /** How many triangles the search has entered. */
  readonly expansions: number;
  /** The time of the search; 0 unless the query has asked for the time. */
  readonly nanoseconds: number;
  readonly pointCount: number;
  readonly pieceCount: number;
  readonly channelCount: number;
  readonly blockerCount: number;
  readonly movedStart: MovedEnd | null;
  readonly movedGoal: MovedEnd | null;
  readonly hasWidest: boolean;
}

function readInfo(path: number): PathInfo {
  const { ww_path_info: layout } = abi;
  const struct = answer(layout);
  check(lib.ww_path_get_info(path, struct));
  const moved = (has: number, from: number, to: number): MovedEnd | null =>
    get.flag(struct + has) ? { from: readPoint(struct + from), to: readPoint(struct + to) } : null;
  return {
    status: fromEnum(PATH_STATUSES, get.int(struct + layout.status)),
    length: get.float(struct + layout.length),
    lowerBound: get.float(struct + layout.lowerBound),
    agent: readAgent(struct + layout.agent),
    expansions: get.long(struct + layout.expansions),
    nanoseconds: get.long(struct + layout.nanoseconds),
    pointCount: get.size(struct + layout.pointCount),
    pieceCount: get.size(struct + layout.pieceCount),
    channelCount: get.size(struct + layout.channelCount),
    blockerCount: get.size(struct + layout.blockerCount),
    movedStart: moved(layout.hasMovedStart, layout.movedStartFrom, layout.movedStartTo),
    movedGoal: moved(layout.hasMovedGoal, layout.movedGoalFrom, layout.movedGoalTo),
    hasWidest: get.flag(struct + layout.hasWidest),
  };
}

function readPiece(struct: number): PathPiece {
  const { ww_path_piece: layout } = abi;
  return {
    kind: get.int(struct + layout.kind) === abi.WW_PIECE_LINE ? 'line' : 'arc',
    from: readPoint(struct + layout.from),
    to: readPoint(struct + layout.to),
    centre: readPoint(struct + layout.centre),
    radius: get.float(struct + layout.radius),
    startAngle: get.float(struct + layout.startAngle),
    endAngle: get.float(struct + layout.endAngle),
  };
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
    return Array.from({ length: list.count }, (_, i) => readPiece(list.address + i * size));
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
  const asked = packPathQuery(query);
  const [within, used, into] = [world.address, contextAddress(context), ownAddressOf(Path, path)];
  path.renew();
  check(lib.ww_world_find_path(within, asked, used, into));
  return path;
}
