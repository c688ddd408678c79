#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs a program and compares every row and column, bit for bit, with what hashes.tsv keeps of it.

usage: golden.py SOFTCNC PROGRAM      exit 1 if a bit differs
       golden.py SOFTCNC --make       writes hashes.tsv and 01_line.csv again

Of 01_line.nc all rows are kept in 01_line.csv, so that a difference of numbers can be read. What
differs in another program is shown by `softcnc record` before the change and `softcnc replay` after.
"""

import hashlib
import pathlib
import subprocess
import sys
import tempfile

import numpy

here = pathlib.Path(__file__).resolve().parent
programs = here.parent.parent / "programs"
table, readable = here / "hashes.tsv", here / "01_line.csv"

# The paper's own mill is simulated; of the others the commanded motion counts.
SIMULATED = {"13_paper003_shapes"}


def run(softcnc, name, trace):
    backend = "sim" if name in SIMULATED else "none"
    command = [softcnc, "run", programs / f"{name}.nc", "--backend", backend,
               "--trace", trace, "--quiet", "--progress", "none"]
    subprocess.run(command, check=True, stdin=subprocess.DEVNULL)


def rows_and_hash(softcnc, name):
    with tempfile.TemporaryDirectory() as folder:
        trace = pathlib.Path(folder) / "trace.npz"
        run(softcnc, name, trace)
        columns = numpy.load(trace)
    digest = hashlib.sha256()
    for column in sorted(columns.files):
        if columns[column].ndim == 0:
            continue
        digest.update(column.encode())
        digest.update(numpy.ascontiguousarray(columns[column]).tobytes())
    return len(columns["t_s"]), digest.hexdigest()[:32]


def text_of(softcnc, name):
    with tempfile.TemporaryDirectory() as folder:
        trace = pathlib.Path(folder) / "trace.csv"
        run(softcnc, name, trace)
        lines = trace.read_text().splitlines()
    return [line for line in lines if not line.startswith("#")]


def kept():
    lines = (line.split("\t") for line in table.read_text().splitlines() if not line.startswith("#"))
    return {name: (int(rows), digest) for name, rows, digest in lines}


def compare(softcnc, name):
    if name == readable.stem:
        was, now = readable.read_text().splitlines(), text_of(softcnc, name)
        for number, (old, new) in enumerate(zip(was, now), start=1):
            if old != new:
                return f"line {number} was\n  {old}\nand is\n  {new}"
        if len(was) != len(now):
            return f"there were {len(was)} lines, and there are {len(now)}"
    was, now = kept().get(name), rows_and_hash(softcnc, name)
    if was is None:
        return f"{table.name} does not list it; scripts/generate golden does that"
    return "" if was == now else f"{was[0]} rows of hash {was[1]} are now {now[0]} of {now[1]}"


def make(softcnc):
    names = sorted(path.stem for path in programs.glob("*.nc"))
    lines = ["# program\trows\thash of all columns: tests/golden/golden.py"]
    for name in names:
        rows, digest = rows_and_hash(softcnc, name)
        lines.append(f"{name}\t{rows}\t{digest}")
    table.write_text("\n".join(lines) + "\n")
    readable.write_text("\n".join(text_of(softcnc, readable.stem)) + "\n")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    if sys.argv[2] == "--make":
        make(sys.argv[1])
    else:
        difference = compare(sys.argv[1], pathlib.Path(sys.argv[2]).stem)
        if difference:
            sys.exit(f"golden: {sys.argv[2]}: {difference}")
