# SPDX-License-Identifier: MIT
"""The server of the Model Context Protocol, by what it reads and writes."""
import json
import subprocess
import sys

import softcnc

PROGRAM = "G1 X10 F600\nG2 X20 I5\nM2\n"


def talk(*requests):
    """Returns the answers of a server to requests, or texts that are none."""
    lines = [one if isinstance(one, str) else json.dumps(one) for one in requests]
    done = subprocess.run(
        [sys.executable, "-m", "softcnc.mcp"], input="\n".join(lines) + "\n",
        capture_output=True, text=True, timeout=60,
    )
    assert done.returncode == 0 and done.stderr == ""
    return [json.loads(line) for line in done.stdout.splitlines()]


def call(name, **arguments):
    request = {
        "jsonrpc": "2.0", "id": 7, "method": "tools/call",
        "params": {"name": name, "arguments": arguments},
    }
    result = talk(request)[0]["result"]
    return result["content"][0]["text"], result["isError"]


def test_it_begins_as_the_protocol_says():
    hello = {
        "jsonrpc": "2.0", "id": 1, "method": "initialize",
        "params": {"protocolVersion": "2025-03-26", "capabilities": {}},
    }
    begun = {"jsonrpc": "2.0", "method": "notifications/initialized"}
    tools = {"jsonrpc": "2.0", "id": "b", "method": "tools/list"}
    unknown = {"jsonrpc": "2.0", "id": 3, "method": "prompts/list"}
    dance = {"jsonrpc": "2.0", "id": 4, "method": "tools/call", "params": {"name": "dance"}}
    first, second, third, fourth, fifth = talk(hello, begun, tools, unknown, "{ no json", dance)
    assert first["result"]["protocolVersion"] == "2025-03-26"
    assert first["result"]["serverInfo"]["version"] == softcnc.__version__
    assert second["id"] == "b"
    assert [tool["name"] for tool in second["result"]["tools"]] == [
        "check", "report", "what_if", "compare",
    ]
    assert third["error"]["code"] == -32601 and fourth["error"]["code"] == -32700
    assert fifth["error"]["code"] == -32602


def test_check_shows_what_is_wrong():
    assert call("check", program=PROGRAM) == ("nothing is wrong", False)
    text, wrong = call("check", program="G1 X10 F600\nG1 X\n")
    assert "[SC1002]" in text and not wrong


def test_report_has_the_figures_of_the_plan():
    report = json.loads(call("report", program=PROGRAM)[0])
    trace = softcnc.plan(PROGRAM)
    assert report["time_s"] == trace.time_s and report["v_mm_s_max"] == trace.v_mm_s.max()
    assert abs(sum(report["seconds_by_limit"].values()) - len(trace) * 0.001) < 1e-9


def test_what_if_and_compare():
    values = {"axis.x.acceleration_mm_s2": 100}
    text = json.loads(call("what_if", program=PROGRAM, values=values)[0])
    assert text["after_s"] == softcnc.plan(PROGRAM, **values).time_s > text["before_s"]
    rows = json.loads(call("compare", program=PROGRAM, methods=["arc-length", "chords"])[0])
    assert rows["chords"]["time_s"] > 0 and list(rows) == ["arc-length", "chords"]


def test_errors_of_a_tool_are_answers():
    assert call("report", program="G1 X\n")[1]
    assert "program" in call("report")[0]
    assert call("compare", program=PROGRAM, methods=["magic"])[1]
    assert call("what_if", program=PROGRAM, values={"axis.x.speed": 1})[1]
    assert call("check", program=PROGRAM, dialect="klingon")[1]


def test_requests_that_are_none_are_answered_as_such():
    ping = {"jsonrpc": "2.0", "id": 1, "method": "ping"}
    listed = {"jsonrpc": "2.0", "id": 2, "method": "initialize", "params": [1]}
    batch, number, empty, deep, wrong, last = talk([ping, ping], "5", {}, "[" * 200000, listed, ping)
    assert [one["result"] for one in batch] == [{}, {}]
    assert number["error"]["code"] == empty["error"]["code"] == -32600
    assert deep["error"]["code"] == -32700 and wrong["error"]["code"] == -32602
    assert last["result"] == {}


def test_no_file_is_read(tmp_path):
    (tmp_path / "foo.ngc").write_text("o<foo> sub\nG1 X77 F600\no<foo> endsub\n")
    program = "o<foo> call\nM2\n"
    folders = f'path = ["{tmp_path}"]'
    assert "program.path names a file" in call(
        "report", program=program, machine=f"[program]\n{folders}"
    )[0]
    assert "program.path names a file" in call(
        "report", program=program, machine=f"program.{folders}"
    )[0]
    assert "program.path names a file" in call(
        "what_if", program=program, values={"program.path": [str(tmp_path)]}
    )[0]
    assert call("report", program=program)[1]


def test_a_tool_without_an_end_is_ended(monkeypatch):
    from softcnc import mcp

    monkeypatch.setattr(mcp, "_SECONDS", 1)
    endless = "o100 while [1]\nG1 X10 F6000\nX0\no100 endwhile\nM2\n"
    result = mcp._call(mcp.TOOLS["report"][1], {"program": endless})
    assert result["isError"] and "ended after 1 s" in result["content"][0]["text"]
