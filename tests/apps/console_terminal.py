# SPDX-License-Identifier: MIT
"""A pseudo-terminal with `softcnc operate` in it, for the tests of the console."""
import os
import pathlib
import time

import pexpect
import pyte

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PART = "programs/31_first_part.nc"
RIGHT, DOWN, PAGE_UP, PAGE_DOWN = "\033[C", "\033[B", "\033[5~", "\033[6~"
ENTER, ESCAPE = "\r", "\033"
ROWS, COLUMNS = 24, 80


class Terminal:
    """softcnc in a terminal of 24 rows and 80 columns, and what that shows."""

    def __init__(self, softcnc, arguments):
        self.child = pexpect.spawn(softcnc, arguments, dimensions=(ROWS, COLUMNS), cwd=ROOT,
                                   timeout=5, env={**os.environ, "TERM": "linux"})
        self.child.delaybeforesend = 0
        self.screen = pyte.Screen(COLUMNS, ROWS)
        self.stream = pyte.ByteStream(self.screen)

    def read(self, seconds):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            try:
                self.stream.feed(self.child.read_nonblocking(65536, 0.02))
            except pexpect.TIMEOUT:
                pass
            except pexpect.EOF:
                return

    def text(self):
        return "\n".join(row.rstrip() for row in self.screen.display).rstrip("\n") + "\n"

    def wait_for(self, *parts, seconds=90):
        """Waits until the screen shows all of this."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self.read(0.05)
            if all(part in self.text() for part in parts):
                self.read(0.15)
                return
        raise AssertionError(f"the screen does not show {parts}:\n{self.text()}")

    def type(self, *keys):
        for key in keys:
            self.child.send(key)
        self.read(0.15)

    def line(self, text):
        """A line of MDI, until it has run."""
        self.type("m", text, ENTER)
        self.type(ESCAPE)
        self.wait_for(" Idle ")

    def end(self):
        self.child.expect(pexpect.EOF)
        self.child.close()
        return self.child.exitstatus
