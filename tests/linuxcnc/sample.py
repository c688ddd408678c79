#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Within HAL: writes every sample that sampler.0 of mill.hal takes, exactly, until the rows end.

A line is what the pins held, as Python writes it, then how many samples sampler has lost. The last
line, behind a '#', is for how long at most this program was not let run, in s.
"""

import sys
import time

import hal

KEY = 0x48534130  # of channel 0, as halsampler has it
CONFIG = "fffbubfffffffffsfbb"
ROW, RUNS, OK = 4, 3, 5
LINGER = 0.3  # s behind the last row
PATIENCE = 120.0


def main():
    component = hal.component("exact_sampler")
    stream = hal.stream(component, KEY, CONFIG)
    component.ready()
    begun, ended, was_ok = time.monotonic(), None, False
    now, longest = begun, 0.0
    with open(sys.argv[1], "w", encoding="ascii") as out:
        while now < (begun + PATIENCE if ended is None else ended + LINGER):
            before, now = now, time.monotonic()
            longest = max(longest, now - before)
            sample = stream.read()
            if sample is None:
                time.sleep(0.005)
                continue
            out.write(" ".join(map(repr, sample)) + f" {stream.num_overruns}\n")
            over = sample[ROW] > 0 and not sample[RUNS] or was_ok and not sample[OK]
            was_ok = sample[OK]
            if over and ended is None:
                ended = time.monotonic()
        out.write(f"# {longest:.3f}\n")


main()
