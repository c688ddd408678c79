#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The points LinuxCNC's preview goes through on the splines of a program: a list for each spline, in program coordinates and inches.

    spline_points.py PROGRAM FOLDER

Needs the module `gcode` of Debian's linuxcnc-uspace, which holds the interpreter of rs274. It does not survive a tool
change.
"""
import json
import pathlib
import re
import sys

import gcode

SPLINE = re.compile(r"G\s*0?5(\.[13])?(?![.\d])", re.IGNORECASE)  # a line at whose end there is a curve


class Preview:
    """Keeps the points of the feeds of every line on which a spline ends."""

    def __init__(self, lines, parameter_file):
        self.lines, self.parameter_file = lines, str(parameter_file)
        self.splines, self.points = [], None

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return lambda *_, **__: None

    def next_line(self, state):
        number = state.sequence_number
        text = self.lines[number - 1] if 0 < number <= len(self.lines) else ""
        self.points = [] if SPLINE.search(text) else None

    def straight_feed(self, x, y, z, *_):
        if self.points is None:
            return
        if not self.points:
            self.splines.append(self.points)
        self.points.append((x, y, z))

    def get_external_length_units(self):
        return 1.0

    def get_external_angular_units(self):
        return 1.0

    def get_axis_mask(self):
        return 7

    def get_block_delete(self):
        return 0

    def get_tool(self, pocket):
        return (-1,) + (0,) * 13

    def check_abort(self):
        return False


def main(program, folder):
    parameters = pathlib.Path(folder) / "preview.var"
    parameters.write_text("")
    lines = pathlib.Path(program).read_text(encoding="latin-1").splitlines()
    preview = Preview(lines, parameters)
    gcode.parse(str(program), preview, "G21", "")
    json.dump(preview.splines, sys.stdout)


if __name__ == "__main__":
    main(*sys.argv[1:])
