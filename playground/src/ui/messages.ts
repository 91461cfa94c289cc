// What the page tells people: in place, at the bottom, and to screen readers.
import type { XY } from '../engine/protocol';
import type { View } from '../view/view';
import { h } from './dom';

const TOAST_MILLISECONDS = 6000;
const NOTE_MILLISECONDS = 3500;

export class Messages {
  readonly toasts = h('div', { className: 'toasts' });
  readonly live = h('div', { className: 'hidden', 'aria-live': 'polite', role: 'status' });
  private readonly noteBox = h('div', { className: 'note', hidden: true });
  private noteTimer = 0;
  view: View | null = null;

  get elements(): HTMLElement[] {
    return [this.toasts, this.live, this.noteBox];
  }

  /** Tells screen readers. */
  say(text: string): void {
    this.live.textContent = text;
  }

  /** Shows a message at the bottom. The last three stay. */
  toast(text: string): void {
    this.say(text);
    const box = h('div', { className: 'toast' }, text);
    this.toasts.append(box);
    while (this.toasts.childElementCount > 3) this.toasts.firstElementChild!.remove();
    window.setTimeout(() => box.remove(), TOAST_MILLISECONDS + 30 * text.length);
  }

  /** Explains a refusal next to a position of the world. */
  note(text: string, at?: XY): void {
    const { view, noteBox } = this;
    this.say(text);
    const where = at ?? view?.cursor ?? view?.pointer ?? null;
    if (view === null || where === null) return this.toast(text);
    const { x, y } = view.camera.toScreen(where);
    noteBox.textContent = text;
    noteBox.hidden = false;
    noteBox.style.left = `${Math.max(8, Math.min(x + 16, window.innerWidth - 296))}px`;
    noteBox.style.top = `${Math.max(8, Math.min(y + 16, window.innerHeight - 140))}px`;
    window.clearTimeout(this.noteTimer);
    this.noteTimer = window.setTimeout(() => (noteBox.hidden = true), NOTE_MILLISECONDS + 20 * text.length);
  }
}

/** Says what people can do about a refusal of the engine. */
export function adviceFor(code: string, message: string): string {
  switch (code) {
    case 'out-of-domain':
      return 'This would leave the domain, the outer frame. Nothing has changed. Keep every corner inside the frame.';
    case 'too-many-vertices':
    case 'too-large':
      return `${message}. Nothing has changed. Try a smaller shape, or remove some of what it crosses.`;
    case 'out-of-memory':
      return 'The memory of the page is full. Nothing has changed. Remove some items, or use the native library.';
    case 'coordinate-range':
      return `${message}. Nothing has changed. Coordinates are 0, or from 2^-100 to 2^100 in size.`;
    case 'crashed':
      return 'The engine stopped during this change. The page has restored the world without it.';
    default:
      return `${message}. Nothing has changed.`;
  }
}
