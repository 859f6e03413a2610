"""The drawing of one figure of one record to SVG."""
import os
import pathlib
import re

from render.drawings import DRAWINGS


def prepare():
    """Imports matplotlib with the report's style; called once before worker processes are forked."""
    os.environ.setdefault("MPLBACKEND", "svg")
    import matplotlib
    matplotlib.use("svg")
    import matplotlib.style
    matplotlib.style.use(str(pathlib.Path(__file__).resolve().parent / "seiche.mplstyle"))
    from render import panels  # noqa: F401  (registers its drawings)


def draw(data_file, figure_id, drawing_name, small, key, target):
    """Draws one figure into `target`. Returns "" or the sentence that says why it could not be drawn."""
    import matplotlib
    import matplotlib.pyplot
    from render import arrays
    try:
        if drawing_name not in DRAWINGS:
            return f"no drawing is called “{drawing_name}”; known: {', '.join(sorted(DRAWINGS))}"
        content = arrays.read_figure(data_file, figure_id)
        matplotlib.rcParams["svg.hashsalt"] = key
        figure = DRAWINGS[drawing_name](content, small)
        target = pathlib.Path(target)
        beside = target.with_name(f"{target.name}.{os.getpid()}.new")
        figure.savefig(beside, format="svg", metadata={"Date": None, "Creator": None})
        beside.write_text(_slim(beside.read_text(encoding="utf-8")), encoding="utf-8")
        os.replace(beside, target)
        return ""
    except Exception as error:      # whatever a drawing stumbles on belongs in the report, beside the other figures
        return f"{type(error).__name__}: {error}"
    finally:
        matplotlib.pyplot.close("all")


def _slim(svg):
    """Drops what a browser does not need: comments, metadata, doctype, line indentation, digits below .1 of a point,
    names that nothing refers to, the style of markers that are alike; other names become short."""
    svg = re.sub(r"<!--.*?-->|<!DOCTYPE.*?>|<metadata>.*?</metadata>", "", svg, flags=re.DOTALL).replace("xlink:href", "href")
    svg = re.sub(r"\n\s*", "\n", svg)
    svg = re.sub(r'(<use href="[^"]*") transform="translate\(([-\d.]+) ([-\d.]+)\)"', r'\1 x="\2" y="\3"', svg)
    svg = re.sub(r' (?:d|x|y)="[^"]*"', lambda found: re.sub(r"(\.\d)\d+", r"\1", found[0]), svg)
    names = {name: f"n{k}" for k, name in enumerate(dict.fromkeys(re.findall(r'(?:href="|url\()#([^")]+)', svg)))}
    svg = re.sub(r'(href="|url\()#([^")]+)', lambda found: f"{found[1]}#{names[found[2]]}", svg)
    svg = re.sub(r' id="([^"]*)"', lambda found: f' id="{names[found[1]]}"' if found[1] in names else "", svg)
    alike = r'<use href="#([^"]+)" x="[^"]*" y="[^"]*" style="([^"]*)"/>(?:\s*<use href="#\1" x="[^"]*" y="[^"]*" style="\2"/>)+'
    return re.sub(alike, _polyline, svg)


def _polyline(run):
    """Markers that are alike as the vertices of one line."""
    points = re.findall(r' x="([^"]*)" y="([^"]*)"', run[0])
    name = f"m{run.start()}"
    return (f'<marker id="{name}" overflow="visible" markerUnits="userSpaceOnUse"><use href="#{run[1]}" style="{run[2]}"/>'
            f'</marker><path d="M{" ".join(" ".join(point) for point in points)}" style="fill: none; marker: url(#{name})"/>')
