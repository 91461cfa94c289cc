import { InputError, type ItemId, type Where } from './types';

const BLANK = 32;
const TAB = 9;
const LARGEST_ID = 2n ** 63n - 1n;

function startsWith(bytes: Uint8Array, start: readonly number[]): boolean {
  return start.length <= bytes.length && start.every((byte, i) => bytes[i] === byte);
}

/** Returns the encoding of a text that is not UTF-8, or null. */
function foreignEncoding(bytes: Uint8Array): string | null {
  const marks: [string, number[]][] = [
    ['UTF-32LE', [0xff, 0xfe, 0, 0]],
    ['UTF-32BE', [0, 0, 0xfe, 0xff]],
    ['UTF-16LE', [0xff, 0xfe]],
    ['UTF-16BE', [0xfe, 0xff]],
  ];
  const marked = marks.find(([, mark]) => startsWith(bytes, mark));
  if (marked) return marked[0];
  // All texts begin with an ASCII character. So zeros around it reveal the encoding.
  const pattern = [...bytes.subarray(0, 4)].map((byte) => (byte === 0 ? '0' : byte < 0x80 ? 'a' : '?')).join('');
  if (pattern === 'a000') return 'UTF-32LE';
  if (pattern === '000a') return 'UTF-32BE';
  if (pattern.startsWith('a0')) return 'UTF-16LE';
  return pattern.startsWith('0a') ? 'UTF-16BE' : null;
}

function isUtf8(bytes: Uint8Array, options?: TextDecodeOptions): boolean {
  try {
    new TextDecoder('utf-8', { fatal: true }).decode(bytes, options);
    return true;
  } catch {
    return false;
  }
}

/** Returns the index of the first byte that is not UTF-8. */
function firstBadByte(bytes: Uint8Array): number {
  let [good, bad] = [0, bytes.length];
  // In the mode `stream`, the decoder accepts every start of a correct text.
  while (bad - good > 1) {
    const middle = (good + bad) >>> 1;
    if (isUtf8(bytes.subarray(0, middle), { stream: true })) good = middle;
    else bad = middle;
  }
  while (!isUtf8(bytes.subarray(0, good))) --good;
  return good;
}

/** Decodes UTF-8, with or without a byte order mark. */
export function decodeText(bytes: Uint8Array): string {
  const encoding = foreignEncoding(bytes);
  if (encoding !== null) {
    const advice = `Save the text as UTF-8, or convert it with 'iconv -f ${encoding} -t UTF-8'`;
    throw new InputError(`the text is in ${encoding}, and not in UTF-8`, { byte: 1 }, advice);
  }
  const zero = bytes.indexOf(0);
  if (zero >= 0) {
    throw new InputError('the file is not a text: it has a zero byte', { byte: zero + 1 }, 'Choose a text file');
  }
  if (!isUtf8(bytes)) {
    const advice = "Save the text as UTF-8; 'iconv -f LATIN1 -t UTF-8' converts older texts";
    throw new InputError('the text is not UTF-8', { byte: firstBadByte(bytes) + 1 }, advice);
  }
  return new TextDecoder().decode(bytes);
}

/** Returns a word in quotes. Shortens a long word, and writes characters that are not printable as their code. */
export function quoted(word: string): string {
  const shown = word.slice(0, 40).replace(/[^\x20-\x7e]/gu, (c) => `\\u{${c.codePointAt(0)!.toString(16)}}`);
  return `'${shown}${word.length > 40 ? '...' : ''}'`;
}

const NUMBER = /^[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?$/;
const INFINITE = /^([+-]?)inf(?:inity)?$/i;

/**
 * Returns the double nearest to a decimal number, or null if the word is no number. The words for infinity and NaN are
 * numbers.
 */
export function readNumber(word: string): number | null {
  if (NUMBER.test(word)) return Number(word);
  if (/^[+-]?nan$/i.test(word)) return NaN;
  const infinite = INFINITE.exec(word);
  return infinite ? (infinite[1] === '-' ? -Infinity : Infinity) : null;
}

/** Reads a whole number from 0 to 2^63 - 1. It is a number up to 2^53 - 1, and a bigint above. */
export function readWhole(word: string): ItemId | null {
  if (!/^\d+$/.test(word)) return null;
  const value = Number(word);
  if (Number.isSafeInteger(value)) return value;
  const whole = BigInt(word.length > 400 ? '9'.repeat(400) : word);
  return whole <= LARGEST_ID ? whole : null;
}

/** Reads the lines and words of a text. Blanks and tabs separate words. Lines end in LF or CRLF. */
export class TextReader {
  private readonly text: string;
  private readonly comment: string | null;
  private nextLine = 0;
  private lineStart = 0;
  private lineEnd = 0;
  private at = 0;
  private wordStart = 0;
  private number = 0;

  /** `comment` is the character that starts a comment, or null. */
  constructor(text: string, comment: string | null = '#') {
    this.text = text;
    this.comment = comment;
  }

  /** Moves to the next line. Returns false at the end of the text. */
  next(): boolean {
    if (this.nextLine >= this.text.length) return false;
    const end = this.text.indexOf('\n', this.nextLine);
    this.lineStart = this.nextLine;
    this.lineEnd = end < 0 ? this.text.length : end;
    this.nextLine = this.lineEnd + 1;
    if (this.lineEnd > this.lineStart && this.text[this.lineEnd - 1] === '\r') --this.lineEnd;
    if (this.comment !== null) this.cutComment(this.comment);
    this.at = this.lineStart;
    this.wordStart = this.at;
    ++this.number;
    this.skipBlanks();
    return true;
  }

  /** Moves to the next line that has a word. */
  nextWithWord(): boolean {
    while (this.next()) if (!this.atEnd) return true;
    return false;
  }

  private cutComment(comment: string): void {
    for (let i = this.lineStart; i < this.lineEnd; ++i) {
      if (this.text[i] === comment) this.lineEnd = i;
    }
  }

  private skipBlanks(): void {
    while (this.at < this.lineEnd && this.isBlank(this.at)) ++this.at;
  }

  private isBlank(index: number): boolean {
    const code = this.text.charCodeAt(index);
    return code === BLANK || code === TAB;
  }

  /** Whether the line has no further word. */
  get atEnd(): boolean {
    return this.at >= this.lineEnd;
  }

  /** Returns the next word of the line, or '' at its end. */
  word(): string {
    this.wordStart = this.at;
    while (this.at < this.lineEnd && !this.isBlank(this.at)) ++this.at;
    const word = this.text.slice(this.wordStart, this.at);
    this.skipBlanks();
    return word;
  }

  /** The line without its comment. */
  get line(): string {
    return this.text.slice(this.lineStart, this.lineEnd);
  }

  get lineNumber(): number {
    return Math.max(1, this.number);
  }

  /** The place of the last word. */
  get where(): Where {
    return this.number === 0 ? { line: 1 } : { line: this.number, column: this.wordStart - this.lineStart + 1 };
  }
}
