// Builds the page and connects its pieces.
import type { EngineClient } from '../engine/client';
import { examples } from '../io/shelf';
import { boundsOfChanges, Document } from '../model/document';
import { Session } from '../model/session';
import { EraseTool, PaintTool } from '../tools/brush';
import { BoxTool, ChainTool, PointTool, PolygonTool, WallTool } from '../tools/draw';
import { Keyboard } from '../tools/keyboard';
import { Pointers } from '../tools/pointers';
import { PanTool, Selection, SelectTool } from '../tools/select';
import type { Bench, Tool } from '../tools/tool';
import type { Insets } from '../view/camera';
import { View } from '../view/view';
import { CrowdPanel } from './crowd_panel';
import { h, icon } from './dom';
import { Files } from './files';
import { makeHelp } from './help';
import { InsidePanel } from './inside_panel';
import { adviceFor, Messages } from './messages';
import { PathPanel } from './path_panel';
import { Timeline } from './timeline';
import { Toolbar } from './toolbar';
import { WorldPanel } from './world_panel';

const PHONE = window.matchMedia('(max-width: 760px)');
const LOW = window.matchMedia('(max-height: 599px)');
/** If more items than this have changed, it is faster to draw everything again. */
const MOST_REPAINTS = 200;
/** After so many stops of the engine, one after the other, the page does not start it again. */
const MOST_RESTARTS = 5;

function insets(): Insets {
  return PHONE.matches
    ? { left: 12, right: 12, top: 64, bottom: 176 }
    : { left: LOW.matches ? 116 : 72, right: 360, top: 68, bottom: 94 };
}

function makeTools(bench: Bench): Tool[] {
  const pan = new PanTool(bench);
  return [
    new SelectTool(bench, new PanTool(bench)), pan, new PointTool(bench), new WallTool(bench), new ChainTool(bench),
    new PolygonTool(bench), new BoxTool(bench), new PaintTool(bench), new EraseTool(bench),
  ];
}

export class App {
  readonly session: Session;
  readonly view: View;
  readonly files: Files;
  readonly messages = new Messages();
  private readonly bench: Bench;
  private readonly crowd: CrowdPanel;
  private readonly toolbar: Toolbar;
  private readonly help: HTMLDialogElement;
  private restarts = 0;

  constructor(root: HTMLElement, canvas: HTMLCanvasElement, engine: EngineClient) {
    this.session = new Session(engine, new Document([0, 0, 1, 1], [], 'empty'));
    this.view = new View(canvas, this.session);
    const { session, view, messages } = this;
    messages.view = view;
    this.bench = {
      session, view, brush: { radius: 1 },
      note: (text, at) => messages.note(text, at),
      say: (text) => messages.say(text),
    };
    const tools = makeTools(this.bench);
    const pointers = new Pointers(this.bench, tools[0]!);
    session.interrupt = () => pointers.interrupt();
    this.toolbar = new Toolbar(this.bench, pointers, tools);
    this.help = makeHelp(tools);
    this.files = new Files(session, view, messages, () => this.fit());
    this.crowd = new CrowdPanel(session, view);
    this.connect(engine, pointers);
    new Keyboard(this.bench, pointers, tools, new Selection(this.bench), {
      choose: (tool) => this.toolbar.choose(tool),
      toggleSnap: () => this.toolbar.toggleSnap(),
      changeBrush: (factor) => this.changeBrush(factor),
      fit: () => this.fit(true),
      help: () => this.help.showModal(),
    });
    this.build(root);
    this.toolbar.choose(tools[0]!);
  }

  private build(root: HTMLElement): void {
    const { session, view, files, messages, help, toolbar } = this;
    const world = new WorldPanel(session, this.bench, this.fileButtons());
    const panel = this.panel([
      ['Path', new PathPanel(session, view).element], ['Crowd', this.crowd.element],
      ['Inside', new InsidePanel(session, view).element], ['World', world.element],
    ]);
    root.append(
      this.top(), toolbar.element, panel, new Timeline(session, messages).element, toolbar.hint,
      files.input, files.shelf, files.dropArea, help, ...messages.elements,
    );
  }

  private top(): HTMLElement {
    const { files, help } = this;
    const theme = h('button', { 'aria-label': 'Dark or light', title: 'Dark or light', onclick: () => this.toggleTheme() }, icon('theme', 18));
    return h('header', { className: 'top' },
      h('div', { className: 'brand card' }, icon('brand', 18), h('h1', {}, 'Waywright'), h('span', { className: 'quiet line' }, 'See it work')),
      h('div', { className: 'actions card' },
        h('button', { onclick: () => files.shelf.showModal() }, 'Examples'),
        h('button', { className: 'wide', onclick: () => files.input.click() }, 'Open'),
        h('button', { onclick: () => void files.share() }, 'Share'),
        h('button', { className: 'wide', 'aria-label': 'Keys', onclick: () => help.showModal() }, '?'),
        theme));
  }

  private fileButtons(): HTMLElement {
    const { files } = this;
    const button = (label: string, run: () => void): HTMLElement => h('button', { className: 'plain', onclick: run }, label);
    return h('div', { className: 'row start' },
      button('Open…', () => files.input.click()), button('Save .wws', () => files.saveScript()),
      button('Save SVG', () => void files.saveSvg()), button('Share', () => void files.share()),
      button('Empty world', () => void this.clear()));
  }

  private async clear(): Promise<void> {
    const { session } = this;
    await session.open(new Document([0, 0, 100, 75], [], 'Empty world'), { start: { x: 8, y: 8 }, goal: { x: 92, y: 67 }, radius: 1 });
    this.fit();
  }

  private panel(sections: readonly (readonly [string, HTMLElement])[]): HTMLElement {
    const tabs = h('div', { className: 'tabs', role: 'tablist', 'aria-label': 'Panels' });
    const panel = h('aside', { className: 'panel card', 'aria-label': 'Details' }, tabs);
    const show = (index: number, isClick: boolean): void => {
      const wasShown = !sections[index]![1].hidden;
      panel.classList.toggle('closed', PHONE.matches && ((isClick && wasShown && !panel.classList.contains('closed')) || !isClick));
      sections.forEach(([, section], i) => (section.hidden = i !== index));
      [...tabs.children].forEach((tab, i) => tab.setAttribute('aria-selected', String(i === index)));
    };
    sections.forEach(([name, section], i) => {
      section.setAttribute('role', 'tabpanel');
      tabs.append(h('button', { role: 'tab', onclick: () => show(i, true) }, name));
      panel.append(section);
    });
    show(0, false);
    return panel;
  }

  private connect(engine: EngineClient, pointers: Pointers): void {
    const { session, view, messages } = this;
    engine.onEvent = (event) => {
      if (event.event === 'crowd') this.crowd.onStates(event.states, event.stats);
    };
    engine.onCrash = (message) => void this.recover(message);
    session.onRefusal = ({ code, message }) => {
      if (code !== 'crashed' || this.restarts < 3) messages.note(adviceFor(code, message));
    };
    session.listen((topic) => {
      if (topic === 'document') {
        pointers.giveUp();
        pointers.tool.cancel();
        view.selection.clear();
        view.mesh = null;
        view.bridges = null;
        view.redrawAll();
      } else if (topic === 'items') {
        this.repaintChanges();
      } else if (topic === 'hashes') {
        this.restarts = 0;
      } else if (topic === 'routes' || topic === 'ends') {
        view.refresh();
      }
    });
  }

  /** Draws anew what the last changes have changed, except for what people drag. */
  private repaintChanges(): void {
    const { view, session } = this;
    const changes = session.lastChanges.filter(({ id }) => !view.isLifted(id));
    for (const { id } of changes) if (!session.document.items.has(id)) view.selection.delete(id);
    if (changes.length > MOST_REPAINTS) return view.redrawAll();
    for (const change of changes) {
      for (const box of [boundsOfChanges([{ ...change, after: null }]), boundsOfChanges([{ ...change, before: null }])]) {
        if (box !== null) view.repaint(box);
      }
    }
    view.refresh();
  }

  /** Starts the engine again with the last world of the page. */
  private async recover(message: string): Promise<void> {
    const { session, messages } = this;
    this.crowd.forget();
    session.interrupt();
    if (++this.restarts > MOST_RESTARTS) {
      const advice = session.summary === null ? 'Reload the page.' : 'Save the world as .wws, and reload the page.';
      messages.toast(`The engine stops again and again (${message}). ${advice}`);
      return;
    }
    if (await session.restore()) messages.toast(`The engine stopped (${message}). The page has started it again with the last world: nothing is lost.`);
  }

  private changeBrush(factor: number): void {
    this.bench.brush.radius *= factor;
    this.session.notify('summary');
    this.view.refresh();
  }

  fit(alternates = false): void {
    this.view.fit(insets(), alternates);
  }

  private toggleTheme(): void {
    const root = document.documentElement;
    root.dataset['theme'] = root.dataset['theme'] === 'dark' ? 'light' : 'dark';
    try {
      localStorage.setItem('waywright-theme', root.dataset['theme']);
    } catch {
      // A page without storage forgets the choice.
    }
    this.view.setTheme();
  }

  /** Opens the world of the link, or the first example. */
  async begin(): Promise<void> {
    // If the start fails, the page tries again, and the world of the link waits for that.
    await this.session.engine.start().catch(() => {});
    const isOpen = await this.files.openLink(location.hash);
    if (!isOpen) await this.files.openExample(examples[0]!);
  }
}
