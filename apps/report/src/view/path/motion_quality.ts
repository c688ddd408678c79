// SPDX-License-Identifier: MIT
// How much of a picture is drawn while it moves, by the time that the browser takes for its frames.

const kSlowMs = 50; // Frames of a movement that take longer lower the quality, to 20 a second.
const kFastMs = 25;
const kLeastQuality = 0.3;
const kFullFrom = 0.8; // At a higher quality everything is drawn.
const kRestMs = 400; // So long after a movement the picture is drawn in full.

/** The quality of a moving picture; at rest it is 1. */
export class MotionQuality {
  private quality = 1;
  private isMoving = false;
  private timer = 0;

  /** Returns the part of the nodes that is drawn: 1, or less where the browser is too slow. */
  get part(): number {
    return this.isMoving && this.quality < kFullFrom ? this.quality : 1;
  }

  /** Notes a movement; calls back when no other follows. */
  move(rested: () => void): void {
    this.isMoving = true;
    window.clearTimeout(this.timer);
    this.timer = window.setTimeout(() => {
      this.isMoving = false;
      rested();
    }, kRestMs);
  }

  /** Notes the time from frame to frame of a movement. */
  note(frameMs: number): void {
    if (!this.isMoving) return;
    if (frameMs > kSlowMs) this.quality = Math.max(kLeastQuality, this.quality * 0.85);
    else if (frameMs < kFastMs) this.quality = Math.min(1, this.quality * 1.05);
  }

  stop(): void {
    window.clearTimeout(this.timer);
  }
}
