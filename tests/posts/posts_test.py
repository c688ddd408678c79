#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs the programs of this folder and compares their paths with those expected.

    posts_test.py SOFTCNC [--altered] [FOLDER|PROGRAM...]

Each program has an expectation beside it, a Python file of the same name (README.md). `softcnc blocks` must give its path,
and `softcnc check` accept the program with no other warnings than those that the expectation names. With --altered: each
move that a program gives is altered, in each of its values, and the comparison must notice; so must it notice a move
left out or done twice, and one digit changed in the program. Exit 1 where anything is wrong.
"""
import argparse
import copy
import pathlib
import re
import runpy
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
        self.program = program
        stated = runpy.run_path(str(program.with_suffix(".py")))
        self.options, self.warnings = stated.get("OPTIONS", []), set(stated.get("WARNINGS", []))
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


def unpaired():
    """Files of these folders that lack their other half."""
    stems = {program.with_suffix("") for program in programs([])}
    expected = {file.with_suffix("") for file in HERE.glob("*/*.py")}
    return sorted(stems ^ expected)


def softcnc(binary, command, expectation, program=None):
    return subprocess.run([binary, command, *expectation.options, (program or expectation.program).name],
                          capture_output=True, text=True, timeout=TIMEOUT, cwd=expectation.program.parent)


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
        if isinstance(value, float) or isinstance(value, int):
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
            place = moved[name] if name == "weights" else moved[name][len(moved[name]) // 2]
            place[0] += 100 * ALTERATION
            yield name, altered(step, curve=moved)
    yield "kind", altered(step, kind="feed" if step.kind == "rapid" else "rapid")
    yield "spindle", altered(step, state={**step.state, "rpm": step.state["rpm"] + 1})


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
    """The program with one of its coordinates 0.01 larger, for each of them outside of comments."""
    hidden = COMMENT.sub(lambda found: " " * len(found[0]), text)
    for found in COORDINATE.finditer(hidden):
        number = f"{float(found[2]) + 0.01:.6f}"
        line = text.count("\n", 0, found.start()) + 1
        yield f"line {line}: {found[0]}", text[:found.start(2)] + number + text[found.end(2):]


def notices_a_changed_program(binary, expectation):
    """Whether one coordinate that is changed in the text is noticed: by another path or by an error."""
    text = expectation.program.read_text(encoding="utf-8")
    for _, changed in changed_programs(text):
        with tempfile.NamedTemporaryFile("w", dir=expectation.program.parent, prefix=".changed_",
                                         suffix=expectation.program.suffix) as file:
            file.write(changed)
            file.flush()
            done = softcnc(binary, "blocks", expectation, pathlib.Path(file.name))
        if done.returncode != 0 or blocks.difference(expectation.steps, blocks.steps(done.stdout)):
            return True
    return False


def main(words):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("softcnc")
    parser.add_argument("--altered", action="store_true", help="alter what is compared, and ask for a difference")
    parser.add_argument("programs", nargs="*", metavar="FOLDER|PROGRAM")
    arguments = parser.parse_intermixed_args(words)
    binary = str(pathlib.Path(arguments.softcnc).resolve())
    wrong, alterations_tried, chosen = 0, 0, programs(arguments.programs)
    for lonely in unpaired():
        wrong += 1
        print(f"WRONG {lonely.relative_to(HERE)}: a program without an expectation, or the other way round")
    if not arguments.programs and len(chosen) < LEAST:
        wrong += 1
        print(f"WRONG {len(chosen)} programs, fewer than {LEAST}")
    for program in chosen:
        expectation = Expectation(program.resolve())
        if what := run(binary, expectation):
            wrong += 1
            print(f"WRONG {program.resolve().relative_to(HERE)}: {what}")
        elif arguments.altered:
            missed, tried = unnoticed(binary, expectation)
            alterations_tried += tried
            wrong += len(missed)
            for what in missed:
                print(f"NOT NOTICED {program.resolve().relative_to(HERE)}: {what}")
    tail = f", {alterations_tried} alterations tried" if arguments.altered else ""
    print(f"{len(chosen)} programs{tail}, {wrong} wrong")
    return 1 if wrong or not chosen else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
