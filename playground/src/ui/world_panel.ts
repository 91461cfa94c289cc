// Facts about the world, and the brush.
import type { Session } from '../model/session';
import type { Bench } from '../tools/tool';
import { bytes, count, h, milliseconds, oncePerFrame, short } from './dom';

const SLIDER_STEPS = 200;

export class WorldPanel {
  readonly element = h('section', { className: 'sheet', 'aria-label': 'World', hidden: true });
  private readonly session: Session;
  private readonly bench: Bench;
  private readonly facts = h('dl');
  private readonly brush = h('input', { type: 'range', min: '1', max: String(SLIDER_STEPS), id: 'brush' });

  constructor(session: Session, bench: Bench, actions: HTMLElement) {
    this.session = session;
    this.bench = bench;
    this.brush.addEventListener('input', () => {
      bench.brush.radius = this.largest * (Number(this.brush.value) / SLIDER_STEPS) ** 2;
    });
    this.element.append(
      this.facts,
      h('div', { className: 'stack' }, h('label', { for: 'brush' }, 'Size of the brush'), this.brush),
      h('div', { className: 'stack' }, h('h2', {}, 'Files'), actions),
      h('p', { className: 'quiet' },
        'Drop a file on the page: .wws, .map of Moving AI, .poly of Triangle, or GeoJSON. Nothing leaves this computer.'),
    );
    const render = oncePerFrame(() => this.render());
    session.listen((topic) => {
      if (topic === 'document') bench.brush.radius = this.largest / 8;
      if (topic === 'summary' || topic === 'document') render();
    });
  }

  private get largest(): number {
    const [x0, y0, x1, y1] = this.session.document.view;
    return Math.min(x1 - x0, y1 - y0) / 6;
  }

  render(): void {
    const { session, bench } = this;
    const { summary, document } = session;
    this.brush.value = String(Math.round(Math.sqrt(bench.brush.radius / this.largest) * SLIDER_STEPS));
    if (summary === null) return;
    const [x0, y0, x1, y1] = document.domain;
    const rows: [string, string][] = [
      ['World', document.title],
      ['Items', count(summary.itemCount)],
      ['Vertices', count(summary.vertexCount)],
      ['Triangles', count(summary.triangleCount)],
      ['Size', `${short(x1 - x0)} × ${short(y1 - y0)}`],
      ['Memory of the module', bytes(summary.memory)],
      ['Last change', milliseconds(summary.milliseconds)],
    ];
    this.facts.replaceChildren(...rows.flatMap(([name, value]) => [h('dt', {}, name), h('dd', {}, value)]));
  }
}
