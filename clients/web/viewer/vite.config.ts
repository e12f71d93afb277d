// The build is committed in ../dist and rebuilt by the tests, so it must be identical on every machine.
import { defaultClientConditions, defineConfig } from 'vite';

export default defineConfig({
  base: './',
  resolve: { conditions: ['source', ...defaultClientConditions] },
  build: { outDir: '../dist', emptyOutDir: true, target: 'es2022', sourcemap: false, chunkSizeWarningLimit: 2000,
    rollupOptions: { input: ['index.html', 'monitor.html'] } },
});
