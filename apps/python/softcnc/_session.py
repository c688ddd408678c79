# SPDX-License-Identifier: MIT
"""A run that its user drives."""
from __future__ import annotations

from typing import Any, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._machine import State
from ._runs import MachineLike, Trace, machine_of, names_of, split


class Session:
    """A machine that takes text and gives a row per period; it has no clock.

    status is "running" (step() gives rows), "waiting" (for more text), "paused" (at M00, M01, M06:
    resume()), "done", "alarm", or "error" (a line was wrong: go_on()). One thread at a time can use
    a session; another one gets a RuntimeError.
    """

    def __init__(
        self,
        machine: MachineLike = None,
        *,
        simulated: bool = False,
        start: ArrayLike | None = None,
        **values: Any,
    ) -> None:
        """Opens a session at `start`, mm in machine coordinates; the rest as for plan().

        Without `start` the machine stands where its state says, or else at machine zero.

        simulated: rows have the columns of the simulated mill, as those of simulate().
        """
        options, settings = split(values)
        model, _ = machine_of(None, machine, settings)
        place = None if start is None else np.asarray(start, float)
        self._core = _core.Session(model._core, options, simulated, place)

    def __repr__(self) -> str:
        return f"<Session, {self.status}, at {self.position.tolist()} mm>"

    def feed(self, text: str) -> bool:
        """Adds text to the program; a line counts once its newline has come.

        Returns False where nothing more is taken: after end() and abort(), and after an error.
        """
        return self._core.feed(text)

    def step(self, rows: int = 1, columns: Sequence[str] | None = None) -> Trace:
        """Moves the machine by up to so many periods while it runs, and returns their rows.

        Ctrl-C ends the call without rows; `position` is where the machine stands then. What the
        limit of the session raises is raised here, and ends the session.
        """
        return Trace({"columns": self._core.step(rows, names_of(columns))})

    def end(self) -> None:
        """Ends the program: nothing more is fed."""
        self._core.end()

    def rest(self) -> None:
        """Lets the machine come to rest where what has been fed ends; more may be fed."""
        self._core.rest()

    def go_on(self) -> None:
        """After an error: forgets what was fed and not run, and takes more."""
        self._core.go_on()

    def hold(self) -> None:
        """Lets the machine come to rest on the path, until resume()."""
        self._core.hold()

    def resume(self) -> None:
        """Ends a hold or a pause."""
        self._core.resume()

    def abort(self) -> None:
        """Lets the machine come to rest on the path, and ends the program there."""
        self._core.abort()

    def set_feed_override(self, factor: float) -> None:
        """Multiplies the programmed feed, up to 2; what is below 0.001 holds."""
        self._core.set_feed_override(factor)

    def set_rapid_override(self, factor: float) -> None:
        """Multiplies the speed of rapids, from 0.01 to 1."""
        self._core.set_rapid_override(factor)

    @property
    def status(self) -> str:
        """How the session stands."""
        return self._core.status()

    @property
    def position(self) -> NDArray[np.float64]:
        """Where the last row was, mm, in machine coordinates, shape (3,)."""
        return self._core.position()

    @property
    def diagnostics(self) -> list[_core.Diagnostic]:
        """What has been reported so far."""
        return self._core.diagnostics()

    @property
    def state(self) -> State:
        """What the program has left so far; a session that begins with it goes on from there."""
        return State._of(self._core.state())
