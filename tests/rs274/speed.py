#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""How fast softcnc interprets, beside LinuxCNC's rs274.

    speed.py --softcnc BINARY [--lines N] [--runs N] [--core N] [--ratio R] [--memory MB]

N lines `G1 X Y Z F`, no two numbers of a column alike but by chance, go through `rs274 -g PROGRAM OUTPUT` and through
`softcnc blocks PROGRAM`: both read and interpret the program and print what it does, a line of text a move: rs274 two
calls of its canon, with the coordinates to four decimals; softcnc a block in JSON, with where it begins and ends in the
shortest form that reads back exactly. Both outputs are /dev/null. One after the other on one core, by turns; what counts is
the CPU time of the process from its start to its end, user and system, the least of the runs. Exit 1 if softcnc is not R
times as fast, or takes more memory.

Where rs274 is given no OUTPUT it writes every line to standard output by itself. That is slower; it is measured too, and
shown, but does not count.
"""
import argparse
import os
import pathlib
import random
import sys
import tempfile
from dataclasses import dataclass


@dataclass(frozen=True)
class Cost:
    cpu: float     # s
    memory: float  # MB, the most that was resident


def write_program(path, lines):
    value = random.Random(274).uniform
    with open(path, "w", encoding="ascii") as file:
        file.write("G21 G90\n")
        for _ in range(lines):
            file.write(f"G1 X{value(-500, 500):.4f} Y{value(-500, 500):.4f} Z{value(-100, 100):.4f} "
                       f"F{value(100, 3000):.1f}\n")
        file.write("M2\n")


def run(command, core):
    child = os.fork()
    if child == 0:
        os.sched_setaffinity(0, {core})
        nothing = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nothing, 1)
        os.dup2(nothing, 2)
        os.execvp(command[0], command)
    _, status, used = os.wait4(child, 0)
    if os.waitstatus_to_exitcode(status) != 0:
        sys.exit(f"{' '.join(command)} failed")
    return Cost(used.ru_utime + used.ru_stime, used.ru_maxrss / 1024)


def main(words):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--softcnc", required=True)
    parser.add_argument("--lines", type=int, default=1000000)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--core", type=int, default=max(os.sched_getaffinity(0)))
    parser.add_argument("--ratio", type=float, default=10)
    parser.add_argument("--memory", type=float, default=50, help="MB")
    options = parser.parse_args(words)
    with tempfile.TemporaryDirectory() as folder:
        program = str(pathlib.Path(folder) / "lines.nc")
        write_program(program, options.lines)
        commands = {"rs274": ["rs274", "-g", program, os.devnull], "rs274, lines": ["rs274", "-g", program],
                    "softcnc": [options.softcnc, "blocks", program]}
        costs = {name: [] for name in commands}
        for _ in range(options.runs):
            for name, command in commands.items():
                costs[name].append(run(command, options.core))
    best = {name: min(cost.cpu for cost in some) for name, some in costs.items()}
    memory = max(cost.memory for cost in costs["softcnc"])
    for name, cpu in best.items():
        print(f"{name:12} {cpu:6.2f} s CPU, {options.lines / cpu:10.0f} blocks/s, "
              f"{max(cost.memory for cost in costs[name]):5.1f} MB")
    ratio = best["rs274"] / best["softcnc"]
    print(f"softcnc is {ratio:.1f} times as fast, {best['rs274, lines'] / best['softcnc']:.1f} times where rs274 writes line "
          f"by line; {options.ratio:g} times and at most {options.memory:g} MB are wanted")
    return 0 if ratio >= options.ratio and memory <= options.memory else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
