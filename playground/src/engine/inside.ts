// What the page shows of the inside of a world. It computes components and corridors from a copy of the mesh.
import { Mesh, type World } from 'waywright';
import { type BridgesAnswer, LEVEL, type MeshAnswer } from './protocol';

/** For each edge of each triangle: the triangle beyond the edge, -1 for none, -2 if the edge is a wall. */
interface Adjacency {
  readonly neighbours: Int32Array;
  readonly freeEdges: Uint32Array;
}

const WALL = -2;

function edgeKey(a: number, b: number, vertexCount: number): number {
  return a < b ? a * vertexCount + b : b * vertexCount + a;
}

function findNeighbours(triangles: Uint32Array, walls: Uint32Array, vertexCount: number): Adjacency {
  const neighbours = new Int32Array(triangles.length).fill(-1);
  const isWall = new Set<number>();
  for (let i = 0; i < walls.length; i += 4) isWall.add(edgeKey(walls[i]!, walls[i + 1]!, vertexCount));
  const open = new Map<number, number>();
  const edges: number[] = [];
  for (let side = 0; side < triangles.length; ++side) {
    const next = side % 3 === 2 ? side - 2 : side + 1;
    const key = edgeKey(triangles[side]!, triangles[next]!, vertexCount);
    if (isWall.has(key)) {
      neighbours[side] = WALL;
      continue;
    }
    const other = open.get(key);
    if (other === undefined) {
      open.set(key, side);
      edges.push(triangles[side]!, triangles[next]!);
      continue;
    }
    neighbours[side] = Math.floor(other / 3);
    neighbours[other] = Math.floor(side / 3);
    open.delete(key);
  }
  return { neighbours, freeEdges: Uint32Array.from(edges) };
}

/** Numbers the triangles that edges without walls connect. */
function numberComponents(neighbours: Int32Array): { numbers: Int32Array; firsts: number[] } {
  const numbers = new Int32Array(neighbours.length / 3).fill(-1);
  const firsts: number[] = [];
  const stack: number[] = [];
  for (let first = 0; first < numbers.length; ++first) {
    if (numbers[first] !== -1) continue;
    numbers[first] = firsts.length;
    stack.push(first);
    while (stack.length > 0) {
      const face = stack.pop()!;
      for (let k = 0; k < 3; ++k) {
        const next = neighbours[3 * face + k]!;
        if (next < 0 || numbers[next] !== -1) continue;
        numbers[next] = firsts.length;
        stack.push(next);
      }
    }
    firsts.push(first);
  }
  return { numbers, firsts };
}

/** The triangle of each component with the largest area: its centroid is safe from rounding. */
function largestFaces(vertices: Float64Array, triangles: Uint32Array, numbers: Int32Array, count: number): Int32Array {
  const best = new Int32Array(count);
  const areas = new Float64Array(count).fill(-1);
  for (let face = 0; face < numbers.length; ++face) {
    const [a, b, c] = [2 * triangles[3 * face]!, 2 * triangles[3 * face + 1]!, 2 * triangles[3 * face + 2]!];
    const [x, y] = [vertices[a]!, vertices[a + 1]!];
    const area = Math.abs(
      (vertices[b]! - x) * (vertices[c + 1]! - y) - (vertices[c]! - x) * (vertices[b + 1]! - y),
    );
    const number = numbers[face]!;
    if (area <= areas[number]!) continue;
    areas[number] = area;
    best[number] = face;
  }
  return best;
}

/** Gives the triangles under polygons the number -1, and numbers the other components anew. */
function leaveOutCovered(
  world: World, vertices: Float64Array, triangles: Uint32Array, numbers: Int32Array, count: number,
): number {
  const faces = largestFaces(vertices, triangles, numbers, count);
  const renumbered = new Int32Array(count);
  let free = 0;
  for (let i = 0; i < count; ++i) {
    const [a, b, c] = [0, 1, 2].map((k) => 2 * triangles[3 * faces[i]! + k]!) as [number, number, number];
    const x = (vertices[a]! + vertices[b]! + vertices[c]!) / 3;
    const y = (vertices[a + 1]! + vertices[b + 1]! + vertices[c + 1]!) / 3;
    renumbered[i] = world.locate({ x, y }).polygons.length > 0 ? -1 : free++;
  }
  for (let face = 0; face < numbers.length; ++face) numbers[face] = renumbered[numbers[face]!]!;
  return free;
}

/** Removes dead ends again and again. A triangle that is left is in a corridor (two passages) or at a junction (three). */
function findLevels(neighbours: Int32Array, components: Int32Array): Uint8Array {
  const count = components.length;
  const levels = new Uint8Array(count);
  const degrees = new Uint8Array(count);
  const leaves: number[] = [];
  for (let face = 0; face < count; ++face) {
    if (components[face]! < 0) continue;
    levels[face] = LEVEL.junction;
    for (let k = 0; k < 3; ++k) if (neighbours[3 * face + k]! >= 0) ++degrees[face]!;
    if (degrees[face]! <= 1) leaves.push(face);
  }
  while (leaves.length > 0) {
    const face = leaves.pop()!;
    if (levels[face] === LEVEL.deadEnd) continue;
    levels[face] = LEVEL.deadEnd;
    for (let k = 0; k < 3; ++k) {
      const next = neighbours[3 * face + k]!;
      if (next < 0 || levels[next] !== LEVEL.junction) continue;
      if (--degrees[next]! <= 1) leaves.push(next);
    }
  }
  for (let face = 0; face < count; ++face) {
    if (levels[face] === LEVEL.junction && degrees[face] === 2) levels[face] = LEVEL.corridor;
  }
  return levels;
}

export function listBridges(world: World): BridgesAnswer {
  const numbers = world.bridges(world.domain).flatMap(({ from, to, radius }) => [from.x, from.y, to.x, to.y, radius]);
  return { version: world.version, bridges: Float64Array.from(numbers) };
}

let copy: Mesh | null = null;

export function lookInside(world: World): MeshAnswer {
  copy = world.snapshot(copy ?? new Mesh());
  const vertices = copy.vertices();
  const triangles = copy.triangles();
  const { neighbours, freeEdges } = findNeighbours(triangles, copy.constrainedEdges(), vertices.length / 2);
  const { numbers, firsts } = numberComponents(neighbours);
  const componentCount = leaveOutCovered(world, vertices, triangles, numbers, firsts.length);
  const levels = findLevels(neighbours, numbers);
  return { version: world.version, vertices, triangles, edges: freeEdges, components: numbers, componentCount, levels };
}
