// The worker that reads one file.
import { parseFile } from '../io/formats';
import { openParsed } from './convert';
import type { IdentifiedShape } from './document';
import type { ReadMessage } from './read_file';

declare const self: DedicatedWorkerGlobalScope;

/** A message has about as many numbers, so that the page needs little time for each. */
const NUMBERS_PER_MESSAGE = 50_000;

const send = (message: ReadMessage, transfer: Transferable[] = []): void => self.postMessage(message, transfer);

/** Sends items whose points are in one buffer, which the page gets without a copy. */
function sendItems(items: readonly IdentifiedShape[], count: number): void {
  const numbers = new Float64Array(count);
  let end = 0;
  const packed = items.map(([id, shape]): IdentifiedShape => {
    const first = end;
    numbers.set(shape.points, first);
    end += shape.points.length;
    return [id, { ...shape, points: numbers.subarray(first, end) }];
  });
  send({ kind: 'items', items: packed }, [numbers.buffer]);
}

function sendAllItems(items: Iterable<IdentifiedShape>): void {
  let [piece, count]: [IdentifiedShape[], number] = [[], 0];
  for (const item of items) {
    piece.push(item);
    count += item[1].points.length;
    if (count < NUMBERS_PER_MESSAGE) continue;
    sendItems(piece, count);
    [piece, count] = [[], 0];
  }
  sendItems(piece, count);
}

self.onmessage = ({ data: { name, bytes } }: MessageEvent<{ name: string; bytes: ArrayBuffer }>) => {
  try {
    const { document, ends, refused } = openParsed(parseFile(name, new Uint8Array(bytes)), name);
    const { domain, title, yDown, view, items, log, nextId } = document;
    send({ kind: 'begin', domain, title, options: { yDown, size: items.size, view } });
    sendAllItems(items);
    send({ kind: 'end', log, nextId, ends, refused });
  } catch (reason) {
    send({ kind: 'failure', message: reason instanceof Error ? reason.message : String(reason) });
  }
};
