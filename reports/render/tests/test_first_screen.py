"""The first screen of a report of the suite's size: its budget, and in Chromium its search, filters and order.

    /usr/bin/python3 reports/render/tests/test_first_screen.py
"""
import os
import pathlib
import re
import tempfile
import unittest

from made import claim, contest_row, contest_table, record, reported
from test_phone import BROWSER, found_by

from render import matrix

CASES, TESTS, GROUPS = 114, 430, 11      # cases as many as the suite has, checks more
PAGES, INDEX_BYTES, INDEX_NODES, SEARCH_BYTES = 180, 120_000, 2_500, 250_000
SHEET_BYTES, ALL_BYTES = 200_000, 25_000_000
SHEETS = 20                              # printed, of A4
WHOLE = pathlib.Path(os.environ.get("SEICHE_EVIDENCE", "build/release/evidence")) / "report/index.html"
RENDERER = max(file.stat().st_mtime for file in pathlib.Path(matrix.__file__).parent.glob("*.py"))
SCREENS = {1440: 3 * 900, 390: 5 * 860}     # width of a window and what its page may be high
# What a person does on the page, and what is then to be seen.
STEPS = """<!DOCTYPE html><body><script>
const found = {errors: []};
const rows = d => [...d.querySelectorAll(".grid tbody tr")].filter(r => !r.hidden).map(r => r.querySelector("a").textContent);
const open = (width, hash) => new Promise(done => {
  const frame = document.createElement("iframe");
  frame.style = `width:${width}px;height:900px;border:0`;
  frame.addEventListener("load", () => done(frame));
  frame.src = "INDEX" + hash;
  document.body.append(frame);
});
const soon = () => new Promise(done => setTimeout(done, 400));
(async () => {
  for (const width of [1440, 390]) {
    const frame = await open(width, "");
    found[width] = frame.contentDocument.documentElement.scrollHeight;
  }
  const frame = await open(1440, ""), d = frame.contentDocument, w = frame.contentWindow;
  w.addEventListener("error", e => found.errors.push(e.message));
  const find = d.getElementById("find"), type = async text => {
    find.value = text;
    find.dispatchEvent(new w.Event("input"));
    await soon();
  };
  w.dispatchEvent(new w.KeyboardEvent("keydown", {key: "/", cancelable: true}));
  found.focused = d.activeElement === find;
  await soon();
  await type("hydraulic jump");
  found.jump = rows(d);
  found.address = w.location.hash;
  await type("openfoam");
  found.openfoam = [...d.querySelectorAll("#hits a")].map(a => a.getAttribute("href"));
  w.dispatchEvent(new w.KeyboardEvent("keydown", {key: "Escape"}));
  found.all = rows(d).length;
  const box = d.querySelector("[value=exact]");
  box.click();
  found.without_exact = rows(d);
  box.click();
  d.getElementById("failures").click();
  found.flawed = rows(d);
  d.getElementById("failures").click();
  const quantity = d.querySelector("[name=quantity]");
  quantity.value = "front";
  quantity.dispatchEvent(new w.Event("change"));
  found.fronts = rows(d);
  quantity.value = "";
  d.querySelector(".grid th[data-sort=text] button").click();
  found.sorted = rows(d);
  found.linked = rows((await open(1440, "#problem=shoaling+and+breaking&q=bar&without=exact")).contentDocument);
  document.body.innerHTML = "<pre id=found></pre>";
  document.getElementById("found").textContent = JSON.stringify(found);
})();
</script></body>"""


class FirstScreen(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        claims = [claim(f"c{k}", text="The front of the bore agrees with the exact solution.") for k in range(9)]
        known = claim("known", verdict="fail", declared="fail", declared_reason="cause unknown: " + "a word of many " * 12)
        made = [record(f"case_{k}", group=f"group_{k % 14}", claims=[*claims, known], article="A word of many. " * 60)
                for k in range(CASES)]
        made += [record(f"test_{k}", kind="verification", group=f"room_{k % GROUPS}", claims=claims[:7 if k % GROUPS else 9])
                 for k in range(TESTS)]
        made += [record("drop_models", group="drop", tables=contest_table([contest_row("SPH", **{"broke by": "it stops"})]))]
        made += [record("case_3", group="group_3", solver="OpenFOAM", claims=claims)]
        folder = cls.enterClassContext(tempfile.TemporaryDirectory())
        cls.printed = pathlib.Path(folder, "report.pdf")
        cls.report = reported(folder, *made, options=["--pdf", str(cls.printed)] if BROWSER else [])

    def test_the_report_keeps_its_budget(self):
        for report in [self.report, *([WHOLE.parent] if WHOLE.exists() and WHOLE.stat().st_mtime > RENDERER else [])]:
            with self.subTest(report):
                self.assertLessEqual(len({*report.rglob("*.html")} - {report / "print.html"}), PAGES)
                index = (report / "index.html").read_text(encoding="utf-8")
                self.assertLessEqual(len(index.encode()), INDEX_BYTES)
                self.assertLessEqual(len(re.findall(r"<[a-z]", index)), INDEX_NODES)
                self.assertLessEqual((report / "assets/search.js").stat().st_size, SEARCH_BYTES)
                for page in report.glob("verification/*.html"):
                    self.assertLessEqual(page.stat().st_size, SHEET_BYTES, page)
                self.assertLessEqual(sum(file.stat().st_size for file in report.rglob("*")
                                         if file.is_file() and report / "data" not in file.parents), ALL_BYTES)

    def test_a_group_goes_on_where_a_page_of_the_verification_is_full(self):
        pages = {page.name: page.read_text(encoding="utf-8") for page in self.report.glob("verification/*.html")}
        self.assertEqual(len(pages), GROUPS + 1)
        for name in (f"test_{k}" for k in range(TESTS)):
            self.assertEqual(sum(f'<details class="test" id="{name}.seiche"' in page for page in pages.values()), 1, name)
        self.assertIn('href="../verification/room_0-2.html"', pages["room_0.html"])

    @unittest.skipUnless(BROWSER, "no Chromium: nothing is printed")
    def test_the_print_has_few_pages(self):
        self.assertLessEqual(len(re.findall(rb"/Type\s*/Page\b", self.printed.read_bytes())), SHEETS)

    @unittest.skipUnless(BROWSER, "no Chromium: search, filters and order are not tried")
    def test_what_a_reader_does_is_answered(self):
        found = found_by(STEPS.replace("INDEX", (self.report / "index.html").as_uri()))
        for width, high in SCREENS.items():
            self.assertLessEqual(found[str(width)], high)
        self.assertEqual(found["errors"], [])
        self.assertTrue(found["focused"])
        self.assertIn("Bore into still water, 2:1", found["jump"])
        self.assertNotIn("Free drop, stretched", found["jump"])
        self.assertEqual(found["address"], "#q=hydraulic+jump")
        self.assertEqual(found["openfoam"], ["cases/case_3.html"])
        problems = matrix.tomllib.loads(matrix.PROBLEMS.read_text(encoding="utf-8"))["problem"]
        self.assertEqual(found["all"], len(problems))
        self.assertEqual(found["without_exact"], [one["title"] for one in problems if one["evidence"] != "exact"])
        self.assertEqual(found["flawed"], ["Free drop, stretched"])
        self.assertEqual(found["fronts"], [one["title"] for one in problems if one["filters"]["quantity"] == "front"])
        self.assertEqual(found["sorted"], sorted(found["sorted"]))
        self.assertEqual(found["linked"], ["Submerged bar (Luth et al., A)"])


if __name__ == "__main__":
    unittest.main()
