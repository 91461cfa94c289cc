// Made by scripts/make_structs.py from bindings/structs.toml. Do not edit.

import { copyPoint, flatten, type Point, type Points } from './buffers.js';
import { PATH_ALGORITHMS, PATH_STATUSES, type PathAlgorithm, type PathStatus, PIECE_KINDS, type PieceKind, SVG_THEMES, type SvgTheme } from './enums.js';
import { toFlag, toNumber, toObject } from './errors.js';
import * as abi from './generated/abi.js';
import { getLimit, toExpansions, toLimit, toNanoseconds } from './limits.js';
import { check, encode, idAt, lib, scratch } from './runtime.js';
import { type Box, copyBox, fromEnum, get, type ItemId, put, putPoints, putText, readBox, readPoint, toEnum, writeBox, writePoint } from './values.js';

/** What moves: a point, or a disc with a radius. */
export interface Agent {
  /** Of the disc, 0 or more; with the radius 0 the agent is a point. */
  readonly radius?: number;
}

/** Returns a copy of an agent that a caller has given. */
export function copyAgent(given: Agent) {
  const { radius = 0 } = toObject(given, 'an agent');
  return {
    radius: toNumber(radius, 'radius'),
  };
}

export function putAgent(struct: number, copy: Required<Agent>): number {
  const { ww_agent: layout } = abi;
  put.float(struct + layout.radius, copy.radius);
  return struct;
}

export function readAgent(struct: number): Required<Agent> {
  const { ww_agent: layout } = abi;
  return {
    radius: get.float(struct + layout.radius),
  };
}

/** An end that the search has moved. */
export interface MovedEnd {
  /** The point in the query. */
  readonly from: Point;
  /** Where the path starts or ends instead. */
  readonly to: Point;
}

export function readMovedEnd(struct: number): MovedEnd {
  const { ww_moved_end: layout } = abi;
  return {
    from: readPoint(struct + layout.from),
    to: readPoint(struct + layout.to),
  };
}

/** The options of a world. */
export interface WorldOptions {
  /** Whether the world maintains the path abstraction: see docs/paths.md. */
  readonly keepAbstraction?: boolean;
  /** Whether the world can answer path queries for discs. */
  readonly keepBridges?: boolean;
  /** The largest number of vertices that one operation may make; no limit by default. */
  readonly newVertexLimit?: number;
}

/** Returns a copy of the options that a caller has given. */
export function copyWorldOptions(given: WorldOptions) {
  const { keepAbstraction = true, keepBridges = false, newVertexLimit = Infinity } = toObject(given, 'the options');
  return {
    keepAbstraction: toFlag(keepAbstraction, 'keepAbstraction'),
    keepBridges: toFlag(keepBridges, 'keepBridges'),
    newVertexLimit: toLimit(newVertexLimit),
  };
}

/** Writes a copy to a struct of the module. */
export function packWorldOptions(copy: ReturnType<typeof copyWorldOptions>): number {
  const { ww_world_options: layout } = abi;
  const struct = scratch.struct2;
  check(lib.ww_world_options_init(struct, layout.size_));
  put.flag(struct + layout.keepAbstraction, copy.keepAbstraction);
  put.flag(struct + layout.keepBridges, copy.keepBridges);
  put.size(struct + layout.newVertexLimit, copy.newVertexLimit);
  return struct;
}

export function readWorldOptions(struct: number): Required<WorldOptions> {
  const { ww_world_options: layout } = abi;
  return {
    keepAbstraction: get.flag(struct + layout.keepAbstraction),
    keepBridges: get.flag(struct + layout.keepBridges),
    newVertexLimit: getLimit(struct + layout.newVertexLimit),
  };
}

/**
 * The options of a picture. The part of the picture that shows the world is the map. The title, the axes and the legend
 * lie around the map.
 */
export interface SvgOptions {
  /** `automatic` by default. */
  readonly theme?: SvgTheme;
  /** In pixels, 240 to 100,000; 1200 by default; the height follows from the content. */
  readonly width?: number;
  /** Whether the picture shows the edges of the mesh that are not constrained; true by default. */
  readonly mesh?: boolean;
  /** Whether it has marks with coordinates, a scale bar, and the direction of y; true by default. */
  readonly axes?: boolean;
  /** Whether it shows the kind and the id of an item while the pointer is on it; true by default. */
  readonly ids?: boolean;
  /** Whether the y axis of the world points down. */
  readonly yDown?: boolean;
  /** The box that the picture shows; it may extend beyond the domain, which is the default. */
  readonly crop?: Box;
  /** The text above the map; none by default. */
  readonly title?: string;
}

/** Returns a copy of the options that a caller has given. */
export function copySvgOptions(given: SvgOptions) {
  const { theme = 'automatic', width = 1200, mesh = true, axes = true, ids = true, yDown = false, crop, title = '' } = toObject(given, 'the options');
  return {
    theme: toEnum(SVG_THEMES, theme),
    width: toNumber(width, 'width'),
    mesh: toFlag(mesh, 'mesh'),
    axes: toFlag(axes, 'axes'),
    ids: toFlag(ids, 'ids'),
    yDown: toFlag(yDown, 'yDown'),
    crop: crop === undefined ? null : copyBox(crop),
    title: encode(title),
  };
}

/** Writes a copy to a struct of the module. */
export function packSvgOptions(copy: ReturnType<typeof copySvgOptions>): number {
  const { ww_svg_options: layout } = abi;
  const struct = scratch.struct2;
  check(lib.ww_svg_options_init(struct, layout.size_));
  put.int(struct + layout.theme, copy.theme);
  put.float(struct + layout.width, copy.width);
  put.flag(struct + layout.mesh, copy.mesh);
  put.flag(struct + layout.axes, copy.axes);
  put.flag(struct + layout.ids, copy.ids);
  put.flag(struct + layout.yDown, copy.yDown);
  if (copy.crop !== null) {
    put.flag(struct + layout.hasCrop, true);
    writeBox(struct + layout.crop, copy.crop);
  }
  putText(struct + layout.title, copy.title);
  return struct;
}

/** An item that a segment meets. */
export interface CrossedItem {
  /** The id of the item. */
  readonly id: ItemId;
  /** Where the segment meets a side of the item, or where their overlap starts; rounded to nearest. */
  readonly at: Point;
}

export function readCrossedItem(struct: number): CrossedItem {
  const { ww_crossed_item: layout } = abi;
  return {
    id: idAt(struct + layout.id),
    at: readPoint(struct + layout.at),
  };
}

/** The first wall that an agent touches. */
export interface RayHit {
  /** Whether the agent touches a wall; if not, the points have no meaning. */
  readonly hit: boolean;
  /** Where the agent is when it first touches a wall, rounded. */
  readonly at: Point;
  /** The ids of the items that the agent touches there, ascending; 0 is the border of the domain. */
  readonly items: readonly ItemId[];
  /** The position on the touched walls that is nearest to `at`; for a point agent, it equals `at`. */
  readonly contact: Point;
}

export function readRayHit(struct: number, items: readonly ItemId[]): RayHit {
  const { ww_ray_hit: layout } = abi;
  return {
    hit: get.flag(struct + layout.hit),
    at: readPoint(struct + layout.at),
    items,
    contact: readPoint(struct + layout.contact),
  };
}

/** A query for the nearest point at which a disc fits. */
export interface NearestFitQuery {
  /** The answer is the point nearest to this one. */
  readonly point: Point;
  /** What must fit there; a point by default. */
  readonly agent?: Agent;
  /** If it is set, the answer is a position from which the disc can move to this point. */
  readonly goal?: Point;
  /** The largest distance of the answer from `point`; infinity by default. */
  readonly limit?: number;
}

/** Returns a copy of a query that a caller has given. */
export function copyNearestFitQuery(given: NearestFitQuery) {
  const { point, agent = {}, goal, limit = Infinity } = toObject(given, 'a query');
  return {
    point: copyPoint(point),
    agent: copyAgent(agent),
    goal: goal === undefined ? null : copyPoint(goal),
    limit: toNumber(limit, 'limit'),
  };
}

/** Writes a copy to a struct of the module. */
export function packNearestFitQuery(copy: ReturnType<typeof copyNearestFitQuery>): number {
  const { ww_nearest_fit_query: layout } = abi;
  const struct = scratch.struct2;
  check(lib.ww_nearest_fit_query_init(struct, layout.size_));
  writePoint(struct + layout.point, copy.point);
  putAgent(struct + layout.agent, copy.agent);
  if (copy.goal !== null) {
    put.flag(struct + layout.hasGoal, true);
    writePoint(struct + layout.goal, copy.goal);
  }
  put.float(struct + layout.limit, copy.limit);
  return struct;
}

/** The nearest point at which a disc fits and, if the query has a goal, from which it can move to the goal. */
export interface NearestFit {
  /** Whether there is an answer within the limit; if not, the other members are 0. */
  readonly isFound: boolean;
  /** The point; that the disc fits there is an exact decision. */
  readonly at: Point;
  /** The distance from the point of the query to `at`. */
  readonly distance: number;
}

export function readNearestFit(struct: number): NearestFit {
  const { ww_nearest_fit: layout } = abi;
  return {
    isFound: get.flag(struct + layout.isFound),
    at: readPoint(struct + layout.at),
    distance: get.float(struct + layout.distance),
  };
}

/** The largest disc that can move from a start to a goal, and the gap that stops every larger disc. */
export interface WidestPath {
  /** Whether a disc with a radius above 0 can move to the goal; if not, all others are 0. */
  readonly isConnected: boolean;
  /** Whether a gap between the ends limits the disc. */
  readonly isLimited: boolean;
  /** The largest radius of a disc that passes all gaps; infinity if no gap limits it. */
  readonly radius: number;
  /** Where the narrowest gap starts: the corner of an item, or of the domain. */
  readonly from: Point;
  /** Where this gap ends, rounded. */
  readonly to: Point;
  /** The ids of the items at the first end of the gap; 0 is the border of the domain. */
  readonly fromItems: readonly ItemId[];
  /** The ids of the items at the second end of the gap. */
  readonly toItems: readonly ItemId[];
}

export function readWidestPath(struct: number, fromItems: readonly ItemId[], toItems: readonly ItemId[]): WidestPath {
  const { ww_widest_path: layout } = abi;
  return {
    isConnected: get.flag(struct + layout.isConnected),
    isLimited: get.flag(struct + layout.isLimited),
    radius: get.float(struct + layout.radius),
    from: readPoint(struct + layout.from),
    to: readPoint(struct + layout.to),
    fromItems,
    toItems,
  };
}

/** The options of a path query: everything except its start and goal. */
export interface PathOptions {
  /** What moves; a point by default; for a disc, the world must keep its bridges. */
  readonly agent?: Agent;
  /** `optimal` by default, for the shortest path; the others take less time and may find longer paths. */
  readonly algorithm?: PathAlgorithm;
  /** How far the search may move a blocked end; the default allows for rounding errors; 0: not at all. */
  readonly endTolerance?: number;
  /** For `ta`: the number of triangles that the search may enter; with 0, the default, the first path is the answer. */
  readonly budgetExpansions?: number;
  /** For `ta`: the time since the start of the search; no limit by default. */
  readonly budgetNanoseconds?: number;
  /** Whether the answer has the edges that a point agent crosses. */
  readonly wantsChannel?: boolean;
  /** Whether the answer has the time of the search. */
  readonly wantsTime?: boolean;
}
/** A query for a path from a start to a goal. */
export interface PathQuery extends PathOptions {
  /** Where the path starts. */
  readonly start: Point;
  /** Where the path ends. */
  readonly goal: Point;
}

/** Returns a copy of a query that a caller has given. */
export function copyPathOptions(given: PathOptions) {
  const { agent = {}, algorithm = 'optimal', endTolerance, budgetExpansions = 0, budgetNanoseconds = Infinity, wantsChannel = false, wantsTime = false } = toObject(given, 'a query');
  return {
    agent: copyAgent(agent),
    algorithm: toEnum(PATH_ALGORITHMS, algorithm),
    endTolerance: endTolerance === undefined ? null : toNumber(endTolerance, 'endTolerance'),
    budgetExpansions: toExpansions(budgetExpansions),
    budgetNanoseconds: toNanoseconds(budgetNanoseconds),
    wantsChannel: toFlag(wantsChannel, 'wantsChannel'),
    wantsTime: toFlag(wantsTime, 'wantsTime'),
  };
}

/** Returns a copy of a query that a caller has given. */
export function copyPathQuery(given: PathQuery) {
  const { start, goal, agent = {}, algorithm = 'optimal', endTolerance, budgetExpansions = 0, budgetNanoseconds = Infinity, wantsChannel = false, wantsTime = false } = toObject(given, 'a query');
  return {
    start: copyPoint(start),
    goal: copyPoint(goal),
    agent: copyAgent(agent),
    algorithm: toEnum(PATH_ALGORITHMS, algorithm),
    endTolerance: endTolerance === undefined ? null : toNumber(endTolerance, 'endTolerance'),
    budgetExpansions: toExpansions(budgetExpansions),
    budgetNanoseconds: toNanoseconds(budgetNanoseconds),
    wantsChannel: toFlag(wantsChannel, 'wantsChannel'),
    wantsTime: toFlag(wantsTime, 'wantsTime'),
  };
}

/** Writes a copy to a struct of the module. */
export function packPathOptions(copy: ReturnType<typeof copyPathOptions>): number {
  const { ww_path_query: layout } = abi;
  const struct = scratch.struct2;
  check(lib.ww_path_query_init(struct, layout.size_));
  putAgent(struct + layout.agent, copy.agent);
  put.int(struct + layout.algorithm, copy.algorithm);
  if (copy.endTolerance !== null) {
    put.flag(struct + layout.hasEndTolerance, true);
    put.float(struct + layout.endTolerance, copy.endTolerance);
  }
  put.long(struct + layout.budgetExpansions, copy.budgetExpansions);
  put.long(struct + layout.budgetNanoseconds, copy.budgetNanoseconds);
  put.flag(struct + layout.wantsChannel, copy.wantsChannel);
  put.flag(struct + layout.wantsTime, copy.wantsTime);
  return struct;
}

export function packPathQuery(copy: ReturnType<typeof copyPathQuery>): number {
  const { ww_path_query: layout } = abi;
  const struct = packPathOptions(copy);
  writePoint(struct + layout.start, copy.start);
  writePoint(struct + layout.goal, copy.goal);
  return struct;
}

/** A query for the shortest paths from one start to many goals. */
export interface ManyGoalsQuery {
  /** Where the paths start. */
  readonly start: Point;
  /** Where the paths end; the points must exist during the call. */
  readonly goals: Points;
  /** What moves; a point by default. */
  readonly agent?: Agent;
  /** Whether the answers have points or pieces, besides status and length. */
  readonly wantsPoints?: boolean;
  /** How far the search may move a blocked end, as in a path query. */
  readonly endTolerance?: number;
}

/** Returns a copy of a query that a caller has given. */
export function copyManyGoalsQuery(given: ManyGoalsQuery) {
  const { start, goals, agent = {}, wantsPoints = false, endTolerance } = toObject(given, 'a query');
  return {
    start: copyPoint(start),
    goals: flatten(goals),
    agent: copyAgent(agent),
    wantsPoints: toFlag(wantsPoints, 'wantsPoints'),
    endTolerance: endTolerance === undefined ? null : toNumber(endTolerance, 'endTolerance'),
  };
}

/** Writes a copy to a struct of the module. */
export function packManyGoalsQuery(copy: ReturnType<typeof copyManyGoalsQuery>): number {
  const { ww_many_goals_query: layout } = abi;
  const struct = scratch.struct2;
  check(lib.ww_many_goals_query_init(struct, layout.size_));
  writePoint(struct + layout.start, copy.start);
  putPoints(struct + layout.goals, struct + layout.goalCount, copy.goals);
  putAgent(struct + layout.agent, copy.agent);
  put.flag(struct + layout.wantsPoints, copy.wantsPoints);
  if (copy.endTolerance !== null) {
    put.flag(struct + layout.hasEndTolerance, true);
    put.float(struct + layout.endTolerance, copy.endTolerance);
  }
  return struct;
}

/** Facts about a path. */
export interface PathInfo {
  /** Whether there is a path; if not, why. */
  readonly status: PathStatus;
  /** The length; 0 if there is no path. */
  readonly length: number;
  /** No path is shorter; equals `length` if the path is proven shortest; 0 if there is no path. */
  readonly lowerBound: number;
  /** The agent of the query. */
  readonly agent: Required<Agent>;
  /** The triangles that the search entered; for a disc, also the straight lines that it examined, and 0 if there is no path. */
  readonly expansions: number;
  /** The time of the search; 0 unless the query has asked for the time. */
  readonly nanoseconds: number;
  /** The number of points. */
  readonly pointCount: number;
  /** The number of lines and arcs. */
  readonly pieceCount: number;
  /** The number of edges in the channel. */
  readonly channelCount: number;
  /** The number of items that block an end. */
  readonly blockerCount: number;
  /** How the search has moved the start. */
  readonly movedStart: MovedEnd | null;
  /** How the search has moved the goal. */
  readonly movedGoal: MovedEnd | null;
  /** Whether the answer has a widest path. */
  readonly hasWidest: boolean;
}

export function readPathInfo(struct: number): PathInfo {
  const { ww_path_info: layout } = abi;
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
    movedStart: get.flag(struct + layout.hasMovedStart) ? readMovedEnd(struct + layout.movedStart) : null,
    movedGoal: get.flag(struct + layout.hasMovedGoal) ? readMovedEnd(struct + layout.movedGoal) : null,
    hasWidest: get.flag(struct + layout.hasWidest),
  };
}

/** A piece of the path of a disc's centre: a line, or an arc around a centre. */
export interface PathPiece {
  /** Whether it is a line or an arc. */
  readonly kind: PieceKind;
  /** Where it starts. */
  readonly from: Point;
  /** Where it ends. */
  readonly to: Point;
  /** Of an arc: a corner of an item, or of the domain. */
  readonly centre: Point;
  /** Of an arc: the radius of the agent. */
  readonly radius: number;
  /** Of an arc: the angle from the centre to `from`, in radians. */
  readonly startAngle: number;
  /** Of an arc: larger than the start angle if the arc turns left, otherwise smaller. */
  readonly endAngle: number;
}

export function readPathPiece(struct: number): PathPiece {
  const { ww_path_piece: layout } = abi;
  return {
    kind: fromEnum(PIECE_KINDS, get.int(struct + layout.kind)),
    from: readPoint(struct + layout.from),
    to: readPoint(struct + layout.to),
    centre: readPoint(struct + layout.centre),
    radius: get.float(struct + layout.radius),
    startAngle: get.float(struct + layout.startAngle),
    endAngle: get.float(struct + layout.endAngle),
  };
}

/**
 * A region that an operation has changed. A replacement has two boxes: one for the removal of the old shape, and one
 * for the insertion of the new shape.
 */
export interface ChangedBox {
  /** The version of the world after the operation. */
  readonly version: number;
  /** The bounding box of an item; the last box of an operation can have several items. */
  readonly box: Box;
  /** Whether the operation inserted an item in the box. */
  readonly isInsertion: boolean;
  /** Whether the operation removed an item in the box. */
  readonly isRemoval: boolean;
}

export function readChangedBox(struct: number): ChangedBox {
  const { ww_changed_box: layout } = abi;
  return {
    version: get.long(struct + layout.version),
    box: readBox(struct + layout.box),
    isInsertion: get.flag(struct + layout.isInsertion),
    isRemoval: get.flag(struct + layout.isRemoval),
  };
}

/** A query of a scenario of Moving AI. */
export interface ScenarioQuery {
  /** The file name of the map. */
  readonly map: string;
  /** The line in the text, from 1. */
  readonly line: number;
  /** The width of the map in tiles. */
  readonly width: number;
  /** The height of the map in tiles. */
  readonly height: number;
  /** Where the path starts. */
  readonly start: Point;
  /** Where the path ends. */
  readonly goal: Point;
  /** The length of the path that the author has found; negative if the author found none. */
  readonly length: number;
  /** Half a unit of the last digit of `length`. */
  readonly precision: number;
}

export function readScenarioQuery(struct: number, map: string): ScenarioQuery {
  const { ww_scenario_query: layout } = abi;
  return {
    map,
    line: get.size(struct + layout.line),
    width: get.long(struct + layout.width),
    height: get.long(struct + layout.height),
    start: readPoint(struct + layout.start),
    goal: readPoint(struct + layout.goal),
    length: get.float(struct + layout.length),
    precision: get.float(struct + layout.precision),
  };
}

/** The memory of a world in bytes, by purpose. */
export interface MemoryUse {
  /** For each vertex: its point, an edge from it, the items with a corner there. */
  readonly vertices: number;
  /** For vertices at crossings: the lines that cross there. */
  readonly crossings: number;
  /** For each triangle: its vertices and neighbours. */
  readonly faces: number;
  /** For each constrained edge: the sides that lie on it. */
  readonly walls: number;
  /** Ids, kinds and sides of the items. */
  readonly items: number;
  /** Squares of a grid, each with a vertex at which the walks of point location start. */
  readonly sectors: number;
  /** The path abstraction. */
  readonly abstraction: number;
  /** The bridges. */
  readonly bridges: number;
  /** The ticks to which the world can return. */
  readonly history: number;
  /** Unused capacity of arrays, and the scratch of operations. */
  readonly spare: number;
  /** The sum of all of them. */
  readonly total: number;
}

export function readMemoryUse(struct: number): MemoryUse {
  const { ww_memory_use: layout } = abi;
  return {
    vertices: get.size(struct + layout.vertices),
    crossings: get.size(struct + layout.crossings),
    faces: get.size(struct + layout.faces),
    walls: get.size(struct + layout.walls),
    items: get.size(struct + layout.items),
    sectors: get.size(struct + layout.sectors),
    abstraction: get.size(struct + layout.abstraction),
    bridges: get.size(struct + layout.bridges),
    history: get.size(struct + layout.history),
    spare: get.size(struct + layout.spare),
    total: get.size(struct + layout.total),
  };
}
