import { quoted, TextReader } from './text';
import { traceCells } from './trace_cells';
import { CornerCount, InputError, type ParsedWorld, type Where } from './types';

const ADVICE =
  "A .map has the lines 'type octile', 'height H', 'width W' and 'map', and then H rows of W cells out of '.GS@OTW'";

function fail(expected: string, found: string, where: Where): never {
  throw new InputError(`expected ${expected}, found ${found}`, where, ADVICE);
}

function headerLine(reader: TextReader, key: string, value: string): void {
  const expected = `'${value === '' ? key : `${key} ${value}`}'`;
  if (!reader.next()) fail(expected, 'the end of the text', reader.where);
  const matches = reader.word() === key && (value === '' || reader.word() === value) && reader.atEnd;
  if (!matches) fail(expected, quoted(reader.line), { line: reader.lineNumber });
}

function sizeLine(reader: TextReader, key: string): number {
  const expected = `'${key}' and a number, 1 or more`;
  if (!reader.next()) fail(expected, 'the end of the text', reader.where);
  const isKey = reader.word() === key;
  const digits = reader.word();
  const size = /^\d+$/.test(digits) ? Number(digits) : 0;
  if (!isKey || !reader.atEnd || size < 1) fail(expected, quoted(reader.line), { line: reader.lineNumber });
  return size;
}

function readRow(reader: TextReader, width: number): string {
  const row = reader.line;
  const unknown = row.search(/[^.GS@OTW]/);
  if (unknown >= 0) {
    const where = { line: reader.lineNumber, column: unknown + 1 };
    fail("cells out of '.GS@OTW'", quoted(row.slice(unknown, unknown + 1)), where);
  }
  if (row.length !== width) fail(`a row of ${width} cells`, String(row.length), { line: reader.lineNumber });
  return row;
}

/** Reads a map of Moving AI: one polygon for each group of blocked cells that are connected through their sides. */
export function readMap(text: string): ParsedWorld {
  const reader = new TextReader(text, null);
  headerLine(reader, 'type', 'octile');
  const height = sizeLine(reader, 'height');
  const width = sizeLine(reader, 'width');
  headerLine(reader, 'map', '');
  const rows: string[] = [];
  while (rows.length < height) {
    if (!reader.next()) fail(`${height} rows`, `the end of the text after ${rows.length}`, reader.where);
    rows.push(readRow(reader, width));
  }
  while (reader.next()) {
    if (!reader.atEnd) fail(`the end of the text after ${height} rows`, quoted(reader.line), { line: reader.lineNumber });
  }
  const items = traceCells(rows, new CornerCount());
  return { items, domain: [0, 0, width, height], yDown: true };
}
