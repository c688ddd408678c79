// SPDX-License-Identifier: MIT
// Which parts of a list belong to a line of a program: a table from (file, line) to their numbers.

/** Numbers of entries by file and line, each list ascending. */
export class LineIndex {
  private readonly firstKey: Float64Array; // of each file: the key of its line 0
  private readonly starts: Uint32Array;
  private readonly entries: Uint32Array;

  /** Entry i is of line `lines[i]`, from 0, of file `files[i]`. */
  constructor(files: ArrayLike<number>, lines: ArrayLike<number>) {
    this.firstKey = firstKeys(files, lines);
    const keys = this.firstKey[this.firstKey.length - 1]!;
    this.starts = new Uint32Array(keys + 1);
    for (let i = 0; i < lines.length; ++i) ++this.starts[this.key(files[i]!, lines[i]!) + 1]!;
    for (let key = 0; key < keys; ++key) this.starts[key + 1]! += this.starts[key]!;
    const next = this.starts.slice();
    this.entries = new Uint32Array(lines.length);
    for (let i = 0; i < lines.length; ++i)
      this.entries[next[this.key(files[i]!, lines[i]!)]!++] = i;
  }

  /** Returns the numbers of the entries of a line; an empty array where it has none. */
  of(file: number, line: number): Uint32Array {
    const known = file >= 0 && file + 1 < this.firstKey.length && line >= 0 &&
      this.key(file, line) < this.firstKey[file + 1]!;
    if (!known) return new Uint32Array(0);
    const key = this.key(file, line);
    return this.entries.subarray(this.starts[key]!, this.starts[key + 1]!);
  }

  private key(file: number, line: number): number {
    return this.firstKey[file]! + line;
  }
}

function firstKeys(files: ArrayLike<number>, lines: ArrayLike<number>): Float64Array {
  const sizes: number[] = [];
  for (let i = 0; i < lines.length; ++i)
    sizes[files[i]!] = Math.max(sizes[files[i]!] ?? 0, lines[i]! + 1);
  const first = new Float64Array(sizes.length + 1);
  for (let file = 0; file < sizes.length; ++file) first[file + 1] = first[file]! + (sizes[file] ?? 0);
  return first;
}
