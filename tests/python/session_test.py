# SPDX-License-Identifier: MIT
"""Sessions and curves in Python."""
import copy
import pickle
import threading

import numpy as np
import pytest
import softcnc
from scipy.interpolate import BSpline


def test_a_session_in_batches_is_the_plan(root):
    text = (root / "programs" / "03_arc.nc").read_text()
    session = softcnc.Session()
    assert session.feed(text)
    session.end()
    batches = []
    while session.status == "running":
        batches.append(session.step(97))
    assert session.status == "done"
    whole = softcnc.plan(text)
    for name in whole.columns:
        assert np.array_equal(np.concatenate([rows[name] for rows in batches]), whole[name]), name
    assert np.array_equal(session.position, whole.position[-1])


def test_a_session_goes_on_after_an_error_where_it_stands():
    session = softcnc.Session(start=(1, 2, 3))
    session.feed("G1 X5 F600\n")
    session.rest()
    assert session.step(10**6).x_mm[0] == 1
    session.feed("G1 X\n")
    session.step(10)
    assert session.status == "error" and session.diagnostics[-1].code == "SC1002"
    assert not session.feed("X0\n")
    session.go_on()
    session.feed("X0\n")
    session.end()
    session.step(10**6)
    assert session.status == "done" and list(session.position) == [0, 2, 3]


def test_hold_and_abort_end_on_the_path():
    session = softcnc.Session()
    session.feed("G1 X100 F6000\n")
    session.end()
    session.step(200)
    session.hold()
    held = session.step(2000)
    assert held.v_mm_s[-1] == 0 and 0 < held.x_mm[-1] < 100
    session.resume()
    session.step(100)
    session.abort()
    rest = session.step(10**6)
    assert session.status == "done" and rest.v_mm_s[-1] == 0 and rest.x_mm[-1] < 100


def test_a_simulated_session_has_the_columns_of_the_mill():
    session = softcnc.Session(simulated=True)
    session.feed("G1 X10 F600\n")
    session.end()
    rows = session.step(10**6, columns=["x_mm", "x_act_mm", "contour_um"])
    assert rows.columns == ("x_mm", "x_act_mm", "contour_um")
    assert 0 < np.max(rows.x_mm - rows.x_act_mm) < 1


def test_what_a_limit_raises_is_raised_by_the_step_and_ends_the_session():
    session = softcnc.Session(limit=lambda *point: [][0])
    session.feed("G1 X10 F600\n")
    session.end()
    with pytest.raises(IndexError):
        session.step(10)
    with pytest.raises(RuntimeError, match="this session has ended"):
        session.step(10)


def test_without_rows_arrays_are_empty():
    session = softcnc.Session()
    for rows in (0, 10):
        trace = session.step(rows)
        assert len(trace) == 0 and trace.x_mm.shape == (0,) and trace.limit.shape == (0,)
    session.feed("G1 X1 F600\nM0\nX0\n")
    session.end()
    assert len(session.step(10**6)) > 100 and session.status == "paused"
    assert len(session.step(10)) == 0
    session.resume()
    assert len(session.step(10**6)) > 100 and session.status == "done"
    assert len(session.step(10)) == 0 and session.step(1).position.shape == (0, 3)


def test_one_thread_at_a_time_uses_a_session():
    session = softcnc.Session()
    session.feed("o100 while [1]\nG1 X10 F6000\nX0\no100 endwhile\nM2\n")
    session.end()
    stepped = threading.Thread(target=lambda: session.step(3_000_000, ["t_s"]))
    stepped.start()
    refused = 0
    while stepped.is_alive():
        for use in (session.hold, session.resume, lambda: session.feed("X1\n"), lambda: session.status):
            try:
                use()
            except RuntimeError as error:
                assert "another thread uses this session" in str(error)
                refused += 1
    assert refused > 0 and session.status == "running"


def test_machines_are_values():
    machine = softcnc.Machine().set(axis__x__jerk_mm_s3=9000, control__period_ms=2)
    assert machine.period == 0.002 and machine != softcnc.Machine()
    assert machine.set(**{"control.period_ms": 1, "axis.x.jerk_mm_s3": 0}) == softcnc.Machine().set(
        axis__x__jerk_mm_s3=0
    )
    assert pickle.loads(pickle.dumps(machine)) == machine
    assert "2 ms" in repr(machine)
    assert softcnc.Machine.parse(machine.toml()) == machine


def test_what_is_returned_can_be_pickled_and_copied():
    with pytest.raises(softcnc.Error) as raised:
        softcnc.plan("G1 X F100\nM2\n")
    error = pickle.loads(pickle.dumps(raised.value))
    assert str(error) == str(raised.value) and error.diagnostics == raised.value.diagnostics
    assert softcnc.Error("x").diagnostics == []
    trace = softcnc.plan("G1 X1 F100\nM2\n")
    assert np.array_equal(pickle.loads(pickle.dumps(trace)).x_mm, trace.x_mm)
    assert np.array_equal(copy.deepcopy(trace).x_mm, trace.x_mm)
    curve = softcnc.Nurbs([[0, 0], [1, 1], [2, 0], [3, 1]], np.array([0, 0, 0, 0, 1, 1, 1, 1.0]))
    assert pickle.loads(pickle.dumps(curve)).length == curve.length


def test_a_curve_is_that_of_another_library():
    generator = np.random.default_rng(1)
    control = generator.normal(size=(9, 3))
    knots = [0, 0, 0, 0, 1, 2, 2.5, 4, 5, 6, 6, 6, 6]
    curve, spline = softcnc.Nurbs(control, knots), BSpline(knots, control, 3)
    u = np.linspace(0, 6, 201)
    assert np.allclose(curve.point(u), spline(u), atol=1e-12)
    assert np.allclose(curve.derivative(u[:-1]), spline.derivative()(u[:-1]), atol=1e-9)
    assert np.allclose(curve.derivative(u[:-1], 2), spline.derivative(2)(u[:-1]), atol=1e-8)
    speed = np.linalg.norm(spline.derivative()(np.linspace(0, 6, 600001)), axis=1)
    assert curve.length == pytest.approx(np.trapz(speed, dx=1e-5), rel=1e-8)
    assert np.allclose(curve.parameter(curve.arc_length(u)), u, atol=1e-9)
    with pytest.raises(softcnc.Error, match="SC30"):
        softcnc.Nurbs(control, knots[:-1])


def test_a_program_of_a_curve_runs_along_it():
    control = [[0, 0], [10, 20 + 1e-14], [30, 20], [40, -3e-16]]
    curve = softcnc.Nurbs(control, [0, 0, 0, 0, 1, 1, 1, 1], weights=[1, 2, 2, 1])
    trace = softcnc.plan(curve.g06_2(6000))
    block = next(one for one in softcnc.blocks(curve.g06_2(6000)) if one["kind"] == "nurbs")
    assert np.array_equal(softcnc.Nurbs.of_block(block).control, curve.control)
    assert np.allclose(trace.position, curve.point(curve.parameter(trace.s_mm)), atol=1e-9)


@pytest.mark.parametrize("method", ["taylor1", "taylor2"])
def test_a_method_of_ones_own_is_judged_as_compare_judges(method, command, root):
    """The rows are those of the built-in method, and so is what is measured of them."""
    program = root / "programs" / "08_butterfly.nc"
    block = next(one for one in softcnc.blocks(program) if one["kind"] == "nurbs")
    control = np.array(block["control"])
    curve = softcnc.Nurbs.of_block({**block, "control": control - control[0]})

    def step(curve, u, ds):
        first, second = curve.derivative(u)[0], curve.derivative(u, 2)[0]
        speed = np.linalg.norm(first)
        du = ds / speed
        if method == "taylor2":
            du -= ds**2 * first.dot(second) / (2 * speed**4)
        return u + du

    text = curve.g06_2(3000)
    far = softcnc.Nurbs.of_block(block)  # a rapid leads there
    assert softcnc.walk(far, softcnc.plan(far.g06_2(3000)), step).feed_fluctuation_max == (
        pytest.approx(softcnc.walk(curve, softcnc.plan(text), step).feed_fluctuation_max, rel=0.05)
    )
    names = ["x_mm", "y_mm", "chord_error_um", "feed_fluctuation"]
    theirs = softcnc.plan(text, columns=names, control__interpolation=method)
    ours = softcnc.walk(curve, softcnc.plan(text), step)
    rows = min(len(ours.u), len(theirs)) - 2
    assert np.allclose(ours.position[:rows, :2], theirs.position[:rows], atol=2e-5)
    assert ours.chord_error_um_max == pytest.approx(theirs.chord_error_um.max(), rel=0.01)
    assert ours.feed_fluctuation_max == pytest.approx(
        np.nanmax(np.abs(theirs.feed_fluctuation)), rel=1e-3
    )


def test_what_a_method_raises_is_raised():
    curve = softcnc.Nurbs([[0, 0], [1, 1], [2, 0], [3, 1]], [0, 0, 0, 0, 1, 1, 1, 1])
    with pytest.raises(KeyError):
        softcnc.walk(curve, softcnc.plan(curve.g06_2(600)), lambda curve, u, ds: {}[u])
    with pytest.raises(ValueError, match="the method returned nan"):
        softcnc.walk(curve, softcnc.plan(curve.g06_2(600)), lambda curve, u, ds: np.nan)
    with pytest.raises(ValueError, match="a plan of three rows"):
        softcnc.walk(curve, softcnc.plan(curve.g06_2(600), columns=["t_s"]), lambda *step: 0)


def test_numbers_that_are_none_are_refused():
    curve = softcnc.Nurbs([[0, 0], [1, 1], [2, 0], [3, 1]], [0, 0, 0, 0, 1, 1, 1, 1])
    for use in (curve.point, curve.arc_length, curve.derivative, curve.curvature):
        with pytest.raises(ValueError, match="must be finite"):
            use(np.nan)
    for feed in (np.nan, -5, 0):
        with pytest.raises(ValueError, match="the feed must be above 0"):
            curve.g06_2(feed)
