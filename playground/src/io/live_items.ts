import { ringsOf } from './items';
import type { Domain, Item, ItemId, Operation } from './types';

interface Live {
  readonly item: Item;
  /** Ascends with the insertions. */
  readonly order: number;
}

function fits(item: Item, [minX, minY, maxX, maxY]: Domain): boolean {
  return ringsOf(item).every((ring) => ring.every(([x, y]) => x >= minX && x <= maxX && y >= minY && y <= maxY));
}

/** Follows the changes of a script, and finds out which items are left. */
export class LiveItems {
  private readonly domain: Domain;
  private readonly live = new Map<ItemId, Live>();
  /** The changes since the first mark, with what they replaced. */
  private readonly undo: { readonly id: ItemId; readonly before: Live | undefined }[] = [];
  /** The length of `undo` at each mark. */
  private readonly marks: number[] = [];
  private inserted = 0;

  constructor(domain: Domain) {
    this.domain = domain;
  }

  /** The tick of the last mark, or of the last rewind after it. */
  get lastMark(): number {
    return this.marks.length;
  }

  /** Makes a change. Returns why a world refuses it, or null. */
  apply(operation: Operation): string | null {
    switch (operation.kind) {
      case 'insert':
      case 'replace':
        return this.put(operation.kind, operation.id, operation.item);
      case 'remove':
        if (!this.live.has(operation.id)) return `no item has id ${operation.id}`;
        this.set(operation.id, undefined);
        return null;
      case 'mark':
        this.marks.push(this.undo.length);
        return null;
      case 'rewind':
        this.rewind(operation.tick);
        return null;
      default:
        return null;
    }
  }

  private put(kind: 'insert' | 'replace', id: ItemId, item: Item): string | null {
    const before = this.live.get(id);
    if (kind === 'insert' && before !== undefined) return `an item has id ${id} already`;
    if (kind === 'replace' && before === undefined) return `no item has id ${id}`;
    if (!fits(item, this.domain)) return `item ${id} is not inside the domain`;
    this.set(id, { item, order: before?.order ?? this.inserted++ });
    return null;
  }

  private set(id: ItemId, now: Live | undefined): void {
    if (this.marks.length > 0) this.undo.push({ id, before: this.live.get(id) });
    this.restore(id, now);
  }

  private restore(id: ItemId, state: Live | undefined): void {
    if (state === undefined) this.live.delete(id);
    else this.live.set(id, state);
  }

  private rewind(tick: number): void {
    const length = this.marks[tick - 1];
    if (length === undefined) return;
    this.marks.length = tick;
    while (this.undo.length > length) {
      const { id, before } = this.undo.pop()!;
      this.restore(id, before);
    }
  }

  /** The items that are left, in the order of their insertions. */
  result(): { readonly items: Item[]; readonly ids: ItemId[] } {
    const left = [...this.live].sort(([, a], [, b]) => a.order - b.order);
    return { items: left.map(([, { item }]) => item), ids: left.map(([id]) => id) };
  }
}
