#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Compares softcnc with LinuxCNC's rs274, program by program.

    compare.py --softcnc BINARY [--valid N] [--broken N] [--seed N] [--subject NAME] [--keep FOLDER] [PROGRAM...]

Without PROGRAM: those of this folder, and generated ones. Both must accept or both refuse; what both accept must
lead to the same moves: kind, end, centre, plane, turns, feed, dwell, and what is in force at each: tool, spindle,
coolant, whether overrides count. What differs must stand in docs/differences.md, and
what stands there must differ. Exit 1 otherwise.
"""
import argparse
import collections
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "tests/oracle"))

import curves  # noqa: E402
import differences  # noqa: E402
import generate  # noqa: E402
from blocks import Softcnc  # noqa: E402
from canon import Rs274  # noqa: E402
from differences import Finding  # noqa: E402

TOLERANCE = 1e-4  # mm, and mm/min
OUT_OF_ORDER = re.compile(r"^\s*o|M9[89]", re.IGNORECASE)
SAMPLES = 2000    # of a spline, from which the nearest point is searched
BRANCHES = 3      # of a spline, that come so near a point that the nearest point may lie on any


def off(a, b):
    return float(np.max(np.abs(np.asarray(a) - np.asarray(b))))


def distance(curve, points):
    """The largest distance of `points` from a NURBS as softcnc gives it, mm."""
    nurbs = curves.Nurbs(curve["degree"], curve["control"], curve["weights"], curve["knots"])
    sampled = np.linspace(nurbs.breaks[0], nurbs.breaks[-1], SAMPLES)
    at = nurbs.derivatives(sampled)[0]
    return max(nearest(nurbs, sampled, np.sum((at - point) ** 2, axis=1), point) for point in points)


def nearest(nurbs, sampled, squares, point):
    """The distance of `point`; `squares` are those of its distances from the curve at `sampled`."""
    padded = np.pad(squares, 1, constant_values=np.inf)
    lowest = np.flatnonzero((squares <= padded[:-2]) & (squares <= padded[2:]))
    starts = sampled[lowest[np.argsort(squares[lowest])[:BRANCHES]]]
    return min(descend(nurbs, u, point) for u in starts)


def descend(nurbs, u, point):
    """The distance of `point` from the curve near `u`, by Newton's steps towards it."""
    for _ in range(20):
        p, p1, p2 = (d[0] for d in nurbs.derivatives([u]))
        slope = p1 @ p1 + (p - point) @ p2
        if slope <= 0:
            break
        u = float(np.clip(u - (p - point) @ p1 / slope, nurbs.breaks[0], nurbs.breaks[-1]))
    return float(np.linalg.norm(nurbs.derivatives([u])[0][0] - point))


def unlike(ours, theirs):
    """In what a move differs; empty: in nothing."""
    if ours.kind != theirs.kind:
        return f"{ours.kind} instead of {theirs.kind}"
    if ours.kind == "dwell":
        same = abs(ours.duration - theirs.duration) < 1e-6
        return ours.unlike_state(theirs) if same else f"{ours.duration} s, not {theirs.duration}"
    if off(ours.end, theirs.end) > TOLERANCE:
        far = np.linalg.norm(ours.end - theirs.end)
        return f"{far:.4f} mm{', less than 0.2 mm,' if far < 0.2 else ''} off: to {ours.end}, not {theirs.end}"
    if ours.feed is not None and abs(ours.feed - theirs.feed) * 60 > TOLERANCE:
        return f"feed {ours.feed * 60:.6g}, not {theirs.feed * 60:.6g} mm/min"
    if ours.kind == "arc" and (what := unlike_arc(ours, theirs)):
        return what
    if ours.kind == "nurbs" and (far := distance(ours.curve, theirs.points)) > TOLERANCE:
        return f"points of rs274 lie {far:.6g} mm off the curve"
    return ours.unlike_state(theirs)


def unlike_arc(ours, theirs):
    if (ours.plane, ours.ccw, ours.turns) != (theirs.plane, theirs.ccw, theirs.turns):
        return (f"plane {ours.plane} ccw {ours.ccw} turns {ours.turns}, not "
                f"{theirs.plane} {theirs.ccw} {theirs.turns}")
    across = {"XY": 2, "ZX": 1, "YZ": 0}[ours.plane]
    centers = (np.delete(m.center, across) for m in (ours, theirs))
    if off(*centers) > TOLERANCE:
        return f"around {ours.center}, not {theirs.center}"
    return ""


def chord_in_radii(move):
    chord, radius = (np.linalg.norm(move.end - p) for p in (move.start, move.center))
    return chord / radius


def is_small_corner(move):
    """An arc of less than some 3 degrees."""
    return move.kind == "arc" and chord_in_radii(move) < 0.06


def near_small_corner(error, moves, lines):
    """Whether softcnc goes round a small corner on the refused line or one of the three before it, which rs274 looks at."""
    numbers = [i for i, line in enumerate(lines, 1) if line.strip() == error.line.strip()]
    near = any(n - 3 <= m.line <= n for n in numbers for m in moves if is_small_corner(m))
    return ", near a small corner" if near else ""


def compare_moves(name, ours, theirs, lines):
    """The first difference, in a list."""
    ours, theirs = ([m for m in moves if m.moves()] for moves in (ours, theirs))

    def finding(what, number):
        return [Finding("moves", name, "", what, lines[number - 1], "\n".join(lines[:number]))]

    for i, (a, b) in enumerate(zip(ours, theirs)):
        if what := unlike(a, b):
            if is_small_corner(a) and i + 1 < len(ours) and not unlike(ours[i + 1], b):
                what = "a small corner arc more: " + what
            return finding(f"{what} ({b.call})", a.line)
    if len(ours) > len(theirs):
        extra = ours[len(theirs)]
        return finding(f"one more: {extra.kind} to {extra.end}", extra.line)
    if len(theirs) > len(ours):
        return finding(f"missing behind this line: {theirs[len(ours)].call}", ours[-1].line if ours else 1)
    return []


def program_lines(program):
    return re.split(r"\r\n|\r|\n", program.read_bytes().decode("latin-1")) + [""]


def compare(program, softcnc, rs274):
    """What differs, and what both made of it."""
    ours, theirs = softcnc.run(program), rs274.run(program)
    name = program.name
    if ours.accepted and theirs.accepted:
        return compare_moves(name, ours.moves, theirs.moves, program_lines(program)), "accepted by both"
    if theirs.accepted:
        return [Finding("refused", name, e.code, e.text, e.line) for e in ours.errors], "refused by softcnc alone"
    if ours.accepted:
        lines = program_lines(program)
        return [Finding("accepted", name, "", e.text + near_small_corner(e, ours.moves, lines), e.line)
                for e in theirs.errors], "refused by rs274 alone"
    return compare_refusals(name, ours, theirs, program_lines(program)), "refused by both"


def compare_refusals(name, ours, theirs, lines):
    """Both refuse a program: for its same line? Up to there they must move alike. rs274 tells the text of a line, not its
    number; where lines are not done in their order, the first one is not to be told."""
    if any(OUT_OF_ORDER.search(line) for line in lines):
        return []
    ours_error, theirs_error = ours.errors[0], theirs.errors[0]
    there = [i for i, line in enumerate(lines, 1) if line.strip() == theirs_error.line.strip()]
    if not there:
        return []
    if ours_error.number < min(there):
        return [Finding("refused", name, ours_error.code, ours_error.text, ours_error.line)]
    if ours_error.number > max(there):
        return [Finding("accepted", name, "", theirs_error.text, theirs_error.line)]
    before = [m for m in ours.moves if m.moves() and m.line < ours_error.number]
    moved = [m for m in theirs.moves if m.moves()]
    both = min(len(before), len(moved))
    return compare_moves(name, before[:both], moved[:both], lines)


def compile_preload(folder):
    library = folder / "exact_printf.so"
    subprocess.run(["cc", "-O1", "-shared", "-fPIC", "-o", library, HERE / "exact_printf.c"], check=True)
    return library


def short_programs(folder):
    """Those of short_programs.txt, a file each."""
    programs = []
    for line in (HERE / "short_programs.txt").read_text(encoding="utf-8").splitlines()[1:]:
        name, text = line.split(": ", 1)
        programs.append(folder / f"{name}.nc")
        programs[-1].write_text(text.encode().decode("unicode_escape") + "\nM2\n")
    return programs


def programs_for(arguments, folder):
    if arguments.program:
        return arguments.program
    programs = sorted(HERE.glob("*.nc")) + short_programs(folder)
    for kind, count in (("valid", arguments.valid), ("broken", arguments.broken)):
        for number in range(count):
            path = folder / f"{kind}_{number:04}.nc"
            path.write_bytes(getattr(generate, kind)(arguments.seed * 100000 + number, arguments.subject))
            programs.append(path)
    return programs


def report(findings, rows, verdicts, complete):
    unlisted = 0
    for finding in findings:
        row = differences.explanation(finding, rows)
        if row:
            row.seen += 1
            continue
        unlisted += 1
        print(f"UNLISTED {finding}")
    stale = [row for row in rows if complete and not row.seen]
    for row in stale:
        print(f"NO LONGER SEEN {row.what}: {row.kind} {row.code} {row.text} {row.pattern}")
    told = ", ".join(f"{count} {verdict}" for verdict, count in sorted(verdicts.items()))
    print(f"{sum(verdicts.values())} programs: {told}; {unlisted} differences not listed, "
          f"{sum(1 for row in rows if row.seen)} of {len(rows)} listed ones seen")
    return 1 if unlisted or stale else 0


def main(words):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--softcnc", required=True)
    parser.add_argument("--valid", type=int, default=400)
    parser.add_argument("--broken", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--subject", choices=generate.SUBJECTS, help="what the generated programs are about")
    parser.add_argument("--keep", type=pathlib.Path, help="keep the generated programs here")
    parser.add_argument("program", nargs="*", type=pathlib.Path)
    arguments = parser.parse_args(words)
    rows = differences.read(ROOT / "docs/differences.md")
    verdicts, findings = collections.Counter(), []
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        softcnc, rs274 = Softcnc(pathlib.Path(arguments.softcnc).resolve()), Rs274(compile_preload(folder), folder)
        for program in map(pathlib.Path.resolve, programs_for(arguments, folder)):
            found, verdict = compare(program, softcnc, rs274)
            findings += found
            verdicts[verdict] += 1
        if arguments.keep:
            shutil.copytree(folder, arguments.keep, dirs_exist_ok=True)
    return report(findings, rows, verdicts, complete=not (arguments.program or arguments.subject))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
