#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""A person at the machine, from power-up to the first part, in a pseudo-terminal.

    tests/apps/operate_session.py SOFTCNC            checks
    tests/apps/operate_session.py SOFTCNC --write    writes the screens into the page

Types what docs/operate.md says, and compares the screens with those of that page and of the README:
each stands there below a comment with its name. In a `moving` one digits stand for any. An emergency
stop comes in the middle of the part; the same session without it must leave the same state, and the
same part.
"""
import csv
import os
import pathlib
import re
import sys
import tempfile

import numpy as np

from console_terminal import DOWN, ENTER, PAGE_UP, PART, ROOT, Terminal

PAGES = [ROOT / "docs" / "operate.md", ROOT / "README.md"]


def session(softcnc, folder, show, estop):
    """Returns the exit status."""
    at = Terminal(softcnc, ["operate", PART, "--state", str(folder / "mill.state.toml"), "--trace",
                            str(folder / "trace.csv"), "--log", str(folder / "log.txt")])
    at.wait_for("the position is not known")
    show("power-up", at)
    at.type("h")
    at.wait_for(" Home ")
    at.wait_for(" Idle ")
    show("homed", at)
    at.line("M03 S3000")
    at.line("G04 P1")
    at.line("M05")
    at.line("G53 G00 X30 Y30")
    at.line("G53 G00 Z-35")
    at.type("p", "Z-20=0", ENTER)
    at.wait_for(" Run ")
    at.wait_for(" Idle ")
    at.line("G53 G00 X5")
    at.line("G53 G00 Z-45")
    at.type("p", "X10=-2", ENTER)
    at.wait_for(" Run ")
    at.wait_for(" Idle ")
    at.line("G53 G00 Y5")
    at.line("G53 G00 X30")
    at.type("p", "Y10=-2", ENTER)
    at.wait_for(" Run ")
    at.wait_for(" Idle ")
    at.line("G53 G00 Z60")
    at.type("w")
    show("work offsets", at)
    at.type("q", "o", ENTER, "Z20 R3", ENTER)
    at.read(0.3)
    at.type(DOWN, ENTER, "Z25 R3", ENTER)
    at.read(0.3)
    show("tools", at)
    at.type("q", "c")
    at.wait_for("s starts")
    show("checked", at)
    at.type("s")
    at.wait_for("T1 end mill 6 mm in, then Enter")
    show("tool change", at)
    at.type(ENTER)
    at.wait_for(">    13")
    at.type(" ")
    at.wait_for("Enter goes on, a ends the program")
    show("held", at)
    at.type(PAGE_UP)
    at.wait_for("Enter goes back and on")
    at.type(ENTER)
    at.wait_for(">    14")
    if estop:
        at.type("e")
        at.wait_for(" Alarm ")
        show("emergency stop", at)
        at.type("u")
        at.wait_for(" Idle ")
        at.line("G53 G00 Z60")
        at.type("h")
        at.wait_for(" Home ")
        at.wait_for(" Idle ")
        at.type("s")
        at.wait_for("T1 end mill 6 mm in, then Enter")
        at.type(ENTER)
    at.wait_for("T2 ball nose 6 mm in, then Enter")
    at.type(ENTER)
    at.wait_for("the program has ended")
    show("done", at)
    at.type("?")
    show("keys", at)
    at.type("q", "q")
    return at.end()


def of_part(folder):
    """The places of the part from its last tool change on, one a period."""
    with open(folder / "trace.csv", encoding="utf-8") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        places = np.array([[float(row[axis]) for axis in ("x_mm", "y_mm", "z_mm")] for row in rows])
    at_change = np.flatnonzero(np.all(places == (0, -80, 60), axis=1))
    return places[at_change[-1]:]


def differ(one, other):
    """Whether two runs of a part go other ways, or at another pace: rows begin anywhere in a period."""
    if min(len(one), len(other)) < 3000 or abs(len(one) - len(other)) > 2:
        return True
    along = [np.concatenate(([0], np.cumsum(np.linalg.norm(np.diff(run, axis=0), axis=1))))
             for run in (one, other)]
    there = np.array([np.interp(along[0], along[1], other[:, axis]) for axis in range(3)]).T
    return np.abs(there - one).max() > 0.005


def state_of(folder):
    return (folder / "mill.state.toml").read_text(encoding="utf-8")


def masked(text):
    """Any digits, as many as there are."""
    return re.sub(r" +", " ", re.sub(r"\d+", "#", text))


def blocks_of(page):
    """Name -> (whether it moves, text), in the order of the page."""
    found = re.findall(r"<!-- screen: ([a-z -]+?)(, moving)? -->\n\n```\n(.*?)```\n", page, re.S)
    return {name: (bool(moving), text) for name, moving, text in found}


def lines_around(text):
    """Without the lines of the program: which they are depends on the instant."""
    return "\n".join(line for line in text.split("\n") if not re.match(r"[> ] {1,5}\d+  ", line))


def differs(shown, moving, expected):
    if not moving:
        return shown != expected
    return masked(lines_around(shown)) != masked(lines_around(expected))


def main():
    softcnc, writes = os.path.abspath(sys.argv[1]), "--write" in sys.argv[2:]
    seen, wrong = {}, []

    def show(name, at):
        seen[name] = at.text()

    with tempfile.TemporaryDirectory() as name:
        with_stop, without = pathlib.Path(name) / "stopped", pathlib.Path(name) / "straight"
        for folder, estop in ((with_stop, True), (without, False)):
            folder.mkdir()
            status = session(softcnc, folder, show if estop else lambda *_: None, estop)
            if status != 0:
                wrong.append(f"{folder.name}: exit status {status}")
        if state_of(with_stop) != state_of(without):
            wrong.append("the states at the end differ")
        if differ(of_part(with_stop), of_part(without)):
            wrong.append("the parts differ")
        log = (with_stop / "log.txt").read_text(encoding="utf-8")
        for action in ("> home", "> start ", "> hold", "> jog Z+1", "> emergency stop", "> unlock"):
            if action not in log:
                wrong.append(f"the log has no line '{action}'")
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        for name, (moving, expected) in blocks_of(text).items():
            if not differs(seen[name], moving, expected):
                continue
            wrong.append(f"{page.name}, screen '{name}':\n{expected}is now\n{seen[name]}")
            mark = f"<!-- screen: {name}{', moving' if moving else ''} -->\n\n```\n"
            text = text.replace(mark + expected + "```", mark + seen[name] + "```")
        if writes:
            page.write_text(text, encoding="utf-8")
    if wrong and not writes:
        sys.exit("\n".join(wrong))


if __name__ == "__main__":
    main()
