import { readGeoJson } from './read_geojson';
import { readMap } from './read_map';
import { readNode, readPoly } from './read_poly';
import { readWws } from './read_wws';
import { decodeText, quoted, readNumber, TextReader } from './text';
import { InputError, LARGEST_FILE, type ParsedWorld } from './types';

type Read = (text: string) => ParsedWorld;

const FORMATS = '.wws (world script), .map (Moving AI), .poly and .node (Triangle), and .geojson or .json (GeoJSON)';

const READERS: Readonly<Record<string, Read>> = {
  wws: readWws,
  map: readMap,
  poly: readPoly,
  node: readNode,
  json: readGeoJson,
  geojson: readGeoJson,
};

/** Files that people choose by mistake: their first bytes, what they are, and what to do. */
const OTHER_FILES: readonly (readonly [readonly number[], string, string])[] = [
  [[0x57, 0x57, 0x4f, 0x52, 0x4c, 0x44], 'a saved world (.wwb)', "Convert it with 'waywright convert FILE.wwb FILE.wws'"],
  [[0x1f, 0x8b], 'compressed by gzip', "Unpack it first, for example with 'gunzip'"],
  [[0x50, 0x4b, 3, 4], 'a ZIP archive', 'Unpack it, and choose a file in it'],
  [[0x89, 0x50, 0x4e, 0x47], 'a PNG image', `Choose a file of one of these formats: ${FORMATS}`],
  [[0x25, 0x50, 0x44, 0x46], 'a PDF document', `Choose a file of one of these formats: ${FORMATS}`],
];

function refuseOtherFiles(bytes: Uint8Array): void {
  for (const [start, what, advice] of OTHER_FILES) {
    if (start.every((byte, i) => bytes[i] === byte)) throw new InputError(`the file is ${what}`, { byte: 1 }, advice);
  }
}

/** Throws an InputError for a file that is too small or too large to be read. */
export function refuseSize(size: number): void {
  if (size === 0) throw new InputError('the file is empty', {}, `Choose a file of one of these formats: ${FORMATS}`);
  if (size <= LARGEST_FILE) return;
  const advice = 'Cut it into pieces, or use the native command, which has no such limit';
  throw new InputError(`the file has ${size} bytes, and the largest size is ${LARGEST_FILE}`, {}, advice);
}

function endingOf(name: string): string {
  const dot = name.lastIndexOf('.');
  return dot < 0 ? '' : name.slice(dot + 1).toLowerCase();
}

/** Finds the reader for the first words of a text. Returns null if the words say nothing about the format. */
function readerFor(text: string, ending: string): Read | null {
  const reader = new TextReader(text);
  if (!reader.nextWithWord()) return null;
  const [first, second] = [reader.word(), reader.word()];
  if (first === 'waywright') return readWws;
  if (first === 'type') return readMap;
  if (first.startsWith('{') || first.startsWith('[')) return readGeoJson;
  if (first === 'version' && readNumber(second) !== null) {
    const advice = 'A scenario has only starts and goals; choose the .map that it belongs to';
    throw new InputError("the file is a scenario of Moving AI (.scen)", { line: 1 }, advice);
  }
  if (readNumber(first) === null) return null;
  return ending === 'node' ? readNode : readPoly;
}

/** Refuses a text of which neither the name nor the first words say the format. */
function refuseUnknown(text: string, name: string): never {
  const reader = new TextReader(text);
  const found = reader.nextWithWord() ? quoted(reader.word()) : 'nothing but blanks and comments';
  const what = `the format of ${quoted(name)} is unknown: the text starts with ${found}`;
  throw new InputError(what, reader.where, `Choose a file of one of these formats: ${FORMATS}`);
}

/**
 * Reads a file. Its first words say the format; if they do not, the ending of its name does. Throws an InputError for a
 * file that cannot be read.
 */
export function parseFile(name: string, bytes: Uint8Array): ParsedWorld {
  refuseSize(bytes.length);
  refuseOtherFiles(bytes);
  const text = decodeText(bytes);
  const ending = endingOf(name);
  const byName = Object.hasOwn(READERS, ending) ? READERS[ending]! : null;
  const read = readerFor(text, ending) ?? byName ?? refuseUnknown(text, name);
  return read(text);
}
