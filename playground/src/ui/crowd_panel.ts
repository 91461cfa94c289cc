// A crowd that walks while people build.
import type { CrowdStats } from '../engine/protocol';
import type { Session } from '../model/session';
import type { View } from '../view/view';
import { bytes, count, h, milliseconds } from './dom';

const SIZES = [1, 1.5, 2.2, 3.2, 4.5];

export class CrowdPanel {
  readonly element = h('section', { className: 'sheet', 'aria-label': 'Crowd', hidden: true });
  private readonly session: Session;
  private readonly view: View;
  private readonly button = h('button', { className: 'main' }, 'Start the crowd');
  private readonly number = h('select', { id: 'units' });
  private readonly facts = h('dl');
  private isRunning = false;
  private wasDrawn = 0;

  constructor(session: Session, view: View) {
    this.session = session;
    this.view = view;
    for (const value of [100, 300, 1000, 2000]) this.number.append(h('option', { value: String(value) }, `${count(value)} units`));
    this.number.value = '1000';
    this.number.addEventListener('change', () => {
      if (this.isRunning) void this.start();
    });
    this.button.addEventListener('click', () => (this.isRunning ? this.stop() : void this.start()));
    this.element.append(
      h('p', {}, 'Units of five sizes walk from goal to goal on one mesh. Build in their way: those whose path is blocked search anew.'),
      h('div', { className: 'row' }, h('label', { className: 'hidden', for: 'units' }, 'Number of units'), this.number, this.button),
      this.facts,
      h('p', { className: 'quiet' }, 'Units do not avoid each other. The searches of a tick have a budget of 5 ms in the worker.'),
    );
    session.listen((topic) => {
      if (topic === 'document') this.forget();
    });
  }

  private async start(): Promise<void> {
    const { session, view } = this;
    const [x0, y0, x1, y1] = session.document.domain;
    const width = Math.max(x1 - x0, y1 - y0);
    const unit = width / 900;
    const options = {
      count: Number(this.number.value), radii: SIZES.map((size) => size * unit),
      algorithm: session.algorithm, speed: width / 24,
    };
    const radii = await session.after(() => session.engine.ask('crowdStart', options));
    if (radii === undefined) return;
    view.units = { radii, states: new Float32Array(0) };
    this.isRunning = true;
    this.button.textContent = 'Stop';
    this.button.className = 'plain';
  }

  private stop(): void {
    void this.session.after(() => this.session.engine.ask('crowdStop'));
    this.forget();
  }

  /** The engine has no crowd any more. */
  forget(): void {
    this.isRunning = false;
    this.view.units = null;
    this.view.refresh();
    this.button.textContent = 'Start the crowd';
    this.button.className = 'main';
    this.facts.replaceChildren();
  }

  onStates(states: Float32Array, stats: CrowdStats): void {
    const { view, session } = this;
    if (!this.isRunning || view.units === null || states.length !== 3 * view.units.radii.length) return;
    view.units.states = states;
    view.refresh();
    if (performance.now() - this.wasDrawn < 200) return;
    this.wasDrawn = performance.now();
    const { summary } = session;
    const rows: [string, string][] = [
      ['Walking', `${count(stats.walking)} of ${count(stats.units)}`],
      ['Waiting for a search', count(stats.waiting)],
      ['Without a path', count(stats.stuck)],
      ['Searches of this tick', `${stats.searches} in ${milliseconds(stats.searchMilliseconds)}`],
      ['Tick', milliseconds(stats.tickMilliseconds)],
      ['Tick, 95th percentile', milliseconds(stats.milliseconds95)],
      ['Last change', milliseconds(session.editMilliseconds)],
      ['Vertices', count(summary?.vertexCount ?? 0)],
      ['Memory', bytes(summary?.memory ?? 0)],
    ];
    this.facts.replaceChildren(...rows.flatMap(([name, value]) => [h('dt', {}, name), h('dd', {}, value)]));
  }
}
