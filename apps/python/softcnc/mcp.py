# SPDX-License-Identifier: MIT
"""A server of the Model Context Protocol: python3 -m softcnc.mcp.

It reads requests (JSON-RPC 2.0, one per line) from standard input and answers on standard output.
Programs and machines come as texts; no file is read or written.
"""
from __future__ import annotations

import json
import sys
from typing import Any, Callable, TextIO

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


def _arguments(arguments: dict[str, Any]) -> tuple[str, Machine, dict[str, Any]]:
    text = str(arguments["program"]) + "\n"
    machine = arguments.get("machine")
    values = {"dialect": arguments["dialect"]} if "dialect" in arguments else {}
    return text, Machine.parse(machine) if machine else Machine(), values


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
    changed = machine.set(**arguments["values"])
    before, after = (plan(text, m, columns=["t_s"], **values).time_s for m in (machine, changed))
    return json.dumps({"before_s": before, "after_s": after, "saved_s": before - after})


def _compare(arguments: dict[str, Any]) -> str:
    text, machine, values = _arguments(arguments)
    columns = ["chord_error_um", "feed_fluctuation"]
    rows = {}
    for method in arguments.get("methods", ["arc-length", "taylor1", "taylor2", "chords"]):
        trace = plan(
            text, machine.set(control__interpolation=method), columns=columns, **values
        )
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


def _call(parameters: dict[str, Any]) -> dict[str, Any]:
    """Errors of a tool are answers, which whoever asked can read."""
    try:
        tool = TOOLS[parameters["name"]][1]
        text, wrong = tool(parameters.get("arguments", {})), False
    except Error as error:
        text, wrong = str(error), True
    except KeyError as error:
        text, wrong = f"missing or unknown: {error}", True
    except (TypeError, ValueError) as error:
        text, wrong = str(error), True
    return {"content": [{"type": "text", "text": text}], "isError": wrong}


def answer(request: dict[str, Any]) -> dict[str, Any] | None:
    """Returns the answer to a request, or nothing to a notification."""
    if "id" not in request:
        return None
    method, parameters = request.get("method"), request.get("params") or {}
    result: dict[str, Any]
    if method == "initialize":
        asked = parameters.get("protocolVersion")
        result = {
            "protocolVersion": asked if asked in VERSIONS else VERSIONS[0],
            "capabilities": {"tools": {}},
            "serverInfo": {"name": "softcnc", "version": __version__},
        }
    elif method == "ping":
        result = {}
    elif method == "tools/list":
        result = {"tools": [{"name": name, **tool[0]} for name, tool in TOOLS.items()]}
    elif method == "tools/call":
        result = _call(parameters)
    else:
        error = {"code": -32601, "message": f"no method {method!r}"}
        return {"jsonrpc": "2.0", "id": request["id"], "error": error}
    return {"jsonrpc": "2.0", "id": request["id"], "result": result}


def serve(requests: TextIO, answers: TextIO) -> None:
    """Answers requests until they end."""
    for line in requests:
        if not line.strip():
            continue
        try:
            request = json.loads(line)
        except ValueError as error:
            wrong = {"code": -32700, "message": str(error)}
            reply: dict[str, Any] | None = {"jsonrpc": "2.0", "id": None, "error": wrong}
        else:
            reply = answer(request if isinstance(request, dict) else {})
        if reply is not None:
            answers.write(json.dumps(reply) + "\n")
            answers.flush()


if __name__ == "__main__":
    serve(sys.stdin, sys.stdout)
