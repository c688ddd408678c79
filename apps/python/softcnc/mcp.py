# SPDX-License-Identifier: MIT
"""A server of the Model Context Protocol: python3 -m softcnc.mcp.

It reads requests (JSON-RPC 2.0, one per line) from standard input and answers on standard output.
Programs and machines come as texts. No file is read or written: keys of a machine that name files
are refused. A tool that has no answer after a minute is ended.
"""
from __future__ import annotations

import json
import signal
import sys
import tomllib
from types import FrameType
from typing import Any, Callable, Iterator, Optional, TextIO

import numpy as np

from . import Error, Machine, __version__, check, plan

VERSIONS = ("2025-06-18", "2025-03-26", "2024-11-05")

_PROGRAM = {"type": "string", "description": "part program (G-code), the whole text"}
_MACHINE = {"type": "string", "description": "machine file (TOML); without it the built-in mill"}
_DIALECT = {"type": "string", "enum": ["linuxcnc", "fanuc", "haas", "grbl", "auto"]}
_VALUES = {
    "type": "object",
    "description": 'values of the machine, for example {"axis.x.acceleration_mm_s2": 2000}',
}


#: Keys of machines that name files or folders, by their last part.
_FILES = ("path", "file", "plant", "device")
_SECONDS = 60


def _keys(table: dict[str, Any], before: str = "") -> Iterator[str]:
    for key, value in table.items():
        yield before + key
        if isinstance(value, dict):
            yield from _keys(value, f"{before}{key}.")


def _refuse_files(keys: Iterator[str]) -> None:
    for key in keys:
        if key.rpartition(".")[2] in _FILES:
            raise ValueError(f"{key} names a file, which is not read here")


def _text(arguments: dict[str, Any], name: str) -> str:
    if not isinstance(arguments[name], str):
        raise TypeError(f"{name} must be a text")
    return str(arguments[name])


def _machine(arguments: dict[str, Any]) -> Machine:
    if not arguments.get("machine"):
        return Machine()
    text = _text(arguments, "machine")
    try:
        _refuse_files(_keys(tomllib.loads(text)))
    except tomllib.TOMLDecodeError:
        pass  # Machine.parse() says what is wrong, with its place
    return Machine.parse(text)


def _arguments(arguments: dict[str, Any]) -> tuple[str, Machine, dict[str, Any]]:
    values = {"dialect": _text(arguments, "dialect")} if "dialect" in arguments else {}
    return _text(arguments, "program") + "\n", _machine(arguments), values


def _check(arguments: dict[str, Any]) -> str:
    text, machine, values = _arguments(arguments)
    found = check(text, machine, **values)
    return "\n".join(map(str, found)) or "nothing is wrong"


def _report(arguments: dict[str, Any]) -> str:
    text, machine, values = _arguments(arguments)
    trace = plan(text, machine, columns=["line", "v_mm_s", "limit"], **values)
    limits, rows = np.unique(trace.limit, return_counts=True)
    lines, spent = np.unique(trace.line, return_counts=True)
    longest = np.argsort(-spent, kind="stable")[:10]
    report = {
        "time_s": trace.time_s,
        "length_mm": trace.length_mm,
        "v_mm_s_max": float(trace.v_mm_s.max(initial=0.0)),
        "seconds_by_limit": {str(k): float(n) * machine.period for k, n in zip(limits, rows)},
        "longest_lines": [
            {"line": int(lines[i]), "seconds": float(spent[i]) * machine.period} for i in longest
        ],
        "diagnostics": [str(one) for one in trace.diagnostics],
    }
    return json.dumps(report, indent=1)


def _what_if(arguments: dict[str, Any]) -> str:
    text, machine, values = _arguments(arguments)
    if not isinstance(arguments["values"], dict):
        raise TypeError("values must be an object")
    _refuse_files(iter(arguments["values"]))
    changed = machine.set(**arguments["values"])
    before, after = (plan(text, m, columns=["t_s"], **values).time_s for m in (machine, changed))
    return json.dumps({"before_s": before, "after_s": after, "saved_s": before - after})


def _compare(arguments: dict[str, Any]) -> str:
    text, machine, values = _arguments(arguments)
    columns = ["chord_error_um", "feed_fluctuation"]
    rows = {}
    for method in arguments.get("methods", ["arc-length", "taylor1", "taylor2", "chords"]):
        model = machine.set(control__interpolation=method)
        trace = plan(text, model, columns=columns, **values)
        rows[method] = {
            "time_s": trace.time_s,
            "chord_error_um_max": float(np.nanmax(trace.chord_error_um, initial=0.0)),
            "feed_fluctuation_max": float(
                np.nanmax(np.abs(trace.feed_fluctuation), initial=0.0)
            ),
        }
    return json.dumps(rows, indent=1)


def _tool(text: str, further: dict[str, Any], required: list[str]) -> dict[str, Any]:
    properties = {"program": _PROGRAM, "machine": _MACHINE, "dialect": _DIALECT, **further}
    schema = {"type": "object", "properties": properties, "required": ["program", *required]}
    return {"description": text, "inputSchema": schema}


_METHODS = {"type": "array", "items": {"type": "string"}, "description": "names of methods"}
TOOLS: dict[str, tuple[dict[str, Any], Callable[[dict[str, Any]], str]]] = {
    "check": (_tool("List all that is wrong with a part program.", {}, []), _check),
    "report": (
        _tool("Time of a part program, what limits it, and the lines that take longest.", {}, []),
        _report,
    ),
    "what_if": (
        _tool("Time of a part program with other values of the machine.", {"values": _VALUES},
              ["values"]),
        _what_if,
    ),
    "compare": (
        _tool("Interpolation methods side by side on a part program.", {"methods": _METHODS}, []),
        _compare,
    ),
}


def _time_is_up(_number: int, _frame: Optional[FrameType]) -> None:
    raise TimeoutError(f"ended after {_SECONDS} s")


def _call(tool: Callable[[dict[str, Any]], str], arguments: dict[str, Any]) -> dict[str, Any]:
    """Errors of a tool are answers, which whoever asked can read."""
    signal.signal(signal.SIGALRM, _time_is_up)
    signal.alarm(_SECONDS)
    try:
        text, is_wrong = tool(arguments), False
    except KeyError as error:
        text, is_wrong = f"missing: {error}", True
    except (Error, TypeError, ValueError, TimeoutError, MemoryError) as error:
        text, is_wrong = str(error) or type(error).__name__, True
    finally:
        signal.alarm(0)
    return {"content": [{"type": "text", "text": text}], "isError": is_wrong}


def _failed(number: Any, code: int, message: str) -> dict[str, Any]:
    return {"jsonrpc": "2.0", "id": number, "error": {"code": code, "message": message}}


def _result(method: Any, parameters: dict[str, Any]) -> dict[str, Any] | None:
    """Returns what a method returns; nothing for one that there is not."""
    if method == "initialize":
        asked = parameters.get("protocolVersion")
        return {
            "protocolVersion": asked if asked in VERSIONS else VERSIONS[0],
            "capabilities": {"tools": {}},
            "serverInfo": {"name": "softcnc", "version": __version__},
        }
    if method == "ping":
        return {}
    if method == "tools/list":
        return {"tools": [{"name": name, **tool[0]} for name, tool in TOOLS.items()]}
    if method == "tools/call":
        return _call(TOOLS[parameters["name"]][1], parameters.get("arguments") or {})
    return None


def answer(request: Any) -> dict[str, Any] | None:
    """Returns the answer to a request, or nothing to a notification."""
    if not isinstance(request, dict) or not isinstance(request.get("method"), str):
        return _failed(None, -32600, "not a request")
    if "id" not in request:
        return None
    number, method, parameters = request["id"], request["method"], request.get("params") or {}
    if not isinstance(parameters, dict) or not isinstance(parameters.get("arguments", {}), dict):
        return _failed(number, -32602, "params must be an object")
    if method == "tools/call" and parameters.get("name") not in TOOLS:
        return _failed(number, -32602, f"no tool {parameters.get('name')!r}")
    result = _result(method, parameters)
    if result is None:
        return _failed(number, -32601, f"no method {method!r}")
    return {"jsonrpc": "2.0", "id": number, "result": result}


def reply_to(line: str) -> Any:
    """Returns what is answered to a line: to a list of requests, a list; nothing where none is due."""
    try:
        request = json.loads(line)
    except (ValueError, RecursionError) as error:
        return _failed(None, -32700, str(error))
    if not isinstance(request, list) or not request:
        return answer(request)
    return [one for one in map(answer, request) if one is not None] or None


def serve(requests: TextIO, answers: TextIO) -> None:
    """Answers requests until they end."""
    for line in requests:
        reply = reply_to(line) if line.strip() else None
        if reply is not None:
            answers.write(json.dumps(reply) + "\n")
            answers.flush()


if __name__ == "__main__":
    serve(sys.stdin, sys.stdout)
