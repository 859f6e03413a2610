"""Markdown with formulas to HTML.

Raw HTML in the text is printed, not obeyed; links lead to http(s), mailto or an anchor only; pictures are left out,
since a page may need nothing but its own folder.
"""
import contextlib
import re
import signal
import xml.etree.ElementTree as ElementTree

from markupsafe import Markup, escape

LONGEST = 5     # [s], for one text; an article of ours takes milliseconds


class TookTooLong(Exception):
    pass


@contextlib.contextmanager
def at_most(seconds):
    """Stops what runs inside by TookTooLong; regular expressions in the main thread too."""
    def stop(*_):
        raise TookTooLong
    former = signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, former)


_PLAIN = re.compile(r"[$*_`\[\]\\!<>&\n|#]|^\s*[-+\d]|  ")
_SAFE_LINK = re.compile(r"(https?://|mailto:|#)", re.IGNORECASE)


class Typesetter:
    """Turns Markdown into HTML, remembering results between runs."""

    def __init__(self, memo, formula):
        """@param formula  formula(tex, display) gives the HTML of one formula"""
        self._memo = memo
        self._formula = formula
        self._converter = None

    def block(self, text):
        """Paragraphs, lists, tables, headings (set two levels down, below the page's own)."""
        return Markup(self._memo("markdown", text, lambda: self._convert_in_time(text)))

    def _convert_in_time(self, text):
        """Converts; a text that takes the converter seconds is none that a person wrote, and is printed as it is."""
        try:
            with at_most(LONGEST):
                return self._convert(text)
        except (TookTooLong, RecursionError):
            self._converter = None      # stopped midway
            return f"<pre>{escape(text)}</pre>"

    def inline(self, text):
        """A sentence or caption, without the paragraph around it."""
        if not _PLAIN.search(text):
            return escape(text)
        html = self.block(text)
        single = re.fullmatch(r"<p>(.*)</p>", html, re.DOTALL)
        return Markup(single[1]) if single and "<p>" not in single[1] else escape(text)

    def _convert(self, text):
        if self._converter is None:
            self._converter = _converter(self._formula)
        return self._converter.reset().convert(text)


def _converter(formula):
    import markdown
    from markdown.extensions import Extension
    from markdown.inlinepatterns import InlineProcessor
    from markdown.treeprocessors import Treeprocessor

    class Formula(InlineProcessor):
        def __init__(self, pattern, md, display):
            super().__init__(pattern, md)
            self.display = display

        def handleMatch(self, match, data):
            tex = " ".join(match.group(1).split())
            html = str(formula(tex, self.display))
            after = match.group(2)
            if after:                       # punctuation stays with its formula at the end of a line
                html = f'<span class="n">{html}{after}</span>'
            return self.md.htmlStash.store(html), match.start(0), match.end(0)

    class Harmless(Treeprocessor):
        def run(self, root):
            for element in root.iter():
                heading = re.fullmatch(r"h([1-6])", element.tag if isinstance(element.tag, str) else "")
                if heading:
                    element.tag = f"h{min(6, max(3, int(heading[1]) + 1))}"
                if element.tag == "a" and not _SAFE_LINK.match(element.get("href", "")):
                    element.tag = "span"
                    element.attrib.clear()
                if element.tag == "img":
                    element.tag, element.text = "em", element.get("alt", "")
                    element.attrib.clear()
            for parent in list(root.iter()):
                for position, child in enumerate(list(parent)):
                    if child.tag == "table":
                        frame = ElementTree.Element("div", {"class": "scroll"})
                        parent.remove(child)
                        frame.append(child)
                        frame.tail, child.tail = child.tail, None
                        parent.insert(position, frame)

    class Ours(Extension):
        def extendMarkdown(self, md):
            md.preprocessors.deregister("html_block")
            md.inlinePatterns.deregister("html")
            # Above backslash escapes (180) and below code (190): TeX keeps its backslashes, code keeps its dollars.
            md.inlinePatterns.register(Formula(r"\$\$(.+?)\$\$()", md, True), "display_formula", 186)
            inline = r"(?<![\\$])\$(?![\s$])([^$]+?)(?<![\s\\])\$(?!\d)([.,;:!?)]?)"
            md.inlinePatterns.register(Formula(inline, md, False), "formula", 185)
            md.treeprocessors.register(Harmless(md), "harmless", 1)

    return markdown.Markdown(extensions=["tables", "fenced_code", "sane_lists", Ours()], output_format="html")
