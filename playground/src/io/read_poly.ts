import { domainAround } from './items';
import { quoted, readNumber, readWhole, TextReader } from './text';
import {
  CornerCount, InputError, isInRange, type Item, type ParsedWorld, rangeError, type Where, type XY,
} from './types';

const ADVICE = 'See https://www.cs.cmu.edu/~quake/triangle.poly.html for the format of .poly';

/** The vertices of a file. Their ids are firstId, firstId + 1, ... */
interface VertexList {
  firstId: number;
  readonly points: XY[];
}

/** Reads the sections of one file. */
class SectionReader {
  private readonly reader: TextReader;
  private readonly count = new CornerCount();

  constructor(text: string) {
    this.reader = new TextReader(text);
  }

  private get where(): Where {
    return this.reader.where;
  }

  private fail(expected: string, found: string, advice = ADVICE): never {
    throw new InputError(`expected ${expected}, found ${found}`, this.where, advice);
  }

  private word(expected: string): string {
    const word = this.reader.word();
    return word === '' ? this.fail(expected, 'the end of the line') : word;
  }

  private integer(expected: string): number {
    const word = this.word(expected);
    const value = readWhole(word);
    return typeof value === 'number' ? value : this.fail(expected, quoted(word));
  }

  /** Reads an integer that may be missing at the end of the line; it is then `otherwise`. */
  private optional(expected: string, otherwise: number): number {
    return this.reader.atEnd ? otherwise : this.integer(expected);
  }

  private coordinate(): number {
    const word = this.word('a coordinate');
    const value = readNumber(word);
    if (value === null) this.fail('a coordinate', quoted(word));
    if (!isInRange(value)) throw rangeError(quoted(word), this.where);
    return value;
  }

  /** Reads numbers, checks them and drops them. */
  private numbers(expected: string, count: number): void {
    for (let i = 0; i < count; ++i) {
      const word = this.word(expected);
      if (readNumber(word) === null) this.fail(expected, quoted(word));
    }
  }

  private endOfLine(): void {
    if (!this.reader.atEnd) this.fail('the end of the line', quoted(this.reader.word()));
  }

  /** Moves to the first line of a section, and reads the number of its entries. */
  private section(counted: string): number {
    if (!this.reader.nextWithWord()) this.fail(`the number of ${counted}`, 'the end of the text');
    return this.integer(`the number of ${counted}`);
  }

  /** Moves to the line of an entry, and reads its id. It must be one more than the last id. The first one is 0 or 1. */
  private entry(kind: string, index: number, firstId: number): number {
    const expected = `${kind} ${index === 0 ? '0 or 1' : firstId + index}`;
    if (!this.reader.nextWithWord()) this.fail(expected, 'the end of the text');
    const id = this.integer(expected);
    const first = index === 0 ? Math.min(id, 1) : firstId;
    return id === first + index ? first : this.fail(expected, String(id));
  }

  vertices(): VertexList {
    const list: VertexList = { firstId: 1, points: [] };
    const count = this.section('vertices');
    const dimension = this.optional('dimension 2', 2);
    if (dimension !== 2) this.fail('dimension 2', String(dimension));
    const attributes = this.optional('the number of attributes', 0);
    const markers = this.optional('0 or 1 boundary markers', 0);
    if (markers > 1) this.fail('0 or 1 boundary markers', String(markers));
    this.endOfLine();
    for (let i = 0; i < count; ++i) {
      list.firstId = this.entry('vertex', i, list.firstId);
      this.count.add(() => this.where);
      list.points.push([this.coordinate(), this.coordinate()]);
      this.numbers('an attribute', attributes);
      this.numbers('a boundary marker', markers);
      this.endOfLine();
    }
    return list;
  }

  /** Refuses a `.poly` whose vertices are in another file. */
  refuseMissingVertices(): never {
    const advice = "Put the lines of the .node file in place of the line that counts 0 vertices, or use 'waywright convert'";
    return this.fail('vertices', 'none: they are in the .node file of the same name', advice);
  }

  private end(list: VertexList): number {
    const id = this.integer('the id of a vertex');
    const index = id - list.firstId;
    if (index >= 0 && index < list.points.length) return index;
    return this.fail('the id of a vertex', `${id}, which no vertex has`);
  }

  segments(list: VertexList): [number, number][] {
    const segments: [number, number][] = [];
    const count = this.section('segments');
    const markers = this.optional('0 or 1 boundary markers', 0);
    if (markers > 1) this.fail('0 or 1 boundary markers', String(markers));
    this.endOfLine();
    let firstId = 1;
    for (let i = 0; i < count; ++i) {
      firstId = this.entry('segment', i, firstId);
      this.count.add(() => this.where);
      segments.push([this.end(list), this.end(list)]);
      this.numbers('a boundary marker', markers);
      this.endOfLine();
    }
    return segments;
  }

  holes(): void {
    const count = this.section('holes');
    this.endOfLine();
    let firstId = 1;
    for (let i = 0; i < count; ++i) {
      firstId = this.entry('hole', i, firstId);
      this.numbers('a coordinate', 2);
      this.endOfLine();
    }
  }

  /** Reads the only section that may be missing. */
  regions(): void {
    if (!this.reader.nextWithWord()) return;
    const count = this.integer('the number of regions');
    this.endOfLine();
    let firstId = 1;
    for (let i = 0; i < count; ++i) {
      firstId = this.entry('region', i, firstId);
      this.numbers('a coordinate', 2);
      this.numbers('an attribute', 1);
      if (!this.reader.atEnd) this.numbers('a largest area', 1);
      this.endOfLine();
    }
  }

  endOfText(): void {
    if (this.reader.nextWithWord()) this.fail('the end of the text', 'one more line');
  }
}

function toWorld(list: VertexList, segments: readonly (readonly [number, number])[]): ParsedWorld {
  const onSegment = new Uint8Array(list.points.length);
  for (const ends of segments) for (const end of ends) onSegment[end] = 1;
  const items: Item[] = [];
  list.points.forEach((xy, i) => {
    if (onSegment[i] === 0) items.push({ kind: 'point', xy });
  });
  for (const [a, b] of segments) items.push({ kind: 'segment', points: [list.points[a]!, list.points[b]!] });
  const all: Item[] = list.points.map((xy) => ({ kind: 'point', xy }));
  return { items, domain: domainAround(all) };
}

/** Reads a `.poly` of Triangle. Vertices that are on no segment become points. Holes and regions are only checked. */
export function readPoly(text: string): ParsedWorld {
  const reader = new SectionReader(text);
  const list = reader.vertices();
  if (list.points.length === 0) reader.refuseMissingVertices();
  const segments = reader.segments(list);
  reader.holes();
  reader.regions();
  reader.endOfText();
  return toWorld(list, segments);
}

/** Reads a `.node` of Triangle. */
export function readNode(text: string): ParsedWorld {
  const reader = new SectionReader(text);
  const list = reader.vertices();
  reader.endOfText();
  return toWorld(list, []);
}
