import { copyIntegers, copyNumbers, readList, toSize } from './buffers.js';
import { ww_item_info } from './generated/abi.js';
import { toObject } from './errors.js';
import { Address, Handle, make } from './handle.js';
import { check, idAt, lib } from './runtime.js';
import { FILL_RULES, type FillRule, forEachShape, ITEM_KINDS, type ItemKind, packShape, type RaggedPoints, type Shape } from './shape.js';
import { answer, askSize, fromEnum, get, type ItemId, toId } from './values.js';

/** An item: its id and its shape. If the id is 0, a world that inserts the item chooses the id. */
export interface Item {
  readonly id?: ItemId;
  readonly shape: Shape;
}

/** Facts about an item of a list. */
export interface ItemInfo {
  readonly id: ItemId;
  readonly kind: ItemKind;
  readonly fill: FillRule;
  readonly pointCount: number;
  readonly ringCount: number;
}

/** A list of items in the memory of the module. A world reads and inserts such a list without further conversions. */
export class ItemList extends Handle {
  constructor(items?: Iterable<Item>);
  /** @internal */
  constructor(given: Address);
  constructor(given?: Iterable<Item> | Address) {
    if (given instanceof Address) {
      super(given.value, given.owner!);
      return;
    }
    super(make((address) => lib.ww_items_create(address)), (address) => lib.ww_items_destroy(address));
    try {
      for (const item of toObject(given ?? [], 'a list of items')) {
        const { id, shape } = toObject(item, 'an item');
        this.add(shape, id);
      }
    } catch (reason) {
      this.dispose();
      throw reason;
    }
  }

  clear(): void {
    check(lib.ww_items_clear(this.ownAddress));
  }

  /** Appends a copy of a shape. If `id` is 0, a world that inserts the item chooses the id. */
  add(shape: Shape, id: ItemId = 0): void {
    const [wanted, given] = [toId(id), packShape(shape)];
    check(lib.ww_items_add(this.ownAddress, wanted, given));
  }

  /** Appends many shapes of one kind. If `firstId` is not 0, the shapes get this id and the ids after it. */
  addMany(kind: ItemKind, shapes: RaggedPoints, firstId: ItemId = 0): void {
    let id = toId(firstId);
    forEachShape(kind, shapes, (struct) => {
      check(lib.ww_items_add(this.ownAddress, id, struct));
      if (id !== 0n) id += 1n;
    });
  }

  /** The number of items. */
  get length(): number {
    return askSize((count) => lib.ww_items_count(this.address, count));
  }

  info(index: number): ItemInfo {
    const struct = answer(ww_item_info);
    check(lib.ww_items_get_info(this.address, toSize(index), struct));
    return {
      id: idAt(struct + ww_item_info.id),
      kind: fromEnum(ITEM_KINDS, get.int(struct + ww_item_info.kind)),
      fill: fromEnum(FILL_RULES, get.int(struct + ww_item_info.fill)),
      pointCount: get.size(struct + ww_item_info.pointCount),
      ringCount: get.size(struct + ww_item_info.ringCount),
    };
  }

  /** The points of an item. */
  points(index: number, into?: Float64Array): Float64Array {
    const [items, at] = [this.address, toSize(index)];
    const list = readList(16, (buffer, capacity, count) => lib.ww_items_points(items, at, buffer, capacity, count));
    return copyNumbers(list.address, 2 * list.count, into);
  }

  /** The number of points of each ring of an item. */
  ringSizes(index: number, into?: Uint32Array): Uint32Array {
    const [items, at] = [this.address, toSize(index)];
    const list = readList(4, (buffer, capacity, count) => lib.ww_items_ring_sizes(items, at, buffer, capacity, count));
    return copyIntegers(list.address, list.count, into);
  }

  /** Copies an item. */
  get(index: number): Required<Item> {
    const { id, kind, fill } = this.info(index);
    return { id, shape: { kind, fill, points: this.points(index), ringSizes: this.ringSizes(index) } };
  }

  /** Copies the items, one after the other. */
  *[Symbol.iterator](): Generator<Required<Item>> {
    for (let i = 0, count = this.length; i < count; ++i) yield this.get(i);
  }
}
