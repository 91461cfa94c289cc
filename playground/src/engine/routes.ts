// Path queries of the page.
import { Path, type PathAlgorithm, PathSearch, type World } from 'waywright';
import { type Film, type FilmFrame, type Gap, type Route, type RouteAnswer, type RouteQuery, WINDOW_NUMBERS, type XY } from './protocol';

/** How long the repetitions of one search may take, in milliseconds. */
const MEASURE_MILLISECONDS = 8;
const MOST_REPETITIONS = 5000;
/** About how many frames a film has. */
const FILM_FRAMES = 120;

const numbers = (ids: readonly (number | bigint)[]): number[] => ids.map(Number);

/** How far the drawn points may be from the arcs of a path. */
export function drawTolerance(world: World): number {
  const { min, max } = world.domain;
  return Math.max(max.x - min.x, max.y - min.y) / 20000;
}

export function lineOf(path: Path, tolerance: number): Float64Array {
  return path.isFound ? path.polyline(tolerance) : new Float64Array(0);
}

export class Router {
  private readonly path = new Path();
  private readonly widePath = new Path();

  answer(world: World, query: RouteQuery): RouteAnswer {
    const routes = query.algorithms.map((algorithm) => this.route(world, query, algorithm));
    const blockers = numbers(this.path.blockers());
    const isMissing = routes.some(({ status }) => status === 'no-path');
    const gap = query.wantsWidest || isMissing ? this.gap(world, query.start, query.goal) : null;
    return { radius: query.radius, routes, gap, blockers };
  }

  private route(world: World, query: RouteQuery, algorithm: PathAlgorithm): Route {
    const { start, goal, radius, wantsChannel } = query;
    const asked = { start, goal, agent: { radius }, algorithm, wantsChannel };
    const begin = performance.now();
    const { path } = this;
    world.findPath(asked, path);
    let milliseconds = performance.now() - begin;
    if (query.measures) milliseconds = this.measure(world, { ...asked, wantsChannel: false }, milliseconds);
    const { status, length, lowerBound, expansions } = path.info;
    const line = lineOf(path, drawTolerance(world));
    return { algorithm, status, length, lowerBound, expansions, milliseconds, line,
      channel: wantsChannel && path.isFound ? path.channel() : null };
  }

  /** Repeats a search, because the clock of a browser is coarse. Returns the mean time. */
  private measure(world: World, query: Parameters<World['findPath']>[0], first: number): number {
    if (first >= MEASURE_MILLISECONDS) return first;
    const begin = performance.now();
    for (let count = 1; ; ++count) {
      world.findPath(query, this.widePath);
      const elapsed = performance.now() - begin;
      if (elapsed >= MEASURE_MILLISECONDS || count >= MOST_REPETITIONS) return elapsed / count;
    }
  }

  private gap(world: World, start: XY, goal: XY): Gap {
    const { isConnected, isLimited, radius, from, to, fromItems, toItems } = world.widestPath(start, goal);
    const line = isConnected && isLimited ? this.widestLine(world, start, goal, radius) : null;
    return { isConnected, isLimited, radius, from, to, fromItems: numbers(fromItems), toItems: numbers(toItems), line };
  }

  private widestLine(world: World, start: XY, goal: XY, radius: number): Float64Array | null {
    const path = world.findPath({ start, goal, agent: { radius } }, this.widePath);
    return path.isFound ? lineOf(path, drawTolerance(world)) : null;
  }
}

function filmFrame(search: PathSearch, isDone: boolean, tolerance: number): FilmFrame {
  const { path } = search;
  const { status, length, lowerBound, expansions } = path.info;
  const steps = search.windows().length / WINDOW_NUMBERS || expansions;
  return {
    isDone, status, length, lowerBound, steps,
    line: lineOf(path, tolerance),
    channel: path.isFound ? path.channel() : new Float64Array(0),
  };
}

/** Searches for the path in slices. Only `optimal` records windows, and only for a radius of 0. */
export function filmOf(world: World, { start, goal, radius, algorithms }: RouteQuery): Film {
  const query = { start, goal, agent: { radius }, algorithm: algorithms[0]!, wantsChannel: true };
  using path = world.findPath(query);
  const slice = Math.max(1, Math.ceil(path.info.expansions / FILM_FRAMES));
  using search = new PathSearch();
  search.recordWindows(true);
  search.begin(world, query);
  const frames: FilmFrame[] = [];
  for (let isDone = false; !isDone;) {
    isDone = search.step(slice);
    frames.push(filmFrame(search, isDone, drawTolerance(world)));
  }
  return { frames, windows: search.windows() };
}
