"""A figure opened in Chromium: values under the pointer, series switched off from the keyboard, films. Skipped without it.

    /usr/bin/python3 reports/render/tests/test_answers.py
"""
import pathlib
import shutil
import tempfile
import unittest

import h5py
from made import write_arrays
from test_phone import BROWSER, found_by

from render import figures

ASSETS = pathlib.Path(figures.__file__).parent / "assets"
STEPS = """<!DOCTYPE html><body><script>
const open = source => new Promise(done => {
  const frame = document.createElement("iframe");
  frame.style = "width:1000px;height:800px";
  frame.addEventListener("load", () => done(frame.contentDocument));
  frame.src = source;
  document.body.append(frame);
});
const seen = d => [...d.querySelectorAll("[data-frame]")].filter(g => g.getAttribute("display") !== "none").map(g => g.dataset.frame);
(async () => {
  const found = {}, d = await open("PLOT"), svg = d.documentElement, about = JSON.parse(svg.dataset.figure);
  const point = (x, y) => {
    const [left, top, width, height] = about.panels[0].box, share = (v, [low, high]) => (v - low) / (high - low);
    const at = new DOMPoint(left + width * share(x, about.panels[0].x), top + height * (1 - share(y, about.panels[0].y)));
    const {x: clientX, y: clientY} = at.matrixTransform(svg.getScreenCTM());
    svg.dispatchEvent(new PointerEvent("pointermove", {clientX, clientY}));
    return d.querySelector("[role=status]").textContent;
  };
  const key = d.querySelector("[data-key]"), press = () => key.dispatchEvent(new KeyboardEvent("keydown", {key: "Enter"}));
  found.on = point(2.02, 20.2);
  press();
  found.pressed = key.getAttribute("aria-pressed");
  found.off = point(2.02, 20.2);
  found.bar = point(2.0, 24.0);
  press();
  found.on_again = point(2.02, 20.2);
  const film = await open("FILM");
  found.still = seen(film);
  const slider = film.querySelector("input");
  slider.value = 0;
  slider.dispatchEvent(new Event("input"));
  found.first = seen(film);
  const playing = await open("FILM#play");
  await new Promise(done => setTimeout(done, 500));
  found.playing = playing.querySelector("button").textContent;
  document.body.innerHTML = "<pre id=found></pre>";
  document.getElementById("found").textContent = JSON.stringify(found);
})();
</script></body>"""


@unittest.skipUnless(BROWSER, "no Chromium: no figure is asked for values")
class Answers(unittest.TestCase):
    def test_a_figure_gives_values_switches_series_and_plays(self):
        figures.prepare()
        with tempfile.TemporaryDirectory() as folder:
            place = pathlib.Path(folder, "figures", "case")
            place.mkdir(parents=True)
            shutil.copytree(ASSETS, pathlib.Path(folder, "assets"))
            line = ("computed", "computed", "line", [1, 2, 3, 4], [10, 20, 30, 40])
            data = ("measured", "data", "points", [1, 2, 4], [12, 21, 38])
            write_arrays(place / "f.h5", {"plot": [[line, data]], "film": [[line], [data], [line, data]]})
            with h5py.File(place / "f.h5", "a") as file:
                file["figures/plot/panel_00/series_01/y_error"] = [3.0, 3.0, 3.0]
            for name, drawing in (("plot", "panels"), ("film", "film")):
                self.assertEqual(figures.draw(place / "f.h5", name, drawing, False, "key", place / f"{name}.svg"), "")
            uri = place.as_uri()
            found = found_by(STEPS.replace("PLOT", f"{uri}/plot.svg").replace("FILM", f"{uri}/film.svg"))
        self.assertEqual(found["on"], "computed: 2, 20")
        self.assertEqual(found["pressed"], "false")
        self.assertEqual(found["off"], "measured: 2, 21")
        self.assertEqual(found["bar"], "measured: 2, 21")
        self.assertEqual(found["on_again"], found["on"])
        self.assertEqual(set(found["still"]), {"2"})
        self.assertEqual(set(found["first"]), {"0"})
        self.assertEqual(found["playing"], "Stop")


if __name__ == "__main__":
    unittest.main()
