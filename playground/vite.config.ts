import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

const inRepository = (path: string): string => fileURLToPath(new URL(`../${path}`, import.meta.url));

export default defineConfig({
  base: './',
  resolve: { alias: { waywright: inRepository('bindings/wasm/dist/index.js') } },
  build: { target: 'es2022', assetsInlineLimit: 0, chunkSizeWarningLimit: 2000, reportCompressedSize: true },
  worker: { format: 'es' },
  server: { fs: { allow: [inRepository('.')] } },
});
