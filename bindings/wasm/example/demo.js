// The world of the example. main.js uses it directly, worker.js in a worker.
import { init, Mesh, Path, Shape, World } from '../dist/index.js';

const WIDTH = 800;
const HEIGHT = 600;
const RADIUS = 12;
const START = { x: 40, y: 40 };

export class Demo {
  static async create() {
    await init();
    return new Demo();
  }

  constructor() {
    this.world = new World({ min: { x: 0, y: 0 }, max: { x: WIDTH, y: HEIGHT } }, { keepBridges: true });
    this.world.insertSegment({ x: 200, y: 0 }, { x: 200, y: 400 });
    this.world.insertPolyline([300, 600, 330, 260, 480, 200]);
    for (let i = 0; i < 12; ++i) {
      const centre = { x: 420 + 110 * (i % 4), y: 130 + 160 * Math.floor(i / 4) };
      this.world.insert(Shape.regularPolygon(centre, 25 + 2 * i, 3 + i));
    }
    this.path = new Path();
    this.points = new Float64Array(1024);
  }

  /** The walls: x, y of the two ends of each. */
  walls() {
    const mesh = this.world.snapshot(new Mesh());
    const [vertices, edges] = [mesh.vertices(), mesh.constrainedEdges()];
    mesh.dispose();
    const walls = new Float64Array(edges.length);
    for (let i = 0; i < edges.length; i += 4) {
      walls.set(vertices.subarray(2 * edges[i], 2 * edges[i] + 2), i);
      walls.set(vertices.subarray(2 * edges[i + 1], 2 * edges[i + 1] + 2), i + 2);
    }
    return walls;
  }

  /** The path to a point as a polyline, and its length. Both are empty if there is no path. */
  pathTo(goal) {
    this.world.findPath({ start: START, goal, agent: { radius: RADIUS } }, this.path);
    if (!this.path.isFound) return { length: 0, points: new Float64Array(0) };
    return { length: this.path.length, points: this.path.polyline(0.25, this.points).slice() };
  }
}
