import { arena, packPoints, packSizes, packText, type Point, type Points, readList } from './buffers.js';
import { refuse } from './errors.js';
import * as abi from './generated/abi.js';
import { contextAddress, make, type QueryContext } from './handle.js';
import { Mesh } from './mesh.js';
import {
  type Bridge,
  findPath,
  packQuery,
  Path,
  type PathOptions,
  type PathQuery,
  Paths,
  readBridges,
  readWidest,
  type WidestPath,
} from './path.js';
import { check, idAt, lib, slots, textAt, withProgress } from './runtime.js';
import { packSvgOptions, type SvgOptions, type SvgOverlay } from './svg.js';
import {
  answer, askFlag, askFloat, askLong, askSize, askText, type Box, fromEnum, get, type ItemId, itemsHashAt, put, readBox, readIds,
  readPoint, toId, writeBox, writePoint,
} from './values.js';
import { packWorldOptions, WorldHistory, type WorldOptions } from './world_history.js';
import { type BulkOptions, packBulk } from './world_items.js';

export type LocationKind = 'vertex' | 'edge' | 'face';
export const LOCATION_KINDS = ['vertex', 'edge', 'face'] as const;

/** The vertex, edge or face of the mesh at a point, and the polygons there. */
export interface Location {
  readonly kind: LocationKind;
  /** The 1, 2 or 3 vertices of the location, rounded. The vertices of a face are counter-clockwise. */
  readonly vertices: readonly Point[];
  /** The polygons there, ascending. */
  readonly polygons: readonly ItemId[];
}

/** An item that a segment meets. */
export interface CrossedItem {
  readonly id: ItemId;
  /** Where the segment meets a side of the item, rounded. */
  readonly at: Point;
}

/** The first wall that a segment or a moving disc touches. */
export interface RayHit {
  /** Whether the segment or the disc touches a wall. */
  readonly hit: boolean;
  /** The first position of the segment, or of the disc's centre, at a touch. */
  readonly at: Point;
  /** The position on the touched walls that is nearest to `at`. */
  readonly contact: Point;
  /** The items that the segment or the disc touches there. 0 is the border of the domain. */
  readonly items: readonly ItemId[];
}

export interface DiscFit {
  readonly fits: boolean;
  /** The items that stop the disc. 0 is the border of the domain. */
  readonly items: readonly ItemId[];
}

export interface NearestFitQuery {
  readonly point: Point;
  /** The default is 0. */
  readonly radius?: number;
  /** If you set it, the answer is the nearest of the points from which the disc gets to this point. */
  readonly goal?: Point;
  /** The largest distance of the answer from `point`. The default is infinity. */
  readonly limit?: number;
}

export interface NearestFit {
  readonly isFound: boolean;
  readonly at: Point;
  readonly distance: number;
}

export interface ManyGoalsQuery {
  readonly start: Point;
  readonly goals: Points;
  /** Whether the answers have points. By default they have only status and length. */
  readonly wantsPoints?: boolean;
  readonly radius?: number;
  readonly endTolerance?: number;
}

/** The memory of a world in bytes. */
export interface MemoryUse {
  readonly vertices: number;
  readonly crossings: number;
  readonly faces: number;
  readonly walls: number;
  readonly items: number;
  readonly sectors: number;
  readonly abstraction: number;
  readonly bridges: number;
  readonly history: number;
  readonly spare: number;
  readonly total: number;
}

/** A region that an operation has changed. */
export interface ChangedBox {
  /** The version of the world after the operation. */
  readonly version: number;
  /** The bounding box of an item. The last box of an operation can be the bounding box of several items. */
  readonly box: Box;
  /** Whether the operation inserted or removed an item in the box. A replacement is both. */
  readonly isInsertion: boolean;
  readonly isRemoval: boolean;
}

export interface Validation {
  readonly isValid: boolean;
  /** The first fault, or an empty text. */
  readonly fault: string;
}

function createWorld(domain: Box, options: WorldOptions): number {
  const given = packWorldOptions(options);
  return make((address) => lib.ww_world_create(writeBox(slots.box, domain), given, address));
}

function readHit(call: (struct: number, buffer: number, capacity: number, count: number) => number): RayHit {
  const { ww_ray_hit: layout } = abi;
  const struct = slots.struct;
  const items = readIds(readList(8, (...list) => call(answer(layout), ...list)));
  return {
    hit: get.flag(struct + layout.hit),
    at: readPoint(struct + layout.at),
    contact: readPoint(struct + layout.contact),
    items,
  };
}

/** Obstacles over a closed box, and their mesh. */
export class World extends WorldHistory {
  constructor(domain: Box, options?: WorldOptions);
  /** @internal */
  constructor(address: number);
  constructor(given: Box | number, options: WorldOptions = {}) {
    const address = typeof given === 'number' ? given : createWorld(given, options);
    super(address, (world) => lib.ww_world_destroy(world));
  }

  /** Makes a world from the bytes that `save` has returned. `progress` reports the construction of the mesh. */
  static load(bytes: Uint8Array, options: BulkOptions = {}): World {
    arena.reset();
    const { address, count } = packText(bytes);
    const bulk = packBulk(options);
    return withProgress(
      options.progress,
      () => new World(make((world) => lib.ww_world_load_bytes(address, count, bulk, world))),
    );
  }

  /** Makes an independent copy, with the same history. Searches and path watches do not belong to the copy. */
  clone(): World {
    return new World(make((world) => lib.ww_world_clone(this.address, world)));
  }

  /** The options with which you made the world, and its present limit of new vertices. */
  get options(): Required<WorldOptions> {
    const { ww_world_options: layout } = abi;
    const struct = answer(layout);
    check(lib.ww_world_get_options(this.address, struct));
    return {
      keepAbstraction: get.flag(struct + layout.keepAbstraction),
      keepBridges: get.flag(struct + layout.keepBridges),
      newVertexLimit: this.newVertexLimit,
    };
  }

  get domain(): Box {
    check(lib.ww_world_domain(this.address, slots.box));
    return readBox(slots.box);
  }

  /** Finds the vertex, edge or face at a point. */
  locate(point: Point, context?: QueryContext): Location {
    const { ww_location: layout } = abi;
    const [world, asked] = [this.address, contextAddress(context)];
    const struct = slots.struct;
    const polygons = readIds(
      readList(8, (...list) => lib.ww_world_locate(world, writePoint(slots.a, point), asked, answer(layout), ...list)),
    );
    const count = get.size(struct + layout.vertexCount);
    return {
      kind: fromEnum(LOCATION_KINDS, get.int(struct + layout.kind)),
      vertices: Array.from({ length: count }, (_, i) => readPoint(struct + layout.vertices + 16 * i)),
      polygons,
    };
  }

  /** Finds the items that contain a point, ascending. */
  itemsAt(point: Point, context?: QueryContext): ItemId[] {
    const [world, asked] = [this.address, contextAddress(context)];
    return readIds(
      readList(8, (...list) => lib.ww_world_items_at(world, writePoint(slots.a, point), asked, ...list)),
    );
  }

  /** Finds the items whose sides a segment meets, in the order from `from` to `to`. */
  itemsCrossed(from: Point, to: Point, context?: QueryContext): CrossedItem[] {
    const { ww_crossed_item: layout } = abi;
    const [world, asked] = [this.address, contextAddress(context)];
    const { address, count } = readList(layout.size_, (...list) =>
      lib.ww_world_items_crossed(world, writePoint(slots.a, from), writePoint(slots.b, to), asked, ...list),
    );
    return Array.from({ length: count }, (_, i) => {
      const struct = address + i * layout.size_;
      return { id: idAt(struct + layout.id), at: readPoint(struct + layout.at) };
    });
  }

  /** Finds the items that have a position in common with a closed box, ascending. */
  itemsIn(box: Box, context?: QueryContext): ItemId[] {
    const [world, asked] = [this.address, contextAddress(context)];
    return readIds(readList(8, (...list) => lib.ww_world_items_in(world, writeBox(slots.box, box), asked, ...list)));
  }

  /** Finds the first wall that a segment touches. */
  ray(from: Point, to: Point, context?: QueryContext): RayHit {
    const [world, asked] = [this.address, contextAddress(context)];
    return readHit((struct, ...list) =>
      lib.ww_world_ray(world, writePoint(slots.a, from), writePoint(slots.b, to), asked, struct, ...list),
    );
  }

  /** Finds the first wall that a disc touches while its centre moves from `from` to `to`. */
  sweepDisc(from: Point, to: Point, radius: number, context?: QueryContext): RayHit {
    const [world, asked] = [this.address, contextAddress(context)];
    return readHit((struct, ...list) =>
      lib.ww_world_sweep_disc(world, writePoint(slots.a, from), writePoint(slots.b, to), radius, asked, struct, ...list),
    );
  }

  /** Finds out whether a disc fits at a position. */
  fitDisc(centre: Point, radius: number, context?: QueryContext): DiscFit {
    const [world, asked] = [this.address, contextAddress(context)];
    const items = readIds(
      readList(8, (...list) =>
        lib.ww_world_fit_disc(world, writePoint(slots.a, centre), radius, asked, slots.flag, ...list),
      ),
    );
    return { fits: get.flag(slots.flag), items };
  }

  /** Finds the nearest point where a disc fits. */
  nearestFit(query: NearestFitQuery, context?: QueryContext): NearestFit {
    const { ww_nearest_fit_query: layout, ww_nearest_fit: fit } = abi;
    const struct = slots.struct2;
    check(lib.ww_nearest_fit_query_init(struct, layout.size_));
    writePoint(struct + layout.point, query.point);
    if (query.goal !== undefined) {
      put.flag(struct + layout.hasGoal, true);
      writePoint(struct + layout.goal, query.goal);
    }
    if (query.radius !== undefined) put.float(struct + layout.radius, query.radius);
    if (query.limit !== undefined) put.float(struct + layout.limit, query.limit);
    const found = answer(fit);
    check(lib.ww_world_nearest_fit(this.address, struct, contextAddress(context), found));
    return {
      isFound: get.flag(found + fit.isFound),
      at: readPoint(found + fit.at),
      distance: get.float(found + fit.distance),
    };
  }

  /** Finds the largest disc that gets from start to goal. */
  widestPath(start: Point, goal: Point, context?: QueryContext): WidestPath {
    const [world, asked] = [this.address, contextAddress(context)];
    return readWidest((struct, ...lists) =>
      lib.ww_world_widest_path(world, writePoint(slots.a, start), writePoint(slots.b, goal), asked, struct, ...lists),
    );
  }

  /** Lists the bridges that meet a closed box, for example `world.domain`. */
  bridges(box: Box, context?: QueryContext): Bridge[] {
    const [world, asked] = [this.address, contextAddress(context)];
    return readBridges((...lists) => lib.ww_world_bridges(world, writeBox(slots.box, box), asked, ...lists));
  }

  /** Finds a path, or finds out that there is none. The answer is `path`, or a new path. */
  findPath(query: PathQuery, path: Path = new Path(), context?: QueryContext): Path {
    return findPath(this.address, query, path, context);
  }

  /** Finds a path for each pair of points in `ends`: start, goal, start, goal, ... The options are the same for all. */
  findPaths(ends: Points, options: PathOptions = {}, paths: Paths = new Paths(), context?: QueryContext): Paths {
    arena.reset();
    const { address, count } = packPoints(ends);
    if (count % 2 !== 0) refuse('a list of ends has two points for each path');
    const query = packQuery(options);
    paths.renew();
    check(lib.ww_js_find_paths(this.address, query, address, count / 2, contextAddress(context), paths.address));
    return paths;
  }

  /** Finds the shortest path from one start to each of many goals. */
  findPathsFrom(query: ManyGoalsQuery, paths: Paths = new Paths(), context?: QueryContext): Paths {
    const { ww_many_goals_query: layout } = abi;
    arena.reset();
    const goals = packPoints(query.goals);
    const struct = slots.struct2;
    check(lib.ww_many_goals_query_init(struct, layout.size_));
    writePoint(struct + layout.start, query.start);
    put.size(struct + layout.goals, goals.address);
    put.size(struct + layout.goalCount, goals.count);
    put.flag(struct + layout.wantsPoints, query.wantsPoints ?? false);
    if (query.radius !== undefined) put.float(struct + layout.radius, query.radius);
    if (query.endTolerance !== undefined) {
      put.flag(struct + layout.hasEndTolerance, true);
      put.float(struct + layout.endTolerance, query.endTolerance);
    }
    paths.renew();
    check(lib.ww_world_find_paths_from(this.address, struct, contextAddress(context), paths.address));
    return paths;
  }

  /** The largest distance by which a search may move a blocked end, if the query has no `endTolerance`. */
  get defaultEndTolerance(): number {
    return askFloat((address) => lib.ww_world_default_end_tolerance(this.address, address));
  }

  /** Whether a point agent can walk along a polyline. */
  isClear(points: Points, context?: QueryContext): boolean {
    arena.reset();
    const { address, count } = packPoints(points);
    return askFlag((flag) => lib.ww_world_is_clear(this.address, address, count, contextAddress(context), flag));
  }

  /** Whether a point agent can walk straight from one point to another. */
  isClearBetween(from: Point, to: Point, context?: QueryContext): boolean {
    const [world, asked] = [this.address, contextAddress(context)];
    return askFlag((flag) =>
      lib.ww_world_is_clear_between(world, writePoint(slots.a, from), writePoint(slots.b, to), asked, flag),
    );
  }

  /** Whether an operation after version `since` has inserted or removed an item near a polyline, or near a path. */
  isAffected(line: Points | Path, since: number): boolean {
    const version = toId(since);
    if (line instanceof Path) {
      return askFlag((flag) => lib.ww_world_is_path_affected(this.address, line.address, version, flag));
    }
    arena.reset();
    const { address, count } = packPoints(line);
    return askFlag((flag) => lib.ww_world_is_affected(this.address, address, count, version, flag));
  }

  /** The indices of the affected paths, ascending. */
  findAffected(paths: readonly Path[], since: number): number[] {
    arena.reset();
    const given = packSizes(paths.map((path) => path.address));
    const [world, version] = [this.address, toId(since)];
    const { address, count } = readList(4, (...list) =>
      lib.ww_world_find_affected(world, given.address, given.count, version, ...list),
    );
    return Array.from({ length: count }, (_, i) => get.size(address + 4 * i));
  }

  /** The regions that operations after version `since` have changed, the oldest first; null if some are unknown. */
  changesSince(since: number): ChangedBox[] | null {
    const { ww_changed_box: layout } = abi;
    const [world, version] = [this.address, toId(since)];
    const { address, count } = readList(layout.size_, (...list) =>
      lib.ww_world_changes_since(world, version, slots.flag, ...list),
    );
    if (!get.flag(slots.flag)) return null;
    return Array.from({ length: count }, (_, i) => {
      const struct = address + i * layout.size_;
      return {
        version: get.long(struct + layout.version),
        box: readBox(struct + layout.box),
        isInsertion: get.flag(struct + layout.isInsertion),
        isRemoval: get.flag(struct + layout.isRemoval),
      };
    });
  }

  /** The number of operations that the world has carried out. */
  get version(): number {
    return askLong((address) => lib.ww_world_version(this.address, address));
  }

  get vertexCount(): number {
    return askSize((count) => lib.ww_world_vertex_count(this.address, count));
  }
  get triangleCount(): number {
    return askSize((count) => lib.ww_world_triangle_count(this.address, count));
  }

  /** Copies the mesh in canonical order, to the given mesh or to a new one. */
  snapshot(mesh: Mesh = new Mesh(), context?: QueryContext): Mesh {
    check(lib.ww_world_snapshot(this.address, contextAddress(context), mesh.address));
    return mesh;
  }

  /** The mesh as canonical text with exact coordinates. */
  dump(): string {
    return askText((text) => lib.ww_world_dump(this.address, text));
  }

  /** The hash of the items: 32 hexadecimal digits. */
  itemsHash(): string {
    check(lib.ww_world_items_hash(this.address, slots.struct));
    return itemsHashAt(slots.struct);
  }

  /** The hash of the mesh: 64 hexadecimal digits. */
  meshHash(): string {
    check(lib.ww_world_mesh_hash(this.address, slots.struct));
    check(lib.ww_mesh_hash_text(slots.struct, slots.struct2, 65, 0));
    return textAt(slots.struct2, 64);
  }

  /** Checks the whole world, exactly. */
  validate(): Validation {
    const fault = askText((text) => lib.ww_world_validate(this.address, slots.flag, text));
    return { isValid: get.flag(slots.flag), fault };
  }

  /** The memory of the world in bytes. */
  memory(): MemoryUse {
    const { ww_memory_use: layout } = abi;
    const struct = answer(layout);
    check(lib.ww_world_memory(this.address, struct));
    const { size_: _size, structSize: _structSize, ...members } = layout;
    const values = Object.entries(members).map(([name, offset]) => [name, get.size(struct + offset)]);
    return Object.fromEntries(values) as unknown as MemoryUse;
  }

  /** Frees spare memory. */
  shrinkToFit(): void {
    check(lib.ww_world_shrink_to_fit(this.address));
  }

  /** Draws a picture of the world as SVG. */
  toSvg(overlay: SvgOverlay | null = null, options: SvgOptions = {}): string {
    arena.reset();
    const given = packSvgOptions(options);
    return askText((text) => lib.ww_world_to_svg(this.address, overlay === null ? 0 : overlay.address, given, text));
  }
}

