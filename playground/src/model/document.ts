// The page's copy of the items, and the log of operations with which people go back and forth.
import type { WireChange } from '../engine/protocol';
import { Grid } from './grid';
import { type Bounds, boundsOf, type Shape, unite } from './shape';

/** A change of one item. Null stands for no item. */
export interface Change {
  readonly id: number;
  readonly before: Shape | null;
  readonly after: Shape | null;
}

export interface Entry {
  readonly label: string;
  readonly changes: readonly Change[];
}

export type IdentifiedShape = readonly [id: number, shape: Shape];

export class Document {
  readonly domain: Bounds;
  readonly yDown: boolean;
  readonly title: string;
  /** What the page shows first. */
  readonly view: Bounds;
  readonly items = new Map<number, Shape>();
  private grid: Grid;
  private log_: Entry[] = [];
  private cursor_ = 0;
  nextId = 1;

  constructor(domain: Bounds, items: readonly IdentifiedShape[], title: string, { yDown = false, size = items.length, view = domain } = {}) {
    this.domain = domain;
    this.view = view;
    this.title = title;
    this.yDown = yDown;
    this.grid = new Grid(domain, Math.max(size, 1000));
    for (const [id, shape] of items) this.set(id, shape);
  }

  get log(): readonly Entry[] {
    return this.log_;
  }
  /** How many entries of the log are done. */
  get cursor(): number {
    return this.cursor_;
  }

  /** Sets or removes an item of the copy. */
  set(id: number, shape: Shape | null): void {
    if (shape === null) {
      this.items.delete(id);
      this.grid.remove(id);
      return;
    }
    this.items.set(id, shape);
    this.grid.set(id, boundsOf(shape));
    if (id >= this.nextId) this.nextId = id + 1;
  }

  takeId(): number {
    return this.nextId++;
  }

  /** Records what the engine has done. It drops the entries that were undone. */
  record(entry: Entry): void {
    this.log_.length = this.cursor_;
    this.log_.push(entry);
    this.cursor_ = this.log_.length;
    for (const { id, after } of entry.changes) this.set(id, after);
  }

  /** The changes that lead to another position in the log: one for each item. */
  changesTo(target: number): Change[] {
    const merged = new Map<number, Change>();
    const add = ({ id, before, after }: Change): void => {
      merged.set(id, { id, before: merged.get(id)?.before ?? (merged.has(id) ? null : before), after });
    };
    for (let i = this.cursor_; i < target; ++i) this.log_[i]!.changes.forEach(add);
    for (let i = this.cursor_ - 1; i >= target; --i) {
      for (const { id, before, after } of [...this.log_[i]!.changes].reverse()) add({ id, before: after, after: before });
    }
    return [...merged.values()].filter(({ before, after }) => before !== after);
  }

  moveTo(target: number, changes: readonly Change[]): void {
    this.cursor_ = target;
    for (const { id, after } of changes) this.set(id, after);
  }

  find(box: Bounds): number[] {
    return this.grid.find(box);
  }
  boundsOf(id: number): Bounds | undefined {
    return this.grid.box(id);
  }

  /** The items, ascending by id. */
  sortedItems(): IdentifiedShape[] {
    return [...this.items].sort(([a], [b]) => a - b);
  }
}

export function toWire(changes: readonly Change[]): WireChange[] {
  return changes.map(({ id, before, after }) => ({ id, exists: before !== null, after }));
}

/** The box of all shapes of changes, before and after. */
export function boundsOfChanges(changes: readonly Change[]): Bounds | null {
  let box: Bounds | null = null;
  for (const { before, after } of changes) {
    for (const shape of [before, after]) {
      if (shape === null) continue;
      const bounds = boundsOf(shape);
      box = box === null ? bounds : unite(box, bounds);
    }
  }
  return box;
}
