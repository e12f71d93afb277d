import { create, fromBinary, type MessageInitShape } from '@bufbuild/protobuf';
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { JointUpdateSchema, SnapshotSchema } from '../gen/jostle/v1/play_pb.js';
import { JointList } from './joint_list.js';

const update = (init: MessageInitShape<typeof JointUpdateSchema>) => create(JointUpdateSchema, init);
const ball = { kind: { case: 'ball' as const, value: {} } };
const two = update({ complete: true, forms: [ball], added: [{ id: 1, entityB: 5, form: 0 }, { id: 2, entityA: 5, entityB: 6, form: 0 }] });

describe('joint list', () => {
  it('adds and removes joints, and starts again with a complete update', () => {
    const list = new JointList();
    expect(list.apply(two)).toBeUndefined();
    expect(list.apply(update({ removed: [1, 9], forms: [ball], added: [{ id: 3, entityA: 6, entityB: 7 }] }))).toBeUndefined();
    expect([...list.joints.keys()]).toEqual([2, 3]);
    expect(list.apply(update({ complete: true }))).toBeUndefined();
    expect(list.joints.size).toBe(0);
  });

  it('replaces a joint that is removed and added in one update', () => {
    const list = new JointList();
    list.apply(two);
    list.apply(update({ removed: [2], forms: [ball], added: [{ id: 2, entityA: 8, entityB: 9 }] }));
    expect(list.joints.get(2)).toMatchObject({ entityA: 8, entityB: 9 });
  });

  it('rejects malformed updates and changes nothing', () => {
    const list = new JointList();
    list.apply(two);
    const bad = (joint: object) => list.apply(update({ complete: true, forms: [ball], added: [joint] }));
    expect(bad({ id: 0, entityB: 1 })).toBe('joint 0: the id must not be 0');
    expect(bad({ id: 7, entityA: 3 })).toBe('joint 7: entity_b must not be 0');
    expect(bad({ id: 7, entityA: 3, entityB: 3 })).toBe('joint 7: entity_a and entity_b are both 3');
    expect(bad({ id: 7, entityA: 3, entityB: 4, form: 1 })).toBe('joint 7: form 1 does not exist; there are 1');
    expect([...list.joints.keys()]).toEqual([1, 2]);
  });

  it('limits the number of joints', () => {
    const added = new Array(1 << 20).fill({ id: 9, entityB: 4 });
    const list = new JointList();
    list.apply(two);
    expect(list.apply({ ...update({ forms: [ball] }), added } as never)).toBe('1048578 joints; at most 1048576 are allowed');
  });

  it('decodes the golden updates', () => {
    const lines = readFileSync(new URL('../../../../../proto/golden_joints.txt', import.meta.url), 'utf8').trim().split('\n');
    const list = new JointList();
    let updates = 0;
    for (let k = 0; k < lines.length; k++) {
      if (!lines[k]!.startsWith('update ')) continue;
      const snapshot = fromBinary(SnapshotSchema, Uint8Array.from(Buffer.from(lines[k]!.slice(7), 'hex')));
      expect(list.apply(snapshot.joints!)).toBeUndefined();
      updates++;
      const expected: string[] = [];
      while (lines[k + 1]?.startsWith('joint ')) expected.push(lines[++k]!);
      const actual = [...list.joints.values()].map(({ id, entityA, entityB, form }) => `joint ${id} ${entityA} ${entityB} ${form.kind.case}`);
      expect(actual).toEqual(expected);
    }
    expect(updates).toBe(2);
  });
});
