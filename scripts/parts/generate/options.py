#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the table of options in docs/cli.md from what the commands print with --help.

    scripts/generate options [SOFTCNC]            writes the table
    scripts/generate options --check [SOFTCNC]    changes nothing; exit 1 if it is not up to date

SOFTCNC is the program that is asked, by default that of build/release.
"""
import pathlib
import re
import subprocess
import sys

from pages import with_table, write_or_check

ROOT = pathlib.Path(__file__).resolve().parents[3]
PAGE = ROOT / "docs/cli.md"
HEAD = "| option | of | meaning |\n|---|---|---|\n"


def help_of(softcnc, *command):
    return subprocess.run([softcnc, *command, "--help"], check=True, capture_output=True, text=True).stdout


def commands_of(softcnc):
    text = help_of(softcnc).split("\nCommands:\n")[1]
    return re.findall(r"^  ([a-z]+)\s", text.split("\n\n")[0], re.MULTILINE)


def options_of(softcnc, command):
    """(names with value, meaning) of each option of a command, in its order."""
    found = []
    for line in help_of(softcnc, command).split("\nExamples:\n")[0].splitlines():
        match = re.match(r"  (-\S+(?: \S+)*?)(?: \.\.\.)?(?:\s{2,}(.*))?$", line)
        if match:
            found.append([match[1], (match[2] or "").strip()])
        elif found and line.startswith("   "):
            found[-1][1] = (found[-1][1] + " " + line.strip()).strip()
    return [(name, meaning) for name, meaning in found if not name.startswith("-h,")]


def shown(name):
    """`-q`, `--quiet` of "-q,--quiet"."""
    names, _, value = name.partition(" ")
    return ", ".join(f"`{(one + ' ' + value).strip()}`" for one in names.split(",")).replace("|", r"\|")


def of(commands, every):
    missing = [command for command in every if command not in commands]
    if not missing:
        return "all"
    return "all except " + " and ".join(missing) if len(missing) <= 2 else ", ".join(commands)


def rows_of(softcnc):
    """(name with value, meaning) of each option in the order of the names, and the commands that take it."""
    rows = {}
    for command in commands_of(softcnc):
        for option in options_of(softcnc, command):
            rows.setdefault(option, []).append(command)
    return {row: rows[row] for row in sorted(rows, key=lambda row: re.sub(r"^-\w,", "", row[0]))}


def table(softcnc):
    every, rows = commands_of(softcnc), rows_of(softcnc)
    meaning = {row: row[1].replace("|", r"\|").replace("<", r"\<") for row in rows}
    return HEAD + "".join(f"| {shown(row[0])} | {of(rows[row], every)} | {meaning[row]} |\n" for row in rows)


def main(arguments):
    check = arguments[:1] == ["--check"]
    rest = arguments[check:]
    if len(rest) > 1 or any(word.startswith("-") for word in rest):
        sys.exit(__doc__)
    softcnc = rest[0] if rest else ROOT / "build/release/apps/softcnc/softcnc"
    write_or_check(PAGE, with_table(PAGE, HEAD, table(softcnc)), check, "options")


if __name__ == "__main__":
    main(sys.argv[1:])
