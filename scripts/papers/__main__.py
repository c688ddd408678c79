# SPDX-License-Identifier: MIT
"""Makes the figures and tables of the papers that a simulation can make; see scripts/figures."""
import argparse
import pathlib
import sys
import tempfile

import numpy

import paper_000
import paper_003
import paper_004
from runs import ROOT, Tools, read

PAPERS = {"000": paper_000, "003": paper_003, "004": paper_004}
OUT = ROOT / "docs/figures"
DATA = OUT / "data"
PAGE = ROOT / "docs/papers.md"
# Of the largest value of a column: traces may have the chord error of a few points of each chord.
SAME = 0.03


def table(rows):
    """Markdown."""
    lines = ["| figure | what | the paper | here |", "|---|---|---|---|"]
    return "\n".join(lines + [f"| {' | '.join(cells)} |" for cells in rows]) + "\n"


def page_with(page, name, text):
    begin, end = f"<!-- begin table {name} -->\n", "<!-- end table -->"
    before, rest = page.split(begin)
    return before + begin + text + rest[rest.index(end):]


def page_of(page):
    for name, paper in PAPERS.items():
        page = page_with(page, name, table(paper.compare(DATA)))
    return page


def differences(kept, made):
    """What differs between two files of numbers, as texts."""
    old, new = read(kept), read(made)
    if list(old) != list(new):
        yield "its columns"
        return
    for name in old:
        if len(old[name]) != len(new[name]):
            yield f"{name} has {len(new[name])} rows, not {len(old[name])}"
        elif isinstance(old[name], list):
            if old[name] != new[name]:
                yield name
        elif not numpy.allclose(old[name], new[name], rtol=0, atol=SAME * numpy.nanmax(abs(old[name])), equal_nan=True):
            yield name


def check(tools, papers):
    """Measures again, and compares with what is kept; the number of differences."""
    count = 0
    with tempfile.TemporaryDirectory() as folder:
        for paper in papers.values():
            paper.measure(tools, pathlib.Path(folder))
        for made in sorted(pathlib.Path(folder).iterdir()):
            for difference in differences(DATA / made.name, made):
                print(f"docs/figures/data/{made.name} is not what is measured: {difference}", file=sys.stderr)
                count += 1
    return count


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__)
    action = parser.add_mutually_exclusive_group()
    action.add_argument("--check", action="store_true", help="measures, and compares with the files of numbers")
    action.add_argument("--draw", action="store_true", help="draws from the files of numbers, and fills docs/papers.md")
    action.add_argument("--page", action="store_true", help="compares docs/papers.md with the files of numbers")
    parser.add_argument("--softcnc", help="the program")
    parser.add_argument("--bench", help="the folder of roughness_map and pulse_table")
    parser.add_argument("papers", nargs="*", metavar="PAPER", help="000, 003, 004; all of them without")
    options = parser.parse_args(arguments)
    if unknown := set(options.papers) - set(PAPERS):
        parser.error(f"no paper {', '.join(sorted(unknown))}")
    papers = {name: PAPERS[name] for name in options.papers or PAPERS}
    if options.page:
        return int(page_of(PAGE.read_text()) != PAGE.read_text() and
                   bool(print("docs/papers.md differs: scripts/figures --draw", file=sys.stderr) or True))
    tools = Tools(options.softcnc, options.bench) if not options.draw else None
    if options.check:
        return int(check(tools, papers) > 0)
    DATA.mkdir(parents=True, exist_ok=True)
    for name, paper in papers.items():
        if tools:
            print(f"paper {name}: measuring", file=sys.stderr)
            paper.measure(tools, DATA)
        paper.draw(DATA, OUT)
    PAGE.write_text(page_of(PAGE.read_text()))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
