// The tools at the left, or at the bottom of a phone.
import type { Pointers } from '../tools/pointers';
import type { Bench, Tool } from '../tools/tool';
import { h, icon } from './dom';

export class Toolbar {
  readonly element = h('nav', { className: 'tools card', 'aria-label': 'Tools' });
  readonly hint = h('div', { className: 'hint' });
  private readonly buttons = new Map<string, HTMLButtonElement>();
  private readonly snap: HTMLButtonElement;
  private readonly bench: Bench;
  private readonly pointers: Pointers;

  constructor(bench: Bench, pointers: Pointers, tools: readonly Tool[]) {
    this.bench = bench;
    this.pointers = pointers;
    for (const tool of tools) {
      if (tool.id === 'point' || tool.id === 'paint') this.element.append(h('hr'));
      const button = h(
        'button',
        { title: `${tool.label} (${tool.key.toUpperCase()}): ${tool.hint}`, 'aria-label': tool.label, 'aria-pressed': 'false' },
        icon(tool.id), h('kbd', {}, tool.key),
      );
      button.addEventListener('click', () => this.choose(tool));
      this.buttons.set(tool.id, button);
      this.element.append(button);
    }
    this.snap = h('button', { title: 'Snap to a grid (N)', 'aria-label': 'Snap to a grid', 'aria-pressed': 'false' }, icon('snap'), h('kbd', {}, 'n'));
    this.snap.addEventListener('click', () => this.toggleSnap());
    this.element.append(h('hr'), this.snap);
  }

  choose(tool: Tool): void {
    const { pointers, bench } = this;
    if (pointers.tool !== tool) {
      pointers.giveUp();
      pointers.tool.cancel();
    }
    pointers.tool = tool;
    bench.view.preview = null;
    bench.view.canvas.style.cursor = tool.cursor;
    for (const [id, button] of this.buttons) button.setAttribute('aria-pressed', String(id === tool.id));
    this.hint.textContent = tool.hint;
    bench.say(`${tool.label}. ${tool.hint}`);
    bench.view.refresh();
  }

  toggleSnap(): void {
    this.pointers.snaps = !this.pointers.snaps;
    this.snap.setAttribute('aria-pressed', String(this.pointers.snaps));
    this.bench.say(this.pointers.snaps ? 'Snapping is on' : 'Snapping is off');
  }
}
