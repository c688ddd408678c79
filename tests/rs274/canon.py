# SPDX-License-Identifier: MIT
"""LinuxCNC's rs274: runs a program and turns its canonical calls into moves."""
import dataclasses
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys

import numpy as np

from moves import PLANE_AXES, Error, Move, Outcome, State

HERE = pathlib.Path(__file__).resolve().parent
INCH = 25.4  # mm
CALL = re.compile(r"^\s*\d+ N[\d.]*\s*([A-Z]\w+)\((.*)\)$")
PLANES = {"CANON_PLANE_XY": "XY", "CANON_PLANE_XZ": "ZX", "CANON_PLANE_YZ": "YZ",
          "CANON_PLANE_UNKNOWN": "of U V W"}
TIMEOUT = 10  # s; a loop without end


def lines_of(output):
    """Parted by line feeds alone: what rs274 quotes may hold a form feed."""
    return output.decode("latin-1").removesuffix("\n").split("\n") if output else []


def numbers(text):
    return [float(word) for word in re.split(r"[ ,]+", text.strip())]


class Canon:
    """The state that canonical calls are meant in. Lengths are kept in mm."""

    def __init__(self):
        self.scale = 1.0
        self.origin, self.shift, self.tool = np.zeros(3), np.zeros(3), np.zeros(3)
        self.rotation = 0.0
        self.plane = "XY"
        self.rate, self.per_turn, self.speed = 0.0, False, 0.0  # mm/min or mm, whether per turn, turns/min
        self.direction = 0  # of the spindle, 1: clockwise
        self.state = State()
        self.position = np.zeros(3)
        self.moves = []
        self.splines = 0

    def machine(self, program, scale=None):
        """machine = tool + origin + R (program + shift)."""
        x, y, z = np.asarray(program, float) * (scale or self.scale) + self.shift
        c, s = math.cos(self.rotation), math.sin(self.rotation)
        return np.array([c * x - s * y, s * x + c * y, z]) + self.origin + self.tool

    def feed(self):
        return self.rate / 60 * (self.speed if self.per_turn else 1)

    def add(self, kind, end, call, **more):
        self.moves.append(Move(kind, self.position, end, call=call, state=self.state, **more))
        self.position = end

    def keep(self, **values):
        self.state = dataclasses.replace(self.state, **values)

    def turn(self, direction):
        self.direction = direction
        self.keep(spindle=direction * self.speed)

    def take(self, name, text):
        """False at the end of the program."""
        act = getattr(self, "on_" + name, None)
        if act:
            act(text)
        return name != "PROGRAM_END"

    def on_USE_LENGTH_UNITS(self, text):
        self.scale = INCH if "INCH" in text else 1.0

    def on_SET_G5X_OFFSET(self, text):
        self.origin = np.array(numbers(text)[1:4]) * self.scale

    def on_SET_G92_OFFSET(self, text):
        self.shift = np.array(numbers(text)[:3]) * self.scale

    def on_SET_XY_ROTATION(self, text):
        self.rotation = math.radians(float(text))

    def on_USE_TOOL_LENGTH_OFFSET(self, text):
        self.tool = np.array(numbers(text)[:3]) * self.scale

    def on_SELECT_PLANE(self, text):
        self.plane = PLANES[text]

    def on_SET_FEED_RATE(self, text):
        self.rate = float(text) * self.scale

    def on_SET_FEED_MODE(self, text):
        self.per_turn = numbers(text)[1] != 0

    def on_SET_SPINDLE_SPEED(self, text):
        self.speed = numbers(text)[1]
        self.turn(self.direction)

    def on_START_SPINDLE_CLOCKWISE(self, text):
        self.turn(1)

    def on_START_SPINDLE_COUNTERCLOCKWISE(self, text):
        self.turn(-1)

    def on_STOP_SPINDLE_TURNING(self, text):
        self.turn(0)

    def on_CHANGE_TOOL(self, text):
        self.keep(tool=int(text))

    def on_CHANGE_TOOL_NUMBER(self, text):
        self.keep(tool=int(text))

    def on_MIST_ON(self, text):
        self.keep(mist=True)

    def on_MIST_OFF(self, text):
        self.keep(mist=False)

    def on_FLOOD_ON(self, text):
        self.keep(flood=True)

    def on_FLOOD_OFF(self, text):
        self.keep(flood=False)

    def on_ENABLE_FEED_OVERRIDE(self, text):
        self.keep(feed_override=True)

    def on_DISABLE_FEED_OVERRIDE(self, text):
        self.keep(feed_override=False)

    def on_ENABLE_SPEED_OVERRIDE(self, text):
        self.keep(speed_override=True)

    def on_DISABLE_SPEED_OVERRIDE(self, text):
        self.keep(speed_override=False)

    def on_STRAIGHT_TRAVERSE(self, text):
        self.add("rapid", self.machine(numbers(text)[:3]), "STRAIGHT_TRAVERSE" + text)

    def on_STRAIGHT_FEED(self, text):
        self.add("feed", self.machine(numbers(text)[:3]), "STRAIGHT_FEED" + text, feed=self.feed())

    def on_ARC_FEED(self, text):
        a, b, ca, cb, turns, across = numbers(text)[:6]
        i, j = PLANE_AXES[self.plane]
        end, center = np.zeros(3), np.zeros(3)
        end[i], end[j], end[3 - i - j] = a, b, across
        center[i], center[j], center[3 - i - j] = ca, cb, across
        self.add("arc", self.machine(end), "ARC_FEED" + text, feed=self.feed(), plane=self.plane,
                 center=self.machine(center), ccw=turns > 0, turns=abs(int(turns)) - 1)

    def on_NURBS_FEED(self, text):
        points = self.points_of[self.splines]
        self.splines += 1
        # The preview keeps the number of Z where the units change; rs274 does not move it.
        points = [np.append(self.machine(point, INCH)[:2], self.position[2]) for point in points]
        self.add("nurbs", points[-1], "NURBS_FEED" + text, feed=self.feed(), points=points)

    def on_DWELL(self, text):
        self.moves.append(Move("dwell", self.position, self.position, duration=float(text), call="DWELL" + text,
                               state=self.state))


class Rs274:
    """The program of Debian's linuxcnc-uspace. `preload` is exact_printf.c, compiled."""

    def __init__(self, preload, folder):
        self.folder = pathlib.Path(folder)
        # Its tools lie in a file of the home directory, which another run must not touch.
        self.environment = dict(os.environ, LD_PRELOAD=str(preload), HOME=str(folder), LC_ALL="C")

    def run(self, program):
        """`program` is a path; subprograms are looked for beside it."""
        variables = self.folder / "rs274.var"
        variables.write_text("")
        (self.folder / "rs274.var.bak").unlink(missing_ok=True)
        tools = shutil.copy(HERE / "tools.tbl", self.folder)  # G10 may write to it
        command = ["rs274", "-t", tools, "-v", variables, "-g", pathlib.Path(program).resolve()]
        try:
            done = subprocess.run(command, env=self.environment, capture_output=True, timeout=TIMEOUT,
                                  cwd=pathlib.Path(program).resolve().parent)
        except subprocess.TimeoutExpired:
            return Outcome(False, [], [Error("", "endless", "")])
        errors = self.errors(done)
        canon = Canon()
        lines = lines_of(done.stdout)
        if any("NURBS_FEED" in line for line in lines):
            canon.points_of = self.spline_points(program)
        for line in lines:
            call = CALL.match(line)
            if call and not canon.take(*call.groups()):
                break
        return Outcome(done.returncode == 0, canon.moves, errors)

    @staticmethod
    def errors(done):
        """A text and the line it is about, as rs274 tells them."""
        if done.returncode == 0:
            return []
        lines = [line for line in lines_of(done.stderr) if line != "executing"]
        if done.returncode < 0:
            return [Error("", f"ended by signal {-done.returncode}", "")]
        return [Error("", lines[-2] if len(lines) > 1 else "", lines[-1] if lines else "")]

    def spline_points(self, program):
        """rs274 does not print the points of splines; the preview of the same library tells them."""
        done = subprocess.run(["/usr/bin/python3", HERE / "spline_points.py", program, self.folder],
                              capture_output=True, text=True, timeout=TIMEOUT)
        if done.returncode:
            sys.exit(f"spline_points.py: {done.stderr}")
        return json.loads(done.stdout)
