"""What people read follows the rules of the language: claims, articles, tests, help, messages, README, templates.

A claim stands alone: it begins with its quantity, has six words or more, and no other claim of its case has its words.
A limit has a number or names what it is compared with.
A figure has a title, a sentence under it, and points in each of its series.
Home-made terms give way to the field's. MOST is a ratchet: a count may fall, and is then lowered here, never rise.
"""

import collections
import json
import os
import pathlib
import re
import subprocess
import unittest

import h5py

ROOT = pathlib.Path(os.environ.get("SEICHE_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
EVIDENCE = pathlib.Path(os.environ.get("SEICHE_EVIDENCE", ROOT / "build/release/evidence"))

LEANS = re.compile(r"(It|Its|So|Nor|And|They|Their|One|None|That|Those|These|This|Neither)\b(?!-)")
LOOSE = re.compile(r"\b(is|are) told\b|earlier program|as measured|\bas (high|fast) as\b|\b(that|those) of\b|\. \(|\ball 1 ")
HOME_MADE = re.compile(
    r"\bplan (model|version)\b|still level|planted defect|broken on purpose|evidence of record|declared failure"
    r"|\btiles?\b|(?<!-)\bpublished sets?\b|\bcontest(ant)?s?\b|\bpeers?\b|\bstrangers?\b|\bleague\b|touch-?down|bit by bit"
    r"|\bto the last (bit|digit)\b|largest run-up|\bruns? through\b|\bturns? over\b|\bfolds?\b|\bfolded\b"
    r"|earlier program|\b(is|are) told\b|\brefus(e|es|ed|al|als)\b|\bjudge[sd]?\b|\b(that|those) of\b"
    r"|\bfree particles\b|\b\d+ depths\b|put upright|\bendless\b|(?<!-)\boff by\b|\btells?\b|upside down|whose it is", re.I)
# A digit, a name, a kind of reference, or a number in words.
REFERENCE = re.compile(
    r"\d|(?<!^)\b[A-Z][a-z]+|\b(exact|theor\w+|measure\w*|experiment\w*|laborator\w+|order|formula|law|identity|half|halves"
    r"|twice|third|tenth|twentieth|one|two|no|single|zero|spacing)\b")
MOST = {"leans": 0, "short": 0, "twice": 0, "loose": 0, "bare": 0, "home-made: claims": 0, "home-made: help": 0,
        "home-made: README": 0, "home-made: messages": 0, "home-made: templates": 0, "home-made: articles": 0, "home-made: tests": 0}
LITERAL = re.compile(r'//[^\n]*|"((?:\\.|[^"\\\n])*)"')


def records():
    every = (json.loads(file.read_text()) for file in sorted(EVIDENCE.glob("*.json")))
    return [record for record in every if record.get("solver") == "seiche"]


def claims():
    """(case, claim, sentence) of every record."""
    return [(f"{record['case']} {record['tier']} {record['set']}", claim["id"], claim["text"])
            for record in records() for claim in record["claims"]]


def helped():
    seiche = os.environ["SEICHE"]
    top = subprocess.run([seiche, "--help"], capture_output=True, text=True, check=True).stdout
    commands = re.findall(r"^  (\w+)  ", top, re.M)
    return [top] + [subprocess.run([seiche, name, "--help"], capture_output=True, text=True).stdout for name in commands]


def spoken(file):
    """The string literals of a C++ file that hold more than one word."""
    return [said for said in LITERAL.findall(file.read_text()) if " " in said]


class Language(unittest.TestCase):
    def held(self, rule, found):
        found = list(found)
        self.assertLessEqual(len(found), MOST[rule], "\n".join(map(str, [f"{rule}:", *found])))
        self.assertEqual(len(found), MOST[rule], f"{rule}: lower MOST to {len(found)}")

    def test_claims_stand_alone(self):
        if not any(EVIDENCE.glob("*.json")):
            self.skipTest(f"no records in {EVIDENCE}")
        every = claims()
        self.assertGreater(len(every), 500)
        uses = collections.Counter((case, text) for case, _, text in every)
        self.held("leans", (one for one in every if LEANS.match(one[2])))
        self.held("short", (one for one in every if len(one[2].split()) < 6))
        self.held("twice", (one for one in every if uses[one[0], one[2]] > 1))
        self.held("loose", (one for one in every if LOOSE.search(one[2])))
        self.held("home-made: claims", (one for one in every if HOME_MADE.search(one[2].removesuffix(f" ({one[1]})."))))

    def test_limits_have_a_number_or_a_reference(self):
        self.held("bare", (f"{record['case']} {claim['id']}: {claim['text']}"
                           for record in records() for claim in record["claims"]
                           if claim["criterion"]["kind"] in ("bound", "uncertainty", "order")
                           and not REFERENCE.search(claim["text"])))

    def test_figures_have_a_title_a_caption_and_points(self):
        wrong = []
        for record in records():
            wrong += [f"{record['case']} {one['id']}: {one['title']!r}, {one['caption']!r}"
                      for one in record["figures"] + record["tables"]
                      if one["title"].endswith(".") or one["caption"] and one["caption"][-1] not in ".:"]
            if record["figures"]:
                with h5py.File(EVIDENCE / record["data"]) as file:
                    wrong += [f"{record['case']}: {series.name} has no point"
                              for figure in file["figures"].values() for panel in figure.values()
                              for name, series in panel.items()
                              if name.startswith("series") and not series["x"].size + series["y"].size]
        self.assertEqual(wrong, [])

    def test_terms_are_the_fields(self):
        texts = {
            "README": (ROOT / "README.md").read_text().splitlines(),
            "help": [line for text in helped() for line in text.splitlines()],
            "messages": [said for room in ("command", "case", "scoring")
                         for file in sorted((ROOT / "validation" / room).glob("*.cpp")) for said in spoken(file)],
            "templates": [line for file in sorted((ROOT / "reports/render/templates").glob("*.j2"))
                          for line in re.sub(r"{[{%#].*?[}%#]}|<[^>]*>", " ", file.read_text(), flags=re.S).splitlines()],
            "tests": [said for file in sorted((ROOT / "verification").rglob("*.[ch]pp")) for said in spoken(file)],
            "articles": [" ".join(re.sub(r"`[^`]*`", "", file.read_text().split("*/")[0]).split())
                         for file in sorted((ROOT / "validation").glob("*/*.cpp")) if file.read_text().startswith("/*")],
        }
        for name, lines in texts.items():
            with self.subTest(name):
                self.held(f"home-made: {name}", (line for line in lines if HOME_MADE.search(line)))


if __name__ == "__main__":
    unittest.main()
