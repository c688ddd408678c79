# SPDX-License-Identifier: MIT
"""softcnc: runs a program and turns what `softcnc blocks` says into moves."""
import dataclasses
import json
import pathlib
import re
import subprocess

import numpy as np

from moves import Error, Move, Outcome, State

HERE = pathlib.Path(__file__).resolve().parent
DIAGNOSTIC = re.compile(r"^(?:.*?):(\d+):(?:\d+:)? (error|warning|note): (.*) \[(SC\d+)\]$")
TIMEOUT = 20  # s


COOLANT = {7: {"mist": True}, 8: {"flood": True}, 9: {"mist": False, "flood": False}}


def state_after(state, block):
    """What is in force after a block: tool, spindle, coolant."""
    if block["kind"] == "tool":
        return dataclasses.replace(state, tool=block["tool"])
    if block["kind"] == "spindle":
        return dataclasses.replace(state, spindle=block["rpm"])
    if block["kind"] == "coolant":
        return dataclasses.replace(state, **COOLANT[block["code"]])
    return state


def moves_of(blocks):
    """The moves and dwells among them, each with what is in force."""
    moves, state = [], State()
    for block in blocks:
        state = state_after(state, block)
        if made := move(block, state):
            moves.append(made)
    return moves


def move(block, state):
    """None for blocks that neither move nor wait."""
    kind = block["kind"]
    if kind == "dwell":
        return Move(kind, duration=block["duration_s"], line=block["line"], state=state)
    if "to" not in block:
        return None
    state = dataclasses.replace(state, feed_override=block.get("feed_override", True),
                                speed_override=block.get("speed_override", True))
    made = Move(kind, np.array(block["from"], float), np.array(block["to"], float), block.get("feed_mm_s"),
                line=block["line"], state=state)
    if kind == "arc":
        made.plane, made.center = block["plane"], np.array(block["center"], float)
        made.ccw, made.turns = block["ccw"], int(block["turns"])
    if kind == "nurbs":
        made.curve = {name: block[name] for name in ("degree", "control", "weights", "knots")}
    return made


class Softcnc:
    def __init__(self, binary):
        self.command = [str(binary), "blocks", "--dialect", "linuxcnc"]

    def run(self, program):
        """On the machine of the file beside `program`, if there is one."""
        beside = pathlib.Path(program).with_suffix(".toml")
        machine = beside if beside.exists() else HERE / "machine.toml"
        try:
            done = subprocess.run([*self.command, "--machine", str(machine), str(program)], capture_output=True,
                                  timeout=TIMEOUT, cwd=pathlib.Path(program).resolve().parent)
        except subprocess.TimeoutExpired:
            return Outcome(False, [], [Error("timeout", "endless", "")])
        lines = re.split(r"\r\n|\r|\n", pathlib.Path(program).read_bytes().decode("latin-1"))
        errors = []
        for text in done.stderr.decode("latin-1").splitlines():
            found = DIAGNOSTIC.match(text)
            if found and found[2] == "error":
                number = int(found[1])
                errors.append(Error(found[4], found[3], lines[number - 1] if 0 < number <= len(lines) else "",
                                    number))
        if done.returncode not in (0, 1) or (done.returncode == 1) != bool(errors):
            errors.append(Error("status", f"exit status {done.returncode}", ""))
        moves = moves_of(self.altered([json.loads(line) for line in done.stdout.splitlines()]))
        return Outcome(not errors, moves, errors)

    def altered(self, blocks):
        """What self_test.py overrides to give other blocks than softcnc does."""
        return blocks
