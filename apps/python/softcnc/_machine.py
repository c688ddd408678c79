# SPDX-License-Identifier: MIT
"""Machines and states: what a program runs on, and what earlier programs have left there."""
from __future__ import annotations

import os
import re
from typing import Any, ClassVar, Self, Union

from . import _core

PathLike = Union[str, "os.PathLike[str]"]


def settings_of(values: dict[str, Any]) -> list[str]:
    """Returns KEY=VALUE as `--set` takes it. Two underscores of a key stand for a dot."""
    texts = []
    for key, value in values.items():
        text = str(value).lower() if isinstance(value, bool) else str(value)
        texts.append(f"{key.replace('__', '.')}={text}")
    return texts


class _Described:
    """What a TOML file describes."""

    _make: ClassVar[Any]  # of the core
    _name: ClassVar[str]

    def __init__(self) -> None:
        self._core = self._make()

    @classmethod
    def _of(cls, core: Any) -> Self:
        made = cls()
        made._core = core
        return made

    @classmethod
    def load(cls, file: PathLike) -> Self:
        """Loads such a file. Raises Error."""
        return cls._of(cls._make.load(os.fspath(file)))

    @classmethod
    def parse(cls, text: str, name: str = "") -> Self:
        """Reads the text of such a file; `name` stands for the file in messages. Raises Error."""
        return cls._of(cls._make.parse(text, name or cls._name))

    def toml(self) -> str:
        """Returns the text of a complete file, which loads as the same."""
        text: str = self._core.toml()
        return text

    def __reduce__(self) -> Any:
        return type(self).parse, (self.toml(),)


class Machine(_Described):
    """A machine: its axes, limits and period. Machines do not change; set() returns another one.

    Without a file it is the built-in machine: three axes, a period of 1 ms.
    """

    _make, _name = _core.Machine, "machine"

    def set(self, **values: Any) -> Machine:
        """Returns the machine with other values, as `--set` of the command takes them.

        Write axis__x__jerk_mm_s3=0, or **{"axis.x.jerk_mm_s3": 0}. Raises Error.
        """
        return Machine._of(self._core.set(settings_of(values))) if values else self

    @property
    def period(self) -> float:
        """The time from one row to the next, s."""
        return float(self._core.period)

    def __repr__(self) -> str:
        name = re.search(r'^name = "(.*)"', self.toml(), re.M)
        return f"<Machine {name[1] if name else ''}, a period of {1e3 * self.period:g} ms>"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Machine) and self.toml() == other.toml()

    def __hash__(self) -> int:
        return hash(self.toml())


class State(_Described):
    """What programs leave on a machine: work offsets, tools, variables, as a state file holds it.

    Without a file it is that of a machine on which nothing has been set.
    """

    _make, _name = _core.State, "state"

    def __repr__(self) -> str:
        return f"<State of {len(self.toml().splitlines())} lines>"
