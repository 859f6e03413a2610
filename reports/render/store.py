"""What survives between two runs of the renderer, in the user's own cache folder.

Every entry is keyed by a hash of all that it depends on, renderer source included, so nothing here is ever stale. It
is never read from a folder of evidence or a former report: those may come from a stranger, and what the cache holds
goes into pages as it is.
"""
import atexit
import hashlib
import json
import os
import pathlib
import shutil
import tempfile
import time

_HERE = pathlib.Path(__file__).resolve().parent
MARKER = ".seiche-report"       # a directory that holds it is a report of ours and may be replaced
UNUSED_DAYS = 30                # after which an entry goes


def user_cache():
    """The user's cache folder; one for this run alone where that cannot be written."""
    home = os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache"
    folder = pathlib.Path(home) / "seiche" / "report"
    try:
        folder.mkdir(parents=True, exist_ok=True, mode=0o700)
        if folder.stat().st_uid == os.getuid() and os.access(folder, os.W_OK):
            return folder
    except (OSError, RuntimeError):     # RuntimeError: the user has no home
        pass
    folder = pathlib.Path(tempfile.mkdtemp(prefix="seiche-report-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return folder


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
    """Small texts in one JSON file for each report, figures in a folder that all reports share."""

    def __init__(self, folder, report=""):
        """@param report  names the report whose texts these are: its path"""
        self.folder = pathlib.Path(folder)
        (self.folder / "figures").mkdir(parents=True, exist_ok=True)
        self._texts = self.folder / f"texts-{digest(report)}.json"
        self._salt = source_digest("records.py", "text.py", "formulas.py", "arrays.py")
        self._used = {}
        # A new report begins with the texts of the latest one: most formulas are the same.
        known = self._texts if self._texts.exists() else max(
            self.folder.glob("texts-*.json"), key=lambda path: path.stat().st_mtime, default=self._texts)
        try:
            self._known = json.loads(known.read_text(encoding="utf-8"))
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
        path = self.folder / "figures" / f"{key}.svg"
        if path.exists():
            os.utime(path, (time.time(), path.stat().st_mtime))
        return path

    def save(self):
        """Writes the texts that this run used, and drops what no run has used for a while."""
        beside = self._texts.with_suffix(f".{os.getpid()}.new")
        beside.write_text(json.dumps(self._used, sort_keys=True), encoding="utf-8")
        os.replace(beside, self._texts)
        oldest = time.time() - UNUSED_DAYS * 86400
        for path in [*(self.folder / "figures").iterdir(), *self.folder.glob("texts-*")]:
            if max(path.stat().st_atime, path.stat().st_mtime) < oldest:
                path.unlink(missing_ok=True)
