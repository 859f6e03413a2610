"""A report as a folder of files, of evidence with hostile and broken records in it."""
import os
import re
import sys
import unittest
import unittest.mock
import urllib.parse

from made import CACHE, Page, Whole, render, write_evidence

from render import pdf


def contents(folder):
    """Bytes of all files of a report."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


class Report(Whole):
    def test_a_report_is_made_of_whatever_there_is(self):
        self.assertEqual(self.status, 0, self.said)
        self.assertIn("index.html", self.said)

    def test_pages_are_well_formed(self):
        for path, page in self.pages.items():
            self.assertEqual(page.faults, [], path.name)
            self.assertEqual(len(page.ids), len(set(page.ids)), f"an id twice in {path.name}")

    def test_every_reference_resolves_within_the_report(self):
        for path, page in self.pages.items():
            for reference in page.references:
                address = urllib.parse.urlsplit(reference)
                self.assertEqual((address.scheme, address.netloc), ("", ""), f"{reference} leaves the report")
                target = (path.parent / urllib.parse.unquote(address.path)).resolve() if address.path else path
                self.assertTrue(target.is_relative_to(self.out.resolve()), reference)
                self.assertTrue(target.is_file(), f"{path.name}: {reference}")
                if address.fragment:
                    self.assertIn(address.fragment, self.pages[self.out / target.relative_to(self.out.resolve())].ids, reference)

    def test_hostile_text_is_printed_not_obeyed(self):
        for path, page in self.pages.items():
            text = path.read_text(encoding="utf-8")
            self.assertNotIn("<script>alert", text, path.name)
            self.assertNotIn("javascript:", "".join(page.references))
            self.assertEqual(page.names.count("script"), 1, path.name)
        self.assertIn("&lt;script&gt;alert", self.hostile())
        for path in self.out.rglob("*.svg"):
            self.assertNotIn("<script>alert", path.read_text(encoding="utf-8"), path.name)

    def test_fonts_travel_with_their_licence(self):
        self.assertIn("assets/STIXGeneral.ttf", self.pages[self.out / "index.html"].references)
        self.assertTrue((self.out / "assets/LICENSE_STIX").is_file())

    def test_figures_are_small(self):
        for path in self.out.rglob("*.svg"):
            self.assertLess(path.stat().st_size, 600_000, path.name)

    def test_records_and_arrays_travel_with_the_report(self):
        for name in ("two_solvers.json", "two_solvers.h5", "hostile.json", "truncated.json", "junit.xml"):
            self.assertEqual((self.out / "data" / name).read_bytes(), (self.evidence / name).read_bytes())

    def test_second_run_draws_nothing_and_gives_the_same_bytes(self):
        first = contents(self.out)
        cached = {path: path.stat().st_mtime_ns for path in (CACHE / "seiche/report/figures").iterdir()}
        self.assertEqual(render(self.evidence, self.out, "--with-data")[0], 0)
        self.assertEqual(contents(self.out), first)
        self.assertEqual({path: path.stat().st_mtime_ns for path in (CACHE / "seiche/report/figures").iterdir()}, cached)

    def test_a_fresh_report_elsewhere_has_the_same_bytes(self):
        self.assertEqual(render(self.evidence, self.folder / "elsewhere", "--jobs", "1", "--with-data")[0], 0)
        self.assertEqual(contents(self.folder / "elsewhere"), contents(self.out))

    def test_stale_pages_go_and_nothing_is_left_beside(self):
        evidence, out = self.folder / "changing", self.folder / "changing_report"
        write_evidence(evidence)
        render(evidence, out)
        (evidence / "nulls.json").unlink()
        render(evidence, out)
        self.assertFalse((out / "cases/nulls.html").exists())
        self.assertEqual([path.name for path in self.folder.iterdir() if path.name.startswith(".")], [])

    def test_what_is_not_a_report_is_never_replaced(self):
        precious = self.folder / "precious"
        precious.mkdir()
        (precious / "thesis.tex").write_text("work of years")
        status, said = render(self.evidence, precious)
        self.assertEqual(status, 2)
        self.assertIn("not a report", said)
        self.assertTrue((precious / "thesis.tex").exists())

    def test_a_folder_without_records_is_named(self):
        (self.folder / "empty").mkdir()
        for name in ("empty", "nowhere"):
            status, said = render(self.folder / name, self.folder / "x")
            self.assertEqual((status, len(said.splitlines())), (2, 1), said)
            self.assertIn(str(self.folder / name), said)
            self.assertFalse((self.folder / "x").exists())

    def printed(self, path):
        """Status, words and file of a report that is printed with the programs of that PATH."""
        with unittest.mock.patch.dict(os.environ, PATH=path):
            return *render(self.evidence, self.folder / "printed", "--pdf", str(self.folder / "x.pdf")), self.folder / "x.pdf"

    def test_missing_browser_is_named(self):
        status, said, _ = self.printed(str(self.folder))
        self.assertEqual(status, 2)
        self.assertIn("chromium", said)

    def test_the_whole_report_is_printed(self):
        stand_in = self.folder / "browser" / "chromium"     # prints a page as it is
        stand_in.parent.mkdir()
        stand_in.write_text(f"""#!{sys.executable}
import shutil, sys, urllib.parse
target = next(word.split("=", 1)[1] for word in sys.argv if word.startswith("--print-to-pdf="))
shutil.copy(urllib.parse.unquote(urllib.parse.urlsplit(sys.argv[-1]).path), target)
""")
        stand_in.chmod(0o755)
        status, said, file = self.printed(str(stand_in.parent))
        self.assertEqual(status, 0, said)
        text = file.read_text(encoding="utf-8")
        self.assertEqual(Page(text).faults, [])
        self.assertEqual(text.count('<div class="sheet">'), 3)      # deviations, agreement, figures of the sources
        if pdf.find_browser():
            status, said, file = self.printed(os.environ["PATH"])
            self.assertEqual(status, 0, said)
            self.assertGreater(len(re.findall(rb"/Type\s*/Page\b", file.read_bytes())), 3)


if __name__ == "__main__":
    unittest.main()
