// Unit tests of both packages. viewer/vite.config.ts builds the viewer.
import { defineConfig } from 'vitest/config';

export default defineConfig({
  resolve: { conditions: ['source'] },
  ssr: { resolve: { conditions: ['source'] } },
  test: { include: ['sdk/src/**/*.test.ts', 'viewer/src/**/*.test.ts'], testTimeout: 30_000, hookTimeout: 30_000 },
});
