// One short word for a list of numbers, so that bodies whose hulls or meshes are alike share one geometry.

const words = new Uint32Array(2);
const number = new Float64Array(words.buffer);

const known = new WeakMap<object, string>();

/** The key of what never changes: made once, however many bodies have it. */
export function keyOf(content: object, make: () => string): string {
  let key = known.get(content);
  if (key === undefined) known.set(content, (key = make()));
  return key;
}

/** 64 bits of hash and the count: alike for alike content; for different content alike by a chance of 1 in 10^19. */
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
    mix(0x2c); // where one list ends and the next begins matters
  }
  const hex = (word: number) => (word >>> 0).toString(16).padStart(8, '0');
  return `${kind}:${count}:${hex(a)}${hex(b)}`;
}
