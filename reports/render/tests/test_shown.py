"""What the pages of a report show of each record, and of each figure of the sources."""
import tomllib
import unittest

from made import REPORTS, Whole

from render import atlas


class Records(Whole):
    def test_every_record_appears(self):
        listed = self.page("cases")
        for case in ("two_solvers", "nulls", "crashed", "lost_figure"):
            self.assertTrue((self.out / "cases" / f"{case}.html").is_file(), case)
            self.assertIn(f"cases/{case}.html", listed)
        self.assertIn('id="hostile-claim-one"', self.hostile())
        for broken in ("truncated.json", "not a record.json", "incomplete.json", "two_solvers_again.json"):
            self.assertIn(broken, self.index)
        self.assertIn("tier", self.index)
        page = self.page("cases/two_solvers")
        self.assertIn("another", page)

    def test_what_is_seen_first_comes_first_and_anything_else_of_that_name_is_a_table(self):
        page = self.page("cases/two_solvers")
        self.assertLess(page.index("that of nobody"), page.index("Solver comparison</h2>"))
        self.assertNotIn('id="two_solvers.another-table-first-look"', page)
        self.assertIn('id="nulls-table-first-look"', self.page("cases/nulls"))

    def test_surprises_are_called_out_and_declared_failures_explained(self):
        alarm = self.index[self.index.index('id="unexpected"'):self.index.index('id="matrix"')]
        declared = self.page("deviations")
        self.assertIn("nulls-claim-one", alarm)
        self.assertIn("nulls-claim-surprise", alarm)
        self.assertIn("unexpected pass", alarm)
        self.assertIn("killed by signal 11", alarm)
        self.assertIn("nulls-claim-another_size", alarm)
        self.assertNotIn("nulls-claim-late", alarm)
        self.assertIn("nulls-claim-late", declared)
        self.assertIn("hostile-claim-one", declared)

    def test_records_of_sets_and_tiers_stand_on_one_page_the_best_first(self):
        page = self.page("cases/sizes")
        self.assertIn("seiche, bzz-fig-6", page)
        self.assertLess(page.index("-claim-whole"), page.index('id="sizes-claim-reduced"'))
        self.assertIn('href="#sizes-claims"', page)

    def test_tiers_stand_side_by_side(self):
        page = self.page("cases/tiers")
        self.assertIn("seiche, full", page)
        self.assertLess(page.index("tiers-full"), page.index('id="tiers-claim-one"'))

    def test_what_does_not_apply_is_said(self):
        page = self.page("cases/sharp")
        self.assertIn("1 claim does not apply at these parameters", page)

    def test_what_could_not_be_drawn_is_said(self):
        page = self.page("cases/lost_figure")
        self.assertIn("holds no figure", page)
        self.assertIn("no drawing is called", page)
        said = self.page("provenance")
        self.assertIn("no-such-tile", said)
        self.assertIn("gone.h5 cannot be read", said)
        self.assertIn("provenance.html#problems", self.index)

    def test_formulas_are_set(self):
        page = self.page("cases/two_solvers")
        self.assertIn('aria-label="x^2"', page)
        self.assertIn("<title>\\frac{a}{b}</title>", page)


class Tiles(Whole):
    def tile(self, name):
        atlas = self.page("atlas")
        return atlas[atlas.index(f'<li id="{name}"'):].split("</li>")[0]

    def test_the_word_of_a_tile_follows_from_its_runs(self):
        # No set; a verification; a surprise; a declared failure, with its proof and without.
        words = {"frank-fig-9": "not yet", "frank-table-celerity": "not yet", "bzz-fig-6": "not yet",
                 "bzz-fig-18": "not yet", "bzz-fig-15": "source contradicted", "bzz-fig-22": "reproduced",
                 "bzz-fig-23": "reproduced by another method", "bzz-fig-12": "reproduced by another method",
                 "frank-fig-4": "picture only", "sph-fig-6": "reduced size", "bzz-fig-7": "not yet"}
        for name, word in words.items():
            self.assertIn(f'<span class="word">{word}</span>', self.tile(name), name)
        counts = {word: list(words.values()).count(word) for word in words.values()}
        counts["not yet"] = 58 - len(words) + counts["not yet"]
        for page in (self.index, self.page("atlas")):
            self.assertIn(", ".join(f"{counts[word]} {word}" for word in atlas.WORDS), page)
        self.assertIn("tier paper", self.tile("sph-fig-6"))

    def test_a_tile_of_a_longer_tier_shows_the_kept_picture(self):
        self.assertIn('src="figures/sph-fig-6.webp"', self.tile("sph-fig-6"))
        self.assertTrue((self.out / "figures/sph-fig-6.webp").is_file())
        self.assertEqual(self.page("atlas").count(".webp"), 2)

    def test_a_tile_gives_the_parameters_of_its_source_and_what_differs(self):
        self.assertIn('<code>particles</code> <span class="n">12</span>', self.tile("bzz-fig-12"))
        self.assertIn("ours is 1 m deep", self.tile("bzz-fig-12"))
        self.assertIn("Stated by the source", self.tile("bzz-fig-12"))
        self.assertIn("(source: 13 &lt;b&gt;)", self.tile("bzz-fig-23"))
        self.assertNotIn("(here", self.tile("bzz-fig-12"))
        self.assertRegex(self.tile("sph-fig-6"), "<code>particles</code> <span[^>]*>12</span> <b>.here <span[^>]*>4</span>")

    def test_evidence_of_record_is_mentioned_where_the_report_has_only_less(self):
        (self.folder / "record").mkdir(exist_ok=True)
        header = "case,set,claim,kind,measured,uncertainty,expected,limit,band,verdict\n"
        table = self.folder / "record/paper.csv"
        for verdicts, expected in ((("pass", "declared fail"), {("small", "sph-fig-6"): "paper"}), (("pass", "fail"), {})):
            table.write_text(header + "".join(f"small,sph-fig-6,c{i},bound,1,,1,1,,{v}\n" for i, v in enumerate(verdicts)))
            self.assertEqual(atlas.kept_sets(self.folder / "record"), expected)
        table.write_text(header + "small,sph-fig-6,c,bound,1,,1,1,,pass\n")
        (table.parent / "long_runs.csv").write_text("tier,case,set,commit,date,seconds\npaper,small,sph-fig-6,0a1b2c3d,2026-11-27,90\n")
        self.assertEqual(atlas.kept_sets(table.parent), {("small", "sph-fig-6"): "paper, commit 0a1b2c3d of 2026-11-27"})

    def test_every_tile_of_the_atlas_appears(self):
        page = self.pages[self.out / "atlas.html"]
        sources = tomllib.loads((REPORTS / "atlas.toml").read_text(encoding="utf-8"))["source"]
        tiles = [tile["id"] for source in sources for tile in source["tile"]]
        self.assertEqual(len(tiles), len(set(tiles)))
        for tile in tiles:
            self.assertIn(tile, page.ids)
        text = self.page("atlas")
        self.assertEqual(text.count("no run"), len(tiles) - 10)


if __name__ == "__main__":
    unittest.main()
