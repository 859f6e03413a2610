"""The Python module: values are the command's, arrays broadcast, and what is wrong is a ValueError that says so."""

import inspect
import json
import os
import pathlib
import pickle
import pydoc
import re
import sys
import threading
import time
import types

import matplotlib.colors
import numpy
import pytest

import seiche
from seiche.testing import assert_score, seiche_score  # noqa: F401  (the fixture)

SHORT = {"markers": 64, "last_time": 0.5}
QUICKER = {"overturning_wave": SHORT, "pressure_forced_wave": {**SHORT, "markers": 192},
           "wall_load": {"markers": 128, "amplitude": 0.1}, "wall_runup": {"markers": 128, "amplitude": 0.1},
           "slope_runup": {"markers": 160, "amplitude": 0.1, "cotangent": 0}}


def test_every_solution_is_there_and_documented():
    assert {"riemann", "solitary", "stokes", "standing", "gerstner", "overturning_wave"} <= set(seiche.solutions)
    for name in seiche.solutions:
        assert "Parameters:" in getattr(seiche, name).__doc__


@pytest.mark.skipif(not os.path.exists(os.environ.get("SEICHE", "")), reason="the command is not built")
@pytest.mark.parametrize("name", [name for name in seiche.solutions if name not in ("wall_load", "wall_runup",
                                                                                    "slope_runup")])  # seconds
def test_a_solution_is_the_command_s_output_by_output(name):
    parameters = QUICKER.get(name, {})
    inputs = re.findall(r"^  (\w+) \[", getattr(seiche, name).__doc__.split("Coordinates:")[1].split("Outputs:")[0], re.M)
    at = {one: 0.0625 * (k + 1) for k, one in enumerate(inputs)}
    words = ["--at", ",".join(f"{one}={value}" for one, value in at.items())] if inputs else []
    command = ["exact", name, *seiche.scoring._settings(parameters), *words, "--format", "json"]
    try:
        said = json.loads(seiche.scoring._run(*command, "--integrals"))
    except ValueError as outside:
        with pytest.raises(ValueError) as ours:
            seiche.exact(name, **parameters)(**at)
        assert str(ours.value) in str(outside)
        return
    one = seiche.exact(name, **parameters)
    assert (one.name, one.citation, one.uncertainty) == (name, said["citation"], said["uncertainty"])
    numpy.testing.assert_equal(one.scalars, {key: numpy.nan if value is None else value for key,
                                             value in said.get("scalars", {}).items()})
    assert {key: said["parameters"][key] for key in one.parameters if isinstance(said["parameters"][key], float)} == {
        key: value for key, value in one.parameters.items() if isinstance(said["parameters"][key], float)}
    assert repr(one) == f"seiche.{name}({', '.join(f'{key}={value:g}' for key, value in sorted(one.parameters.items()))})"
    columns = [column["name"] for column in said.get("columns", ())]
    rows = numpy.array(said.get("rows", ()), float).reshape(-1, len(columns))
    for key, values in one(**at).items():
        numpy.testing.assert_array_equal(numpy.atleast_1d(values), rows[:, columns.index(key)], err_msg=key)


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


RECORD = {"case": "a <b>", "measurements": {"speed": 2.5}, "claims": [
    {"id": name, "verdict": verdict, "text": f"text of {name}", "measured": measured, "expected": expected, "unit": unit,
     "criterion": {"limit": limit}, "as_declared": declared}
    for name, verdict, measured, expected, unit, limit, declared in (
        ("one", "pass", 1.5, 1.0, "m", 2.0, True), ("two", "fail", 4.0, 1.0, "s", 2.0, False),
        ("three", "pass", 0.25, 1.0, "", 3.0, True),
        ("seen", "pass", 1.0, 1.0, "1", None, True), ("exact", "pass", 0.0, 0.0, "1", 0.0, True),
        ("gone", "error", None, 1.0, "1", 1.0, True))]}


def test_a_result_shows_each_claim_in_its_columns():
    result = seiche.Result(RECORD, ["a note"], ["one: WORSE than before", "two: better"])
    assert (result.notes, result.worse, result.measurements) == (["a note"], ["one: WORSE than before"], {"speed": 2.5})
    assert result.claims[0] == {"id": "one", "verdict": "pass", "text": "text of one", "measured": 1.5, "expected": 1.0,
                                "limit": 2.0,
                                "unit": "m"}
    assert not result.passed and seiche.Result({**RECORD, "claims": RECORD["claims"][:1]}).passed
    assert repr(result) == "<seiche.Result a <b>: 4 of 6 claims met>"
    shown = result._repr_html_()
    assert shown.startswith("<p>&lt;seiche.Result a &lt;b&gt;: 4 of 6 claims met&gt;</p><table><tr><th>verdict</th><th>text</th>"
                            "<th>measured</th><th>expected</th><th>limit</th><th>unit</th></tr>"
                            "<tr><td>pass</td><td>text of one</td><td>1.5</td><td>1</td><td>2</td><td>m</td></tr>")
    assert shown.count("<tr>") == 7 and "<td>None</td>" in shown
    axes = result.plot()
    told = {label.get_text(): bar.get_width() for label, bar in zip(axes.get_yticklabels(), axes.patches)}
    assert told == {"one": 0.25, "two": 1.5, "three": 0.25} and axes.get_xlabel() == "error over its limit"
    assert list(axes.lines[0].get_xdata()) == [1, 1] and axes.figure.get_size_inches()[1] == pytest.approx(0.4 * 6 + 1)
    assert result.plot(axes) is axes


def test_claims_become_a_table_of_pandas(monkeypatch):
    monkeypatch.setitem(sys.modules, "pandas", types.SimpleNamespace(DataFrame=lambda rows: ("frame", type(rows), rows)))
    claims = seiche.Result(RECORD).claims
    assert claims.to_pandas() == ("frame", list, list(claims))


@pytest.fixture
def told(monkeypatch):
    """The words that the command would be given, for a case of two tables."""
    about = {"name": "waves", "title": "Waves", "scores": True, "tables": {
        "wall": {"files": ["/data/a/table.csv", "/data/a/bed.asc"]}, "gauges": {"files": ["/data/b/table.csv"]}}}
    listed = {"waves": about, "quiet": {**about, "name": "quiet", "scores": False}}
    monkeypatch.setattr(seiche.scoring, "_listed", lambda: listed)
    calls = []

    def run(*words, allowed=(0,)):
        files = {pathlib.Path(word).name: pathlib.Path(word).read_text() for word in words if str(word).endswith(".csv")}
        calls.append((list(map(str, words)), files, allowed))
        if "--template" in words:
            return "# seiche\nx [m],t [s],eta [m]\n1,2,\n3,4,\n" if "wall" in words else "# seiche\nt [s],h [m]\n"
        return json.dumps({"record": RECORD, "notes": ["n"], "baseline": ["WORSE"]})
    monkeypatch.setattr(seiche.scoring, "_run", run)
    return calls


def test_a_case_has_templates_files_and_a_name(told):
    case = seiche.case("waves", depth=2, kind="piston")
    assert (repr(case), seiche.cases()) == ("<seiche.Case waves: Waves>", ["waves"])
    assert {name: str(file) for name, file in case.files.items()} == {
        "a/table.csv": "/data/a/table.csv", "bed.asc": "/data/a/bed.asc", "b/table.csv": "/data/b/table.csv"}
    both = case.template()
    assert told[0][0] == ["score", "waves", "--template", "--table", "wall", "--set", "depth=2", "--set", "kind=piston"]
    assert {table: {name: list(values) for name, values in columns.items() if name != "eta"} for table,
            columns in both.items()} == {
        "wall": {"x": [1, 3], "t": [2, 4]}, "gauges": {"t": [pytest.approx(numpy.nan, nan_ok=True)],
                                                       "h": [pytest.approx(numpy.nan, nan_ok=True)]}}
    assert numpy.isnan(both["wall"]["eta"]).all() and list(case.template("wall")) == ["x", "t", "eta"]


def test_options_of_a_score_are_words_of_the_command(told, tmp_path):
    case, table = seiche.case("waves"), {"t": [1.0, 2], "h": [0.1, 3]}
    result = case.score({"wall": table, "gauges": {"t": [5.0], "h": [7.0]}})
    words, files, allowed = told[-1]
    assert files == {"wall.csv": "t,h\n1,0.10000000000000001\n2,3\n", "gauges.csv": "t,h\n5,7\n"} and allowed == (0, 1)
    data = [word for before, word in zip(words, words[1:]) if before == "--data"]
    assert [pathlib.Path(word).name for word in data] == ["gauges.csv", "wall.csv"]
    assert words[:2] == ["score", "waves"] and words[6:-1] == ["--solver", "mine", "--json", "--out"]
    assert pathlib.Path(words[-1]).name == "results" and (result.notes, result.worse) == (["n"], ["WORSE"])
    case.score({"gauges": table}, solver="theirs", dx=0.1, seconds=0, uncertainty={"h": "1%"}, out=tmp_path, bless=True,
               plain=False, absent=None,
               gauges="WG1=6")
    assert told[-1][0][4:] == ["--table", "gauges", "--uncertainty", "h=1%", "--dx=0.1", "--seconds=0", "--bless",
                               "--gauges=WG1=6",
                               "--solver", "theirs", "--json", "--out", str(tmp_path)]
    file = tmp_path / "mine.csv"
    file.write_text("as it is")
    for data in (file, str(file)):
        case.score(data)
        assert told[-1][:2] == (["score", "waves", "--data", str(file), *told[-1][0][4:]], {"mine.csv": "as it is"})
        assert "--table" not in told[-1][0]
    case.score(table)
    assert told[-1][1] == {"table.csv": "t,h\n1,0.10000000000000001\n2,3\n"}
    frame = types.SimpleNamespace(reset_index=lambda: table)
    array = types.SimpleNamespace(to_dataframe=lambda: frame, keys=lambda: {"wall"}, variables={
        "t": types.SimpleNamespace(attrs={}), "h": types.SimpleNamespace(attrs={"units": "cm"})})
    case.score(array)
    assert told[-1][1] == {"table.csv": "t,h [cm]\n1,0.10000000000000001\n2,3\n"}
    with pytest.raises(ValueError, match="table h: columns of 1, 2 values, must be as many|table wall: columns of 1, 2 values"):
        case.score({"wall": {"t": [1.0], "h": [1.0, 2]}})
    with pytest.raises(ValueError, match="table walls: must be one of wall, gauges"):
        case.score({"walls": table, "wall": table})


@pytest.mark.parametrize("values,seconds", [
    (numpy.array(["2020-01-02", "2020-01-03"], "M8[D]"), [0, 86400]), (numpy.array([1500, 2500], "m8[ms]"), [1.5, 2.5]),
    ([1, 2], [1, 2])])
def test_times_are_seconds(values, seconds):
    assert list(seiche.scoring._numbers(values)) == seconds


def test_cases_are_run_into_a_folder(told, tmp_path):
    for tier, names in (("quick", ("a", "b")), ("full", ("a@full", "b@full"))):
        for k, name in enumerate(names):
            (tmp_path / f"{name}.json").write_text(json.dumps({**RECORD, "case": f"{name} {k}"}))
        results = seiche.run("a", "b", out=tmp_path, depth=2, **({} if tier == "quick" else {"tier": tier}))
        assert [result.record["case"] for result in results] == [f"{name} {k}" for k, name in enumerate(names)]
        assert told[-1][0] == ["run", "a", "b", "--tier", tier, "--out", str(tmp_path), "--set",
                               "depth=2"] and told[-1][2] == (0, 1)


def test_a_failed_assertion_says_claim_by_claim_what_is_not_met(told, tmp_path, monkeypatch):
    table = {"wall": {"t": [1.0]}}
    with pytest.raises(AssertionError, match="^WORSE$"):
        assert_score("waves", table, parameters={"depth": 3}, out=tmp_path)
    assert told[-1][0][6:8] == ["--set", "depth=3"] and told[-1][0][-1] == str(tmp_path)
    run = seiche.scoring._run
    monkeypatch.setattr(seiche.scoring, "_run", lambda *words, **options: run(*words, **options).replace("WORSE", "better"))
    with pytest.raises(AssertionError) as failed:
        assert_score("waves", table)
    assert str(failed.value) == ("<seiche.Result a <b>: 4 of 6 claims met>\nfail: text of two (two: 4.0, must be within 2.0 of 1.0 s)\n"
                                 "error: text of gone (gone: None, must be within 1.0 of 1.0 1)")
    assert assert_score("waves", table, baseline=tmp_path).record == RECORD


def test_the_fixture_keeps_its_record_in_the_folder_of_the_test(told, seiche_score, tmp_path):
    with pytest.raises(AssertionError, match="^WORSE$"):
        seiche_score("waves", {"wall": {"t": [1.0]}}, parameters={"depth": 3})
    assert told[-1][0][6:8] == ["--set", "depth=3"] and told[-1][0][-1] == str(tmp_path / "seiche")


def test_the_command_is_found_by_variable_path_or_build_tree(monkeypatch, tmp_path):
    command = tmp_path / "seiche"
    monkeypatch.setenv("SEICHE", "/named")
    assert seiche.scoring._command() == "/named"
    monkeypatch.delenv("SEICHE")
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr(seiche.scoring, "__file__", str(tmp_path / "tree/python/seiche/scoring.py"))
    with pytest.raises(FileNotFoundError, match="the command 'seiche' is not on the PATH"):
        seiche.scoring._command()
    (tmp_path / "tree").mkdir()
    (tmp_path / "tree/seiche").touch()
    assert seiche.scoring._command() == str(tmp_path / "tree/seiche")
    command.write_text('#!/bin/sh\necho "said $1"\necho "$2" >&2\nexit ${3:-0}\n')
    command.chmod(0o755)
    assert (seiche.scoring._command(), seiche.scoring._run("a", "")) == (str(command), "said a\n")
    assert seiche.scoring._run("a", "", 1, allowed=(0, 1)) == "said a\n"
    for words, said in ((("a", "wrong", 2), "^wrong$"), (("a", "", 3), "^seiche a: ended with status 3$")):
        with pytest.raises(ValueError, match=said):
            seiche.scoring._run(*words)


def test_stubs_have_a_line_for_every_solution_with_its_defaults():
    lines = seiche._stubs().splitlines()
    assert len(lines) == 8 + len(seiche.solutions) and set(seiche.solutions) <= set(seiche.__all__)
    assert "def solitary(*, amplitude: float = 0.3, depth: float = 1.0, gravity: float = 9.81) -> Solution: ..." in lines
    for name in seiche.solutions:
        (line,) = [line for line in lines if line.startswith(f"def {name}(")]
        described, signature = seiche._seiche.describe(name), inspect.signature(getattr(seiche, name))
        assert {p.name: p.default for p in signature.parameters.values()} == described["defaults"]
        assert all(p.kind == p.KEYWORD_ONLY and p.annotation is type(p.default) for p in signature.parameters.values())
        for parameter, default in described["defaults"].items():
            shown = 'float("inf")' if default == numpy.inf else repr(default)
            assert f"{parameter}: {type(default).__name__} = {shown}" in line
        assert signature.return_annotation is seiche.Solution and getattr(seiche, name).__doc__ == described["doc"]
