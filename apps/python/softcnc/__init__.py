# SPDX-License-Identifier: MIT
"""softcnc in Python: what a control will do with a part program, as arrays of numpy.

    import softcnc

    trace = softcnc.plan("part.nc")
    print(trace.time_s, trace.v_mm_s.max(), "mm/s")

Lengths are in mm, times in s, angles in degrees; the names of columns and of keys of machines carry
their units. Where there is no result, softcnc.Error is raised, and its `diagnostics` say why.
"""
from ._core import CURVE_COLUMNS, Diagnostic, Error, __version__
from ._machine import Machine, State
from ._nurbs import Nurbs
from ._runs import Trace, blocks, check, plan, simulate
from ._session import Session
from ._walk import Walk, walk

__all__ = [
    "CURVE_COLUMNS",
    "Diagnostic",
    "Error",
    "Machine",
    "Nurbs",
    "Session",
    "State",
    "Trace",
    "Walk",
    "__version__",
    "blocks",
    "check",
    "plan",
    "simulate",
    "walk",
]
