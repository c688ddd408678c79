#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Senders of grbl at `softcnc serve`, on a pseudo-terminal and by TCP.

    tests/apps/serve_clients.py SOFTCNC [CHORDS]

Streams 5,000 chords, or as many as are given, of 0.1 mm at F15000 by both protocols of grbl's
streamers, over both connections: the time must be that of `run`, within half a percent and a few
periods. Then: a second client, one that vanishes, one that speaks HTTP, one that never reads, lines
without end, and a program that the sender begins by `~`.
"""
import csv
import math
import os
import pathlib
import socket
import subprocess
import sys
import tempfile
import time

from grbl_client import Server, by_tcp, by_terminal

CHORDS, CHORD = 5000, 0.1  # mm


def program(chords):
    lines = ["G21 G90 G1 F15000"]
    for i in range(1, chords + 1):
        s = CHORD * i
        lines.append(f"X{s:.4f} Y{10 * math.sin(s / 20):.4f}")
    return lines


def stream(line, lines, counts):
    """grbl's two ways: by counting characters, or by waiting for each answer."""
    sent, answered, outstanding = 0, 0, []
    while answered < len(lines):
        while sent < len(lines) and (sum(outstanding) + len(lines[sent]) < 1000 if counts else
                                     not outstanding):
            line.send(lines[sent].encode() + b"\n")
            outstanding.append(len(lines[sent]) + 1)
            sent += 1
        answer = line.line()
        assert answer == "ok", answer
        outstanding.pop(0)
        answered += 1
    while not line.report().startswith("<Idle"):
        time.sleep(0.02)


def moving_time(trace):
    with open(trace, encoding="utf-8") as file:
        rows = [float(row["v_mm_s"]) for row in csv.DictReader(r for r in file if r[0] != "#")]
    return sum(v > 0 for v in rows) / 1000


def streams(softcnc, folder, chords=CHORDS):
    (folder / "p.nc").write_text("\n".join(program(chords)) + "\n", encoding="utf-8")
    travel = ("--set", f"axis.x.max_mm={CHORD * chords + 1000}")
    subprocess.run(
        [softcnc, "run", "-q", "p.nc", "--dialect", "grbl", "--trace", "run.csv", *travel],
        cwd=folder, check=True, stderr=subprocess.DEVNULL)
    wanted = moving_time(folder / "run.csv")
    for name, connect in (("tcp", lambda server: by_tcp(server.port)),
                          ("pty", lambda server: by_terminal(server.link))):
        for counts in (False, True):
            trace = folder / f"{name}{counts}.csv"
            server = Server(softcnc, folder, "--trace", str(trace), *travel)
            stream(connect(server), program(chords), counts)
            server.end()
            took = moving_time(trace)
            print(f"{chords} chords, {name}, {'counting' if counts else 'waiting'}: {took:.3f} s, "
                  f"run {wanted:.3f} s, {100 * (took / wanted - 1):+.3f} %", flush=True)
            assert abs(took - wanted) <= 0.005 * wanted + 0.005, (name, counts, took, wanted)


def several(softcnc, folder):
    server = Server(softcnc, folder, "--state", str(folder / "s.toml"), "--set", "operate.alone_s=1")
    first, second = by_tcp(server.port), by_tcp(server.port)
    assert first.ask(b"M3 S1000\n")[-1] == "ok"
    assert first.ask(b"G91 G1 X500 F3000\n")[-1] == "ok"
    time.sleep(0.3)
    assert second.ask(b"G1 X1\n") == ["error:8"]
    assert second.report().startswith("<Run|")
    second.send(b"!")
    time.sleep(0.4)
    assert first.report().startswith("<Hold:0|")
    first.send(b"~")
    time.sleep(0.2)
    assert first.report().startswith("<Run|")
    first.owner.close()  # it vanishes in the middle of a move
    time.sleep(0.5)
    report = second.report()
    assert report.startswith("<Hold:0|") and ",1000" in report, report
    time.sleep(1.2)  # nobody commands: the spindle goes off
    assert ",1000" not in second.report()
    web = socket.create_connection(("127.0.0.1", server.port))
    web.sendall(b"POST / HTTP/1.1\r\nHost: x\r\n\r\nG91 G1 X5 F100\n")
    web.settimeout(5)
    heard = b""
    while data := web.recv(4096):
        heard += data
    assert b"ok" not in heard, heard
    deaf = socket.create_connection(("127.0.0.1", server.port))
    deaf.setblocking(False)
    for _ in range(2000):  # it sends, and never reads
        try:
            deaf.send(b"?$G\n" * 200)
        except BlockingIOError:
            time.sleep(0.001)
        except OSError:
            break
    assert second.report().startswith("<")
    deaf.close()
    server.end()
    state = (folder / "s.toml").read_text(encoding="utf-8")
    assert 'in_motion = "no"' in state


def lines_without_end(softcnc, folder):
    server = Server(softcnc, folder)
    line = by_terminal(server.link)
    for _ in range(200):
        line.send(b"x" * 500)
    line.send(b"\n")
    assert line.line() == "error:11"
    assert line.ask(b"G91 G1 X1 F1000 (" + b"c" * 3000 + b")\n")[-1] == "ok"
    server.end()


def own_program(softcnc, folder):
    (folder / "own.nc").write_text("G21 G90 G1 X20 F3000\nY20\nX0\nY0\nM30\n", encoding="utf-8")
    server = Server(softcnc, folder, "own.nc")
    line = by_tcp(server.port)
    assert line.report().startswith("<Idle|")
    line.send(b"~")
    time.sleep(0.3)
    assert "|Ln:1|" in line.report()
    assert line.ask(b"G1 X1\n") == ["error:8"]
    time.sleep(3)
    assert line.report().startswith("<Idle|MPos:0.000,0.000,0.000|")
    server.end()


def main():
    softcnc = os.path.abspath(sys.argv[1])
    chords = int(sys.argv[2]) if len(sys.argv) > 2 else CHORDS
    with tempfile.TemporaryDirectory() as name:
        streams(softcnc, pathlib.Path(name), chords)
    for part in (several, lines_without_end, own_program):
        with tempfile.TemporaryDirectory() as name:
            part(softcnc, pathlib.Path(name))


if __name__ == "__main__":
    main()
