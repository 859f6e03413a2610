"""Mutation testing: the operators make what they say, the drawing repeats itself, seeded faults stand in the sources."""

import csv
import os
import pathlib
import subprocess
import sys
import tempfile
import tomllib
import unittest

SOURCE = pathlib.Path(os.environ["SEICHE_SOURCE"])
sys.path.insert(0, str(SOURCE / "verification/mutants"))

import checks  # noqa: E402
import mutate  # noqa: E402
import operators  # noqa: E402
import seeded  # noqa: E402

try:
    import clang.cindex  # noqa: F401
except ImportError:
    clang = None

CPP = """#include <stdexcept>
struct Point { double x, y; };
double f(double a, double b);
void require_that(bool met, const char* sentence, double a, double b);
template <class T> double g(const T* next, const T* previous, int i, Point p, double h) {
  if (h <= 0) throw std::invalid_argument("h is 1");
  double sum = next[i + 1] - previous[i] * 0.5;
  sum += f(p.x, h);
  f(h, sum);
  require_that(h < 7, "h is {}, of {}", h + 11, sum + 11);
  return i == 3 && !(h > 2) ? sum : -h;
}
"""
MADE_OF_CPP = {
    "relation: <= → <", "relation: <= → >=", "condition: h <= 0 → !(h <= 0)", "guard taken away: h <= 0 → false",
    "constant: 0 → 1", "index: i + 1 → i", "arithmetic: - → +", "index: i → i + 1", "arithmetic: * → /",
    "constant: 0.5 → (1.01 * 0.5)", "arithmetic: += → -=", "arithmetic: += → =", "member: x → y",
    "arguments: p.x, h → h, p.x", "statement left out: f(h, sum) → nothing", "arguments: h, sum → sum, h",
    "relation: == → !=", "logic: && → ||", "condition: ! → nothing", "constant: 3 → 4", "constant: 3 → 2",
    "sign: - → nothing", "stale value: next → previous", "stale value: previous → next",
    "statement left out: sum += f(p.x, h) → nothing", "relation: < → <=",
}
PYTHON = '''"""Text of 3 words."""
def f(x, y):
    if x < 0:
        return None
    draw(x, y)
    raise ValueError(f"{x + 1} is 2")
    return -x["left"][i] + 2.5 if not y else max(x, y)
'''
MADE_OF_PYTHON = {
    "relation: < → <=", "relation: < → >", "condition: x < 0 → not (x < 0)", "guard taken away: x < 0 → False",
    "constant: 0 → 1", "arguments: x, y → y, x", "statement left out: draw(x, y) → pass", "sign: - → nothing",
    "member: left → right", "index: i → i + 1", "arithmetic: + → -", "constant: 2.5 → (1.01 * 2.5)",
    "condition: not y → not (not y)", "condition: not → nothing", "member: x → y", "member: y → x", "member: max → min",
}
COMPLETE = """what = "a"
file = "LICENSE"
text = "MIT License"
replacement = "No License"
check = "verification/linear/tridiagonal_test.cpp"
claim = "record: id"
"""


class Operators(unittest.TestCase):
    def made(self, name, text, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / name).write_text(text)
            return operators.changes(name, folder, arguments)

    @unittest.skipUnless(clang, "needs python3-clang-19")
    def test_each_operator_of_cpp(self):
        found = self.made("a.hpp", CPP, "-xc++", "-std=c++20")
        self.assertEqual(MADE_OF_CPP - {change.shown(CPP.encode()) for change in found}, set())
        messages = [change.shown(CPP.encode()) for change in found if change.operator != "statement left out"
                    if any(word in CPP[change.begin:change.end] for word in ("h is", "11", "h +", "sum +"))]
        self.assertEqual(messages, [])
        minus = next(change for change in found if change.operator == "sign")
        self.assertEqual((minus.applied(CPP.encode()).decode(), minus.line), (CPP.replace(": -h", ":  h"), 11))

    @unittest.skipUnless(clang, "needs python3-clang-19")
    def test_changes_compile_together_as_choices(self):
        """Each of the template's lines, changed by the condition, is C++ that the compiler takes."""
        for change in self.made("a.hpp", CPP, "-xc++", "-std=c++20"):
            text, end = b"bool chosen();\n", 0
            for first, stop, choice in change.chosen(CPP.encode(), "chosen()"):
                text, end = text + CPP[end:first].encode() + choice.encode(), stop
            with self.subTest(change.shown(CPP.encode())):
                said = subprocess.run(["c++", "-std=c++20", "-fsyntax-only", "-w", "-xc++", "-"], capture_output=True,
                                      input=text + CPP[end:].encode())
                self.assertEqual(said.returncode, 0, said.stderr.decode())

    def test_each_operator_of_python(self):
        found = self.made("a.py", PYTHON)
        self.assertEqual(MADE_OF_PYTHON ^ {change.shown(PYTHON.encode()) for change in found}, set())

    def test_the_same_word_draws_the_same_change(self):
        pool = mutate.Pool(())
        drawn = [pool.draw("report", f"1 {number} 0") for number in range(20)]
        again = mutate.Pool(())
        self.assertEqual(drawn, [again.draw("report", f"1 {number} 0") for number in range(20)])
        self.assertGreater(len({change.file for change in drawn if change}), 5)

    def test_every_file_of_the_code_has_a_room(self):
        for room, files in mutate.Pool(()).rooms.items():
            self.assertTrue(files, room)


class Seeded(unittest.TestCase):
    def test_each_stands_in_the_sources_once(self):
        self.assertLessEqual(len(seeded.all_faults()), 150)

    def test_a_complete_table_is_read_whatever_the_white_space(self):
        for text in (COMPLETE, COMPLETE.replace("MIT License", "MIT\\n   Li  cense")):
            fault = seeded.fault("a/b", tomllib.loads(text))
            self.assertTrue(fault.change.applied((SOURCE / "LICENSE").read_bytes()).startswith(b"No License\n"))
            self.assertEqual(fault.check.target, "verify_linear")

    def test_each_mistake_is_refused(self):
        for before, after in [("MIT License", "GPL"), ("MIT License", "the"), ("No License", "MIT License"),
                              ("LICENSE", "LICENCE"), ("tridiagonal_test", "no_test"), ("record: id", "id"),
                              ('what = "a"\n', ""), ("what", "why"), ('claim = "record: id"\n', ""),
                              ('claim = "record: id"', 'claim = "record: id"\ntest = "a"'),
                              ("claim", 'set = ["a=1"]\nclaim')]:
            with self.subTest(after=after), self.assertRaises(seeded.BadFault):
                seeded.fault("a/b", tomllib.loads(COMPLETE.replace(before, after)))

    def test_a_record_of_a_run_that_did_not_finish_says_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a.json"
            path.write_text('{"case": "a", "status": "error", "error": "b", "claims": []}')
            self.assertEqual(checks.of_record(path), {})


class Recorded(unittest.TestCase):
    def test_equivalent_changes_are_few_and_have_a_reason(self):
        with (SOURCE / "reports/record/mutation.csv").open(newline="") as file:
            rows = [row for row in csv.DictReader(file) if row["seed"] != "seeded"]
        for room in {row["room"] for row in rows}:
            outcomes = [row["outcome"] for row in rows if row["room"] == room]
            self.assertLessEqual(outcomes.count("equivalent"), 0.1 * len(outcomes), room)
        self.assertEqual([row for row in rows if (row["outcome"] == "equivalent") != bool(row["reason"])], [])


if __name__ == "__main__":
    unittest.main()
