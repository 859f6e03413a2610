"""The badge is green only when every verdict is known and as declared."""
import json
import tempfile
import unittest

from made import claim, record, reported

from render import records
from render.badge import badge


def declared(verdict):
    return {"verdict": verdict, "declared": verdict, "declared_reason": "known"}


class Badge(unittest.TestCase):
    def check(self, raw, color, *words, broken=()):
        made = badge(records.cases([records.Record(f"{one['case']}.json", one) for one in raw]), broken)
        self.assertEqual((made["schemaVersion"], made["label"], made["color"]), (1, "seiche", color), made)
        self.assertEqual(made["isError"], color == "red")
        for word in words:
            self.assertIn(word, made["message"])

    def test_green_when_all_is_as_declared(self):
        self.check([record("a"), record("b")], "brightgreen", "2 of 2 claims pass")
        known = record("b", claims=[claim("one"), claim("two", **declared("fail"))])
        self.check([record("a"), known], "green", "2 of 3 claims pass, 1 declared failure")

    def test_never_green_when_a_verdict_is_not_known(self):
        self.check([], "lightgrey", "0 of 0 claims pass")
        self.check([record("a", claims=[])], "lightgrey")

    def test_red_when_anything_is_not_as_declared(self):
        for verdict in ("fail", "inconclusive", "error"):
            self.check([record("a"), record("b", claims=[claim("one", verdict=verdict)])], "red",
                       "1 of 2 claims pass", "1 unexpected")
        self.check([record("a", claims=[claim("one", declared="fail", declared_reason="thought so")])], "red",
                   "1 unexpected")
        other_size = claim("one", **declared("fail"), as_declared=False)
        self.check([record("a", claims=[other_size])], "red", "1 unexpected")
        self.check([record("a"), record("b", status="error", error="killed")], "red", "1 unfinished")
        self.check([record("a")], "red", "1 broken record", broken=[records.Broken("b.json", ["not JSON"])])

    def test_another_solver_counts_too(self):
        wrong = record("a", solver="mine", claims=[claim("one", verdict="fail")])
        self.check([record("a"), wrong], "red", "1 of 2 claims pass, 1 unexpected")

    def test_it_stands_beside_the_first_page(self):
        with tempfile.TemporaryDirectory() as folder:
            made = json.loads((reported(folder, record("a")) / "badge.json").read_text(encoding="utf-8"))
        self.assertEqual(made["message"], "1 of 1 claims pass")


if __name__ == "__main__":
    unittest.main()
