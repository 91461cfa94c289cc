import { Random, rounded } from './numbers';
import { operationsOf } from './wws';
import type { Domain, Item, Operation, ParsedWorld, XY } from './types';

export const square = (x: number, y: number, reach: number): XY[] => [
  [x - reach, y - reach],
  [x + reach, y - reach],
  [x + reach, y + reach],
  [x - reach, y + reach],
];
export const polygon = (...rings: XY[][]): Item => ({ kind: 'polygon', rings });
export const segment = (a: XY, b: XY): Item => ({ kind: 'segment', points: [a, b] });

/** A frame of streets: its origin, and the direction of its first axis. */
interface Frame {
  readonly origin: XY;
  readonly axis: XY;
}

type Rectangle = readonly [u0: number, v0: number, u1: number, v1: number];

const CITY: Domain = [0, 0, 1200, 900];
const CITY_MARGIN = 12;
// The boulevard: the line 5 x + 12 y = 13 * BOULEVARD. (5, 12) has the length 13.
const BOULEVARD = 640;
const BOULEVARD_WIDTH = 44;

/** Returns the distance of a point from the boulevard. It is positive above. */
function aboveBoulevard([x, y]: XY): number {
  return (5 * x + 12 * y) / 13 - BOULEVARD;
}

/** Makes the blocks of a city. */
class City {
  readonly items: Item[] = [];
  private readonly random = new Random(2009);

  private at({ origin, axis }: Frame, u: number, v: number): XY {
    const x = origin[0] + u * axis[0] - v * axis[1];
    return [rounded(x, 4), rounded(origin[1] + u * axis[1] + v * axis[0], 4)];
  }

  private ring(frame: Frame, corners: readonly XY[]): XY[] {
    return corners.map(([u, v]) => this.at(frame, u, v));
  }

  private rectangle(frame: Frame, [u0, v0, u1, v1]: Rectangle): XY[] {
    return this.ring(frame, [[u0, v0], [u1, v0], [u1, v1], [u0, v1]]);
  }

  /** Adds the blocks of a frame that `accepts`. */
  district(frame: Frame, accepts: (corner: XY) => boolean): void {
    const [width, depth, street] = [64, 46, 14];
    for (let row = -16; row < 16; ++row) {
      for (let column = -16; column < 20; ++column) {
        const [u, v] = [column * (width + street), row * (depth + street)];
        const block: Rectangle = [u, v, u + width, v + depth];
        if (this.rectangle(frame, block).every((corner) => isInCity(corner) && accepts(corner))) this.block(frame, block);
      }
    }
  }

  private block(frame: Frame, block: Rectangle): void {
    const kinds = [this.solid, this.courtyard, this.courtyard, this.gate, this.gate, this.alleys, this.park];
    kinds[this.random.below(kinds.length)]!.call(this, frame, block);
  }

  private solid(frame: Frame, [u0, v0, u1, v1]: Rectangle): void {
    const cut = this.random.between(4, 16);
    const corners: XY[] = [[u0, v0], [u1, v0], [u1, v1 - cut], [u1 - cut, v1], [u0, v1]];
    this.items.push(polygon(this.ring(frame, corners)));
  }

  /** A closed courtyard, with a house in it. */
  private courtyard(frame: Frame, block: Rectangle): void {
    const [u0, v0, u1, v1] = block;
    const depth = this.random.between(8, 12);
    const yard: Rectangle = [u0 + depth, v0 + depth, u1 - depth, v1 - depth];
    this.items.push(polygon(this.rectangle(frame, block), this.rectangle(frame, yard)));
    this.items.push(polygon(this.rectangle(frame, [u0 + 26, v0 + 18, u0 + 26 + this.random.between(4, 12), v0 + 28])));
  }

  /** A courtyard with a gate. */
  private gate(frame: Frame, [u0, v0, u1, v1]: Rectangle): void {
    const depth = this.random.between(8, 12);
    const [a, b] = [u0 + 24, u0 + 24 + this.random.between(3, 12)];
    const corners: XY[] = [
      [u0, v0], [a, v0], [a, v0 + depth], [u0 + depth, v0 + depth], [u0 + depth, v1 - depth], [u1 - depth, v1 - depth],
      [u1 - depth, v0 + depth], [b, v0 + depth], [b, v0], [u1, v0], [u1, v1], [u0, v1],
    ];
    this.items.push(polygon(this.ring(frame, corners)));
  }

  /** Three rows of houses, with narrow alleys between them. */
  private alleys(frame: Frame, [u0, v0, u1, v1]: Rectangle): void {
    const alley = this.random.between(2, 5);
    const width = (u1 - u0 - 2 * alley) / 3;
    for (let i = 0; i < 3; ++i) {
      const u = u0 + i * (width + alley);
      this.items.push(polygon(this.rectangle(frame, [u, v0, u + width, v1 - this.random.below(9)])));
    }
  }

  /** A park: a fence with a gate, and trees. */
  private park(frame: Frame, [u0, v0, u1, v1]: Rectangle): void {
    const fence: XY[] = [[u0 + 20, v0], [u0, v0], [u0, v1], [u1, v1], [u1, v0], [u0 + 30, v0]];
    this.items.push({ kind: 'polyline', points: this.ring(frame, fence) });
    for (let i = 0; i < 9; ++i) {
      const [u, v] = [u0 + 6 + (i % 3) * 24 + this.random.below(5), v0 + 6 + Math.floor(i / 3) * 15 + this.random.below(5)];
      const [x, y] = this.at(frame, u, v);
      this.items.push(polygon([[x - 1, y], [x, y - 1], [x + 1, y], [x, y + 1]]));
    }
  }
}

function isInCity([x, y]: XY): boolean {
  const [minX, minY, maxX, maxY] = CITY;
  return x >= minX + CITY_MARGIN && x <= maxX - CITY_MARGIN && y >= minY + CITY_MARGIN && y <= maxY - CITY_MARGIN;
}

/** A city of two districts whose streets meet at an angle. */
export function city(): ParsedWorld {
  const made = new City();
  const half = BOULEVARD_WIDTH / 2;
  made.district({ origin: [14, 14], axis: [1, 0] }, (corner) => aboveBoulevard(corner) < -half);
  made.district({ origin: [600, 470], axis: [12 / 13, -5 / 13] }, (corner) => aboveBoulevard(corner) > half);
  return { items: made.items, domain: CITY, start: [5, 5], goal: [1190, 890], radius: 1.5 };
}

const SQUARES: Domain = [0, 0, 4096, 4096];

/** Random squares that do not touch. */
export function squares(): ParsedWorld {
  const random = new Random(7);
  const taken: { readonly x: number; readonly y: number; readonly reach: number }[] = [];
  while (taken.length < 600) {
    const [x, y, reach] = [random.between(160, 3936), random.between(160, 3936), random.between(20, 80)];
    const touches = taken.some((other) => {
      const least = reach + other.reach;
      return Math.abs(x - other.x) <= least && Math.abs(y - other.y) <= least;
    });
    if (!touches) taken.push({ x, y, reach });
  }
  const items = taken.map(({ x, y, reach }) => polygon(square(x, y, reach)));
  return { items, domain: SQUARES, start: [60, 60], goal: [4036, 4036], radius: 8 };
}

/** Random segments that cross each other. */
export function randomSegments(): ParsedWorld {
  const random = new Random(53);
  const point = (): XY => [random.between(-8000, 8000), random.between(-8000, 8000)];
  const items = Array.from({ length: 200 }, () => segment(point(), point()));
  return { items, domain: [-9000, -9000, 9000, 9000], start: [-8900, -8900], goal: [8900, 8900] };
}

/** Segments between the points of a lattice, of which every second one is removed again. */
export function survival(): ParsedWorld {
  const random = new Random(40);
  const point = (): XY => [random.below(13), random.below(13)];
  const items = Array.from({ length: 40 }, () => segment(point(), point()));
  const operations: Operation[] = [...operationsOf({ items })];
  for (let id = 2; id <= items.length; id += 2) operations.push({ kind: 'remove', id });
  const ids = items.map((_, i) => i + 1).filter((id) => id % 2 === 1);
  const left = ids.map((id) => items[id - 1]!);
  return { items: left, ids, operations, domain: [-1, -1, 13, 13], start: [-0.5, -0.5], goal: [12.5, 12.5] };
}

/** Nine nested squares, and a small square on its corner that the thesis moves through them. */
export function movingSquare(): ParsedWorld {
  const items = Array.from({ length: 9 }, (_, i) => polygon(square(0, 0, 10_000 * (i + 1))));
  const [at, arm] = [5000, 700];
  items.push(polygon([[at, at + arm], [at - arm, at], [at, at - arm], [at + arm, at]]));
  return { items, domain: [-100_000, -100_000, 100_000, 100_000], start: [-95_000, -95_000], goal: [95_000, 95_000] };
}

const MAZE = { columns: 48, rows: 32, cell: 10 };

/** Which cells are connected: `right[cell]` to the right, `up[cell]` upwards. */
function carve(random: Random): { readonly right: boolean[]; readonly up: boolean[] } {
  const { columns, rows } = MAZE;
  const flags = (): boolean[] => new Array<boolean>(columns * rows).fill(false);
  const [right, up, seen] = [flags(), flags(), flags()];
  const open = (a: number, b: number): void => {
    (Math.abs(a - b) === 1 ? right : up)[Math.min(a, b)] = true;
  };
  const neighbours = (cell: number): number[] => {
    const [x, y] = [cell % columns, Math.floor(cell / columns)];
    const all = [x > 0 ? cell - 1 : -1, x + 1 < columns ? cell + 1 : -1, cell - columns, y + 1 < rows ? cell + columns : -1];
    return all.filter((other) => other >= 0);
  };
  const stack = [0];
  seen[0] = true;
  while (stack.length > 0) {
    const cell = stack[stack.length - 1]!;
    const free = neighbours(cell).filter((other) => !seen[other]);
    if (free.length === 0) {
      stack.pop();
      continue;
    }
    const next = free[random.below(free.length)]!;
    open(cell, next);
    seen[next] = true;
    stack.push(next);
  }
  for (let i = 0; i < 24; ++i) {
    const cell = random.below(columns * rows);
    open(cell, neighbours(cell)[0]!);
  }
  return { right, up };
}

/** Returns the segments of the walls along one line: neighbouring walls become one. */
function runs(length: number, isWall: (i: number) => boolean, at: (i: number) => XY): Item[] {
  const items: Item[] = [];
  let first = -1;
  for (let i = 0; i <= length; ++i) {
    const wall = i < length && isWall(i);
    if (wall && first < 0) first = i;
    if (wall || first < 0) continue;
    items.push(segment(at(first), at(i)));
    first = -1;
  }
  return items;
}

/** A labyrinth with a few loops. */
export function labyrinth(): ParsedWorld {
  const { columns, rows, cell } = MAZE;
  const { right, up } = carve(new Random(1979));
  const items: Item[] = [];
  for (let y = 1; y < rows; ++y) {
    items.push(...runs(columns, (x) => !up[(y - 1) * columns + x], (x) => [x * cell, y * cell]));
  }
  for (let x = 1; x < columns; ++x) {
    items.push(...runs(rows, (y) => !right[y * columns + x - 1], (y) => [x * cell, y * cell]));
  }
  const domain: Domain = [0, 0, columns * cell, rows * cell];
  return { items, domain, start: [5, 5], goal: [domain[2] - 5, domain[3] - 5], radius: 3 };
}

/** A gap whose width is the double below 2, and a gap of exactly 2, for a disc with the radius 1. */
export function gaps(): ParsedWorld {
  const below2 = 2 - 2 ** -52;
  const items = [segment([0, -6], [0, 0]), segment([0, below2], [0, 4]), segment([0, 6], [0, 12])];
  return { items, domain: [-10, -6, 10, 12], start: [-5, 1], goal: [5, 1], radius: 1 };
}
