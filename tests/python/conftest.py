# SPDX-License-Identifier: MIT
"""Where the tests of the Python package find the project and the command."""
import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def command():
    """Runs the command softcnc, and returns what it prints."""

    def run(*arguments, status=0):
        done = subprocess.run(
            [os.environ["SOFTCNC"], *map(str, arguments)], capture_output=True, text=True, cwd=ROOT
        )
        assert done.returncode == status, done.stderr
        return done.stdout

    return run


@pytest.fixture(scope="session")
def root():
    return ROOT
