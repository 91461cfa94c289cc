// The list of all keys.
import type { Tool } from '../tools/tool';
import { h, icon } from './dom';

const KEYS: readonly (readonly [string, string])[] = [
  ['Arrows', 'move the cursor'], ['Shift + arrows', 'move it far'], ['Space', 'press, or release'],
  ['Enter', 'end a chain or a polygon'], ['Esc', 'give up, or select nothing'], ['Delete', 'remove the selected items'],
  ['Alt + arrows', 'move the selected items'], ['Ctrl + D', 'copy the selected items'], ['Ctrl + A', 'select everything'],
  ['Ctrl + Z', 'undo'], ['Ctrl + Shift + Z', 'redo'], ['S', 'put the start here'], ['T', 'put the goal here'],
  ['N', 'snap to a grid'], ['[ and ]', 'size of the brush'], ['+ and -', 'zoom'], ['0', 'show what matters, then everything'], ['?', 'this list'],
];

export function makeHelp(tools: readonly Tool[]): HTMLDialogElement {
  const dialog = h('dialog', { 'aria-label': 'Keys' });
  const row = ([key, what]: readonly [string, string]): HTMLElement => h('div', {}, h('span', {}, what), h('kbd', {}, key));
  const close = h('button', { 'aria-label': 'Close', onclick: () => dialog.close() }, icon('close', 18));
  const toolRows = tools.map((tool) => row([tool.key.toUpperCase(), tool.label]));
  dialog.append(
    h('header', {}, h('h2', {}, 'Keys'), close),
    h('div', { className: 'body' },
      h('div', { className: 'keys' }, ...toolRows, ...KEYS.map(row)),
      h('p', { className: 'quiet' }, 'With a mouse: the wheel zooms, the right button moves the picture. On a touch screen, use two fingers.')),
  );
  return dialog;
}
