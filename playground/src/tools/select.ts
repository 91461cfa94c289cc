// The tool that selects and moves, and the one that moves the picture.
import type { XY } from '../engine/protocol';
import type { Change } from '../model/document';
import { type Shape, translate, withPoint } from '../model/shape';
import { type Bench, itemAt, type Press, reach, type Tool } from './tool';

interface Move {
  readonly from: XY;
  readonly shapes: readonly (readonly [id: number, shape: Shape])[];
  /** The index of the corner that moves alone, or -1. */
  readonly corner: number;
  hasMoved: boolean;
}

/** Removes or moves the selected items. */
export class Selection {
  private readonly bench: Bench;

  constructor(bench: Bench) {
    this.bench = bench;
  }
  get ids(): Set<number> {
    return this.bench.view.selection;
  }
  shapes(): [number, Shape][] {
    const { items } = this.bench.session.document;
    return [...this.ids].flatMap((id): [number, Shape][] => (items.has(id) ? [[id, items.get(id)!]] : []));
  }
  remove(): void {
    const changes = this.shapes().map(([id, before]): Change => ({ id, before, after: null }));
    this.ids.clear();
    if (changes.length === 0) return;
    void this.bench.session.commit(changes.length === 1 ? `remove ${changes[0]!.before!.kind}` : 'remove items', changes);
  }
  nudge(dx: number, dy: number): void {
    const changes = this.shapes().map(([id, before]): Change => ({ id, before, after: translate(before, dx, dy) }));
    void this.bench.session.commit('move', changes);
  }
  duplicate(offset: number): void {
    const { session } = this.bench;
    const changes = this.shapes().map(
      ([, shape]): Change => ({ id: session.document.takeId(), before: null, after: translate(shape, offset, -offset) }),
    );
    void session.commit('copy', changes).then((isAccepted) => {
      if (!isAccepted) return;
      this.ids.clear();
      for (const { id } of changes) this.ids.add(id);
      this.bench.view.refresh();
    });
  }
}

export class SelectTool implements Tool {
  readonly id = 'select';
  readonly label = 'Select';
  readonly key = 'v';
  readonly hint = 'Drag an obstacle, or one corner of the selected one. Drag the ground to move the picture.';
  readonly cursor = 'default';
  private readonly bench: Bench;
  private readonly pan: PanTool;
  private moving: Move | null = null;

  constructor(bench: Bench, pan: PanTool) {
    this.bench = bench;
    this.pan = pan;
  }

  down(press: Press): void {
    const { exact, adds } = press;
    const { view, session } = this.bench;
    const corner = this.cornerAt(exact);
    const id = corner >= 0 ? [...view.selection][0]! : itemAt(this.bench, exact);
    if (id === null) {
      if (!adds) view.selection.clear();
      this.pan.down(press);
      view.refresh();
      return;
    }
    if (adds && view.selection.delete(id)) return view.refresh();
    if (!adds && !view.selection.has(id)) view.selection.clear();
    view.selection.add(id);
    const shapes = [...view.selection].map((each) => [each, session.document.items.get(each)!] as const);
    this.moving = { from: press.at, shapes: shapes.filter(([, shape]) => shape !== undefined), corner, hasMoved: false };
    view.refresh();
  }

  private cornerAt({ x, y }: XY): number {
    const { view, session } = this.bench;
    if (view.selection.size !== 1) return -1;
    const shape = session.document.items.get([...view.selection][0]!);
    if (shape === undefined || shape.kind === 'point' || shape.points.length > 400) return -1;
    const near = reach(this.bench, 9);
    for (let i = 0; 2 * i < shape.points.length; ++i) {
      if (Math.hypot(shape.points[2 * i]! - x, shape.points[2 * i + 1]! - y) <= near) return i;
    }
    return -1;
  }

  move(press: Press): void {
    const { moving } = this;
    if (moving === null) return this.pan.move(press);
    const [dx, dy] = [press.at.x - moving.from.x, press.at.y - moving.from.y];
    if (!moving.hasMoved && Math.hypot(dx, dy) < reach(this.bench, 3)) return;
    moving.hasMoved = true;
    const changed = (shape: Shape): Shape =>
      moving.corner < 0 ? translate(shape, dx, dy) : withPoint(shape, moving.corner, press.at.x, press.at.y);
    const changes = moving.shapes.map(([id, before]): Change => ({ id, before, after: changed(before) }));
    this.bench.view.lift(changes.map(({ id, after }) => [id, after!]));
    void this.bench.session.drag(changes);
  }

  up(): void {
    const { moving } = this;
    this.pan.up();
    if (moving === null) return;
    this.moving = null;
    if (!moving.hasMoved) return;
    const firsts = moving.shapes.map(([id, before]): Change => ({ id, before, after: null }));
    void this.bench.session.endDrag('move', firsts).then(() => this.bench.view.drop());
  }

  cancel(): boolean {
    const { view } = this.bench;
    if (this.moving !== null) return this.abandon();
    const had = view.selection.size > 0;
    view.selection.clear();
    view.refresh();
    return had;
  }

  /** Takes a move back. What is selected stays selected. */
  abandon(): boolean {
    const { moving, bench } = this;
    this.pan.cancel();
    if (moving === null) return false;
    this.moving = null;
    const firsts = moving.shapes.map(([id, before]): Change => ({ id, before, after: before }));
    if (moving.hasMoved) void bench.session.drag(firsts);
    void bench.session.endDrag('move', firsts).then(() => bench.view.drop());
    return moving.hasMoved;
  }
}

export class PanTool implements Tool {
  readonly id = 'pan';
  readonly label = 'Pan';
  readonly key = 'h';
  readonly hint = 'Drag to move the picture. The wheel, or two fingers, zoom.';
  readonly cursor = 'grab';
  private readonly bench: Bench;
  private held: XY | null = null;

  constructor(bench: Bench) {
    this.bench = bench;
  }
  down({ exact }: Press): void {
    this.held = exact;
  }
  move({ exact }: Press): void {
    if (this.held === null) return;
    const { camera } = this.bench.view;
    camera.x += this.held.x - exact.x;
    camera.y += this.held.y - exact.y;
    this.bench.view.refresh();
  }
  up(): void {
    this.held = null;
  }
  cancel(): boolean {
    this.held = null;
    return false;
  }
}
