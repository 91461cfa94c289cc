// The list of all keys.
import type { Tool } from '../tools/tool';
import { h, icon } from './dom';

const KEYS: readonly (readonly [string, string])[] = [
  ['Arrows', 'Move the cursor'], ['Shift + arrows', 'Move it far'], ['Space', 'Press, or release'],
  ['Enter', 'End a chain or a polygon'], ['Esc', 'Give up, or select nothing'], ['Delete', 'Remove the selected items'],
  ['Alt + arrows', 'Move the selected items'], ['Ctrl + D', 'Copy the selected items'], ['Ctrl + A', 'Select everything'],
  ['Ctrl + Z', 'Undo'], ['Ctrl + Shift + Z', 'Redo'], ['S', 'Put the start here'], ['T', 'Put the goal here'],
  ['N', 'Snap to a grid'], ['[ and ]', 'Size of the brush'], ['+ and -', 'Zoom'], ['0', 'Show what matters, then everything'], ['?', 'This list'],
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
