// Files that cannot be read: each gives an InputError that says what, where and what to do.
import assert from 'node:assert/strict';
import test from 'node:test';

import { bytesOf, firstSyntaxError, parse, parseFile, Random, refuses } from './support.mjs';

const SCRIPT = 'waywright 1\ndomain 0 0 10 10\npolygon 1 3 1 1 5 1 1 5\npath 0 0 9 9 0\n';
const MAP = 'type octile\nheight 2\nwidth 3\nmap\n.@.\n...\n';
const POLY = '3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n1 0\n1 1 2\n0\n';
const GEO = '{"type":"Feature","geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]]]}}';

/** Each row: what it is, the name of the file, its text, what the message says, where. */
const texts = [
  ['an empty file', 'a.wws', '', /the file is empty/, {}],
  ['only blanks', 'a', ' \n\t\n# nothing\n', /nothing but blanks/, { line: 3, column: 1 }],
  ['an unknown format', 'notes.txt', 'Dear diary,\n', /'notes\.txt' is unknown.*'Dear'.*\.geojson/, { line: 1, column: 1 }],
  ['a page of HTML', 'a.html', '<!DOCTYPE html>\n', /is unknown/, { line: 1, column: 1 }],
  ['a scenario', 'a.scen', 'version 1\n0\ta.map\t5\t5\t1\t1\t2\t2\t1.4\n', /choose the \.map/, { line: 1 }],

  ['a wrong header', 'a.wws', 'wayward 1\n', /expected the header 'waywright 1', found 'wayward'/, { line: 1, column: 1 }],
  ['no version', 'a.wws', 'waywright\n', /format version 1, found the end of the line/, { line: 1, column: 10 }],
  ['an unknown version', 'a.wws', 'waywright 2\n', /format version 1, found '2'/, { line: 1, column: 11 }],
  ['no domain', 'a.wws', 'waywright 1\n', /expected 'domain.*the end of the text/, { line: 1, column: 11 }],
  ['an item before the domain', 'a.wws', 'waywright 1\npoint 1 2 3\n', /'domain.*found 'point'/, { line: 2, column: 1 }],
  ['an empty domain', 'a.wws', 'waywright 1\ndomain 1 0 1 5', /a number above 1/, { line: 2, column: 14 }],
  ['a second domain', 'a.wws', `${SCRIPT}domain 0 0 1 1`, /only one domain/, { line: 5, column: 1 }],
  ['a domain at infinity', 'a.wws', 'waywright 1\ndomain 0 0 inf 1', /coordinate 'inf'.*2\^100/, { line: 2, column: 12 }],
  ['an unknown operation', 'a.wws', `${SCRIPT}\n  line 1 2`, /an operation \(point, .*found 'line'/, { line: 6, column: 3 }],
  ['a name of Object', 'a.wws', `${SCRIPT}constructor 1`, /found 'constructor'/, { line: 5, column: 1 }],
  [
    'a cut line', 'a.wws', SCRIPT.slice(0, 48),
    /a number in 'polygon ID.*found the end of the line/, { line: 3, column: 20 },
  ],
  ['a cut number', 'a.wws', `${SCRIPT}point 2 1 2e`, /a number.*found '2e'/, { line: 5, column: 11 }],
  ['a hexadecimal number', 'a.wws', `${SCRIPT}point 2 1 0x10`, /found '0x10'/, { line: 5, column: 11 }],
  ['a comma', 'a.wws', `${SCRIPT}point 2 1,5 3`, /found '1,5'/, { line: 5, column: 9 }],
  ['NaN', 'a.wws', `${SCRIPT}point 2 NaN 1`, /the coordinate 'NaN' is not 0/, { line: 5, column: 9 }],
  ['a huge number', 'a.wws', `${SCRIPT}point 2 1e999 1`, /the coordinate '1e999'/, { line: 5, column: 9 }],
  ['a tiny number', 'a.wws', `${SCRIPT}point 2 1e-300 1`, /the coordinate '1e-300'/, { line: 5, column: 9 }],
  ['a negative count', 'a.wws', `${SCRIPT}polyline 2 -3 1 1`, /a count of points.*found '-3'/, { line: 5, column: 12 }],
  ['a huge count', 'a.wws', `${SCRIPT}polyline 2 ${'9'.repeat(500)} 1 1`, /a count of points/, { line: 5, column: 12 }],
  ['a count without points', 'a.wws', `${SCRIPT}polyline 2 9000000000 1 1`, /a number/, { line: 5, column: 26 }],
  ['an id of 0', 'a.wws', `${SCRIPT}point 0 1 1`, /an id from 1 to 9223372036854775807.*'0'/, { line: 5, column: 7 }],
  ['an id of 2^63', 'a.wws', `${SCRIPT}remove 9223372036854775808`, /an id from 1/, { line: 5, column: 8 }],
  ['one word too many', 'a.wws', `${SCRIPT}check now`, /expected the end of the line in 'check', found 'now'/, { line: 5, column: 7 }],
  ['an unknown algorithm', 'a.wws', `${SCRIPT}path 1 1 2 2 0 best`, /'optimal', 'ta', 'tra'/, { line: 5, column: 16 }],
  ['a wrong mark', 'a.wws', `${SCRIPT}mark 2`, /tick 1, the one after/, { line: 5, column: 6 }],
  ['a rewind to nothing', 'a.wws', `${SCRIPT}rewind 1`, /a mark before/, { line: 5, column: 8 }],
  ['a cut hash', 'a.wws', `${SCRIPT}tick 1 0123`, /32 hexadecimal digits/, { line: 5, column: 8 }],
  ['replace without a kind', 'a.wws', `${SCRIPT}replace 1 2 3`, /'point', 'segment'/, { line: 5, column: 9 }],
  ['a wrong separator', 'a.wws', `${SCRIPT}polygon 2 1 0 0 ; 1 1 1`, /expected '\/' or the end of the line/, { line: 5, column: 17 }],

  [
    'a map of another type', 'a.map', MAP.replace('octile', 'tile'),
    /expected 'type octile', found 'type tile'/, { line: 1 },
  ],
  ['a map without its first line', 'a.map', MAP.slice(12), /expected 'type octile', found 'height 2'/, { line: 1 }],
  ['a map of negative height', 'a.map', MAP.replace('2', '-2'), /'height' and a number, 1 or more/, { line: 2 }],
  [
    'a map without cells', 'a.map', 'type octile\nheight 2\nwidth 3\n',
    /expected 'map', found the end/, { line: 3, column: 7 },
  ],
  ['a cut map', 'a.map', MAP.slice(0, -4), /2 rows, found the end of the text after 1/, { line: 5, column: 1 }],
  ['a cut row', 'a.map', MAP.slice(0, -2), /a row of 3 cells, found 2/, { line: 6 }],
  ['an unknown cell', 'a.map', MAP.replace('@', 'x'), /cells out of '\.GS@OTW', found 'x'/, { line: 5, column: 2 }],
  ['a map with more', 'a.map', `${MAP}...\n`, /the end of the text after 2 rows/, { line: 7 }],
  ['a map that is too large', 'a.map', MAP.replace('3', '4000000000'), /a row of 4000000000 cells/, { line: 5 }],

  ['a .poly of dimension 3', 'a.poly', POLY.replace('3 2', '3 3'), /expected dimension 2, found 3/, { line: 1, column: 3 }],
  ['a .poly with a negative count', 'a.poly', '-3 2 0 0\n', /the number of vertices, found '-3'/, { line: 1, column: 1 }],
  ['a cut .poly', 'a.poly', POLY.slice(0, 20), /vertex 3, found the end of the text/, { line: 3, column: 5 }],
  [
    'a .poly with a gap in its ids', 'a.poly', POLY.replace('\n3 ', '\n4 '),
    /expected vertex 3, found 4/, { line: 4, column: 1 },
  ],
  ['an unknown vertex', 'a.poly', POLY.replace('1 1 2', '1 1 7'), /found 7, which no vertex has/, { line: 6, column: 5 }],
  ['a .poly without vertices', 'a.poly', '0 2 0 0\n1 0\n1 1 2\n0\n', /in the \.node file/, { line: 1, column: 7 }],
  ['a word in a .poly', 'a.poly', POLY.replace('1 0\n3', 'one 0\n3'), /a coordinate, found 'one'/, { line: 3, column: 3 }],
  ['NaN in a .poly', 'a.poly', POLY.replace('1 0\n3', 'nan 0\n3'), /the coordinate 'nan'/, { line: 3, column: 3 }],
  [
    'a huge number in a .poly', 'a.poly', POLY.replace('1 0\n3', '1e40 0\n3'),
    /the coordinate '1e40'/, { line: 3, column: 3 },
  ],
  ['a huge id', 'a.poly', '1 2\n99999999999999999999 1 1', /found '99999999999999999999'/, { line: 2, column: 1 }],
  ['a .poly with more', 'a.poly', `${POLY}0\nmore`, /the end of the text, found one more line/, { line: 9, column: 1 }],
  ['a .node with more', 'a.node', '1 2\n1 0 0\n7\n', /the end of the text/, { line: 3, column: 1 }],

  ['cut GeoJSON', 'a.json', GEO.slice(0, 60), /not JSON: it is wrong at the end of the text/, { line: 1, column: 61 }],
  ['NaN in GeoJSON', 'a.json', '{"type":"Point",\n"coordinates":[NaN,0]}', /wrong at 'NaN,0\]\}'/, { line: 2, column: 16 }],
  ['a comma too many', 'a.json', GEO.replace('[0,0]]', '[0,0],]'), /wrong at '\]/, { line: 1, column: 88 }],
  ['a wrong bracket', 'a.json', GEO.replace(']]]', ']]}'), /wrong at '\}/, { line: 1, column: 88 }],
  ['a text without its end', 'a.json', '{"type":"Poi', /wrong at '"Poi'/, { line: 1, column: 9 }],
  ['a key without quotes', 'a.json', '{\n type: 1}', /wrong at 'type: 1\}'/, { line: 2, column: 2 }],
  ['two values', 'a.json', '{} {}', /wrong at '\{\}'/, { line: 1, column: 4 }],
  ['an array', 'a.json', '[1, 2]', /expected a GeoJSON object, found an array/, { path: '' }],
  ['JSON of another kind', 'a.json', '{"a":1}', /a type of GeoJSON .*found nothing/, { path: 'type' }],
  ['TopoJSON', 'a.json', '{"type":"Topology","arcs":[]}', /TopoJSON.*Convert it/, { path: 'type' }],
  [
    'an unknown geometry', 'a.json', GEO.replace('Polygon', 'Circle'),
    /MultiPolygon.*found '"Circle"'/, { path: 'geometry.type' },
  ],
  ['no geometry', 'a.json', '{"type":"FeatureCollection","features":[]}', /has no geometry/, {}],
  ['no features', 'a.json', '{"type":"FeatureCollection"}', /an array of features, found nothing/, { path: 'features' }],
  [
    'a geometry as a feature', 'a.json', '{"type":"FeatureCollection","features":[{"type":"Point"}]}',
    /'Feature'/, { path: 'features[0].type' },
  ],
  [
    'a text as a coordinate', 'a.json', GEO.replace('[1,0]', '["1",0]'),
    /a coordinate, found/, { path: 'geometry.coordinates[0][1][0]' },
  ],
  [
    'a position of one number', 'a.json', GEO.replace('[1,0]', '[1]'),
    /found nothing/, { path: 'geometry.coordinates[0][1][1]' },
  ],
  ['a null position', 'a.json', GEO.replace('[1,0]', 'null'), /a position/, { path: 'geometry.coordinates[0][1]' }],
  [
    'rings that lack a level', 'a.json', GEO.replace('[[[', '[[').replace(']]]', ']]'),
    /a position/, { path: 'geometry.coordinates[0][0]' },
  ],
  [
    'a huge number in GeoJSON', 'a.json', GEO.replace('[1,0]', '[1e999,0]'),
    /beyond 2\^100/, { path: 'geometry.coordinates[0][1][0]' },
  ],
  [
    'a tiny number in GeoJSON', 'a.json', GEO.replace('[1,0]', '[1e-99,0]'),
    /1e-99/, { path: 'geometry.coordinates[0][1][0]' },
  ],
  ['deep arrays', 'a.json', '['.repeat(1_000_000), /nested more than 100 deep/, { line: 1, column: 101 }],
  [
    'deep collections', 'a.json', `${'{"type":"GeometryCollection","geometries":['.repeat(60)}${']}'.repeat(60)}`,
    /nested more than 100 deep/, { line: 1, column: 2151 },
  ],
];

for (const [what, name, text, pattern, where] of texts) {
  test(`${what} is refused`, () => refuses(() => parse(name, text), pattern, where));
}

const utf16 = (text) => Buffer.from(text, 'utf16le');
const swapped = (text) => utf16(text).swap16();

/** Each row: what it is, the bytes, what the message says, the byte. */
const files = [
  ['UTF-16LE with a mark', utf16(`\ufeff${SCRIPT}`), /UTF-16LE.*iconv/, 1],
  ['UTF-16BE with a mark', swapped(`\ufeff${SCRIPT}`), /UTF-16BE/, 1],
  ['UTF-16LE without a mark', utf16(SCRIPT), /UTF-16LE/, 1],
  ['UTF-16BE without a mark', swapped(SCRIPT), /UTF-16BE/, 1],
  ['UTF-32LE', Buffer.from([0xff, 0xfe, 0, 0, 0x77, 0, 0, 0]), /UTF-32LE/, 1],
  ['UTF-32BE', Buffer.from([0, 0, 0, 0x77, 0, 0, 0, 0x61]), /UTF-32BE/, 1],
  ['Latin-1', Buffer.from(`# caf\xe9\n${SCRIPT}`, 'latin1'), /not UTF-8.*LATIN1/, 6],
  ['a cut character', Buffer.concat([bytesOf(SCRIPT), Buffer.from([0x23, 0xe2, 0x82])]), /not UTF-8/, SCRIPT.length + 2],
  ['a zero byte', Buffer.from(`${SCRIPT}\0`), /not a text/, SCRIPT.length + 1],
  ['a saved world', Buffer.from('WWORLD\x01\x00'), /saved world.*waywright convert/, 1],
  ['gzip', Buffer.from([0x1f, 0x8b, 8, 0, 0, 0]), /gzip.*gunzip/, 1],
  ['a ZIP archive', Buffer.from('PK\x03\x04'), /ZIP/, 1],
  ['a picture', Buffer.from('\x89PNG\r\n', 'latin1'), /PNG/, 1],
  ['a document', Buffer.from('%PDF-1.4'), /PDF/, 1],
];

for (const [what, bytes, pattern, byte] of files) {
  test(`${what} is refused`, () => refuses(() => parseFile('a.wws', bytes), pattern, { byte }));
}

test('a file of more than 50 MB is refused', async () => {
  await refuses(() => parseFile('a.wws', new Uint8Array(50_000_001)), /50000001 bytes, and the largest size is 50000000/);
});

test('more than 2,000,000 corners are refused', async () => {
  const line = `clear 100000 ${'1 1 '.repeat(100_000)}\n`;
  assert.equal(parse('a.wws', SCRIPT.slice(0, 29) + line.repeat(20)).operations.length, 20);
  const text = `${SCRIPT.slice(0, 29)}${line.repeat(20)}point 1 1 1\n`;
  await refuses(() => parse('a.wws', text), /more than 2,000,000 corners.*native command/, { line: 23, column: 11 });
  const positions = `${'[1,1],'.repeat(2_000_000)}[1,1]`;
  const geo = `{"type":"MultiPoint","coordinates":[${positions}]}`;
  await refuses(() => parse('a.json', geo), /more than 2,000,000 corners/, { path: 'coordinates[2000000]' });
});

test('more than 2,000,000 operations are refused', async () => {
  const text = SCRIPT + 'hash\n'.repeat(1_999_999);
  await refuses(() => parse('a.wws', text), /more than 2,000,000 operations/, { line: 2_000_003, column: 1 });
});

test('no damaged file makes anything else than an InputError', () => {
  const sources = [SCRIPT, MAP, POLY, GEO].map((text) => bytesOf(text));
  for (let seed = 0; seed < 20_000; ++seed) {
    const random = new Random(seed);
    const bytes = Uint8Array.from(random.pick(sources));
    const letters = bytesOf('0129-.#/ \n@{}[],"einax\xff');
    for (let i = random.below(4); i >= 0; --i) bytes[random.below(bytes.length)] = random.pick(letters);
    const cut = bytes.subarray(0, random.below(3) > 0 ? bytes.length : random.below(bytes.length));
    try {
      parseFile(random.pick(['a.wws', 'a.map', 'a.poly', 'a.node', 'a.json', 'a']), cut);
    } catch (error) {
      assert.equal(error.name, 'InputError', `seed ${seed}: ${error.stack}`);
    }
  }
});

test('the place of a syntax error is where no JSON can begin as the text does', () => {
  const source = '{"a": [1, -2.5e3, {"b": null}, "\\u00e9\\n", true], "c": {}}';
  for (let seed = 0; seed < 5000; ++seed) {
    const random = new Random(seed);
    const at = random.below(source.length);
    const text = source.slice(0, at) + random.pick([...'{}[],:"1-ntx ']) + source.slice(at + random.below(2));
    let isJson = true;
    try {
      JSON.parse(text);
    } catch {
      isJson = false;
    }
    if (isJson) continue;
    const index = firstSyntaxError(text);
    // What is before the place can be completed: the tokens of a text that is cut there are correct.
    assert.ok(index >= at - 12 && index <= text.length, `${text}: ${index}`);
    assert.equal(firstSyntaxError(text.slice(0, index)), index, text);
  }
});
