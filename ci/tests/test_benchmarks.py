"""What ci/checks/benchmarks writes: every benchmark beside the limit of the machine that it is near."""

import csv
import importlib.machinery
import importlib.util
import os
import pathlib
import tempfile
import unittest

SCRIPT = pathlib.Path(os.environ["SEICHE_SOURCE"]) / "ci/checks/benchmarks"
loader = importlib.machinery.SourceFileLoader("benchmarks", str(SCRIPT))
benchmarks = importlib.util.module_from_spec(importlib.util.spec_from_loader("benchmarks", loader))
loader.exec_module(benchmarks)

MACHINE = [{"name": "triad/1000", "real_time": 100, "time_unit": "ns", "bytes_per_second": 2e11},
           {"name": "triad/10000000", "real_time": 10, "time_unit": "ms", "bytes_per_second": 2e10},
           {"name": "fused", "real_time": 1, "time_unit": "us", "operations_per_second": 8e10}]


def table(*entries):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "speed.csv"
        benchmarks.write_table({"machine": MACHINE, "flow": list(entries)}, path)
        with path.open(encoding="utf-8", newline="") as file:
            return [row for row in csv.DictReader(file) if row["program"] == "flow"]


class Benchmarks(unittest.TestCase):
    def test_small_arrays_are_compared_with_the_cache_and_large_ones_with_the_memory(self):
        small, large = table(
            {"name": "step/1000", "real_time": 2, "time_unit": "us", "items_per_second": 5e8, "bytes_per_step": 1e5},
            {"name": "step/1000000", "real_time": 8, "time_unit": "ms", "items_per_second": 1.25e8,
             "bytes_per_step": 1e8, "operations_per_step": 6.4e7})
        self.assertAlmostEqual(float(small["of_bandwidth"]), 5e10 / 2e11)
        self.assertAlmostEqual(float(large["of_bandwidth"]), 1.25e10 / 2e10, places=3)
        self.assertAlmostEqual(float(large["of_peak"]), 0.1)
        self.assertEqual(small["of_peak"], "")
        self.assertAlmostEqual(float(large["nanoseconds_per_item"]), 8)

    def test_what_is_not_counted_says_why(self):
        row, = table({"name": "solve/3", "real_time": 2, "time_unit": "ms", "label": "not counted: adaptive"})
        self.assertEqual({row[column] for column in benchmarks.COUNTED}, {"adaptive"})

    def test_a_label_of_another_kind_is_no_reason(self):
        row, = table({"name": "step/3", "real_time": 2, "time_unit": "ms", "label": "banded", "bytes_per_step": 1e8})
        self.assertEqual(float(row["bytes_per_second"]), 5e10)

    def test_memory_of_a_particle_is_shown(self):
        row, = table({"name": "step/3", "real_time": 2, "time_unit": "ms", "bytes_per_particle": 200.25})
        self.assertEqual(row["bytes_per_item"], "200")

    def test_words_of_the_command(self):
        self.assertEqual(benchmarks.table_of("--table"), benchmarks.TABLE)
        self.assertEqual(benchmarks.table_of("--table=/tmp/a.csv"), pathlib.Path("/tmp/a.csv"))
        self.assertIsNone(benchmarks.table_of("--benchmark_filter=steps"))

    def test_a_program_without_a_matching_benchmark_has_no_rows(self):
        with tempfile.NamedTemporaryFile() as empty:
            self.assertEqual(benchmarks.entries_of(pathlib.Path(empty.name)), [])

    def test_a_benchmark_that_failed_has_no_row(self):
        self.assertEqual(table({"name": "step/3", "error_occurred": True, "real_time": 0, "time_unit": "ns"}), [])


if __name__ == "__main__":
    unittest.main()
