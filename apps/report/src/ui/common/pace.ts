// SPDX-License-Identifier: MIT
// Keeps texts that follow the player from changing faster than anyone reads them.

const TEXT_MS = 120;

/** Calls something at most every 120 ms, and once more after the last request. */
export class Pace {
  private readonly run: () => void;
  private last = -Infinity;
  private timer = 0;

  constructor(run: () => void) {
    this.run = run;
  }

  request(): void {
    if (this.timer) return;
    const wait = this.last + TEXT_MS - performance.now();
    if (wait <= 0)
      this.now();
    else
      this.timer = window.setTimeout(() => this.now(), wait);
  }

  /** Calls it at once. */
  now(): void {
    window.clearTimeout(this.timer);
    this.timer = 0;
    this.last = performance.now();
    this.run();
  }
}
