// Carries out what people do: one question to the engine after the other, the newest position of a drag only.
import { type EngineClient, EngineError } from '../engine/client';
import type { EditAnswer, Hashes, RouteAnswer, RouteQuery, WorldSummary, XY } from '../engine/protocol';
import { ALGORITHMS } from '../engine/protocol';
import { type Change, Document, toWire } from './document';
import type { Bounds } from './shape';

export interface Ends {
  start: XY;
  goal: XY;
  radius: number;
}

export interface Wishes {
  compares: boolean;
  widest: boolean;
  channel: boolean;
}

interface Drag {
  readonly changes: readonly Change[];
  readonly done: (isAccepted: boolean) => void;
}

interface Task {
  readonly run: () => Promise<void>;
  readonly done: () => void;
}

/** What has changed, for those who draw it. */
export type Topic = 'document' | 'items' | 'log' | 'routes' | 'ends' | 'summary' | 'hashes' | 'busy' | 'touched';

const IDLE_MILLISECONDS = 140;
/**
 * The hash of the mesh of a large world takes long, and the next change waits for it. So the session waits longer after a
 * change of a larger world before it asks for the hash.
 */
const VERTICES_PER_IDLE_MILLISECOND = 80;
const LONGEST_IDLE_MILLISECONDS = 1500;

export class Session {
  readonly engine: EngineClient;
  document: Document;
  ends: Ends = { start: { x: 0, y: 0 }, goal: { x: 1, y: 1 }, radius: 0 };
  readonly wishes: Wishes = { compares: false, widest: false, channel: false };
  algorithm: (typeof ALGORITHMS)[number] = 'optimal';
  routes: RouteAnswer | null = null;
  summary: WorldSummary | null = null;
  hashes: Hashes | null = null;
  touched: readonly Bounds[] = [];
  editMilliseconds = 0;
  /** The changes of the last notification `items`. They have the shapes before and after. */
  lastChanges: readonly Change[] = [];
  private readonly listeners: ((topic: Topic, box: Bounds | null) => void)[] = [];
  private readonly tasks: Task[] = [];
  private live: Drag | null = null;
  private seekTarget: number | null = null;
  /** Steps forward from there, or from the present position. */
  private seekSteps = 0;
  private wantsRoutes = false;
  private isPumping = false;
  private idleTimer = 0;
  private isDragging = false;
  private ignoresDrags = false;
  /** The start of another engine after a crash. Everything else waits for it. */
  private recovery: Promise<boolean> | null = null;
  /**
   * Called before something else than a drag changes the world: the tool takes back what it has begun. Returns whether it had
   * begun something.
   */
  interrupt: () => boolean = () => false;
  /** Called with what the engine refuses. */
  onRefusal: (error: EngineError) => void = () => {};

  constructor(engine: EngineClient, document: Document) {
    this.engine = engine;
    this.document = document;
  }

  listen(listener: (topic: Topic, box: Bounds | null) => void): void {
    this.listeners.push(listener);
  }
  notify(topic: Topic, box: Bounds | null = null): void {
    for (const listener of this.listeners) listener(topic, box);
  }

  get query(): RouteQuery {
    const { start, goal, radius } = this.ends;
    const compares = this.wishes.compares && !this.isDragging;
    return {
      start, goal, radius,
      algorithms: compares ? ALGORITHMS : [this.algorithm],
      wantsWidest: this.wishes.widest,
      wantsChannel: this.wishes.channel,
      measures: false,
    };
  }

  /** Replaces the world. */
  async open(document: Document, ends: Ends): Promise<void> {
    this.interrupt();
    await this.enqueue(async () => {
      const summary = await this.openInEngine(document);
      this.forgetGestures();
      this.document = document;
      this.hashes = null;
      this.ends = ends;
      this.summary = summary;
      this.routes = null;
      this.notify('document');
      this.notify('summary');
      this.notify('log');
    });
    this.askRoutes();
  }

  /** What people have begun in the old world does not change the new one. */
  private forgetGestures(): void {
    this.ignoresDrags = true;
    this.interrupt();
    this.ignoresDrags = false;
    this.isDragging = false;
    this.live?.done(false);
    this.live = null;
    this.seekTarget = null;
    this.seekSteps = 0;
  }

  private openInEngine(document: Document): Promise<WorldSummary> {
    const items = document.sortedItems();
    const ids = Float64Array.from(items, ([id]) => id);
    return this.engine.ask('open', document.domain, { ids, shapes: items.map(([, shape]) => shape) });
  }

  /** Gives a new engine the world of the page. Returns whether that has succeeded. */
  restore(): Promise<boolean> {
    const recovery = this.startAgain().catch(() => false);
    this.recovery = recovery;
    void recovery.then(() => {
      if (this.recovery === recovery) this.recovery = null;
    });
    return recovery;
  }

  private async startAgain(): Promise<boolean> {
    await this.engine.start();
    this.summary = await this.openInEngine(this.document);
    this.hashes = null;
    this.notify('summary');
    this.askRoutes();
    return true;
  }

  /** The changes from the present shapes, without those that change nothing. */
  private fromPresent(changes: readonly Change[]): Change[] {
    return changes
      .map(({ id, after }) => ({ id, before: this.document.items.get(id) ?? null, after }))
      .filter(({ before, after }) => before !== after);
  }

  /** Makes changes and records them. Returns whether the engine has accepted them. */
  async commit(label: string, changes: readonly Change[]): Promise<boolean> {
    if (changes.length === 0) return true;
    this.interrupt();
    const { document } = this;
    let isAccepted = false;
    await this.enqueue(async () => {
      if (this.document !== document) return;
      const current = this.fromPresent(changes);
      const answer = await this.engine.ask('edit', toWire(current), this.query);
      if (current.length > 0) this.document.record({ label, changes: current });
      this.accept(answer, current);
      this.notify('log');
      isAccepted = true;
    });
    return isAccepted;
  }

  /** Makes changes of a drag. Only the newest ones count; the others resolve to false. */
  drag(changes: readonly Change[]): Promise<boolean> {
    if (this.ignoresDrags) return Promise.resolve(false);
    this.isDragging = true;
    return new Promise((done) => {
      this.live?.done(false);
      this.live = { changes, done };
      void this.pump();
    });
  }

  /** Records the changes of a drag, which the engine has already made: from the first shapes to the last accepted ones. */
  async endDrag(label: string, firsts: readonly Change[]): Promise<void> {
    if (this.ignoresDrags) return;
    const { live: last, document } = this;
    this.live = null;
    await this.enqueue(async () => {
      if (this.document !== document) return last?.done(false);
      if (last !== null) await this.carryOut(last);
      this.isDragging = false;
      const changes = firsts
        .map(({ id, before }) => ({ id, before, after: this.document.items.get(id) ?? null }))
        .filter(({ before, after }) => before !== after);
      if (changes.length > 0) this.document.record({ label, changes });
      this.notify('log');
    });
    this.askRoutes();
  }

  /** Goes to a position in the log. A drag that is under way is taken back. */
  seek(target: number): void {
    this.interrupt();
    this.seekTarget = target;
    this.seekSteps = 0;
    void this.pump();
  }
  /** Takes back a drag that is under way, or else the last step. */
  undo(): void {
    if (this.interrupt()) return;
    --this.seekSteps;
    void this.pump();
  }
  redo(): void {
    if (this.interrupt()) return;
    ++this.seekSteps;
    void this.pump();
  }

  askRoutes(): void {
    this.wantsRoutes = true;
    this.notify('ends');
    void this.pump();
  }

  setDragging(isDragging: boolean): void {
    this.isDragging = isDragging;
  }

  /** Asks the engine after all other questions. */
  async after<T>(ask: () => Promise<T>): Promise<T> {
    let value: T | undefined;
    await this.enqueue(async () => void (value = await ask()));
    return value as T;
  }

  /** Resolves when nothing waits. */
  async settled(): Promise<void> {
    await this.enqueue(async () => {});
    while (this.isPumping) await new Promise((resolve) => setTimeout(resolve, 1));
  }

  private enqueue(run: () => Promise<void>): Promise<void> {
    return new Promise((done) => {
      this.tasks.push({ run, done });
      void this.pump();
    });
  }

  private accept(answer: EditAnswer, changes: readonly Change[]): void {
    this.summary = answer.summary;
    this.editMilliseconds = answer.summary.milliseconds;
    if (answer.routes !== null) this.routes = answer.routes;
    this.touched = answer.touched;
    this.lastChanges = changes;
    for (const { id, after } of changes) this.document.set(id, after);
    this.notify('items');
    this.notify('touched');
    this.notify('summary');
    this.notify('routes');
  }

  private async pump(): Promise<void> {
    if (this.isPumping) return;
    this.isPumping = true;
    window.clearTimeout(this.idleTimer);
    try {
      while (await this.step());
    } finally {
      this.isPumping = false;
      const pause = IDLE_MILLISECONDS + (this.summary?.vertexCount ?? 0) / VERTICES_PER_IDLE_MILLISECOND;
      this.idleTimer = window.setTimeout(() => void this.whenIdle(), Math.min(pause, LONGEST_IDLE_MILLISECONDS));
    }
  }

  /** Does the next piece of work. Returns false if there is none. */
  private async step(): Promise<boolean> {
    while (this.recovery !== null) await this.recovery;
    if (this.tasks.length > 0) await this.stepTask();
    else if (this.live !== null) await this.stepDrag();
    else if (this.seekTarget !== null || this.seekSteps !== 0) await this.stepSeek();
    else if (this.wantsRoutes) await this.stepRoutes();
    else return false;
    return true;
  }

  private async stepDrag(): Promise<void> {
    const drag = this.live!;
    this.live = null;
    await this.carryOut(drag);
  }

  private async carryOut({ changes, done }: Drag): Promise<void> {
    const isAccepted = await this.attempt(async () => {
      const current = this.fromPresent(changes);
      this.accept(await this.engine.ask('edit', toWire(current), this.query), current);
    });
    done(isAccepted);
  }

  private async stepTask(): Promise<void> {
    const task = this.tasks.shift()!;
    await this.attempt(task.run);
    task.done();
  }

  private async stepSeek(): Promise<void> {
    const { log, cursor } = this.document;
    const target = Math.max(0, Math.min(log.length, (this.seekTarget ?? cursor) + this.seekSteps));
    this.seekTarget = null;
    this.seekSteps = 0;
    if (target === cursor) return;
    await this.attempt(async () => {
      const changes = this.document.changesTo(target);
      const answer = await this.engine.ask('edit', toWire(changes), this.query);
      this.document.moveTo(target, changes);
      this.accept(answer, changes);
      this.notify('log');
    });
  }

  private async stepRoutes(): Promise<void> {
    this.wantsRoutes = false;
    await this.attempt(async () => {
      this.routes = await this.engine.ask('routes', this.query);
      this.notify('routes');
    });
  }

  private async attempt(run: () => Promise<void>): Promise<boolean> {
    try {
      await run();
      return true;
    } catch (reason) {
      const error = reason instanceof EngineError
        ? reason
        : new EngineError({ code: 'page', message: String(reason), item: null });
      this.onRefusal(error);
      return false;
    }
  }

  /** Asks for the answers that take longer, when people have made no change for some time. */
  private async whenIdle(): Promise<void> {
    if (this.isPumping || this.summary === null) return;
    if (this.hashes?.version !== this.summary.version) {
      await this.after(async () => {
        this.hashes = await this.engine.ask('hashes');
        this.notify('hashes');
      });
      return;
    }
    this.notify('busy');
  }
}
