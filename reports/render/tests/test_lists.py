"""Lists that pages are made of, and what a report keeps: shares of limits, the search, cases in their order, stores, files."""
import json
import math
import os
import pathlib
import tempfile
import time
import types
import unittest
import unittest.mock

from made import claim, figure, published, record, write_arrays
from test_shapes import judged, of

from render import (arrays, atlas, command, coverage, files, gallery, league, matrix, pictures, power, printed, records, report,
                    search, sharpness, speed, store, text)


class Lists(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def test_the_share_of_a_limit(self):
        for one, wanted in ((judged(1.5, 1.0, 2.0), 0.25), (judged(0.5, 1.0, 2.0, uncertainty=0.5), 0.5),
                            (judged(0.5, 1.0, 2.0, "uncertainty", 0.5), 0.25),
                            (judged(1.5, 1.0, 2.0, "order", 0.5), 0.5), (judged(1.5, 1.0, 2.0, "roundoff", 0.5), 0.5),
                            (judged(1.5, 1.0, 2.0, verdict="fail"), None),
                            (judged(1.0, 1.0, 1.0, "qualitative"), None), (judged(None, 1.0, 1.0), None),
                            (judged(1.0, None, 1.0), None), (judged(1.0, 1.0, 0.0), None),
                            (judged(math.inf, 1.0, 1.0), None), (judged(1.5, 1.0, 2.0, uncertainty=None), 0.25)):
            self.assertEqual(sharpness.share(one), wanted)
        shares = (0.0, 0.5e-4, 1e-4, 0.005, 0.01, 0.1, 0.3, 0.89, 0.9, 1.0)
        told = sharpness.survey([of(claims=[judged(share, 0.0,
                                                   1.0).raw for share in shares] + [judged(0.5, 0.0, 1.0, "order").raw])])
        self.assertEqual(told["columns"], ["0", "below 0.0001", "0.0001 to 0.001", "0.001 to 0.01", "0.01 to 0.1", "0.1 to 0.3",
                                           "0.3 to 0.6", "0.6 to 0.9", "0.9 to 1"])
        self.assertEqual(told["kinds"], {"bound": [1, 1, 1, 1, 1, 1, 1, 1, 2], "order": [0, 0, 0, 0, 0, 0, 1, 0, 0]})
        self.assertEqual((told["count"], told["exact"], [one.share for one in told["marginal"]],
                          [one.share for one in told["loose"]]), (11, 1, [1], [0.5e-4, 1e-4, 0.005]))

    def test_power_has_a_column_for_each_change_with_a_size(self):
        def row(change, by="a", unit="1", quantity="eta", table="wall"):
            return {"table": table, "quantity": quantity, "change": change, "by": by, "smallest": "0.04", "amount": "0.0213",
                    "unit": unit}
        table = power.table([row("amplitude"), row("datum", unit="m"), row("shift", by=""), row("amplitude", quantity="u"),
                             row("mirror"), row("noise", by=""), row("copy", by="same"),
                             row("other", table="")])
        self.assertEqual([column["name"] for column in table["columns"]], ["table", "quantity", "amplitude", "datum", "shift"])
        self.assertEqual(table["rows"], [["wall", "eta", "4 %", "4 % (0.021 m)", "not detected"], ["wall", "u", "4 %", "", ""]])
        self.assertTrue(table["caption"].endswith("without a size: detected: mirror (wall); not detected: noise (wall)."))

    def test_the_index_of_the_search_has_each_word_once(self):
        case = records.Case("long_wave", [of(case="long_wave", group="dam_break", source="Ritter", title="A <wave>",
                                             article="Ritter's depth of a wave " + " ".join(f"word{k}x" for k in range(70)))])
        test = records.Case("t", [of(case="t", kind="verification", source="Stoker", title="T")])
        found = types.SimpleNamespace(title="P", id="p", words="Big", quantity="Front", group="drop")
        model = {"title": "M", "id": "m", "equations": "Euler", "avoid": "Foam"}
        search.write(self.folder / "deep/search.js", {"problems": [found], "models": [model], "synonyms": {"a": "b"}},
                     [case, test])
        said = (self.folder / "deep/search.js").read_text()
        self.assertNotIn("<", said)
        index = json.loads(said.removeprefix("window.searchIndex=").removesuffix(";\n"))
        words = index["entries"].pop(2)
        self.assertEqual(index, {"entries": [["P", "problems/p.html", "big front drop"], ["M", "models/m.html", "euler foam"],
                                             ["T", "verification/bore.html#c", "stoker"]], "synonyms": {"a": "b"}})
        self.assertEqual(words[:2], ["A <wave>", "cases/long_wave.html"])
        self.assertEqual(words[2].split()[:8], ["long", "wave", "dam", "break", "ritter", "seiche", "defect", "depth"])
        self.assertEqual(words[2].split()[-1], "word58x")      # sixty of the article

    def test_speeds_are_numbers_or_a_word(self):
        row = {"program": "p", "benchmark": "b/4/iterations:4/real_time", "nanoseconds_per_item": "0.5", "of_peak": "adaptive",
               "processor": "a", "date": "d"}
        told = speed._numbers(row)
        self.assertEqual(told, {**row, "benchmark": "b/4", "nanoseconds_per_item": 0.5, "of_peak": None, "bytes_per_item": None,
                                "not_counted": "adaptive"})
        self.assertEqual((speed._numbers({**row, "of_peak": "0.5"})["not_counted"], speed._number("")), ("", None))
        other = {**told, "program": speed.MACHINE, "processor": "b", "date": "c"}
        found = speed.survey([told, other], ["x"])
        self.assertEqual(found, {"machine": [other], "build": ["x"], "programs": {"p": [told]}, "count": 2,
                                 "processors": ["a", "b"], "dates": ["c", "d"]})

    def test_regimes_come_from_a_case_or_from_numbers(self):
        own = {"wave": of(parameters={"a": {"value": 0.2}, "h": {"value": 2.0}}), "gone": None}
        for said, wanted in (({}, (None, None, None)), ({"height": 0.1}, (None, 0.1, None)),
                             ({"case": "wave", "height": "a", "depth": "h", "length": 10.0}, (0.4 * math.pi, 0.1, 2.5)),
                             ({"case": "wave", "height": "a", "both": True}, (None, 0.4, None)),
                             ({"case": "gone", "height": 0.1}, (None,) * 3), ({"case": "wave", "height": "b"}, (None,) * 3),
                             ({"length": math.pi}, (2, None, None))):
            found = matrix._regime(said, own)
            for name, value in zip(("kh", "H/h", "Ur"), wanted):
                self.assertEqual(found[name], value if value is None else unittest.mock.ANY)
                self.assertAlmostEqual(found[name] or 0, value or 0)
        for error, shade in ((None, 0), (0.0099, 0), (0.01, 1), (0.05, 2), (0.1, 3), (0.25, 4)):
            self.assertEqual(matrix.Cell(None, "", error, None, 1).shade, shade)
        self.assertEqual([[(one.phenomenon, one.name, one.case) for one in members] for _,
                          members in matrix.scorable("b/x,a/y,b/z", [types.SimpleNamespace(name="z")])][0],
                         [("a", "y", None)])

    def test_what_the_report_could_not_show_is_a_sentence(self):
        one, two = of(figures=[figure("f"), figure("g")], fields="c.xdmf"), of(digest="0" * 64, figures=[figure("f")])
        two.stem = "two"
        drawn = {("c", "f"): gallery.Drawn(problem="torn"), ("c", "g"): gallery.Drawn(),
                 ("two", "f"): gallery.Drawn(problem="unread")}
        surveys = {"c": {"problem": ""}, "two": {"problem": "unread"}}
        self.assertEqual([said for _, said in report._problems([one, two], surveys, drawn, [(one, "no-tile")], self.folder)], [
            "figure “f”: torn", "c.xdmf is missing", "it carries no digest: a change after it was written would not be seen",
            "unread", "no tile of the atlas is called “no-tile”"])
        (self.folder / "c.xdmf").touch()
        sealed = of(digest="0" * 64, fields="c.xdmf", files={"c.xdmf": "other"})
        self.assertEqual([said for _, said in report._problems([sealed], {"c": {"problem": ""}}, {}, [], self.folder)],
                         ["c.xdmf is not the file that was written with the record: its digest differs"])

    def test_the_menu_and_the_pages_of_cases_lead_to_their_neighbours(self):
        self.assertEqual([name for name, _ in report._menu(True)],
                         ["index.html", "cases.html", "agreement.html", "atlas.html", "league.html", "deviations.html",
                          "quality.html", "reading.html"])
        self.assertNotIn("league.html", [name for name, _ in report._menu(False)])
        cases = [records.Case(name, [of(case=name, kind=kind)]) for name,
                 kind in (("a", "validation"), ("b", "validation"), ("c", "validation"), ("v", "verification"))]
        told, broken = [], []
        for case in cases:
            report._made(case, cases, {}, {}, lambda template, page, root,
                         **more: told.append((page, root, more["before"], more["after"])), broken)
        self.assertEqual(told, [("cases/a.html", "../", None, cases[1]), ("cases/b.html", "../", cases[0], cases[2]),
                                ("cases/c.html", "../", cases[1], None)])

        def fails(template, page, root, **more):
            if template == "case.html.j2":
                raise ValueError("torn")
            told.append((template, page, more["reason"]))
        self.assertFalse(report._made(cases[0], cases, {}, {}, fails, broken))
        self.assertEqual((told[-1], broken[0].file, broken[0].reasons),
                         (("broken.html.j2", "cases/a.html", "ValueError: torn"), "c.json",
                          ["page not made: ValueError: torn"]))

    def test_records_are_ordered_and_named(self):
        def case(**changes):
            return records.cases([of(**one) for one in ({"solver": "b"}, {"solver": "a"}, {}, {"tier": "paper"},
                                                        {"tier": "full"},
                                                        {"set": "s", "published": [{"here": True, "tiles": []}]})])[0]
        self.assertEqual([one.by for one in case().records], ["seiche, s", "seiche, paper", "seiche, full", "seiche", "a", "b"])
        self.assertTrue(case().peers)
        verdicts = {"error": of(status="error", claims=[]), "none": of(claims=[]),
                    "fail": of(claims=[claim("a"), claim("b", verdict="fail"), claim("c", verdict="inconclusive")]),
                    "inconclusive": of(claims=[claim("a", verdict="inconclusive"), claim("b")]), "pass": of()}
        self.assertEqual([one.worst for one in verdicts.values()], list(verdicts))
        self.assertEqual([one.unexpected for one in verdicts.values()], [True, False, True, True, False])
        shown = [figure("f", atlas=["t"]), figure("g")]
        for changes, names in (({}, "fg"), ({"kind": "verification"}, "f"),
                               ({"kind": "verification", "claims": [claim("a", verdict="fail")]}, "fg"),
                               ({"kind": "verification", "claims": [claim("a", "order")]}, "fg")):
            self.assertEqual([one["id"] for one in of(figures=shown, **changes).shown], list(names))
        self.assertEqual([of(parameters={"a": {"value": 1, "default": default}}, set=name).standard for default,
                          name in ((1, ""), (2, ""), (2, "s"))], [True, False, True])
        self.assertEqual((records.slug("a b"), records.slug("a.b-c_1")), (f"a-b-{store.digest('a b')[:6]}", "a.b-c_1"))
        several = of(kind="verification", group="a")
        several.sheet = "-2"
        self.assertEqual(several.page, "verification/a-2.html")
        self.assertEqual(of(atlas=["x"], figures=[figure("f", atlas=["y"])], tables=[{"atlas": ["x", "z"]}]).tiles,
                         ["x", "y", "z"])

    def test_a_strip_takes_as_many_of_each_source_as_there_is_room_for(self):
        def tiles(name, count, picture=True):
            return [atlas.Tile(f"{name}{k}", "figure", "", "", "", picture=(1,) if picture else None) for k in range(count)]
        shown = [({}, tiles("a", 9)), ({}, tiles("b", 9)), ({}, tiles("c", 2)), ({}, tiles("d", 5, False))]
        self.assertEqual([tile.id for tile in atlas.strip(shown)], ["a0", "a1", "a2", "b0", "b1", "b2", "c0", "c1"])
        self.assertEqual(atlas.strip([]), [])

    def test_a_store_keeps_what_is_used_and_drops_what_is_not(self):
        kept = store.Store(self.folder, "r")
        self.assertEqual([kept.memo("k", "a", lambda: made) for made in (1, 2)], [1, 1])
        self.assertEqual(kept.memo("k", "b", lambda: 3), 3)
        kept.save()
        again = store.Store(self.folder, "r")
        self.assertEqual([again.memo("k", "a", lambda: 9), again.memo("l", "a", lambda: 9)], [1, 9])
        again.save()
        self.assertEqual(store.Store(self.folder, "other").memo("k", "a", lambda: 7), 1)       # begins with the latest
        self.assertEqual(store.Store(self.folder, "r").memo("k", "b", lambda: 5), 5)           # no longer used
        old, new = (self.folder / "figures" / f"{name}.svg" for name in ("old", "new"))
        for path, days in ((old, 31), (new, 29)):
            path.touch()
            os.utime(path, 2 * (time.time() - 86400 * days,))
        self.assertEqual((again.figure("new"), again.figure("none").exists()), (new, False))
        self.assertLess(abs(new.stat().st_atime - time.time()), 60)
        again.save()
        self.assertEqual((old.exists(), new.exists()), (False, True))
        self.assertNotEqual(store.digest("a", "bc"), store.digest("ab", "c"))
        self.assertEqual((store.digest("é"), len(store.digest())), (store.digest("é".encode()), 40))
        (self.folder / "torn").mkdir()
        (self.folder / "torn" / f"texts-{store.digest('')}.json").write_text("{")
        self.assertEqual(store.Store(self.folder / "torn").memo("k", "a", lambda: 4), 4)

    def test_files_of_strangers_are_regular_and_not_too_large(self):
        path = self.folder / "a.json"
        path.write_bytes(b"x" * 10)
        with unittest.mock.patch.object(files, "LARGEST_RECORD", 10):
            self.assertEqual(files.read_text(path), 10 * "x")
        with unittest.mock.patch.object(files, "LARGEST_RECORD",
                                        9), self.assertRaisesRegex(ValueError, "10 bytes, more than the 9"):
            files.read_text(path)
        (self.folder / "link").symlink_to(path)
        self.assertEqual([files.is_regular(self.folder / name) for name in ("a.json", "link", "none", ".")],
                         [True, False, False, False])
        with self.assertRaisesRegex(ValueError, "not a regular file"):
            files.read_text(self.folder / "link")

    def test_a_picture_is_drawn_of_the_first_record_of_a_longer_tier_with_the_parameters_of_the_source(self):
        for name, tier, here in (("a", "full", True), ("b", "quick", True), ("c", "paper", False)):
            one = record(name, tier=tier, data=f"{name}.h5", figures=[figure("f", atlas=[f"tile-{name}"])],
                         published=published(f"tile-{name}", here))
            (self.folder / f"{name}.json").write_text(json.dumps(one))
            write_arrays(self.folder / f"{name}.h5", {"f": [[("a", "computed", "line", [0, 1], [0, 1])]]})
        self.assertEqual(pictures.draw(self.folder, self.folder / "kept"), ["tile-a"])
        with unittest.mock.patch.object(pictures, "KEPT", self.folder / "kept"):
            self.assertEqual((pictures.of("tile-a"), pictures.of("tile-b")), (self.folder / "kept/tile-a.webp", None))

    def test_formulas_stand_with_their_source_and_the_claims_of_their_cases(self):
        path = self.folder / "formulas.toml"
        path.write_text('[[formula]]\nsource = "b"\nclaims = ["c: one*", "gone: x"]\n[[formula]]\nsource = "a"\n')
        case = records.Case("c", [of(claims=[claim("one-1"), claim("two")])])
        others = [records.Case("c", [of(solver="theirs", claims=[claim("one")])]),
                  records.Case("d", [of(case="d", claims=[claim("one")])])]
        told = printed.survey([({"id": "a"}, []), ({"id": "b"}, [])], [case, *others], path)
        self.assertEqual([(source["id"], [[one.id for _, one in claims] for _, claims in found]) for source, found in told],
                         [("a", [[]]), ("b", [["one-1"]])])

    def test_rooms_want_nine_of_ten_lines(self):
        rows = [("solver/seiche/io/a.cpp", 10, 9), ("solver/seiche/io/b.cpp", 20, 10), ("solver/seiche/io/c.cpp", 10, 4),
                ("solver/seiche/b/a.cpp", 10, 9), ("ci/a/b/c.py", 1, 1), ("solver/a/b.cpp", 1, 1)]
        rooms = {room.name: room for room in coverage.survey(rows)}
        self.assertEqual(list(rooms), ["ci/a", "solver/a", "solver/seiche/b", "solver/seiche/io"])
        self.assertEqual([room.wanting for room in rooms.values()], [False, False, False, True])
        self.assertEqual([file for file, _, _ in rooms["solver/seiche/io"].behind],
                         ["solver/seiche/io/b.cpp", "solver/seiche/io/c.cpp"])
        self.assertEqual(rooms["solver/seiche/io"].share, 23 / 40)

    def test_arrays_are_listed_and_figures_known_by_all_that_is_in_them(self):
        def digest(label="a", x=(0, 1), y=(0, 1)):
            write_arrays(self.folder / "a.h5", {"f": [[(label, "computed", "line", x, y)]]})
            return arrays.survey(self.folder / "a.h5")
        first = digest()
        self.assertEqual([(one["name"], one["shape"], one["type"], one["unit"]) for one in first["arrays"]],
                         [("depth", [3, 4], "float64", "m")])
        found = [digest(**more)["figures"]["f"] for more in ({}, {"label": "b"}, {"x": (0, 2)}, {"y": (0, 2)},
                                                             {"x": (0, 1, 2)})]
        self.assertEqual((found[0], len(set(found))), (first["figures"]["f"], 5))
        digest()
        (panel,) = arrays.read_figure(self.folder / "a.h5", "f")["panels"]
        self.assertEqual((panel["x_label"], panel["series"][0]["label"], list(panel["series"][0]["x"])), ("x [m]", "a", [0, 1]))
        for most, fits in ((4, True), (3, False)):
            with unittest.mock.patch.object(arrays, "LARGEST_FIGURES", most):
                if fits:
                    arrays.survey(self.folder / "a.h5")
                else:
                    with self.assertRaisesRegex(ValueError, "declare 4 numbers, more than 3"):
                        arrays.survey(self.folder / "a.h5")

    def test_a_row_of_the_league_has_each_number_in_its_column(self):
        one = of(solver="boxes", case="wave", measurements={"cell_size": 0.05, "ladder_order_h": 1.5}, wall_time=7.0, standing={
            "settings": "a=1", "errors": {"h": 0.25, "eta": 0.125}}, claims=[claim("a"), claim("b", verdict="fail")])
        eta, h = league.rows_of(one, {"boxes": "2.1"})
        self.assertEqual(list(h.values()), ["wave", "a=1", "h", "boxes", "2.1", "0.05", "0.25", "1.5", "7", 1, 2, "a processor",
                                            "2026-01-02"])
        self.assertEqual((eta["quantity"], eta["error"], eta["order"]), ("eta", "0.125", ""))
        own = of(parameters={"scheme": {"value": "roe"}, "cell": {"value": 0.5}}, wall_time=0.0,
                 standing={"settings": "", "errors": {"h": 0.1}})
        (row,) = league.rows_of(own, {})
        self.assertEqual((row["solver"], row["version"], row["cell"], row["seconds"], row["machine"]),
                         ("seiche roe", "1.0", "0.5", "", ""))
        other = records.Case("c", [of(solver="theirs", standing={"settings": "", "errors": {"h": 0.2}})])
        kept = league.stored(self.folder / "none.csv")
        self.assertEqual((kept, [len(league.survey([records.Case("c", [one])])) for one in (of(), other.first)]), ({}, [0, 1]))

    def test_options_of_the_command_have_their_defaults(self):
        options = command._options(["evidence"])
        self.assertEqual((options.out, options.jobs, options.pdf, options.with_data, options.scorable),
                         (None, min(2, os.cpu_count()), None, False, ""))
        self.assertEqual(command._options(["e", "--jobs", "1"]).jobs, 1)
        with self.assertRaises(SystemExit), unittest.mock.patch("sys.stderr"):
            command._options(["e", "--jobs", "0"])
        stage, out = self.folder / "stage", self.folder / "out"
        for name in ("first", "second"):
            stage.mkdir()
            (stage / name).touch()
            command._swap(stage, out)
            self.assertEqual([path.name for path in self.folder.rglob("*")], ["out", name])

    def test_a_figure_that_cannot_be_drawn_has_a_sentence(self):
        for name, kind, words in (("g", "panels", "Unable|KeyError"),
                                  ("f", "none", "no drawing is called “none”; known: film, panels")):
            write_arrays(self.folder / "a.h5", {"f": [[("a", "computed", "line", (0, 1), (0, 1))]]})
            self.assertRegex(gallery._draw([(str(self.folder / "a.h5"), name, kind, False, "k", str(self.folder / "x.svg"))],
                                           1)["k"], words)
        self.assertEqual((gallery._draw([], 1), gallery._version("no-such-package")), ({}, "none"))

    def test_articles_are_set_and_harmless(self):
        setter = text.Typesetter(lambda kind, key, make: make(), lambda tex, display: f"<f>{tex}{display}</f>")
        for said, wanted in (("# A", "<h3>A</h3>"), ("##### A", "<h6>A</h6>"), ("###### A", "<h6>A</h6>"),
                             ("$a$, $$b$$", "<p><span class=\"n\"><f>aFalse</f>,</span> <f>bTrue</f></p>"),
                             ("5$ and $6", "<p>5$ and $6</p>"),
                             ("`$b$`", "<p><code>$b$</code></p>"), ("[a](http://b)", '<p><a href="http://b">a</a></p>'),
                             ("[a](file:b)", "<p><span>a</span></p>"),
                             ("[a](#b)", '<p><a href="#b">a</a></p>'), ("![p](q)", "<p><em>p</em></p>"),
                             ("a|b\n-|-\n1|2\n\nc", None), ("<b>x</b>", "<p>&lt;b&gt;x&lt;/b&gt;</p>")):
            found = setter.block(said)
            if wanted is None:
                self.assertRegex(found, r'(?s)^<div class="scroll"><table>.*</table>\s*</div>\s*<p>c</p>$')
            else:
                self.assertEqual(found, wanted)
        for said, wanted in (("plain", "plain"), ("a < b", "a &lt; b"), ("*a*", "<em>a</em>"), ("a\n\nb", "a\n\nb"),
                             ("- a", "- a")):
            self.assertEqual(setter.inline(said), wanted)
        with unittest.mock.patch.object(text, "LONGEST", 0.05):
            slow = text.Typesetter(lambda kind, key, make: make(), lambda tex, display: time.sleep(1))
            self.assertEqual(slow.block("$a$ <"), "<pre>$a$ &lt;</pre>")


if __name__ == "__main__":
    unittest.main()
