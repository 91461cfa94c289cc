// Units of five sizes that walk through the world while it changes. Each tick spends a bounded time on searches.
import { Path, type PathAlgorithm, PathWatch, Walkers, type World } from 'waywright';
import type { CrowdOptions, CrowdStats, XY } from './protocol';

const TICK_MILLISECONDS = 1000 / 60;
const SEARCH_BUDGET_MILLISECONDS = 5;
const TRIES = 12;

/** The states of units, as the page draws them. */
export const UNIT = { waiting: 0, walking: 1, stuck: 2 } as const;

/** A queue without repetition. */
class Queue {
  private list: number[] = [];
  private head = 0;
  private readonly members = new Set<number>();

  add(unit: number): void {
    if (this.members.has(unit)) return;
    this.members.add(unit);
    this.list.push(unit);
  }
  take(): number | null {
    const unit = this.list[this.head++];
    if (unit === undefined) {
      this.list = [];
      this.head = 0;
      return null;
    }
    this.members.delete(unit);
    return unit;
  }
  get size(): number {
    return this.members.size;
  }
}

export class Crowd {
  private readonly world: World;
  private readonly algorithm: PathAlgorithm;
  private readonly count: number;
  private readonly sizes: readonly number[];
  private readonly step: number;
  private readonly emit: (states: Float32Array, stats: CrowdStats) => void;
  private readonly walkers: Walkers;
  private readonly watch: PathWatch;
  private readonly paths: Path[] = [];
  private readonly lengths: Float64Array;
  private readonly states: Uint8Array;
  private readonly positions: Float64Array;
  private readonly goals: Float64Array;
  private moved: Float64Array;
  private readonly urgent = new Queue();
  private readonly later = new Queue();
  private readonly retries: { unit: number; tick: number }[] = [];
  private readonly times: number[] = [];
  private ticks = 0;
  private readonly timer: ReturnType<typeof setInterval>;

  constructor(world: World, options: CrowdOptions, emit: (states: Float32Array, stats: CrowdStats) => void) {
    const { count, radii, algorithm, speed } = options;
    this.world = world;
    this.emit = emit;
    this.count = count;
    this.sizes = radii;
    this.algorithm = algorithm;
    this.step = (speed * TICK_MILLISECONDS) / 1000;
    this.walkers = new Walkers(count);
    this.watch = new PathWatch(world);
    this.lengths = new Float64Array(count);
    this.states = new Uint8Array(count);
    this.positions = new Float64Array(2 * count);
    this.goals = new Float64Array(2 * count);
    this.moved = new Float64Array(4 * count);
    for (let unit = 0; unit < count; ++unit) this.place(unit);
    this.timer = setInterval(() => this.tick(), TICK_MILLISECONDS);
  }

  dispose(): void {
    clearInterval(this.timer);
    this.watch.dispose();
    this.walkers.dispose();
    for (const path of this.paths) path.dispose();
  }

  radii(): Float32Array {
    return Float32Array.from({ length: this.count }, (_, unit) => this.radius(unit));
  }

  private radius(unit: number): number {
    return this.sizes[unit % this.sizes.length]!;
  }

  /** A random position where a unit fits. */
  private randomFit(radius: number): XY {
    const { min, max } = this.world.domain;
    for (let i = 0; i < TRIES; ++i) {
      const point = { x: min.x + Math.random() * (max.x - min.x), y: min.y + Math.random() * (max.y - min.y) };
      if (this.world.fitDisc(point, { radius }).fits) return point;
    }
    const middle = { x: (min.x + max.x) / 2, y: (min.y + max.y) / 2 };
    const { isFound, at } = this.world.nearestFit({ point: middle, agent: { radius } });
    return isFound ? at : middle;
  }

  private place(unit: number): void {
    const { x, y } = this.randomFit(this.radius(unit));
    this.positions[2 * unit] = x;
    this.positions[2 * unit + 1] = y;
    this.paths.push(new Path());
    this.chooseGoal(unit);
    this.later.add(unit);
  }

  private chooseGoal(unit: number): void {
    const { x, y } = this.randomFit(this.radius(unit));
    this.goals[2 * unit] = x;
    this.goals[2 * unit + 1] = y;
  }

  /** Finds the path of one unit. */
  private findPath(unit: number): void {
    const path = this.paths[unit]!;
    const radius = this.radius(unit);
    const goal = { x: this.goals[2 * unit]!, y: this.goals[2 * unit + 1]! };
    let start: XY = { x: this.positions[2 * unit]!, y: this.positions[2 * unit + 1]! };
    const ask = (): void => void this.world.findPath({ start, goal, agent: { radius }, algorithm: this.algorithm }, path);
    ask();
    if (path.status === 'start-blocked') {
      const { isFound, at } = this.world.nearestFit({ point: start, agent: { radius } });
      if (isFound) {
        start = at;
        ask();
      }
    }
    if (path.isFound) this.walk(unit, path);
    else this.wait(unit, path.status === 'no-path');
  }

  private walk(unit: number, path: Path): void {
    this.walkers.set(unit, path);
    this.watch.add(unit + 1, path);
    this.lengths[unit] = path.length;
    this.states[unit] = UNIT.walking;
  }

  /** Without a path, a unit chooses another goal after a while. */
  private wait(unit: number, isStuck: boolean): void {
    this.walkers.set(unit, null);
    this.watch.remove(unit + 1);
    this.states[unit] = isStuck ? UNIT.stuck : UNIT.waiting;
    this.chooseGoal(unit);
    this.retries.push({ unit, tick: this.ticks + 30 + (unit % 30) });
  }

  /** Finds the units whose paths the changes of the world may have blocked or made too long. */
  private noteChanges(): void {
    const { blocked, mayBeBlocked, mayBeTooLong } = this.watch.update();
    for (const key of blocked) this.urgent.add(Number(key) - 1);
    for (const key of mayBeBlocked) this.urgent.add(Number(key) - 1);
    for (const key of mayBeTooLong) this.later.add(Number(key) - 1);
    while (this.retries.length > 0 && this.retries[0]!.tick <= this.ticks) this.later.add(this.retries.shift()!.unit);
  }

  /** Searches until the budget of this tick is used. Returns how many searches there were. */
  private searchInBudget(begin: number): number {
    let searches = 0;
    while (performance.now() - begin < SEARCH_BUDGET_MILLISECONDS) {
      const unit = this.urgent.take() ?? this.later.take();
      if (unit === null) break;
      this.findPath(unit);
      ++searches;
    }
    return searches;
  }

  private advance(): void {
    this.moved = this.walkers.advance(this.step, this.moved);
    for (let unit = 0; unit < this.count; ++unit) {
      if (this.states[unit] !== UNIT.walking) continue;
      this.positions[2 * unit] = this.moved[4 * unit]!;
      this.positions[2 * unit + 1] = this.moved[4 * unit + 1]!;
      this.lengths[unit]! -= this.step;
      if (this.lengths[unit]! > 0) continue;
      this.chooseGoal(unit);
      this.states[unit] = UNIT.waiting;
      this.walkers.set(unit, null);
      this.watch.remove(unit + 1);
      this.later.add(unit);
    }
  }

  private tick(): void {
    const begin = performance.now();
    ++this.ticks;
    this.noteChanges();
    const searches = this.searchInBudget(begin);
    const searchMilliseconds = performance.now() - begin;
    this.advance();
    const tickMilliseconds = performance.now() - begin;
    this.times.push(tickMilliseconds);
    if (this.times.length > 240) this.times.shift();
    this.emit(this.packStates(), this.stats(searches, searchMilliseconds, tickMilliseconds));
  }

  /** x, y and the state of each unit. */
  private packStates(): Float32Array {
    const packed = new Float32Array(3 * this.count);
    for (let unit = 0; unit < this.count; ++unit) {
      packed[3 * unit] = this.positions[2 * unit]!;
      packed[3 * unit + 1] = this.positions[2 * unit + 1]!;
      packed[3 * unit + 2] = this.states[unit]!;
    }
    return packed;
  }

  private stats(searches: number, searchMilliseconds: number, tickMilliseconds: number): CrowdStats {
    const sorted = [...this.times].sort((a, b) => a - b);
    const counts = [0, 0, 0];
    for (const state of this.states) ++counts[state]!;
    return {
      units: this.count,
      walking: counts[UNIT.walking]!,
      waiting: this.urgent.size + this.later.size,
      stuck: counts[UNIT.stuck]!,
      searches, searchMilliseconds, tickMilliseconds,
      milliseconds95: sorted[Math.floor(0.95 * (sorted.length - 1))]!,
    };
  }
}
