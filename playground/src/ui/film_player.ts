// Plays a search as a film: one window after the other, forward, backward, or to any step.
import { type Film, type FilmFrame, WINDOW_NUMBERS } from '../engine/protocol';
import type { Session } from '../model/session';
import type { View } from '../view/view';
import { count, h, short } from './dom';

const STEP_MILLISECONDS = 60;
/** About how many pictures a whole film has. */
const PICTURES = 120;

export class FilmPlayer {
  readonly element = h('div', { className: 'stack' }, h('h2', {}, 'A search, step by step'));
  private readonly session: Session;
  private readonly view: View;
  private readonly play = h('button', { className: 'plain' });
  private readonly slider = h('input', { type: 'range', min: '0', max: '0', value: '0', disabled: true, 'aria-label': 'Step of the search' });
  private readonly facts = h('dl');
  private readonly legend = h('div', { className: 'legend' });
  private film: Film | null = null;
  /** The number of steps of the search that the page shows. */
  private at = 0;
  private timer = 0;
  private isAsking = false;

  constructor(session: Session, view: View) {
    this.session = session;
    this.view = view;
    const step = (direction: number, label: string, symbol: string): HTMLButtonElement =>
      h('button', { className: 'plain', 'aria-label': label, title: label, onclick: () => void this.step(direction) }, symbol);
    const off = h('button', { className: 'plain', onclick: () => this.stop() }, 'Close');
    this.play.addEventListener('click', () => void this.togglePlay());
    this.slider.addEventListener('input', () => {
      this.pause();
      this.show(Number(this.slider.value));
    });
    this.element.append(
      h('div', { className: 'row start' }, this.play, step(-1, 'One step back', '‹'), step(1, 'One step', '›'), off),
      this.slider, this.legend, this.facts);
    this.pause();
  }

  private get total(): number {
    return this.film?.frames.at(-1)?.steps ?? 0;
  }

  /** Asks the engine for the film, if there is none. */
  private async load(): Promise<boolean> {
    if (this.film !== null) return true;
    if (this.isAsking) return false;
    this.isAsking = true;
    const { session } = this;
    const film = await session.after(() => session.engine.ask('film', session.query));
    this.isAsking = false;
    if (film === undefined) return false;
    this.film = film;
    this.at = 0;
    this.slider.max = String(this.total);
    this.slider.disabled = this.total === 0;
    this.legend.replaceChildren(
      film.windows.length > 0
        ? 'The ground that the search has seen. The present window is the thick piece of an edge, seen from its root, the dot.'
        : 'This search has no windows to show. To see windows, set the radius to 0, and put a wall between the two ends.');
    return true;
  }

  private async togglePlay(): Promise<void> {
    if (this.timer !== 0) return this.pause();
    if (!(await this.load()) || this.timer !== 0) return;
    if (this.at >= this.total) this.show(0);
    this.play.textContent = 'Pause';
    this.timer = window.setInterval(() => {
      this.show(this.at + Math.max(1, Math.round(this.total / PICTURES)));
      if (this.at >= this.total) this.pause();
    }, STEP_MILLISECONDS);
  }

  private pause(): void {
    window.clearInterval(this.timer);
    this.timer = 0;
    this.play.textContent = 'Play the search';
  }

  private async step(direction: number): Promise<void> {
    this.pause();
    if (!(await this.load())) return;
    this.show(this.at + direction * (this.film!.windows.length > 0 ? 1 : Math.max(1, Math.round(this.total / PICTURES))));
  }

  /** Shows the search after a number of steps. */
  private show(step: number): void {
    const { film, view } = this;
    if (film === null) return;
    this.at = Math.max(0, Math.min(step, this.total));
    this.slider.value = String(this.at);
    this.slider.setAttribute('aria-valuetext', `${this.at} of ${this.total}`);
    const frame = this.frameAt(film);
    view.film = { frame, windows: film.windows, count: Math.min(this.at, film.windows.length / WINDOW_NUMBERS) };
    view.refresh();
    this.render(film, frame);
  }

  private frameAt({ frames }: Film): FilmFrame {
    const last = frames.at(-1)!;
    if (this.at >= last.steps) return last;
    const before = frames.filter((frame) => !frame.isDone && frame.steps <= this.at).at(-1);
    if (before !== undefined) return before;
    const none = new Float64Array(0);
    return { isDone: false, steps: 0, length: 0, lowerBound: 0, status: 'no-path', line: none, channel: none };
  }

  private render({ windows }: Film, frame: FilmFrame): void {
    const rows: [string, string][] = [
      [windows.length > 0 ? 'Windows followed' : 'Steps made', `${count(this.at)} of ${count(this.total)}`],
      [frame.isDone ? 'The path' : 'Best path until now', frame.status === 'found' ? short(frame.length) : 'none'],
    ];
    if (windows.length > 0 && this.at > 0) {
      const numbers = windows.subarray(WINDOW_NUMBERS * (this.at - 1), WINDOW_NUMBERS * this.at);
      rows.push(['Length to the root', short(numbers[10]!)], ['No path here is shorter than', short(numbers[11]!)]);
    } else if (frame.lowerBound > 0) {
      rows.push(['No path is shorter than', short(frame.lowerBound)]);
    }
    this.facts.replaceChildren(...rows.flatMap(([name, value]) => [h('dt', {}, name), h('dd', {}, value)]));
  }

  /** Forgets the film: the world or the query has changed. */
  stop(): void {
    this.pause();
    this.film = null;
    this.at = 0;
    this.slider.value = this.slider.max = '0';
    this.slider.disabled = true;
    this.facts.replaceChildren();
    this.legend.replaceChildren();
    this.view.film = null;
    this.view.refresh();
  }
}
