// A short key for lists of numbers, so that bodies with equal hulls or meshes share one geometry.

const words = new Uint32Array(2);
const number = new Float64Array(words.buffer);

const known = new WeakMap<object, string>();

/** The cached key of an immutable object. */
export function keyOf(content: object, make: () => string): string {
  let key = known.get(content);
  if (key === undefined) known.set(content, (key = make()));
  return key;
}

/**
 * Element count and a 64-bit hash. Equal content has equal keys; different content collides with
 * probability 1e-19.
 */
export function contentKey(kind: string, ...lists: Iterable<number>[]): string {
  let a = 0x811c9dc5;
  let b = 0x9e3779b9;
  let count = 0;
  const mix = (word: number) => {
    a = Math.imul(a ^ word, 0x01000193);
    a ^= a >>> 15;
    b = Math.imul(b ^ word, 0x85ebca6b);
    b ^= b >>> 13;
  };
  for (const list of lists) {
    for (const value of list) {
      number[0] = value;
      mix(words[0]!);
      mix(words[1]!);
      count++;
    }
    mix(0x2c); // separates the lists
  }
  const hex = (word: number) => (word >>> 0).toString(16).padStart(8, '0');
  return `${kind}:${count}:${hex(a)}${hex(b)}`;
}
