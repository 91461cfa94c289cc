// Lets Node load the modules of the page: TypeScript without types, names without an ending, and texts by `?raw`.
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { fileURLToPath, pathToFileURL } from 'node:url';

// WAYWRIGHT_TYPESCRIPT names another folder with the package typescript in its node_modules.
const modules = process.env.WAYWRIGHT_TYPESCRIPT ?? fileURLToPath(new URL('../../', import.meta.url));
const typescript = createRequire(pathToFileURL(`${modules}/package.json`))('typescript');

export async function resolve(specifier, context, next) {
  if (specifier.endsWith('?raw')) return { url: new URL(specifier, context.parentURL).href, shortCircuit: true };
  if (specifier.startsWith('.') && context.parentURL?.endsWith('.ts')) {
    const url = new URL(`${specifier}.ts`, context.parentURL);
    if (existsSync(url)) return { url: url.href, shortCircuit: true };
  }
  return next(specifier, context);
}

export async function load(url, context, next) {
  const isRaw = url.endsWith('?raw');
  if (!isRaw && !url.endsWith('.ts')) return next(url, context);
  const text = readFileSync(fileURLToPath(url.replace(/\?raw$/, '')), 'utf8');
  if (isRaw) return { format: 'module', source: `export default ${JSON.stringify(text)};`, shortCircuit: true };
  const options = { module: typescript.ModuleKind.ESNext, target: typescript.ScriptTarget.ES2022 };
  const { outputText } = typescript.transpileModule(text, { compilerOptions: options, fileName: fileURLToPath(url) });
  return { format: 'module', source: outputText, shortCircuit: true };
}
