// What the page shows of the inside: the mesh, circumcircles, components, corridors, a search step by step.
import type { FilmFrame } from '../engine/protocol';
import type { Session } from '../model/session';
import type { View } from '../view/view';
import { check, count, h, milliseconds, short } from './dom';

const LARGEST_LIVE_MESH = 30_000;
const FILM_STEP_MILLISECONDS = 60;
/** The approximate number of steps in which the page shows a whole search. */
const FILM_STEPS = 120;

export class InsidePanel {
  readonly element = h('section', { className: 'sheet', 'aria-label': 'Inside', hidden: true });
  private readonly session: Session;
  private readonly view: View;
  private readonly facts = h('p', { className: 'quiet' });
  private readonly legend = h('div', { className: 'legend' });
  private readonly film = h('dl');
  private readonly play = h('button', { className: 'plain' }, 'Play the search');
  private readonly stepButton = h('button', { className: 'plain' }, 'One step');
  private isAsking = false;
  private timer = 0;
  private hasFilm = false;
  private isStepping = false;

  constructor(session: Session, view: View) {
    this.session = session;
    this.view = view;
    this.build();
    session.listen((topic) => {
      if (topic === 'items' || topic === 'document') this.meshChanged();
      if (topic === 'busy' || topic === 'hashes') void this.refreshMesh();
      if (topic === 'touched' && view.look.touched) view.flashTouched();
      if (topic === 'ends' || topic === 'document') this.stopFilm();
    });
  }

  private build(): void {
    const { view } = this;
    const change = (apply: (isOn: boolean) => void) => (isOn: boolean): void => {
      apply(isOn);
      view.redrawAll();
      void this.refreshMesh();
      this.renderLegend();
    };
    const faces = (['none', 'components', 'levels'] as const).map((mode) => {
      const input = h('input', { type: 'radio', name: 'faces', checked: mode === 'none' });
      input.addEventListener('change', () => change(() => (view.look.faces = mode))(true));
      const label = { none: 'Plain', components: 'Components', levels: 'Corridors' }[mode];
      return h('label', { className: 'check' }, input, label);
    });
    this.play.addEventListener('click', () => this.togglePlay());
    this.stepButton.addEventListener('click', () => void this.filmStep());
    this.element.append(
      h('div', { className: 'stack' }, h('h2', {}, 'Mesh'),
        check('Triangles', false, change((isOn) => (view.look.mesh = isOn))),
        check('Circumcircle of the face under the pointer', false, change((isOn) => (view.look.circles = isOn))),
        check('What a change has touched', false, change((isOn) => (view.look.touched = isOn)))),
      h('div', { className: 'stack' }, h('h2', {}, 'Faces'), h('div', { className: 'row start' }, ...faces), this.legend),
      this.facts,
      h('div', { className: 'stack' }, h('h2', {}, 'A search, step by step'),
        h('div', { className: 'row start' }, this.play, this.stepButton), this.film),
    );
  }

  private get wantsMesh(): boolean {
    const { mesh, circles, faces } = this.view.look;
    return mesh || circles || faces !== 'none';
  }

  private meshChanged(): void {
    const { view, session } = this;
    if (!this.wantsMesh) view.mesh = null;
    else if ((session.summary?.triangleCount ?? 0) <= LARGEST_LIVE_MESH) void this.refreshMesh();
  }

  private async refreshMesh(): Promise<void> {
    const { view, session } = this;
    if (!this.wantsMesh || this.isAsking || session.summary === null) return;
    if (view.mesh?.version === session.summary.version) return;
    this.isAsking = true;
    const begin = performance.now();
    const mesh = await session.engine.ask('mesh').catch(() => null);
    this.isAsking = false;
    if (mesh === null) return;
    view.setMesh(mesh);
    const { vertices, triangles, componentCount } = mesh;
    this.facts.textContent =
      `${count(vertices.length / 2)} vertices, ${count(triangles.length / 3)} triangles, ` +
      `${count(componentCount)} components, copied in ${milliseconds(performance.now() - begin)}.`;
    if (session.summary.version !== mesh.version) void this.refreshMesh();
  }

  private renderLegend(): void {
    const entry = (colour: string, text: string): HTMLElement => {
      const mark = h('i');
      mark.style.background = `var(--${colour})`;
      return h('span', {}, mark, text);
    };
    const { faces } = this.view.look;
    this.legend.replaceChildren();
    if (faces === 'levels') {
      this.legend.append(entry('level-1', 'dead end'), entry('level-2', 'corridor'), entry('level-3', 'junction'));
    } else if (faces === 'components') {
      this.legend.append('Faces of one colour are connected for a point agent.');
    }
  }

  private togglePlay(): void {
    if (this.timer !== 0) {
      window.clearInterval(this.timer);
      this.timer = 0;
      this.play.textContent = 'Play the search';
      return;
    }
    this.play.textContent = 'Pause';
    this.timer = window.setInterval(() => void this.filmStep(), FILM_STEP_MILLISECONDS);
    void this.filmStep();
  }

  private async filmStep(): Promise<void> {
    if (this.isStepping) return;
    this.isStepping = true;
    const { session, view } = this;
    const total = session.routes?.routes[0]?.expansions ?? 0;
    await session.after(async () => {
      if (!this.hasFilm) await session.engine.ask('filmBegin', session.query);
      this.hasFilm = true;
      const frame = await session.engine.ask('filmStep', Math.max(1, Math.round(total / FILM_STEPS)));
      view.film = frame;
      view.refresh();
      this.renderFilm(frame, total);
      if (!frame.isDone) return;
      if (this.timer !== 0) this.togglePlay();
      this.hasFilm = false;
    });
    this.isStepping = false;
  }

  private renderFilm(frame: FilmFrame, total: number): void {
    const rows: [string, string][] = [
      ['Triangles entered', total === 0 ? count(frame.expansions) : `${count(frame.expansions)} of ${count(total)}`],
      [frame.isDone ? 'The path' : 'Best path until now', frame.status === 'found' ? short(frame.length) : 'none'],
    ];
    if (frame.lowerBound > 0) rows.push(['No path is shorter than', short(frame.lowerBound)]);
    const part = total === 0 ? 1 : Math.min(1, frame.expansions / total);
    const bar = h('progress', { max: 1, value: frame.isDone ? 1 : part, 'aria-label': 'Progress of the search' });
    this.film.replaceChildren(...rows.flatMap(([name, value]) => [h('dt', {}, name), h('dd', {}, value)]), bar);
  }

  private stopFilm(): void {
    if (this.timer !== 0) this.togglePlay();
    this.hasFilm = false;
    this.view.film = null;
    this.film.replaceChildren();
  }
}
