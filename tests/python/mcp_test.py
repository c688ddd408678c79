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
    first, second, third, fourth = talk(hello, begun, tools, unknown, "{ no json")
    assert first["result"]["protocolVersion"] == "2025-03-26"
    assert first["result"]["serverInfo"]["version"] == softcnc.__version__
    assert second["id"] == "b"
    assert [tool["name"] for tool in second["result"]["tools"]] == [
        "check", "report", "what_if", "compare",
    ]
    assert third["error"]["code"] == -32601 and fourth["error"]["code"] == -32700


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
    assert call("dance", program=PROGRAM)[1]
    assert call("what_if", program=PROGRAM, values={"axis.x.speed": 1})[1]
    assert call("check", program=PROGRAM, dialect="klingon")[1]
