"""What holds the files of a record together: its JSON ends with the digest of all that stands before it, and among that
are the digests of the files beside it. The other side is reports/evidence/seal.hpp.
"""
import hashlib
import re

from render import files

_END = re.compile(rb'"digest": "([0-9a-f]{64})"\n}\n\Z')


def is_sealed(text):
    """Whether a text ends with the digest of what stands before it."""
    content = text.encode("utf-8")
    end = _END.search(content)
    return end is not None and hashlib.sha256(content[:end.start(1)]).hexdigest().encode() == end[1]


def stranger_beside(directory, raw, name):
    """Why the file of this name is not the one that was written with the record; nothing where it is, or none can tell."""
    known = raw.get("files", {}).get(name)
    if known is None or files.content_digest(directory / name) == known:
        return ""
    return f"{name} is not the file that was written with the record: its digest differs"
