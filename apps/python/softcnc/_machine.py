# SPDX-License-Identifier: MIT
"""Machines and states: what a program runs on, and what earlier programs have left there."""
from __future__ import annotations

import os
import re
from typing import Any, Union

from . import _core

PathLike = Union[str, "os.PathLike[str]"]


def settings_of(values: dict[str, Any]) -> list[str]:
    """Returns KEY=VALUE as `--set` takes it. Two underscores of a key stand for a dot."""
    texts = []
    for key, value in values.items():
        text = str(value).lower() if isinstance(value, bool) else str(value)
        texts.append(f"{key.replace('__', '.')}={text}")
    return texts


class Machine:
    """A machine: its axes, limits and period. Machines do not change; set() returns another one."""

    def __init__(self) -> None:
        """Makes the built-in machine: three axes, a period of 1 ms."""
        self._core = _core.Machine()

    @classmethod
    def _of(cls, core: _core.Machine) -> Machine:
        machine = cls()
        machine._core = core
        return machine

    @classmethod
    def load(cls, file: PathLike) -> Machine:
        """Loads a machine file (TOML). Raises Error."""
        return cls._of(_core.Machine.load(os.fspath(file)))

    @classmethod
    def parse(cls, text: str, name: str = "machine") -> Machine:
        """Reads the text of a machine file; `name` stands for the file in messages."""
        return cls._of(_core.Machine.parse(text, name))

    def set(self, **values: Any) -> Machine:
        """Returns the machine with other values, as `--set` of the command takes them.

        Write axis__x__jerk_mm_s3=0, or **{"axis.x.jerk_mm_s3": 0}. Raises Error.
        """
        return Machine._of(self._core.set(settings_of(values))) if values else self

    @property
    def period(self) -> float:
        """The time from one row to the next, s."""
        return self._core.period

    def toml(self) -> str:
        """Returns a complete machine file, which loads as the same machine."""
        return self._core.toml()

    def __repr__(self) -> str:
        name = re.search(r'^name = "(.*)"', self.toml(), re.M)
        return f"<Machine {name[1] if name else ''}, a period of {1e3 * self.period:g} ms>"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Machine) and self.toml() == other.toml()

    def __hash__(self) -> int:
        return hash(self.toml())

    def __reduce__(self) -> Any:
        return Machine.parse, (self.toml(),)


class State:
    """What programs leave on a machine: work offsets, tools, variables, as a state file holds it."""

    def __init__(self) -> None:
        """Makes the state of a machine on which nothing has been set."""
        self._core = _core.State()

    @classmethod
    def _of(cls, core: _core.State) -> State:
        state = cls()
        state._core = core
        return state

    @classmethod
    def load(cls, file: PathLike) -> State:
        """Loads a state file (TOML). Raises Error."""
        return cls._of(_core.State.load(os.fspath(file)))

    @classmethod
    def parse(cls, text: str, name: str = "state") -> State:
        """Reads the text of a state file; `name` stands for the file in messages."""
        return cls._of(_core.State.parse(text, name))

    def toml(self) -> str:
        """Returns the text of a state file, which loads as the same state."""
        return self._core.toml()

    def __repr__(self) -> str:
        return f"<State of {len(self.toml().splitlines())} lines>"

    def __reduce__(self) -> Any:
        return State.parse, (self.toml(),)
