import { expect, it } from 'vitest';
import { MessageBudget } from './message_budget';

it('allows a burst of 10 and then 5 messages per second', () => {
  const budget = new MessageBudget();
  const sent = (fromMs: number, toMs: number) => {
    let count = 0;
    for (let now = fromMs; now < toMs; now += 10) if (budget.take(now, 0)) count++;
    return count;
  };
  expect(sent(0, 10)).toBe(1);
  expect(sent(10, 1010)).toBe(9 + 5);
  expect(sent(1010, 3010)).toBe(10);
});

it('leaves messages for chat while cursors are sent', () => {
  const budget = new MessageBudget();
  let cursors = 0;
  while (budget.take(0, 5)) cursors++;
  let chat = 0;
  while (budget.take(0, 0)) chat++;
  expect([cursors, chat]).toEqual([5, 5]);
});

it('waits after a refusal', () => {
  const budget = new MessageBudget();
  budget.close(0, 400);
  expect([budget.take(399, 0), budget.take(400, 0)]).toEqual([false, true]);
});
