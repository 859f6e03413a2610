"""What survives between two runs of the renderer, in OUT/.cache.

Every entry is keyed by a hash of all that it depends on, renderer source included, so nothing here is ever stale;
entries that a run did not use are dropped at its end.
"""
import hashlib
import json
import os
import pathlib

_HERE = pathlib.Path(__file__).resolve().parent
MARKER = ".seiche-report"       # a directory that holds it is a report of ours and may be replaced


def digest(*parts):
    """Hash of strings and bytes, with their borders."""
    state = hashlib.sha256()
    for part in parts:
        content = part if isinstance(part, bytes) else str(part).encode("utf-8")
        state.update(len(content).to_bytes(8, "little") + content)
    return state.hexdigest()[:40]


def source_digest(*names):
    """Hash of files of the renderer."""
    return digest(*((_HERE / name).read_bytes() for name in names))


class Store:
    """Small texts in one JSON file, figures in a folder."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        (self.folder / "figures").mkdir(parents=True, exist_ok=True)
        self._salt = source_digest("records.py", "text.py", "formulas.py", "arrays.py")
        self._used, self._figures = {}, set()
        try:
            self._known = json.loads((self.folder / "texts.json").read_text(encoding="utf-8"))
        except (OSError, ValueError):
            self._known = {}

    def memo(self, kind, key, function):
        """The JSON-able result of function(), computed once for each (kind, key)."""
        name = digest(self._salt, kind, key)
        if name not in self._used:
            self._used[name] = self._known[name] if name in self._known else function()
        return self._used[name]

    def figure(self, key):
        """Path in the cache of the drawing with this key; whether it is there is for the caller to see."""
        self._figures.add(key)
        return self.folder / "figures" / f"{key}.svg"

    def save(self):
        """Writes the texts, and drops what this run did not use."""
        beside = self.folder / "texts.json.new"
        beside.write_text(json.dumps(self._used, sort_keys=True), encoding="utf-8")
        os.replace(beside, self.folder / "texts.json")
        for path in (self.folder / "figures").iterdir():
            if path.stem not in self._figures:
                path.unlink()
