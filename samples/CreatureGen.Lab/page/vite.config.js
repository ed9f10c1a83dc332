import { defineConfig } from 'vite';

// Works in any folder of any host: no address in what is built begins with a slash.
export default defineConfig({
  base: './',
  worker: { format: 'es' },
  build: { target: 'es2022', assetsInlineLimit: 0, modulePreload: { polyfill: false }, chunkSizeWarningLimit: 1200 },
});
