"""Files as solvers write them are read without conversion: the same numbers pass from every format."""

import unittest

import numpy as np

from submitting import Scoring, rows_of, seiche


class SolverFiles(Scoring):
    def bowl(self):
        """Positions of three gauges, times, and a row of depths per time."""
        x, t, h = self.gauges()
        places = sorted(set(x))
        return places, t[x == places[0]], np.array([h[x == place] for place in places]).T

    def wave(self):
        """t and eta of the case with a single gauge."""
        template = seiche("score", "wavemaker_start", "--template").stdout
        command = next(line for line in template.splitlines() if "the reference: seiche " in line)
        names, rows = rows_of(seiche(*command.split("the reference: seiche ")[1].split()).stdout)
        values = np.array([[float(word) for word in row] for row in rows])
        columns = {name.split("[")[0].strip(): values[:, k] for k, name in enumerate(names)}
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
        self.assertIn("30 rows are replaced by a restart", self.passes("--data", probes))
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

        refused("t;eta\n0,5;1\n1;1\n", "comma.csv", "line 2", "column t", "decimal comma")
        refused("0 1\n1 1\n", "bare.txt", "line 1", "--columns")
        refused("0 1\n1 1\n", "bare.txt", "2 columns", "names 3", columns=("--columns", "t,eta,u"))
        refused("# Probe 0 (1 0 0)\n# Time\n0 1 2\n0.1 1\n", "p", "line 4", "number of values")
        refused("# Probe 0 (1 0 0)\n# Probe 1 (2 0 0)\n0 1 2 3\n", "p", "line 3", "3 values for 2 probes")
        refused("# gauge_id= 1 location=( 1.0 0.0 ) num_var= 4\n1 0 1 0 0\n", "gauge00001.txt", "line 2", "5 entries")
        refused("number of gauges:  1\nx_coord y_coord\n1\t 0\t 0\n\ntime\t P1\n\n0\t 1\t 2\n", "WSF.dat", "line 7",
                "2 values for 1 gauges")
        refused("t eta\n0 nan\n1 1\n", "nan.txt", "line 2", "column eta", "nan")
        self.refused(self.score("wavemaker_start", "--data", self.write("t eta\n0 1\n"), "--format", "excel"),
                     "--format excel", "geoclaw")


if __name__ == "__main__":
    unittest.main()
