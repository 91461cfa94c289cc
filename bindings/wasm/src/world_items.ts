import { arena, copyList, flatten, packPoints, type Point, type Points, readList } from './buffers.js';
import { refuse, shown, toObject } from './errors.js';
import * as abi from './generated/abi.js';
import { contextAddress, Handle, ownAddressOf, type QueryContext } from './handle.js';
import { type Item, ItemList } from './items.js';
import { check, lib, scratch, withProgress } from './runtime.js';
import { copyShape, packCopy, packShape, type Shape, type ShapeCopy } from './shape.js';
import { askFlag, askId, askSize, type ItemId, put, readIds, toId, writeEnds, writePoint } from './values.js';

/** One of several changes of `World.apply`. */
export type Change =
  | { readonly kind: 'insert'; readonly shape: Shape; readonly id?: ItemId }
  | { readonly kind: 'remove'; readonly id: ItemId }
  | { readonly kind: 'replace'; readonly id: ItemId; readonly shape: Shape };

const CHANGE_KINDS = { insert: abi.WW_CHANGE_INSERT, remove: abi.WW_CHANGE_REMOVE, replace: abi.WW_CHANGE_REPLACE };

export interface BulkOptions {
  /**
   * The library calls it from time to time, at the end with `done === total`. It must not call functions of the package. It
   * cannot stop the call: if it throws, the call does its work, and throws this error afterwards.
   */
  readonly progress?: (done: number, total: number) => void;
}

/** A copy of a change that a caller has given. */
interface ChangeCopy {
  readonly kind: number;
  readonly id: bigint;
  readonly shape: ShapeCopy | null;
}

function copyChange(change: Change): ChangeCopy {
  const { kind, id = 0 } = toObject(change, 'a change');
  if (!Object.hasOwn(CHANGE_KINDS, kind)) refuse(`${shown(kind)} is no kind of change`);
  const shape = kind === 'remove' ? null : copyShape((change as { readonly shape: Shape }).shape);
  return { kind: CHANGE_KINDS[kind], id: toId(id), shape };
}

export function copyChanges(changes: readonly Change[]): readonly ChangeCopy[] {
  return copyList(changes, 'a list of changes', copyChange);
}

/** Copies changes into the arena. */
export function packChanges(changes: readonly ChangeCopy[]): number {
  const { ww_change: layout, ww_shape: shapeLayout } = abi;
  const address = arena.take(layout.size_ * changes.length);
  changes.forEach(({ kind, id, shape }, i) => {
    const struct = address + layout.size_ * i;
    const given = shape === null ? 0 : packCopy(shape, arena.take(shapeLayout.size_));
    put.int(struct + layout.kind, kind);
    put.long(struct + layout.id, id);
    put.size(struct + layout.shape, given);
  });
  return address;
}

/** Returns the progress function of options that a caller has given. */
export function progressOf(options: BulkOptions): BulkOptions['progress'] {
  return toObject(options, 'the options').progress;
}

/** Writes options to a struct of the module. */
export function packBulk(progress: BulkOptions['progress']): number {
  check(lib.ww_bulk_options_init(scratch.struct, abi.ww_bulk_options.size_));
  if (progress !== undefined) lib.ww_js_report_progress(scratch.struct);
  return scratch.struct;
}

/** The part of World that changes and reads items. */
export abstract class WorldItems extends Handle {
  /** Inserts a shape. If `id` is 0, the world chooses the id. Returns the id. */
  insert(shape: Shape, id: ItemId = 0): ItemId {
    const [wanted, given] = [toId(id), packShape(shape)];
    return askId((inserted) => lib.ww_world_insert(this.address, given, wanted, inserted));
  }

  insertPoint(point: Point, id: ItemId = 0): ItemId {
    const [wanted, at] = [toId(id), writePoint(scratch.a, point)];
    return askId((inserted) => lib.ww_world_insert_point(this.address, at, wanted, inserted));
  }

  insertSegment(a: Point, b: Point, id: ItemId = 0): ItemId {
    const [wanted, [from, to]] = [toId(id), writeEnds(a, b)];
    return askId((inserted) => lib.ww_world_insert_segment(this.address, from, to, wanted, inserted));
  }

  insertPolyline(points: Points, id: ItemId = 0): ItemId {
    const [wanted, coordinates] = [toId(id), flatten(points)];
    arena.reset();
    const { address, count } = packPoints(coordinates);
    return askId((inserted) => lib.ww_world_insert_polyline(this.address, address, count, wanted, inserted));
  }

  /** Inserts a polygon of one ring. For several rings, use `insert` and `Shape.polygon`. */
  insertPolygon(points: Points, id: ItemId = 0): ItemId {
    const [wanted, coordinates] = [toId(id), flatten(points)];
    arena.reset();
    const { address, count } = packPoints(coordinates);
    return askId((inserted) => lib.ww_world_insert_polygon(this.address, address, count, wanted, inserted));
  }

  remove(id: ItemId): void {
    const wanted = toId(id);
    check(lib.ww_world_remove(this.address, wanted));
  }

  /** Gives an item another shape. */
  replace(id: ItemId, shape: Shape): void {
    const [wanted, given] = [toId(id), packShape(shape)];
    check(lib.ww_world_replace(this.address, wanted, given));
  }

  /** Inserts many items as one operation. Returns their ids. */
  insertAll(items: ItemList | Iterable<Item>, options: BulkOptions = {}): ItemId[] {
    const progress = progressOf(options);
    const list = items instanceof ItemList ? items : new ItemList(toObject(items, 'a list of items'));
    try {
      const count = list.length;
      arena.reset();
      const ids = arena.take(8 * count);
      const bulk = packBulk(progress);
      withProgress(progress, () => check(lib.ww_world_insert_all(this.address, list.address, bulk, ids)));
      return readIds({ address: ids, count });
    } finally {
      if (list !== items) list.dispose();
    }
  }

  /** Inserts many points as one operation. Their ids count up from `first`. Returns the first id. */
  insertPoints(points: Points, first: ItemId = 0, options: BulkOptions = {}): ItemId {
    const [wanted, coordinates, progress] = [toId(first), flatten(points), progressOf(options)];
    arena.reset();
    const { address, count } = packPoints(coordinates);
    const bulk = packBulk(progress);
    return withProgress(progress, () =>
      askId((firstId) => lib.ww_world_insert_points(this.address, address, count, wanted, bulk, firstId)),
    );
  }

  /** Makes several changes, one after the other, as one operation. Returns the id of each. */
  apply(changes: readonly Change[]): ItemId[] {
    const copies = copyChanges(changes);
    const count = copies.length;
    arena.reset();
    const list = packChanges(copies);
    const ids = arena.take(8 * count);
    check(lib.ww_world_apply(this.address, list, count, ids));
    return readIds({ address: ids, count });
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
    check(lib.ww_world_items(this.address, contextAddress(context), ownAddressOf(ItemList, list)));
    return list;
  }
}
