import { copyNumbers, readList, toSize } from './buffers.js';
import { toFlag } from './errors.js';
import { Address, addressOf, Handle, make } from './handle.js';
import { Path } from './path.js';
import { check, lib, scratch, u32 } from './runtime.js';
import { copyPathQuery, packPathQuery, type PathQuery } from './structs.js';
import { askFlag, askSize } from './values.js';
import { World } from './world.js';

/** A path search in slices. Between the slices you may change the world. */
export class PathSearch extends Handle {
  /** @internal The world of the search: the garbage collector must not free it before the search ends. */
  searched: World | null = null;

  constructor() {
    super(make((address) => lib.ww_search_create(address)), (address) => lib.ww_search_destroy(address));
  }

  /** Starts a search. It cancels the search that is running. */
  begin(world: World, query: PathQuery): void {
    const asked = packPathQuery(copyPathQuery(query));
    const [address, within] = [this.address, addressOf(World, world)];
    this.changed();
    check(lib.ww_search_begin(address, within, asked));
    this.searched = world;
  }

  /** Continues the search until it has entered `expansions` further triangles. Returns whether it is done. */
  step(expansions: number): boolean {
    const [address, count] = [this.address, toSize(expansions)];
    this.changed();
    return askFlag((flag) => lib.ww_search_step(address, count, flag));
  }

  /** The answer, or the best path so far. It belongs to the search, and is valid until the next call that changes it. */
  get path(): Path {
    check(lib.ww_search_path(this.address, scratch.pointer));
    return new Path(new Address(u32[scratch.pointer >>> 2]!, this));
  }

  /** How often the search started again because the world had changed. */
  get restarts(): number {
    return askSize((count) => lib.ww_search_restarts(this.address, count));
  }

  get isRunning(): boolean {
    return askFlag((flag) => lib.ww_search_is_running(this.address, flag));
  }

  /** Sets whether the searches that begin from now on record their windows. */
  recordWindows(wanted: boolean): void {
    const [address, flag] = [this.address, toFlag(wanted, 'wanted') ? 1 : 0];
    this.changed();
    check(lib.ww_search_record_windows(address, flag));
  }

  /**
   * The windows that the search has followed since its last start, one or more for each triangle that it has entered: 12
   * numbers for each. These are x, y of five points: the root, the left and the right end of the edge, the left and the
   * right end of the interval; then the length of the path to the root, and the bound.
   */
  windows(into?: Float64Array): Float64Array {
    const { address } = this;
    const list = readList(96, (...buffer) => lib.ww_search_windows(address, ...buffer));
    return copyNumbers(list.address, 12 * list.count, into);
  }

  cancel(): void {
    const { address } = this;
    this.changed();
    check(lib.ww_search_cancel(address));
    this.searched = null;
  }
}
