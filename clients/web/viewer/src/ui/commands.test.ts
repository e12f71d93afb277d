import { expect, it } from 'vitest';
import { Commands } from './commands';

it('runs the command of a key, independent of upper case', () => {
  const commands = new Commands();
  const runs: string[] = [];
  commands.register({ key: 'f', label: 'Show all', run: () => runs.push('f') });
  commands.register({ key: '?', label: 'Help', run: () => runs.push('?') });
  expect([commands.run('F'), commands.run('?'), commands.run('x')]).toEqual([true, true, false]);
  expect(runs).toEqual(['f', '?']);
  expect(() => commands.register({ key: 'f', label: 'Other', run: () => {} })).toThrow('two commands have the key f: Other');
});
