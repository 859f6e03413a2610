"""Files as solvers write them are read without conversion: the same numbers pass from every format."""

import datetime
import os
import re
import shutil
import subprocess
import unittest

import h5py
import numpy as np

from submitting import SEICHE, SOURCE, Scoring, exact, rows_of, seiche

WRITTEN = SOURCE / "ci/tests/solver_output"  # by real solvers, see its README.md


# The text of a file or of several by name, which of them is submitted and how, what is said of it.
PROBE, GAUGE, REEF = "# Probe 0 (1 0 0)\n", "# gauge_id= 1 location=", "number of gauges:  1\nx_coord y_coord\n"
PLACES = " ;PosX [m]:;1\n ;PosY [m]:;0\n ;PosZ [m]:;0\n"
LINE, PATCH = "1 mx\n0 xlow\n1 dx\n\n", "1 mx\n1 my\n0 xlow\n0 ylow\n1 dx\n1 dy\n\n"
BROKEN = [
    ("0 1\n1 1\n", "bare.txt", "bare.txt: line 1: ", "--columns"),
    ("0 1\n1 1\n", "bare.txt --columns t,eta,u", "2 columns", "names 3"),
    ("t eta\n0 inf\n1 1\n", "inf.txt", "inf.txt: line 2: column eta", "inf"),
    ("", "empty.txt --format reef3d", "empty.txt: no rows of numbers"),
    ("<VTKFile>", "run.vtu", "run.vtu: 'python3 -m seiche.adapt' makes a table of it"),
    (PROBE, "p", "p: no rows of numbers"),
    ("", "p --format openfoam", "p: no rows of numbers"),
    (PROBE + "()\n", "p", "p: line 2: no numbers"),
    (PROBE + "# Time\n0 1 2\n0.1 1\n", "p", "p: line 4: holds another number of values than the lines before"),
    ("# Location  0\n# hB hL\n0 1 2\n", "height.dat",
     "height.dat: line 3: no position of a probe before it: '# Probe 0 (x y z)' or '# Location 0 : (x y z)'"),
    (PROBE + "# Probe 1 (2 0 0)\n0 1 2 3\n", "p", "p: line 3: 3 values for 2 probes"),
    (PROBE + "0\n", "p", "p: line 2: 0 values for 1 probes"),
    ("# Probe 0 (1 0 0\n0 1\n", "p", "p: line 1: has no position (x y) in brackets"),
    ("0 1 2\n", "set.xy", "set.xy: 3 columns do not fit the name of the file, SET_FIELD_FIELD.xy"),
    ({"sets/1/a_eta.xy": "0 1\n1 1\n", "sets/1/b_eta.xy": "0 1\n2 1\n"}, "sets",
     "1: 2 sets of different points: name the files of one of them"),
    ({"run/note": ""}, "run", "run: is a folder without times", "it contains note"),
    ({"run/0/deeper/note": ""}, "run", "run: its folders of times are empty"),
    ({"p/0/eta": PROBE + "0 1\n1 1\n"}, "p --format geoclaw", "p: --format geoclaw: is a folder of openfoam"),
    (GAUGE + " 1.0 0.0\n", "gauge00001.txt", "line 1: has no position (x y) in brackets"),
    (GAUGE + "( 1.0 )\n", "gauge00001.txt", "line 1: the location has not two numbers"),
    (GAUGE + "( 1.0 0.0 )\n# level, time\n", "gauge00001.txt", "line 1: no rows of numbers follow"),
    (GAUGE + "( 1.0 0.0 ) num_var= 4\n1 0 1 0 0\n", "gauge00001.txt", "line 2: 5 entries, must be 6"),
    (REEF + "1 0\n", "WSF.dat", "line 3: must be the number, x and y of a gauge"),
    (REEF + "1\t 0\t 0\n\ntime\t P1\n\n0\t 1\t 2\n", "WSF.dat", "line 7: 2 values for 1 gauges"),
    (PLACES + "Part;Time [s];Elevation_0 [m]\n", "e.csv", "line 4: ends before the first row of numbers"),
    (PLACES.replace(";1", "").replace(";0", "") + "Part;Time [s]\n0;0\n", "e.csv", "line 1: no positions: MeasureTool"),
    (PLACES.replace("Y [m]:;0", "Y [m]:;0;0") + "Part;Time [s];Elevation_0 [m]\n0;0;1\n", "e.csv",
     "line 4: 3 columns, must be part, time and one for each of the 1 positions"),
    (PLACES.replace("Z [m]:;0", "Z [m]:") + "Part;Time [s];Elevation_0 [m]\n0;0;1\n", "e.csv", "line 4: 3 columns"),
    (PLACES + "Part;Time [s]\n0;0;1\n", "e.csv", "line 4: 2 columns, must be part, time"),
    (PLACES + "Part;Time [s];Elevation_0 [m]\n0;0;1\n1;1;1;1\n", "e.csv", "line 6: 4 entries, must be 3"),
    *(({"fort.q0001": grid, "fort.t0001": time}, "fort.q0001", message) for grid, time, message in (
        (LINE + "1 0 1\n", "", "fort.t0001: is empty, must say the time"),
        (LINE + "1 0 1\n", "time 6.0\n", "fort.t0001: line 1: must begin with the time"),
        ("", "6.0 time\n", "fort.q0001: no patches"),
        ("1 grid number\n", "6.0 time\n", "fort.q0001: line 1: must be a number and what it is: the header of a patch"),
        (LINE.replace("1 mx", "0 mx"), "6.0 time\n", "line 1: mx = 0, must be in [1, 1e7]"),
        (PATCH.replace("1 my", "1.1e7 my"), "6.0 time\n", "line 2: my = 1.1e+07, must be in [1, 1e7]"),
        (LINE.replace("1 dx\n", ""), "6.0 time\n", "line 3: a header must have mx, xlow, dx"),
        (PATCH.replace("0 ylow\n", "") + "1 0 0\n", "6.0 time\n", "line 7: a header must have mx, xlow, dx"),
        ("0 xlow\n1 dx\n\n1 0 1\n", "6.0 time\n", "line 4: a header must have mx, xlow, dx"),
        (LINE.replace("1 mx", "3 mx") + "1 0 1\n1 0 1\n", "6.0 time\n", "line 6: ends 1 cells before the patch does"),
        (LINE + "1\n", "6.0 time\n", "line 5: 1 values in a cell, must be h, hu, eta"),
        (PATCH + "1 1\n", "6.0 time\n", "line 8: 2 values in a cell, must be h, hu, hv, eta"),
        (PATCH + "1 0 0 1\n\n" + LINE + "1 0 1\n", "6.0 time\n",
         "line 13: a patch of one dimension beside one of two, must all be alike"),
        (LINE.replace("1 mx", "2 mx") + "1 0 1\n1 0\n", "6.0 time\n", "line 6: 2 entries, must be 3"))),
    ({"_output/fort.q0001": LINE + "1 0 1\n"}, "_output", "fort.t0001: cannot be read as a file")]


class SolverFiles(Scoring):
    def bowl(self):
        """Positions of three gauges, times, and a row of depths per time."""
        x, t, h = self.gauges()
        places = sorted(set(x))
        return places, t[x == places[0]], np.array([h[x == place] for place in places]).T

    def wave(self):
        """t and eta of the case with a single gauge."""
        columns = self.reference("wavemaker_start", "gauge")
        return columns["t"], columns["eta"]

    def passes(self, *words, case="thacker"):
        table = ("--table", "gauges") if case == "thacker" else ()
        scored = self.score(case, *words, *table)
        self.accepted(scored)
        measured = self.record(f"{case}.mine")["measurements"]
        worst = max(abs(value) for name, value in measured.items() if "largest_error" in name)
        self.assertLess(worst, 1e-12)
        return scored.stdout

    def test_openfoam_probes_restarted(self):
        places, times, depths = self.bowl()
        head = "".join(f"# Probe {k} ({x!r} 0 0)\n" for k, x in enumerate(places))
        head += "#       Probe             0             1             2\n#        Time\n"
        def rows_at(values):
            return [f" {t!r}   " + "  ".join(map(repr, row)) + "\n" for t, row in zip(times.tolist(), values.tolist())]

        rows = rows_at(depths)
        probes = self.write(head + "".join(rows), "h")
        self.assertIn("openfoam, columns x, y, z, t, h", self.passes("--data", probes))
        self.write(head + "".join(rows[:40] + rows_at(2 * depths)[40:50] + rows[40:]), "h")
        self.assertIn("10 rows for x = ", self.passes("--data", probes))
        vectors = [f" {t!r}   " + "  ".join(f"({h!r} 0 {-h!r})" for h in row) + "\n"
                   for t, row in zip(times.tolist(), depths.tolist())]
        self.passes("--data", self.write(head + "".join(vectors), "U"), "--map", "U_x=h")

    def test_openfoam_interface_height(self):
        places, times, depths = self.bowl()
        text = "".join(f"# Location {k}       : ({x!r} 0 0)\n" for k, x in enumerate(places))
        text += "# hB               : Interface height above the boundary\n# Time\thB hL hB hL hB hL\n"
        text += "".join(f"{t!r}\t" + " ".join(f"{h!r} {h - 1!r}" for h in row) + "\n"
                        for t, row in zip(times.tolist(), depths.tolist()))
        self.passes("--data", self.write(text, "height.dat"), "--map", "hB=h")

    def test_geoclaw_gauges_in_a_file_each(self):
        places, times, depths = self.bowl()
        words = []
        for k, x in enumerate(places):
            text = f"# gauge_id= {k + 1:5d} location=( {x!r} 0.0 ) num_var=  4\n# Columns: level, time, h, hu, hv, eta\n"
            text += "".join(f"  1 {t!r} {h!r} 0.0 0.0 {h!r}\n" for t, h in zip(times.tolist(), depths[:, k].tolist()))
            words += ["--data", self.write(text, f"gauge{k + 1:05d}.txt")]
        self.passes(*words)

    def test_reef3d_wave_gauges(self):
        places, times, depths = self.bowl()
        text = "number of gauges:  3\n\nx_coord     y_coord\n"
        text += "".join(f"{k + 1}\t {x!r}\t 0.005\n" for k, x in enumerate(places))
        text += "\n\ntime\t P1\t P2\t P3\n\n"
        text += "".join(f"{t!r}\t " + "\t ".join(map(repr, row)) + "\n" for t, row in zip(times.tolist(), depths.tolist()))
        self.passes("--data", self.write(text, "REEF3D-CFD-WSF-HG.dat"), "--map", "eta=h")

    def test_dualsphysics_measuretool_in_any_order_of_positions(self):
        places, times, depths = self.bowl()
        order = [2, 0, 1]
        for separator in ";,":
            text = ""
            for axis, values in (("X", [places[k] for k in order]), ("Y", [0.0] * 3), ("Z", [0.0] * 3)):
                text += separator.join([" ", f"Pos{axis} [m]:", *map(repr, values)]) + "\n"
            text += separator.join(["Part", "Time [s]", *(f"Elevation_{k} [m]" for k in range(3))]) + "\n"
            text += "".join(separator.join([str(n), repr(t), *(repr(row[k]) for k in order)]) + "\n"
                            for n, (t, row) in enumerate(zip(times.tolist(), depths.tolist())))
            self.passes("--data", self.write(text, "elevation.csv"), "--map", "Elevation=h")

    def test_openfoam_sets_of_every_time(self):
        template = seiche("score", "solitary_wave", "--template", "--table", "surface").stdout
        for command in re.findall(r"the reference: seiche (.*)", template):
            names, rows = rows_of(seiche(*command.split()).stdout)
            x, t, eta = ([row[names.index(name)] for row in rows] for name in ("x [m]", "t [s]", "eta [m]"))
            folder = self.folder / "surface" / t[0]
            folder.mkdir(parents=True)
            (folder / "line_eta_alpha.water.xy").write_text("".join(f"{a} \t{b}\t1\n" for a, b in zip(x, eta)))
        scored = self.score("solitary_wave", "--data", self.folder / "surface", "--table", "surface")
        self.accepted(scored)
        self.assertIn("openfoam, columns x, eta, alpha.water, t", scored.stdout)
        self.assertLess(self.record("solitary_wave.mine")["measurements"]["eta_relative_l2_t_10"], 1e-12)

    def test_openfoam_sets_as_written(self):
        folder = WRITTEN / "shallowWaterFoam/profile"
        for data in ([folder], [folder / "6"]):
            scored = self.score("riemann", *(word for path in data for word in ("--data", path)), "--map", "U_x=u",
                                "--dx", 1)
            self.accepted(scored)
            self.assertIn("columns x, U_x, U_y, U_z, t, h", scored.stdout)
        self.assertAlmostEqual(self.record("riemann.mine")["measurements"]["front_position"], 39.4, delta=1)

    def test_openfoam_folder_without_times(self):
        self.refused(self.score("riemann", "--data", WRITTEN / "shallowWaterFoam"), "without times", "profile")

    def test_openfoam_restart_as_written(self):
        """Ten times of 0.55 s and later are there twice; the two probes below each other are none of them."""
        scored = self.score("wavemaker_start", "--data", WRITTEN / "interFoam/probes", "--map", "p_rgh=eta")
        self.assertEqual(scored.returncode, 2)
        self.assertIn("must increase", scored.stderr)  # three probes, and the case asks for one gauge
        alone = self.folder / "probes"
        shutil.copytree(WRITTEN / "interFoam/probes", alone)
        for path in alone.glob("*/*"):
            lines = path.read_text().splitlines(keepends=True)
            if path.name == "U":
                path.unlink()
            else:
                path.write_text("".join(line for line in lines if "Probe 1" not in line and "Probe 2" not in line and
                                        line.startswith("#")) +
                                "".join(" ".join(line.split()[:2]) + "\n" for line in lines if not line.startswith("#")))
        scored = self.score("wavemaker_start", "--data", alone, "--map", "p_rgh=eta")
        self.assertIn("10 rows are replaced by later ones", scored.stdout, scored.stderr)

    def test_probes_below_each_other_are_no_restart(self):
        places, times, depths = self.bowl()
        text = "".join(f"# Probe {2 * k + j} ({x!r} {0.1 * j} 0)\n" for k, x in enumerate(places) for j in (0, 1))
        text += "# Time\n" + "".join(f"{t!r} " + " ".join(f"{h!r} {h!r}" for h in row) + "\n"
                                     for t, row in zip(times.tolist(), depths.tolist()))
        refused = self.score("thacker", "--data", self.write(text, "h"), "--table", "gauges")
        self.refused(refused, "must increase")  # two at each x: which of them is asked for is not guessed

    def test_gerris_locations_as_written(self):
        scored = self.score("riemann", "--data", WRITTEN / "gerris/profile.txt", "--map", "P=h", "--dx", 1)
        self.accepted(scored)
        self.assertIn("gerris, columns t, x, y, z, P", scored.stdout)

    def test_geoclaw_grids_with_refinement(self):
        places = [0.5 + k if k < 25 else 25.25 + 0.5 * (k - 25) for k in range(75)]
        flow = exact("riemann", "--set", "jump=20,right_depth=0.1", *(word for x in places for word in ("--at", f"x={x},t=6")))
        values = list(zip(flow["h"].tolist(), flow["u"].tolist()))

        def patch(number, level, low, size, cells):
            header = f"{number} grid_number\n{level} AMR_level\n{len(cells)} mx\n{low} xlow\n{size} dx\n\n"
            return header + "".join(f"{h!r} {h * u!r} {h!r}\n" for h, u in cells) + "\n"

        coarse = values[:25] + [(9.0, 9.0)] * 25  # what the finer patch covers is not looked at
        output = self.folder / "_output"
        output.mkdir()
        (output / "fort.q0001").write_text(patch(1, 1, 0, 1, coarse) + patch(2, 2, 25, 0.5, values[25:]))
        (output / "fort.t0001").write_text("6.0 time\n")
        for data in (output, output / "fort.q0001"):
            scored = self.score("riemann", "--data", data, "--map", "hu=u")
            self.assertIn("geoclaw, columns x, t, h, hu, eta", scored.stdout, scored.stderr)
            self.assertLess(self.record("riemann.mine")["measurements"]["h_relative_l1"], 0.02)

    def test_tecplot_points(self):
        head = 'TITLE = "flume, run 3"\nVARIABLES = "Time, s"\n"eta [cm]" "u, m/s"\nZONE T="gauge, 1", I=9, F=POINT\n'
        rows = "".join(f" {t!r} {100 * eta!r} 0\n" for t, eta in zip(*(values.tolist() for values in self.wave())))
        said = self.passes("--data", self.write(head + rows, "gauge.dat"), case="wavemaker_start")
        self.assertIn("tecplot, columns Time, eta, u", said)
        self.assertIn("cm became m", said)
        surface = self.reference("solitary_wave", "surface")
        zones = "variables=x,eta\n"
        for time in dict.fromkeys(surface["t"].tolist()):
            here = surface["t"] == time
            zones += f"zone solutiontime = {time!r}, i = {here.sum()}\n" + "".join(
                f"{x!r} {eta!r}\n" for x, eta in zip(surface["x"][here].tolist(), surface["eta"][here].tolist()))
        self.accepted(self.score("solitary_wave", "--data", self.write(zones, "surface.dat"), "--table", "surface"))
        for path in self.out.glob("*"):
            path.unlink()
        for wrong, *said in ((head.replace("F=POINT", "DATAPACKING=BLOCK") + rows, "line 4", "POINT form"),
                             (head.replace("F=POINT", "ZONETYPE=FEQUAD") + rows, "line 4", "POINT form"),
                             (zones.replace("solutiontime", "strandid"), "a second zone", "SOLUTIONTIME"),
                             ("strandid".join(zones.rsplit("solutiontime", 1)), "a second zone", "SOLUTIONTIME"),
                             (head.replace('"u, m/s"', "") + rows, "line 5", "3 columns")):
            self.refused(self.score("solitary_wave", "--data", self.write(wrong, "w.dat"), "--table", "surface"), *said)

    def test_gauges_beside_each_other(self):
        places, times, depths = self.bowl()
        wide = "t,WG1,WG2,WG3\n" + "".join(f"{t!r}," + ",".join(map(repr, row)) + "\n"
                                          for t, row in zip(times.tolist(), depths.tolist()))
        gauges = ",".join(f"WG{k + 1}={x!r}" for k, x in enumerate(places))
        self.passes("--data", self.write(wide, "wide.csv"), "--gauges", gauges, "--map", "gauge=h")
        words = []
        for k, x in enumerate(places):
            text = "".join(f"  {t!r}  {h!r}  0.0  0.0\n" for t, h in zip(times.tolist(), depths[:, k].tolist()))
            words += ["--data", self.write(text, f"sta_{k + 1:04d}")]
        gauges = ",".join(f"sta_{k + 1:04d}={x!r}" for k, x in enumerate(places))
        self.passes(*words, "--gauges", gauges, "--map", "eta=h")

    def test_gauge_without_a_position(self):
        wide = self.write("t,WG1\n0,1\n1,1\n")
        self.refused(self.score("thacker", "--data", wide, "--table", "gauges", "--gauges", "WG1=left"), "--gauges WG1", "left")

    def test_swash_table_with_its_header(self):
        t, eta = (values.tolist() for values in self.wave())
        text = ("%\n% Run:001 Table:GAUGE SWASH version:7.01\n%\n%  Tsec  Watlev\n%  [sec]  [m]\n%\n" +
                "".join(f"  {a!r}  {b!r}\n" for a, b in zip(t, eta)))
        self.passes("--data", self.write(text, "gauge.tbl"), case="wavemaker_start")

    def test_one_gauge_in_every_delimiter(self):
        t, eta = (values.tolist() for values in self.wave())
        swl = "time [s];swlx [m];swly [m];swlz [m];pos0x [m]\n" + "".join(
            f"{a!r};9.5;0;{b!r};9.5\n" for a, b in zip(t, eta))
        self.passes("--data", self.write(swl, "swl.csv"), "--map", "time=t,swlz=eta", case="wavemaker_start")
        station = "".join(f"   {a!r}   {b!r}   0.0\t0.0\n" for a, b in zip(t, eta))
        self.passes("--data", self.write(station.replace("\t", "   "), "sta_0001"), "--columns", "t,eta,u,v",
                    case="wavemaker_start")
        swash = "%\n% Run:test Table:GAUGE SWASH\n%\n% Tsec  Watlev\n% [s]  [m]\n%\n" + "".join(
            f"  {a!r}  {b!r}\n" for a, b in zip(t, eta))
        self.passes("--data", self.write(swash, "gauge.tbl"), "--columns", "t,eta", case="wavemaker_start")
        tabs = "// Basilisk\nt\teta\n" + "".join(f"{a!r}\t{b!r}\n" for a, b in zip(t, eta))
        self.passes("--data", self.write(tabs, "gauge.txt"), case="wavemaker_start")

    def test_what_is_wrong_is_named_with_its_line(self):
        said = []
        for number, (files, place, *message) in enumerate(BROKEN):
            if isinstance(files, str):
                files = {place.split()[0]: files}
            folder = self.folder / str(number)
            folder.mkdir()
            for name, text in files.items():
                (folder / name).parent.mkdir(parents=True, exist_ok=True)
                (folder / name).write_text(text)
            data, *options = place.split()
            with self.subTest(files=files, message=message):
                result = self.score("wavemaker_start", "--data", folder / data, *options)
                self.refused(result, *message)
                said.append(result.stderr)
        for file in ("gauge_files", "geoclaw_grids", "openfoam_files", "solver_files"):
            self.every_message_tried(f"validation/scoring/{file}.cpp", said)
        self.refused(self.score("thacker", "--table", "gauges", "--data", self.write("t left right\n0 1 1\n1 1 1\n")),
                     "column h is missing", "--gauges NAME=")

class AsPeopleWrite(Scoring):
    """A table in the shapes in which people and data loggers write it: the same verdict and the same numbers."""

    def setUp(self):
        super().setUp()
        self.t, self.eta = (values.tolist() for values in self.reference("standing_wave", "wall").values())

    def rows(self, separator=",", text=repr, order=slice(None), eta=None):
        return "".join(f"{text(t)}{separator}{text(y)}\n" for t, y in list(zip(self.t, eta or self.eta))[order])

    def judged(self, *words, status=0):
        scored = self.score("standing_wave", *words, "--table", "wall")
        self.accepted(scored, status)
        return scored.stdout, self.record("standing_wave.mine")["measurements"]

    def alike(self, text, *notes, name="mine.csv", within=1e-9):
        plain = self.judged("--data", self.write("t,eta\n" + self.rows()))[1]
        stdout, numbers = self.judged("--data", self.write(text, name))
        for note in notes:
            self.assertIn(note, stdout)
        self.assertEqual(set(numbers), set(plain))
        for key, value in plain.items():
            self.assertAlmostEqual(numbers[key], value, delta=within * max(1, abs(value)), msg=key)

    def test_headers_and_numbers(self):
        fortran = lambda value: f"{value:.16E}".replace("E", "D")
        comma = lambda value: repr(value).replace(".", ",")
        cm = [100 * y for y in self.eta]
        for text in ("# t [s]   eta [m]\n" + self.rows(" "), "# t eta\n" + self.rows(" ", fortran),
                     "t [s];eta [m]\n" + self.rows(";", comma), "t\teta\r\n" + self.rows("\t").replace("\n", "\r\n"),
                     "\ufefft,eta\n" + self.rows(), ("t,eta\n" + self.rows()).encode("utf-16"),
                     b"\xe9t\xe9\n" + ("t,eta\n" + self.rows()).encode(), "sep=;\nt;eta;\n" + self.rows(";").replace("\n", ";\n"),
                     "t,eta\n(s),(m)\n" + self.rows(), "t,eta\n" + self.rows(order=slice(0, 50)) + "t,eta\n"
                     + self.rows(order=slice(50, None))):
            with self.subTest(text[:20]):
                self.alike(text)
        for name in ("elev", "zs [m]", "swlz [m]", "Watlev", "FREE SURFACE [M]", "ETA", "stage"):
            self.alike(f"TIME [S];{name}\n" + self.rows(";"), "is taken for eta")
        self.alike("Wave flume run 12\nrecorded by a logger\n,wall x=0m\nt(s),level(cm)\n" + self.rows(eta=cm),
                   "level is taken for eta", "cm became m")

    def test_which_of_two_columns_is_meant_is_asked(self):
        """ANUGA's elevation is the bed's."""
        rows = "".join(f"{t!r},{y!r},-1\n" for t, y in zip(self.t, self.eta))
        words = "standing_wave", "--table", "wall", "--data", self.write("time,stage,elevation\n" + rows)
        self.refused(self.score(*words), "elevation or stage", "--map NAME=eta")
        self.accepted(self.score(*words, "--map", "stage=eta"))

    def test_the_first_rows_may_lack_the_last_column(self):
        empty = seiche("score", "riemann", "--template").stdout
        self.refused(self.score("riemann", "--data", self.write(empty)), "column h: no value where the depth is 1 m")
        words = ("--set", "left_depth=0,right_depth=1,time=2")
        columns = self.reference("riemann", "profile", *words)
        self.assertTrue((columns["h"][:2] == 0).all())
        text = "x,h,u\n" + "".join(f"{x},{h},{u if h > 0 else ''}\n" for x, h, u in zip(*(columns[k] for k in "xhu")))
        self.accepted(self.score("riemann", *words, "--data", self.write(text)))

    def test_units(self):
        for unit, factor in (("mm", 1e-3), ("ft", 0.3048), ("km", 1e3), ("inch", 0.0254)):
            self.alike(f"t,eta [{unit}]\n" + self.rows(eta=[y / factor for y in self.eta]), f"{unit} became m")
        for unit, factor in (("min", 60), ("hours", 3600), ("days", 86400), ("ms", 1e-3)):
            rows = "".join(f"{t / factor!r},{y!r}\n" for t, y in zip(self.t, self.eta))
            self.alike(f"time [{unit}],eta\n" + rows, f"{unit} became s")
        start = 1577836800
        rows = "".join(f"{start + t:.9f},{y!r}\n" for t, y in zip(self.t, self.eta))
        self.alike("t [seconds since 2020-01-01 00:00:00],eta\n" + rows, f"counted from {start} s", within=1e-6)
        for form in ("%Y-%m-%dT%H:%M:%S.%fZ", "%Y-%m-%d %H:%M:%S.%f"):
            date = lambda t: (datetime.datetime(2020, 1, 1) + datetime.timedelta(seconds=t)).strftime(form)
            self.alike("Time [UTC],eta\n" + "".join(f"{date(t)},{y!r}\n" for t, y in zip(self.t, self.eta)),
                       f"counted from {start} s", within=1e-5)  # a millionth of a second, over a period of two
        for path in self.out.glob("*"):
            path.unlink()
        for text in ("t,eta [kg]\n", "t [m],eta\n", "t,eta [furlong]\n"):
            self.refused(self.score("standing_wave", "--table", "wall", "--data", self.write(text + self.rows())), "unit")

    def test_order_repeats_and_padding(self):
        n = len(self.t)
        self.alike("t,eta\n" + self.rows(order=slice(0, None, 2)) + self.rows(order=slice(1, None, 2)), "sorted by t")
        self.alike("t,eta\n" + self.rows(order=slice(None, None, -1)), "sorted by t")
        wrong = [2 * y for y in self.eta]
        self.alike("t,eta\n" + self.rows(order=slice(0, n // 2)) + self.rows(order=slice(n // 2, n // 2 + 9), eta=wrong)
                   + self.rows(order=slice(n // 2, None)), "9 rows are replaced by later ones")
        self.alike("t,eta\n" + self.rows() + "0,0\n" * 20, "20 rows of zeros at the end are left out")

    def test_no_value_is_a_gap(self):
        for none in ("nan", "-9999", "1e20", "9.96921e+36", "", "NA", "****"):
            lines = ["t,eta", *self.rows().splitlines()]
            for k in (8, 9, 20):
                lines[k] = lines[k].split(",")[0] + "," + none
            stdout, numbers = self.judged("--data", self.write("\n".join(lines)))
            self.assertIn(f"3 of {len(self.t)} rows have no value", stdout)
            self.assertAlmostEqual(numbers["eta_coverage"], 1 - 3 / len(self.t), 12)
            largest = re.search(r"largest error: eta: largest at t = \S+ s, (\S+) m", stdout)
            self.assertTrue(largest is None or abs(float(largest[1])) < 1e-9, "the straight line over a gap is nobody's error")
        self.judged("--data", self.write("t,eta\n" + self.rows(order=slice(0, len(self.t) // 2))), status=1)

    def test_netcdf_says_what_its_numbers_mean(self):
        with h5py.File(self.folder / "run.nc", "w") as file:
            file["time"] = [t / 3600 for t in self.t]
            file["time"].attrs["units"] = "hours since 2020-01-01"
            file["eta"] = [round((100 * y - 5) / 1e-6) if k != 20 else -7 for k, y in enumerate(self.eta)]
            file["eta"].attrs.update({"units": "cm", "scale_factor": 1e-6, "add_offset": 5.0, "_FillValue": [-7]})
        stdout, numbers = self.judged("--data", self.folder / "run.nc")
        self.assertIn(f"1 of {len(self.t)} rows have no value", stdout)
        self.assertLess(numbers["eta_relative_l2"], 1e-6)  # half a millionth of a centimetre

    def test_a_pipe_and_a_file_for_adapt_are_refused(self):
        os.mkfifo(self.folder / "pipe.csv")
        for name, said in (("pipe.csv", "cannot be read as a file"), ("run.vtu", "seiche.adapt")):
            path = self.folder / name if name == "pipe.csv" else self.write("<VTKFile>", name)
            self.refused(self.score("standing_wave", "--table", "wall", "--data", path), name, said)

    def test_dry_is_no_value_where_the_reference_is_dry(self):
        words = ("--set", "right_depth=0,time=4")
        columns = self.reference("riemann", "profile", *words)

        def scored(dry):
            h, u = (["nan" if d else repr(float(v)) for v, d in zip(columns[k], dry)] for k in "hu")
            return self.score("riemann", *words, "--data", self.write("x,h,u\n" + "".join(
                f"{x},{a},{b}\n" for x, a, b in zip(columns["x"], h, u))))

        self.score("riemann", *words, "--data", self.table(columns))
        whole = self.verdicts("riemann.mine")
        self.assertNotIn("fail", whole.values())
        scored(columns["h"] == 0)
        self.assertEqual(self.verdicts("riemann.mine"), whole)
        for path in self.out.glob("*"):
            path.unlink()
        self.refused(scored(columns["h"] < 0.05), "no value where the depth is")
        cut = {**columns, "h": np.where(columns["h"] < 0.05, 0, columns["h"])}
        self.accepted(self.score("riemann", *words, "--data", self.table(cut)), 1)


class Published(Scoring):
    """Results that others have published: examples/solvers/published."""

    def worked_out(self, x, y, exact):
        """Relative L2 error of the points (x, y), joined by lines, at the case's points."""
        at, right = exact
        return np.sqrt(np.sum((np.interp(at, x, y) - right) ** 2) / np.sum(right ** 2))

    def pulsating(self, t):
        """Thacker's formula, with the radius and depth that the files are of."""
        radius, depth, middle = 430620.0, 50.0, 2.0
        a = ((depth + middle) ** 2 - depth ** 2) / ((depth + middle) ** 2 + depth ** 2)
        d = 1 - a * np.cos(np.sqrt(8 * 9.81 * depth) / radius * t)
        reach = radius * np.sqrt((depth + middle) / depth)
        at = np.linspace(-reach, reach, 201)
        eta = depth * (np.sqrt(1 - a * a) / d - 1 - (at / radius) ** 2 * ((1 - a * a) / d ** 2 - 1))
        wet = eta > depth * ((at / radius) ** 2 - 1)
        return at[wet], eta[wet]

    def test_they_are_whole_and_score_what_is_worked_out_by_hand(self):
        folder = SOURCE / "examples/solvers/published"
        subprocess.run(["sha256sum", "--check", "--quiet", "--strict", "SHA256SUMS"], cwd=folder, check=True)
        subprocess.run([folder / "run.sh", self.out], check=True, capture_output=True, env={**os.environ, "SEICHE": SEICHE})
        rows = np.loadtxt(folder / "geoclaw/gauge00001.txt")
        t = np.linspace(0, 0.1 * 2 * np.pi / np.sqrt(2 * 9.81 * 0.1), 101)
        phase = np.sqrt(2 * 9.81 * 0.1) * t
        errors = {"GeoClaw": self.worked_out(rows[:, 1], rows[:, 2], (t, 0.05 * (np.cos(phase) + np.sin(phase) - 0.5) + 0.05))}
        for hour in (18, 24):
            x, eta = np.loadtxt(folder / f"thetis/{hour}h.csv", unpack=True)
            errors[f"Thetis-{hour}h"] = self.worked_out(x, eta, self.pulsating(3600 * hour))
        limit = 0.05 / np.sqrt(2)
        for solver, error in errors.items():
            claim, = (one for one in self.record(f"thacker_bowl.{solver}")["claims"] if one["id"].endswith("relative_l2"))
            self.assertAlmostEqual(claim["measured"], error, 9)
            self.assertEqual(claim["verdict"], "pass" if error < limit else "fail")
        self.assertEqual(self.verdicts("thacker_bowl.GeoClaw")["gauges-given"], "fail")
        bar = self.record("luth_bar.Basilisk")
        self.assertIn("3 readings, clock set at x = 17.3, u_num not stated",
                      [one["resolution"] for one in bar["claims"] if one["id"] == "agreement"][0])


if __name__ == "__main__":
    unittest.main()
