// Scenes, scripts, scenarios and pictures.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import {
  ItemList, Scenario, Scene, sceneFormat, Script, Shape, svgFrame, SvgOverlay, svgToPicture, svgToWorld, World,
} from '../../bindings/wasm/dist/index.js';
import { at, DOMAIN, makeWorld, refuses } from './support.mjs';

const SCRIPT = `waywright 1
domain 0 0 100 100
segment 1 40 0 40 70
polygon 2 4 60 40 80 40 80 60 60 60
locate 5 5
path 10 70 50 40 0 ta
remove 1
hash
`;

test('a world script', () => {
  const script = new Script().parse(SCRIPT);
  assert.deepEqual(script.domain, DOMAIN);
  assert.equal(script.length, 6);
  const lines = Array.from({ length: 6 }, (_, i) => script.line(i));
  assert.deepEqual(lines.map(({ kind }) => kind), ['insert', 'insert', 'locate', 'path', 'remove', 'hash']);
  assert.deepEqual(lines.map(({ line }) => line), [3, 4, 5, 6, 7, 8]);
  assert.deepEqual([lines[0].word, lines[0].id, lines[3].algorithm, lines[3].from], ['segment', 1, 'ta', at(10, 70)]);
  const list = script.item(1);
  assert.deepEqual([...list.points(0)], [60, 40, 80, 40, 80, 60, 60, 60]);
  const scene = script.scene();
  assert.deepEqual([...scene.items].map(({ id }) => id), [2]);
  const world = new World(scene.domain);
  assert.deepEqual(world.insertAll(scene.items), [2]);
  assert.match(scene.toScript(), /^domain 0 0 100 100$/m);
});

test('a script with a fault', () => {
  const error = refuses('malformed', () => new Script().parse('waywright 1\ndomain 0 0 1 1\nsegment 1 0 0\n', 'my script'));
  assert.match(error.message, /my script:3/);
  assert.equal(error.index, 3);
});

test('the items of a scene are valid until it changes', () => {
  const scene = new Scene().set(DOMAIN, new ItemList([{ id: 5, shape: Shape.point(at(1, 1)) }]), true);
  const { items } = scene;
  assert.deepEqual([items.info(0).id, scene.yDown], [5, true]);
  scene.parseMovingaiMap('type octile\nheight 2\nwidth 3\nmap\n.@.\n...\n');
  refuses('disposed', () => items.length);
  assert.deepEqual(scene.domain, { min: at(0, 0), max: at(3, 2) });
  assert.equal(scene.items.length, 1);
  assert.equal(sceneFormat('a/b.map'), 'movingai');
});

test('files of Triangle', () => {
  const node = '4 2 0 0\n1 0 0\n2 4 0\n3 4 3\n4 0 3\n';
  assert.equal(new Scene().parseTriangleNode(node).items.length, 4);
  const poly = '0 2 0 0\n2 0\n1 1 2\n2 2 3\n0\n';
  const scene = new Scene().parseTrianglePoly(poly, 'a.poly', node, 'a.node');
  assert.ok([...scene.items].filter(({ shape }) => shape.kind === 'segment').length === 2);
  refuses('malformed', () => scene.parseTriangleNode('4 2 0 0\n1 0\n'));
});

test('a scenario of Moving AI', () => {
  const scenario = new Scenario().parse('version 1\n3\ta.map\t512\t256\t1\t2\t30\t40\t47.5\n');
  assert.equal(scenario.length, 1);
  const { map, width, height, start, goal, length } = scenario.query(0);
  assert.deepEqual([map, width, height, length], ['a.map', 512, 256, 47.5]);
  assert.ok(start.x > 0 && goal.x > start.x);
});

test('pictures', () => {
  const world = makeWorld({ keepBridges: true });
  const query = { start: at(10, 60), goal: at(50, 40), agent: { radius: 2 } };
  const overlay = new SvgOverlay()
    .addPath(world.findPath({ ...query, agent: {} }))
    .addDiscPath(query, world.findPath(query))
    .addFailedPath(at(1, 1), at(2, 2), 'no-path')
    .addRay(at(1, 1), at(99, 1), world.ray(at(1, 1), at(99, 1)))
    .addLocation(at(70, 45), world.locate(at(70, 45)))
    .addDisc(at(20, 20), 3, { colour: '#123456', hint: 'a disc' })
    .addPolyline([1, 2, 3, 4], 2, { dashed: true })
    .addLabel(at(30, 30), 'a label äö', 4)
    .addKey('a key', 'red')
    .addElements('<circle r="17"/>');
  const svg = world.toSvg(overlay, { title: 'A title', theme: 'dark', width: 600, ids: false });
  for (const text of ['#123456', 'a disc', 'a label äö', 'a key', '<circle r="17"/>', 'A title']) {
    assert.ok(svg.includes(text), text);
  }
  assert.ok(!overlay.clear().addKey('other', 'red').isDisposed);
  assert.ok(!world.toSvg(overlay).includes('a key'));
  const crop = { min: at(10, 10), max: at(20, 20) };
  const frame = svgFrame(DOMAIN, { width: 400, crop });
  assert.deepEqual(frame.shown, crop);
  const pixels = svgToPicture(frame, at(12, 14));
  const back = svgToWorld(frame, pixels);
  assert.ok(Math.hypot(back.x - 12, back.y - 14) < 1e-9);
});
