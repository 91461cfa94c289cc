// What the page shows of the inside: the mesh, circumcircles, components, corridors, bridges, a search step by step.
import { BRIDGE_NUMBERS } from '../engine/protocol';
import type { Session } from '../model/session';
import type { View } from '../view/view';
import { check, count, h, milliseconds } from './dom';
import { FilmPlayer } from './film_player';

const LARGEST_LIVE_MESH = 30_000;

export class InsidePanel {
  readonly element = h('section', { className: 'sheet', 'aria-label': 'Inside', hidden: true });
  private readonly session: Session;
  private readonly view: View;
  private readonly facts = h('p', { className: 'quiet' });
  private readonly legend = h('div', { className: 'legend' });
  private readonly bridgeFacts = h('div', { className: 'legend' });
  private readonly film: FilmPlayer;
  private isAsking = false;
  private isAskingBridges = false;

  constructor(session: Session, view: View) {
    this.session = session;
    this.view = view;
    this.film = new FilmPlayer(session, view);
    this.build();
    session.listen((topic) => {
      if (topic === 'items' || topic === 'document') this.meshChanged();
      if (topic === 'busy' || topic === 'hashes') this.refreshAll();
      if (topic === 'ends' || topic === 'routes') this.renderBridges();
      if (topic === 'touched' && view.look.touched) view.flashTouched();
      if (topic === 'ends' || topic === 'items' || topic === 'document') this.film.stop();
    });
  }

  private build(): void {
    const { view } = this;
    const change = (apply: (isOn: boolean) => void) => (isOn: boolean): void => {
      apply(isOn);
      view.redrawAll();
      this.refreshAll();
      this.renderLegend();
    };
    const faces = (['none', 'components', 'levels'] as const).map((mode) => {
      const input = h('input', { type: 'radio', name: 'faces', checked: mode === 'none' });
      input.addEventListener('change', () => change(() => (view.look.faces = mode))(true));
      const label = { none: 'Plain', components: 'Components', levels: 'Corridors' }[mode];
      return h('label', { className: 'check' }, input, label);
    });
    this.element.append(
      h('div', { className: 'stack' }, h('h2', {}, 'Mesh'),
        check('Triangles', false, change((isOn) => (view.look.mesh = isOn))),
        check('Circumcircle of the face under the pointer', false, change((isOn) => (view.look.circles = isOn))),
        check('What a change has touched', false, change((isOn) => (view.look.touched = isOn)))),
      h('div', { className: 'stack' }, h('h2', {}, 'Faces'), h('div', { className: 'row start' }, ...faces), this.legend),
      this.facts,
      h('div', { className: 'stack' }, h('h2', {}, 'Gaps'),
        check('Bridges', false, change((isOn) => (view.look.bridges = isOn))), this.bridgeFacts),
      this.film.element,
    );
  }

  private get wantsMesh(): boolean {
    const { mesh, circles, faces } = this.view.look;
    return mesh || circles || faces !== 'none';
  }

  private meshChanged(): void {
    const { view, session } = this;
    if (!this.wantsMesh) view.mesh = null;
    if ((session.summary?.triangleCount ?? 0) <= LARGEST_LIVE_MESH) this.refreshAll();
  }

  private refreshAll(): void {
    void this.refreshMesh();
    void this.refreshBridges();
  }

  private async refreshBridges(): Promise<void> {
    const { view, session } = this;
    this.renderBridges();
    if (!view.look.bridges || this.isAskingBridges || session.summary === null) return;
    if (view.bridges?.version === session.summary.version) return;
    this.isAskingBridges = true;
    const bridges = await session.engine.ask('bridges').catch(() => null);
    this.isAskingBridges = false;
    if (bridges === null) return;
    view.setBridges(bridges);
    this.renderBridges();
    if (session.summary.version !== bridges.version) void this.refreshBridges();
  }

  /** Says how many bridges the agent passes. */
  private renderBridges(): void {
    const { look, bridges } = this.view;
    this.bridgeFacts.replaceChildren();
    if (!look.bridges || bridges === null) return;
    let narrow = 0;
    for (let i = BRIDGE_NUMBERS - 1; i < bridges.bridges.length; i += BRIDGE_NUMBERS) {
      if (bridges.bridges[i]! < this.session.ends.radius) ++narrow;
    }
    const total = bridges.bridges.length / BRIDGE_NUMBERS;
    this.bridgeFacts.append(
      this.entry('second', `${count(total - narrow)} that the agent passes`),
      this.entry('failed', `${count(narrow)} that are too narrow`));
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

  private entry(colour: string, text: string): HTMLElement {
    const mark = h('i');
    mark.style.background = `var(--${colour})`;
    return h('span', {}, mark, text);
  }

  private renderLegend(): void {
    const { faces } = this.view.look;
    this.legend.replaceChildren();
    if (faces === 'levels') {
      this.legend.append(
        this.entry('level-1', 'dead end'), this.entry('level-2', 'corridor'), this.entry('level-3', 'junction'));
    } else if (faces === 'components') {
      this.legend.append('Faces of one colour are connected for a point agent.');
    }
  }
}
