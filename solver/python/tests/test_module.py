"""The Python module: values are the command's, arrays broadcast, and what is wrong is a ValueError that says so."""

import inspect
import json
import os
import pathlib
import pickle
import pydoc
import threading
import time

import matplotlib.colors
import numpy
import pytest

import seiche

SHORT = {"markers": 64, "last_time": 0.5}
QUICKER = {"overturning_wave": SHORT, "pressure_forced_wave": {**SHORT, "markers": 192},
           "wall_load": {"markers": 128, "amplitude": 0.1}, "wall_runup": {"markers": 128, "amplitude": 0.1},
           "slope_runup": {"markers": 160, "amplitude": 0.1, "cotangent": 0}}


def test_every_solution_is_there_and_documented():
    assert {"riemann", "solitary", "stokes", "standing", "gerstner", "overturning_wave"} <= set(seiche.solutions)
    for name in seiche.solutions:
        assert "Parameters:" in getattr(seiche, name).__doc__
        assert seiche.exact(name, **QUICKER.get(name, {})).name == name


def test_arrays_come_back_in_the_shape_that_coordinates_broadcast_to():
    dam_break = seiche.riemann(left_depth=1, right_depth=0, gravity=9.81)
    values = dam_break(x=numpy.linspace(-5, 5, 11), t=1.0)
    assert values["h"].shape == (11,)
    assert values["h"][5] == pytest.approx(4 / 9, rel=1e-15)
    grid = dam_break(x=numpy.linspace(-1, 1, 4), t=numpy.array([[0.5], [1.0], [2.0]]))
    assert grid["u"].shape == (3, 4)
    assert dam_break(x=0.0, t=1.0)["u"].shape == ()


def test_the_solitary_wave_at_depth_and_on_the_surface():
    wave = seiche.solitary(amplitude=0.3, gravity=1)
    assert wave.scalars["speed"] == pytest.approx(1.13752301663104, rel=1e-14)
    inside = wave(x=numpy.array([0.0, 1.0]), y=-0.5)
    assert inside["u"] == pytest.approx([0.25121780819879, 0.21852316195712], abs=1e-14)
    assert wave(x=0.0)["u"] == pytest.approx(0.304481232945863, abs=1e-14)
    assert wave(x=0.0)["eta"] == pytest.approx(0.3, abs=1e-14)


def test_points_outside_the_fluid_are_errors_unless_nan_is_asked_for():
    wave = seiche.solitary(amplitude=0.3)
    with pytest.raises(ValueError, match="y"):
        wave(x=0.0, y=0.4)
    values = wave(x=0.0, y=numpy.array([0.2, 0.4]), outside="nan")
    assert numpy.isfinite(values["u"][0]) and numpy.isnan(values["u"][1])


def test_wrong_names_and_values_say_what_is_allowed():
    for call, words in [
        (lambda: seiche.exact("nothing"), "nothing"),
        (lambda: seiche.riemann(left_deth=1), "left_deth"),
        (lambda: seiche.riemann(left_depth=-1), "left_depth"),
        (lambda: seiche.riemann(left_depth=float("nan")), "left_depth"),
        (lambda: seiche.riemann()(x=0, z=1), "coordinate z"),
        (lambda: seiche.wavemaker(kind="plunger"), "piston"),
        (lambda: seiche.solitary()(x=0, outside="zero"), "outside"),
    ]:
        with pytest.raises(ValueError, match=words):
            call()


def test_a_curve_comes_back_as_arrays_along_it():
    profile = seiche.overturning_wave(**SHORT)(t=0.0)
    assert profile["x"].ndim == 1 and profile["x"].shape == profile["y"].shape


def test_solutions_test_themselves():
    for identity in seiche.riemann(right_depth=0.1).self_test():
        assert identity["defect"] <= identity["accuracy"], identity


def test_signatures_and_stubs_name_the_parameters():
    assert list(inspect.signature(seiche.solitary).parameters) == ["amplitude", "depth", "gravity"]
    assert inspect.signature(seiche.wavemaker).parameters["kind"].default == "piston"
    assert list(inspect.signature(seiche.exact).parameters) == ["name", "parameters"]
    assert list(inspect.signature(seiche.read_table).parameters) == ["path"]
    shown = pydoc.render_doc(seiche.exact, renderer=pydoc.plaintext)
    assert "exact(name: str, **parameters: float | str)" in shown and "seiche.solutions" in shown
    compile(seiche._stubs(), "seiche.pyi", "exec")
    assert pathlib.Path(seiche.__file__).with_name("py.typed").is_file() and seiche.__version__


def test_a_solution_is_pickled_by_its_parameters():
    wave = seiche.solitary(amplitude=0.2)
    assert pickle.loads(pickle.dumps(wave))(x=0.5)["eta"] == wave(x=0.5)["eta"]


def test_other_threads_run_while_points_are_computed():
    wave, points = seiche.solitary(amplitude=0.3), numpy.linspace(-5, 5, 20000)
    thread = threading.Thread(target=lambda: wave(x=points, y=-0.5))
    thread.start()
    turns = 0
    while thread.is_alive():
        turns += 1
        time.sleep(0.001)
    assert turns > 10


def filled(case):
    t = case.template("wall")["t"]
    command = ["exact", "standing", *seiche_words(case, "wall"), "--format", "json"]
    told = json.loads(seiche.scoring._run(*command))
    names = [column["name"] for column in told["columns"]]
    eta = numpy.array([row[names.index("eta")] for row in told["rows"]])
    return {"t": t, "eta": eta}


def seiche_words(case, table):
    template = seiche.scoring._run("score", case.name, "--template", "--table", table)
    line = next(line for line in template.splitlines() if "the reference: seiche exact standing" in line)
    return line.split("seiche exact standing ")[1].split()


@pytest.mark.skipif(not os.path.exists(os.environ.get("SEICHE", "")), reason="the command is not built")
def test_a_result_is_scored(tmp_path):
    case = seiche.case("standing_wave")
    assert case.name in seiche.cases()
    data = filled(case)
    result = case.score({"wall": data}, solver="mine", dx=0.1, out=tmp_path)
    assert result.passed and "claims met" in result._repr_html_() and result.notes == []
    assert seiche.read_record(next(tmp_path.glob("standing_wave*.json"))).passed
    result = case.score({"wall": {"t": data["t"], "elevation": 1.5 * data["eta"]}})
    assert not result.passed and any("taken for eta" in note for note in result.notes)
    verdicts = [claim["verdict"] for claim in result.claims]
    assert {"pass", "fail"} <= set(verdicts)
    assert f"standing_wave: {verdicts.count('pass')} of {len(verdicts)} claims met" in repr(result)
    drawn = [matplotlib.colors.to_hex(bar.get_facecolor()) for bar in result.plot().patches]
    told = [claim for claim in result.claims if claim["limit"] and claim["measured"] is not None]
    wanted = {"pass": "tab:green"}
    assert drawn == [matplotlib.colors.to_hex(wanted.get(claim["verdict"], "tab:red")) for claim in told]
    from seiche.testing import assert_score
    assert_score("standing_wave", {"wall": data})
    with pytest.raises(AssertionError, match="fail: "):
        assert_score("standing_wave", {"wall": {**data, "eta": 1.5 * data["eta"]}})
    higher = {"wall": {**data, "eta": 1.01 * data["eta"]}}
    kept = {"baseline": tmp_path / "baseline"}
    assert case.score({"wall": data}, bless=True, **kept).worse == []
    assert_score("standing_wave", {"wall": data}, **kept)
    with pytest.raises(AssertionError, match="WORSE"):
        assert_score("standing_wave", higher, **kept)
    with pytest.raises(ValueError, match="--dxx"):
        case.score({"wall": data}, dxx=0.1)
    span = (1e9 * data["t"]).astype("timedelta64[ns]")
    for t in (span, numpy.datetime64("2020-01-01", "ns") + span):
        assert case.score({"wall": {**data, "t": t}}).passed
    assert {"bathymetry.asc", "matsuyama_tanaka_2001_monai_valley/table.csv"} <= set(seiche.case("monai_valley").files)
    with pytest.raises(ValueError, match="did you mean monai_valley"):
        seiche.case("monai_valey")
    with pytest.raises(ValueError, match="must be as many"):
        case.score({"wall": {"t": data["t"], "eta": data["eta"][1:]}})
    with pytest.raises(ValueError, match="table walls: must be one of wall"):
        case.score({"walls": data})
    one = seiche.case("monai_valley").score({"runup": {"place": [1], "R": [0.0896]}}, uncertainty={"R": 0.001})
    assert [claim["verdict"] for claim in one.claims] == ["fail", "pass"]  # one of three, as measured


@pytest.mark.skipif(not os.path.exists(os.environ.get("SEICHE", "")), reason="the command is not built")
def test_units_of_xarray_count():
    xarray = pytest.importorskip("xarray")
    case = seiche.case("standing_wave")
    data = filled(case)
    wall = xarray.Dataset({"eta": ("t", 100 * data["eta"], {"units": "cm"})}, {"t": data["t"]})
    result = case.score(wall, table="wall")
    assert result.passed and any("cm became m" in note for note in result.notes)
