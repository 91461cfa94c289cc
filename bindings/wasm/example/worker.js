// Answers the questions of main.js: the walls, or the path to a goal.
import { Demo } from './demo.js';

const creation = Demo.create();

self.onmessage = async ({ data: { id, goal } }) => {
  const demo = await creation;
  self.postMessage({ id, answer: goal === undefined ? demo.walls() : demo.pathTo(goal) });
};
