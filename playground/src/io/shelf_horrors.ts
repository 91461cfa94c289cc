import { onCircle, Random, rounded } from './numbers';
import { polygon, segment, square } from './shelf_scenes';
import type { Item, ParsedWorld, XY } from './types';

const SIZE = 100;

/** Segments that lie on few lines and overlap, and points on them. */
export function overlaps(): ParsedWorld {
  const random = new Random(11);
  // Each line by a point and a step.
  const lines: readonly (readonly [XY, XY])[] = [
    [[0, 50], [4, 0]],
    [[2, 2], [4, 4]],
    [[1, 90], [3, -2]],
    [[98, 1], [-1, 4]],
  ];
  const items: Item[] = [];
  for (let i = 0; i < 96; ++i) {
    const [[x, y], [dx, dy]] = lines[i % lines.length]!;
    const [a, b] = [random.below(24), random.below(24)];
    const at = (k: number): XY => [x + k * dx, y + k * dy];
    items.push(i % 8 === 7 ? { kind: 'point', xy: at(a) } : segment(at(a), at(b)));
  }
  items.push(polygon(square(70, 20, 10)), polygon(square(90, 20, 10)), polygon(square(80, 36, 6)));
  return { items, domain: [-10, -10, 110, 110], start: [-5, -5], goal: [105, 105] };
}

/** Segments through almost the same point: their ends differ from the exact ones by a few doubles. */
export function nearCrossings(): ParsedWorld {
  const random = new Random(12);
  const ulp = 2 ** -46; // of numbers from 64 to 128
  const items = Array.from({ length: 48 }, (_, i) => {
    const [dx, dy]: XY = i < 24 ? [SIZE, 8 * i - SIZE] : [SIZE - 8 * (i - 24), SIZE];
    const shift = (): number => random.between(-3, 3) * ulp;
    return segment([dx + shift(), dy + shift()], [-dx + shift(), -dy + shift()]);
  });
  return { items, domain: [-128, -128, 128, 128], start: [-120, -10], goal: [120, 10] };
}

/** All 324 points with whole coordinates on the circle with the radius 5 * 13 * 17 * 29. */
export function circle(): ParsedWorld {
  const radius = 5 * 13 * 17 * 29;
  const items: Item[] = [];
  for (let x = -radius; x <= radius; ++x) {
    const y = Math.round(Math.sqrt(radius * radius - x * x));
    if (x * x + y * y !== radius * radius) continue;
    items.push({ kind: 'point', xy: [x, y] });
    if (y !== 0) items.push({ kind: 'point', xy: [x, -y] });
  }
  const end = 40_000;
  return { items, domain: [-end, -end, end, end], start: [-39_000, -39_000], goal: [39_000, 39_000] };
}

/** Triangles that are 10^15 long, and as thin as a world allows. */
export function slivers(): ParsedWorld {
  const [long, tiny] = [1e15, 2 ** -100];
  const items = [
    polygon([[0, 0], [long, -tiny], [long, tiny]]),
    polygon([[0, 1], [long, 1], [long, 1 + 2 ** -52]]),
    polygon([[tiny, -1], [long, -1], [3 * tiny, -1 + 2 ** -53]]),
    segment([-tiny, -tiny], [tiny, tiny]),
  ];
  for (let k = 1; k < 9; ++k) items.push(segment([k * 1e14 + 0.25, -2], [k * 1e14 + 0.5, 2]));
  // The needles' points, and the ends in the lane of 2^-100 to 1 between two needles.
  return { items, domain: [-long, -long, 2 * long, long], start: [-1, -2], goal: [2.5, 0.5], view: [-2, -3, 4, 3] };
}

/** 225 points of which each has the next double as its neighbour, and walls between them. */
export function neighbouringDoubles(): ParsedWorld {
  const at = (i: number, j: number): XY => [1 + i * 2 ** -52, 1 + j * 2 ** -52];
  const items: Item[] = Array.from({ length: 225 }, (_, k) => ({ kind: 'point', xy: at(k % 15, Math.floor(k / 15)) }));
  items.push(segment(at(0, 0), at(14, 13)), segment(at(0, 14), at(13, 0)), segment(at(0, 7), at(14, 8)));
  items.push(polygon([at(2, 2), at(12, 3), at(11, 12), at(3, 11)]));
  const [start, goal] = [at(-3, -2), at(17, 16)];
  return { items, domain: [0, 0, 2, 2], start, goal, view: [...at(-5, -5), ...at(19, 19)] };
}

/** The same polygon 60 times: from other first corners, and in the other direction. */
export function identical(): ParsedWorld {
  const ring = Array.from({ length: 12 }, (_, i): XY => {
    const [x, y] = onCircle(i / 12);
    return [rounded(40 * x, 10), rounded(40 * y, 10)];
  });
  const items = Array.from({ length: 60 }, (_, i) => {
    const turned = [...ring.slice(i % 12), ...ring.slice(0, i % 12)];
    return polygon(i % 2 === 0 ? turned : turned.reverse());
  });
  return { items, domain: [-60, -60, 60, 60], start: [-50, -50], goal: [50, 50] };
}

/** A comb of 200 teeth, and a second comb whose teeth are between them with gaps of 1/64. */
export function combs(): ParsedWorld {
  const [teeth, gap] = [200, 1 / 64];
  const comb = (base: number, root: number, tip: number, shift: number): Item => {
    const ring: XY[] = [[2 * teeth, root], [2 * teeth, base], [0, base], [0, root]];
    for (let i = 0; i < teeth; ++i) {
      const [x0, x1] = [2 * i + shift + gap, 2 * i + shift + 1 - gap];
      ring.push([x0, root], [x0, tip], [x1, tip], [x1, root]);
    }
    return polygon(ring);
  };
  const items = [comb(0, 5, 75, 0), comb(100, 95, 25, 1)];
  return { items, domain: [-20, 0, 2 * teeth + 20, 100], start: [-10, 50], goal: [2 * teeth + 10, 50], radius: 1 / 64 };
}

/** One polygon of 50 nested rings, and nested polygons that touch each other in points. */
export function nested(): ParsedWorld {
  const rings = Array.from({ length: 50 }, (_, i) => square(0, 0, 50 - i));
  const items: Item[] = [polygon(...rings)];
  for (let reach = 64; reach >= 1; reach /= 2) {
    items.push(polygon(square(130, 0, reach)), polygon([[130 + reach, 0], [130, reach], [130 - reach, 0], [130, -reach]]));
  }
  return { items, domain: [-70, -80, 210, 80], start: [-65, -75], goal: [205, 75] };
}

/** A star that crosses itself, with both fill rules. */
export function star(): ParsedWorld {
  const [corners, step] = [31, 14];
  const ring = (centre: number): XY[] =>
    Array.from({ length: corners }, (_, i): XY => {
      const [x, y] = onCircle(((i * step) % corners) / corners);
      return [rounded(centre + 45 * x, 100), rounded(45 * y, 100)];
    });
  const items: Item[] = [polygon(ring(-50)), { kind: 'polygon', rings: [ring(50)], fill: 'nonzero' }];
  return { items, domain: [-110, -60, 110, 60], start: [-100, 0], goal: [100, 0] };
}
