#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs a program on LinuxCNC's HAL, by programs/hal/mill.hal, and compares every row.

HAL runs in user space, in name spaces of its own: a session that is there already is not touched.
What streamer put on its pins is read exactly, as doubles, and held against softcnc's own trace.

Without a real-time kernel nobody promises the threads their time, and 10 ms of one without the other
are a following error of 0.2 mm, which ends it all. So that watch is off while rows are compared, the
error is held against how far the threads were apart, and the watch is tried by itself. What is left is
halstreamer without its time until there is no row any more: seen by how long the program that takes
the samples, an ordinary one too, was not let run. Such a run says nothing, and is begun anew.
"""

import argparse
import csv
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
HERE = ROOT / "tests/linuxcnc"
UNPRIVILEGED = 65534
BLU = 0.0025  # mm
MAX_STEP = 21e-3  # mm: limit.x.maxv for a period of 1 ms
SERVO_BEATS = 10  # of charge_pump, in a period of the servo thread
STEP_DELAY = 0.1  # mm: following error of a base thread that is in time
RECOVERY = 100  # periods in which stepgen makes up for it
STARVED = 0.2  # s: not let run for so long
RUNS = 4  # at most
ASTRAY = 0.2  # mm: near.x.max

failures = 0


def check(holds, what):
    global failures
    print(("ok      " if holds else "FAILED  ") + what)
    failures += not holds


class Sample:
    def __init__(self, line):
        *pins, overruns = line.split()
        self.row = tuple(float(pin) for pin in pins[0:3])
        self.runs, self.number, self.ok = pins[3] == "True", int(pins[4]), pins[5] == "True"
        self.limited = tuple(float(pin) for pin in pins[6:9])
        self.actual = tuple(float(pin) for pin in pins[9:12])
        self.error = max(abs(float(pin)) for pin in pins[12:15])
        self.beats, self.overruns = int(pins[15]), int(overruns)
        self.spindle, self.coolant = float(pins[16]), (pins[17] == "True", pins[18] == "True")


class Run:
    """What a session of HAL leaves."""

    def __init__(self, lines):
        *samples, longest = lines
        self.samples = [Sample(line) for line in samples]
        self.longest_gap = float(longest.split()[1])

    def starved(self):
        """Broken off because programs that should have run were not let run."""
        ran = [s for s in self.samples if s.number > 0]
        return self.longest_gap > STARVED and not all(s.ok for s in ran)


class Hal:
    """One session of halrun in a folder of its own."""

    def __init__(self, folder, rows, settings=()):
        self.samples = folder / "samples"
        script = folder / "test.hal"
        script.write_text("\n".join([
            f"source {ROOT}/programs/hal/mill.hal", *settings,
            f"loadusr -w /usr/bin/python3 {HERE}/sample.py {self.samples}", ""]))
        folder.chmod(0o777)  # HAL gives root's rights away before it makes its socket
        isolated = ["unshare", "--ipc", "--mount", "--pid", "--fork", "--kill-child", "--mount-proc"]
        if os.geteuid() != 0:
            isolated += ["--user", "--map-current-user"]
        self.log = folder / "halrun.log"
        environment = dict(os.environ, ROWS=str(rows), HOME=str(folder),
                           RTAPI_UID=str(UNPRIVILEGED), RTAPI_FIFO_PATH=str(folder / "rtapi"))
        with self.log.open("w") as log:
            self.process = subprocess.Popen(isolated + ["halrun", "-f", str(script)], cwd=folder,
                                            env=environment, stdin=subprocess.DEVNULL,
                                            stdout=log, stderr=log)

    def finish(self):
        try:
            status = self.process.wait(timeout=150)
        except subprocess.TimeoutExpired:
            self.process.kill()
            status = self.process.wait()
        if status != 0 or not self.samples.exists():
            sys.exit(f"halrun ended with {status}:\n{self.log.read_text()}")
        return Run(self.samples.read_text().splitlines())


UNWATCHED = [f"setp near.{axis}.{end} {sign}1e9"
             for axis in "xyz" for end, sign in (("min", "-"), ("max", ""))]


def anew(run):
    """The first run that was not starved, or the last one."""
    for count in range(1, RUNS + 1):
        result = run(count)
        if not result[0].starved() or count == RUNS:
            return result
        print(f"        programs were not let run for {result[0].longest_gap:.2f} s: begun anew")


def softcnc(options, *arguments):
    machine = ROOT / "programs/hal/mill.toml"
    return subprocess.run([options.softcnc, "run", "-q", "--machine", machine, *arguments],
                          capture_output=True, text=True, timeout=150, check=False)


def try_unread(options, folder):
    os.mkfifo(folder / "unread")
    early = softcnc(options, f"--set=backend.hal-stream.file={folder / 'unread'}", options.program)
    check(early.returncode == 5 and "[SC6070]" in early.stderr,
          "a FIFO that nobody reads is refused: status 5, SC6070")


def run_live(options, folder):
    """Through a FIFO, at the pace of HAL."""
    folder.mkdir()
    rows, trace, report = folder / "rows", folder / "trace.csv", folder / "report.json"
    os.mkfifo(rows)
    arguments = (f"--set=backend.hal-stream.file={rows}", "--trace", trace, "--report", report,
                 options.program)
    hal = Hal(folder, rows, UNWATCHED)
    for _ in range(100):
        ended = softcnc(options, *arguments)
        if "SC6070" not in ended.stderr:
            break
        time.sleep(0.1)
    return hal.finish(), ended, trace, report


def trace_rows(trace):
    with trace.open() as lines:
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def place_of(row):
    return tuple(float(row[axis + "_mm"]) for axis in "xyz")


def check_outputs(ran, rows):
    """While it moves: M03 and M08 before the line of M04, which adds M07, and these behind it."""
    turn = next(i for i, line in enumerate((HERE / "rows.nc").read_text().splitlines(), 1)
                if line.startswith("M04"))
    moving = [(s, int(row["line"]) < turn) for s, row in zip(ran, rows) if float(row["v_mm_s"]) > 0]
    check(len(moving) > 5000 and all(
        (s.spindle, s.coolant) == ((1200.0, (False, True)) if before else (-1200.0, (True, True)))
        for s, before in moving), f"spindle and coolant are those of the program in {len(moving)} rows")
    check((ran[-1].spindle, ran[-1].coolant) == (0.0, (False, False)), "and off at its end")


def follows(samples):
    """The largest error, and whether each follows from how far one thread was behind the other."""
    shift = [i * SERVO_BEATS - s.beats for i, s in enumerate(samples)]
    in_time = statistics.median(shift)
    apart = [abs(s - in_time) / SERVO_BEATS for s in shift]  # ms
    print(f"        the threads were up to {max(apart):.1f} ms apart")
    late = [max(apart[max(i - RECOVERY, 0):i + 1]) for i in range(len(samples))]
    return (max(s.error for s in samples),
            all(s.error < STEP_DELAY + ms * MAX_STEP for s, ms in zip(samples, late)))


def compare(samples, expected, report):
    ran = [s for s in samples if s.number > 0]
    last = expected[-1]
    numbers = [s.number for s in ran]
    n = len(expected) + 1  # the last one says that the program rests
    print(f"        {n} rows, {len(samples)} samples")
    check(report["stream_rows"] == n, "softcnc counts as many rows as its trace has, and the last")
    check(numbers[:n] == list(range(1, n + 1)), "HAL got every row once, one each period")
    check(set(numbers[n:]) <= {n}, "and holds the last one")
    check(all(s.row == e for s, e in zip(ran, expected + [last])), "all rows are equal, bit for bit")
    check([s.runs for s in ran[:n]] == [True] * (n - 1) + [False], "the last row alone is at rest")
    check(all(s.limited == s.row for s in samples), "limit3 changes nothing")
    check(all(s.overruns == 0 for s in samples), "sampler lost nothing")
    check(all(s.ok for s in ran), "the emergency stop stays off")
    error, explained = follows(samples)
    check(explained, f"stepgen follows within {error:.4f} mm, as far as its thread is in time")
    off = max(abs(a - e) for a, e in zip(ran[-1].actual, last))
    check(off < BLU, f"and comes to rest {off / BLU:.4f} BLU from the end")


def written_rows(options, folder):
    file = folder / "all_rows"
    ended = softcnc(options, f"--set=backend.hal-stream.file={file}", options.program)
    check(ended.returncode == 0, f"the same rows go into a file: status {ended.returncode}")
    return file.read_text().splitlines()


def run_file(folder, name, lines, settings=()):
    inner = folder / name
    inner.mkdir()
    (inner / "rows").write_text("\n".join(lines) + "\n")
    return Hal(inner, inner / "rows", settings).finish().samples


def is_slow(places):
    return all(abs(b - a) <= MAX_STEP + 1e-12
               for p, q in zip(places, places[1:]) for a, b in zip(p, q))


def with_damage(lines, at):
    x, *others = lines[at].split()
    return lines[:at] + [" ".join([str(float(x) + 5), *others])] + lines[at + 1:]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--softcnc", required=True)
    parser.add_argument("program", nargs="?", default=HERE / "rows.nc", type=Path)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        folder.chmod(0o711)
        try_unread(options, folder)
        run, ended, trace, report = anew(lambda count: run_live(options, folder / f"live{count}"))
        check(ended.returncode == 0, f"softcnc ran: status {ended.returncode} {ended.stderr}")
        rows = trace_rows(trace)
        compare(run.samples, [place_of(row) for row in rows], json.loads(report.read_text()))
        if options.program == HERE / "rows.nc":
            check_outputs([s for s in run.samples if s.number > 0], rows)
        lines = written_rows(options, folder)
        broken = run_file(folder, "broken", lines[:len(lines) // 2], UNWATCHED)
        check(broken[-1].runs and not broken[-1].ok,
              "rows that break off latch the emergency stop")
        check(broken[-1].spindle == 0 and not any(broken[-1].coolant),
              "which switches spindle and coolant off")
        damaged = run_file(folder, "damaged", with_damage(lines, len(lines) // 2),
                           UNWATCHED)
        check(not is_slow([s.row for s in damaged]) and is_slow([s.limited for s in damaged]),
              "a damaged row makes no jump: limit3 keeps its speed")
        astray = run_file(folder, "astray", lines, ["setp stepgen.0.maxvel 1"])
        check(not astray[-1].ok and max(s.error for s in astray if s.ok) < ASTRAY,
              "steps that lag behind latch it, too")
    print(f"{failures} failed")
    return 1 if failures else 0


sys.exit(main())
