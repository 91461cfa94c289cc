// The world of the worker, and the answers to the page's questions.
import {
  init, ItemList, moduleMemory, Path, Shape as WorldShape, SvgOverlay, version, World, type Change,
} from 'waywright';
import type { Bounds, Shape } from '../model/shape';
import { Crowd } from './crowd';
import { listBridges, lookInside } from './inside';
import type {
  BridgesAnswer, CrowdOptions, EditAnswer, EngineApi, EngineEvent, Film, Hashes, MeshAnswer, PackedItems, RouteAnswer,
  RouteQuery, WireChange, WorldSummary,
} from './protocol';
import { filmOf, Router } from './routes';

/** The largest number of new vertices of one operation, so that no operation fills the memory of the machine. */
const NEW_VERTEX_LIMIT = 4_000_000;

export function toWorldShape({ kind, points, rings, fill }: Shape): WorldShape {
  return { kind, points, ...(rings === undefined ? {} : { ringSizes: rings }), ...(fill === undefined ? {} : { fill }) };
}

function toChange({ id, exists, after }: WireChange): Change {
  if (after === null) return { kind: 'remove', id };
  return { kind: exists ? 'replace' : 'insert', id, shape: toWorldShape(after) };
}

export class Engine implements EngineApi {
  private world_: World | null = null;
  private readonly emit: (event: EngineEvent, transfer?: Transferable[]) => void;
  private router_: Router | null = null;
  private crowd: Crowd | null = null;

  constructor(emit: (event: EngineEvent, transfer?: Transferable[]) => void) {
    this.emit = emit;
  }

  private get world(): World {
    if (this.world_ === null) throw new Error('there is no world yet');
    return this.world_;
  }

  private get router(): Router {
    return (this.router_ ??= new Router());
  }

  /** Loads the module, from its address or from its bytes. Returns the version of the library. */
  async loadModule(module: ArrayBuffer | string): Promise<string> {
    await init({ module });
    return version();
  }
  load(): string {
    return version();
  }

  open(domain: Bounds, { ids, shapes }: PackedItems): WorldSummary {
    const begin = performance.now();
    const [x0, y0, x1, y1] = domain;
    const world = new World({ min: { x: x0, y: y0 }, max: { x: x1, y: y1 } }, { keepBridges: true });
    const list = new ItemList();
    try {
      world.newVertexLimit = NEW_VERTEX_LIMIT;
      shapes.forEach((shape, i) => list.add(toWorldShape(shape), ids[i]!));
      if (shapes.length > 0) world.insertAll(list, { progress: (done, total) => this.report(done, total) });
    } catch (reason) {
      world.dispose();
      throw reason;
    } finally {
      list.dispose();
    }
    this.crowdStop();
    this.world_?.dispose();
    this.world_ = world;
    return this.summary(begin);
  }

  private report(done: number, total: number): void {
    this.emit({ event: 'progress', done, total });
  }

  private summary(begin: number): WorldSummary {
    const { world } = this;
    return {
      itemCount: world.itemCount,
      vertexCount: world.vertexCount,
      triangleCount: world.triangleCount,
      version: world.version,
      memory: moduleMemory().used,
      milliseconds: performance.now() - begin,
    };
  }

  /** Makes changes as one operation, then asks for the routes. */
  edit(changes: readonly WireChange[], query: RouteQuery | null): EditAnswer {
    const { world } = this;
    const before = world.version;
    const begin = performance.now();
    const [only] = changes;
    if (changes.length === 1 && only !== undefined) this.change(only);
    else if (changes.length > 0) world.apply(changes.map(toChange));
    const summary = this.summary(begin);
    const touched = (world.changesSince(before) ?? []).map(
      ({ box: { min, max } }): Bounds => [min.x, min.y, max.x, max.y],
    );
    return { summary, touched, routes: query === null ? null : this.router.answer(world, query) };
  }

  private change({ id, exists, after }: WireChange): void {
    const { world } = this;
    if (after === null) world.remove(id);
    else if (exists) world.replace(id, toWorldShape(after));
    else world.insert(toWorldShape(after), id);
  }

  routes(query: RouteQuery): RouteAnswer {
    return this.router.answer(this.world, query);
  }

  hashes(): Hashes {
    const { world } = this;
    return { items: world.itemsHash(), mesh: world.meshHash(), version: world.version };
  }

  validate(): { isValid: boolean; fault: string; milliseconds: number } {
    const begin = performance.now();
    const { isValid, fault } = this.world.validate();
    return { isValid, fault, milliseconds: performance.now() - begin };
  }

  mesh(): MeshAnswer {
    return lookInside(this.world);
  }

  svg(query: RouteQuery | null, dark: boolean, yDown: boolean): string {
    using overlay = new SvgOverlay();
    if (query !== null) {
      const { start, goal, radius } = query;
      using path = new Path();
      this.world.findPath({ start, goal, agent: { radius } }, path);
      if (!path.isFound) overlay.addFailedPath(start, goal, path.status);
      else if (radius > 0) overlay.addDiscPath({ start, goal, agent: { radius } }, path);
      else overlay.addPath(path);
    }
    return this.world.toSvg(overlay, { theme: dark ? 'dark' : 'light', yDown, title: 'Waywright' });
  }

  bridges(): BridgesAnswer {
    return listBridges(this.world);
  }

  film(query: RouteQuery): Film {
    return filmOf(this.world, query);
  }

  /** Starts a crowd. Returns the radius of each unit. */
  crowdStart(options: CrowdOptions): Float32Array {
    this.crowdStop();
    this.crowd = new Crowd(this.world, options, (states, stats) =>
      this.emit({ event: 'crowd', states, stats }, [states.buffer as ArrayBuffer]),
    );
    return this.crowd.radii();
  }

  crowdStop(): void {
    this.crowd?.dispose();
    this.crowd = null;
  }

  /** Stops the worker as a bug of the module would: a test of the page's recovery. */
  crash(): void {
    throw Object.assign(new Error('a crash on purpose'), { code: 'internal-error' });
  }
}
