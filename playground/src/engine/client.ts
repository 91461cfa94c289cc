// Sends the questions of the page to the worker. If the module crashes, the client starts another worker and tells the page.
import type { EngineApi, EngineEvent, Failure, Response } from './protocol';

export class EngineError extends Error {
  readonly code: string;
  readonly item: number | null;

  constructor({ code, message, item }: Failure) {
    super(message);
    this.name = 'EngineError';
    this.code = code;
    this.item = item;
  }
}

interface Waiting {
  readonly resolve: (value: unknown) => void;
  readonly reject: (reason: unknown) => void;
}

type Answer<Name extends keyof EngineApi> = ReturnType<EngineApi[Name]>;

let workerCount = 0;

/** Makes workers. The single-file page replaces it. */
export type WorkerFactory = () => Worker;

export class EngineClient {
  private readonly makeWorker: WorkerFactory;
  private readonly module: () => Promise<ArrayBuffer | string>;
  private worker: Worker | null = null;
  private waiting = new Map<number, Waiting>();
  private last = 0;
  /** The client calls it for each message of the worker that is no answer. */
  onEvent: (event: EngineEvent) => void = () => {};
  /** The client calls it after a crash. The new worker has no world. */
  onCrash: (message: string) => void = () => {};

  constructor(makeWorker: WorkerFactory, module: () => Promise<ArrayBuffer | string>) {
    this.makeWorker = makeWorker;
    this.module = module;
  }

  /** Starts the worker and loads the module. Returns the version of the library. */
  async start(): Promise<string> {
    const worker = this.makeWorker();
    this.worker = worker;
    worker.onmessage = ({ data }: MessageEvent<Response | EngineEvent>) => {
      if ('event' in data) this.onEvent(data);
      else this.settle(data);
    };
    worker.onerror = (event) => {
      event.preventDefault();
      if (this.worker === worker) this.crashed(event.message || 'the worker stopped');
    };
    const lock = `waywright-engine-${Date.now()}-${Math.random()}-${++workerCount}`;
    const version = await this.ask('load', await this.module(), lock);
    this.watch(worker, lock);
    return version;
  }

  /** Notices that the browser has ended the worker, for example because memory is short. No event says so. */
  private watch(worker: Worker, lock: string): void {
    navigator.locks?.request(lock, () => {
      if (this.worker === worker) this.crashed('the browser has ended its worker');
    }).catch(() => {
      // Without the lock, the page does not notice.
    });
  }

  ask<Name extends keyof EngineApi>(name: Name, ...args: Parameters<EngineApi[Name]>): Promise<Answer<Name>> {
    const seq = ++this.last;
    const { worker } = this;
    if (worker === null) return Promise.reject(new EngineError({ code: 'stopped', message: 'there is no engine', item: null }));
    return new Promise<unknown>((resolve, reject) => {
      this.waiting.set(seq, { resolve, reject });
      worker.postMessage({ seq, name, args });
    }) as Promise<Answer<Name>>;
  }

  private settle(response: Response): void {
    const waiting = this.waiting.get(response.seq);
    this.waiting.delete(response.seq);
    if (waiting === undefined) return;
    if ('value' in response) {
      waiting.resolve(response.value);
      return;
    }
    waiting.reject(new EngineError(response.failure));
    if (response.failure.code === 'internal-error') this.crashed(response.failure.message);
  }

  private crashed(message: string): void {
    this.worker?.terminate();
    this.worker = null;
    const lost = [...this.waiting.values()];
    this.waiting = new Map();
    for (const { reject } of lost) reject(new EngineError({ code: 'crashed', message, item: null }));
    this.onCrash(message);
  }
}
