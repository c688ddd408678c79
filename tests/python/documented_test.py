# SPDX-License-Identifier: MIT
"""The examples of docs/python.md run, and show what the page says."""
import os
import re
import subprocess
import sys
from pathlib import Path

import documented
import pytest


def test_the_examples_run_and_draw_the_pictures_of_the_page(tmp_path, monkeypatch, root):
    monkeypatch.chdir(tmp_path)
    names = documented.run(tmp_path)
    page = (root / "docs" / "python.md").read_text()
    drawn = {file.name for file in tmp_path.glob("*.png")}
    assert drawn == set(re.findall(r"\(pictures/(python_\w+\.png)\)", page))
    assert all((root / "docs" / "pictures" / name).exists() for name in drawn)
    assert names["kv"] == pytest.approx(30, rel=0.01)
    assert names["times"][0] != names["times"][-1]


def test_the_package_is_typed(root, tmp_path):
    package = Path(os.environ["PYTHONPATH"].split(":")[0]) / "softcnc"
    done = subprocess.run(
        ["/usr/bin/mypy", "--strict", "--cache-dir", str(tmp_path), str(package)],
        capture_output=True, text=True,
    )
    assert done.returncode == 0, done.stdout


def test_everything_has_a_docstring():
    import inspect

    import softcnc

    for name in softcnc.__all__:
        thing = getattr(softcnc, name)
        if not (inspect.isclass(thing) or inspect.isfunction(thing)):
            continue
        assert inspect.getdoc(thing), name
        if thing.__module__.startswith("softcnc._core"):
            continue
        for member, value in vars(thing).items() if inspect.isclass(thing) else ():
            if not member.startswith("_") and callable(getattr(value, "fget", value)):
                assert inspect.getdoc(value), f"{name}.{member}"
