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

    def test_geoclaw_grids_that_are_broken(self):
        output = self.folder / "_output"
        output.mkdir()
        (output / "fort.q0001").write_text("1 grid_number\n1 AMR_level\n3 mx\n0 xlow\n1 dx\n\n1 0 1\n1 0 1\n")
        self.refused(self.score("riemann", "--data", output), "fort.t0001")
        (output / "fort.t0001").write_text("6.0 time\n")
        self.refused(self.score("riemann", "--data", output), "fort.q0001", "line 8", "ends 1 cells before the patch")

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
        def refused(text, name, *words, columns=()):
            self.refused(self.score("wavemaker_start", "--data", self.write(text, name), *columns), name, *words)

        refused("0 1\n1 1\n", "bare.txt", "line 1", "--columns")
        refused("0 1\n1 1\n", "bare.txt", "2 columns", "names 3", columns=("--columns", "t,eta,u"))
        refused("# Probe 0 (1 0 0)\n# Time\n0 1 2\n0.1 1\n", "p", "line 4", "number of values")
        refused("# Location  0\n# hB hL\n0 1 2\n", "height.dat", "line 3", "no position of a probe", "# Location 0 : (x y z)")
        refused("# Probe 0 (1 0 0)\n# Probe 1 (2 0 0)\n0 1 2 3\n", "p", "line 3", "3 values for 2 probes")
        refused("# gauge_id= 1 location=( 1.0 0.0 ) num_var= 4\n1 0 1 0 0\n", "gauge00001.txt", "line 2", "5 entries")
        refused("number of gauges:  1\nx_coord y_coord\n1\t 0\t 0\n\ntime\t P1\n\n0\t 1\t 2\n", "WSF.dat", "line 7",
                "2 values for 1 gauges")
        refused("t eta\n0 inf\n1 1\n", "inf.txt", "line 2", "column eta", "inf")
        self.refused(self.score("wavemaker_start", "--data", self.write("t eta\n0 1\n"), "--format", "excel"),
                     "--format excel", "geoclaw")
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

    def test_some_gauges_are_judged_and_the_others_named(self):
        pulse = lambda t: 0.01 * np.exp(-((t - 30) ** 2))
        t = np.arange(25, 36, 0.1)
        folder = self.folder / "stations"
        folder.mkdir()
        for gauge in (6, 9, 16, 22):
            (folder / f"sta_{gauge:04d}").write_text("".join(f" {a:.6E} {b:.6E} 0 0\n" for a, b in zip(t, pulse(t))))
        wide = "".join(",".join([f"{a}", *[repr(pulse(a))] * 4]) + "\n" for a in t)
        places = [(9.36, 13.8), (10.36, 13.8), (12.96, 11.22), (15.56, 13.8)]
        long = "x,y,t,eta\n" + "".join(f"{x},{y},{a},{pulse(a)}\n" for x, y in places for a in t)
        named = "t,A,B,C,D\n" + wide
        for words in (["--data", folder], ["--data", self.write(wide, "wide.txt"), "--columns", "t,6,9,16,22"],
                      ["--data", self.write("t,6,9,16,22\n" + wide)], ["--data", self.write(long, "long.csv")],
                      ["--data", self.write(named, "named.csv"), "--gauges", "A=6,B=9,C=12.96:11.22,D=22"]):
            with self.subTest(words):
                scored = self.score("island_gauges", *words, "--table", "gauges")
                self.accepted(scored, 1)
                self.assertIn("4 of 8 given, without gauge = 1, 2, 3, 4", scored.stdout)
                self.assertIn(self.verdicts("island_gauges.mine")["agreement"], ("fail", "inconclusive"))
        for path in self.out.glob("*"):
            path.unlink()
        self.refused(self.score("island_gauges", "--data", self.write(named), "--gauges", "E=6"), "--gauges E=6", "is called E")
        self.refused(self.score("island_gauges", "--data", self.write(named), "--gauges", "A=7"), "--gauges A=7", "6, 9, 16")
        # Numbers in names count where nobody says what the columns hold.
        twice = self.write("t,P1,P2,P6,Q1\n" + wide)
        self.refused(self.score("island_gauges", "--data", twice), "gauge = 1, which another of its columns holds")
        numbered = self.write("t,P1,P2,P6,total\n" + wide)
        for words, given in ((("--gauges", "P1=9,P2=1"), "2 of 8 given, without gauge = 2, 3, 4, 6, 16, 22"),
                             ((), "3 of 8 given, without gauge = 3, 4, 9, 16, 22")):
            scored = self.score("island_gauges", "--data", numbered, "--table", "gauges", *words)
            self.assertIn(given, scored.stdout, scored.stderr)
            self.assertEqual("column P6 is taken for gauge = 6" in scored.stdout, not words)
        for path in self.out.glob("*"):
            path.unlink()
        self.refused(self.score("isolated_building", "--data", self.write("t,1,2,3,4\n" + wide)),
                     "fits the tables depths and velocity: add --table")

    def test_what_the_record_does_not_hold_is_named(self):
        water = "T,p\n" + "".join(f"{k / 20},0.01\n" for k in range(201))
        scored = self.score("dam_break_wall_pressure", "--data", self.write(water))
        self.accepted(scored, 1)
        self.assertEqual(self.verdicts("dam_break_wall_pressure.mine")["agreement"], "fail")  # nothing sets its clock
        names, rows = rows_of(seiche("score", "composite_beach", "--template", "--table", "gauges").stdout)
        still = ",".join(names) + "\n" + "".join(f"{gauge},{t},0\n" for gauge, t, _ in rows)
        scored = self.score("composite_beach", "--data", self.write(still), "--table", "gauges")
        self.accepted(scored, 1)
        self.assertIn("readings, u_num not stated, without gauges-arrival-", scored.stdout)
        self.assertIn("the measured quantity is missing", scored.stdout)
        self.assertNotIn("error nan %", scored.stdout)
        names, rows = rows_of(seiche("score", "breaking_on_slope", "--template", "--table", "levels").stdout)
        wrong = ",".join(names) + "\n" + "".join(f"{case},{x},0.02\n" for case, x, _ in rows)
        scored = self.score("breaking_on_slope", "--data", self.write(wrong), "--table", "levels")
        self.accepted(scored, 1)  # a level alone is compared with nothing
        self.assertIn("no amplitude was submitted", scored.stdout)

    def test_a_part_of_an_experiment_is_no_full_pass(self):
        """The data themselves, but for one gauge, or the end of the record."""
        data = (SOURCE / "reference_data/matsuyama_tanaka_2001_monai_valley/table.csv").read_text().splitlines()
        head = [k for k, line in enumerate(data) if line.startswith("gauge")][0]
        rows = [line.split(",") for line in data[head + 1:]]
        words = ("--table", "gauges", "--uncertainty", "eta=0.0001,t=0.01")
        for keep, status in ((lambda row: True, 0), (lambda row: row[0] != "7", 1), (lambda row: float(row[1]) < 17, 1)):
            text = "\n".join([data[head], *(",".join(row) for row in rows if keep(row))])
            self.accepted(self.score("monai_valley", "--data", self.write(text), *words), status)
            verdicts = self.verdicts("monai_valley.mine")
            self.assertNotIn("error", verdicts.values())
            missed = {name for name, verdict in verdicts.items() if verdict != "pass"}
            self.assertTrue(all(name.endswith(("-given", "-coverage")) for name in missed), missed)
        # Gauges that differ in y alone.
        places = {"5": "4.521,1.196", "7": "4.521,1.696", "9": "4.521,2.196"}
        text = "x,y,t,eta\n" + "\n".join(",".join([places[gauge], *rest]) for gauge, *rest in rows)
        self.accepted(self.score("monai_valley", "--data", self.write(text), *words), 0)

    def agreement(self, case, text, *words):
        """Verdict and resolution of the comparison with the data; what is there is no full pass."""
        scored = self.score(case, "--data", self.write(text), *words)
        self.accepted(scored, 1)
        claim, = (one for one in self.record(f"{case}.mine")["claims"] if one["id"] == "agreement")
        return claim["verdict"], claim["resolution"], scored.stdout

    def test_one_gauge_is_known_by_the_name_of_its_column_under_any_header(self):
        data = (SOURCE / "reference_data/briggs_1995_conical_island_a/table.csv").read_text().splitlines()
        rows = [line.split(",")[1:] for line in data if line.startswith("6,")]
        plain, cm = ("".join(f"{t},{float(eta) * per}\n" for t, eta in rows) for per in (1, 100))
        measured = set()
        for text in ("t,6\n" + plain, "# my data\nt,WG6\n" + plain, "# t,WG6\n# s,m\n" + plain, "t,WG6\ns,cm\n" + cm,
                     "t,WG6\n[s],[cm]\n" + cm):
            told = self.agreement("island_gauges", text, "--table", "gauges", "--uncertainty", "eta=0.0001,t=0.001")
            self.assertIn("1 of 8 given, without gauge = 1, 2, 3, 4, 9, 16, 22", told[2])
            claim, = (one for one in self.record("island_gauges.mine")["claims"] if one["id"] == "agreement")
            measured.add(round(claim["measured"], 9))
        self.assertEqual(len(measured), 1, measured)
        self.accepted(self.score("island_gauges", "--data", self.write("t,WG7\n" + plain), "--table", "gauges"), 2)

    def test_a_record_that_ends_before_the_clocks_window_does_is_judged_by_what_it_holds(self):
        data = (SOURCE / "reference_data/briggs_1995_conical_island_a/table.csv").read_text().splitlines()
        rows = [line.split(",") for line in data if line[0].isdigit()]
        for end, late, factor, verdict in ((30, 0, 1, "pass"), (30, 0.5, 1, "pass"), (30, 0, 1.4, "fail"), (21, 0, 1, "error")):
            text = "gauge,t,eta\n" + "".join(f"{gauge},{float(t) + late},{factor * float(eta)}\n" for gauge, t, eta in rows
                                             if float(t) <= end)
            told = self.agreement("island_gauges", text, "--table", "gauges", "--uncertainty", "eta=0.0001,t=0.001")
            self.assertEqual(told[0], verdict, told)
            self.assertEqual("too short to set its clock" in told[1], verdict == "error", told)

    def test_what_is_given_of_a_wave_on_a_beach_is_judged(self):
        """Seven of eight instants, or one gauge: as good as the whole, and named."""
        for table, column, missing in (("profiles", "eta_over_d", "t"), ("gauges", "gauge_over_d", "x_over_d")):
            data = (SOURCE / f"reference_data/synolakis_1987_analytic_{'series' if table == 'gauges' else table}/table.csv"
                    ).read_text().splitlines()
            names = [name.split(" ")[0] for name in next(line for line in data if "eta" in line and line[0] != "#").split(",")]
            rows = [dict(zip(names, line.split(","))) for line in data if line[0] in "-0123456789"]
            left = min(float(row[missing]) for row in rows)
            for factor, verdict in ((1, "pass"), (1.2, "fail")):
                text = f"t,x_over_d,{column}\n" + "".join(
                    f"{row['t']},{row['x_over_d']},{factor * float(row['eta_over_d'])}\n" for row in rows
                    if float(row[missing]) != left)
                scored = self.score("synolakis_beach", "--data", self.write(text), "--table", table)
                self.accepted(scored, 1)
                self.assertIn(f"given, without {missing} = {left:g}", scored.stdout)
                verdicts = self.verdicts("synolakis_beach.mine")
                judged = {verdicts[one] for one in verdicts if not one.endswith(("-given", "-coverage"))}
                self.assertEqual(judged, {verdict})

    def test_some_of_several_run_ups_are_judged_and_the_others_named(self):
        means = {1: 0.5375 / 6, 2: 0.3625 / 6, 3: 0.3350 / 6}
        words = ("--table", "runup", "--uncertainty", "R=0.001")
        self.refused(self.score("island_gauges", "--data", self.write("angle,R\n80,0.03\n"), *words), "at least two")
        for places, named in (((1,), "1 of 3 given, without place = 2, 3"), ((1, 3), "2 of 3 given, without place = 2")):
            for factor, verdict in ((1, "pass"), (1.3, "fail")):
                text = "place,R\n" + "".join(f"{place},{factor * means[place]}\n" for place in places)
                told = self.agreement("monai_valley", text, *words)
                self.assertEqual(told[:2], (verdict, f"{len(places)} readings"))
                self.assertIn(named, told[2])
        for factor, verdict in ((1, "inconclusive"), (1.5, "fail")):  # one run-up is known to a fifth
            told = self.agreement("island_gauges", f"angle,R\n90,{0.02659 * factor}\n", *words)
            self.assertEqual(told[:2], (verdict, "1 readings"))
            self.assertIn("1 point, 1 of 9 reference points", told[2].splitlines()[0])

    def test_a_gauge_sets_the_clock_where_that_of_the_clock_is_missing(self):
        data = (SOURCE / "reference_data/luth_1994_bar_a/table.csv").read_text().splitlines()
        rows = [line.split(",") for line in data if line.startswith("17.3,")]
        for late, factor, verdict in ((0, 1, "pass"), (0.6, 1, "pass"), (0.6, 1.4, "fail")):
            text = "x,t,eta\n" + "".join(f"{x},{float(t) + late},{factor * float(eta)}\n" for x, t, eta in rows)
            told = self.agreement("luth_bar", text, "--uncertainty", "eta=0.0001")
            self.assertIn(", clock set at x = 17.3", told[1])
            self.assertEqual(told[0], verdict)
            self.assertAlmostEqual(self.record("luth_bar.mine")["measurements"]["gauges_time_shift"], late,
                                   delta=0.05)  # points are 0.1 s apart


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
