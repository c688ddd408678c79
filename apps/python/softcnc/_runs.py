# SPDX-License-Identifier: MIT
"""Programs that are checked, read as blocks, planned and simulated."""
from __future__ import annotations

import json
import os
from typing import Any, Callable, Iterable, Mapping, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._machine import Machine, PathLike, State, settings_of

MachineLike = Union[Machine, PathLike, None]
Limit = Callable[
    [NDArray[np.float64], NDArray[np.float64], NDArray[np.float64], float, bool], float
]


def _is_text(program: PathLike) -> bool:
    return isinstance(program, str) and "\n" in program


def part_of(program: PathLike) -> _core.Part:
    """A text has more than one line; everything else is the name of a file."""
    if _is_text(program):
        return _core.Part.of_text(str(program), "program")
    return _core.Part(os.fspath(program))


def names_of(names: Iterable[Any] | None) -> list[str] | None:
    """Returns a list of names; one name alone is a mistake."""
    if names is None:
        return None
    if isinstance(names, (str, bytes)):
        raise TypeError(f"a list of names is expected, not {names!r}")
    return [os.fspath(name) for name in names]


def machine_of(
    program: PathLike | None, machine: MachineLike, values: dict[str, Any]
) -> tuple[Machine, list[_core.Diagnostic]]:
    """Returns the machine of a run: the one that is given, otherwise that beside the program.

    With it come warnings about what does not count in a file beside the program.
    """
    if machine is None and program is not None and not _is_text(program):
        beside = _core.machine_beside(os.fspath(program), settings_of(values))
        if beside is not None:
            return Machine._of(beside[0]), beside[1]
    if machine is None:
        machine = Machine()
    elif not isinstance(machine, Machine):
        machine = Machine.load(machine)
    return machine.set(**values), []


def options_of(
    dialect: str = "linuxcnc",
    feed_override: float = 1.0,
    block_skip: bool = False,
    optional_stop: bool = False,
    subprograms: Iterable[PathLike] = (),
    define: Mapping[str, float] | None = None,
    state: State | PathLike | None = None,
    limit: Limit | None = None,
) -> _core.Options:
    """Returns the options of a run; see plan()."""
    options = _core.Options()
    options.dialect = dialect
    options.feed_override = feed_override
    options.block_skip = block_skip
    options.optional_stop = optional_stop
    options.subprograms = names_of(subprograms) or []
    options.define = {str(name): value for name, value in (define or {}).items()}
    if state is not None:
        options.state = (state if isinstance(state, State) else State.load(state))._core
    options.limit = limit
    return options


_OPTIONS = frozenset(options_of.__code__.co_varnames[: options_of.__code__.co_argcount])


def split(values: dict[str, Any]) -> tuple[_core.Options, dict[str, Any]]:
    """Returns the options of a run among keyword arguments, and the values of the machine."""
    for key in values:
        if key not in _OPTIONS and key != "name" and "." not in key.replace("__", "."):
            raise TypeError(
                f"{key!r} is neither an option ({', '.join(sorted(_OPTIONS))}) nor a key of a machine,"
                " as axis__x__jerk_mm_s3"
            )
    chosen = {key: value for key, value in values.items() if key in _OPTIONS}
    return options_of(**chosen), {k: v for k, v in values.items() if k not in _OPTIONS}


class Trace:
    """The rows of a run, one per period of the machine, as arrays.

    Each column is an attribute with the name that it has in a trace: t_s (s), line, block, s_mm
    (mm of path), v_mm_s and a_mm_s2 (along the path), limit (what limits the speed, text), x_mm,
    y_mm, z_mm (commanded), feed_mm_s (programmed). All have one number per row, shape (rows,).
    """

    def __init__(self, result: Mapping[str, Any]) -> None:
        self._columns: dict[str, NDArray[Any]] = dict(result["columns"])
        #: How long the program takes, s; not rounded to periods.
        self.time_s: float = result.get("time_s", float("nan"))
        #: Length of the path, mm.
        self.length_mm: float = result.get("length_mm", float("nan"))
        #: Warnings and notes.
        self.diagnostics: list[_core.Diagnostic] = list(result.get("diagnostics", []))

    @property
    def columns(self) -> tuple[str, ...]:
        """The names of the columns, in the order of a trace."""
        return tuple(self._columns)

    def __getitem__(self, column: str) -> NDArray[Any]:
        if column not in self._columns:
            raise KeyError(self._missing(column))
        return self._columns[column]

    def __getattr__(self, column: str) -> NDArray[Any]:
        if column.startswith("_") or column not in self._columns:
            raise AttributeError(column if column.startswith("_") else self._missing(column))
        return self._columns[column]

    def _missing(self, column: str) -> str:
        return f"no column {column!r}; there are {', '.join(self._columns)}"

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._columns]

    def __len__(self) -> int:
        return len(next(iter(self._columns.values()), ()))

    def __repr__(self) -> str:
        return f"<Trace of {len(self)} rows, {self.time_s:.3f} s: {', '.join(self._columns)}>"

    @property
    def position(self) -> NDArray[np.float64]:
        """The commanded positions, mm, shape (rows, axes)."""
        axes = [name for name in ("x_mm", "y_mm", "z_mm") if name in self._columns]
        if not axes:
            raise AttributeError("no column of an axis was asked for")
        return np.column_stack([self._columns[name] for name in axes])


def plan(
    program: PathLike,
    machine: MachineLike = None,
    *,
    columns: Sequence[str] | None = None,
    **values: Any,
) -> Trace:
    """Plans a program and returns the rows that `softcnc run --dry-run` writes.

    program: the name of a file, or a text of more than one line.
    machine: a Machine or the name of a machine file; without it the file beside the program that
        ends in .toml, otherwise the built-in machine.
    columns: the columns that are kept, in this order, those of CURVE_COLUMNS among them; without it
        all except these.
    values: options of the run (dialect, feed_override, block_skip, optional_stop, subprograms,
        define, state, limit), and values of the machine as Machine.set() takes them. `limit` is a
        function of position (mm, shape (3,)), unit tangent (3,), curvature vector (1/mm, (3,)),
        feed (mm/s) and rapid (bool) that returns the largest speed, mm/s, above 0; in the column
        `limit` it is "custom".

    Raises Error where the program has errors, ValueError for an unknown column or dialect, and
    whatever `limit` raises. Ctrl-C ends it.
    """
    return _run(program, machine, columns, values, simulated=False)


def simulate(
    program: PathLike,
    machine: MachineLike = None,
    *,
    columns: Sequence[str] | None = None,
    **values: Any,
) -> Trace:
    """Runs a program on the simulated mill; as plan(), with the columns of the mill.

    Those are, for each axis, the actual position (x_act_mm), its distance from the command (x_err_um)
    and the current of the motor (x_current_a), and contour_um, the distance of the table from the
    path.
    """
    return _run(program, machine, columns, values, simulated=True)


def _run(
    program: PathLike,
    machine: MachineLike,
    columns: Sequence[str] | None,
    values: dict[str, Any],
    simulated: bool,
) -> Trace:
    options, settings = split(values)
    model, warnings = machine_of(program, machine, settings)
    asked = names_of(columns)
    result = _core.run(part_of(program), model._core, options, asked, simulated)
    result["diagnostics"] = warnings + result["diagnostics"]
    return Trace(result)


def check(program: PathLike, machine: MachineLike = None, **values: Any) -> list[_core.Diagnostic]:
    """Returns all that is wrong with a program, as `softcnc check` reports it.

    The arguments are those of plan(). Errors of the program are in the list, not raised; a file
    that cannot be read and a wrong machine raise Error.
    """
    options, settings = split(values)
    model, warnings = machine_of(program, machine, settings)
    return warnings + _core.check(part_of(program), model._core, options)


def blocks(program: PathLike, machine: MachineLike = None, **values: Any) -> list[dict[str, Any]]:
    """Returns the blocks of a program as `softcnc blocks` prints them, each a dict.

    The arguments are those of plan(). Raises Error where the program has errors.
    """
    options, settings = split(values)
    model, _ = machine_of(program, machine, settings)
    return [json.loads(line) for line in _core.blocks(part_of(program), model._core, options)]
