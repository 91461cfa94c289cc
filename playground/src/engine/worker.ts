// The worker with the engine. It answers one question after the other.
import { WaywrightError } from 'waywright';
import { Engine } from './engine';
import type { EngineEvent, Failure, Request, Response } from './protocol';

declare const self: DedicatedWorkerGlobalScope;

const engine = new Engine((event: EngineEvent, transfer: Transferable[] = []) => self.postMessage(event, transfer));

/** The buffers of the arrays in an answer, which the worker hands over without a copy. */
function buffersOf(value: unknown, found = new Set<ArrayBuffer>()): Set<ArrayBuffer> {
  if (ArrayBuffer.isView(value)) found.add(value.buffer as ArrayBuffer);
  else if (Array.isArray(value)) for (const element of value) buffersOf(element, found);
  else if (typeof value === 'object' && value !== null) for (const member of Object.values(value)) buffersOf(member, found);
  return found;
}

function toFailure(reason: unknown): Failure {
  if (reason instanceof WaywrightError) {
    return { code: reason.code, message: reason.message, item: reason.item === null ? null : Number(reason.item) };
  }
  const { code, message } = reason as { code?: string; message?: string };
  return { code: code ?? 'internal-error', message: message ?? String(reason), item: null };
}

/** Holds a lock as long as the worker lives: the page gets it when the browser has ended the worker. */
function hold(lock: string): Promise<void> {
  return new Promise((resolve) => {
    const held = (): Promise<never> => {
      resolve();
      return new Promise(() => {});
    };
    // Browsers have no locks on pages that are not secure.
    if (navigator.locks === undefined) resolve();
    else navigator.locks.request(lock, held).catch(() => resolve());
  });
}

let beginToAnswer: (loading: Promise<unknown>) => void;
/** All other questions wait until the module is loaded. */
const loaded = new Promise<unknown>((resolve) => (beginToAnswer = resolve));

async function load(module: ArrayBuffer | string, lock: string): Promise<string> {
  await hold(lock);
  return engine.loadModule(module);
}

async function answer({ name, args }: Request): Promise<unknown> {
  if (name === 'load') beginToAnswer(load(args[0] as ArrayBuffer | string, args[1] as string));
  const version = await loaded;
  if (name === 'load') return version;
  return (engine[name] as (...given: readonly unknown[]) => unknown).apply(engine, args as unknown[]);
}

self.onmessage = async ({ data }: MessageEvent<Request>) => {
  let response: Response;
  try {
    response = { seq: data.seq, value: await answer(data) };
  } catch (reason) {
    response = { seq: data.seq, failure: toFailure(reason) };
  }
  const value = 'value' in response ? response.value : null;
  self.postMessage(response, [...buffersOf(value)]);
};
