// Opens files, examples and links, and saves.
import { refuseSize } from '../io/formats';
import { decodeShare } from '../io/share';
import { examples, type Example } from '../io/shelf';
import type { RefusedLine } from '../io/types';
import { linkOf, type Opened, openParsed, openShared, scriptOf } from '../model/convert';
import { readFile } from '../model/read_file';
import type { Session } from '../model/session';
import type { View } from '../view/view';
import { h, icon } from './dom';
import type { Messages } from './messages';

/** Some mail programs and chats cut links that are longer. */
const LONG_LINK = 30_000;
const LARGEST_LINK = 1_500_000;

export function download(name: string, text: string, type: string): void {
  const url = URL.createObjectURL(new Blob([text], { type }));
  const link = h('a', { href: url, download: name });
  link.click();
  window.setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** Says which lines of a script the page has left out, and why. */
function tellRefused(refused: readonly RefusedLine[]): string {
  const told = refused.slice(0, 3).map(({ line, reason }) => `line ${line}: ${reason}`).join('; ');
  const more = refused.length > 3 ? `; and ${refused.length - 3} more` : '';
  const what = refused.length === 1 ? 'One line was refused, as every world does' : `${refused.length} lines were refused, as every world does`;
  return `${what}: ${told}${more}. Everything else is open.`;
}

export class Files {
  readonly input = h('input', { type: 'file', hidden: true, accept: '.wws,.map,.poly,.node,.json,.geojson', 'aria-label': 'File' });
  readonly shelf = h('dialog', { 'aria-label': 'Examples' });
  /** The names of the examples in links: `#example=NAME`. */
  readonly exampleIds = examples.map(({ id }) => id);
  readonly dropArea = h('div', { className: 'drop', hidden: true }, 'Drop a world here');
  private readonly session: Session;
  private readonly view: View;
  private readonly messages: Messages;
  private readonly fit: () => void;
  /** How many worlds the page was asked to open. Only the last one counts. */
  private requests = 0;

  constructor(session: Session, view: View, messages: Messages, fit: () => void) {
    this.session = session;
    this.view = view;
    this.messages = messages;
    this.fit = fit;
    this.input.addEventListener('change', () => {
      const [file] = this.input.files ?? [];
      if (file !== undefined) void this.openFile(file);
      this.input.value = '';
    });
    this.buildShelf();
    this.listenForDrops();
    window.addEventListener('hashchange', () => void this.openLink(location.hash));
  }

  private buildShelf(): void {
    const close = h('button', { 'aria-label': 'Close', onclick: () => this.shelf.close() }, icon('close', 18));
    const buttons = examples.map((example) => {
      const button = h('button', {}, h('strong', {}, example.title), h('span', {}, example.line));
      button.addEventListener('click', () => {
        this.shelf.close();
        void this.openExample(example);
      });
      return button;
    });
    this.shelf.append(h('header', {}, h('h2', {}, 'Examples'), close), h('div', { className: 'body' }, h('div', { className: 'shelf' }, ...buttons)));
  }

  private listenForDrops(): void {
    const hasFiles = (event: DragEvent): boolean => event.dataTransfer?.types.includes('Files') ?? false;
    window.addEventListener('dragover', (event) => {
      if (!hasFiles(event)) return;
      event.preventDefault();
      this.dropArea.hidden = false;
    });
    window.addEventListener('dragleave', (event) => {
      if (event.relatedTarget === null) this.dropArea.hidden = true;
    });
    window.addEventListener('drop', (event) => {
      event.preventDefault();
      this.dropArea.hidden = true;
      if (event.dataTransfer !== null) this.openDropped(event.dataTransfer);
    });
  }

  private openDropped({ files, items }: DataTransfer): void {
    const [first, ...others] = files;
    if (first === undefined) return;
    if (items[0]?.webkitGetAsEntry()?.isDirectory === true) {
      this.messages.toast(`${first.name} is a folder. Drop a file in it. The world on the page has not changed.`);
      return;
    }
    void this.openFile(first);
    if (others.length === 0) return;
    const names = others.slice(0, 3).map(({ name }) => name).join(', ') + (others.length > 3 ? ', …' : '');
    this.messages.toast(`The page opens one file at a time: ${first.name}. It has not opened ${names}.`);
  }

  /** Opens a world. If it cannot be read or built, the page keeps its world and says why. */
  private async open(name: string, read: () => Opened | Promise<Opened>, after: () => void = this.fit): Promise<boolean> {
    const request = ++this.requests;
    try {
      const { document, ends, refused } = await read();
      if (request !== this.requests) return false;
      await this.session.open(document, ends);
      if (this.session.document !== document) return false;
      after();
      this.messages.say(`${name} is open: ${document.items.size} items`);
      if (refused.length > 0) this.messages.toast(`${name}: ${tellRefused(refused)}`);
      return true;
    } catch (reason) {
      this.messages.toast(`${name}: ${reason instanceof Error ? reason.message : String(reason)} The world on the page has not changed.`);
      return false;
    }
  }

  async openFile(file: File): Promise<boolean> {
    return this.open(file.name, async () => {
      refuseSize(file.size);
      return readFile(file.name, await file.arrayBuffer());
    });
  }

  openExample(example: Example): Promise<boolean> {
    if (location.hash !== '') history.replaceState(null, '', location.pathname + location.search);
    return this.open(example.title, () => openParsed(example.load(), example.title));
  }

  /** Opens the world of a link. Returns false if there is none, or if it is damaged. */
  async openLink(hash: string): Promise<boolean> {
    const text = hash.replace(/^#/, '');
    if (text === '') return false;
    const example = examples.find(({ id }) => `example=${id}` === text);
    if (example !== undefined) return this.open(example.title, () => openParsed(example.load(), example.title));
    if (text.startsWith('example=')) {
      this.messages.toast(`The link: the page has no example with the name '${text.slice(8, 48)}'. Choose one under Examples.`);
      return false;
    }
    const state = await decodeShare(text).catch((reason: Error) => reason);
    if (state instanceof Error) {
      this.messages.toast(`The link: ${state.message}`);
      return false;
    }
    const restoreView = (): void => {
      this.fit();
      if (state.view !== null) this.view.camera.show(state.view);
      this.session.algorithm = state.algorithm;
      this.view.refresh();
    };
    return this.open('The link', () => openShared(state), restoreView);
  }

  async share(): Promise<string | null> {
    const { x, y, scale } = this.view.camera;
    const text = await linkOf(this.session, { x, y, scale }).catch((reason: Error) => reason);
    if (text instanceof Error) {
      this.messages.toast(`The page can make no link: ${text.message} Save the world as .wws, and send the file.`);
      return null;
    }
    if (text.length > LARGEST_LINK) {
      this.messages.toast('This world is too large for a link. Save it as .wws, and send the file.');
      return null;
    }
    const address = new URL(`#${text}`, location.href).href;
    history.replaceState(null, '', address);
    const isCopied = await navigator.clipboard?.writeText(address).then(() => true, () => false);
    const length = text.length > LONG_LINK ? ` It has ${text.length.toLocaleString('en')} characters: some programs cut it.` : '';
    this.messages.toast((isCopied === true ? 'The link is copied. It contains the whole world.' : 'The link is in the address bar.') + length);
    return address;
  }

  saveScript(): void {
    download('world.wws', scriptOf(this.session), 'text/plain');
  }

  async saveSvg(): Promise<void> {
    const isDark = document.documentElement.dataset['theme'] === 'dark';
    const { session } = this;
    const text = await session.after(() => session.engine.ask('svg', session.query, isDark, session.document.yDown));
    if (text !== undefined) download('world.svg', text, 'image/svg+xml');
  }
}
