#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the examples of docs/python.md, one after the other, as somebody who types them.

usage: tests/python/documented.py FOLDER

Pictures go into FOLDER. SOFTCNC is the program softcnc; the package is imported from PYTHONPATH.
"""
import os
import re
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def examples():
    """Returns the blocks of Python on the page, each with the line on which it begins."""
    text = (ROOT / "docs" / "python.md").read_text()
    found = re.finditer(r"^```python\n(.*?)^```$", text, re.M | re.S)
    return [(text[: block.start(1)].count("\n"), block[1]) for block in found]


def run(folder):
    """Runs them in FOLDER, where they find the programs of the project."""
    import matplotlib

    matplotlib.use("Agg")
    os.environ["PATH"] = f"{Path(os.environ['SOFTCNC']).parent}:{os.environ['PATH']}"
    os.chdir(folder)
    (Path(folder) / "programs").symlink_to(ROOT / "programs")
    names = {}
    for line, code in examples():
        exec(compile("\n" * line + code, "docs/python.md", "exec"), names)
    return names


if __name__ == "__main__":
    here = Path.cwd()
    with tempfile.TemporaryDirectory() as scratch:
        run(scratch)
        os.chdir(here)
        for picture in Path(scratch).glob("*.png"):
            (Path(sys.argv[1]) / picture.name).write_bytes(picture.read_bytes())
