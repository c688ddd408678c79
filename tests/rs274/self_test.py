#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Shows that the comparison finds what it is for: softcnc's blocks are altered in one way at a time, and each must be found.

    self_test.py --softcnc BINARY

Exit 1 if an altered block is not found, or one that is not altered is.
"""
import argparse
import pathlib
import sys
import tempfile

import compare
from blocks import Softcnc
from canon import Rs274

PROGRAM = """G21 G90 F100 S500 M3 M8
G0 Z5
G1 X1
T2 M6
G1 X2
M4 S600 M7
G1 X3
M9
M49
G2 X5 I1
M48
M3
G84 X7 Z-1 R1 P0.5
G80
G1 X9
M2
"""


def without(kind, **values):
    """Drops the blocks of this kind with these values."""
    def alter(blocks):
        return [b for b in blocks if b["kind"] != kind or any(b.get(k) != v for k, v in values.items())]
    return alter


def changed(kind, **values):
    def alter(blocks):
        return [dict(b, **values) if b["kind"] == kind else b for b in blocks]
    return alter


def with_override(name):
    def alter(blocks):
        return [{k: v for k, v in b.items() if k != name} for b in blocks]
    return alter


ALTERED = {  # what is done to the blocks: what the comparison must say
    "nothing": (lambda blocks: blocks, ""),
    "M06 leaves the spindle on": (without("spindle", code=6), "spindle"),
    "M06 changes nothing": (without("tool"), "tool"),
    "another tool": (changed("tool", tool=3), "tool"),
    "the other direction": (without("spindle", code=4), "spindle"),
    "another speed": (changed("spindle", rpm=400), "spindle"),
    "no flood": (without("coolant", code=8), "flood"),
    "no mist": (without("coolant", code=7), "mist"),
    "coolant stays on": (without("coolant", code=9), "mist"),
    "the feed override counts": (with_override("feed_override"), "feed_override"),
    "the speed override counts": (with_override("speed_override"), "speed_override"),
    "another feed": (changed("feed", feed_mm_s=1), "feed"),
    "another dwell": (changed("dwell", duration_s=2), "s, not"),
}


class Altered(Softcnc):
    def __init__(self, binary, alter):
        super().__init__(binary)
        self.alter = alter

    def altered(self, blocks):
        return self.alter(blocks)


def main(words):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--softcnc", required=True)
    binary = pathlib.Path(parser.parse_args(words).softcnc).resolve()
    wrong = 0
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        rs274 = Rs274(compare.compile_preload(folder), folder)
        program = folder / "self_test.nc"
        program.write_text(PROGRAM)
        for name, (alter, expected) in ALTERED.items():
            found, _ = compare.compare(program, Altered(binary, alter), rs274)
            text = found[0].text if found else ""
            if bool(text) != bool(expected) or expected not in text:
                wrong += 1
                print(f"NOT FOUND {name}: '{expected}' expected, '{text}' found")
    print(f"{len(ALTERED)} alterations of blocks, {wrong} not found as they must be")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
