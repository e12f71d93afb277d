// The problems of an uploaded scene, each at its line of the file.

export interface SceneProblem {
  /** From 1; 0: the problem has no position. */
  readonly line: number;
  readonly column: number;
  readonly text: string;
}

export interface ExcerptLine {
  readonly number: number;
  readonly text: string;
  readonly isProblem: boolean;
}

const LINES_AROUND = 1;
const CHARACTERS_MAX = 160; // of an excerpt line

/** The lines of the server's message: "line 3, column 11: bodies[0].mass: -1 is out of range; ...". */
export function parseProblems(message: string): SceneProblem[] {
  return message
    .split('\n')
    .filter((line) => line.trim() !== '')
    .map((line) => {
      const start = /^line (\d+), column (\d+): /.exec(line);
      if (start) return { line: Number(start[1]), column: Number(start[2]), text: line.slice(start[0].length) };
      // A syntax error has its position within the text.
      const within = /\bline (\d+), column (\d+)/.exec(line);
      return { line: Number(within?.[1] ?? 0), column: Number(within?.[2] ?? 0), text: line };
    });
}

/** The line of a problem with its neighbors; empty: the file has no such line. */
export function excerpt(file: string, problem: SceneProblem): ExcerptLine[] {
  const lines = file.split(/\r\n|\r|\n/);
  if (problem.line < 1 || problem.line > lines.length) return [];
  const first = Math.max(1, problem.line - LINES_AROUND);
  const last = Math.min(lines.length, problem.line + LINES_AROUND);
  // Of a long line, the part around the column.
  const from = problem.column > CHARACTERS_MAX / 2 ? problem.column - CHARACTERS_MAX / 2 : 0;
  return Array.from({ length: last - first + 1 }, (_, k) => {
    const number = first + k;
    const isProblem = number === problem.line;
    const start = isProblem ? from : 0;
    const text = lines[number - 1]!;
    return { number, text: (start > 0 ? '…' : '') + text.slice(start, start + CHARACTERS_MAX) + (text.length > start + CHARACTERS_MAX ? '…' : ''), isProblem };
  });
}

/** A world name for a file: its name without folder and extension, 1 to 64 bytes. */
export function nameOfFile(file: string): string {
  const base = file.replace(/^.*[\\/]/, '').replace(/\.json$/i, '');
  return base.replace(/[^\p{L}\p{N}_. -]+/gu, '_').slice(0, 20) || 'scene';
}

/** The first name that is not used: "box", "box-2", "box-3" ... */
export function freeName(base: string, used: ReadonlySet<string>): string {
  let name = base;
  for (let n = 2; used.has(name); n++) name = `${base}-${n}`;
  return name;
}
