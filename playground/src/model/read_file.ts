// Reads a file in a worker of its own, so that the page answers while the worker reads.
import type { RefusedLine } from '../io/types';
import type { Opened } from './convert';
import { Document, type Entry, type IdentifiedShape } from './document';
import type { Ends } from './session';
import type { Bounds } from './shape';

/** The messages of the worker: the beginning, the items in pieces, the end; or a failure. */
export type ReadMessage =
  | {
      readonly kind: 'begin';
      readonly domain: Bounds;
      readonly title: string;
      readonly options: { readonly yDown: boolean; readonly size: number; readonly view: Bounds };
    }
  | { readonly kind: 'items'; readonly items: readonly IdentifiedShape[] }
  | {
      readonly kind: 'end';
      readonly log: readonly Entry[];
      readonly nextId: number;
      readonly ends: Ends;
      readonly refused: readonly RefusedLine[];
    }
  | { readonly kind: 'failure'; readonly message: string };

/** Puts a world together from the messages of the worker. */
class Receiver {
  private document: Document | null = null;

  /** Returns the world with the last message, and null before. */
  receive(message: ReadMessage): Opened | null {
    if (message.kind === 'failure') throw new Error(message.message);
    if (message.kind === 'begin') {
      this.document = new Document(message.domain, [], message.title, message.options);
      return null;
    }
    const document = this.document!;
    if (message.kind === 'items') {
      for (const [id, shape] of message.items) document.set(id, shape);
      return null;
    }
    for (const entry of message.log) document.record(entry);
    document.nextId = message.nextId;
    return { document, ends: message.ends, refused: message.refused };
  }
}

/** Rejects with what is wrong if the file cannot be read. The worker takes the bytes. */
export function readFile(name: string, bytes: ArrayBuffer): Promise<Opened> {
  const worker = new Worker(new URL('./read_worker.ts', import.meta.url), { type: 'module' });
  const receiver = new Receiver();
  const reading = new Promise<Opened>((resolve, reject) => {
    worker.onmessage = ({ data }: MessageEvent<ReadMessage>) => {
      try {
        const opened = receiver.receive(data);
        if (opened !== null) resolve(opened);
      } catch (reason) {
        reject(reason);
      }
    };
    worker.onerror = (event) => {
      event.preventDefault();
      reject(new Error(`the file could not be read: ${event.message || 'the worker stopped'}.`));
    };
    worker.postMessage({ name, bytes }, [bytes]);
  });
  return reading.finally(() => worker.terminate());
}
