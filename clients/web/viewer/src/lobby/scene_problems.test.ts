import { expect, it } from 'vitest';
import { excerpt, freeName, nameOfFile, parseProblems } from './scene_problems';

it('reads the positions of problems', () => {
  const message = 'line 3, column 11: bodies[0].mass: -1 is out of range; it must be from 1e-09 to 1e+15\nname: must be a string of 1 to 64 bytes\nnot valid JSON: parse error at line 5, column 1: syntax error';
  expect(parseProblems(message)).toEqual([
    { line: 3, column: 11, text: 'bodies[0].mass: -1 is out of range; it must be from 1e-09 to 1e+15' },
    { line: 0, column: 0, text: 'name: must be a string of 1 to 64 bytes' },
    { line: 5, column: 1, text: 'not valid JSON: parse error at line 5, column 1: syntax error' },
  ]);
});

it('shows a line with its neighbors', () => {
  const file = '{\r\n "bodies": [\r\n {"mass": -1}\r\n]}';
  const at = (line: number, column = 1) => excerpt(file, { line, column, text: '' }).map(({ number, text, isProblem }) => `${number}${isProblem ? '>' : ' '}${text}`);
  expect(at(3)).toEqual(['2  "bodies": [', '3> {"mass": -1}', '4 ]}']);
  expect(at(1)).toEqual(['1>{', '2  "bodies": [']);
  expect([at(0), at(9)]).toEqual([[], []]);
});

it('shows the part of a long line around the column', () => {
  const [line] = excerpt(`${'x'.repeat(1000)}BAD${'y'.repeat(1000)}`, { line: 1, column: 1001, text: '' });
  expect(line!.text.length).toBe(162);
  expect(line!.text.slice(70, 90)).toContain('BAD');
});

it('names worlds after files', () => {
  expect(nameOfFile('C:\\scenes\\my scene.JSON')).toBe('my scene');
  expect(nameOfFile('<img src=x>.json')).toBe('_img src_x_');
  expect(nameOfFile('.json')).toBe('scene');
  expect(freeName('a', new Set(['a', 'a-2']))).toBe('a-3');
});
