// usage: worlds_in_node.mjs EXPORT_CHANGES PRINT_MESHES
// Runs the 200 worlds with the package, and compares all meshes, hashes and paths with those of the native program.
import { execFileSync } from 'node:child_process';

import { init } from '../../bindings/wasm/dist/index.js';
import { worldText } from './worlds.mjs';

const [exportChanges, printMeshes] = process.argv.slice(2);
const run = (program) => execFileSync(program, { encoding: 'utf8', maxBuffer: 2 ** 30 });
const worlds = run(exportChanges).trimEnd().split('\n');
const expected = run(printMeshes);
await init();
let at = 0;
for (const line of worlds) {
  const text = worldText(line);
  if (expected.slice(at, at + text.length) !== text) {
    const lines = text.split('\n');
    const native = expected.slice(at, at + text.length).split('\n');
    const first = lines.findIndex((each, i) => each !== native[i]);
    console.error(`${lines[0]}, line ${first + 1}:\nhere   ${lines[first]}\nnative ${native[first]}`);
    process.exit(1);
  }
  at += text.length;
}
if (at !== expected.length || worlds.length !== 200) {
  console.error(`${worlds.length} worlds, ${at} characters of ${expected.length}`);
  process.exit(1);
}
console.log(`${worlds.length} worlds, ${at} equal characters`);
