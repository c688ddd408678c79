# SPDX-License-Identifier: MIT
"""The limits of a machine, and whether the rows of a trace keep them."""
import math
import subprocess
import tomllib

import numpy as np

AXES = "xyz"
OVER, OVER_JERK = 1.001, 1.005  # docs/trace.md: by so much at most, as differences of rows
LANDING = 3  # periods: so much acceleration is left in the last row of a jerk-limited motion


class Limits:
    """What the machine of these options allows, one number for each axis: mm, s."""

    def __init__(self, softcnc, options, cwd=None):
        said = subprocess.run([softcnc, "machine", "--toml", *options], cwd=cwd, check=True,
                              capture_output=True, text=True).stdout
        machine = tomllib.loads(said)
        axes = [machine["axis"][axis] for axis in AXES]
        self.period = machine["control"]["period_ms"] / 1000
        self.velocity = np.array([axis["velocity_mm_min"] / 60 for axis in axes])
        self.acceleration = np.array([float(axis["acceleration_mm_s2"]) for axis in axes])
        self.jerk = np.array([axis["jerk_mm_s3"] or math.inf for axis in axes])


class Trace:
    """The rows of an .npz: places in mm, and speeds along the path."""

    def __init__(self, file):
        with np.load(file) as columns:
            self.places = np.stack([columns[f"{axis}_mm"] for axis in AXES], axis=1)
            self.speeds = columns["v_mm_s"]

    def travel(self):
        """The length of the polyline through the rows, in mm."""
        return float(np.linalg.norm(np.diff(self.places, axis=0), axis=1).sum())


def jumps(trace, limits):
    """The rows after which the machine is at rest, but not where and as it was a period before.

    That is so after an emergency stop, and where somebody has said where the machine stands.
    """
    if len(trace.places) < 2:
        return np.array([], dtype=int)
    steps = np.diff(trace.places, axis=0, prepend=trace.places[:1])  # row i: that ends there
    most = OVER * np.minimum(limits.acceleration * limits.period**2,
                             LANDING * limits.jerk * limits.period**3)
    rests = trace.speeds[1:] == 0
    changes = np.abs(np.diff(steps, axis=0))
    found = []
    for row in np.flatnonzero(rests & ((changes > most) | (np.abs(steps[1:]) > most)).any(axis=1)):
        follows = bool(found) and found[-1] == row - 1  # its own step is a jump
        change = np.abs(steps[row + 1]) if follows else changes[row]
        if (change > most).any():
            found.append(row)
    return np.array(found, dtype=int)


def exceeded(trace, limits, jumps_allowed=0):
    """What is beyond a limit, as lines of text.

    Every motion between two jumps begins at rest, and ends at rest where no jump ends it. A last
    row that moves counts as one.
    """
    if not len(trace.places):
        return []
    at = jumps(trace, limits)
    wrong = []
    count = len(at) + (trace.speeds[-1] > 0)
    if count > jumps_allowed:
        wrong.append(f"{count} jumps, not {jumps_allowed}: after rows {at[:10]}")
    bounds = [0, *(at + 1), len(trace.places)]
    for begin, end in zip(bounds, bounds[1:]):
        wrong += exceeded_between(trace, limits, begin, end)
    return wrong


def exceeded_between(trace, limits, begin, end):
    """The largest excess of each kind in these rows."""
    places = trace.places[begin:end]
    rests = [places[-1:]] * 3 if end == len(trace.places) and trace.speeds[-1] == 0 else []
    differences = np.concatenate([*[places[:1]] * 3, places, *rests])
    wrong = []
    for name, most, over in (("velocity", limits.velocity, OVER),
                             ("acceleration", limits.acceleration, OVER),
                             ("jerk", limits.jerk, OVER_JERK)):
        differences = np.diff(differences, axis=0) / limits.period
        ratio = np.abs(differences) / most
        row, axis = np.unravel_index(np.argmax(ratio), ratio.shape)
        if ratio[row, axis] > over:
            wrong.append(f"{name} of {AXES[axis]} is {ratio[row, axis]:.5f} of its limit near row "
                         f"{begin + max(0, row - 2)} of {len(trace.places)}")
    return wrong
