import { type ByteReader, type ByteWriter, damaged } from './byte_stream';
import { makeItem, ringsOf } from './items';
import {
  ALGORITHMS, type Algorithm, CornerCount, type FillRule, InputError, isInRange, type Item, type ItemId, type ItemKind,
  type Operation, rangeError, type XY,
} from './types';

// The number of a kind in a link is its index here. Never change the order; append.
const OPERATION_KINDS: readonly Operation['kind'][] = [
  'insert', 'remove', 'replace', 'mark', 'rewind', 'tick', 'locate', 'ray', 'disc', 'nearest', 'path', 'clear', 'check',
  'hash',
];
const ITEM_KINDS: readonly ItemKind[] = ['point', 'segment', 'polyline', 'polygon'];
const NONZERO = 4; // a polygon with the fill rule nonzero

const toBig = (id: ItemId): bigint => BigInt(id);
const toId = (id: bigint): ItemId => (id <= BigInt(Number.MAX_SAFE_INTEGER) ? Number(id) : id);

/** Writes operations into three streams: whole numbers, coordinates, and other numbers. */
export class OperationWriter {
  readonly coordinates: number[] = [];
  readonly numbers: number[] = [];
  private readonly codes: ByteWriter;
  private readonly corners = new CornerCount();
  private nextId = 1n;

  constructor(codes: ByteWriter) {
    this.codes = codes;
  }

  point([x, y]: XY): void {
    for (const value of [x, y]) if (!isInRange(value)) throw rangeError(String(value), {});
    this.coordinates.push(x, y);
  }

  /** Writes a number that is not a coordinate. */
  number(value: number): void {
    if (Number.isNaN(value)) throw new InputError('a number of the state is NaN', {}, 'Correct the radius or the view');
    this.numbers.push(value);
  }

  flag(value: boolean): void {
    this.codes.byte(value ? 1 : 0);
  }

  /** Writes whether there is a value, and the value. */
  optional<T>(value: T | null | undefined, write: (value: T) => void): void {
    this.flag(value !== null && value !== undefined);
    if (value !== null && value !== undefined) write(value);
  }

  algorithm(algorithm: Algorithm): void {
    const index = ALGORITHMS.indexOf(algorithm);
    if (index < 0) throw new InputError(`'${algorithm}' is no algorithm`, {}, `Use one of ${ALGORITHMS.join(', ')}`);
    this.codes.byte(index);
  }

  operation(operation: Operation): void {
    this.codes.byte(OPERATION_KINDS.indexOf(operation.kind));
    switch (operation.kind) {
      case 'insert':
      case 'replace':
        this.id(operation.id);
        return this.item(operation.item);
      case 'remove':
        return this.id(operation.id);
      case 'mark':
      case 'rewind':
        return this.codes.whole(operation.tick);
      case 'tick':
        this.codes.whole(operation.tick);
        return this.optional(operation.hash, (hash) => this.hash(hash));
      case 'check':
      case 'hash':
        return;
      default:
        return this.query(operation);
    }
  }

  private query(query: Extract<Operation, { kind: 'locate' | 'ray' | 'disc' | 'nearest' | 'path' | 'clear' }>): void {
    if (query.kind === 'clear') return this.points(query.points);
    if (query.kind === 'ray' || query.kind === 'path') {
      this.point(query.from);
      this.point(query.to);
    } else {
      this.point(query.at);
    }
    if (query.kind === 'ray') return this.optional(query.radius, (radius) => this.number(radius));
    if (query.kind === 'locate') return;
    this.number(query.radius);
    if (query.kind === 'nearest') this.optional(query.goal, (goal) => this.point(goal));
    if (query.kind !== 'path') return;
    this.optional(query.algorithm, (algorithm) => this.algorithm(algorithm));
    this.optional(query.tolerance, (tolerance) => this.number(tolerance));
  }

  /** Writes the difference to the id that is most likely: the one after the last. */
  private id(id: ItemId): void {
    const difference = toBig(id) - this.nextId;
    this.codes.whole(difference < 0n ? -2n * difference - 1n : 2n * difference);
    this.nextId = toBig(id) + 1n;
  }

  private hash(hash: string): void {
    if (!/^[0-9a-f]{32}$/.test(hash)) throw new InputError(`'${hash}' is no hash`, {}, 'A hash has 32 hexadecimal digits');
    for (let i = 0; i < 32; i += 2) this.codes.byte(Number.parseInt(hash.slice(i, i + 2), 16));
  }

  private item(item: Item): void {
    const isNonzero = item.kind === 'polygon' && item.fill === 'nonzero';
    this.codes.byte(isNonzero ? NONZERO : ITEM_KINDS.indexOf(item.kind));
    const rings = ringsOf(item);
    if (item.kind === 'polygon') this.codes.whole(rings.length);
    for (const ring of rings) {
      if (item.kind === 'polygon' || item.kind === 'polyline') this.codes.whole(ring.length);
      ring.forEach((corner) => this.corner(corner));
    }
  }

  private points(points: readonly XY[]): void {
    this.codes.whole(points.length);
    points.forEach((point) => this.corner(point));
  }

  private corner(corner: XY): void {
    this.corners.add(() => ({}));
    this.point(corner);
  }
}

/** Reads what OperationWriter has written. */
export class OperationReader {
  private readonly codes: ByteReader;
  private readonly coordinates: readonly number[];
  private readonly numbers: readonly number[];
  private readonly corners = new CornerCount();
  private usedCoordinates = 0;
  private usedNumbers = 0;
  private nextId = 1n;

  constructor(codes: ByteReader, coordinates: readonly number[], numbers: readonly number[]) {
    this.codes = codes;
    this.coordinates = coordinates;
    this.numbers = numbers;
  }

  get isAtEnd(): boolean {
    const { codes, coordinates, numbers, usedCoordinates, usedNumbers } = this;
    return codes.remaining === 0 && usedCoordinates === coordinates.length && usedNumbers === numbers.length;
  }

  private coordinate(): number {
    const value = this.coordinates[this.usedCoordinates++];
    if (value === undefined) throw damaged('it lacks coordinates');
    if (!isInRange(value)) throw rangeError(String(value), {});
    return value;
  }

  point(): XY {
    return [this.coordinate(), this.coordinate()];
  }

  number(): number {
    const value = this.numbers[this.usedNumbers++];
    if (value === undefined || Number.isNaN(value)) throw damaged('it lacks a number');
    return value;
  }

  flag(): boolean {
    return this.oneOf([false, true]);
  }

  optional<T>(read: () => T): T | undefined {
    return this.flag() ? read() : undefined;
  }

  private oneOf<T>(values: readonly T[]): T {
    const index = this.codes.byte();
    const value = values[index];
    if (value === undefined) throw damaged(`it has the unknown code ${index}`);
    return value;
  }

  algorithm(): Algorithm {
    return this.oneOf(ALGORITHMS);
  }

  operation(): Operation {
    const kind = this.oneOf(OPERATION_KINDS);
    switch (kind) {
      case 'insert':
      case 'replace':
        return { kind, id: this.id(), item: this.item() };
      case 'remove':
        return { kind, id: this.id() };
      case 'mark':
      case 'rewind':
        return { kind, tick: this.codes.whole() };
      case 'tick': {
        const tick = this.codes.id();
        const hash = this.optional(() => this.hash());
        return { kind, tick, ...(hash !== undefined && { hash }) };
      }
      case 'check':
      case 'hash':
        return { kind };
      default:
        return this.query(kind);
    }
  }

  private query(kind: 'locate' | 'ray' | 'disc' | 'nearest' | 'path' | 'clear'): Operation {
    if (kind === 'clear') return { kind, points: this.points() };
    const at = this.point();
    if (kind === 'locate') return { kind, at };
    if (kind === 'disc') return { kind, at, radius: this.number() };
    if (kind === 'nearest') {
      const radius = this.number();
      const goal = this.optional(() => this.point());
      return { kind, at, radius, ...(goal !== undefined && { goal }) };
    }
    const ends = { from: at, to: this.point() };
    if (kind === 'ray') {
      const radius = this.optional(() => this.number());
      return { kind, ...ends, ...(radius !== undefined && { radius }) };
    }
    const radius = this.number();
    const algorithm = this.optional(() => this.algorithm());
    const tolerance = this.optional(() => this.number());
    return {
      kind, ...ends, radius, ...(algorithm !== undefined && { algorithm }), ...(tolerance !== undefined && { tolerance }),
    };
  }

  private id(): ItemId {
    const code = this.codes.bigWhole();
    const difference = code % 2n === 1n ? -(code + 1n) / 2n : code / 2n;
    const id = this.nextId + difference;
    if (id < 1n || id >= 2n ** 63n) throw damaged(`it has the id ${id}`);
    this.nextId = id + 1n;
    return toId(id);
  }

  private hash(): string {
    return Array.from({ length: 16 }, () => this.codes.byte().toString(16).padStart(2, '0')).join('');
  }

  private item(): Item {
    const code = this.codes.byte();
    const fill: FillRule = code === NONZERO ? 'nonzero' : 'even-odd';
    const kind = code === NONZERO ? 'polygon' : ITEM_KINDS[code];
    if (kind === undefined) throw damaged(`it has an item of the unknown kind ${code}`);
    if (kind === 'point') return makeItem(kind, [[this.corner()]]);
    if (kind === 'segment') return makeItem(kind, [[this.corner(), this.corner()]]);
    if (kind === 'polyline') return makeItem(kind, [this.points()]);
    const rings = Array.from({ length: this.codes.count(1) }, () => this.points());
    return makeItem(kind, rings, fill);
  }

  private points(): XY[] {
    const count = this.codes.count(2, this.coordinates.length - this.usedCoordinates);
    return Array.from({ length: count }, () => this.corner());
  }

  private corner(): XY {
    this.corners.add(() => ({}));
    return this.point();
  }
}
