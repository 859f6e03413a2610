"""Surfaces, fronts and gauges that are read off snapshots, and what the command says of them."""

import os
import resource
import signal

import numpy
import pytest

from seiche import adapt
from seiche.readers import Snapshot
from test_readers import X, H, refused


@pytest.mark.parametrize("x,values,crossing", [
    ([0, 1, 2, 3], [1, 1, 0.2, 0], 1.5), ([3, 2, 1, 0], [0, 0.2, 1, 1], 1.5), ([0, 1, 2], [1, 1, 1], 2), ([0, 1], [0, 0], None),
    ([0, 1, 2], [0, 0.6, 0], 1), ([0, 1, 2, 4], [1, 0, 0.8, 0], 2.5), ([], [], None)])
def test_the_last_crossing_is_on_a_straight_line(x, values, crossing):
    found = adapt.last_crossing(numpy.array(x, float), numpy.array(values, float), 0.6)
    assert found == (None if crossing is None else pytest.approx(crossing))


def test_points_share_a_row_to_a_millionth_of_the_range():
    found = adapt.rows_of(numpy.array([1.0, 3, 1 + 0.9e-6, 2, 3 - 0.9e-6, 1 + 4e-6]))
    assert [sorted(map(int, row)) for row in found] == [[0, 2], [5], [3], [1, 4]]
    assert [len(row) for row in adapt.rows_of(numpy.array([5.0, 5, 5]))] == [3]
    assert adapt.rows_of(numpy.array([])) == []


def test_the_front_of_particles_has_four_others_within_twice_their_spacing():
    x, y = numpy.array([0, 0.1, 0.2, 0, 0.1, 0.2, 0.5]), numpy.array([0, 0, 0, 0.1, 0.1, 0.1, 0])
    assert adapt.front(Snapshot(0, x, y), None, None, 0.11) == 0.2
    assert adapt.front(Snapshot(0, x, y), None, None, 0.1) == 0.1      # strictly within
    assert adapt.front(Snapshot(0, x[:4], y[:4]), None, None, 0.3) is None
    refused("a front of particles needs --near", adapt.front, Snapshot(0, x, y), None, None, None)


def test_the_front_of_a_field_is_that_of_its_farthest_row():
    one = Snapshot(0, [0.0, 1, 0, 1], [0.0, 0, 1, 1], {"h": [1, 0, 1, 0.25]})
    assert adapt.front(one, "h", None, None) == pytest.approx(2 / 3)
    assert adapt.front(one, "h", 0.75, None) == pytest.approx(1 / 3)
    assert adapt.front(one, "h", 2, None) is None


def found(one, field=None, level=None):
    return [list(map(float, values)) for values in adapt.surface(one, field, level)]


def test_the_surface_of_points_of_a_field_and_of_columns():
    assert found(Snapshot(0, [2.0, 1, 1], [10.0, 4, 6])) == [[1, 2], [5, 10]]
    refused("needs --field: there are a, h", adapt.surface, Snapshot(0, X, None, {"h": H, "a": H}), None, None)
    refused("needs --field: there are none", adapt.surface, Snapshot(0, X), None, None)
    numpy.testing.assert_array_equal(found(Snapshot(0, [2.0, 1, 4], None, {"h": [0.5, -1e20, 3]}), "h"),
                                     [[1, 2, 4], [numpy.nan, 0.5, 3]])
    columns = {"x": [1.0, 1, 0, 0, 2, 2], "y": [0.0, 2, 0, 2, 0, 2]}
    one = Snapshot(0, **columns, fields={"h": [1, 0, 1, 0.25, 0, 0]})
    assert found(one, "h") == [[0, 1], [pytest.approx(4 / 3), 1]]
    assert found(one, "h", 0.75) == [[0, 1], [pytest.approx(2 / 3), 0.5]]
    for values in ([-0.5, 1, 1, 1, 1, 1], [0, 1.5, 1, 1, 1, 1]):
        one = Snapshot(0, **columns, fields={"h": values})
        refused("no share of water from 0 to 1", adapt.surface, one, "h", None)
        adapt.surface(one, "h", 0.5)


@pytest.mark.parametrize("text,place", [("x=2.5", (2.5, None)), ("x=2.5,y=0", (2.5, 0)), ("y=1,x=2", (2, 1)), ("y=1", None),
                                        ("x=1,y=a", None), ("x=1,z=2", None), ("x=1,y=2,z=3", None), ("x", None)])
def test_the_place_of_a_gauge(text, place):
    if place is None:
        refused("must be x=NUMBER", adapt.place_of, text)
    else:
        assert adapt.place_of(text) == place


def test_a_gauge_in_the_plan_lies_at_a_point_or_in_a_triangle():
    pytest.importorskip("scipy")
    x, y = (values.ravel() for values in numpy.meshgrid([0.0, 1, 2], [0.0, 2, 4]))
    one = Snapshot(0, x, y, {"h": 3 * x + 5 * y}, plan=True)
    assert adapt.in_plan(one, "h", 1, 2) == 13
    assert adapt.in_plan(one, "h", 0.25, 3.5) == pytest.approx(18.25)
    assert numpy.isnan(adapt.in_plan(one, "h", 2.5, 1)) and numpy.isnan(adapt.in_plan(one, "h", 1, -1e-6))
    assert adapt.in_plan(one, "h", 2 + 5e-9, 4 - 3e-9) == 26
    assert numpy.isnan(adapt.in_plan(one, "h", 2 + 7e-9, 4))
    refused("needs --field", adapt.in_plan, one, None, 1, 2)
    line = Snapshot(0, x[:3], y[:3], {"h": x[:3]}, plan=True)
    assert numpy.isnan(adapt.in_plan(line, "h", 0.5, 0)) and adapt.in_plan(line, "h", 1, 0) == 1


def printed(capsys, *words):
    adapt.main([*map(str, words)])
    rows = [line.split(",") for line in capsys.readouterr().out.splitlines()]
    return rows[0], [[float(word) for word in row] for row in rows[1:]]


def test_a_front_over_the_width_of_its_column(capsys, tmp_path):
    file = tmp_path / "a.csv"
    file.write_text("t,x,h\n3,0,0\n2,0,1\n2,4,0\n1,0,1\n1,2,0\n")
    words = ("front", file, "--field", "h")
    assert printed(capsys, *words) == (["t [s]", "x [m]"], [[1, 1], [2, 2]])
    assert printed(capsys, *words, "--level", 0.25)[1] == [[1, 1.5], [2, 3]]
    for more, unit in (((), (2 * 9.81 / 0.5) ** 0.5), (("--square",), (9.81 / 0.5) ** 0.5), (("--gravity", 4), 4)):
        names, rows = printed(capsys, *words, "--column", 0.5, *more)
        assert names == ["T [1]", "X [1]"] and rows == [pytest.approx([unit, 2], rel=1e-9),
                                                        pytest.approx([2 * unit, 4], rel=1e-9)]


def test_surfaces_and_gauges_have_their_columns(capsys, tmp_path):
    file = tmp_path / "a.csv"
    file.write_text("t,x,h\n1,0,5\n1,2,7\n2,0,8\n2,2,nan\n")
    words = (file, "--field", "h")
    assert printed(capsys, "surface", *words) == (["t [s]", "x [m]", "eta [m]"], [[1, 0, 5], [1, 2, 7], [2, 0, 8]])
    names, rows = printed(capsys, "gauge", *words, "--at", "x=0.5")
    assert names == ["x [m]", "t [s]", "eta [m]"]
    numpy.testing.assert_array_equal(rows, [[0.5, 1, 5.5], [0.5, 2, numpy.nan]])
    assert printed(capsys, "gauge", *words, "--at", "x=0", "--step", 3)[1] == [[0, 0, 5], [0, 3, 8]]
    file.write_text("t,x,y,h\n1,0,0,5\n1,2,1,7\n")
    assert printed(capsys, "gauge", *words, "--at", "x=2,y=1") == (["x [m]", "y [m]", "t [s]", "eta [m]"], [[2, 1, 1, 7]])


def test_what_was_not_found_is_said(capsys, tmp_path):
    file = tmp_path / "a.csv"
    file.write_text("t,x,y,h\n1,0,0,5\n1,2,1,7\n")
    for words, said in ((("gauge", file, "--field", "h"), "gauge needs --at x=NUMBER"),
                        (("gauge", file, "--field", "h", "--at", "x=9"),
                         "not known there: over a plan it is at x=NUMBER,y=NUMBER"),
                        (("gauge", file, "--field", "h", "--at", "x=9,y=9"), "not known there\n"),
                        (("front", file, "--field", "h", "--level", 9), "a.csv: no front was found: is --level met?"),
                        (("series", file, file), "series needs one file")):
        with pytest.raises(SystemExit) as ended:
            adapt.main([*map(str, words)])
        told = capsys.readouterr()
        assert (ended.value.code, told.out) == (2, "") and told.err.startswith("seiche.adapt: ") and said in told.err


def test_work_apart_tells_what_it_did_and_how_it_ended(capfd):
    def ends(signal_):
        os.kill(os.getpid(), signal_)

    def fails():
        raise MemoryError
    assert adapt.apart(lambda: "done" if [os.write(chatter, b"noise") for chatter in (1, 2)] else "") == (0, "done")
    assert tuple(capfd.readouterr()) == ("", "")
    assert adapt.apart(fails) == (2, "MemoryError")
    status, told = adapt.apart(lambda: ends(signal.SIGKILL))
    assert status == -signal.SIGKILL and f"signal {signal.SIGKILL}" in told
    limits = [(resource.RLIMIT_AS, adapt.MOST_MEMORY), (resource.RLIMIT_CPU, adapt.MOST_SECONDS)]
    # No more than is allowed here already.
    least = [most if (here := resource.getrlimit(what)[1]) == resource.RLIM_INFINITY else min(most, here)
             for what, most in limits]
    told = adapt.apart(lambda: repr([resource.getrlimit(what) for what, _ in limits]))[1]
    assert told == repr([(most, most) for most in least])
    assert limits[0][1] == 16 * 2**30 and limits[1][1] == 600
