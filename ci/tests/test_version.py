"""The version is said once, in CMakeLists.txt; CITATION.cff and the newest entry of CHANGELOG.md follow it."""
import os
import pathlib
import re
import unittest

ROOT = pathlib.Path(os.environ.get("SEICHE_SOURCE", pathlib.Path(__file__).resolve().parents[2]))


def found(pattern, file):
    """What the pattern's group holds at its first match in the file, else None."""
    match = re.search(pattern, (ROOT / file).read_text(encoding="utf-8"), re.MULTILINE)
    return match and match[1]


VERSION = found(r"^project\(seiche VERSION (\d+\.\d+\.\d+)\b", "CMakeLists.txt")


class Version(unittest.TestCase):
    def test_said_once(self):
        self.assertIsNotNone(VERSION)

    def test_citation(self):
        self.assertEqual(found(r"^version: (\S+)$", "CITATION.cff"), VERSION)

    def test_changelog(self):
        self.assertEqual(found(r"^## \[([^\]]+)\] - ", "CHANGELOG.md"), VERSION)

    def test_date_of_release(self):
        date = found(r"^## \[[^\]]+\] - (\S+)$", "CHANGELOG.md")
        self.assertRegex(date or "", r"^(unreleased|\d{4}-\d{2}-\d{2})$")
        self.assertEqual(found(r"^date-released: (\S+)$", "CITATION.cff"), None if date == "unreleased" else date)


if __name__ == "__main__":
    unittest.main()
