// The transform between a world and the screen, in CSS pixels.
import type { XY } from '../engine/protocol';
import type { Bounds } from '../model/shape';

export interface Insets {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/** The camera shows no more and no less than what a world can contain: coordinates from 2^-100 to 2^100. */
const LEAST_SCALE = 2 ** -110;
const LARGEST_SCALE = 2 ** 110;

export class Camera {
  /** The position in the middle of the screen. */
  x = 0;
  y = 0;
  /** Pixels of one unit of length. */
  scale = 1;
  width = 1;
  height = 1;
  /** 1 if the y axes of the screen and of the world have the same direction, otherwise -1. */
  yStep: 1 | -1 = -1;

  toScreen({ x, y }: XY): XY {
    return { x: this.screenX(x), y: this.screenY(y) };
  }
  screenX(x: number): number {
    return (x - this.x) * this.scale + this.width / 2;
  }
  screenY(y: number): number {
    return (y - this.y) * this.scale * this.yStep + this.height / 2;
  }
  toWorld(x: number, y: number): XY {
    return {
      x: (x - this.width / 2) / this.scale + this.x,
      y: ((y - this.height / 2) / this.scale) * this.yStep + this.y,
    };
  }

  pan(dx: number, dy: number): void {
    this.x -= dx / this.scale;
    this.y -= (dy / this.scale) * this.yStep;
  }

  /** Zooms such that the position under a pixel stays there. */
  zoom(factor: number, x: number, y: number): void {
    const at = this.toWorld(x, y);
    this.scale = Math.min(LARGEST_SCALE, Math.max(LEAST_SCALE, this.scale * factor));
    const moved = this.toWorld(x, y);
    this.x += at.x - moved.x;
    this.y += at.y - moved.y;
  }

  /** Shows a position in the middle, unless no world has it. */
  show({ x, y, scale }: { readonly x: number; readonly y: number; readonly scale: number }): void {
    if (!Number.isFinite(x) || !Number.isFinite(y) || !(scale >= LEAST_SCALE && scale <= LARGEST_SCALE)) return;
    Object.assign(this, { x, y, scale });
  }

  /** Shows a box in the middle of the screen without its insets. */
  fit(box: Bounds, { left, right, top, bottom }: Insets): void {
    const [width, height] = [Math.max(this.width - left - right, 50), Math.max(this.height - top - bottom, 50)];
    this.scale = Math.min(width / (box[2] - box[0]), height / (box[3] - box[1]));
    this.x = (box[0] + box[2]) / 2 + (right - left) / 2 / this.scale;
    this.y = (box[1] + box[3]) / 2 + (((bottom - top) / 2) * this.yStep) / this.scale;
  }

  /** The part of the world on the screen. */
  bounds(margin = 0): Bounds {
    const a = this.toWorld(-margin, -margin);
    const b = this.toWorld(this.width + margin, this.height + margin);
    return [Math.min(a.x, b.x), Math.min(a.y, b.y), Math.max(a.x, b.x), Math.max(a.y, b.y)];
  }

  copyFrom(other: Camera): void {
    const { x, y, scale, width, height, yStep } = other;
    Object.assign(this, { x, y, scale, width, height, yStep });
  }
}
