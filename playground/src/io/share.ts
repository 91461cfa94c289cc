import { ByteReader, ByteWriter, damaged } from './byte_stream';
import { readNumbers, writeNumbers } from './number_lists';
import { OperationReader, OperationWriter } from './operation_bytes';
import {
  type Algorithm, type Domain, InputError, LARGEST_FILE, LARGEST_OPERATION_COUNT, type Operation, type XY,
} from './types';

// A link is the base64url text of these bytes:
//   1 byte: the version of the format
//   8 bytes: two checksums of the compressed bytes, CRC-32 and CRC-32C, the lowest byte first
//   the rest: the state, compressed by deflate
// The state consists of the number of bytes of the codes, the codes, the coordinates and the other numbers.
const VERSION = 1;
const HEADER_SIZE = 9;
const LARGEST_LINK = 20_000_000;
const CRC_32 = 0xedb88320;
const CRC_32C = 0x82f63b78;

/** What the page shows: the point of the world in its middle, and the number of pixels of a unit of the world. */
export interface View {
  readonly x: number;
  readonly y: number;
  readonly scale: number;
}

/** The state of the page that a link recreates. */
export interface ShareState {
  readonly domain: Domain;
  /** Whether the y axis points down, as in a map of Moving AI. */
  readonly yDown?: boolean;
  /** All changes since the world was empty. They recreate the items, their ids and the next id. */
  readonly operations: readonly Operation[];
  readonly start: XY | null;
  readonly goal: XY | null;
  readonly radius: number;
  readonly algorithm: Algorithm;
  readonly view: View | null;
}

const tables = new Map<number, Uint32Array>();

/** Returns the table of a CRC with a reversed polynomial: the remainder of each byte. */
function tableOf(polynomial: number): Uint32Array {
  const known = tables.get(polynomial);
  if (known) return known;
  const table = Uint32Array.from({ length: 256 }, (_, byte) => {
    let rest = byte;
    for (let bit = 0; bit < 8; ++bit) rest = rest & 1 ? (rest >>> 1) ^ polynomial : rest >>> 1;
    return rest;
  });
  tables.set(polynomial, table);
  return table;
}

function checksum(bytes: Uint8Array, polynomial: number): number {
  const table = tableOf(polynomial);
  let rest = 0xffffffff;
  for (const byte of bytes) rest = (rest >>> 8) ^ table[(rest ^ byte) & 255]!;
  return ~rest >>> 0;
}

const DIGITS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_';

function toBase64Url(bytes: Uint8Array): string {
  const pieces: string[] = [];
  for (let at = 0; at < bytes.length; at += 3) {
    const [a, b = 0, c = 0] = bytes.subarray(at, at + 3);
    const bits = (a! << 16) | (b << 8) | c;
    const digits = [bits >>> 18, (bits >>> 12) & 63, (bits >>> 6) & 63, bits & 63];
    pieces.push(...digits.slice(0, bytes.length - at + 1).map((digit) => DIGITS[digit]!));
  }
  return pieces.join('');
}

function digitsOf(text: string): Uint8Array {
  const values = new Int8Array(128).fill(-1);
  for (let digit = 0; digit < DIGITS.length; ++digit) values[DIGITS.charCodeAt(digit)] = digit;
  return Uint8Array.from(text, (c, i) => {
    const value = values[c.charCodeAt(0)] ?? -1;
    if (value < 0) throw damaged(`it has the character '${c}', which no link has`, i + 1);
    return value;
  });
}

function fromBase64Url(text: string): Uint8Array {
  const digits = digitsOf(text);
  const bytes = new Uint8Array(Math.floor((digits.length * 6) / 8));
  let [bits, count, at] = [0, 0, 0];
  for (const digit of digits) {
    bits = ((bits << 6) | digit) & 0xffff;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes[at++] = (bits >>> count) & 255;
  }
  if (count === 6 || (bits & ((1 << count) - 1)) !== 0) throw damaged('its last character is wrong or missing', text.length);
  return bytes;
}

/** Sends bytes through a stream, and collects the result. Returns null if it is larger than `limit`. */
async function pipe(
  bytes: Uint8Array,
  stream: CompressionStream | DecompressionStream,
  limit: number,
): Promise<Uint8Array | null> {
  const out = new ByteWriter();
  const reader = new Blob([bytes as Uint8Array<ArrayBuffer>]).stream().pipeThrough(stream).getReader();
  let size = 0;
  for (let chunk = await reader.read(); !chunk.done; chunk = await reader.read()) {
    size += chunk.value.length;
    if (size > limit) {
      await reader.cancel();
      return null;
    }
    out.append(chunk.value);
  }
  return out.result();
}

function writeState(state: ShareState): Uint8Array {
  const codes = new ByteWriter();
  const writer = new OperationWriter(codes);
  const [minX, minY, maxX, maxY] = state.domain;
  writer.point([minX, minY]);
  writer.point([maxX, maxY]);
  writer.flag(state.yDown ?? false);
  writer.optional(state.start, (point) => writer.point(point));
  writer.optional(state.goal, (point) => writer.point(point));
  writer.number(state.radius);
  writer.algorithm(state.algorithm);
  writer.optional(state.view, ({ x, y, scale }) => [x, y, scale].forEach((value) => writer.number(value)));
  codes.whole(state.operations.length);
  for (const operation of state.operations) writer.operation(operation);
  const [out, codeBytes] = [new ByteWriter(), codes.result()];
  out.whole(codeBytes.length);
  out.append(codeBytes);
  writeNumbers(out, writer.coordinates, 2);
  writeNumbers(out, writer.numbers, 1);
  return out.result();
}

function readDomain(reader: OperationReader): Domain {
  const [minX, minY] = reader.point();
  const [maxX, maxY] = reader.point();
  if (!(minX < maxX && minY < maxY)) throw damaged('its domain is empty');
  return [minX, minY, maxX, maxY];
}

function readState(bytes: Uint8Array): ShareState {
  const whole = new ByteReader(bytes);
  const codes = new ByteReader(whole.take(whole.count(1)));
  const reader = new OperationReader(codes, readNumbers(whole, 2), readNumbers(whole, 1));
  const domain = readDomain(reader);
  const yDown = reader.flag();
  const start = reader.optional(() => reader.point()) ?? null;
  const goal = reader.optional(() => reader.point()) ?? null;
  const radius = reader.number();
  if (!(radius >= 0 && radius < Infinity)) throw damaged('its radius is not a number from 0 on');
  const algorithm = reader.algorithm();
  const view = reader.optional(() => ({ x: reader.number(), y: reader.number(), scale: reader.number() })) ?? null;
  const count = codes.count(1);
  if (count > LARGEST_OPERATION_COUNT) throw damaged('it has too many operations');
  const operations = Array.from({ length: count }, () => reader.operation());
  if (!reader.isAtEnd || whole.remaining > 0) throw damaged('it has more than its state');
  return { domain, ...(yDown && { yDown }), operations, start, goal, radius, algorithm, view };
}

/** Returns the text of a link: only letters, digits, `-` and `_`. */
export async function encodeShare(state: ShareState): Promise<string> {
  const compressed = await pipe(writeState(state), new CompressionStream('deflate-raw'), Infinity);
  const bytes = new Uint8Array(HEADER_SIZE + compressed!.length);
  const header = new DataView(bytes.buffer);
  header.setUint8(0, VERSION);
  header.setUint32(1, checksum(compressed!, CRC_32), true);
  header.setUint32(5, checksum(compressed!, CRC_32C), true);
  bytes.set(compressed!, HEADER_SIZE);
  return toBase64Url(bytes);
}

/** Checks the header of a link. Returns the compressed bytes. */
function openLink(text: string): Uint8Array {
  if (text === '') throw new InputError('the link has no text after #', {}, 'Copy the whole link again');
  if (text.length > LARGEST_LINK) throw damaged(`it has more than ${LARGEST_LINK} characters`);
  const bytes = fromBase64Url(text);
  const version = bytes[0]!;
  if (bytes.length > 0 && version !== VERSION) {
    const advice = 'Copy the whole link again; if it comes from a newer version of the page, reload this page';
    const what = `the link has version ${version} of the format, and the page reads version ${VERSION}`;
    throw new InputError(what, {}, advice);
  }
  if (bytes.length <= HEADER_SIZE) throw damaged('it ends too early');
  const header = new DataView(bytes.buffer, bytes.byteOffset);
  const compressed = bytes.subarray(HEADER_SIZE);
  const isWrong = [CRC_32, CRC_32C].some((crc, i) => header.getUint32(1 + 4 * i, true) !== checksum(compressed, crc));
  if (isWrong) throw damaged('its checksum is wrong');
  return compressed;
}

/**
 * Returns the state of a link. A `#` and blanks around the text are ignored. Throws an InputError if the text is damaged.
 * Otherwise the coordinates are those that were encoded, bit by bit.
 */
export async function decodeShare(text: string): Promise<ShareState> {
  const compressed = openLink(text.trim().replace(/^#/, ''));
  let state: Uint8Array | null;
  try {
    state = await pipe(compressed, new DecompressionStream('deflate-raw'), LARGEST_FILE);
  } catch {
    throw damaged('it cannot be unpacked');
  }
  if (state === null) throw damaged('its state is too large');
  return readState(state);
}
