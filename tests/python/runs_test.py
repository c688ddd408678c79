# SPDX-License-Identifier: MIT
"""Runs in Python beside the command, whose rows they must have bit for bit."""
import json
import os
import resource
import signal
import subprocess
import sys
import threading
from pathlib import Path

import numpy as np
import pytest
import softcnc

PROGRAMS = sorted((Path(__file__).resolve().parents[2] / "programs").rglob("*.nc"))


def assert_same(trace, file):
    """Compares bits, of numbers as well as of text."""
    with np.load(file) as columns:
        assert sorted(columns.files) == sorted(trace.columns)
        for name in columns.files:
            ours, theirs = trace[name], columns[name]
            assert ours.dtype == theirs.dtype and ours.shape == theirs.shape, name
            assert ours.tobytes() == theirs.tobytes(), name


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda path: path.stem)
def test_rows_are_those_of_the_command(program, command, tmp_path):
    file = tmp_path / "rows.npz"
    command("run", "--dry-run", "-q", program, "--trace", file)
    with np.load(file) as columns:
        names = list(columns.files)
    assert_same(softcnc.plan(program, columns=names), file)


@pytest.mark.parametrize("name", ["01_line", "03_arc", "13_paper003_shapes"])
def test_simulated_rows_are_those_of_the_command(name, command, root, tmp_path):
    program, file = root / "programs" / f"{name}.nc", tmp_path / "rows.npz"
    command("run", "-q", program, "--set", "control.backend=sim", "--trace", file)
    with np.load(file) as columns:
        names = list(columns.files)
    assert_same(softcnc.simulate(program, columns=names), file)


def test_options_and_values_are_those_of_the_command(command, root, tmp_path):
    program, file = root / "programs" / "08_butterfly.nc", tmp_path / "rows.csv"
    command(
        "run", "--dry-run", "-q", program, "--feed-override", "50", "--set", "axis.x.jerk_mm_s3=9000",
        "--trace", file,
    )
    rows = np.genfromtxt(file, delimiter=",", names=True, dtype=None, encoding=None)
    trace = softcnc.plan(program, feed_override=0.5, axis__x__jerk_mm_s3=9000)
    for name in ("t_s", "s_mm", "v_mm_s", "x_mm", "y_mm"):
        assert np.array_equal(trace[name], rows[name])


def test_columns_that_are_asked_for_come_in_their_order(root):
    program = root / "programs" / "07_nurbs.nc"
    trace = softcnc.plan(program, columns=["chord_error_um", "t_s"])
    assert trace.columns == ("chord_error_um", "t_s")
    with pytest.raises(ValueError, match="no column 'speed'"):
        softcnc.plan(program, columns=["speed"])
    with pytest.raises(AttributeError, match="no column 'x_mm'; there are chord_error_um, t_s"):
        trace.x_mm


@pytest.mark.parametrize("name", ["unknown_code", "no_number"])
def test_errors_are_raised_as_the_command_shows_them(name, command, tmp_path):
    text = {"unknown_code": "G1 X1 F100\nG999\nM2\n", "no_number": "G1 X F100\nM2\n"}[name]
    program = tmp_path / "wrong.nc"
    program.write_text(text)
    shown = subprocess.run(
        [os.environ["SOFTCNC"], "check", program], capture_output=True, text=True
    ).stdout
    with pytest.raises(softcnc.Error) as raised:
        softcnc.plan(program)
    assert str(raised.value) in shown
    errors = [one for one in raised.value.diagnostics if one.severity == "error"]
    assert errors and all(one.code.startswith("SC") and one.line > 0 for one in errors)


def test_check_finds_what_the_command_finds(command, root):
    for program in sorted((root / "tests" / "bad").glob("*.nc"))[:60]:
        done = subprocess.run(
            [os.environ["SOFTCNC"], "check", "--diagnostics", "json", program],
            capture_output=True, text=True,
        )
        theirs = json.loads(done.stdout or done.stderr)
        try:
            ours = softcnc.check(program)
        except softcnc.Error as error:
            ours = error.diagnostics
        assert [(one.code, one.line, one.column, one.message) for one in ours] == [
            (one["code"], one.get("line", 0), one.get("column", 0), one["message"])
            for one in theirs
        ], program.name


@pytest.mark.parametrize("name", ["07_nurbs", "12_dwell_and_actions", "17_drilling_cycles"])
def test_blocks_are_those_of_the_command(name, command, root):
    program = root / "programs" / f"{name}.nc"
    theirs = [json.loads(line) for line in command("blocks", program).splitlines()]
    assert softcnc.blocks(program) == theirs


def test_a_file_that_is_not_there_and_a_wrong_machine_are_errors(tmp_path):
    with pytest.raises(softcnc.Error, match="SC6001"):
        softcnc.plan(tmp_path / "missing.nc")
    with pytest.raises(softcnc.Error, match="SC7001"):
        softcnc.plan("G1 X1 F100\nM2\n", axis__x__speed=3)
    with pytest.raises(ValueError, match="no dialect 'klingon'"):
        softcnc.plan("G1 X1 F100\nM2\n", dialect="klingon")


def test_a_state_shifts_the_program():
    session = softcnc.Session()
    session.feed("G10 L2 P1 X10 Y20\n")
    session.end()
    session.step(10)
    shifted = softcnc.plan("G0 X1 Y0\nM2\n", state=session.state)
    assert shifted.x_mm[-1] == 11 and shifted.y_mm[-1] == 20
    again = softcnc.State.parse(session.state.toml())
    assert softcnc.plan("G0 X1 Y0\nM2\n", state=again).x_mm[-1] == 11


def test_a_limit_of_ones_own_is_kept_and_what_it_raises_is_raised():
    text = "G1 X10 F6000\nM2\n"
    slow = softcnc.plan(text, limit=lambda position, tangent, curvature, feed, rapid: 7.0)
    assert slow.v_mm_s.max() == pytest.approx(7.0) and "custom" in slow.limit
    with pytest.raises(ZeroDivisionError):
        softcnc.plan(text, limit=lambda *point: 1 / 0)
    with pytest.raises(TypeError, match="a limit must return a speed"):
        softcnc.plan(text, limit=lambda *point: "fast")
    for speed in (0, -1, float("nan")):
        with pytest.raises(ValueError, match="a speed above 0"):
            softcnc.plan(text, limit=lambda *point: speed)


def test_values_that_are_wrong_are_refused():
    text = "G1 X10 F6000\nM2\n"
    for override in (0, -1, float("nan"), 2.5, float("inf")):
        with pytest.raises(ValueError, match="feed_override"):
            softcnc.plan(text, feed_override=override)
    for values in ({"columns": "t_s"}, {"subprograms": "subs"}, {"column": ["t_s"]}):
        with pytest.raises(TypeError):
            softcnc.plan(text, **values)
    with pytest.raises(ValueError, match="no column 'aa'"):
        softcnc.plan(text, columns=["aa", "bb"])
    with pytest.raises(softcnc.Error, match="SC6"):
        softcnc.plan("")
    with pytest.raises(softcnc.Error, match="SC6"):
        softcnc.plan("/")
    assert softcnc.plan("G1 X[#100] F600\nM2\n", define={100: 7}).x_mm[-1] == 7


def test_a_machine_beside_the_program_is_that_of_the_command(command, tmp_path):
    """A link out of the folder, or what is no file, is refused; files of backends do not count."""
    part, beside = tmp_path / "part.nc", tmp_path / "part.toml"
    part.write_text("G1 X10 F6000\nM2\n")
    beside.write_text('[control]\nperiod_ms = 2\nbackend = "stepdir"\n[backend.stepdir]\nfile = "/tmp/x.vcd"\n')
    assert softcnc.plan(part).t_s[1] == 0.002
    assert [one.code for one in softcnc.check(part)] == ["SC7021"]
    assert [one.code for one in softcnc.plan(part).diagnostics] == ["SC7021"]
    assert softcnc.check(part, softcnc.Machine()) == []
    beside.unlink()
    beside.symlink_to(tmp_path / "nowhere.toml")
    with pytest.raises(softcnc.Error, match="SC7003"):
        softcnc.plan(part)
    beside.unlink()
    os.mkfifo(beside)
    with pytest.raises(softcnc.Error, match="SC7003"):
        softcnc.plan(part)


def test_a_process_ends_while_a_thread_plans_with_a_limit():
    code = (
        "import softcnc, threading, time\n"
        "def plan():\n"
        f"    softcnc.plan({ENDLESS!r}, columns=['t_s'], limit=lambda *point: 20.0)\n"
        "threading.Thread(target=plan, daemon=True).start()\n"
        "time.sleep(0.3)\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert done.returncode == 0 and done.stderr == ""


ENDLESS = "o100 while [1]\nG1 X10 F6000\nX0\no100 endwhile\nM2\n"


def test_control_c_is_answered_within_a_second():
    code = (
        "import signal, softcnc, threading, os\n"
        "threading.Timer(1.0, lambda: os.kill(os.getpid(), signal.SIGINT)).start()\n"
        f"softcnc.plan({ENDLESS!r}, columns=['t_s'])\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=60
    )
    assert done.returncode in (1, -signal.SIGINT) and "KeyboardInterrupt" in done.stderr


def test_other_threads_run_while_a_program_is_planned(root):
    counted, done = 0, threading.Event()

    def count():
        nonlocal counted
        while not done.wait(0.001):
            counted += 1

    thread = threading.Thread(target=count)
    thread.start()
    for _ in range(3):
        softcnc.plan(root / "programs" / "08_butterfly.nc", columns=["t_s"])
    done.set()
    thread.join()
    assert counted > 20


def test_a_thousand_plans_leave_memory_level():
    text = "G1 X10 F6000\nG2 X20 I5\nM2\n"
    for _ in range(100):
        softcnc.plan(text)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    for _ in range(1000):
        softcnc.plan(text)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 2048  # KiB
