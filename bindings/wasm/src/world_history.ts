import { arena, packPoints, packText, type Points } from './buffers.js';
import { refuse } from './errors.js';
import * as abi from './generated/abi.js';
import { check, lib, slots, withQuestion } from './runtime.js';
import { askCopy, askFlag, askId, askLong, askSize, type ItemId, put, toId } from './values.js';
import { type Change, packChanges, WorldItems } from './world_items.js';

export interface WorldOptions {
  /** Whether the world maintains the path abstraction. The default is true. */
  readonly keepAbstraction?: boolean;
  /** Whether the world can answer path queries for discs. The default is false. */
  readonly keepBridges?: boolean;
  /** The largest number of vertices that one operation may make. The default, Infinity, is no limit. */
  readonly newVertexLimit?: number;
}

const NO_LIMIT = 2 ** 32 - 1;

function toLimit(limit: number): number {
  if (!(limit >= 0) || (limit !== Infinity && !Number.isInteger(limit))) refuse(`${limit} is no limit for vertices`);
  return Math.min(limit, NO_LIMIT);
}

/** Writes options to a struct of the module. */
export function packWorldOptions(options: WorldOptions): number {
  const { ww_world_options: layout } = abi;
  const struct = slots.struct2;
  check(lib.ww_world_options_init(struct, layout.size_));
  if (options.keepAbstraction !== undefined) put.flag(struct + layout.keepAbstraction, options.keepAbstraction);
  if (options.keepBridges !== undefined) put.flag(struct + layout.keepBridges, options.keepBridges);
  if (options.newVertexLimit !== undefined) put.size(struct + layout.newVertexLimit, toLimit(options.newVertexLimit));
  return struct;
}

/** The part of World that goes back to earlier states, tries changes out, limits operations and saves the world. */
export abstract class WorldHistory extends WorldItems {
  /** Makes the world remember its last `ticks` ticks from now on. With 0, the world drops its history. */
  keepHistory(ticks: number): void {
    check(lib.ww_world_keep_history(this.address, toLimit(ticks)));
  }

  /** Names the current state. Returns its tick: 1 for the first call, and one more for each further call. */
  mark(): number {
    return askLong((tick) => lib.ww_world_mark(this.address, tick));
  }

  /** Brings back the state of the world at a tick, as one operation. The later ticks then no longer exist. */
  rewind(tick: number): void {
    check(lib.ww_world_rewind(this.address, toId(tick)));
  }

  /**
   * Makes changes, asks a question about the changed world, and takes the changes back. Returns the answer. The question
   * gets this world; it may make queries, but no changes.
   */
  attempt<T>(changes: readonly Change[], question: (changed: this) => T): T {
    const { address } = this;
    arena.reset();
    const list = packChanges(changes);
    let answer: { readonly value: T } | null = null;
    withQuestion(
      () => (answer = { value: question(this) }),
      () => lib.ww_js_world_attempt(address, list, changes.length),
    );
    return (answer as { readonly value: T } | null)!.value;
  }

  /**
   * Whether changes would enclose an agent: an agent gets from one of the points to another now but not after the changes,
   * or it can stand at one of the points now but not after the changes. The function makes no change.
   */
  wouldDisconnect(changes: readonly Change[], points: Points, radius = 0): boolean {
    arena.reset();
    const list = packChanges(changes);
    const { address, count } = packPoints(points);
    return askFlag((flag) =>
      lib.ww_world_would_disconnect(this.address, list, changes.length, address, count, radius, flag),
    );
  }

  /** The largest number of vertices that one operation may make. Infinity is no limit. */
  get newVertexLimit(): number {
    const limit = askSize((count) => lib.ww_world_new_vertex_limit(this.address, count));
    return limit === NO_LIMIT ? Infinity : limit;
  }
  set newVertexLimit(limit: number) {
    check(lib.ww_world_set_new_vertex_limit(this.address, toLimit(limit)));
  }

  /** The largest id that the world has seen, or 0. If the world chooses an id, it is this id plus 1. */
  get largestIdSeen(): ItemId {
    return askId((id) => lib.ww_world_largest_id_seen(this.address, id));
  }

  /** Lets the world continue its ids after `last`, as if it had seen this id. */
  reserveIds(last: ItemId): void {
    check(lib.ww_world_reserve_ids(this.address, toId(last)));
  }

  /** The saved world: its domain, options and items. `World.load` reads it. Equal worlds give equal bytes. */
  save(): Uint8Array {
    return askCopy((bytes) => lib.ww_world_save_bytes(this.address, bytes));
  }
}

/** Finds out whether bytes start like a saved world. */
export function isSavedWorld(bytes: Uint8Array): boolean {
  arena.reset();
  const { address, count } = packText(bytes.subarray(0, 1024));
  return askFlag((flag) => lib.ww_is_saved_world(address, count, flag));
}
