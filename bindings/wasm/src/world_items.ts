import { arena, packPoints, type Point, type Points, readList } from './buffers.js';
import { refuse } from './errors.js';
import * as abi from './generated/abi.js';
import { contextAddress, Handle, type QueryContext } from './handle.js';
import { type Item, ItemList } from './items.js';
import { check, lib, slots, withProgress } from './runtime.js';
import { packShape, type Shape } from './shape.js';
import { askFlag, askId, askSize, type ItemId, put, readIds, toId, writePoint } from './values.js';

/** One of several changes of `World.apply`. */
export type Change =
  | { readonly kind: 'insert'; readonly shape: Shape; readonly id?: ItemId }
  | { readonly kind: 'remove'; readonly id: ItemId }
  | { readonly kind: 'replace'; readonly id: ItemId; readonly shape: Shape };

const CHANGE_KINDS = { insert: abi.WW_CHANGE_INSERT, remove: abi.WW_CHANGE_REMOVE, replace: abi.WW_CHANGE_REPLACE };

export interface BulkOptions {
  /** The library calls it from time to time, at the end with `done === total`. It must not call functions of the package. */
  readonly progress?: (done: number, total: number) => void;
}

/** Copies changes into the arena. */
export function packChanges(changes: readonly Change[]): number {
  const { ww_change: layout, ww_shape: shape } = abi;
  const address = arena.take(layout.size_ * changes.length);
  changes.forEach((change, i) => {
    const struct = address + layout.size_ * i;
    const kind = CHANGE_KINDS[change.kind] ?? refuse(`'${String(change.kind)}' is no kind of change`);
    const id = toId(change.id ?? 0);
    const given = change.kind === 'remove' ? 0 : packShape(change.shape, arena.take(shape.size_));
    put.int(struct + layout.kind, kind);
    put.long(struct + layout.id, id);
    put.size(struct + layout.shape, given);
  });
  return address;
}

/** Writes options to a struct of the module. */
export function packBulk(options: BulkOptions): number {
  check(lib.ww_bulk_options_init(slots.struct, abi.ww_bulk_options.size_));
  if (options.progress !== undefined) lib.ww_js_report_progress(slots.struct);
  return slots.struct;
}

/** The part of World that changes and reads items. */
export abstract class WorldItems extends Handle {
  /** Inserts a shape. If `id` is 0, the world chooses the id. Returns the id. */
  insert(shape: Shape, id: ItemId = 0): ItemId {
    arena.reset();
    const wanted = toId(id);
    return askId((inserted) => lib.ww_world_insert(this.address, packShape(shape), wanted, inserted));
  }

  insertPoint(point: Point, id: ItemId = 0): ItemId {
    const wanted = toId(id);
    return askId((inserted) => lib.ww_world_insert_point(this.address, writePoint(slots.a, point), wanted, inserted));
  }

  insertSegment(a: Point, b: Point, id: ItemId = 0): ItemId {
    const wanted = toId(id);
    return askId((inserted) =>
      lib.ww_world_insert_segment(this.address, writePoint(slots.a, a), writePoint(slots.b, b), wanted, inserted),
    );
  }

  insertPolyline(points: Points, id: ItemId = 0): ItemId {
    arena.reset();
    const wanted = toId(id);
    const { address, count } = packPoints(points);
    return askId((inserted) => lib.ww_world_insert_polyline(this.address, address, count, wanted, inserted));
  }

  /** Inserts a polygon of one ring. For several rings, use `insert` and `Shape.polygon`. */
  insertPolygon(points: Points, id: ItemId = 0): ItemId {
    arena.reset();
    const wanted = toId(id);
    const { address, count } = packPoints(points);
    return askId((inserted) => lib.ww_world_insert_polygon(this.address, address, count, wanted, inserted));
  }

  remove(id: ItemId): void {
    check(lib.ww_world_remove(this.address, toId(id)));
  }

  /** Gives an item another shape. */
  replace(id: ItemId, shape: Shape): void {
    arena.reset();
    check(lib.ww_world_replace(this.address, toId(id), packShape(shape)));
  }

  /** Inserts many items as one operation. Returns their ids. */
  insertAll(items: ItemList | Iterable<Item>, options: BulkOptions = {}): ItemId[] {
    const list = items instanceof ItemList ? items : new ItemList(items);
    try {
      const count = list.length;
      arena.reset();
      const ids = arena.take(8 * count);
      const bulk = packBulk(options);
      withProgress(options.progress, () => check(lib.ww_world_insert_all(this.address, list.address, bulk, ids)));
      return readIds({ address: ids, count });
    } finally {
      if (list !== items) list.dispose();
    }
  }

  /** Inserts many points as one operation. Their ids count up from `first`. Returns the first id. */
  insertPoints(points: Points, first: ItemId = 0, options: BulkOptions = {}): ItemId {
    arena.reset();
    const wanted = toId(first);
    const { address, count } = packPoints(points);
    const bulk = packBulk(options);
    return withProgress(options.progress, () =>
      askId((firstId) => lib.ww_world_insert_points(this.address, address, count, wanted, bulk, firstId)),
    );
  }

  /** Makes several changes, one after the other, as one operation. Returns the id of each. */
  apply(changes: readonly Change[]): ItemId[] {
    arena.reset();
    const list = packChanges(changes);
    const ids = arena.take(8 * changes.length);
    check(lib.ww_world_apply(this.address, list, changes.length, ids));
    return readIds({ address: ids, count: changes.length });
  }

  contains(id: ItemId): boolean {
    const wanted = toId(id);
    return askFlag((flag) => lib.ww_world_contains(this.address, wanted, flag));
  }

  get itemCount(): number {
    return askSize((count) => lib.ww_world_item_count(this.address, count));
  }

  /** The ids of all live items, ascending. */
  itemIds(): ItemId[] {
    const { address } = this;
    return readIds(readList(8, (buffer, capacity, count) => lib.ww_world_item_ids(address, buffer, capacity, count)));
  }

  /** The shape of an item. */
  shape(id: ItemId): Shape {
    const list = new ItemList();
    try {
      check(lib.ww_world_item(this.address, toId(id), list.address));
      return list.get(0).shape;
    } finally {
      list.dispose();
    }
  }

  /** All live items, ascending by id, in the given list or in a new one. */
  items(list: ItemList = new ItemList(), context?: QueryContext): ItemList {
    check(lib.ww_world_items(this.address, contextAddress(context), list.address));
    return list;
  }
}
