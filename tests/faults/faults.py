#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Lets every call of the system that softcnc makes fail once, and allocations spread evenly, and looks at what is left.

    tests/faults/faults.py SOFTCNC LIBFAULTS.so [--allocations N] [--kills N] [SCENARIO...]

After a fault, whatever the exit status, each file to be written is the old one or the new one, whole (a state file
may also have the mark of a motion, or the place where that ended before its time); nothing else has been left, neither beside them nor in the folder for temporary files; nothing hangs. Status 0 is for new files alone;
otherwise it is 5, or 2 where a file that says how to run could not be read, and an error with its code has been shown.

With --kills, runs are killed at moments spread evenly instead: each file is the old or the new one, whole, and later runs
remove every file that has been left; the last one names those that it finds.

Shows how many faults there were and what came of them; exit 1 if anything is broken.
"""
import argparse
import collections
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import tomllib
from dataclasses import dataclass, field

KINDS = ("open", "read", "write", "sync", "rename", "allocation")
SECONDS = 30   # no run takes a hundredth of it

PROGRAM = """G21 G90 F3000
o<bow> call
G10 L2 P2 X1.5
G01 X0 Y0
M02
"""
BOW = """o<bow> sub
  G02 X4 Y0 I2 J0
o<bow> endsub
M02
"""
MACHINE = """[axis.x]
acceleration_mm_s2 = 2000.0
[axis.y]
[axis.z]
"""
STATE = """schema = 1
"""


@dataclass(frozen=True)
class Scenario:
    """A command line, and the files that it writes."""
    arguments: tuple
    writes: tuple = ()
    inputs: dict = field(default_factory=lambda: {
        "part.nc": PROGRAM, "bow.ngc": BOW, "mill.toml": MACHINE, "mill.state.toml": STATE})
    allocates: bool = True  # allocations fail, too


RUN = ("--machine", "mill.toml", "part.nc")
QUIET = ("--quiet", "--progress", "none")
MILLED = {"part.nc": """G21 G90 F600
T1 M06
S6000 M03
G00 X0 Y0 Z0
G01 X2
G00 Y0.5
G01 X0
M02
""", "mill.toml": MACHINE + """[tool.1]
radius_mm = 3.0
teeth = 2
[stock]
origin_mm = [0.0, 0.0, -1.0]
x_mm = 2.0
y_mm = 0.5
grid_um = 50.0
"""}
SCENARIOS = {
    "run": Scenario(("run", *QUIET, "--trace", "trace.csv", "--report", "report.json", "--state", "mill.state.toml", *RUN),
                    ("trace.csv", "report.json", "mill.state.toml")),
    "npz": Scenario(("run", *QUIET, "--trace", "trace.npz", *RUN), ("trace.npz",)),
    "zst": Scenario(("run", *QUIET, "--backend", "sim", "--trace", "trace.csv.zst", *RUN), ("trace.csv.zst",)),
    "stepdir": Scenario(("run", *QUIET, "--backend", "stepdir", "--set", "backend.stepdir.file=steps.vcd", *RUN),
                        ("steps.vcd",)),
    "record": Scenario(("record", *QUIET, "-o", "part.rec", *RUN), ("part.rec",)),
    "replay": Scenario(("replay", "--quiet", "part.rec")),
    "surface": Scenario(("surface", *QUIET, "-o", "surface.npz", *RUN), ("surface.npz",), MILLED),
    "compare": Scenario(("compare", *QUIET, "--phases", "2", "--methods", "arc-length,dda", "-o", "compare.txt", *RUN),
                        ("compare.txt",)),
    "picture": Scenario(("surface", *QUIET, "-o", "surface.png", *RUN), ("surface.png",), MILLED,
                        allocates=False),  # fontconfig does not check all of its own
}


@dataclass(frozen=True)
class Ending:
    status: int
    errors: str
    files: dict      # name: bytes, in the folder
    temporary: list  # names in the folder for temporary files


class Bench:
    """Runs a scenario in folders of its own, with a fault or until it is killed."""

    def __init__(self, softcnc, faults, scenario):
        self.softcnc, self.faults, self.scenario = softcnc, faults, scenario
        self.inputs = {name: text.encode() for name, text in scenario.inputs.items()}
        if "part.rec" in scenario.arguments and "part.rec" not in scenario.writes:
            recorded = Bench(softcnc, faults, SCENARIOS["record"]).run().files
            self.inputs["part.rec"] = recorded["part.rec"]
        self.old = {name: self.inputs.get(name, b"old\n") for name in scenario.writes}
        counts = {}
        self.whole = self.run(counts=counts)
        assert self.whole.status == 0, self.whole.errors
        self.counts = counts

    def prepare(self, folder):
        for name, content in (self.inputs | self.old).items():
            (folder / name).write_bytes(content)

    def start(self, folder, temporary, environment):
        return subprocess.Popen([self.softcnc, *self.scenario.arguments], cwd=folder, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace",
                                env={**os.environ, "TMPDIR": str(temporary), **environment})

    def run(self, kind="", at=0, counts=None):
        with tempfile.TemporaryDirectory() as place:
            folder, temporary = pathlib.Path(place) / "work", pathlib.Path(place) / "tmp"
            folder.mkdir(), temporary.mkdir()
            self.prepare(folder)
            counted = pathlib.Path(place) / "counts"
            process = self.start(folder, temporary, {"LD_PRELOAD": self.faults, "FAULT_KIND": kind,
                                                     "FAULT_AT": str(at), "FAULT_COUNT": str(counted)})
            status, errors = ended(process)
            if counts is not None:
                counts |= {name: int(number) for name, number in map(str.split, counted.read_text().splitlines())}
            return Ending(status, errors, contents(folder), os.listdir(temporary))

    def broken(self, ending):
        """What is wrong with what a fault has left, in words."""
        if ending.status is None:
            return "hangs"
        found = self.broken_files(ending.files)
        if set(ending.files) != set(self.whole.files):
            found.append(f"files {sorted(set(ending.files) ^ set(self.whole.files))}")
        if ending.temporary:
            found.append(f"temporary files {ending.temporary}")
        if ending.status == 0 and any(self.is_old(name, ending.files) for name in self.scenario.writes):
            found.append("status 0, and an old file")
        if ending.status not in (0, 2, 5):
            found.append(f"status {ending.status}")
        if ending.status in (2, 5) and "error: " not in ending.errors:
            found.append(f"status {ending.status} without a word")
        return ", ".join(found)

    def broken_files(self, files):
        return [f"{name} is neither the old nor the new one" for name in self.scenario.writes
                if not self.is_old(name, files) and not self.is_new(name, files)]

    def is_old(self, name, files):
        return files.get(name) == self.old[name] != self.whole.files[name]

    def is_new(self, name, files):
        if name.endswith(".json"):  # has times
            return name in files and is_json(files[name])
        if name.endswith(".state.toml"):  # has the mark of a motion, or where it ended before its time
            return is_whole_state(files.get(name, b""))
        return files.get(name) == self.whole.files[name]


def ended(process):
    """Status (None: it hangs) and standard error."""
    try:
        _, errors = process.communicate(timeout=SECONDS)
        return process.returncode, errors
    except subprocess.TimeoutExpired:
        process.kill()
        return None, process.communicate()[1]


def contents(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def is_whole_state(content):
    """Whether it is a state file from its first key to its last table."""
    try:
        return {"schema", "work", "parameter"} <= tomllib.loads(content.decode()).keys()
    except ValueError:
        return False


def is_json(content):
    try:
        return isinstance(json.loads(content), dict)
    except ValueError:
        return False


def spread(count, most):
    """At most so many numbers from 1 to count, evenly."""
    return range(1, count + 1) if count <= most else [1 + i * (count - 1) // (most - 1) for i in range(most)]


def fail_each(name, bench, allocations):
    """Shows what came of all faults of a scenario; returns how many left something broken."""
    bad = 0
    statuses = collections.Counter()
    for kind in KINDS if bench.scenario.allocates else KINDS[:-1]:
        for at in spread(bench.counts[kind], allocations if kind == "allocation" else sys.maxsize):
            ending = bench.run(kind, at)
            statuses[kind, ending.status] += 1
            if wrong := bench.broken(ending):
                bad += 1
                print(f"{name}: {kind} {at} of {bench.counts[kind]}: {wrong}\n{ending.errors}", flush=True)
    counted = ", ".join(f"{kind} {sum(n for (k, _), n in statuses.items() if k == kind)}" for kind in KINDS)
    by_status = collections.Counter()
    for (_, status), number in statuses.items():
        by_status[status] += number
    ends = ", ".join(f"{number} with {status}" for status, number in sorted(by_status.items(), key=str))
    print(f"{name}: {counted}; ended {ends}; {bad} broken", flush=True)
    return bad


def kill_many(name, bench, kills):
    """The same of runs that are killed, which all write to one folder."""
    bad = done = 0
    left = set()
    with tempfile.TemporaryDirectory() as place:
        folder, temporary = pathlib.Path(place) / "work", pathlib.Path(place) / "tmp"
        folder.mkdir(), temporary.mkdir()
        bench.prepare(folder)
        began = time.monotonic()
        ended(bench.start(folder, temporary, {}))
        longest = 1.1 * (time.monotonic() - began)
        known = set(bench.whole.files)
        for i in range(kills):
            bench.prepare(folder)
            process = bench.start(folder, temporary, {})
            time.sleep(longest * i / kills)
            process.send_signal(signal.SIGKILL)
            status, _ = ended(process)
            done += status == 0
            for wrong in bench.broken_files(contents(folder)):
                bad += 1
                print(f"{name}: killed after {longest * i / kills:.4f} s: {wrong}", flush=True)
            left |= set(os.listdir(folder)) - known
        strays = set(os.listdir(folder)) - known
        bench.prepare(folder)  # a run killed in motion leaves the position unknown, and the next one refuses
        status, errors = ended(bench.start(folder, temporary, {}))
        bad += status != 0
        bad += set(os.listdir(folder)) != known
        for stray in strays:
            named = stray in errors or stray.endswith(".softcnc-lock")  # which is taken over without a note
            if not named or (folder / stray).exists():
                bad += 1
                print(f"{name}: the next run does not name {stray}, or leaves it", flush=True)
        for stray in os.listdir(temporary):
            bad += 1
            print(f"{name}: {stray} is left in the folder for temporary files", flush=True)
    print(f"{name}: {kills - done} of {kills} runs killed, {len(left)} files left and gone after later runs; {bad} broken",
          flush=True)
    return bad


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("softcnc", type=os.path.abspath)
    parser.add_argument("faults", type=os.path.abspath)
    parser.add_argument("--allocations", type=int, default=200, help="that fail, of each scenario")
    parser.add_argument("--kills", type=int, default=0)
    parser.add_argument("scenarios", nargs="*", metavar="SCENARIO", help=", ".join(SCENARIOS))
    options = parser.parse_intermixed_args()
    bad = 0
    for name in options.scenarios or SCENARIOS:
        bench = Bench(options.softcnc, options.faults, SCENARIOS[name])
        if options.kills:
            bad += kill_many(name, bench, options.kills) if SCENARIOS[name].writes else 0
        else:
            bad += fail_each(name, bench, options.allocations)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
