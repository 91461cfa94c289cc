import { arena, flatten, packPoints, packText, type Points, toBytes } from './buffers.js';
import { refuse, shown } from './errors.js';
import { fromLimit, toLimit } from './limits.js';
import { check, lib, scratch, withQuestion } from './runtime.js';
import { type Agent, copyAgent, putAgent } from './structs.js';
import { askCopy, askFlag, askId, askLong, askSize, type ItemId, toId, toLong } from './values.js';
import { type Change, copyChanges, packChanges, WorldItems } from './world_items.js';

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
    check(lib.ww_world_rewind(this.address, toLong(tick, 'tick')));
  }

  /**
   * Makes changes, asks a question about the changed world, and takes the changes back. Returns the answer. The question
   * gets this world. It may make queries, but no changes, clones, searches in slices, path watches and replay logs of this
   * world. It must return its answer at once: `attempt` refuses a promise.
   */
  attempt<T>(changes: readonly Change[], question: (changed: this) => T): T {
    if (typeof question !== 'function') refuse(`the question is ${shown(question)}, not a function`);
    const copies = copyChanges(changes);
    const { address } = this;
    arena.reset();
    const list = packChanges(copies);
    let answer: { readonly value: T } | null = null;
    const ask = (): void => {
      const value: unknown = question(this);
      if (value instanceof Promise) {
        value.catch(() => undefined);
        refuse('the question of an attempt returned a promise: it must answer at once');
      }
      answer = { value: value as T };
    };
    this.using(() => withQuestion(ask, () => lib.ww_js_world_attempt(address, list, copies.length)));
    return (answer as { readonly value: T } | null)!.value;
  }

  /**
   * Whether changes would enclose an agent: the agent can move from one of the points to another now but not after the
   * changes, or one of the points is not blocked now but is blocked after the changes. The function makes no change.
   */
  wouldDisconnect(changes: readonly Change[], points: Points, agent: Agent = {}): boolean {
    const [copies, coordinates, given] = [copyChanges(changes), flatten(points), copyAgent(agent)];
    arena.reset();
    const list = packChanges(copies);
    const { address, count } = packPoints(coordinates);
    const moving = putAgent(scratch.agent, given);
    return askFlag((flag) =>
      lib.ww_world_would_disconnect(this.address, list, copies.length, address, count, moving, flag),
    );
  }

  /** The largest number of vertices that one operation may make. Infinity is no limit. */
  get newVertexLimit(): number {
    return fromLimit(askSize((count) => lib.ww_world_new_vertex_limit(this.address, count)));
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
    const wanted = toId(last);
    check(lib.ww_world_reserve_ids(this.address, wanted));
  }

  /** The saved world: its domain, options and items. `World.load` reads it. Equal worlds give equal bytes. */
  save(): Uint8Array {
    return askCopy((bytes) => lib.ww_world_save_bytes(this.address, bytes));
  }
}

/** Finds out whether bytes start like a saved world. */
export function isSavedWorld(bytes: Uint8Array): boolean {
  const start = toBytes(bytes).subarray(0, 1024);
  arena.reset();
  const { address, count } = packText(start);
  return askFlag((flag) => lib.ww_is_saved_world(address, count, flag));
}
