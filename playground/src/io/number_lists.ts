import { type ByteReader, type ByteWriter, damaged } from './byte_stream';

// A list of numbers is written in one of two ways. Method 0 writes the bytes of the doubles, with the bytes of the same
// significance next to each other, because they are often alike and then take little space after compression. Method 1 is
// for numbers that are multiples of 1 / d, in binary or in decimal: it writes d and the differences of the multiples.
const BYTES = 0;
const MULTIPLES = 1;
const DIVISORS = [1, 2, 4, 8, 10, 16, 64, 100, 256, 1000, 1024, 4096, 10_000, 65_536, 100_000, 1_000_000, 1_048_576];
const LARGEST_MULTIPLE = 2 ** 50;

/** Whether `multiple / divisor` is exactly `value`. Both signs of 0 differ. */
function isMultiple(value: number, divisor: number): boolean {
  const multiple = Math.round(value * divisor);
  return Math.abs(multiple) <= LARGEST_MULTIPLE && !Object.is(value, -0) && multiple / divisor === value;
}

function divisorFor(values: readonly number[]): number | null {
  let tried = 0;
  for (const value of values) {
    while (tried < DIVISORS.length && !isMultiple(value, DIVISORS[tried]!)) ++tried;
    if (tried === DIVISORS.length) return null;
  }
  // The loop may have increased the divisor for a later value, and this divisor may not fit an earlier value.
  return values.every((value) => isMultiple(value, DIVISORS[tried]!)) ? DIVISORS[tried]! : divisorForAll(values, tried);
}

function divisorForAll(values: readonly number[], first: number): number | null {
  return DIVISORS.slice(first).find((divisor) => values.every((value) => isMultiple(value, divisor))) ?? null;
}

function writeBytes(out: ByteWriter, values: readonly number[]): void {
  const bytes = new Uint8Array(8 * values.length);
  const one = new DataView(new ArrayBuffer(8));
  values.forEach((value, i) => {
    one.setFloat64(0, value);
    for (let plane = 0; plane < 8; ++plane) bytes[plane * values.length + i] = one.getUint8(plane);
  });
  out.append(bytes);
}

/**
 * Writes a list of numbers, bit by bit. With `stride` 2 it contains the coordinates of points: each number is then compared
 * with the last one of the same axis.
 */
export function writeNumbers(out: ByteWriter, values: readonly number[], stride: 1 | 2): void {
  const divisor = divisorFor(values);
  out.byte(divisor === null ? BYTES : MULTIPLES);
  out.whole(values.length);
  if (divisor === null) return writeBytes(out, values);
  out.whole(divisor);
  const last = [0, 0];
  values.forEach((value, i) => {
    const multiple = Math.round(value * divisor);
    out.signed(multiple - last[i % stride]!);
    last[i % stride] = multiple;
  });
}

function readBytes(reader: ByteReader, count: number): number[] {
  const bytes = reader.take(8 * count);
  const one = new DataView(new ArrayBuffer(8));
  return Array.from({ length: count }, (_, i) => {
    for (let plane = 0; plane < 8; ++plane) one.setUint8(plane, bytes[plane * count + i]!);
    return one.getFloat64(0);
  });
}

/** Reads what writeNumbers has written. */
export function readNumbers(reader: ByteReader, stride: 1 | 2): number[] {
  const method = reader.byte();
  if (method === BYTES) return readBytes(reader, reader.count(8));
  if (method !== MULTIPLES) throw damaged(`it has numbers of the unknown kind ${method}`);
  const count = reader.count(1);
  const divisor = reader.whole();
  if (!DIVISORS.includes(divisor)) throw damaged(`it has the unknown divisor ${divisor}`);
  const last = [0, 0];
  return Array.from({ length: count }, (_, i) => {
    last[i % stride] = last[i % stride]! + reader.signed();
    return last[i % stride]! / divisor;
  });
}
