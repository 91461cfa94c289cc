// Replays the operations of a script or a link on the page's copy of the items.
import type { ItemId, Operation } from '../io/types';
import { type Change, Document } from './document';
import type { Shape } from './shape';

/** The state that a rewind to a mark brings back. */
interface Mark {
  /** The number of changes since the first mark. */
  readonly changeCount: number;
  readonly nextId: number;
}

/** How a replay reads the ids and items of operations. */
export interface Reader {
  id(id: ItemId): number;
  shape(operation: Extract<Operation, { kind: 'insert' | 'replace' }>): Shape;
}

/** Makes the changes of operations in a document. Marks and ticks divide them into steps of its log. */
export class Replay {
  private readonly document: Document;
  private readonly reader: Reader;
  private step: Change[] = [];
  private isFirst = true;
  private readonly marks: Mark[] = [];
  private readonly undo: Change[] = [];

  constructor(document: Document, reader: Reader) {
    this.document = document;
    this.reader = reader;
  }

  run(operations: readonly Operation[]): void {
    for (const operation of operations) this.apply(operation);
    this.endStep();
  }

  private apply(operation: Operation): void {
    switch (operation.kind) {
      case 'insert':
      case 'replace':
        return this.change(this.reader.id(operation.id), this.reader.shape(operation));
      case 'remove':
        return this.change(this.reader.id(operation.id), null);
      case 'tick':
        return this.endStep();
      case 'mark':
        this.endStep();
        this.marks.push({ changeCount: this.undo.length, nextId: this.document.nextId });
        return;
      case 'rewind':
        return this.rewind(operation.tick);
      default:
    }
  }

  private change(id: number, after: Shape | null): void {
    const { document, undo, marks, step } = this;
    const before = document.items.get(id) ?? null;
    if (before === after) return;
    document.set(id, after);
    const change = { id, before, after };
    if (marks.length > 0) undo.push(change);
    if (!this.isFirst) step.push(change);
  }

  private rewind(tick: number): void {
    const mark = this.marks[tick - 1];
    if (mark === undefined) return;
    this.endStep();
    this.marks.length = tick;
    for (const { id, before, after } of this.undo.splice(mark.changeCount).reverse()) {
      this.document.set(id, before);
      this.step.push({ id, before: after, after: before });
    }
    this.endStep(`rewind to mark ${tick}`);
    this.document.nextId = mark.nextId;
  }

  /** Records the changes since the last step. Those before the first mark or tick belong to the world at the beginning. */
  private endStep(label?: string): void {
    this.isFirst = false;
    const { step } = this;
    this.step = [];
    if (step.length > 0) this.document.record({ label: label ?? labelOf(step), changes: step });
  }
}

function labelOf(changes: readonly Change[]): string {
  const first = changes[0]!;
  const what = changes.length === 1 ? (first.after ?? first.before)!.kind : `${changes.length} items`;
  if (first.before === null) return `insert ${what}`;
  return first.after === null ? `remove ${what}` : `move ${what}`;
}
