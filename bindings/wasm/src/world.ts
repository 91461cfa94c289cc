import {
  arena, copyList, flatten, packPoints, packSizes, packText, type Point, type Points, readList, toBytes,
} from './buffers.js';
import { refuse } from './errors.js';
import * as abi from './generated/abi.js';
import { Address, addressOf, contextAddress, make, ownAddressOf, type QueryContext } from './handle.js';
import { Mesh } from './mesh.js';
import { type Bridge, findPath, Path, Paths, readBridges, readWidest } from './path.js';
import { check, lib, scratch, textAt, withProgress } from './runtime.js';
import { SvgOverlay } from './svg.js';
import {
  type Agent, type ChangedBox, copyAgent, copySvgOptions, type CrossedItem, packSvgOptions, readCrossedItem, type SvgOptions, copyManyGoalsQuery, copyNearestFitQuery, copyPathOptions, copyWorldOptions, type ManyGoalsQuery,
  type MemoryUse, type NearestFit, type NearestFitQuery, packManyGoalsQuery, packNearestFitQuery, packPathOptions, packWorldOptions,
  type PathOptions, type PathQuery, putAgent, type RayHit, readChangedBox, readMemoryUse, readNearestFit, readRayHit, readWorldOptions,
  type WidestPath, type WorldOptions,
} from './structs.js';
import {
  answer, askFlag, askFloat, askLong, askSize, askText, type Box, copyBox, fromEnum, get, type ItemId, itemsHashAt,
  readBox, readIds, readPoint, toLong, writeBox, writeEnds, writePoint,
} from './values.js';
import { WorldHistory } from './world_history.js';
import { type BulkOptions, packBulk, progressOf } from './world_items.js';

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

export interface DiscFit {
  readonly fits: boolean;
  /** The items that stop the disc. 0 is the border of the domain. */
  readonly items: readonly ItemId[];
}

export interface Validation {
  readonly isValid: boolean;
  /** The first fault, or an empty text. */
  readonly fault: string;
}

function createWorld(domain: Box, options: WorldOptions): number {
  const box = copyBox(domain);
  const given = packWorldOptions(copyWorldOptions(options));
  return make((address) => lib.ww_world_create(writeBox(scratch.box, box), given, address));
}

function readHit(call: (struct: number, buffer: number, capacity: number, count: number) => number): RayHit {
  const struct = scratch.struct;
  const items = readIds(readList(8, (...list) => call(answer(abi.ww_ray_hit), ...list)));
  return readRayHit(struct, items);
}

/** Obstacles over a closed box, and their mesh. */
export class World extends WorldHistory {
  constructor(domain: Box, options?: WorldOptions);
  /** @internal */
  constructor(given: Address);
  constructor(given: Box | Address, options: WorldOptions = {}) {
    const address = given instanceof Address ? given.value : createWorld(given, options);
    super(address, (world) => lib.ww_world_destroy(world));
  }

  /** Makes a world from the bytes that `save` has returned. `progress` reports the construction of the mesh. */
  static load(bytes: Uint8Array, options: BulkOptions = {}): World {
    const [given, progress] = [toBytes(bytes), progressOf(options)];
    arena.reset();
    const { address, count } = packText(given);
    const bulk = packBulk(progress);
    return withProgress(
      progress,
      () => new World(new Address(make((world) => lib.ww_world_load_bytes(address, count, bulk, world)))),
    );
  }

  /** Makes an independent copy, with the same history. Searches and path watches do not belong to the copy. */
  clone(): World {
    return new World(new Address(make((world) => lib.ww_world_clone(this.address, world))));
  }

  /** The options with which you made the world, and its present limit of new vertices. */
  get options(): Required<WorldOptions> {
    const struct = answer(abi.ww_world_options);
    check(lib.ww_world_get_options(this.address, struct));
    return readWorldOptions(struct);
  }

  get domain(): Box {
    check(lib.ww_world_domain(this.address, scratch.box));
    return readBox(scratch.box);
  }

  /** Finds the vertex, edge or face at a point. */
  locate(point: Point, context?: QueryContext): Location {
    const { ww_location: layout } = abi;
    const at = writePoint(scratch.a, point);
    const [world, asked] = [this.address, contextAddress(context)];
    const struct = scratch.struct;
    const polygons = readIds(
      readList(8, (...list) => lib.ww_world_locate(world, at, asked, answer(layout), ...list)),
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
    const at = writePoint(scratch.a, point);
    const [world, asked] = [this.address, contextAddress(context)];
    return readIds(readList(8, (...list) => lib.ww_world_items_at(world, at, asked, ...list)));
  }

  /** Finds the items whose sides a segment meets, in the order from `from` to `to`. */
  itemsCrossed(from: Point, to: Point, context?: QueryContext): CrossedItem[] {
    const size = abi.ww_crossed_item.size_;
    const [a, b] = writeEnds(from, to);
    const [world, asked] = [this.address, contextAddress(context)];
    const { address, count } = readList(size, (...list) => lib.ww_world_items_crossed(world, a, b, asked, ...list));
    return Array.from({ length: count }, (_, i) => readCrossedItem(address + i * size));
  }

  /** Finds the items that have a position in common with a closed box, ascending. */
  itemsIn(box: Box, context?: QueryContext): ItemId[] {
    const given = writeBox(scratch.box, box);
    const [world, asked] = [this.address, contextAddress(context)];
    return readIds(readList(8, (...list) => lib.ww_world_items_in(world, given, asked, ...list)));
  }

  /** Finds the first wall that an agent touches while it moves straight from `from` to `to`. */
  ray(from: Point, to: Point, agent: Agent = {}, context?: QueryContext): RayHit {
    const [given, [a, b]] = [copyAgent(agent), writeEnds(from, to)];
    const [world, asked, moving] = [this.address, contextAddress(context), putAgent(scratch.agent, given)];
    return readHit((struct, ...list) => lib.ww_world_ray(world, a, b, moving, asked, struct, ...list));
  }

  /** Finds out whether a disc fits at a position. */
  fitDisc(centre: Point, agent: Agent, context?: QueryContext): DiscFit {
    const [given, at] = [copyAgent(agent), writePoint(scratch.a, centre)];
    const [world, asked, moving] = [this.address, contextAddress(context), putAgent(scratch.agent, given)];
    const items = readIds(
      readList(8, (...list) => lib.ww_world_fit_disc(world, at, moving, asked, scratch.flag, ...list)),
    );
    return { fits: get.flag(scratch.flag), items };
  }

  /** Finds the nearest point where a disc fits. */
  nearestFit(query: NearestFitQuery, context?: QueryContext): NearestFit {
    const asked = packNearestFitQuery(copyNearestFitQuery(query));
    const found = answer(abi.ww_nearest_fit);
    check(lib.ww_world_nearest_fit(this.address, asked, contextAddress(context), found));
    return readNearestFit(found);
  }

  /** Finds the largest disc that can move from start to goal. The radius of `agent` does not matter. */
  widestPath(start: Point, goal: Point, agent: Agent = {}, context?: QueryContext): WidestPath {
    const [given, [a, b]] = [copyAgent(agent), writeEnds(start, goal)];
    const [world, asked, moving] = [this.address, contextAddress(context), putAgent(scratch.agent, given)];
    return readWidest((struct, ...lists) => lib.ww_world_widest_path(world, a, b, moving, asked, struct, ...lists));
  }

  /** Lists the bridges that meet a closed box, for example `world.domain`. */
  bridges(box: Box, context?: QueryContext): Bridge[] {
    const given = writeBox(scratch.box, box);
    const [world, asked] = [this.address, contextAddress(context)];
    return readBridges((...lists) => lib.ww_world_bridges(world, given, asked, ...lists));
  }

  /** Finds a path, or finds out that there is none. The answer is `path`, or a new path. */
  findPath(query: PathQuery, path: Path = new Path(), context?: QueryContext): Path {
    return findPath(this, query, path, context);
  }

  /** Finds a path for each pair of points in `ends`: start, goal, start, goal, ... The options are the same for all. */
  findPaths(ends: Points, options: PathOptions = {}, paths: Paths = new Paths(), context?: QueryContext): Paths {
    const [coordinates, given] = [flatten(ends), copyPathOptions(options)];
    if (coordinates.length % 4 !== 0) refuse('a list of ends has two points for each path');
    const [world, asked, into] = [this.address, contextAddress(context), ownAddressOf(Paths, paths)];
    arena.reset();
    const { address, count } = packPoints(coordinates);
    const query = packPathOptions(given);
    paths.renew();
    check(lib.ww_js_find_paths(world, query, address, count / 2, asked, into));
    return paths;
  }

  /** Finds the shortest path from one start to each of many goals. */
  findPathsFrom(query: ManyGoalsQuery, paths: Paths = new Paths(), context?: QueryContext): Paths {
    const copy = copyManyGoalsQuery(query);
    const [world, asked, into] = [this.address, contextAddress(context), ownAddressOf(Paths, paths)];
    arena.reset();
    const struct = packManyGoalsQuery(copy);
    paths.renew();
    check(lib.ww_world_find_paths_from(world, struct, asked, into));
    return paths;
  }

  /** The largest distance by which a search may move a blocked end, if the query has no `endTolerance`. */
  get defaultEndTolerance(): number {
    return askFloat((address) => lib.ww_world_default_end_tolerance(this.address, address));
  }

  /** Whether an agent can walk along a polyline. Discs are not supported yet. */
  isClear(points: Points, agent: Agent = {}, context?: QueryContext): boolean {
    const [coordinates, given] = [flatten(points), copyAgent(agent)];
    arena.reset();
    const { address, count } = packPoints(coordinates);
    const moving = putAgent(scratch.agent, given);
    return askFlag((flag) => lib.ww_world_is_clear(this.address, address, count, moving, contextAddress(context), flag));
  }

  /** Whether an agent can walk straight from one point to another. Discs are not supported yet. */
  isClearBetween(from: Point, to: Point, agent: Agent = {}, context?: QueryContext): boolean {
    const [given, [a, b]] = [copyAgent(agent), writeEnds(from, to)];
    const [world, asked, moving] = [this.address, contextAddress(context), putAgent(scratch.agent, given)];
    return askFlag((flag) => lib.ww_world_is_clear_between(world, a, b, moving, asked, flag));
  }

  /**
   * Whether an operation after version `since` has inserted or removed an item near a polyline, or near a path. `agent`
   * moves along the polyline; a path has its own agent.
   */
  isAffected(line: Points | Path, since: number, agent: Agent = {}): boolean {
    const [version, given] = [toLong(since, 'version'), copyAgent(agent)];
    if (line instanceof Path) {
      return askFlag((flag) => lib.ww_world_is_path_affected(this.address, line.address, version, flag));
    }
    const coordinates = flatten(line);
    arena.reset();
    const { address, count } = packPoints(coordinates);
    return askFlag((flag) => lib.ww_world_is_affected(this.address, address, count, putAgent(scratch.agent, given), version, flag));
  }

  /** The indices of the affected paths, ascending. */
  findAffected(paths: readonly Path[], since: number): number[] {
    const [addresses, version] = [copyList(paths, 'a list of paths', (path) => addressOf(Path, path)), toLong(since, 'version')];
    const world = this.address;
    arena.reset();
    const given = packSizes(addresses);
    const { address, count } = readList(4, (...list) =>
      lib.ww_world_find_affected(world, given.address, given.count, version, ...list),
    );
    return Array.from({ length: count }, (_, i) => get.size(address + 4 * i));
  }

  /** The regions that operations after version `since` have changed, the oldest first; null if some are unknown. */
  changesSince(since: number): ChangedBox[] | null {
    const size = abi.ww_changed_box.size_;
    const [world, version] = [this.address, toLong(since, 'version')];
    const { address, count } = readList(size, (...list) => lib.ww_world_changes_since(world, version, scratch.flag, ...list));
    if (!get.flag(scratch.flag)) return null;
    return Array.from({ length: count }, (_, i) => readChangedBox(address + i * size));
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
    check(lib.ww_world_snapshot(this.address, contextAddress(context), addressOf(Mesh, mesh)));
    return mesh;
  }

  /** The mesh as canonical text with exact coordinates. */
  dump(): string {
    return askText((text) => lib.ww_world_dump(this.address, text));
  }

  /** The hash of the items: 32 hexadecimal digits. */
  itemsHash(): string {
    check(lib.ww_world_items_hash(this.address, scratch.struct));
    return itemsHashAt(scratch.struct);
  }

  /** The hash of the mesh: 64 hexadecimal digits. */
  meshHash(): string {
    check(lib.ww_world_mesh_hash(this.address, scratch.struct));
    check(lib.ww_mesh_hash_text(scratch.struct, scratch.struct2, 65, 0));
    return textAt(scratch.struct2, 64);
  }

  /** Checks the whole world, exactly. */
  validate(): Validation {
    const fault = askText((text) => lib.ww_world_validate(this.address, scratch.flag, text));
    return { isValid: get.flag(scratch.flag), fault };
  }

  /** The memory of the world in bytes. */
  memory(): MemoryUse {
    const struct = answer(abi.ww_memory_use);
    check(lib.ww_world_memory(this.address, struct));
    return readMemoryUse(struct);
  }

  /** Frees spare memory. */
  shrinkToFit(): void {
    check(lib.ww_world_shrink_to_fit(this.address));
  }

  /** Draws a picture of the world as SVG. */
  toSvg(overlay: SvgOverlay | null = null, options: SvgOptions = {}): string {
    const [copy, marks] = [copySvgOptions(options), overlay === null ? 0 : addressOf(SvgOverlay, overlay)];
    arena.reset();
    const given = packSvgOptions(copy);
    return askText((text) => lib.ww_world_to_svg(this.address, marks, given, text));
  }
}

