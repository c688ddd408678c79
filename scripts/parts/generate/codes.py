#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes docs/codes.md from the table of diagnostics, libs/motion/core/diagnostic_table.inc.

    scripts/generate codes            writes the page
    scripts/generate codes --check    changes nothing; exit 1 if the page is not up to date
"""
import pathlib
import re
import sys

from pages import TEXT, text_of, write_or_check

ROOT = pathlib.Path(__file__).resolve().parents[3]
TABLE = ROOT / "libs/motion/core/diagnostic_table.inc"
PAGE = ROOT / "docs/codes.md"
ROW = re.compile(rf"^SOFTCNC_DIAGNOSTIC\((\d+),\s*(\w+),\s*{TEXT},\s*{TEXT}\)", re.M)

HEAD = """# What the codes mean

<!-- made by scripts/generate codes from libs/motion/core/diagnostic_table.inc; a test compares it -->

A diagnostic names its place, what is wrong, and its code. Below it is the line with the place
marked:

```
part.nc:12:9: error: G02 ends 0.35 mm off its circle (radius 10 mm at the start, 10.35 mm at the end) [SC2103]
   12 | N40 G02 X10 Y0 I0 J-10
      |         ^~~~~~~~~~~~~~
```

An error keeps a program from running. A warning says what softcnc does instead of what was asked
for. A note is worth knowing. A code never changes its meaning.
"""

SECTIONS = {
    1: "Characters and words",
    2: "Modes and motion",
    3: "NURBS",
    4: "Limits and planning",
    5: "At run time",
    6: "Files",
    7: "Machine and state file",
    9: "Defects in softcnc",
}


def joined(literals):
    """The text of C++ string literals, for a cell of a table."""
    return text_of(literals).replace("|", "\\|")


def page(table):
    rows = ROW.findall(table)
    assert len(rows) == table.count("\nSOFTCNC_DIAGNOSTIC("), "a row of the table was not understood"
    text, section = HEAD, None
    for number, severity, title, advice in rows:
        if section != int(number) // 1000:
            section = int(number) // 1000
            text += f"\n## {SECTIONS[section]}\n\n| code | | what is wrong | what to do |\n|---|---|---|---|\n"
        text += f"| SC{number} | {severity} | {joined(title)} | {joined(advice)} |\n"
    return text


def main(arguments):
    if arguments not in ([], ["--check"]):
        sys.exit(__doc__)
    write_or_check(PAGE, page(TABLE.read_text(encoding="utf-8")), bool(arguments), "codes")


if __name__ == "__main__":
    main(sys.argv[1:])
