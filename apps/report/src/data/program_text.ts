// SPDX-License-Identifier: MIT
// The text of a program, line by line, however long: lines are found in its bytes and decoded one
// by one, when they are shown.

/** A text whose lines are counted from 1. */
export class ProgramText {
  private readonly bytes: Uint8Array;
  private readonly starts: Uint32Array; // of each line, then one past the end
  private readonly decoder = new TextDecoder();

  constructor(bytes: Uint8Array) {
    this.bytes = bytes;
    this.starts = lineStarts(bytes);
  }

  get lines(): number {
    return this.starts.length - 1;
  }

  /** Returns a line without its end, or an empty text for a line that there is not. */
  line(number: number): string {
    if (number < 1 || number > this.lines) return '';
    const text = this.decoder.decode(
      this.bytes.subarray(this.starts[number - 1]!, this.starts[number]!));
    return text.replace(/[\r\n]+$/, '');
  }

  /**
   * Returns the first line after `from` (backwards: before it) that contains `text`, in upper or
   * lower case, and starts over at the other end; 0 if there is none.
   */
  find(text: string, from: number, backwards = false): number {
    const wanted = text.toUpperCase();
    for (let step = 1; wanted && step <= this.lines; ++step) {
      const offset = from - 1 + (backwards ? -step : step);
      const number = ((offset % this.lines) + this.lines) % this.lines + 1;
      if (this.line(number).toUpperCase().includes(wanted)) return number;
    }
    return 0;
  }
}

function lineStarts(bytes: Uint8Array): Uint32Array {
  const newline = 10;
  let count = 0;
  for (let at = bytes.indexOf(newline); at >= 0; at = bytes.indexOf(newline, at + 1)) ++count;
  const unfinished = bytes.length > 0 && bytes[bytes.length - 1] !== newline;
  const starts = new Uint32Array(count + (unfinished ? 2 : 1));
  let line = 0;
  for (let at = bytes.indexOf(newline); at >= 0; at = bytes.indexOf(newline, at + 1))
    starts[++line] = at + 1;
  if (unfinished) starts[++line] = bytes.length;
  return starts;
}
