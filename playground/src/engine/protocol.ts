// The messages between the page and the worker with the engine.
import type { PathAlgorithm, PathStatus } from 'waywright';
import type { Bounds, Shape } from '../model/shape';

export interface XY {
  readonly x: number;
  readonly y: number;
}

export const ALGORITHMS: readonly PathAlgorithm[] = ['optimal', 'ta', 'tra'];

/** The new shape of an item. Null removes the item. */
export interface WireChange {
  readonly id: number;
  /** Whether the item exists before the change. */
  readonly exists: boolean;
  readonly after: Shape | null;
}

/** Items: `shapes[i]` has the id `ids[i]`. */
export interface PackedItems {
  readonly ids: Float64Array;
  readonly shapes: readonly Shape[];
}

export interface WorldSummary {
  readonly itemCount: number;
  readonly vertexCount: number;
  readonly triangleCount: number;
  readonly version: number;
  readonly memory: number;
  readonly milliseconds: number;
}

export interface RouteQuery {
  readonly start: XY;
  readonly goal: XY;
  readonly radius: number;
  readonly algorithms: readonly PathAlgorithm[];
  readonly wantsWidest: boolean;
  readonly wantsChannel: boolean;
  /** Whether to repeat each search until its time is known well. */
  readonly measures: boolean;
}

export interface Route {
  readonly algorithm: PathAlgorithm;
  readonly status: PathStatus;
  readonly length: number;
  readonly lowerBound: number;
  readonly expansions: number;
  readonly milliseconds: number;
  /** x, y of each point; arcs are flattened. */
  readonly line: Float64Array;
  /** The edges that the path crosses: four numbers for each. */
  readonly channel: Float64Array | null;
}

/** The largest disc that gets from start to goal, and the gap that limits it. */
export interface Gap {
  readonly isConnected: boolean;
  readonly isLimited: boolean;
  readonly radius: number;
  readonly from: XY;
  readonly to: XY;
  readonly fromItems: readonly number[];
  readonly toItems: readonly number[];
  /** The path of this largest disc. */
  readonly line: Float64Array | null;
}

export interface RouteAnswer {
  readonly radius: number;
  readonly routes: readonly Route[];
  readonly gap: Gap | null;
  /** The items that block an end. */
  readonly blockers: readonly number[];
}

export interface EditAnswer {
  readonly summary: WorldSummary;
  readonly routes: RouteAnswer | null;
  /** The boxes that the change has touched. */
  readonly touched: readonly Bounds[];
}

export interface Hashes {
  readonly items: string;
  readonly mesh: string;
  readonly version: number;
}

export interface MeshAnswer {
  readonly version: number;
  readonly vertices: Float64Array;
  readonly triangles: Uint32Array;
  /** The indices of the two ends of each edge that is not constrained. */
  readonly edges: Uint32Array;
  /** For each triangle: the number of its component, or -1 under a polygon. */
  readonly components: Int32Array;
  readonly componentCount: number;
  /** For each triangle: a value of LEVEL. */
  readonly levels: Uint8Array;
}

/** The kind of a triangle in the abstraction: an element of `MeshAnswer.levels`. */
export const LEVEL = { covered: 0, deadEnd: 1, corridor: 2, junction: 3 } as const;

/** A search as it stands after a number of steps. */
export interface FilmFrame {
  readonly isDone: boolean;
  /** The number of windows that the search has followed. If it records none: the number of its expansions. */
  readonly steps: number;
  readonly length: number;
  readonly lowerBound: number;
  readonly status: PathStatus;
  readonly line: Float64Array;
  readonly channel: Float64Array;
}

/** The whole course of a search. */
export interface Film {
  /** Ascending by steps. The last one is done. */
  readonly frames: readonly FilmFrame[];
  /** The windows, WINDOW_NUMBERS numbers for each as `PathSearch.windows` gives them: one for each step, or none. */
  readonly windows: Float64Array;
}

/** The numbers of a window: x, y of the root, of the edge's two ends and of the interval's two ends; length, bound. */
export const WINDOW_NUMBERS = 12;

/** The bridges of a world: BRIDGE_NUMBERS numbers for each. */
export interface BridgesAnswer {
  readonly version: number;
  readonly bridges: Float64Array;
}

/** The numbers of a bridge: x, y of its two ends, and the largest radius that passes. */
export const BRIDGE_NUMBERS = 5;

export interface CrowdOptions {
  readonly count: number;
  /** Five radii, ascending. */
  readonly radii: readonly number[];
  readonly algorithm: PathAlgorithm;
  /** Units of length per second. */
  readonly speed: number;
}

export interface CrowdStats {
  readonly units: number;
  readonly walking: number;
  readonly waiting: number;
  readonly stuck: number;
  /** The searches of this tick. */
  readonly searches: number;
  readonly searchMilliseconds: number;
  readonly tickMilliseconds: number;
  readonly milliseconds95: number;
}

/** The messages of the worker that answer no question. */
export type EngineEvent =
  | { readonly event: 'progress'; readonly done: number; readonly total: number }
  | { readonly event: 'crowd'; readonly states: Float32Array; readonly stats: CrowdStats };

/** The questions of the page. */
export interface EngineApi {
  /** `lock` is the name of a lock that the worker holds as long as it lives. */
  load(module: ArrayBuffer | string, lock: string): string;
  open(domain: Bounds, items: PackedItems): WorldSummary;
  edit(changes: readonly WireChange[], query: RouteQuery | null): EditAnswer;
  routes(query: RouteQuery): RouteAnswer;
  hashes(): Hashes;
  validate(): { readonly isValid: boolean; readonly fault: string; readonly milliseconds: number };
  mesh(): MeshAnswer;
  svg(query: RouteQuery | null, dark: boolean, yDown: boolean): string;
  bridges(): BridgesAnswer;
  film(query: RouteQuery): Film;
  crowdStart(options: CrowdOptions): Float32Array;
  crowdStop(): void;
  crash(): void;
}

export interface Request {
  readonly seq: number;
  readonly name: keyof EngineApi;
  readonly args: readonly unknown[];
}

export interface Failure {
  readonly code: string;
  readonly message: string;
  readonly item: number | null;
}

export type Response =
  | { readonly seq: number; readonly value: unknown }
  | { readonly seq: number; readonly failure: Failure };
