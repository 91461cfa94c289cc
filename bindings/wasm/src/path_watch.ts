import { readList } from './buffers.js';
import { addressOf, Handle, make } from './handle.js';
import { Path } from './path.js';
import { check, lib } from './runtime.js';
import { askFlag, askSize, type ItemId, readIds, toLong } from './values.js';
import { World } from './world.js';

/** The answer of `PathWatch.update`: three lists of keys. The keys of each list ascend. A path can be in two lists. */
export interface PathChanges {
  /** The paths of point agents that are no longer clear. This list is exact. */
  readonly blocked: ItemId[];
  /** The paths of discs to which an inserted item is so near that the disc may touch it. */
  readonly mayBeBlocked: ItemId[];
  /** The paths that may be longer than necessary, because an item was removed, and those that have become possible. */
  readonly mayBeTooLong: ItemId[];
}

/** Watches the paths of many agents: after operations, it finds the paths that the agents should search for again. */
export class PathWatch extends Handle {
  private readonly world: World;

  /** Makes a watch without paths for a world. */
  constructor(world: World) {
    super(make((address) => lib.ww_path_watch_create(addressOf(World, world), address)), (address) =>
      lib.ww_path_watch_destroy(address),
    );
    this.world = world;
  }

  /** Watches a copy of a path under a key, instead of the path that the watch has under this key. */
  add(key: ItemId, path: Path): void {
    check(lib.ww_path_watch_add(this.address, toLong(key, 'key'), addressOf(Path, path)));
  }

  /** Stops watching the path under a key. Returns whether there was one. */
  remove(key: ItemId): boolean {
    const wanted = toLong(key, 'key');
    return askFlag((flag) => lib.ww_path_watch_remove(this.address, wanted, flag));
  }

  contains(key: ItemId): boolean {
    const wanted = toLong(key, 'key');
    return askFlag((flag) => lib.ww_path_watch_contains(this.address, wanted, flag));
  }

  /** The number of paths. */
  get size(): number {
    return askSize((count) => lib.ww_path_watch_count(this.address, count));
  }

  /** Finds out what the operations since the last update, or since the watch was made, mean for the paths. */
  update(): PathChanges {
    const { address } = this;
    check(lib.ww_path_watch_update(address, this.world.address));
    return {
      blocked: readIds(readList(8, (...list) => lib.ww_path_watch_blocked(address, ...list))),
      mayBeBlocked: readIds(readList(8, (...list) => lib.ww_path_watch_may_be_blocked(address, ...list))),
      mayBeTooLong: readIds(readList(8, (...list) => lib.ww_path_watch_may_be_too_long(address, ...list))),
    };
  }
}
