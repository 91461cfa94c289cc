// Draws the walls and the path to the mouse.
import { Demo } from './demo.js';

/** The same functions as Demo, answered by a worker. */
class RemoteDemo {
  constructor() {
    this.worker = new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
    this.waiting = new Map();
    this.worker.onmessage = ({ data: { id, answer } }) => {
      this.waiting.get(id)(answer);
      this.waiting.delete(id);
    };
    this.last = 0;
  }
  ask(goal) {
    const id = ++this.last;
    this.worker.postMessage({ id, goal });
    return new Promise((resolve) => this.waiting.set(id, resolve));
  }
  walls() {
    return this.ask();
  }
  pathTo(goal) {
    return this.ask(goal);
  }
}

const canvas = document.querySelector('canvas');
const status = document.querySelector('#status');
const context = canvas.getContext('2d');
const isRemote = new URLSearchParams(location.search).has('worker');
const demo = isRemote ? new RemoteDemo() : await Demo.create();
const walls = await demo.walls();

function drawWalls() {
  context.beginPath();
  for (let i = 0; i < walls.length; i += 4) {
    context.moveTo(walls[i], walls[i + 1]);
    context.lineTo(walls[i + 2], walls[i + 3]);
  }
  context.strokeStyle = '#333';
  context.lineWidth = 2;
  context.stroke();
}

function drawPath(points) {
  context.beginPath();
  for (let i = 0; i < points.length; i += 2) context.lineTo(points[i], points[i + 1]);
  context.strokeStyle = '#06c';
  context.lineWidth = 3;
  context.stroke();
}

async function show(goal) {
  const { length, points } = await demo.pathTo(goal);
  context.clearRect(0, 0, canvas.width, canvas.height);
  drawWalls();
  drawPath(points);
  status.textContent = length > 0 ? `a path of length ${length.toFixed(1)}` : 'no path';
}

canvas.addEventListener('pointermove', (event) => {
  const scale = canvas.width / canvas.clientWidth;
  const x = Math.min(Math.max(event.offsetX * scale, 0), canvas.width);
  const y = Math.min(Math.max(event.offsetY * scale, 0), canvas.height);
  void show({ x, y });
});
status.textContent = 'move the mouse over the canvas';
drawWalls();
