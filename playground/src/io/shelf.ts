import highground from '../../../examples/maps/highground.wws?raw';
import { readWws } from './read_wws';
import * as horrors from './shelf_horrors';
import * as scenes from './shelf_scenes';
import type { ParsedWorld } from './types';

export interface Example {
  readonly id: string;
  readonly title: string;
  /** One sentence for the list of examples. */
  readonly line: string;
  load(): ParsedWorld;
}

/** The bundled map, with a query from the middle of one base to the middle of the other. */
function arena(): ParsedWorld {
  return { ...readWws(highground), start: [90, 80], goal: [422, 304], radius: 2 };
}

// What other libraries do was measured in Node with poly2tri 1.5.0, cdt2d 1.0.0, earcut 3.2.4, Delaunator 5.1.0 and
// Constrainautor 4.1.0, which got the corners and sides of the items without preparation. Several of them document that they
// want sides without crossings and points without repetition.
export const examples: readonly Example[] = [
  {
    id: 'arena',
    title: 'Highground',
    line: 'A map for two players: cliffs, a river with bridges, forests and walls.',
    load: arena,
  },
  {
    id: 'city',
    title: 'City',
    line: 'Two districts whose streets meet at an angle, with courtyards, gates, narrow alleys and parks.',
    load: scenes.city,
  },
  {
    id: 'labyrinth',
    title: 'Labyrinth',
    line: 'Long dead ends and few loops: searches on the abstraction skip the dead ends.',
    load: scenes.labyrinth,
  },
  {
    id: 'gaps',
    title: 'A gap of exactly 2r',
    line: 'The lower gap is narrower than the disc by one unit in the last place; the upper gap fits exactly.',
    load: scenes.gaps,
  },
  {
    id: 'squares',
    title: 'Random squares',
    line: 'Scenes like those of the thesis: 600 squares that do not touch.',
    load: scenes.squares,
  },
  {
    id: 'random-constraints',
    title: 'Random constraints',
    line: 'Experiment 5 of the thesis: 200 random segments with thousands of crossings.',
    load: scenes.randomSegments,
  },
  {
    id: 'survival',
    title: 'What survives',
    line: '40 segments on a lattice, every second one removed again: with doubles, 23 of 1,000 such scenes failed.',
    load: scenes.survival,
  },
  {
    id: 'moving-square',
    title: 'The moving square',
    line: 'Experiment 6 of the thesis: nine nested squares, and a small one to move through them.',
    load: scenes.movingSquare,
  },
  {
    id: 'overlaps',
    title: 'Collinear overlaps',
    line: 'Walls share parts of their lines. poly2tri, Constrainautor and cdt2d end with errors.',
    load: horrors.overlaps,
  },
  {
    id: 'near-crossings',
    title: 'Almost one crossing',
    line: '48 walls cross in almost one point. cdt2d wants the crossings beforehand, and loses 45 walls without an error.',
    load: horrors.nearCrossings,
  },
  {
    id: 'circle',
    title: 'All points on a circle',
    line: '324 points on one circle: every in-circle test is 0. In plain doubles, 19 % of these tests are wrong.',
    load: horrors.circle,
  },
  {
    id: 'slivers',
    title: 'Slivers',
    line: 'Triangles 10^15 long and 2^-99 wide. cdt2d loses half of the walls, and poly2tri throws an error.',
    load: horrors.slivers,
  },
  {
    id: 'neighbouring-doubles',
    title: 'Neighbouring doubles',
    line: '225 points, each the next double of its neighbour. Delaunator drops 15 of them without an error.',
    load: horrors.neighbouringDoubles,
  },
  {
    id: 'identical',
    title: 'Identical polygons',
    line: 'One polygon 60 times, in both directions. poly2tri does not take a point twice, and throws an error.',
    load: horrors.identical,
  },
  {
    id: 'combs',
    title: 'Two combs',
    line: 'Two combs with gaps of 1/32 between their 400 teeth. The disc fits exactly.',
    load: horrors.combs,
  },
  {
    id: 'nested',
    title: 'Nested contours',
    line: '50 rings in each other, and squares that touch in points. earcut finds 1,548 of the 5,100 units of area.',
    load: horrors.nested,
  },
  {
    id: 'star',
    title: 'A star that crosses itself',
    line: '31 sides that all cross each other, with both fill rules. earcut is wrong by 89 % of the area.',
    load: horrors.star,
  },
];
