"""Drawings by name. A record names the drawing that each of its figures wants; most want "panels".

A special one is a small function beside panels.py, marked `@drawing("name")`, that takes the figure (see
arrays.read_figure) and returns a matplotlib Figure; `small` asks for a picture the size of a stamp, for the atlas: no
text.
"""
DRAWINGS = {}


def drawing(name):
    """Registers a function (figure, small) -> matplotlib Figure under the name that records use."""
    def register(function):
        DRAWINGS[name] = function
        return function
    return register
