// For tests: what each module told in its golden world, as the tests of the modules keep it (tests/modules/golden).

import { readFileSync } from 'node:fs';

export function golden(tag: string): Uint8Array {
  return new Uint8Array(readFileSync(new URL(`../../../../proto/golden_modules/${tag}.bin`, import.meta.url)));
}

/** All that a reader must refuse: bytes that end early, and one too many. */
export function* broken(bytes: Uint8Array): Iterable<Uint8Array> {
  for (let end = 1; end < bytes.length; end++) yield bytes.subarray(0, end);
  yield new Uint8Array([...bytes, 0]);
}
