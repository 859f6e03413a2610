"""Sets the formulas of Doxygen's pages as the report sets its own: drawn, so that they show without a network.

    python3 set_formulas.py HTML_FOLDER

Also names a header's page by its path: a dozen are called flow.hpp. Status 1 if a formula cannot be set.
"""
import html
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "reports"))
from render.formulas import Formulas  # noqa: E402

_MATHJAX = re.compile(r'<script [^>]*(?:mathjax-config|MathJax\.js)[^>]*>.*?</script>\n?', re.DOTALL)
_FORMULA = re.compile(r'<p class="formulaDsp">\s*\\\[(?P<display>.*?)\\\]\s*</p>|\\\((?P<inline>.*?)\\\)', re.DOTALL)
_FOLDER = re.compile(r'<li class="navelem"><a [^>]*>([^<]*)</a></li>')
_BIG = re.compile(r'(\\(?:sum|int)(?:_\{[^{}]*\}|_\w)?(?:\^\{[^{}]*\}|\^\w)?)(?![\w_^])')
_HEADER_TITLE = re.compile(r'([\w.]+\.hpp) File Reference')


def main(folder):
    memory = {}
    unset = set()

    def remember(kind, key, make):
        if key not in memory:
            memory[key] = make()
        return memory[key]

    formulas = Formulas(remember)

    def drawn(match):
        display = match["display"] is not None
        tex = " ".join(html.unescape(match["display"] if display else match["inline"]).split())
        result = str(formulas.html(_BIG.sub(r"\1\\,", tex), display))  # mathtext sets sums too close
        if 'class="tex" title="formula"' in result:
            unset.add(tex)
        return result

    for page in sorted(folder.glob("*.html")):
        text = old = page.read_text(encoding="utf-8")
        text = _MATHJAX.sub("", text)
        if not page.name.endswith("_source.html"):
            text = _FORMULA.sub(drawn, text)
        path = "/".join(_FOLDER.findall(text))
        if path.endswith(".hpp"):
            text = _HEADER_TITLE.sub(path, text)
        if text != old:
            page.write_text(text, encoding="utf-8")
    for tex in sorted(unset):
        print(f"set_formulas.py: cannot set {tex}", file=sys.stderr)
    return 1 if unset else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
