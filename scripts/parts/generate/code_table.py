#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the table of codes in docs/gcode.md from libs/ipr/handlers/gcode_table.cpp.

    scripts/generate code_table            writes the table, with a place to link to for every code
    scripts/generate code_table --check    changes nothing; exit 1 if the table is not up to date
"""
import pathlib
import re
import sys

from pages import LITERAL, TEXT, text_of, with_table, write_or_check

ROOT = pathlib.Path(__file__).resolve().parents[3]
TABLE = ROOT / "libs/ipr/handlers/gcode_table.cpp"
PAGE = ROOT / "docs/gcode.md"
ROW = re.compile(rf"{{'(\w)', (\w+), Group::\w+, order::\w+, ({LITERAL}), \w+,\s*{TEXT}")
HEAD = "| code | words | what it does |\n|---|---|---|\n"


def name_of(letter, number):
    if number == "kAnyNumber":
        return letter
    whole, tenth = divmod(int(number), 10)
    return f"{letter}{whole:02}" + (f".{tenth}" if tenth else "")


def anchor_of(name):
    return name.lower().replace(".", "-")


def table():
    rows = []
    for letter, number, words, says in ROW.findall(TABLE.read_text(encoding="utf-8")):
        name = name_of(letter, number)
        rows.append(f'| <a id="{anchor_of(name)}"></a>{name} | {" ".join(text_of(words))} | '
                    f"{text_of(says)} |\n")
    return HEAD + "".join(rows)


def main(arguments):
    if arguments not in ([], ["--check"]):
        sys.exit(__doc__)
    write_or_check(PAGE, with_table(PAGE, HEAD, table()), bool(arguments), "code_table")


if __name__ == "__main__":
    main(sys.argv[1:])
