// Files that parseFile reads.
import assert from 'node:assert/strict';
import test from 'node:test';

import { bytesOf, items, numberText, operationsOf, parse, parseFile, Random, writeWws } from './support.mjs';

const point = (x, y) => ({ kind: 'point', xy: [x, y] });
const MAP = 'type octile\nheight 4\nwidth 5\nmap\n.....\n.@@@.\n.@.T.\n..O.W\n';
const POLY = `# a triangle, and a point
4 2 1 1
1 0 0 7.5 1
2 4 0 7.5 1
3 0 3 7.5 1
4 9 9 7.5 0
3 1
1 1 2 0
2 2 3 0
3 3 1 0
1
1 0.5 0.5
`;

test('a map becomes one polygon for each group of blocked cells', () => {
  const world = parse('arena.map', MAP);
  assert.deepEqual(world.domain, [0, 0, 5, 4]);
  assert.equal(world.yDown, true);
  // The group around the free cell (2, 2) is open there: the cells (1, 2) and (2, 3) only touch diagonally.
  assert.deepEqual(world.items, [
    { kind: 'polygon', rings: [[[1, 1], [4, 1], [4, 3], [3, 3], [3, 2], [2, 2], [2, 3], [1, 3]]] },
    { kind: 'polygon', rings: [[[2, 3], [3, 3], [3, 4], [2, 4]]] },
    { kind: 'polygon', rings: [[[4, 3], [5, 3], [5, 4], [4, 4]]] },
  ]);
});

test('a map with a hole has its outer ring first', () => {
  const world = parse('ring.map', 'type octile\nheight 3\nwidth 3\nmap\n@@@\n@.@\n@@@\n');
  assert.deepEqual(world.items, [
    { kind: 'polygon', rings: [[[0, 0], [3, 0], [3, 3], [0, 3]], [[1, 2], [2, 2], [2, 1], [1, 1]]] },
  ]);
});

test('the rings of a random map cover its blocked cells, and no others', () => {
  for (let seed = 0; seed < 60; ++seed) {
    const random = new Random(seed);
    const [width, height] = [1 + random.below(9), 1 + random.below(9)];
    const rows = Array.from({ length: height }, () => Array.from({ length: width }, () => random.pick('.GS@OTW')).join(''));
    const world = parse('x.map', `type octile\nheight ${height}\nwidth ${width}\nmap\n${rows.join('\n')}`);
    for (let y = 0; y < height; ++y) {
      for (let x = 0; x < width; ++x) {
        const covers = world.items.filter((item) => isInside(item.rings, x + 0.5, y + 0.5)).length;
        assert.equal(covers, '.GS'.includes(rows[y][x]) ? 0 : 1, `seed ${seed}, cell ${x}, ${y}`);
      }
    }
  }
});

/** Whether a position is inside rings whose sides are level or upright. */
function isInside(rings, x, y) {
  let crossings = 0;
  for (const ring of rings) {
    ring.forEach(([ax, ay], i) => {
      const [bx, by] = ring[(i + 1) % ring.length];
      if (ax === bx && ax > x && Math.min(ay, by) < y && y < Math.max(ay, by)) ++crossings;
    });
  }
  return crossings % 2 === 1;
}

test('a .poly becomes segments, and points that are on no segment', () => {
  const world = parse('a.poly', POLY);
  assert.deepEqual(world.items, [
    point(9, 9),
    { kind: 'segment', points: [[0, 0], [4, 0]] },
    { kind: 'segment', points: [[4, 0], [0, 3]] },
    { kind: 'segment', points: [[0, 3], [0, 0]] },
  ]);
  assert.deepEqual(world.domain, [-2, -2, 11, 11]);
});

test('a .node becomes points', () => {
  assert.deepEqual(parse('a.node', '2 2\n0 1 2\n1 3.5 -4e-2\n').items, [point(1, 2), point(3.5, -0.04)]);
});

test('GeoJSON of every type becomes items', () => {
  const square = [[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]];
  const hole = [[1, 1], [1, 2], [2, 2], [1, 1]];
  const geometries = [
    { type: 'Point', coordinates: [1, 2, 300] },
    { type: 'MultiPoint', coordinates: [[3, 4], [5, 6, 7, 8]] },
    { type: 'LineString', coordinates: [[0, 0], [1, 1], [2, 0]] },
    { type: 'MultiLineString', coordinates: [[[0, 0], [1, 0]], [[0, 1], [1, 1]]] },
    { type: 'Polygon', coordinates: [square, hole] },
    { type: 'MultiPolygon', coordinates: [[square], [hole]] },
  ];
  const rings = [square.slice(0, -1), hole.slice(0, -1)];
  const expected = [
    point(1, 2), point(3, 4), point(5, 6),
    { kind: 'polyline', points: [[0, 0], [1, 1], [2, 0]] },
    { kind: 'polyline', points: [[0, 0], [1, 0]] }, { kind: 'polyline', points: [[0, 1], [1, 1]] },
    { kind: 'polygon', rings },
    { kind: 'polygon', rings: [rings[0]] }, { kind: 'polygon', rings: [rings[1]] },
  ];
  const features = geometries.map((geometry) => ({ type: 'Feature', properties: { name: '[{"' }, geometry }));
  const collection = { type: 'GeometryCollection', geometries };
  const texts = [
    collection,
    { type: 'FeatureCollection', features: [{ type: 'Feature', geometry: null }, ...features] },
    { type: 'Feature', geometry: { type: 'GeometryCollection', geometries: [collection] } },
  ];
  for (const text of texts) {
    const world = parse('a.geojson', JSON.stringify(text));
    assert.deepEqual(world.items, expected);
    assert.deepEqual(world.domain, [-1, -1, 6, 7]);
  }
});

test('geometry without positions makes no item', () => {
  const geometries = [
    { type: 'Point', coordinates: [] }, { type: 'LineString', coordinates: [] }, { type: 'Polygon', coordinates: [[]] },
    { type: 'MultiPolygon', coordinates: [] }, { type: 'Point', coordinates: [1, 1] },
  ];
  assert.deepEqual(parse('a.json', JSON.stringify({ type: 'GeometryCollection', geometries })).items, [point(1, 1)]);
});

const SCRIPT = `# every line of docs/formats.md
waywright 1
domain -10 -10 10 10 # the box
point 1 -0 0.1
segment 2 1 2 3 4
polyline 9007199254740993 3 0 0 1 1 +2 0
polygon 4 nonzero 3 0 0 1e0 0 0 1. / 1 .5 .25
mark 1
remove 2
replace polygon 4 2 1 1 2 2
point 9 11 0
remove 77
segment 1 0 0 1 1
replace point 5 0 0
rewind 1
locate 1 2
ray 1 2 3 4
ray 1 2 3 4 0.5
path 1 2 3 4 0
path 1 2 3 4 0.5 tra tolerance inf
path -1 -2 3 4 0.25 ta
disc 1 2 -1
disc 1 2 3
nearest 1 2 0.5 goal 3 4
nearest 1 2 0.5
clear 2 0 0 5 5
check
hash
tick 7
tick 8 0123456789abcdef0123456789abcdef
point 8 5 5
`;

test('a script keeps its operations, without those that every world refuses', () => {
  const world = parse('a.wws', SCRIPT);
  assert.deepEqual(world.ids, [1, 2, 9007199254740993n, 4, 8]);
  assert.deepEqual(world.items[3], { kind: 'polygon', rings: [[[0, 0], [1, 0], [0, 1]], [[0.5, 0.25]]], fill: 'nonzero' });
  assert.deepEqual([world.start, world.goal, world.radius], [[-1, -2], [3, 4], 0.25]);
  assert.deepEqual(world.refused.map(({ line }) => line), [11, 12, 13, 14, 22]);
  assert.deepEqual(world.operations.map(({ kind }) => kind), [
    'insert', 'insert', 'insert', 'insert', 'mark', 'remove', 'replace', 'rewind', 'locate', 'ray', 'ray', 'path', 'path',
    'path', 'disc', 'nearest', 'nearest', 'clear', 'check', 'hash', 'tick', 'tick', 'insert',
  ]);
  assert.deepEqual(world.operations[12], {
    kind: 'path', from: [1, 2], to: [3, 4], radius: 0.5, algorithm: 'tra', tolerance: Infinity,
  });
  const again = parse('b.wws', writeWws(world.domain, world.operations));
  assert.deepEqual(again.operations, world.operations.map((operation, i) => (i === 0 ? again.operations[0] : operation)));
  assert.deepEqual(again.operations[0].item, point(0, 0.1)); // -0 is written as 0
});

test('line ends, blanks and a byte order mark make no difference', () => {
  const json = '{"type":"Point",\n"coordinates":[1,2]}';
  for (const [name, text] of [['a.wws', SCRIPT], ['a.map', MAP], ['a.poly', POLY], ['a.json', json]]) {
    const expected = parse(name, text);
    assert.deepEqual(parse(name, text.replaceAll('\n', '\r\n')), expected);
    assert.deepEqual(parse(name, `\ufeff${text}`), expected);
    assert.deepEqual(parse(name, text.trimEnd()), expected);
    assert.deepEqual(parse('without an ending', text), expected);
    if (!name.endsWith('.map')) assert.deepEqual(parse('wrong.map', text), expected);
  }
});

test('random items survive a script', () => {
  for (let seed = 0; seed < 200; ++seed) {
    const random = new Random(seed);
    const ring = () => Array.from({ length: 1 + random.below(5) }, () => [random.coordinate() + 0, random.coordinate() + 0]);
    const list = Array.from({ length: 5 }, () => {
      const kind = random.pick(['point', 'segment', 'polyline', 'polygon']);
      const rings = kind === 'polygon' ? [ring(), ring()] : [[...ring(), ...ring()]];
      if (kind === 'segment') rings[0].length = 2;
      return items.makeItem(kind, rings, random.pick(['even-odd', 'nonzero']));
    });
    const [far, operations] = [2 ** 100, operationsOf({ items: list })];
    const world = parse('a.wws', writeWws([-far, -far, far, far], operations));
    assert.deepEqual(world.operations, operations, `seed ${seed}`);
    assert.deepEqual(world.items, list);
  }
});

test('numbers are written in their shortest form', () => {
  const random = new Random(8);
  for (let i = 0; i < 10_000; ++i) {
    const value = random.coordinate();
    assert.ok(Object.is(Number(numberText(value)), value + 0));
  }
  const expected = ['0', '1e+21', '7.888609052210118e-31', '-0.5', '10000', '1e+05', '0.001', '1e-04', '-2.5', 'inf', 'nan'];
  const values = [-0, 1e21, 2 ** -100, -0.5, 1e4, 1e5, 1e-3, 1e-4, -2.5, Infinity, NaN];
  assert.deepEqual(values.map(numberText), expected);
});

test('the domain around items lies outside them, also at the ends of the range', () => {
  const boxes = [[0, 0, 0, 0], [1e15, 1, 1e15, 1], [-(2 ** 99), 0, 2 ** 99, 1], [2 ** 80, 2 ** 80, 2 ** 80, 2 ** 80]];
  for (const [x0, y0, x1, y1] of boxes) {
    const [minX, minY, maxX, maxY] = items.domainAround([point(x0, y0), point(x1, y1)]);
    assert.ok(minX < x0 && minY < y0 && maxX > x1 && maxY > y1);
  }
  const end = 2 ** 100;
  assert.deepEqual(items.domainAround([point(-end, -end), point(end, end)]), [-end, -end, end, end]);
});

test('a large file takes a short time', () => {
  const corners = Array.from({ length: 400_000 }, (_, i) => `${i} ${i % 7}.5`).join(' ');
  const begin = performance.now();
  const world = parseFile('a.wws', bytesOf(`waywright 1\ndomain 0 0 400000 10\npolyline 1 400000 ${corners}\n`));
  assert.equal(world.items[0].points.length, 400_000);
  assert.ok(performance.now() - begin < 10_000);
});
