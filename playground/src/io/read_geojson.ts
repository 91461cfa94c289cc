import { domainAround } from './items';
import { firstSyntaxError } from './json_place';
import { quoted } from './text';
import {
  CornerCount, InputError, isInRange, type Item, type ParsedWorld, rangeError, type Where, type XY,
} from './types';

const DEEPEST = 100;
const ADVICE = 'Geometry must be as RFC 7946 describes it';
const GEOMETRIES = [
  'Point', 'MultiPoint', 'LineString', 'MultiLineString', 'Polygon', 'MultiPolygon', 'GeometryCollection',
];

/** Returns the line and the column of a character. */
function placeOf(text: string, index: number): Where {
  const before = text.slice(0, index);
  const lines = before.split('\n');
  return { line: lines.length, column: lines[lines.length - 1]!.length + 1 };
}

/** Refuses a text whose arrays and objects are nested too deeply, before a parser with a stack reads it. */
function checkDepth(text: string): void {
  let depth = 0;
  for (let i = 0; i < text.length; ++i) {
    const c = text[i];
    if (c === '"') {
      for (++i; i < text.length && text[i] !== '"'; ++i) if (text[i] === '\\') ++i;
    } else if (c === '[' || c === '{') {
      if (++depth > DEEPEST) {
        const advice = `GeoJSON of a map needs no more than about 10 levels; at most ${DEEPEST} are read`;
        throw new InputError(`arrays and objects are nested more than ${DEEPEST} deep`, placeOf(text, i), advice);
      }
    } else if (c === ']' || c === '}') {
      --depth;
    }
  }
}

function parseJson(text: string): unknown {
  checkDepth(text);
  try {
    return JSON.parse(text);
  } catch {
    const index = firstSyntaxError(text);
    const found = index < text.length ? quoted(text.slice(index, index + 20)) : 'the end of the text';
    const advice = 'Look there for a missing bracket, a comma too many, or a word such as NaN that JSON does not have';
    throw new InputError(`the text is not JSON: it is wrong at ${found}`, placeOf(text, index), advice);
  }
}

type Members = Readonly<Record<string, unknown>>;

function nameOf(value: unknown): string {
  if (Array.isArray(value)) return 'an array';
  if (value === undefined) return 'nothing';
  return value !== null && typeof value === 'object' ? 'an object' : quoted(JSON.stringify(value));
}

class GeometryReader {
  readonly items: Item[] = [];
  private readonly count = new CornerCount();

  private fail(expected: string, found: unknown, path: string): never {
    throw new InputError(`expected ${expected}, found ${nameOf(found)}`, { path }, ADVICE);
  }

  private object(value: unknown, expected: string, path: string): Members {
    if (value === null || typeof value !== 'object' || Array.isArray(value)) this.fail(expected, value, path);
    return value as Members;
  }

  private array(value: unknown, expected: string, path: string): readonly unknown[] {
    return Array.isArray(value) ? value : this.fail(expected, value, path);
  }

  /** Reads the object of the file. */
  root(value: unknown): void {
    const object = this.object(value, 'a GeoJSON object', '');
    const { type } = object;
    if (type === 'FeatureCollection') {
      const features = this.array(object['features'], 'an array of features', 'features');
      features.forEach((feature, i) => this.feature(feature, `features[${i}]`));
    } else if (type === 'Feature') {
      this.feature(object, '');
    } else if (type === 'Topology') {
      const advice = 'Convert it to GeoJSON first, for example with mapshaper or topo2geo';
      throw new InputError('the file is TopoJSON', { path: 'type' }, advice);
    } else {
      this.geometry(object, '');
    }
  }

  private feature(value: unknown, path: string): void {
    const feature = this.object(value, 'a feature', path);
    const at = path === '' ? '' : `${path}.`;
    if (feature['type'] !== 'Feature') this.fail("the type 'Feature'", feature['type'], `${at}type`);
    // A feature without a location has the geometry null.
    if (feature['geometry'] !== null) this.geometry(feature['geometry'], `${at}geometry`);
  }

  private geometry(value: unknown, path: string): void {
    const geometry = this.object(value, 'a geometry', path);
    const at = path === '' ? '' : `${path}.`;
    const type = geometry['type'];
    const coordinates = geometry['coordinates'];
    const where = `${at}coordinates`;
    if (type === 'GeometryCollection') {
      const members = this.array(geometry['geometries'], 'an array of geometries', `${at}geometries`);
      members.forEach((member, i) => this.geometry(member, `${at}geometries[${i}]`));
    } else if (type === 'Point') this.point(coordinates, where);
    else if (type === 'LineString') this.line(coordinates, where);
    else if (type === 'Polygon') this.polygon(coordinates, where);
    else if (type === 'MultiPoint') this.each(coordinates, where, (one, its) => this.point(one, its));
    else if (type === 'MultiLineString') this.each(coordinates, where, (one, its) => this.line(one, its));
    else if (type === 'MultiPolygon') this.each(coordinates, where, (one, its) => this.polygon(one, its));
    else this.fail(`a type of GeoJSON (Feature, FeatureCollection, ${GEOMETRIES.join(', ')})`, type, `${at}type`);
  }

  private each(value: unknown, path: string, read: (one: unknown, path: string) => void): void {
    this.array(value, 'an array', path).forEach((one, i) => read(one, `${path}[${i}]`));
  }

  /** Reads a position. Numbers after the first two, as a height, are ignored. */
  private position(value: unknown, path: string): XY {
    const numbers = this.array(value, 'a position [x, y]', path);
    this.count.add(() => ({ path }));
    return [this.coordinate(numbers[0], `${path}[0]`), this.coordinate(numbers[1], `${path}[1]`)];
  }

  private coordinate(value: unknown, path: string): number {
    if (typeof value !== 'number') this.fail('a coordinate', value, path);
    if (!isInRange(value)) throw rangeError(Math.abs(value) > 1 ? 'beyond 2^100' : String(value), { path });
    return value;
  }

  private positions(value: unknown, path: string): XY[] {
    const list = this.array(value, 'an array of positions', path);
    return list.map((position, i) => this.position(position, `${path}[${i}]`));
  }

  // An empty array of coordinates is a geometry without a position: it makes no item.

  private point(value: unknown, path: string): void {
    if (Array.isArray(value) && value.length === 0) return;
    this.items.push({ kind: 'point', xy: this.position(value, path) });
  }

  private line(value: unknown, path: string): void {
    const points = this.positions(value, path);
    if (points.length > 0) this.items.push({ kind: 'polyline', points });
  }

  private polygon(value: unknown, path: string): void {
    const list = this.array(value, 'an array of rings', path);
    const rings = list.map((ring, i) => this.ring(ring, `${path}[${i}]`)).filter((ring) => ring.length > 0);
    if (rings.length > 0) this.items.push({ kind: 'polygon', rings });
  }

  /** Reads a ring without its last position if this is the first one again. */
  private ring(value: unknown, path: string): XY[] {
    const ring = this.positions(value, path);
    const [first, last] = [ring[0], ring[ring.length - 1]];
    if (ring.length > 1 && first![0] === last![0] && first![1] === last![1]) ring.pop();
    return ring;
  }
}

/** Reads GeoJSON. Longitudes and latitudes are taken as x and y. */
export function readGeoJson(text: string): ParsedWorld {
  const reader = new GeometryReader();
  reader.root(parseJson(text));
  if (reader.items.length === 0) {
    throw new InputError('the file has no geometry', {}, 'Choose a file with points, lines or polygons');
  }
  return { items: reader.items, domain: domainAround(reader.items) };
}
