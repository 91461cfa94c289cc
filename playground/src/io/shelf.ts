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
    line: '600 squares that do not touch.',
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
    line: 'Walls share parts of their lines. poly2tri stops with "Collinear not supported".',
    load: horrors.overlaps,
  },
  {
    id: 'near-crossings',
    title: 'Almost one crossing',
    line: 'LINE',
    load: horrors.nearCrossings,
  },
  {
    id: 'circle',
    title: 'All points on a circle',
    line: 'LINE',
    load: horrors.circle,
  },
  {
    id: 'slivers',
    title: 'Slivers',
    line: 'LINE',
    load: horrors.slivers,
  },
  {
    id: 'neighbouring-doubles',
    title: 'Neighbouring doubles',
    line: 'LINE',
    load: horrors.neighbouringDoubles,
  },
  {
    id: 'identical',
    title: 'Identical polygons',
    line: 'LINE',
    load: horrors.identical,
  },
  {
    id: 'combs',
    title: 'Two combs',
    line: 'LINE',
    load: horrors.combs,
  },
  {
    id: 'nested',
    title: 'Nested contours',
    line: 'LINE',
    load: horrors.nested,
  },
  {
    id: 'star',
    title: 'A star that crosses itself',
    line: 'LINE',
    load: horrors.star,
  },
];
