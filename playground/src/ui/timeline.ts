// The line at the bottom: time, the two hashes, and the button that validates the world.
import type { Session } from '../model/session';
import { count, h, icon, milliseconds, oncePerFrame } from './dom';
import type { Messages } from './messages';

export class Timeline {
  readonly element = h('footer', { className: 'bottom card' });
  private readonly session: Session;
  private readonly messages: Messages;
  private readonly undo = h('button', { title: 'Undo (Ctrl+Z)', 'aria-label': 'Undo' }, icon('undo', 18));
  private readonly redo = h('button', { title: 'Redo (Ctrl+Shift+Z)', 'aria-label': 'Redo' }, icon('redo', 18));
  private readonly slider = h('input', { type: 'range', min: '0', max: '0', value: '0', 'aria-label': 'Time: steps of this session' });
  private readonly step = h('span', { className: 'step' });
  private readonly items = h('code', { id: 'items-hash' });
  private readonly mesh = h('code', { id: 'mesh-hash' });
  private readonly hashes = h('div', { className: 'hashes stale' });
  private readonly checkButton = h('button', { className: 'plain', id: 'check', title: 'Checks the whole world, exactly' }, 'Check');

  constructor(session: Session, messages: Messages) {
    this.session = session;
    this.messages = messages;
    this.undo.addEventListener('click', () => session.undo());
    this.redo.addEventListener('click', () => session.redo());
    this.slider.addEventListener('input', () => session.seek(Number(this.slider.value)));
    this.checkButton.addEventListener('click', () => void this.check());
    this.hashes.append(
      h('div', { className: 'pair', title: 'The hash of the items' }, h('span', {}, 'items'), this.items),
      h('div', { className: 'pair', title: 'The hash of the mesh' }, h('span', {}, 'mesh'), this.mesh),
      this.checkButton,
    );
    this.element.append(h('div', { className: 'time' }, this.undo, this.redo, this.slider), this.step, this.hashes);
    const render = oncePerFrame(() => this.render());
    session.listen((topic) => {
      if (topic === 'items' || topic === 'document') {
        this.hashes.classList.add('stale');
        this.checkButton.className = 'plain';
        this.checkButton.textContent = 'Check';
      }
      if (topic === 'log' || topic === 'document') render();
      if (topic === 'hashes') this.renderHashes();
    });
  }

  private render(): void {
    const { log, cursor } = this.session.document;
    this.slider.max = String(log.length);
    this.slider.value = String(cursor);
    this.slider.disabled = log.length === 0;
    this.undo.disabled = cursor === 0;
    this.redo.disabled = cursor === log.length;
    const label = cursor === 0 ? this.session.document.title : log[cursor - 1]!.label;
    this.step.textContent = log.length === 0 ? label : `${count(cursor)} of ${count(log.length)}: ${label}`;
    this.slider.setAttribute('aria-valuetext', this.step.textContent);
  }

  private renderHashes(): void {
    const { hashes } = this.session;
    if (hashes === null) return;
    this.hashes.classList.remove('stale');
    for (const [element, text] of [[this.items, hashes.items], [this.mesh, hashes.mesh]] as const) {
      element.textContent = text.slice(0, 10);
      element.title = text;
      element.dataset['hash'] = text;
    }
  }

  private async check(): Promise<void> {
    const { session, messages, checkButton } = this;
    checkButton.textContent = 'Checking…';
    const result = await session.after(() => session.engine.ask('validate'));
    if (result === undefined) return;
    const { isValid, fault } = result;
    checkButton.className = isValid ? 'plain good' : 'plain bad';
    checkButton.textContent = isValid ? '✓ Valid' : 'Fault';
    const items = count(session.summary?.itemCount ?? 0);
    messages.toast(
      isValid
        ? `The world is valid: every triangle, wall and component of ${items} items, checked exactly in ${milliseconds(result.milliseconds)}.`
        : `A fault: ${fault}. Please send the link of this world (Share).`,
    );
  }
}
