#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs the programs of this folder and compares their paths with those expected.

    posts_test.py SOFTCNC [--altered] [FOLDER|PROGRAM...]

Each program has an expectation beside it, a Python file of the same name (README.md). `softcnc blocks` must give its path,
and `softcnc check` accept the program with no other warnings than those that the expectation names. With --altered: each
move that a program gives is altered, in each of its values, and the comparison must notice; so must it notice a move
left out or done twice, and each coordinate of the program made 0.01 larger. Exit 1 where anything is wrong.
"""
import argparse
import copy
import pathlib
import re
import runpy
import shutil
import subprocess
import sys
import tempfile

import blocks
from path import Path

HERE = pathlib.Path(__file__).resolve().parent
SUFFIXES = (".nc", ".ngc", ".tap", ".gc")
WARNING = re.compile(r"^[^\n]*?:\d+:(?:\d+:)? warning: [^\n]* \[(SC\d+)\]$", re.MULTILINE)
ALTERATION = 1e-5  # of a value, in its unit
TIMEOUT = 60       # s
LEAST = 60         # programs
COORDINATE = re.compile(r"([XYZ])(-?\d*\.?\d+|-?\d+\.)(?![\d.\[#])")
COMMENT = re.compile(r"\([^)]*\)|;.*")


class Expectation:
    """A program with the options it is run with, the warnings it may get, and its path."""

    def __init__(self, program):
        self.program, self.name = program, str(program.relative_to(HERE))
        stated = runpy.run_path(str(program.with_suffix(".py")))
        self.options, self.warnings = stated.get("OPTIONS", []), set(stated.get("WARNINGS", []))
        self.no_effect = stated.get("NO_EFFECT", [])  # "line 15: X0": a coordinate that leads nowhere
        path = Path()
        stated["path"](path)
        self.steps = path.steps


def programs(chosen):
    """The programs of the files and folders chosen, or all; each has its expectation, and each expectation a program."""
    places = [pathlib.Path(name) if pathlib.Path(name).exists() else HERE / name for name in chosen] or [HERE]
    found = []
    for place in places:
        files = [place] if place.is_file() else sorted(place.rglob("*"))
        found += [f for f in files if f.suffix in SUFFIXES and not f.parent.name.startswith("subprograms")]
    return found


def unpaired_or_few(chosen):
    """Files of these folders that lack their other half; too few programs, if none were chosen."""
    stems = {program.with_suffix("") for program in programs([])}
    expected = {file.with_suffix("") for file in HERE.glob("*/*.py")}
    wrong = [f"{lonely.relative_to(HERE)}: a program without an expectation, or the other way round"
             for lonely in sorted(stems ^ expected)]
    if not chosen and len(stems) < LEAST:
        wrong.append(f"{len(stems)} programs, fewer than {LEAST}")
    return wrong


def softcnc(binary, command, expectation, folder=None):
    """Runs a program, or that of the same name in another folder."""
    return subprocess.run([binary, command, *expectation.options, expectation.program.name],
                          capture_output=True, text=True, timeout=TIMEOUT, cwd=folder or expectation.program.parent)


def run(binary, expectation):
    """What is wrong with a program, a text; empty: nothing."""
    done = softcnc(binary, "blocks", expectation)
    if done.returncode != 0:
        return f"blocks: exit status {done.returncode}\n{done.stderr}"
    if what := blocks.difference(expectation.steps, blocks.steps(done.stdout)):
        return what
    done = softcnc(binary, "check", expectation)
    said = done.stdout + done.stderr
    if done.returncode != 0:
        return f"check: exit status {done.returncode}\n{said}"
    if more := set(WARNING.findall(said)) - expectation.warnings:
        return f"warnings that are not expected: {sorted(more)}\n{said}"
    return ""


def alterations(step):
    """(name, altered step): one for each value of a step."""
    for name in ("end", "center", "feed", "seconds"):
        value = getattr(step, name)
        if value is None:
            continue
        if isinstance(value, (int, float)):
            yield name, altered(step, **{name: value + ALTERATION})
            continue
        for axis in range(len(value)):
            yield f"{name} {axis}", altered(step, **{
                name: [v + ALTERATION if i == axis else v for i, v in enumerate(value)]})
    if step.kind == "arc":
        yield "direction", altered(step, ccw=not step.ccw)
        yield "turns", altered(step, turns=step.turns + 1)
    if step.kind == "nurbs":
        for name in ("control", "weights"):
            moved = copy.deepcopy(step.curve)
            middle = len(moved[name]) // 2
            if name == "weights":
                moved[name][middle] += 100 * ALTERATION
            else:
                moved[name][middle][0] += 100 * ALTERATION
            yield name, altered(step, curve=moved)
    yield "kind", altered(step, kind="feed" if step.kind == "rapid" else "rapid")
    yield "tool", altered(step, state={**step.state, "tool": step.state["tool"] + 1})
    yield "spindle", altered(step, state={**step.state, "rpm": step.state["rpm"] + 1})
    for coolant in ("mist", "flood"):
        yield coolant, altered(step, state={**step.state, coolant: not step.state[coolant]})


def altered(step, **values):
    made = copy.copy(step)
    for name, value in values.items():
        setattr(made, name, value)
    return made


def unnoticed(binary, expectation):
    """Alterations of what a program gives that the comparison does not notice, and how many were tried."""
    found = blocks.steps(softcnc(binary, "blocks", expectation).stdout)
    missed, tried = [], 0
    for number, step in enumerate(found):
        variants = [(name, [other]) for name, other in alterations(step)]
        variants += [("left out", []), ("done twice", [step, step])]
        for name, others in variants:
            tried += 1
            if not blocks.difference(expectation.steps, found[:number] + others + found[number + 1:]):
                missed.append(f"step {number + 1}, {step.kind}: {name}")
    return missed, tried


def changed_programs(text):
    """(name, text): the program with one of its coordinates 0.01 larger, for each of them outside of comments."""
    hidden = COMMENT.sub(lambda found: " " * len(found[0]), text)
    for found in COORDINATE.finditer(hidden):
        number = f"{float(found[2]) + 0.01:.6f}"
        line = text.count("\n", 0, found.start()) + 1
        yield f"line {line}: {found[0]}", text[:found.start(2)] + number + text[found.end(2):]


def unnoticed_changes(binary, expectation):
    """Coordinates of the text whose change leads to no other path and no error, and how many were tried. Those that the
    expectation names as NO_EFFECT must be among them."""
    missed, tried = [], 0
    text = expectation.program.read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary) / "programs"
        shutil.copytree(expectation.program.parent, folder)
        for name, changed in changed_programs(text):
            tried += 1
            (folder / expectation.program.name).write_text(changed, encoding="utf-8")
            done = softcnc(binary, "blocks", expectation, folder)
            if done.returncode == 0 and not blocks.difference(expectation.steps, blocks.steps(done.stdout)):
                missed.append(name)
    idle = list(expectation.no_effect)
    return [name for name in missed if name not in idle] + [f"{name}, which has an effect" for name in idle
                                                            if name not in missed], tried


def main(words):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("softcnc")
    parser.add_argument("--altered", action="store_true", help="alter what is compared, and ask for a difference")
    parser.add_argument("programs", nargs="*", metavar="FOLDER|PROGRAM")
    arguments = parser.parse_intermixed_args(words)
    binary = str(pathlib.Path(arguments.softcnc).resolve())
    wrong, tried, chosen = unpaired_or_few(arguments.programs), 0, programs(arguments.programs)
    for program in chosen:
        expectation = Expectation(program.resolve())
        if what := run(binary, expectation):
            wrong.append(f"{expectation.name}: {what}")
        elif arguments.altered:
            for alter in (unnoticed, unnoticed_changes):
                missed, count = alter(binary, expectation)
                tried += count
                wrong += [f"{expectation.name}: not noticed: {what}" for what in missed]
    for what in wrong:
        print(f"WRONG {what}")
    tail = f", {tried} alterations" if arguments.altered else ""
    print(f"{len(chosen)} programs{tail}, {len(wrong)} wrong")
    return 1 if wrong or not chosen else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
