#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Hostile bytes at `softcnc serve`, by TCP and through its pseudo-terminal.

    tests/apps/serve_bytes.py SOFTCNC [BYTES [SEED]]

Sessions of some hundred random bytes: any values, lines of grbl whole and broken, real-time bytes
anywhere, and lines of up to 100,000 bytes beside them. Half of them go to a TCP port, each by a
connection of its own that may vanish; half go through the pseudo-terminal to a machine with limits
of jerk. What must hold: every line gets one answer and no line two (those that a reset or a client
that vanishes takes away get none), everything heard consists of whole lines in grbl's forms, `?` is
answered at once, `!` stops the machine, the places of reports are rows of the trace, and every row
is within the limits of the machine.
"""
import os
import pathlib
import random
import re
import select
import sys
import tempfile
import time

from grbl_client import Server, by_tcp, by_terminal
from trace_limits import AXES, Limits, Trace, exceeded

BYTES, SEED, PER_SESSION = 20000, 20261129, 100
JERK = [word for axis in AXES for word in ("--set", f"axis.{axis}.jerk_mm_s3=20000")]
SANITIZED = "SOFTCNC_SANITIZED" in os.environ  # slow, and freed memory is kept for a while
REPORT_WITHIN, STOP_WITHIN, ANSWERS_WITHIN = (20, 20, 20) if SANITIZED else (2, 4, 3)  # s
ENDLESS = ["--set", "program.block_limit=2000"]  # loops without end are given up soon
LEAST_TRAVEL = 10  # mm
MOST_MORE = 64 << 20  # bytes of memory that the server may get more

RESET = 0x18
REAL_TIME = [*b"?!~", RESET, 0x84, 0x85, *range(0x90, 0x98), *range(0x99, 0x9F), 0xA0, 0xA1]
NUMBER, STATES = r"-?\d+\.\d{3,4}", r"Idle|Run|Hold:[01]|Jog|Home|Alarm|Check|Door:[0-3]|Sleep"
PLACE = f"{NUMBER},{NUMBER},{NUMBER}"
REPORT = re.compile(
    rf"<({STATES})\|([MW]Pos):({PLACE})(\|Bf:\d+,\d+)?(\|Ln:\d+)?\|FS:\d+,\d+(\|WCO:{PLACE})?"
    r"(\|Ov:\d+,\d+,\d+(\|A:[SCFM]+)?)?>")
ANSWER = re.compile(r"ok|error:\d+")
OTHERS = re.compile(  # messages show bytes of lines: tabs, and U+FFFD in place of others
    r"|Grbl 1\.1h \['\$' for help\]|ALARM:\d|\[MSG:[^\x00-\x08\x0a-\x1f\x7f]*\]"
    r"|\[GC:[A-Z0-9 .-]*\]|\[VER:[ -~]*\]"
    rf"|\[OPT:[A-Z]+,\d+,\d+\]|\[HLP:[ -~]*\]|\$\d+=-?\d+(\.\d{{3}})?|\$N[01]="
    rf"|\[(G5[4-9]|G28|G30|G92):{PLACE}\]|\[TLO:{NUMBER}\]|\[PRB:{PLACE}:[01]\]")
LINES = [b"G1 X1 F3000", b"G91 G1 X5 Y-2 F8000", b"G90 G0 X0 Y0 Z0", b"G2 X5 Y5 I2 J3 F2000",
         b"X3 Y4", b"$J=G91 X2 F5000", b"$J=G90 Y0 F3000", b"$J=X9999 F100", b"$$", b"$#", b"$G",
         b"$I", b"$N", b"$", b"$X", b"$H", b"$C", b"$SLP", b"$10=1", b"$13=0", b"$110=500",
         b"$x=1", b"G4 P0.01", b"M3 S1000", b"M5", b"M0", b"M2", b"M30", b"%", b"",
         b"(a comment ?)", b"G38.2 Z-5 F100", b"G10 L20 P1 X0", b"G92 X1", b"G54", b"T1 M6",
         b"G20", b"G21", b"G64 P0.1", b"G5 X1 Y1 I0 J1 P0 Q-1 F1000", b"O1 while [1 LT 3]",
         b"O1 endwhile", b"#1=[1/0]", b"G1 X[#1+2] F1000", b"G1", b"F", b"G1 X1 X2"]


class Sender:
    """A connection, what was sent by it, and what it has heard.

    Lines are counted in the stretches between resets. The server answers each stretch in turn, and
    its banner ends one; the banner that a leaving of Check brings does not.
    """

    def __init__(self, line):
        self.descriptor, self.owner = line.descriptor, line.owner
        os.set_blocking(self.descriptor, False)
        self.heard = b""
        self.lines = [0]  # sent, in each stretch
        self.at, self.answers = 0, 0  # the stretch that is heard, and the answers in it
        self.reports, self.all_answers, self.leaves_check = [], 0, 0
        self.sent, self.said = b"", []  # the last of each, for a failure

    def close(self):
        if self.owner:
            self.owner.close()
        else:
            os.close(self.descriptor)

    def fail(self, what):
        raise AssertionError(f"{what}; sent last: {self.sent!r}; "
                             f"heard last: {self.said} {self.heard!r}")

    def count(self, data):
        for byte in data:
            if byte == RESET:
                self.lines.append(0)
            elif byte in b"\r\n":
                self.lines[-1] += 1

    def send(self, data):
        """Sends all of it, and hears meanwhile; the server must always go on reading."""
        self.count(data)
        self.sent = (self.sent + data)[-2000:] if data != b"?" else self.sent
        last = time.monotonic()
        while data:
            _, ready, _ = select.select([], [self.descriptor], [], 0.05)
            if ready:
                size = os.write(self.descriptor, data[:4096])
                data, last = data[size:], time.monotonic()
            self.hear(0)
            if time.monotonic() - last > ANSWERS_WITHIN:
                self.fail(f"no byte is taken for {ANSWERS_WITHIN} s")

    def hear(self, seconds):
        if not select.select([self.descriptor], [], [], seconds)[0]:
            return
        data = os.read(self.descriptor, 65536)
        if not data:
            self.fail("the server has closed the connection")
        *lines, self.heard = (self.heard + data).split(b"\r\n")
        for line in lines:
            self.said = [*self.said[-30:], line]
            self.take(line.decode("latin-1"))

    def take(self, line):
        if ANSWER.fullmatch(line):
            self.answers += 1
            self.all_answers += 1
            if self.answers > self.lines[self.at]:
                self.fail(f"{self.answers} answers to {self.lines[self.at]} lines")
        elif report := REPORT.fullmatch(line):
            self.reports.append(report)
        elif not OTHERS.fullmatch(line):
            self.fail(f"'{line}' is no line of grbl")
        if line == "[MSG:Disabled]":
            self.leaves_check += 1
        if line.startswith("Grbl"):
            self.take_banner()

    def take_banner(self):
        if self.leaves_check:
            self.leaves_check -= 1
            return
        self.at += 1
        self.answers = 0
        if self.at >= len(self.lines):
            self.fail("a banner without a reset")

    def wait_for(self, is_so, seconds):
        end = time.monotonic() + seconds
        while not is_so():
            left = end - time.monotonic()
            if left <= 0:
                return False
            self.hear(left)
        return True

    def is_even(self):
        """Whether every line since the last reset has its answer."""
        return self.at == len(self.lines) - 1 and self.answers == self.lines[-1]

    def report(self):
        """Asks for a report; returns its state."""
        known = len(self.reports)
        self.send(b"?")
        if not self.wait_for(lambda: len(self.reports) > known, REPORT_WITHIN):
            self.fail(f"no report within {REPORT_WITHIN} s")
        return self.reports[-1][1]

    def stop(self):
        """`!` brings whatever moves to rest; not homing, which this machine has not."""
        self.send(b"!")
        end = time.monotonic() + STOP_WITHIN
        while (state := self.report()) in ("Run", "Jog", "Hold:1", "Door:2"):
            if time.monotonic() > end:
                self.fail(f"{state}, {STOP_WITHIN} s after '!'")

    def settle(self):
        """Waits for all answers, and goes on where the machine is held. Returns whether all came.

        Asleep, or in a dwell of hours, nothing is answered before a reset. In a state in which
        lines are read, no answer may be missing.
        """
        end, state = time.monotonic() + ANSWERS_WITHIN, ""
        while not self.is_even() and time.monotonic() < end and state != "Sleep":
            state = self.report()
            self.send(b"~")
            self.wait_for(self.is_even, 0.03)
        if self.is_even():
            return True
        if state in ("Idle", "Alarm", "Check"):
            self.fail(f"{self.answers} answers to {self.lines[self.at:]} lines in {state}")
        self.reset()
        return False

    def reset(self):
        self.send(bytes([RESET]))
        if not self.wait_for(self.is_even, ANSWERS_WITHIN):
            self.fail("no banner after a reset")


class Noise:
    """Random bytes of a sender that has lost its mind."""

    def __init__(self, rng):
        self.rng = rng

    def piece(self):
        rng = self.rng
        kind = rng.random()
        if kind < 0.45:
            return rng.choice(LINES) + rng.choice([b"\n", b"\n", b"\r", b"\r\n", b""])
        if kind < 0.6:
            return self.broken(rng.choice(LINES)) + b"\n"
        if kind < 0.75:
            return bytes(rng.choices(REAL_TIME, k=rng.randint(1, 2)))
        if kind < 0.9:
            return rng.randbytes(rng.randint(1, 20))
        return bytes(rng.choices(b"GXYZFIJKMSTPN$=#[]0123456789.-+() \t\n", k=rng.randint(1, 30)))

    def broken(self, line):
        """With some bytes changed, left out, or put in."""
        text = bytearray(line)
        for _ in range(self.rng.randint(1, 3)):
            at = self.rng.randint(0, len(text))
            text[at:at + self.rng.randint(0, 2)] = self.rng.randbytes(self.rng.randint(0, 2))
        return bytes(text)

    def long_line(self):
        return bytes(self.rng.choices(b"GX1 (-.", k=self.rng.randint(4000, 100000)))


class Totals:
    """What all sessions together have come to."""

    def __init__(self):
        self.sessions = self.bytes = self.answers = self.settled = self.given_up = self.stops = 0
        self.slowest, self.places = 0.0, set()

    def add_report_time(self, seconds):
        self.slowest = max(self.slowest, seconds)

    def add(self, sender):
        """Takes over the answers and the places in mm of reports, and forgets them there."""
        self.answers += sender.all_answers
        self.places |= {report[3] for report in sender.reports
                        if report[2] == "MPos" and report[3].count(".") == 3
                        and len(report[3].rsplit(".", 1)[1]) == 3}
        sender.all_answers, sender.reports = 0, []


def begin_at_rest(sender):
    """A machine that nobody has locked, and with something to do."""
    sender.send(b"\n")
    sender.stop()
    sender.reset()
    sender.send(b"$X\nG21 G91 G1 X1 Y-0.5 F4000\nG90 X0 Y0\n")


def session(sender, noise, totals):
    """Random bytes, now and then with a look, a stop, or the wait for all answers."""
    rng = noise.rng
    if rng.random() < 0.6:
        begin_at_rest(sender)
    else:
        sender.send(rng.choice([b"\n", b"\x18", b"\n$X\n", b"\x18$X\n", b"~\n$X\n"]))
    left = rng.randint(PER_SESSION // 2, PER_SESSION * 3 // 2)
    if rng.random() < 0.01:
        sender.send(noise.long_line())
    while left > 0:
        data = noise.piece()[:left]
        sender.send(data)
        left -= len(data)
        totals.bytes += len(data)
        if rng.random() < 0.1:
            sender.wait_for(lambda: False, rng.uniform(0, 0.03))
    begin = time.monotonic()
    sender.report()
    totals.add_report_time(time.monotonic() - begin)
    end = rng.random()
    if end < 0.1:
        sender.stop()
        totals.stops += 1
    elif end < 0.4:
        sender.send(b"\n")
        if sender.settle():
            totals.settled += 1
        else:
            totals.given_up += 1
    totals.sessions += 1


def by_connections(server, noise, count, totals):
    """A connection for each session, which vanishes whatever moves."""
    while totals.bytes < count:
        sender = Sender(by_tcp(server.port))
        session(sender, noise, totals)
        totals.add(sender)
        sender.close()


def by_one_terminal(server, noise, count, totals):
    """One connection for all of them, that nobody closes."""
    sender = Sender(by_terminal(server.link))
    while totals.bytes < count:
        session(sender, noise, totals)
        totals.add(sender)
    sender.close()


def memory_of(process):
    """Resident, in bytes."""
    text = pathlib.Path(f"/proc/{process.pid}/status").read_text(encoding="utf-8")
    return 1024 * int(re.search(r"VmRSS:\s*(\d+)", text)[1])


def last_look(server):
    """It is alive, and does what a sender asks for: a move."""
    sender = Sender(by_tcp(server.port))
    sender.send(b"\n")
    sender.reset()
    sender.settle()
    sender.send(b"$X\nG21 G91 G1 X1 F1000\nG4 P0\n")
    if not sender.wait_for(sender.is_even, ANSWERS_WITHIN):
        sender.fail("the last lines have no answers")
    if sender.report() != "Idle":
        sender.fail("it is not idle after the last line")
    sender.close()


def as_reported(mm):
    return f"{0.0 if abs(mm) < 0.0005 else mm:.3f}"


def check_trace(softcnc, file, options, places):
    """Limits, and that reports show places where the machine was. Returns the travel in mm."""
    trace = Trace(file)
    wrong = exceeded(trace, Limits(softcnc, ["--machine", "builtin", *options]))
    assert not wrong, "; ".join(wrong)
    rows = {",".join(map(as_reported, row)) for row in trace.places}
    elsewhere = sorted(places - rows - {"0.000,0.000,0.000"})
    assert not elsewhere, f"{len(elsewhere)} reports of places that no row has: {elsewhere[:5]}"
    return trace.travel()


def hostile(softcnc, folder, sessions, options, count, seed):
    """Returns what to print."""
    trace, begin = folder / "rows.npz", time.monotonic()
    server = Server(softcnc, folder, "--trace", str(trace), *options)
    try:
        totals, before = Totals(), memory_of(server.process)
        sessions(server, Noise(random.Random(seed)), count, totals)
        took, grown = time.monotonic() - begin, memory_of(server.process) - before
        last_look(server)
        server.end()
    finally:
        server.process.kill()  # where a check has failed
    travel = check_trace(softcnc, trace, options, totals.places)
    assert travel > LEAST_TRAVEL, f"the machine has moved by {travel} mm only"
    assert totals.settled > totals.given_up, f"{totals.given_up} sessions without all answers"
    assert grown < MOST_MORE or SANITIZED, f"{grown} bytes of memory more"
    return (f"{totals.bytes} bytes in {totals.sessions} sessions, {took:.1f} s: "
            f"{totals.answers} answers; {totals.settled} sessions waited for all, "
            f"{totals.given_up} gave up; {totals.stops} stops; slowest report "
            f"{1000 * totals.slowest:.0f} ms; {len(totals.places)} places of reports; "
            f"{travel:.0f} mm; memory {before >> 10} KiB, {grown / 1024:+.0f} KiB")


def main():
    softcnc = os.path.abspath(sys.argv[1])
    count = int(sys.argv[2]) if len(sys.argv) > 2 else BYTES
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else SEED
    for sessions, options in ((by_connections, ENDLESS), (by_one_terminal, JERK + ENDLESS)):
        with tempfile.TemporaryDirectory() as name:
            said = hostile(softcnc, pathlib.Path(name), sessions, options, count // 2, seed)
            print(f"{sessions.__name__}, seed {seed}: {said}", flush=True)


if __name__ == "__main__":
    main()
