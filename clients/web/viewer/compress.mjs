// Writes FILE.br and FILE.gz next to the files of ../dist that compress; jostle-server sends them to browsers that accept them.
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { brotliCompressSync, constants, gzipSync } from 'node:zlib';

const dist = new URL('../dist/', import.meta.url).pathname;
const smallest = 1024; // bytes; a smaller file fits into one packet either way

for (const name of readdirSync(dist, { recursive: true })) {
  if (!/\.(html|js|css|wasm|svg|json)$/.test(name)) continue;
  const file = join(dist, name);
  const bytes = readFileSync(file);
  if (bytes.length < smallest) continue;
  const quality = { [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length };
  writeFileSync(`${file}.br`, brotliCompressSync(bytes, { params: quality }));
  writeFileSync(`${file}.gz`, gzipSync(bytes, { level: 9 }));
}
