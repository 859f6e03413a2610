"""The drawing of one figure of one record to SVG."""
import os
import pathlib

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
    the style of markers that are alike."""
    import re
    svg = re.sub(r"<!--.*?-->|<!DOCTYPE.*?>|<metadata>.*?</metadata>", "", svg, flags=re.DOTALL)
    svg = re.sub(r"\n\s*", "\n", svg)
    svg = re.sub(r' (?:d|x|y)="[^"]*"', lambda found: re.sub(r"(\.\d)\d+", r"\1", found[0]), svg)
    alike = r'<use xlink:href="([^"]+)" x="[^"]*" y="[^"]*" style="([^"]*)"/>(?:\s*<use xlink:href="\1" x="[^"]*" y="[^"]*" style="\2"/>)+'
    return re.sub(alike, lambda run: f'<g style="{run[2]}">' + run[0].replace(f' style="{run[2]}"', "") + "</g>", svg)
