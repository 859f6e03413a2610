"""No test and no case takes extremes in a way that forgets what is not a number.

`worst = std::max(worst, error)` keeps `worst` where the error is NaN, and is its first value where there was no error at
all. Worst, Largest, Smallest and Count (solver/seiche/samples.hpp) remember. A harmless use, such as the clipping of a
step, is written without the variable on both sides.
"""
import os
import pathlib
import re
import unittest

ROOT = pathlib.Path(os.environ.get("SEICHE_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
FOLDERS = ("validation", "verification", "reports/evidence")

CALL = re.compile(r"(?<![=!<>+\-*/])=\s*(?:std::)?(?:ranges::)?f?(?:max|min)(?:f|l)?\s*(?:<[^<>;(]*>)?\s*\(")
LITERAL = re.compile(r'//[^\n]*|/\*.*?\*/|R"([^\s()\\]*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9A-Fa-f])\'(?:\\.|[^\'\\\n])+\'',
                     re.DOTALL)
OPENING, CLOSING = "([{", ")]}"


def code_of(text):
    """The text with comments and literals blanked, at the same places."""
    return LITERAL.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)


def arguments(code, begin):
    """What stands between the bracket at `begin` and its partner, divided at commas that no further bracket holds."""
    parts, depth, first = [], 0, begin + 1
    for place in range(begin, len(code)):
        depth += (code[place] in OPENING) - (code[place] in CLOSING)
        if depth == 0 or (depth == 1 and code[place] == ","):
            parts.append(code[first:place])
            first = place + 1
        if depth == 0:
            return parts
    return []


def assigned(code, end):
    """The expression before an `=` at `end`: a variable, a member, an element, a choice in brackets."""
    place, depth = end - 1, 0
    while place >= 0 and code[place].isspace():
        place -= 1
    last = place + 1
    while place >= 0:
        character = code[place]
        depth += (character in CLOSING) - (character in OPENING)
        if depth < 0 or (depth == 0 and (character in ";{},=&|!?" or character.isspace())):
            # A bracket opens or an operator stands before it; `a .b` and `->` are not written with spaces here.
            break
        place -= 1
    return code[place + 1:last]


def plain(expression):
    """Without blanks and without brackets or dereferencing around it."""
    expression = "".join(expression.split())
    while expression.startswith("(") and expression.endswith(")") and len(arguments(expression, 0)) == 1 \
            and len(arguments(expression, 0)[0]) == len(expression) - 2:
        expression = expression[1:-1]
    return expression.removeprefix("*").removeprefix("this->")


def swallowing(text):
    """Lines of the assignments in which an extreme is taken of the variable and something else."""
    code = code_of(text)
    lines = []
    for call in CALL.finditer(code):
        given = arguments(code, call.end() - 1)
        if given and given[0].strip().startswith("{"):
            given = arguments(given[0].strip(), 0)
        if plain(assigned(code, call.start())) in map(plain, given):
            lines.append(code.count("\n", 0, call.start()) + 1)
    return lines


class Swallowing(unittest.TestCase):
    def test_no_extreme_forgets_what_is_not_a_number(self):
        found = []
        for folder in FOLDERS:
            for file in sorted((ROOT / folder).rglob("*")):
                if file.suffix in {".cpp", ".hpp"}:
                    found += [f"{file.relative_to(ROOT)}:{line}" for line in swallowing(file.read_text("utf-8"))]
        self.assertEqual(found, [], "use Worst, Largest, Smallest or Count of solver/seiche/samples.hpp")

    def test_every_form_is_noticed(self):
        for sample in ("worst = std::max(worst, error);",
                       "worst = std::max(error, worst);",
                       "worst = std::max(\n        worst, std::abs(a(i, j) - b[k]));",
                       "worst =\n    std::max(worst,\n             error);",
                       "worst = std::max({worst, std::abs(x), std::abs(y)});",
                       "worst = std::max({std::abs(x), worst});",
                       "worst = std::max<double>(worst, error);",
                       "worst = std::fmax(worst, error);",
                       "worst = fmin(error, worst);",
                       "lowest = std::min(lowest, depth);",
                       "lowest = std::ranges::min({lowest, depth});",
                       "double worst = 0; for (double e : errors) worst = std::max(worst, e);",
                       "if (wet) { worst = std::max(worst, e); }",
                       "result.worst = std::max(result.worst, e);",
                       "run->worst = std::max(run->worst, e);",
                       "*worst = std::max(*worst, e);",
                       "worst_ = std::max(this->worst_, e);",
                       "worst[k] = std::max(worst[k], e);",
                       "worst[k + 1].depth = std::max(worst[k + 1].depth, e);",
                       "errors.back() = std::max(errors.back(), e);",
                       "at(i, j) = std::max(at(i, j), e);",
                       "(left ? a : b) = std::max(left ? a : b, e);",
                       "worst=std::max(worst,e);",
                       "worst = std::max(worst /* so far */, e);  // largest"):
            with self.subTest(sample):
                self.assertEqual(len(swallowing(sample)), 1)

    def test_what_forgets_nothing_is_left_alone(self):
        for sample in ("worst.add(error);",
                       "const double step = std::min(tau, end - time);",
                       "const double larger = std::max(left, right);",
                       "x = std::max(y, z);",
                       "worst = other.worst; x = std::max(a.x, b.x);",
                       "if (worst == std::max(worst, error)) return;",
                       "// worst = std::max(worst, error)",
                       'note = "worst = std::max(worst, error);";'):
            with self.subTest(sample):
                self.assertEqual(swallowing(sample), [])


if __name__ == "__main__":
    unittest.main()
