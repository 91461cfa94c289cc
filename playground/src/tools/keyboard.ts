// All tools and commands by keys. On the canvas, the arrow keys move a cursor, and the space bar presses.
import type { XY } from '../engine/protocol';
import type { Pointers } from './pointers';
import type { Selection } from './select';
import type { Bench, Tool } from './tool';

export interface Commands {
  choose(tool: Tool): void;
  toggleSnap(): void;
  changeBrush(factor: number): void;
  fit(): void;
  help(): void;
}

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1],
};

function isTyping(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && target.closest('input, textarea, select, [contenteditable]') !== null;
}

export class Keyboard {
  private readonly bench: Bench;
  private readonly pointers: Pointers;
  private readonly tools: readonly Tool[];
  private readonly selection: Selection;
  private readonly commands: Commands;

  constructor(bench: Bench, pointers: Pointers, tools: readonly Tool[], selection: Selection, commands: Commands) {
    this.bench = bench;
    this.pointers = pointers;
    this.tools = tools;
    this.selection = selection;
    this.commands = commands;
    window.addEventListener('keydown', (event) => this.onKey(event));
  }

  private onKey(event: KeyboardEvent): void {
    const isCommand = event.ctrlKey || event.metaKey;
    if (document.querySelector('dialog[open]') !== null) return;
    const isSlider = event.target instanceof HTMLInputElement && event.target.type !== 'text';
    if (isTyping(event.target) && !(isSlider && (isCommand || /^[a-z]$/i.test(event.key)))) return;
    const isDone = isCommand ? this.onCommand(event) : this.onPlain(event);
    if (isDone) event.preventDefault();
  }

  private onCommand(event: KeyboardEvent): boolean {
    const { session } = this.bench;
    const key = event.key.toLowerCase();
    if (key === 'z' && !event.shiftKey) session.undo();
    else if (key === 'y' || key === 'z') session.redo();
    else if (key === 'd') this.selection.duplicate(this.stepLength());
    else if (key === 'a') this.selectAll();
    else return false;
    return true;
  }

  private selectAll(): void {
    const { session, view } = this.bench;
    for (const id of session.document.items.keys()) view.selection.add(id);
    this.bench.say(`${view.selection.size} items selected`);
    view.refresh();
  }

  private onPlain(event: KeyboardEvent): boolean {
    if (event.key in ARROWS) return this.onArrow(event);
    const isOnCanvas = event.target === this.bench.view.canvas || event.target === document.body;
    switch (event.key) {
      case 'Escape': return this.pointers.tool.cancel();
      case 'Enter': return isOnCanvas && this.finish();
      case ' ': return isOnCanvas && this.press();
      case 'Backspace':
        if (this.pointers.tool.stepBack?.() === true) return true;
        this.selection.remove();
        return true;
      case 'Delete': this.selection.remove(); return true;
      case '+': case '=': return this.zoom(1.25);
      case '-': return this.zoom(0.8);
      case '0': this.commands.fit(); return true;
      case '[': this.commands.changeBrush(0.8); return true;
      case ']': this.commands.changeBrush(1.25); return true;
      case '?': this.commands.help(); return true;
      default: return this.onLetter(event.key.toLowerCase());
    }
  }

  private onLetter(key: string): boolean {
    const tool = this.tools.find((each) => each.key === key);
    if (tool !== undefined) this.commands.choose(tool);
    else if (key === 's') this.pointers.moveEnd('start', this.position());
    else if (key === 't') this.pointers.moveEnd('goal', this.position());
    else if (key === 'n') this.commands.toggleSnap();
    else return false;
    return true;
  }

  /** The position of the cursor, of the pointer, or of the middle of the screen. */
  private position(): XY {
    const { view } = this.bench;
    return view.cursor ?? view.pointer ?? { x: view.camera.x, y: view.camera.y };
  }

  private stepLength(): number {
    return 16 / this.bench.view.camera.scale;
  }

  private onArrow(event: KeyboardEvent): boolean {
    const { view } = this.bench;
    const step = this.stepLength() * (event.shiftKey ? 5 : 1);
    const [dx, dy] = ARROWS[event.key]!;
    const [x, y] = [dx * step, dy * step * view.camera.yStep];
    if (event.altKey) {
      this.selection.nudge(x, y);
      return true;
    }
    const from = this.position();
    view.cursor = { x: from.x + x, y: from.y + y };
    view.pointer = view.cursor;
    this.pointers.moveByKey(view.cursor);
    view.refresh();
    return true;
  }

  /** The first hit of the space bar presses, and the second hit releases. */
  private press(): boolean {
    const { view } = this.bench;
    view.cursor ??= this.position();
    const { tool } = this.pointers;
    const isHeld = this.pointers.pressByKey(view.cursor);
    this.bench.say(isHeld ? `${tool.label}: held; move with the arrow keys, release with the space bar` : tool.label);
    return true;
  }

  private finish(): boolean {
    if (this.pointers.tool.finish === undefined) return this.press();
    this.pointers.tool.finish();
    return true;
  }

  private zoom(factor: number): boolean {
    const { camera } = this.bench.view;
    camera.zoom(factor, camera.width / 2, camera.height / 2);
    this.bench.view.refresh();
    return true;
  }
}
