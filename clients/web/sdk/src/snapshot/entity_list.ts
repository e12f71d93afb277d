// Decodes the packed entity lists of proto/WIRE.md, "Entity lists". The C++ implementation is
// proto/snapshot/src/entity_list.cpp.

import { BitReader, bitWidth } from './bit_reader.js';
import { DecodeError } from './decode_frame.js';

const COUNT_ORDER = 4;
const GAP_ORDER = 0;
const PROTOTYPES_MAX = 65536;
/** Maximum number of entities of one list. */
export const ENTITIES_MAX = 1 << 20;

export interface ListedEntity {
  readonly id: number;
  /** Index in EntityUpdate.prototypes. */
  readonly prototype: number;
}

/** Decodes untrusted bytes. Throws DecodeError with the cause and the position. */
export function decodeEntityList(packed: Uint8Array, prototypes: number): ListedEntity[] {
  const reader = new BitReader(packed);
  const fail = (what: string): never => {
    throw new DecodeError(`${what} (at bit ${reader.position})`);
  };
  if (prototypes === 0 || prototypes > PROTOTYPES_MAX)
    fail(`${prototypes} prototypes; there must be 1 to ${PROTOTYPES_MAX}`);
  const count = reader.expGolomb(COUNT_ORDER);
  if (reader.pastEnd) fail('truncated data');
  if (count > ENTITIES_MAX || count > packed.length * 8) fail('the number of entities exceeds the limit or the data');
  const width = prototypes > 1 ? bitWidth(prototypes - 1) : 0;
  // The prototype that last followed each prototype.
  const after = Uint32Array.from({ length: prototypes }, (_, k) => k);
  const entities: ListedEntity[] = [];
  let nextId = 1;
  let previous = 0;
  for (let k = 0; k < count; k++) {
    const id = nextId + reader.expGolomb(GAP_ORDER);
    if (id > 0xffffffff) fail('id exceeds 32 bits');
    nextId = id + 1;
    let prototype = 0;
    if (width > 0) {
      prototype = reader.bits(1) === 1 ? after[previous]! : reader.bits(width);
      if (prototype >= prototypes) fail('unknown prototype');
      after[previous] = prototype;
      previous = prototype;
    }
    if (reader.pastEnd) fail('truncated data');
    entities.push({ id, prototype });
  }
  if (!reader.atCleanEnd()) fail('unexpected or missing bits at the end');
  return entities;
}
