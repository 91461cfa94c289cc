// Tools that draw new items.
import type { XY } from '../engine/protocol';
import type { Change } from '../model/document';
import { makeShape, type Kind, type Shape } from '../model/shape';
import type { Bench, Press, Tool } from './tool';
import { reach } from './tool';

/** A tool that makes an item between the press and the release. The item is in the world all the time. */
abstract class DragTool implements Tool {
  abstract readonly id: string;
  abstract readonly label: string;
  abstract readonly key: string;
  abstract readonly hint: string;
  readonly cursor = 'crosshair';
  protected readonly bench: Bench;
  private item: { readonly id: number; readonly from: XY } | null = null;

  constructor(bench: Bench) {
    this.bench = bench;
  }

  protected abstract shape(from: XY, to: XY): Shape | null;

  down({ at }: Press): void {
    this.item = { id: this.bench.session.document.takeId(), from: at };
  }
  move({ at }: Press): void {
    if (this.item === null) return;
    const after = this.shape(this.item.from, at);
    if (after === null) return;
    this.bench.view.lift([[this.item.id, after]]);
    void this.bench.session.drag([{ id: this.item.id, before: null, after }]);
  }
  up(press: Press): void {
    const { item } = this;
    if (item === null) return;
    this.move(press);
    this.item = null;
    void this.bench.session.endDrag(`insert ${this.label.toLowerCase()}`, [{ id: item.id, before: null, after: null }])
      .then(() => this.bench.view.drop());
  }
  cancel(): boolean {
    const { item, bench } = this;
    if (item === null) return false;
    this.item = null;
    const changes: Change[] = [{ id: item.id, before: null, after: null }];
    void bench.session.drag(changes);
    void bench.session.endDrag('nothing', changes).then(() => bench.view.drop());
    return true;
  }
}

export class WallTool extends DragTool {
  readonly id = 'wall';
  readonly label = 'Wall';
  readonly key = 'w';
  readonly hint = 'Drag from one end of the wall to the other.';

  protected shape(from: XY, to: XY): Shape | null {
    return from.x === to.x && from.y === to.y ? null : makeShape('segment', [from.x, from.y, to.x, to.y]);
  }
}

export class BoxTool extends DragTool {
  readonly id = 'box';
  readonly label = 'Box';
  readonly key = 'b';
  readonly hint = 'Drag from one corner to the opposite one.';

  protected shape(a: XY, b: XY): Shape | null {
    if (a.x === b.x || a.y === b.y) return null;
    const [x0, x1, y0, y1] = [Math.min(a.x, b.x), Math.max(a.x, b.x), Math.min(a.y, b.y), Math.max(a.y, b.y)];
    return makeShape('polygon', [x0, y0, x1, y0, x1, y1, x0, y1]);
  }
}

export class PointTool implements Tool {
  readonly id = 'point';
  readonly label = 'Point';
  readonly key = 'p';
  readonly hint = 'Click to insert a vertex. It blocks nothing.';
  readonly cursor = 'crosshair';
  private readonly bench: Bench;

  constructor(bench: Bench) {
    this.bench = bench;
  }
  down(): void {}
  move(): void {}
  up({ at }: Press): void {
    const { session } = this.bench;
    const id = session.document.takeId();
    void session.commit('insert point', [{ id, before: null, after: makeShape('point', [at.x, at.y]) }]);
  }
  readonly clicks = true;
  abandon(): boolean {
    return false;
  }
  cancel(): boolean {
    return false;
  }
}

/** A tool that collects corners. */
abstract class CornersTool implements Tool {
  abstract readonly id: string;
  abstract readonly label: string;
  abstract readonly key: string;
  abstract readonly hint: string;
  protected abstract readonly kind: Kind;
  protected abstract readonly least: number;
  readonly cursor = 'crosshair';
  private readonly bench: Bench;
  readonly clicks = true;
  private corners: XY[] = [];
  private next: XY | null = null;

  constructor(bench: Bench) {
    this.bench = bench;
  }

  down(press: Press): void {
    this.hover(press);
  }
  up({ at, exact }: Press): void {
    const { corners } = this;
    const [first, last] = [corners[0], corners.at(-1)];
    const near = reach(this.bench, 10);
    const isNear = (corner: XY | undefined): boolean =>
      corner !== undefined && Math.hypot(corner.x - exact.x, corner.y - exact.y) <= near;
    if (corners.length >= this.least && (isNear(last) || (this.kind === 'polygon' && isNear(first)))) {
      this.finish();
      return;
    }
    if (!isNear(last)) corners.push(at);
    this.show();
  }
  move(press: Press): void {
    this.hover(press);
  }
  abandon(): boolean {
    return false;
  }
  hover({ at }: Press): void {
    this.next = at;
    if (this.corners.length > 0) this.bench.view.refresh();
  }

  finish(): void {
    const { corners, kind, bench } = this;
    if (corners.length === 0) return;
    if (corners.length < this.least) {
      bench.note(`This needs ${this.least} corners or more; it has ${corners.length}. Click to add a corner.`);
      return;
    }
    const id = bench.session.document.takeId();
    const after = makeShape(kind, corners.flatMap(({ x, y }) => [x, y]));
    void bench.session.commit(`insert ${kind}`, [{ id, before: null, after }]).then((isAccepted) => {
      if (isAccepted) this.clear();
    });
  }
  stepBack(): boolean {
    const had = this.corners.pop() !== undefined;
    this.show();
    return had;
  }
  cancel(): boolean {
    const had = this.corners.length > 0;
    this.clear();
    return had;
  }

  private clear(): void {
    this.corners = [];
    this.bench.view.preview = null;
    this.bench.view.refresh();
  }

  private show(): void {
    this.bench.view.preview = (context, camera, theme) => {
      const corners = this.next === null ? this.corners : [...this.corners, this.next];
      if (this.corners.length === 0) return;
      context.beginPath();
      for (const corner of corners) context.lineTo(camera.screenX(corner.x), camera.screenY(corner.y));
      if (this.kind === 'polygon') {
        context.fillStyle = theme['accent-soft'];
        context.fill();
      }
      context.strokeStyle = theme.accent;
      context.lineWidth = 2;
      context.stroke();
      for (const corner of this.corners) {
        context.fillStyle = theme.page;
        context.fillRect(camera.screenX(corner.x) - 3.5, camera.screenY(corner.y) - 3.5, 7, 7);
        context.strokeRect(camera.screenX(corner.x) - 3.5, camera.screenY(corner.y) - 3.5, 7, 7);
      }
    };
    this.bench.view.refresh();
  }
}

export class ChainTool extends CornersTool {
  readonly id = 'chain';
  readonly label = 'Chain';
  readonly key = 'c';
  readonly hint = 'Click the corners of a chain. Its straight pieces are walls. Enter, or a second click on the last corner, ends it.';
  protected readonly kind = 'polyline';
  protected readonly least = 2;
}

export class PolygonTool extends CornersTool {
  readonly id = 'polygon';
  readonly label = 'Polygon';
  readonly key = 'g';
  readonly hint = 'Click the corners of an obstacle. Enter, or a click on the first corner, closes it.';
  protected readonly kind = 'polygon';
  protected readonly least = 3;
}
