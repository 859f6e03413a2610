"""The drawing of one figure of one record to SVG."""
import base64
import html
import io
import json
import os
import pathlib
import re



def prepare():
    """Imports matplotlib with the report's style; called once before worker processes are forked."""
    os.environ.setdefault("MPLBACKEND", "svg")
    import matplotlib
    matplotlib.use("svg")
    import matplotlib.style
    matplotlib.style.use(str(pathlib.Path(__file__).resolve().parent / "seiche.mplstyle"))
    from render import panels  # noqa: F401  (imported before the fork)


def draw(data_file, figure_id, drawing_name, small, key, target):
    """Draws one figure into `target`. Returns "" or the sentence that says why it could not be drawn."""
    import matplotlib
    import matplotlib.pyplot
    from render import arrays
    from render.panels import DRAWINGS
    try:
        if drawing_name not in DRAWINGS:
            return f"no drawing is called “{drawing_name}”; known: {', '.join(sorted(DRAWINGS))}"
        content = arrays.read_figure(data_file, figure_id)
        matplotlib.rcParams["svg.hashsalt"] = key
        figure = DRAWINGS[drawing_name](content, small)
        target = pathlib.Path(target)
        beside = target.with_name(f"{target.name}.{os.getpid()}.new")
        figure.savefig(beside, format="svg", metadata={"Date": None, "Creator": None})
        svg = _slim(beside.read_text(encoding="utf-8"), len(content["panels"]) - 1)
        beside.write_text(svg if small else _answering(svg, figure, content), encoding="utf-8")
        os.replace(beside, target)
        return ""
    except Exception as error:      # whatever a drawing stumbles on belongs in the report, beside the other figures
        return f"{type(error).__name__}: {error}"
    finally:
        matplotlib.pyplot.close("all")


def _answering(svg, figure, content):
    """With the labels of the series and the place and range of every panel, in points from above, for assets/figure.js."""
    from render.looks import Looks
    width, height = (72 * size for size in figure.get_size_inches())
    panels = []
    for axis in (axis for axis in figure.axes if (axis.get_gid() or "").startswith("panel")):
        box = axis.get_position()
        panels.append({"box": [box.x0 * width, (1 - box.y1) * height, box.width * width, box.height * height],
                       "x": axis.get_xlim(), "y": axis.get_ylim(), "log": [axis.get_xscale() == "log", axis.get_yscale() == "log"]}
                      if axis.axison else None)
    about = json.dumps({"labels": Looks(content["panels"]).labels(), "panels": panels})
    return svg.replace("<svg ", f'<svg data-figure="{html.escape(about)}" ', 1).replace(
        "</svg>", '<script href="../../assets/figure.js"/></svg>')


def _slim(svg, last):
    """Drops what a browser does not need: comments, metadata, doctype, line indentation, digits below .1 of a point,
    names that nothing refers to, the style of markers that are alike; other names become short, and those of panels.py
    data. Of a film's frames all but the last are hidden."""
    svg = re.sub(r' id="((?:[a-z]+-\d+ ?)+)"', lambda found: "".join(
        f' data-{what}="{number}"' + ' display="none"' * (what == "frame" and int(number) != last)
        for what, number in re.findall(r"([a-z]+)-(\d+)", found[1])), svg)
    svg = re.sub(r"<!--.*?-->|<!DOCTYPE.*?>|<metadata>.*?</metadata>", "", svg, flags=re.DOTALL).replace("xlink:href", "href")
    svg = re.sub(r"\n\s*", "\n", svg)
    svg = re.sub(r'(<use href="[^"]*") transform="translate\(([-\d.]+) ([-\d.]+)\)"', r'\1 x="\2" y="\3"', svg)
    svg = re.sub(r' (?:d|x|y)="[^"]*"', lambda found: re.sub(r"(\.\d)\d+", r"\1", found[0]), svg)
    names = {name: f"n{k}" for k, name in enumerate(dict.fromkeys(re.findall(r'(?:href="|url\()#([^")]+)', svg)))}
    svg = re.sub(r'(href="|url\()#([^")]+)', lambda found: f"{found[1]}#{names[found[2]]}", svg)
    svg = re.sub(r' id="([^"]*)"', lambda found: f' id="{names[found[1]]}"' if found[1] in names else "", svg)
    svg = re.sub(r"data:image/png;base64,([^\"]+)", _webp, svg)
    alike = r'<use href="#([^"]+)" x="[^"]*" y="[^"]*" style="([^"]*)"/>(?:\s*<use href="#\1" x="[^"]*" y="[^"]*" style="\2"/>)+'
    return re.sub(alike, _polyline, svg)


def _webp(found):
    """A painted surface, in a tenth of the bytes."""
    import PIL.Image
    held = io.BytesIO()
    PIL.Image.open(io.BytesIO(base64.b64decode(found[1]))).save(held, "WEBP", quality=80)
    return "data:image/webp;base64," + base64.b64encode(held.getvalue()).decode()


def _polyline(run):
    """Markers that are alike as the vertices of one line."""
    points = re.findall(r' x="([^"]*)" y="([^"]*)"', run[0])
    name = f"m{run.start()}"
    return (f'<marker id="{name}" overflow="visible" markerUnits="userSpaceOnUse"><use href="#{run[1]}" style="{run[2]}"/>'
            f'</marker><path d="M{" ".join(" ".join(point) for point in points)}" style="fill: none; marker: url(#{name})"/>')
