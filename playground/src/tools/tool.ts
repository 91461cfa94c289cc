// What all tools have in common.
import type { XY } from '../engine/protocol';
import type { Session } from '../model/session';
import { distanceTo } from '../model/shape';
import type { View } from '../view/view';

export interface Press {
  /** The position in the world, on the grid if snapping is on. */
  readonly at: XY;
  /** The position in the world, also if snapping is on. */
  readonly exact: XY;
  readonly adds: boolean;
}

/** A tool gets the presses and moves of a mouse, a finger, a pen or the keyboard's cursor. */
export interface Tool {
  readonly id: string;
  readonly label: string;
  readonly key: string;
  readonly hint: string;
  readonly cursor: string;
  down(press: Press): void;
  move(press: Press): void;
  up(press: Press): void;
  /** Moves without a pressed button. */
  hover?(press: Press): void;
  /** Ends a shape of several corners. */
  finish?(): void;
  /** Removes the last corner. Returns whether there was one. */
  stepBack?(): boolean;
  /** Whether a press and a release at one position are one click, as for corners. */
  readonly clicks?: boolean;
  /**
   * Another input has started, such as a second finger: the press must have no effect. Without this function, the page
   * calls `cancel`. Returns whether the press had changed something.
   */
  abandon?(): boolean;
  /** Cancels the shape or change that the tool has begun. Returns whether there was one. */
  cancel(): boolean;
}

/** The objects and functions that tools use. */
export interface Bench {
  readonly session: Session;
  readonly view: View;
  readonly brush: { radius: number };
  /** Tells people something next to the position of their action. */
  note(text: string, at?: XY): void;
  say(text: string): void;
}

/** The largest distance, in units of length, at which the pointer hits an item. */
export function reach({ view }: Bench, pixels = 8): number {
  return pixels / view.camera.scale;
}

/** The item under a position: a point or a wall before a polygon, the newest first. */
export function itemAt(bench: Bench, at: XY, pixels = 8): number | null {
  const { document } = bench.session;
  const near = reach(bench, pixels);
  const candidates = document.find([at.x - near, at.y - near, at.x + near, at.y + near]).reverse();
  let polygon: number | null = null;
  for (const id of candidates) {
    const shape = document.items.get(id)!;
    const distance = distanceTo(shape, at.x, at.y);
    if (shape.kind !== 'polygon' && distance <= near) return id;
    if (shape.kind === 'polygon' && distance === 0) polygon ??= id;
  }
  return polygon;
}
