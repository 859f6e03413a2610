"""Marks of solvers in drawings.

    /usr/bin/python3 reports/render/tests/test_marks.py
"""
import unittest
import xml.etree.ElementTree

import made  # noqa: F401  (finds render)

from render import marks


class Marks(unittest.TestCase):
    def test_marks_of_many_solvers_differ(self):
        self.assertEqual(len({(one.colour, one.letter) for one in map(marks.mark, range(24))}), 24)
        drawn = {marks.mark(number).svg(10, 20, 3, "a='b'", "<title>t</title>") for number in range(24)}
        self.assertEqual(len(drawn), 24)
        for one in drawn:
            self.assertEqual(xml.etree.ElementTree.fromstring(one).find("title").text, "t")


if __name__ == "__main__":
    unittest.main()
