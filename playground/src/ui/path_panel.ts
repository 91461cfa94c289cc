// The path: its length, the three algorithms, the radius, and why there is no path.
import { ALGORITHMS, type Gap, type Route, type RouteAnswer } from '../engine/protocol';
import type { Session } from '../model/session';
import { styleOf } from '../view/overlay';
import type { View } from '../view/view';
import { check, h, milliseconds, oncePerFrame, short } from './dom';

const SLIDER_STEPS = 1000;
const MEASURE_DELAY = 250;

const ABOUT: Readonly<Record<Route['algorithm'], string>> = {
  optimal: 'the shortest path, proven',
  ta: 'search over triangles',
  tra: 'search over corridors',
};

export class PathPanel {
  readonly element = h('section', { className: 'sheet', 'aria-label': 'Path' });
  private readonly session: Session;
  private readonly view: View;
  private readonly length = h('div', { className: 'big' });
  private readonly detail = h('div', { className: 'quiet' });
  private readonly why = h('div');
  private readonly slider = h('input', { type: 'range', min: '0', max: String(SLIDER_STEPS), step: '1', id: 'radius' });
  private readonly radiusText = h('input', { type: 'text', inputMode: 'decimal', size: 7, 'aria-label': 'Radius as a number' });
  private readonly radiusError = h('div', { className: 'why', id: 'radius-error', role: 'alert', hidden: true });
  private readonly rows = h('tbody');
  private measured: RouteAnswer | null = null;
  private timer = 0;
  private largest = 1;

  constructor(session: Session, view: View) {
    this.session = session;
    this.view = view;
    this.build();
    const render = oncePerFrame(() => this.render());
    session.listen((topic) => {
      if (topic === 'document') this.resetScale();
      if (topic === 'routes' || topic === 'ends' || topic === 'document') render();
      if (topic === 'routes') this.measureSoon();
    });
  }

  private build(): void {
    const { session, slider, radiusText } = this;
    slider.addEventListener('input', () => this.setRadius(this.fromSlider(Number(slider.value))));
    radiusText.addEventListener('change', () => this.readRadius());
    radiusText.setAttribute('aria-describedby', 'radius-error');
    Object.assign(radiusText.style, { width: '84px', textAlign: 'right', background: 'none', border: '1px solid var(--line)', borderRadius: '8px', padding: '4px 8px' });
    const wish = (name: 'compares' | 'widest' | 'channel') => (isOn: boolean): void => {
      session.wishes[name] = isOn;
      session.askRoutes();
    };
    this.element.append(
      h('div', {}, this.length, this.detail),
      this.why,
      h('div', { className: 'stack' },
        h('div', { className: 'row' }, h('label', { for: 'radius' }, 'Radius of the agent'), radiusText),
        slider, this.radiusError),
      h('table', {}, h('thead', {}, h('tr', {}, h('th', {}, 'Algorithm'), h('th', {}, 'Length'), h('th', {}, 'Time'))), this.rows),
      h('div', { className: 'stack' },
        check('Draw all three', false, wish('compares')),
        check('Widest path', false, wish('widest')),
        check('Triangles on the path (radius 0)', false, wish('channel'))),
      h('p', { className: 'quiet' }, 'Drag the two ends, or drag obstacles: the path follows.'),
    );
  }

  private resetScale(): void {
    const [x0, y0, x1, y1] = this.session.document.view;
    this.largest = Math.min(x1 - x0, y1 - y0) / 8;
    this.measured = null;
  }
  private fromSlider(step: number): number {
    const part = step / SLIDER_STEPS;
    return Number((this.largest * part * part).toPrecision(4));
  }
  private toSlider(radius: number): number {
    return Math.round(Math.sqrt(Math.min(1, radius / this.largest)) * SLIDER_STEPS);
  }

  private readRadius(): void {
    const text = this.radiusText.value.trim();
    const radius = Number(text);
    if (text !== '' && radius >= 0 && Number.isFinite(radius)) return this.setRadius(radius);
    const what = text === '' ? 'The radius is missing' : `'${text.slice(0, 24)}' is no radius`;
    this.radiusError.textContent = `${what}. Type a number from 0 on, such as 1.5. The radius is still ${short(this.session.ends.radius)}.`;
    this.setRefused(true);
  }

  private setRefused(isRefused: boolean): void {
    this.radiusError.hidden = !isRefused;
    this.radiusText.setAttribute('aria-invalid', String(isRefused));
  }

  setRadius(radius: number): void {
    this.setRefused(false);
    this.session.ends.radius = radius;
    this.session.askRoutes();
  }

  /** Measures all three algorithms once people pause. */
  private measureSoon(): void {
    this.measured = null;
    window.clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.measure(), MEASURE_DELAY);
  }

  private async measure(): Promise<void> {
    const { session } = this;
    if (document.hidden || this.view.units !== null) return;
    const query = { ...session.query, algorithms: ALGORITHMS, wantsChannel: false, wantsWidest: false, measures: true };
    const answer = await session.after(() => session.engine.ask('routes', query));
    if (answer === undefined) return;
    this.measured = answer;
    this.render();
  }

  private render(): void {
    const { session, radiusText, slider } = this;
    const { radius } = session.ends;
    if (document.activeElement !== radiusText) radiusText.value = short(radius);
    slider.value = String(this.toSlider(radius));
    slider.setAttribute('aria-valuetext', short(radius));
    this.renderHead();
    this.renderRows();
  }

  private renderHead(): void {
    const { routes } = this.session;
    const route = routes?.routes[0];
    this.why.replaceChildren();
    if (routes === null || route === undefined) {
      this.length.textContent = '…';
      this.detail.textContent = '';
      return;
    }
    const known = this.measured?.routes.find(({ algorithm }) => algorithm === route.algorithm);
    const time = milliseconds((known ?? route).milliseconds);
    if (route.status === 'found') {
      this.length.textContent = short(route.length);
      const kind = routes.radius > 0 ? `for a disc of radius ${short(routes.radius)}` : 'for a point';
      this.detail.textContent = `length of the path ${kind}, found in ${time}`;
      if (this.session.wishes.widest && routes.gap !== null) this.why.append(this.widest(routes.gap));
      return;
    }
    this.length.textContent = 'No path';
    this.detail.textContent = `proven in ${time}`;
    this.why.append(this.whyNot(route, routes));
  }

  private widest(gap: Gap): HTMLElement {
    if (!gap.isLimited) return h('div', { className: 'why fits' }, h('strong', {}, 'No gap limits the agent.'));
    return h('div', { className: 'why fits' },
      h('div', {}, h('strong', {}, `Radius ${short(gap.radius)}`), ' is the largest that gets through. ', this.sides(gap)),
      h('div', { className: 'row start' }, this.radiusButton(gap.radius)));
  }

  private whyNot(route: Route, routes: RouteAnswer): HTMLElement {
    const box = h('div', { className: 'why' });
    if (route.status !== 'no-path') {
      const end = route.status === 'start-blocked' ? 'start' : 'goal';
      const what = routes.blockers.length === 0 ? 'something' : this.names(routes.blockers);
      box.append(h('div', {}, h('strong', {}, `The ${end} is blocked`), ` by ${what}. Drag the ${end} to free ground.`));
      return box;
    }
    const { gap } = routes;
    if (gap === null || !gap.isConnected) {
      box.append(h('div', {}, h('strong', {}, 'Walled in.'), ' No agent of any size gets from the start to the goal.'));
      return box;
    }
    box.append(
      h('div', {}, h('strong', {}, `A gap of ${short(2 * gap.radius)}`), ` is too narrow: this disc needs ${short(2 * routes.radius)}. `, this.sides(gap)),
      h('div', { className: 'row start' }, this.radiusButton(gap.radius), ...this.removeButtons(gap)));
    return box;
  }

  private names(ids: readonly number[]): string {
    return ids.map((id) => (id === 0 ? 'the frame' : `item ${id}`)).join(', ');
  }
  private sides(gap: Gap): string {
    return `The gap lies between ${this.names(gap.fromItems)} and ${this.names(gap.toItems)}.`;
  }

  private radiusButton(radius: number): HTMLButtonElement {
    return h('button', { className: 'plain', onclick: () => this.setRadius(radius) }, `Use radius ${short(radius)}`);
  }

  private removeButtons(gap: Gap): HTMLButtonElement[] {
    const { session } = this;
    const ids = [...new Set([...gap.fromItems, ...gap.toItems])].filter((id) => session.document.items.has(id));
    return ids.slice(0, 2).map((id) => {
      const remove = (): void => {
        const before = session.document.items.get(id);
        if (before !== undefined) void session.commit(`remove ${before.kind}`, [{ id, before, after: null }]);
      };
      return h('button', { className: 'plain', onclick: remove }, `Remove item ${id}`);
    });
  }

  private renderRows(): void {
    const { session, measured } = this;
    const live = session.routes?.routes ?? [];
    const rows = ALGORITHMS.map((algorithm) => {
      const known = measured?.routes.find((route) => route.algorithm === algorithm);
      const route = known ?? live.find((each) => each.algorithm === algorithm);
      const { colour, dash } = styleOf(algorithm, this.view.theme);
      const mark = h('i', { className: 'dash' });
      mark.style.borderTop = `3px ${dash.length === 0 ? 'solid' : dash[0] === 2 ? 'dotted' : 'dashed'} ${colour}`;
      const length = route === undefined ? '' : route.status === 'found' ? short(route.length) : '–';
      const time = known === undefined ? '' : milliseconds(known.milliseconds);
      return h('tr', { className: algorithm === session.algorithm ? 'chosen' : '', title: ABOUT[algorithm] },
        h('td', {}, mark, algorithm), h('td', {}, length), h('td', {}, time));
    });
    this.rows.replaceChildren(...rows);
  }
}
