// Tools that paint obstacles and erase them.
import type { XY } from '../engine/protocol';
import type { Change } from '../model/document';
import { distanceTo, regularPolygon } from '../model/shape';
import type { Bench, Press, Tool } from './tool';

const DAB_CORNERS = 8;

/** A tool whose stroke makes many changes and one step of the log. */
abstract class BrushTool implements Tool {
  abstract readonly id: string;
  abstract readonly label: string;
  abstract readonly key: string;
  abstract readonly hint: string;
  readonly cursor = 'crosshair';
  protected readonly bench: Bench;
  /** The first and the wanted shape of each item of the stroke. */
  protected readonly stroke = new Map<number, Change>();
  private last: XY | null = null;
  private isDown = false;

  constructor(bench: Bench) {
    this.bench = bench;
  }

  protected abstract dab(at: XY): void;
  protected abstract readonly title: string;

  down({ exact }: Press): void {
    this.isDown = true;
    this.last = null;
    this.stroke.clear();
    this.move({ exact, at: exact, adds: false });
  }

  move(press: Press): void {
    this.hover(press);
    if (!this.isDown) return;
    const { exact } = press;
    const spacing = this.bench.brush.radius * 0.9;
    const from = this.last ?? exact;
    const length = Math.hypot(exact.x - from.x, exact.y - from.y);
    if (this.last !== null && length < spacing) return;
    const count = Math.max(1, Math.min(64, Math.floor(length / spacing)));
    for (let i = 1; i <= count; ++i) {
      this.dab({ x: from.x + ((exact.x - from.x) * i) / count, y: from.y + ((exact.y - from.y) * i) / count });
    }
    this.last = exact;
    if (this.stroke.size > 0) void this.bench.session.drag([...this.stroke.values()]);
  }

  up(): void {
    if (!this.isDown) return;
    this.isDown = false;
    const firsts = [...this.stroke.values()];
    if (firsts.length > 0) void this.bench.session.endDrag(this.title, firsts);
  }

  hover({ exact }: Press): void {
    this.bench.view.preview = (context, camera, theme) => {
      context.beginPath();
      context.arc(camera.screenX(exact.x), camera.screenY(exact.y), this.bench.brush.radius * camera.scale, 0, 7);
      context.strokeStyle = theme.accent;
      context.lineWidth = 1.5;
      context.stroke();
    };
    this.bench.view.refresh();
  }

  cancel(): boolean {
    if (!this.isDown) return false;
    const firsts = [...this.stroke.values()];
    this.isDown = false;
    void this.bench.session.drag(firsts.map(({ id, before }) => ({ id, before, after: before })));
    void this.bench.session.endDrag(this.title, firsts);
    return true;
  }
}

export class PaintTool extends BrushTool {
  readonly id = 'paint';
  readonly label = 'Paint';
  readonly key = 'f';
  readonly hint = 'Drag to paint obstacles. [ and ] change the size of the brush.';
  protected readonly title = 'paint';

  protected dab({ x, y }: XY): void {
    const { session, brush } = this.bench;
    const id = session.document.takeId();
    const after = regularPolygon(x, y, brush.radius, DAB_CORNERS, Math.PI / DAB_CORNERS);
    this.stroke.set(id, { id, before: null, after });
  }
}

export class EraseTool extends BrushTool {
  readonly id = 'erase';
  readonly label = 'Erase';
  readonly key = 'e';
  readonly hint = 'Drag over items to remove them whole. [ and ] change the size of the brush.';
  protected readonly title = 'erase';

  protected dab({ x, y }: XY): void {
    const { session, brush } = this.bench;
    const { radius } = brush;
    for (const id of session.document.find([x - radius, y - radius, x + radius, y + radius])) {
      const shape = session.document.items.get(id)!;
      if (this.stroke.has(id) || distanceTo(shape, x, y) > radius) continue;
      this.stroke.set(id, { id, before: shape, after: null });
    }
  }
}
