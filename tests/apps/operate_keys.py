#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Random keys at `softcnc operate`, in a pseudo-terminal whose window changes its size.

    tests/apps/operate_keys.py SOFTCNC [BYTES [SEED]]

Sends keys of the console, lines, text, escape sequences that are known, unknown or cut in half,
UTF-8 and control characters, in bursts and with the delays of a network. The program must go on
until `q`, SIGTERM or a hang-up ends it, with the status that docs/operate.md says and the state
written; its picture must follow the size of the window; and every row of its trace must be within
the limits of the machine. Without jog keys, and without keys that run lines, nothing may move.
"""
import os
import pathlib
import random
import re
import select
import signal
import sys
import tempfile
import time
import tomllib

import pexpect

from console_terminal import ENTER, ESCAPE, PAGE_DOWN, PAGE_UP, PART, RIGHT, ROOT, Terminal
from trace_limits import Limits, Trace, exceeded

BYTES, SEED = 2000, 20261129
MACHINE = "programs/31_first_part.toml"
JERK = [word for axis in "xyz" for word in ("--set", f"axis.{axis}.jerk_mm_s3=20000")]
ANSWERS_WITHIN = 20 if "SOFTCNC_SANITIZED" in os.environ else 5  # s, on a busy computer
CLEARED = b"\033[H\033[J"  # what a terminal of TERM=linux gets before a picture of another size

TABLE_KEYS = " saeurhkmlcvtpwo,.f[]{}<>=bn/?" + ENTER  # without q
MOVING_KEYS = "smhpkgt"  # of all pages: these may run a line, or say where the machine stands
JOGS = [RIGHT, "\033[D", "\033[A", "\033[B", PAGE_UP, PAGE_DOWN, "\033OA", "\033OD"]
KNOWN = ["\033[H", "\033[F", "\033[3~", "\033[1~", "\033[8~", "\033OF", "\033OM"]
UNKNOWN = ["\033[Z", "\033[15~", "\033[1;5C", "\033[200~", "\033[<0;10;10M", "\033]0;x\007",
           "\033P1\033\\", "\033[" + "9" * 60 + "~", "\033Ox", "\033z"]
CUT = ["\033", "\033\033", "\033[", "\033O", "\033[5", "\033[1;", "\033[;;;"]
UTF_8 = ["ä", "€", "😀", "e\u0301", "\u202e", "日本語"]
LINES = ["G1 X20 F3000", "G1 X-20 Y15 F15000", "G53 G0 Z40", "G0 X0 Y0", "G2 X10 Y10 R20 F2000",
         "G91 G1 X1 Y1 Z-1 F500", "G90 G1 Y-30 F6000", "M3 S5000", "M5", "G4 P0.1",
         "G10 L2 P1 X1", "T2 M6", "G64 P0.05", "O100 while [1 LT 2]", "#1=[5/0]", "G1 X9999",
         "M30", "%", "G20", "G21"]
ANSWERS = {"k": ["X0 Y0 Z0", "", "X1", "Y-"], "t": ["X0 Y-3", "Z", "X1e9"],
           "p": ["Z-20", "Z-5=0", "X=", "X10 Y10"], "l": [PART, "nothing", "/", ""],
           "w": [ENTER + "X1 Y2"], "o": [ENTER + "Z20 R3", "m5"]}
LOSES_PLACE = "> emergency stop|> home"  # in a log


class Keys:
    """Random keys; without `jogs` those that cannot move a machine at rest."""

    def __init__(self, rng, jogs):
        self.rng, self.jogs = rng, jogs
        self.weights = {self.table_key: 10, self.text: 4, self.known: 2, self.unknown: 2,
                        self.cut: 3, self.utf_8: 2, self.control: 2}
        if jogs:
            self.weights |= {self.jog: 8, self.held: 2, self.line: 6, self.answer: 3,
                             self.recovery: 4}

    def next(self):
        """Returns a key, or some that belong together, as pieces: bytes, and the s after them."""
        made = self.rng.choices(list(self.weights), list(self.weights.values()))[0]()
        if isinstance(made, list):
            return made
        return [(made if isinstance(made, bytes) else made.encode(), pause(self.rng))]

    def table_key(self):
        return self.rng.choice([key for key in TABLE_KEYS if self.jogs or key not in MOVING_KEYS])

    def text(self):
        letters = [chr(code) for code in range(ord("!"), 127) if chr(code) != "q"]
        if not self.jogs:
            letters = [letter for letter in letters if letter.lower() not in MOVING_KEYS]
        return "".join(self.rng.choices(letters, k=self.rng.randint(1, 6)))

    def known(self):
        return self.rng.choice(KNOWN)

    def unknown(self):
        return self.rng.choice(UNKNOWN)

    def cut(self):
        """Where there are to be no jog keys, what follows must not make one of it."""
        return self.rng.choice(CUT) + ("" if self.jogs else "z")

    def utf_8(self):
        """Characters of several bytes, and bytes that are none."""
        return self.rng.choice([self.rng.choice(UTF_8).encode(), b"\xc3", b"\xff\xfe",
                                bytes([self.rng.randint(128, 255)])])

    def control(self):
        return bytes([self.rng.choice([code for code in range(32) if code != 27] + [127])])

    def jog(self):
        return self.rng.choice(JOGS)

    def held(self):
        """As a terminal repeats a key, after the delay of the first repeat."""
        key, count = self.rng.choice(JOGS).encode(), self.rng.randint(3, 25)
        return [(key, 0.25), *[(key, self.rng.choice([0.005, 0.033]))] * count]

    def line(self):
        text = self.rng.choice(LINES).encode()
        return [(b"m", 0.01), (text, 0.01), (b"\r", pause(self.rng)), (ESCAPE.encode(), 0.1)]

    def recovery(self):
        """What a person does before the next motion: back to the main page, and out of an alarm."""
        keys = self.rng.choice(["au", "aukX0 Y0 Z0\r", "uh", "aus"])
        return [(ESCAPE.encode(), 0.1), *[(key.encode(), 0.01) for key in keys]]

    def answer(self):
        key = self.rng.choice(list(ANSWERS))
        return key + self.rng.choice(ANSWERS[key]) + ENTER


class Session:
    """One run of the program, and what has been sent to it."""

    def __init__(self, softcnc, folder, name, options=()):
        self.folder, self.sent = folder, b""
        self.trace, self.log = folder / f"{name}.npz", folder / f"{name}.txt"
        self.options = options
        self.at = Terminal(softcnc, ["operate", PART, "--state", str(self.state_file()), "--trace",
                                     str(self.trace), "--log", str(self.log), "--set",
                                     "operate.alone_s=0.3", *options])
        self.at.wait_for("keys", seconds=20)

    def state_file(self):
        return self.folder / "mill.state.toml"

    def state(self):
        return tomllib.loads(self.state_file().read_text(encoding="utf-8"))

    def place(self):
        position = self.state()["position"]
        return [position[f"{axis}_mm"] for axis in "xyz"]

    def fail(self, what):
        raise AssertionError(f"{what}; the last bytes sent: {self.sent[-300:]!r}\n{self.at.text()}")

    def send(self, data):
        """Sends bytes, and takes what the screen shows by then."""
        _, ready, _ = select.select([], [self.at.child.fileno()], [], ANSWERS_WITHIN)
        if not ready:
            self.fail(f"it takes no keys for {ANSWERS_WITHIN} s")
        self.sent += data
        os.write(self.at.child.fileno(), data)

    def hear(self, seconds):
        """Returns what the program writes, or None once it has ended."""
        try:
            heard = self.at.child.read_nonblocking(65536, seconds)
        except pexpect.TIMEOUT:
            return b""
        except (pexpect.EOF, OSError):
            return None
        self.at.stream.feed(heard)
        return heard

    def is_there(self, seconds):
        """Reads for so long, and returns whether the program goes on."""
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > -0.001:
            if self.hear(max(left, 0)) is None:
                return False
        return True

    def resize(self, rng):
        """The whole screen is drawn again, in the new size."""
        size = rng.choice([(5, 20), (100, 300), (24, 80),
                           (rng.randint(5, 100), rng.randint(20, 300))])
        if size == (self.at.screen.lines, self.at.screen.columns):
            return
        self.at.screen.resize(*size)
        self.at.child.setwinsize(*size)
        heard, end = b"", time.monotonic() + ANSWERS_WITHIN
        while CLEARED not in heard:
            more = self.hear(0.05)
            if more is None:
                self.fail("it has ended after a change of the window's size")
            heard += more
            if time.monotonic() > end:
                self.fail(f"no picture of {size} within {ANSWERS_WITHIN} s")
        self.is_there(0.02)
        if not self.at.text().strip():
            self.fail(f"the picture of {size} is empty")

    def wait_for_end(self, seconds=30):
        """Returns the exit status, 128 and more by a signal."""
        end = time.monotonic() + seconds
        while self.at.child.isalive():
            if not self.at.child.closed:
                self.hear(0.05)
            if time.monotonic() > end:
                self.fail(f"it has not ended within {seconds} s")
            time.sleep(0.01)
        if self.at.child.exitstatus is None:
            self.fail(f"signal {self.at.child.signalstatus} has ended it")
        return self.at.child.exitstatus

    def end_by(self, signal_number):
        """By SIGTERM, or by a terminal that goes away."""
        if signal_number == signal.SIGTERM:
            self.at.child.kill(signal_number)
        else:
            self.at.child.ptyproc.fileobj.close()
            self.at.child.ptyproc.closed = self.at.child.closed = True
        status = self.wait_for_end()
        if status != 128 + signal_number:
            self.fail(f"exit status {status} after signal {signal_number}")

    def check_files(self, softcnc):
        """The trace keeps all limits, and the state is that of a machine at rest.

        Returns the travel in mm.
        """
        log = self.log.read_text(encoding="utf-8")
        is_known = not re.search(LOSES_PLACE, log.rsplit("> the machine stands at", 1)[-1])
        if is_known and self.state()["position"]["in_motion"] != "no":
            self.fail("the state says that the machine moves")
        trace = Trace(self.trace)
        jumps = len(re.findall(f"> the machine stands at|{LOSES_PLACE}", log))
        limits = Limits(softcnc, ["--machine", MACHINE, *self.options], ROOT)
        if wrong := exceeded(trace, limits, jumps):
            self.fail("; ".join(wrong))
        return trace.travel()


def pause(rng):
    """s, as they lie between the packets of ssh."""
    return rng.choice([0, 0, 0, rng.uniform(0.001, 0.03), rng.uniform(0.001, 0.03),
                       rng.uniform(0.03, 0.2)])


def pieces(rng, keys):
    """A key, its two halves, or a burst of fifty at once."""
    kind = rng.random()
    if kind < 0.03:
        burst = b""
        while len(burst) < 50:
            burst += b"".join(data for data, _ in keys.next())
        return [(burst, pause(rng))]
    made = keys.next()
    if kind < 0.2 and len(made) == 1 and len(made[0][0]) > 1:
        data, last = made[0]
        at = rng.randrange(1, len(data))
        return [(data[:at], pause(rng)), (data[at:], last)]
    return made


def press(session, rng, keys, count):
    """Sends about so many random bytes. Returns whether the program goes on."""
    while len(session.sent) < count:
        if rng.random() < 0.03:
            session.resize(rng)
        for piece, seconds in pieces(rng, keys):
            session.send(piece)
            if not session.is_there(seconds):
                session.fail("it has ended without q")
        if keys.jogs and rng.random() < 0.01:
            session.send(b"q")
            if not session.is_there(1):
                return False
    return True


def random_keys(softcnc, folder, count, seed):
    """Sessions one after the other, with one state. The machine must have moved."""
    rng = random.Random(seed)
    keys = Keys(rng, jogs=True)
    sent, travel, number = 0, 0, 0
    while sent < count:
        number += 1
        session = Session(softcnc, folder, f"random{number}", JERK if number % 2 else [])
        session.send(b"kX0 Y0 Z0\r")
        goes_on = press(session, rng, keys, min(count - sent, count // 4))
        if goes_on:
            session.end_by(signal.SIGTERM if number % 4 < 2 else signal.SIGHUP)
        elif (status := session.wait_for_end()) != 0:
            session.fail(f"exit status {status} after q")
        moved = session.check_files(softcnc)
        print(f"session {number}: {len(session.sent)} bytes, {moved:.1f} mm, "
              f"{'ended from outside' if goes_on else 'q'}", flush=True)
        sent += len(session.sent)
        travel += moved
    assert travel > 10, f"the machine has moved by {travel} mm only"


def keys_that_move_nothing(softcnc, folder, count, seed):
    """No row before the jog key at the end, and that one moves by one step of one axis."""
    session = Session(softcnc, folder, "still")
    session.send(b"kX0 Y0 Z0\r")
    session.is_there(0.5)
    rng = random.Random(seed + 1)
    press(session, rng, Keys(rng, jogs=False), count)
    session.is_there(0.5)
    for key in (ESCAPE, ESCAPE, "u", "r"):
        session.send(key.encode())
        session.is_there(0.3)
    log, before = session.log.read_text(encoding="utf-8"), session.place()
    if re.search("> jog [XYZ]", log) or before != [0, 0, 0]:
        session.fail(f"it has moved to {before} without a jog key")
    session.send(RIGHT.encode())
    session.is_there(1)
    session.send(b"a")
    session.end_by(signal.SIGTERM)
    session.check_files(softcnc)
    places = Trace(session.trace).places
    if places[0].any() or places[:, 1:].any() or places[-1, 0] <= 0:
        session.fail(f"rows from {places[0]} to {places[-1]}, not a step along X")


def main():
    softcnc = os.path.abspath(sys.argv[1])
    count = int(sys.argv[2]) if len(sys.argv) > 2 else BYTES
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else SEED
    print(f"{count} bytes, seed {seed}", flush=True)
    for part in (random_keys, keys_that_move_nothing):
        with tempfile.TemporaryDirectory() as name:
            part(softcnc, pathlib.Path(name), count, seed)


if __name__ == "__main__":
    main()
