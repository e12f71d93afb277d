// Writes FILE.br and FILE.gz next to the files of ../dist that compress; jostle-server sends them to browsers that accept them.
// Fails if the script of the first view, which index.html names, is too large.
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

const html = readFileSync(join(dist, 'index.html'), 'utf8');
const scripts = [...html.matchAll(/(?:src|href)="\.\/(assets\/[^"]+\.js)"/g)].map(([, name]) => name);
const firstView = scripts.reduce((sum, name) => sum + gzipSync(readFileSync(join(dist, name)), { level: 9 }).length, 0);
const firstViewMax = 350e3; // bytes, with gzip
if (scripts.length === 0 || firstView > firstViewMax) {
  console.error(`the script of the first view has ${firstView} bytes with gzip in ${scripts.length} files; at most ${firstViewMax} are allowed`);
  process.exit(1);
}
console.log(`script of the first view: ${(firstView / 1000).toFixed(0)} kB with gzip`);
