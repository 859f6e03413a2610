"""Every option of the command: what it rejects, in which words, what it is without being given, and what it changes."""

import functools
import json
import os
import re
import unittest

from submitting import SOURCE, Scoring, messages_of, printed, rows_of, seiche

# What another test tries row by row.
TRIED_ELSEWHERE = {"exact_inputs.cpp": "test_exact_inputs.py"}

# {wave}: the exact elevation of a standing wave at the wall; {empty}: a folder; {text}: no result.
WALL = "score standing_wave --table wall --data {wave}"
REJECTED = [
    ("run riemann --set particles", "--set particles: 'particles' must be name=value"),
    ("run riemann --set =3", "'=3' must be name=value"),
    ("run riemann --config {empty}", "cannot be read as a file"),
    ("run rieman", "unknown case 'rieman': did you mean riemann?"),
    ("run zz*", "run: no further case is called zz*"),
    ("run", "name a case, or a tier with --tier"),
    ("run riemann --tier huge", "--tier huge is unknown: must be one of quick, full, paper"),
    ("run riemann dry_dam_break --as bzz-fig-6", "run --as: name exactly one case"),
    ("run dry_dam_break --as bzz-fig-6 --config {text}", "run: --as and --config: leave one of the two out"),
    ("run dry_dam_break --as bzz-fig-6 --tier full", "set bzz-fig-6 belongs to the level quick, not --tier full"),
    ("run dry_dam_break --as bzz-fig-6 --set particles=20", "--set changes the as-published set bzz-fig-6"),
    ("run riemann --jobs 0", "--jobs: Value 0 not in range 1 to 1024"),
    ("run riemann --jobs 1025", "--jobs: Value 1025 not in range"),
    ("run riemann --threads 0", "--threads: Value 0 not in range 1 to 1024"),
    ("run riemann --threads 1025", "--threads: Value 1025 not in range"),
    ("run riemann --checkpoint-every -1", "--checkpoint-every: Value -1 not in range 0 to 86400"),
    ("run riemann --checkpoint-every 86401", "--checkpoint-every: Value 86401 not in range"),
    ("run riemann --most-seconds 0", "--most-seconds: Value 0 not in range 1 to 100000000"),
    ("run riemann --most-seconds 100000001", "--most-seconds: Value 100000001 not in range"),
    ("list --tier full", "list: --tier and --set belong to --claims CASE"),
    ("list --set particles=5", "list: --tier and --set belong to --claims CASE"),
    ("list --scores --json", "list: --json lists everything: leave out --scores or --published"),
    ("list --published --json", "list: --json lists everything: leave out --scores or --published"),
    ("list --claims rieman", "unknown case 'rieman'"),
    ("list --claims riemann --tier huge", "--tier huge is unknown"),
    ("list --claims riemann --set particles=0", "riemann: parameter particles = 0 is not allowed"),
    ("report {empty}", "must be a folder with records, as 'seiche run' and 'seiche score' write them"),
    ("report {empty} --jobs 0", "--jobs: Value 0 not in range 1 to 1024"),
    ("report {empty} --jobs 1025", "--jobs: Value 1025 not in range"),
    ("compare {empty}", "compare: folder {empty} holds no record"),
    ("compare {text}", "{text} is not a folder"),
    ("compare {empty} --tier full", "--tier requires --record"),
    ("compare {empty} --whole", "--whole requires --record"),
    ("compare {empty} --record {none}", "compare --record: no baseline {none}"),
    ("compare {empty} --record", "{empty} holds no record of tier quick"),
    ("compare {empty} --factor 0.99", "factor = 0.99 is out of range: must be in [1, 1e6]"),
    ("compare {empty} --factor 1000001", "factor = 1000001 is out of range"),
    ("record {empty} --tier full", "folder {empty} holds no record of tier full"),
    ("record {empty} --tier huge", "--tier huge is unknown"),
    ("fly", "unknown command 'fly'"),
    ("exact riemann --at z=0,t=0", "riemann has no coordinate z: it has x, t"),
    ("exact riemann --at x,t=0", "--at x,t=0: 'x' must be name=value"),
    ("exact riemann --at x=inf,t=0", "x = inf must be finite"),
    ("exact riemann --at x=a,t=0", "x = a is not a number"),
    ("exact riemann --at x=0:1:3,t=0", "--at x=0:1:3,t=0: must be single numbers; ranges are for --grid"),
    ("exact riemann --at x=0", "--at x=0: t is missing: riemann changes in time"),
    ("exact riemann --grid x=0:1:3", "--grid x=0:1:3: t is missing"),
    ("exact riemann --grid x=0:1,t=0", "x=0:1: must be x=FROM:TO:COUNT"),
    ("exact riemann --grid x=0:1:1,t=0", "COUNT = 1 must be an integer in [2, 1e7]"),
    ("exact riemann --grid x=0:1:2.5,t=0", "COUNT = 2.5 must be an integer in [2, 1e7]"),
    ("exact riemann --grid x=0:1:10000001,t=0", "COUNT = 10000001 must be an integer in [2, 1e7]"),
    ("exact riemann --grid x=0:1:4000,t=0:1:3000", "1.2e+07 points, must be at most 1e7"),
    ("exact riemann --set left_depth --at x=0,t=0", "--set left_depth: 'left_depth' must be name=value"),
    ("exact wall_runup --at x=0", "wall_runup has no coordinates, and no x"),
    ("exact wavemaker --set kind=plunger", "kind = plunger is unknown: must be one of piston, flap"),
    ("exact solitary --format excel --at x=0,t=0", "--format: excel not in {{csv,json,hdf5}}"),
    ("exact solitary --write excel", "--write: excel not in {{openfoam,dualsphysics,geoclaw,vtk,csv}}"),
    ("exact solitary --write geoclaw --up x", "--up: x not in {{y,z}}"),
    ("exact solitary --write geoclaw --origin 1", "--origin: At least 2 required but received 1"),
    ("exact solitary --write geoclaw --origin 1,2,3", "--origin: At Most 2 required but received 3"),
    ("exact solitary --write geoclaw --width 0", "--width: 0: must be a positive number [m]"),
    ("exact solitary --write geoclaw --width 3s", "--width: 3s: must be a positive number [m]"),
    ("score riemann --data {none}", "{none}"),
    ("score riemann", "score: --data FILE is missing (or --template)"),
    ("score shock_formation --template", "score: case shock_formation does not score others"),
    ("score thacker --template", "case thacker takes several tables: add --table with one of shorelines, gauges"),
    ("score thacker --template --table wall", "--table wall: must be one of shorelines, gauges"),
    ("score standing_wave --data {wave} --table gauge", "--table gauge: must be one of "),
    (WALL + " --solver seiche", "--solver seiche: must be letters, digits, '-' and '_', and not seiche"),
    (WALL + " --solver a.b", "--solver a.b: must be letters"),
    (WALL + " --format excel", "--format excel: must be auto or one of csv, hdf5, delimited"),
    (WALL + " --map eta", "--map eta: 'eta' must be name=value"),
    (WALL + " --map height=H", "--map: case standing_wave has no quantity H: must be one of "),
    (WALL + " --map a=eta,b=eta", "--map: quantity eta is given twice"),
    (WALL + " --uncertainty H=1", "--uncertainty: case standing_wave has no quantity H: must be one of "),
    (WALL + " --uncertainty volume=1", "--uncertainty: case standing_wave has no quantity volume"),
    (WALL + " --uncertainty eta=-1", "uncertainty eta = -1: must be a number at least 0, or a percentage"),
    (WALL + " --dx 0", "--dx: 0: must be a positive number [m]"),
    (WALL + " --dx -1m", "--dx: -1m: must be a positive number [m]"),
    (WALL + " --seconds 0", "--seconds: 0: must be a positive number [s]"),
    (WALL + " --seconds 2m", "--seconds: 2m: must be a positive number [s]"),
    (WALL + " --seconds 1,2", "--seconds 1,2: must be one number, or one for each of the 0 --sizes"),
    (WALL + " --threads 0", "--threads: Value 0 not in range 1 to 100000000"),
    (WALL + " --repeats 1", "--repeats: Value 1 not in range 2 to 1000"),
    (WALL + " --repeats 2", "--data: got 1 files for 2 repeats; give the same number for each run"),
    (WALL + " --repeats 2 --sizes 1,2,4 --data {wave} --data {wave}", "--repeats and --sizes: leave one of the two out"),
    (WALL + " --sizes 1,2,4 --dx 1", "--dx: --sizes say how large the cells are"),
    (WALL + " --sizes 1,2,4", "--data: got 1 files for 3 cell sizes; give the same number for each size"),
    (WALL + " --sizes 1,0,4", "--sizes: 0: must be a positive number [m]"),
    (WALL + " --sizes 1,2,4 --seconds 1,2", "--seconds 1,2: must be one number, or one for each of the 3 --sizes"),
    (WALL + " --bless", "--bless requires --baseline"),
    (WALL + " --baseline {out}", "--baseline {out}: is --out, must be another folder"),
    (WALL + " --baseline {empty}", "--baseline {empty}: has no standing_wave.yours.json: --bless makes this score the baseline"),
    ("score standing_wave --data {history}", "contains only a volume, energy or momentum history"),
]

# Numbers and words that help shows: those of the options that were not given.
DEFAULTS = {"exact": {"--format": "csv", "--up": "z", "--width": "1"},
            "score": {"--format": "auto", "--solver": "yours", "--out": "evidence"},
            "compare": {"--factor": "1.2", "--tier": "quick"}, "record": {"DIR": "evidence", "--tier": "quick"},
            "report": {"DIR": "evidence"}, "run": {"--out": "evidence"}}


@functools.cache
def wave():
    """The standing wave's elevation at the wall, by theory."""
    template = printed("score", "standing_wave", "--template", "--table", "wall")
    command = next(line.split("the reference: seiche ")[1] for line in template.splitlines() if "the reference" in line)
    names, rows = rows_of(printed(*command.split()))
    t, eta = (next(k for k, name in enumerate(names) if name.split(" ")[0] == one) for one in ("t", "eta"))
    return "t,eta\n" + "".join(f"{row[t]},{row[eta]}\n" for row in rows)


class Options(Scoring):
    def setUp(self):
        super().setUp()
        self.places = {"wave": self.write(wave(), "wave.csv"), "empty": self.folder / "empty", "none": self.folder / "none",
                       "text": self.write("no = 1\n", "text.toml"), "out": self.out,
                       "history": self.write("t,volume\n0,1\n1,1\n", "history.csv")}
        self.places["empty"].mkdir()

    def run_here(self, words):
        command, *rest = (word.format(**self.places) for word in words.split())
        out = ("--out", self.out) if command in ("run", "score", "report", "exact", "record") else ()
        return seiche(command, *rest, *out, cwd=self.folder)

    def test_what_is_rejected_and_in_which_words(self):
        said = []
        before = sorted(self.folder.rglob("*"))
        for words, message in REJECTED:
            with self.subTest(words):
                result = self.run_here(words)
                self.refused(result, message.format(**self.places))
                said.append(result.stderr)
        self.assertEqual(sorted(self.folder.rglob("*")), before, "something was written")
        for file in sorted((SOURCE / "validation/command").glob("*.cpp")):
            if file.name not in TRIED_ELSEWHERE:
                self.every_message_tried(file, said)

    def test_defaults_are_those_that_help_shows(self):
        for command, defaults in DEFAULTS.items():
            shown = re.findall(r"^  (--[a-z]+|[A-Z]+) [A-Z]+[^ =]*=(\S+)", seiche(command, "--help").stdout, re.MULTILINE)
            self.assertEqual(dict(shown), defaults, command)

    def test_what_is_not_said_is_not_recorded(self):
        self.assertEqual(self.run_here(WALL).returncode, 0)
        record = self.record("standing_wave.yours")
        self.assertEqual({"cell_size", "threads", "repeats"} & set(record["measurements"]), set())
        self.assertEqual(record["wall_time"], 0)
        for words, wanted in (("--dx 25cm --seconds 3 --threads 7", {"cell_size": 0.25, "threads": 7, "wall_time": 3}),
                              ("--dx 2 --seconds 1min", {"cell_size": 2, "wall_time": 60})):
            self.assertEqual(self.run_here(f"{WALL} {words}").returncode, 0)
            record = self.record("standing_wave.yours")
            self.assertEqual({key: {**record["measurements"], **record}[key] for key in wanted}, wanted)

    def test_a_claim_is_listed_as_it_is_recorded(self):
        def amount(claim, name):
            """An amount that is stated, or that the run tells below a cap."""
            value, cap = {**claim, **claim["criterion"]}[name], claim["criterion"].get("caps", {}).get(name)
            if name == "limit" and claim["criterion"].get("relative"):
                value /= abs(claim["expected"])
            number = re.escape(f"{value:g}")
            return number if cap is None else rf"({number} \(at most {cap:g}\)|at most {cap:g} \(set by the run\))"

        def criterion(claim):
            own = claim["criterion"]
            return {"roundoff": lambda: "{} within round-off of {} operations on numbers of size {}".format(
                        *(amount(claim, name) for name in ("expected", "operations", "scale"))),
                    "order": lambda: rf"order {own['theory']:g} \+- {own['tolerance']:g}",
                    "bound": lambda: f"{amount(claim, 'expected')} within {amount(claim, 'limit')}"
                                     + (", relative" if own["relative"] else ""),
                    "uncertainty": lambda: "{} within {:g} u, u_data = {}, u_input = {}, at most {:g}".format(
                        amount(claim, "expected"), own["coverage"], amount(claim, "data"), amount(claim, "input"), own["useful"]),
                    "qualitative": lambda: rf"(not )?seen \({re.escape(own['detector'])}\)"}[own["kind"]]()

        kinds = set()
        for case in ("bore_reflection", "dry_dam_break", "shock_formation", "stationary_jump", "wall_run_up_mesh"):
            self.assertEqual(seiche("run", case, "--out", self.out).returncode, 0)
            record = self.record(case)
            made = {claim["id"]: claim for claim in record["claims"]}
            listed = json.loads(seiche("list", case, "--json").stdout)
            self.assertEqual({claim["id"]: claim["left_out"] for claim in listed if claim["left_out"]},
                             {left["id"]: left["reason"] for left in record["left_out"]})
            self.assertEqual({claim["id"] for claim in listed if not claim["left_out"]}, set(made))
            text = seiche("list", "--claims", case).stdout
            for claim in listed:
                self.assertIn(f"{claim['id']}\n  {claim['text']}\n  {claim['quantity']} [{claim['unit']}]: {claim['criterion']}\n"
                              f"  because {claim['reason']}\n", text)
                if claim["left_out"]:
                    self.assertIn(f"  does not apply: {claim['left_out']}\n", text)
                    continue
                own = made[claim["id"]]
                kinds.add(own["criterion"]["kind"])
                with self.subTest(case=case, claim=claim["id"]):
                    self.assertRegex(claim["criterion"], f"^{criterion(own)}$")
                    self.assertEqual((claim["quantity"], claim["unit"], claim["reason"], claim["fails"]),
                                     (own["quantity"], own["unit"], own["criterion"]["reason"], own["declared_reason"]))
                    if own["declared_band"]:
                        value, width = own["declared_band"]
                        self.assertIn(f"  declared to fail at {value:g} +- {width:g}: {claim['fails']}\n", text)
        self.assertEqual(kinds, {"roundoff", "order", "bound", "uncertainty", "qualitative"})
        self.assertNotEqual(seiche("list", "--claims", case, "--tier", "full").stdout, text)

    def test_parameters_are_printed_with_what_they_mean(self):
        cases = {case["name"]: case for case in json.loads(seiche("list", "--json").stdout)["cases"]}
        printed = seiche("run", "riemann", "moving_bore", "--help-parameters", "--out", self.out).stdout
        self.assertFalse(self.out.exists())
        expected = ""
        for name in ("riemann", "moving_bore"):
            case = cases[name]
            expected += f"{name}: {case['title']}\n{case['source']}\n\n"
            for one in case["parameters"]:
                standard = one["default"]["quick"]
                shown = str(standard).lower() if isinstance(standard, bool) else f"{standard}".removesuffix(".0")
                expected += f"  {one['name']:<18} {one['meaning']} [{one['unit']}]\n  {'':<18} default {shown}; {one['range']}\n"
        self.assertEqual(printed, expected)

    def test_tests_of_ctest_run_every_case_as_it_is_declared(self):
        cases = json.loads(seiche("list", "--json").stdout)["cases"]
        for words, more in (((), ""), (("--most-seconds", 9), " --most-seconds 9")):
            file = self.folder / "tests.cmake"
            self.assertEqual(seiche("list", "--ctest", file, "--evidence", self.out, *words).returncode, 0)
            text = file.read_text()
            runs = re.findall(r"run (\w+) --(?:tier|as) (\S+) --jobs 1 --threads 1(.*) --out \[=\[(.*)\]=\]\)", text)
            self.assertEqual({(limit, out) for _, _, limit, out in runs}, {(more, str(self.out))})
            self.assertEqual(text.count("stopped at its time limit"), len(runs) if words else 0)
            for case in cases:
                tiers = {run for name, run, *_ in runs if name == case["name"]}
                self.assertEqual(tiers & {"quick", "full", "paper"}, set(case["tiers"]), case["name"])


if __name__ == "__main__":
    unittest.main()
