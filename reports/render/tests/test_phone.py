"""Pages on a phone: none is wider than the screen, text has 12 pixels and contrast 4.5:1. Skipped without Chromium.
With AXE=axe.min.js of axe-core (npm pack axe-core), what that finds on any page, of this size or of a desktop's.

    /usr/bin/python3 reports/render/tests/test_phone.py
"""
import html
import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

from made import claim, contest_row, contest_table, figure, record, reported, whole, write_arrays, write_evidence

from render import pdf

WIDTH = 390     # of a phone, in pixels of a page
# Frames of that width, for a window of Chromium without a screen is at least 500 wide.
FRAMES = """<!DOCTYPE html><body>{frames}<script>
const light = colour => {{
  const [r, g, b] = colour.match(/[\\d.]+/g).map(v => v / 255).map(v => v <= .04045 ? v / 12.92 : ((v + .055) / 1.055) ** 2.4);
  return .2126 * r + .7152 * g + .0722 * b + .05;
}};
const faint = (frame, e) => {{      // text that cannot be read: too small, or too near its background
  const look = one => frame.contentWindow.getComputedStyle(one);
  let behind = e;
  while (behind.parentElement && look(behind).backgroundColor.endsWith(", 0)")) behind = behind.parentElement;
  const [text, paper] = [light(look(e).color), light(look(behind).backgroundColor)];
  return parseFloat(look(e).fontSize) < 12 || Math.max(text, paper) / Math.min(text, paper) < 4.5;
}};
addEventListener("load", () => {{
  const found = {{}};
  for (const frame of document.querySelectorAll("iframe")) {{
    const page = frame.contentDocument.documentElement;
    const names = [...frame.contentDocument.querySelectorAll("code.name")];
    const said = [...frame.contentDocument.querySelectorAll("body *:not(sup, sub, script, svg *, th > [style^=color])")].filter(
      e => e.getClientRects().length && [...e.childNodes].some(n => n.nodeType == 3 && n.textContent.trim()));
    found[frame.title] = {{faint: said.filter(e => faint(frame, e)).map(e => e.outerHTML.slice(0, 120)), width: page.scrollWidth, broken: names.filter(n => n.getClientRects().length > 1).length}};
  }}
  document.body.innerHTML = "<pre id=found></pre>";
  document.getElementById("found").textContent = JSON.stringify(found);
}});</script></body>"""
AUDIT = """<!DOCTYPE html><body><script>
(async () => {
  const found = {};
  for (const page of PAGES) for (const width of [390, 1440]) {
    const frame = document.createElement("iframe"), loaded = one => new Promise(done => one.addEventListener("load", done));
    Object.assign(frame, {src: page, style: `width:${width}px;height:900px`});
    document.body.append(frame);
    await loaded(frame);
    const script = frame.contentDocument.createElement("script");
    script.src = "AXE";
    frame.contentDocument.head.append(script);
    await loaded(script);
    const {violations} = await frame.contentWindow.axe.run(frame.contentDocument);
    for (const one of violations) found[`${page} ${width} ${one.id}`] = one.nodes.map(node => node.html.slice(0, 120));
    frame.remove();
  }
  document.body.innerHTML = "<pre id=found></pre>";
  document.getElementById("found").textContent = JSON.stringify(found);
})();</script></body>"""
AXE = pathlib.Path(os.environ.get("AXE", "no axe.min.js"))
BROWSER = pdf.find_browser()


def found_by(script):
    """What a page with a script leaves in its element `found`, as JSON."""
    with tempfile.TemporaryDirectory() as folder:
        page = pathlib.Path(folder, "script.html")
        page.write_text(script, encoding="utf-8")
        said = subprocess.run([BROWSER, *pdf.FLAGS, "--allow-file-access-from-files", "--dump-dom",
                               "--virtual-time-budget=60000", f"--user-data-dir={folder}/user", page.as_uri()],
                              capture_output=True, text=True, timeout=300, check=True).stdout
    return json.loads(html.unescape(re.search(r'<pre id="found">(.*?)</pre>', said, re.DOTALL)[1]))


def measured(report, pages):
    """{page: {"width": of its content, "broken": names on two lines, "faint": text that cannot be read}}"""
    return found_by(FRAMES.format(frames="".join(
        f'<iframe title="{page}" src="{html.escape((report / page).as_uri())}" '
        f'style="width:{WIDTH}px;height:900px;border:0"></iframe>' for page in pages)))


@unittest.skipUnless(BROWSER, "no Chromium: how wide pages are on a phone is not measured")
class Phone(unittest.TestCase):
    def test_no_page_is_wider_than_the_screen_and_no_name_is_broken(self):
        with tempfile.TemporaryDirectory() as folder:
            evidence = pathlib.Path(folder, "evidence")
            write_evidence(evidence)
            several = [{"name": f"a column with a long name {k}", "unit": "m^2/s"} for k in range(12)]
            long_names = {f"a_parameter_with_a_long_name_{k}": {"value": 0.123456789, "unit": "(g H)^(1/2)",
                                                               "default": 1.0, "meaning": "word " * 20} for k in range(9)}
            contest = [contest_row("Lagrangian mesh", **{"broke by": "the mesh tangles at node " + "1234567890" * 9})]
            write_arrays(evidence / "drop_models.h5", {"cost": [[("a", "computed", "points", [1, 2], [2, 1])]]})
            cases = ",".join(f"a_phenomenon/a_case_that_scores_others_{k}" for k in range(9))
            report = reported(
                folder, record("drop_models", group="drop", tables=contest_table(contest), figures=[figure("cost")],
                               data="drop_models.h5", parameters=long_names),
                record("wide", claims=[claim("one", text="Long_words_without_blanks_" * 6)], parameters=long_names,
                       tables=[{"id": "t", "title": "t", "caption": "c", "atlas": [], "columns": several,
                                "rows": [[1e-12] * 12]}]),
                record("wide", solver="boxes", article="$\\mathcal " + "R" * 60 + "$.",
                       measurements={"cell_size": 0.1, "eta_relative_l1": 0.2}), options=["--scorable", cases])
            pages = [str(page.relative_to(report)) for page in sorted(report.rglob("*.html"))]
            found = measured(report, pages)
            self.assertEqual(sorted(found), sorted(pages))
            self.assertEqual({page: one["width"] for page, one in found.items() if one["width"] > WIDTH}, {})
            self.assertEqual({page: one["faint"] for page, one in found.items() if one["faint"]}, {})
            self.assertEqual({page: one["broken"] for page, one in found.items() if one["broken"]}, {})

    @unittest.skipUnless(AXE.is_file(), "AXE does not name axe-core")
    def test_axe_finds_nothing(self):
        report = whole().out
        pages = [page.as_uri() for page in sorted(report.rglob("*.html"))]
        self.assertEqual(found_by(AUDIT.replace("PAGES", json.dumps(pages)).replace("AXE", AXE.resolve().as_uri())), {})


if __name__ == "__main__":
    unittest.main()
