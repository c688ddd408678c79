# SPDX-License-Identifier: MIT
"""The programs of bench that measure."""
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]


def built(target):
    """The program of bench with that name; builds it first."""
    done = subprocess.run([ROOT / "scripts/parts/build_bench", target], check=False)
    if done.returncode:
        sys.exit(done.returncode)
    return ROOT / "build/release/bench" / target
