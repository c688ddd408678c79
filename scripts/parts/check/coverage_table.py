#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Lines and branches that tests have reached, file by file.

    scripts/parts/check/coverage_table.py BUILD FOLDER [--missing]

BUILD was made with SOFTCNC_COVERAGE, and its tests have run; FOLDER holds the sources. With --missing
each line that was not reached, or a branch of it, is shown after the table. Exit 1 below 95 % of the
lines or 85 % of the branches.

A line counts once however many instances of a template it has, and is reached if one is. A branch is an
edge out of a condition, as gcov counts them without optimisation: `a && b` has four. Edges that only an
exception takes do not count: softcnc throws none.
"""
import collections
import json
import pathlib
import subprocess
import sys

LINES, BRANCHES = 95.0, 85.0


def reports(build):
    """What gcov reports for every object that has run."""
    for data in sorted(pathlib.Path(build).rglob("*.gcda")):
        said = subprocess.run(["gcov", "--json-format", "--stdout", "--branch-probabilities", data.name],
                              cwd=data.parent, capture_output=True, check=True).stdout
        for text in said.splitlines():
            yield json.loads(text)


def collect(build, folder):
    """{file: {line: (count, [counts of its branches])}}; instances are added up."""
    folder = pathlib.Path(folder).resolve()
    files = collections.defaultdict(dict)
    for report in reports(build):
        for file in report["files"]:
            path = pathlib.Path(report["current_working_directory"], file["file"]).resolve()
            if folder not in path.parents:
                continue
            functions = collections.defaultdict(dict)
            for line in file["lines"]:
                branches = [b["count"] for b in line["branches"] if not b["throw"]]
                count, known = functions[line.get("function_name")].get(line["line_number"], (0, []))
                functions[line.get("function_name")][line["line_number"]] = (
                    count + line["count"], known + branches)
            merge(files[path.name], functions)
    return files


def merge(lines, functions):
    for function in functions.values():
        for number, (count, branches) in function.items():
            old, known = lines.get(number, (0, []))
            if len(known) == len(branches):
                known = [a + b for a, b in zip(known, branches)]
            else:
                known = max(known, branches, key=len)
            lines[number] = (old + count, known)


def share(part, whole):
    return 100.0 * part / whole if whole else 100.0


def figures(lines):
    reached = sum(count > 0 for count, _ in lines.values())
    edges = [edge for _, branches in lines.values() for edge in branches]
    return reached, len(lines), sum(edge > 0 for edge in edges), len(edges)


def row(name, f):
    return f"{name:28} {f[0]:6}/{f[1]:<6} {share(f[0], f[1]):6.1f} % {f[2]:6}/{f[3]:<6} {share(f[2], f[3]):6.1f} %"


def show_missing(folder, files):
    for name in sorted(files):
        text = pathlib.Path(folder, name).read_text(encoding="utf-8").splitlines()
        for number, (count, branches) in sorted(files[name].items()):
            if count == 0:
                print(f"{name}:{number}: not reached: {text[number - 1].strip()}")
            elif 0 in branches:
                print(f"{name}:{number}: {branches.count(0)} of {len(branches)}: {text[number - 1].strip()}")


def main():
    build, folder = sys.argv[1], sys.argv[2]
    files = collect(build, folder)
    print(f"{'file':28} {'lines':>13} {'':8} {'branches':>13}")
    total = [0, 0, 0, 0]
    for name in sorted(files):
        f = figures(files[name])
        total = [a + b for a, b in zip(total, f)]
        print(row(name, f))
    print(row("all", total))
    if "--missing" in sys.argv:
        show_missing(folder, files)
    return 0 if share(*total[:2]) >= LINES and share(*total[2:]) >= BRANCHES else 1


if __name__ == "__main__":
    sys.exit(main())
