#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the table of codes in docs/gcode.md from libs/ipr/handlers/gcode_table.cpp.

    scripts/generate code_table            writes the table, with a place to link to for every code
    scripts/generate code_table --check    changes nothing; exit 1 if the table is not up to date
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
TABLE = ROOT / "libs/ipr/handlers/gcode_table.cpp"
PAGE = ROOT / "docs/gcode.md"
LITERAL = r'"(?:[^"\\]|\\.)*"'
TEXT = rf"((?:{LITERAL}\s*)+)"  # as in C++, literals that follow one another are one text
ROW = re.compile(rf"{{'(\w)', (\w+), Group::\w+, order::\w+, ({LITERAL}), \w+,\s*{TEXT}")
HEAD = "| code | words | what it does |\n|---|---|---|\n"


def text_of(literals):
    return "".join(literal[1:-1].replace('\\"', '"') for literal in re.findall(LITERAL, literals))


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
    page = PAGE.read_text(encoding="utf-8")
    begin = page.index(HEAD)
    made = page[:begin] + table() + page[page.index("\n\n", begin) + 1:]
    if arguments:
        if made != page:
            sys.exit(f"{PAGE} is not up to date; run scripts/generate code_table")
        return
    PAGE.write_text(made, encoding="utf-8")
    print(f"wrote {PAGE.relative_to(ROOT)}")


if __name__ == "__main__":
    main(sys.argv[1:])
