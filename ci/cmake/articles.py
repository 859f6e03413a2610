"""Writes the opening comments of case files, articles in Markdown, as strings seiche::validation::articles::NAME.

    articles.py --output FILE.cpp CASE.cpp...
"""

import argparse
import pathlib


def article_of(source):
    text = source.read_text()
    end = text.find("*/")
    if not text.startswith("/*") or end < 3:
        raise SystemExit(f"{source} must open with its article: a comment /* ... */ in Markdown")
    return text[2:end].strip()


def literal(text):
    """One literal per line: a compiler limits the length of one and joins several."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"').split("\n")
    return "\n".join(f'    "{line}\\n"' for line in escaped[:-1]) + f'\n    "{escaped[-1]}"'


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=pathlib.Path, required=True)
    parser.add_argument("cases", type=pathlib.Path, nargs="+")
    options = parser.parse_args()
    text = "namespace seiche::validation::articles {\n\n"
    for case in options.cases:
        text += f"extern const char* const {case.stem};\nconst char* const {case.stem} =\n{literal(article_of(case))};\n\n"
    text += "}  // namespace seiche::validation::articles\n"
    # An unchanged file keeps its time: what depends on it is not compiled again.
    if not options.output.exists() or options.output.read_text() != text:
        options.output.write_text(text)


if __name__ == "__main__":
    main()
