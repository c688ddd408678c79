# SPDX-License-Identifier: MIT
"""What softcnc and its measuring programs give: runs as columns, and the files of numbers."""
import csv
import json
import math
import pathlib
import subprocess
import tempfile

import numpy

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PROGRAMS = ROOT / "programs"


class Tools:
    """The programs that measure: softcnc, and those of bench."""

    def __init__(self, softcnc, bench):
        self.softcnc, self.bench = pathlib.Path(softcnc), pathlib.Path(bench)

    def rows_of(self, program, *arguments):
        """The lines that a program of bench prints, as lists of texts."""
        text = subprocess.run([self.bench / program, *arguments], check=True, capture_output=True,
                              text=True).stdout
        return [line.replace("\t", ",").split(",") for line in text.splitlines()]

    def _call(self, *arguments):
        subprocess.run([self.softcnc, *arguments], check=True, stdin=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)

    def run(self, part, settings=(), text=None, replace=None):
        """Columns of the trace of a run, by name, with those of its report as `report`.

        `part` is a program of programs/; `text`, if given, is run instead of it, with the machine
        beside `part`; `replace` is {old: new} in its text.
        """
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            trace, report = folder / "trace.npz", folder / "report.json"
            self._call("run", self._part(folder, part, text, replace), "--quiet", *self._set(settings),
                       "--progress", "none", "--trace", trace, "--report", report)
            with numpy.load(trace) as file:
                columns = {name: file[name] for name in file.files}
            return columns | {"report": json.loads(report.read_text())}

    def compare(self, part, methods, phases, settings=()):
        """The rows of a comparison of methods on a program of programs/: {method: {key: value}}."""
        text = subprocess.run([self.softcnc, "compare", PROGRAMS / part, "--quiet", "--progress", "none",
                               "--format", "json", "--methods", ",".join(methods), "--phases", str(phases),
                               *self._set(settings)],
                              check=True, capture_output=True, text=True, stdin=subprocess.DEVNULL).stdout
        return {row["method"]: row for row in json.loads(text)["rows"]}

    def step_times(self, text, settings=(), line="x_step"):
        """The instants, s, of the rising edges of a step line."""
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            edges = folder / "edges.vcd"
            self._call("run", self._part(folder, None, text), "--quiet", "--progress", "none", "--backend",
                       "stepdir", "--set", f"backend.stepdir.file={edges}", *self._set(settings))
            return numpy.array(list(rising_edges(edges, line)))

    def surface(self, part, settings=(), text=None, replace=None):
        """The arrays of a machined surface, by name."""
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            out = folder / "surface.npz"
            self._call("surface", self._part(folder, part, text, replace), "--quiet", "--progress", "none",
                       *self._set(settings), "-o", out)
            with numpy.load(out) as file:
                return {name: file[name] for name in file.files}

    def blocks(self, part):
        text = subprocess.run([self.softcnc, "blocks", "--quiet", PROGRAMS / part], check=True,
                              capture_output=True, text=True, stdin=subprocess.DEVNULL).stdout
        return [json.loads(line) for line in text.splitlines()]

    @staticmethod
    def _set(settings):
        return [word for setting in settings for word in ("--set", setting)]

    @staticmethod
    def _part(folder, part, text, replace=None):
        """The file to run, in `folder`: with the machine that is beside `part`."""
        text = text or (PROGRAMS / part).read_text()
        for old, new in (replace or {}).items():
            assert old in text, old
            text = text.replace(old, new)
        (folder / "part.nc").write_text(text)
        machine = (PROGRAMS / part).with_suffix(".toml") if part else None
        if machine and machine.exists():
            (folder / "part.toml").write_text(machine.read_text())
        return folder / "part.nc"


def rising_edges(dump, line):
    """The instants, s, at which a line of a value change dump (scale 1 ns) rises."""
    name, now = None, 0
    with open(dump, encoding="ascii") as text:
        for row in text:
            if row.startswith("$var") and f" {line} " in row:
                name = row.split()[3]
            elif row.startswith("#"):
                now = int(row[1:])
            elif name and row.strip() == f"1{name}":
                yield now * 1e-9


def cuts(trace):
    """Which rows lie in moves with a feed, and the row at which the last one ends."""
    inside = trace["feed_mm_s"] > 0
    last = numpy.flatnonzero(inside)[-1]
    inside[min(last + 1, len(inside) - 1)] = True
    return inside


def rounded(value, digits):
    """A number as a file has it: `digits` after the point, without zeros that say nothing."""
    if isinstance(value, str):
        return value
    if not math.isfinite(value):
        return "nan"
    text = f"{value:.{digits}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def write(path, columns, digits):
    """Writes {name: values} as CSV; `digits` after the point, by name."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(columns)
        for row in zip(*columns.values()):
            out.writerow(rounded(value, digits.get(name, 4)) for name, value in zip(columns, row))


def read(path):
    """{name: values} of a CSV file: numbers as arrays, words as lists."""
    with open(path, newline="", encoding="utf-8") as file:
        names, *rows = csv.reader(file)
    columns = {}
    for i, name in enumerate(names):
        words = [row[i] for row in rows]
        try:
            columns[name] = numpy.array([float(word) for word in words])
        except ValueError:
            columns[name] = words
    return columns
