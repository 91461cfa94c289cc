// A picture of many things that seldom change. It is drawn in slices, so that no frame takes long.
import type { Bounds } from '../model/shape';
import { overlap } from '../model/shape';
import { Camera } from './camera';

type Context = OffscreenCanvasRenderingContext2D;

/** Draws what overlaps a box. Each `yield` is a position at which the layer may interrupt it. */
export type Painter = (context: Context, camera: Camera, box: Bounds) => Generator<void>;

/** A picture extends beyond the screen on each side, by this share of the screen. */
const MARGIN = 0.25;

interface Picture {
  readonly canvas: OffscreenCanvas;
  readonly context: Context;
  readonly camera: Camera;
}

function makePicture(): Picture {
  const canvas = new OffscreenCanvas(1, 1);
  return { canvas, context: canvas.getContext('2d')!, camera: new Camera() };
}

export class Layer {
  private front = makePicture();
  private back = makePicture();
  private job: Generator<void> | null = null;
  private missed: Bounds[] = [];
  private isEmpty = true;
  private isStale = true;
  private readonly paint: Painter;
  private ratio = 1;

  constructor(paint: Painter) {
    this.paint = paint;
  }

  /** Makes the layer draw everything again. */
  invalidate(): void {
    this.isStale = true;
  }

  /** Draws a box again at once. */
  repaint(box: Bounds): void {
    if (this.isEmpty) return;
    this.paintBox(this.front, box);
    if (this.job !== null) this.missed.push(box);
  }

  private paintBox({ context, camera }: Picture, box: Bounds): void {
    const [ax, bx] = [camera.screenX(box[0]), camera.screenX(box[2])];
    const [ay, by] = [camera.screenY(box[1]), camera.screenY(box[3])];
    const pad = 4;
    const [x, y] = [Math.floor(Math.min(ax, bx)) - pad, Math.floor(Math.min(ay, by)) - pad];
    const [width, height] = [Math.ceil(Math.abs(bx - ax)) + 2 * pad + 1, Math.ceil(Math.abs(by - ay)) + 2 * pad + 1];
    const a = camera.toWorld(x, y);
    const b = camera.toWorld(x + width, y + height);
    const region: Bounds = [Math.min(a.x, b.x), Math.min(a.y, b.y), Math.max(a.x, b.x), Math.max(a.y, b.y)];
    if (!overlap(region, camera.bounds())) return;
    context.save();
    context.beginPath();
    context.rect(x, y, width, height);
    context.clip();
    context.clearRect(x, y, width, height);
    for (const _ of this.paint(context, camera, region));
    context.restore();
  }

  private prepare(picture: Picture, view: Camera): void {
    const { canvas, camera, context } = picture;
    camera.copyFrom(view);
    camera.width = Math.ceil(view.width * (1 + 2 * MARGIN));
    camera.height = Math.ceil(view.height * (1 + 2 * MARGIN));
    const [width, height] = [Math.ceil(camera.width * this.ratio), Math.ceil(camera.height * this.ratio)];
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    context.clearRect(0, 0, camera.width, camera.height);
  }

  /** Whether the picture in front shows what the camera sees, at its scale. */
  private shows({ camera }: Picture, view: Camera): boolean {
    if (camera.scale !== view.scale || camera.yStep !== view.yStep) return false;
    const [x, y] = [Math.abs(camera.x - view.x) * view.scale, Math.abs(camera.y - view.y) * view.scale];
    return x <= (camera.width - view.width) / 2 && y <= (camera.height - view.height) / 2;
  }

  /**
   * Continues to draw, at most until `deadline`. Returns whether the layer is complete. While the camera moves, it draws
   * anew only what it must.
   */
  update(view: Camera, ratio: number, deadline: number): boolean {
    const isFit = !this.isEmpty && this.ratio === ratio && this.shows(this.front, view);
    if (!this.isStale && isFit && this.job === null) return true;
    if (this.isStale || this.job === null || !this.shows(this.back, view)) this.begin(view, ratio);
    const { job } = this;
    while (job !== null) {
      if (job.next().done === true) {
        this.finish();
        return true;
      }
      if (performance.now() >= deadline) return false;
    }
    return true;
  }

  private begin(view: Camera, ratio: number): void {
    this.ratio = ratio;
    this.isStale = false;
    this.missed = [];
    this.prepare(this.back, view);
    this.job = this.paint(this.back.context, this.back.camera, this.back.camera.bounds());
  }

  private finish(): void {
    [this.front, this.back] = [this.back, this.front];
    this.job = null;
    this.isEmpty = false;
    for (const box of this.missed) this.paintBox(this.front, box);
    this.missed = [];
  }

  /** Draws the picture, moved and scaled to the present state of the camera. */
  draw(context: CanvasRenderingContext2D, view: Camera): void {
    if (this.isEmpty) return;
    const { canvas, camera } = this.front;
    const factor = view.scale / camera.scale;
    // At large zooms, the corner of the picture is no double. The distance of the two cameras is exact.
    let x = (camera.x - view.x) * view.scale + (view.width - camera.width * factor) / 2;
    let y = (camera.y - view.y) * view.scale * view.yStep + (view.height - camera.height * factor) / 2;
    if (factor === 1) {
      x = Math.round(x * this.ratio) / this.ratio;
      y = Math.round(y * this.ratio) / this.ratio;
    }
    context.drawImage(canvas, x, y, camera.width * factor, camera.height * factor);
  }
}
