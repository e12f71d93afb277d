import { describe, expect, it } from 'vitest';
import { InputQueue } from './input_queue.js';

describe('the input queue', () => {
  const filled = (count: number) => {
    const queue = new InputQueue<string>();
    for (let i = 1; i <= count; i++) queue.push(`input ${i}`);
    return queue;
  };

  it('resends only lost inputs under their original numbers', () => {
    const queue = filled(10);
    expect(queue.take(8)).toMatchObject({ firstSequence: 1 });
    for (const sequence of [1, 2, 3]) expect(queue.onResult(sequence)).toBe(true);
    queue.resumeAfter(5); // the server has 4 and 5; their results are pending
    expect(queue.take(32)).toEqual({ firstSequence: 6, inputs: ['input 6', 'input 7', 'input 8', 'input 9', 'input 10'] });
    expect(queue.onResult(3)).toBe(false); // repeated, because the server does not know that it arrived
    expect(queue.onResult(4)).toBe(true);
    expect(queue.onResult(4)).toBe(false);
    expect(queue.onResult(10)).toBe(true);
  });

  it('restarts numbering when the server does not resume the session', () => {
    const queue = filled(10);
    queue.take(8);
    queue.startNewSession();
    expect(queue.length).toBe(0);
    queue.push('first');
    expect(queue.take(32)).toEqual({ firstSequence: 1, inputs: ['first'] });
  });

  it('ignores confirmations beyond the last sent input', () => {
    const queue = filled(3);
    queue.take(2);
    queue.resumeAfter(4_000_000_000);
    expect(queue.take(32)).toEqual({ firstSequence: 3, inputs: ['input 3'] });
  });
});
