// Turns the events of mouse, touch and pen into presses of the tool, drags of the ends, and moves of the camera.
import type { XY } from '../engine/protocol';
import { endPixels } from '../view/overlay';
import type { Bench, Press, Tool } from './tool';

const END_REACH_PIXELS = 13;

/** The grid on which presses snap: about 1/100 of a width, a power of ten times 1, 2 or 5. */
export function gridStep(width: number): number {
  const rough = width / 100;
  const power = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].map((factor) => factor * power).find((step) => step >= rough)!;
}

export class Pointers {
  tool: Tool;
  snaps = false;
  private readonly bench: Bench;
  private readonly held = new Map<number, XY>();
  private end: 'start' | 'goal' | null = null;
  private pans = false;
  private isPressed = false;
  /** Whether the space bar holds the tool. */
  private isHeldByKey = false;

  constructor(bench: Bench, tool: Tool) {
    this.bench = bench;
    this.tool = tool;
    const { canvas } = bench.view;
    canvas.addEventListener('pointerdown', (event) => this.onDown(event));
    canvas.addEventListener('pointermove', (event) => this.onMove(event));
    for (const name of ['pointerup', 'pointercancel'] as const) canvas.addEventListener(name, (event) => this.onUp(event));
    canvas.addEventListener('dblclick', () => this.tool.finish?.());
    canvas.addEventListener('wheel', (event) => this.onWheel(event), { passive: false });
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('pointerleave', () => this.leave());
    // The frame around the canvas is for people who have moved there with the Tab key. Other people see their pointer.
    canvas.addEventListener('keyup', ({ key }) => canvas.classList.toggle('tabbed', key === 'Tab' || canvas.classList.contains('tabbed')));
    for (const name of ['blur', 'pointerdown']) canvas.addEventListener(name, () => canvas.classList.remove('tabbed'));
  }

  private leave(): void {
    this.bench.view.pointer = null;
    this.bench.view.refresh();
  }

  pressAt(exact: XY, adds = false): Press {
    if (!this.snaps) return { at: exact, exact, adds };
    const [x0, , x1] = this.bench.session.document.view;
    const step = gridStep(x1 - x0);
    return { at: { x: Math.round(exact.x / step) * step, y: Math.round(exact.y / step) * step }, exact, adds };
  }

  private press(event: PointerEvent): Press {
    const { camera } = this.bench.view;
    return this.pressAt(camera.toWorld(event.offsetX, event.offsetY), event.shiftKey);
  }

  /** The end under a pixel. */
  private endAt(x: number, y: number): 'start' | 'goal' | null {
    const { session, view } = this.bench;
    const reach = Math.max(END_REACH_PIXELS, Math.min(60, endPixels(session.ends.radius, view.camera)));
    for (const end of ['goal', 'start'] as const) {
      const at = view.camera.toScreen(session.ends[end]);
      if (Math.hypot(at.x - x, at.y - y) <= reach) return end;
    }
    return null;
  }

  /** Puts an end at a position, inside the domain. */
  moveEnd(end: 'start' | 'goal', { x, y }: XY): void {
    const { session } = this.bench;
    const [x0, y0, x1, y1] = session.document.domain;
    session.ends[end] = { x: Math.min(x1, Math.max(x0, x)), y: Math.min(y1, Math.max(y0, y)) };
    session.askRoutes();
  }

  private onDown(event: PointerEvent): void {
    const { view } = this.bench;
    view.canvas.setPointerCapture(event.pointerId);
    this.held.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    if (this.isHeldByKey) this.interrupt();
    if (this.held.size > 1) {
      this.giveUp();
      return;
    }
    view.cursor = null;
    view.pointer = this.press(event).exact;
    this.pans = event.button === 1 || event.button === 2;
    if (this.pans) return;
    this.end = this.endAt(event.offsetX, event.offsetY);
    if (this.end !== null) this.bench.session.setDragging(true);
    else this.tool.down(this.press(event));
    this.isPressed = true;
  }

  /** Ends the press of the tool, which takes back what it has begun. Returns whether that was something. */
  interrupt(): boolean {
    const isPressed = this.isHeldByKey || (this.isPressed && this.end === null);
    if (!isPressed) return false;
    this.isHeldByKey = false;
    this.isPressed = false;
    const { tool } = this;
    return tool.abandon === undefined ? tool.cancel() : tool.abandon();
  }

  /** Ends the press of the tool, or the drag of an end where it is. Two fingers do that: they move and zoom. */
  giveUp(): void {
    this.interrupt();
    if (this.end !== null) this.dropEnd();
    this.isPressed = false;
  }

  private dropEnd(): void {
    this.end = null;
    this.bench.session.setDragging(false);
    this.bench.session.askRoutes();
  }

  /** The space bar presses, and releases when it is hit again. Returns whether it holds the tool now. */
  pressByKey(at: XY): boolean {
    const { tool } = this;
    if (this.isPressed) return false;
    const press = this.pressAt(at);
    if (!this.isHeldByKey) tool.down(press);
    const releases = this.isHeldByKey || tool.clicks === true;
    this.isHeldByKey = !releases;
    if (releases) tool.up(press);
    return this.isHeldByKey;
  }

  moveByKey(at: XY): void {
    const press = this.pressAt(at);
    if (this.isHeldByKey) this.tool.move(press);
    else if (!this.isPressed) this.tool.hover?.(press);
  }

  private onMove(event: PointerEvent): void {
    const { view } = this.bench;
    const before = this.held.get(event.pointerId);
    view.pointer = view.camera.toWorld(event.offsetX, event.offsetY);
    if (view.look.circles) view.refresh();
    if (before === undefined) {
      this.tool.hover?.(this.press(event));
      view.canvas.style.cursor = this.endAt(event.offsetX, event.offsetY) === null ? this.tool.cursor : 'move';
      return;
    }
    const now = { x: event.offsetX, y: event.offsetY };
    if (this.held.size > 1) this.pinch(event.pointerId, before, now);
    else if (this.pans) this.pan(before, now);
    else if (this.end !== null) this.moveEnd(this.end, this.press(event).at);
    else if (this.isPressed) this.tool.move(this.press(event));
    this.held.set(event.pointerId, now);
  }

  private pan(before: XY, now: XY): void {
    this.bench.view.camera.pan(now.x - before.x, now.y - before.y);
    this.bench.view.refresh();
  }

  private pinch(id: number, before: XY, now: XY): void {
    const other = [...this.held].find(([each]) => each !== id)![1];
    const { camera } = this.bench.view;
    const [was, is] = [Math.hypot(before.x - other.x, before.y - other.y), Math.hypot(now.x - other.x, now.y - other.y)];
    camera.pan((now.x - before.x) / 2, (now.y - before.y) / 2);
    if (was > 10 && is > 10) camera.zoom(is / was, (now.x + other.x) / 2, (now.y + other.y) / 2);
    this.bench.view.refresh();
  }

  private onUp(event: PointerEvent): void {
    this.held.delete(event.pointerId);
    if (this.held.size > 0) return;
    const isClick = this.isPressed && this.end === null && event.type === 'pointerup';
    if (isClick) {
      this.isPressed = false;
      this.tool.up(this.press(event));
    } else {
      this.giveUp();
    }
    this.pans = false;
  }

  private onWheel(event: WheelEvent): void {
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === 1 ? 16 : 1);
    const factor = Math.exp(-pixels * (event.ctrlKey ? 0.01 : 0.0016));
    this.bench.view.camera.zoom(factor, event.offsetX, event.offsetY);
    this.bench.view.refresh();
  }
}
