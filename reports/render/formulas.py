"""TeX formulas as inline SVG, set by matplotlib's mathtext in the text's own face (STIX).

mathtext knows a subset of TeX; what it lacks and cases use is translated here, and a formula that it cannot set is
shown as source. The drawing takes the colour of the text, and sits on its baseline.
"""
import re

from markupsafe import Markup, escape

SIZE = 10.0   # points; lengths below are in em, so it cancels

_TRANSLATIONS = [
    (r"\\(?:text|mbox|textrm|textnormal)\s*\{([^{}]*)\}", lambda m: r"\mathrm{" + m[1].replace(" ", r"\ ") + "}"),
    (r"\\operatorname\*?\s*\{([^{}]*)\}", r"\\mathrm{\1}"),
    (r"\\(?:bigl|bigr|Bigl|Bigr|biggl|biggr|big|Big|bigg)(?![a-zA-Z])", ""),
    (r"\\(?:left|right)\s*(?=\.)\.", ""),
    (r"\\[td]?frac\s*(\d)\s*(\d)", r"\\frac{\1}{\2}"),
    (r"\\[td]frac(?![a-zA-Z])", r"\\frac"),
    (r"\\(?:lVert|rVert|Vert)(?![a-zA-Z])", r"\\|"),
    (r"\\(?:lvert|rvert|vert)(?![a-zA-Z])", "|"),
    (r"\\(?:boldsymbol|bm)(?![a-zA-Z])", r"\\mathbf"),
    (r"\\dots(?![a-zA-Z])", r"\\ldots"),
    (r"\\(sech|csch|erf|sgn|sign|Fr|Re)(?![a-zA-Z])", r"\\mathrm{\1}"),
    (r"\\(?:displaystyle|textstyle|limits|nolimits|nonumber|label\{[^}]*\})(?![a-zA-Z])", ""),
    (r"\\le(?![a-zA-Z])", r"\\leq"),
    (r"\\ge(?![a-zA-Z])", r"\\geq"),
    (r"\\to(?![a-zA-Z])", r"\\rightarrow"),
    (r"\\mathrm\s+d(?![a-zA-Z])", r"\\mathrm{d}"),
    (r"~", r"\\ "),
]


class Formulas:
    """Sets formulas, remembering results between runs."""

    def __init__(self, memo):
        self._memo = memo

    def html(self, tex, display=False):
        return Markup(self._memo("formula", ("display " if display else "inline ") + tex, lambda: _set(tex, display)))


def _set(tex, display):
    body, label = tex, ""
    tag = re.search(r"\\tag\{([^{}]*)\}", body)
    if tag:
        body, label = body.replace(tag[0], ""), f'<span class="tag">({escape(tag[1])})</span>'
    lines = [body]
    environment = re.fullmatch(r"\s*\\begin\{(aligned|align\*?|gathered|gather\*?|split|eqnarray\*?)\}"
                               r"(.*)\\end\{\1\}\s*(.*)", body, re.DOTALL)
    if environment:
        lines = [line.replace("&", " ") for line in re.split(r"\\\\", environment[2]) if line.strip()]
    try:
        drawn = [_svg(line, tex, display) for line in lines]
    except Exception:                          # mathtext raises many types; the reader gets the source instead
        drawn = [f'<code class="tex" title="formula">{escape(tex)}</code>']
    if not display:
        return "".join(drawn)
    rows = "".join(f'<span class="row">{line}</span>' for line in drawn)
    return f'<span class="display"><span class="rows">{rows}</span>{label}</span>'


def _svg(line, tex, display):
    from matplotlib.font_manager import FontProperties
    from matplotlib.textpath import TextToPath

    for pattern, replacement in _TRANSLATIONS:
        line = re.sub(pattern, replacement, line)
    if display:
        line = re.sub(r"\\frac(?![a-zA-Z])", r"\\dfrac", line)
    font = FontProperties(family="STIXGeneral", size=SIZE, math_fontfamily="stix")
    engine = TextToPath()
    source = f"${line.strip()}$"
    width, height, depth = engine.get_text_width_height_descent(source, font, ismath=True)
    vertices, codes = engine.get_text_path(font, source, ismath=True)
    vertices = [(x * SIZE / engine.FONT_SCALE, y * SIZE / engine.FONT_SCALE) for x, y in vertices]
    pad = 0.04 * SIZE
    scale = 1 / SIZE
    box = " ".join(f"{100 * side:.0f}" for side in (-pad, -(height - depth) - pad, width + 2 * pad, height + 2 * pad))
    style = (f"width:{(width + 2 * pad) * scale:.3f}em;height:{(height + 2 * pad) * scale:.3f}em;"
             f"vertical-align:{-(depth + pad) * scale:.3f}em;margin:0 {-pad * scale:.3f}em")
    label = escape(" ".join(tex.split()))
    return (f'<svg class="tex" role="img" aria-label="{label}" viewBox="{box}" style="{style}"><title>{label}</title>'
            f'<path d="{_path(vertices, codes)}"/></svg>')


def _path(vertices, codes):
    """SVG path data of a matplotlib path, y downwards, in hundredths of the unit, each point from the one before."""
    names = {1: ("M", 1), 2: ("l", 1), 3: ("q", 2), 4: ("c", 3), 79: ("z", 1)}
    parts, index, here = [], 0, (0, 0)
    while index < len(codes):
        letter, count = names[int(codes[index])]
        points = [(round(100 * x), round(-100 * y)) for x, y in vertices[index:index + count]]
        left, up = (0, 0) if letter == "M" else here
        parts.append(letter if letter == "z" else letter + " ".join(f"{x - left} {y - up}" for x, y in points))
        here = here if letter == "z" else points[-1]
        index += count
    return "".join(parts).replace(" -", "-")
