// SPDX-License-Identifier: MIT
// Codes of errors, by which levels of detail are chosen, and the motions of an interval.

export const kCodes = 64;
const kFinestLog2 = -20; // Code 1 stands for 2^-20 mm; code 63 for 2^11 mm and more.

/** Returns the code of an error in mm. */
export function codeOfError(error: number): number {
  if (!(error > 0)) return 0;
  const code = Math.ceil((Math.log2(error) - kFinestLog2) * 2) + 1;
  return Math.min(kCodes - 1, Math.max(1, code));
}

/** Motions of an interval. */
export const kRest = 0;
export const kCutting = 1;
export const kRapid = 2;
