"""Files of an evidence folder, which may come from a stranger: only regular files in it, of a size that can be read. Tables
of the baseline, which are ours."""
import csv
import hashlib
import pathlib
import stat

LARGEST_RECORD = 8 * 2**20      # [byte], sixty times the largest of ours; checked against the schema within a minute


RECORD = pathlib.Path(__file__).resolve().parent.parent / "record"      # the baseline


def table(path):
    """Rows of a CSV file by their headings; none where there is no such file."""
    if not pathlib.Path(path).is_file():
        return []
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def is_regular(path):
    """A regular file itself: no link, which may lead anywhere, no pipe, which may never end."""
    try:
        return stat.S_ISREG(pathlib.Path(path).lstat().st_mode)
    except OSError:
        return False


def read_text(path):
    """@throws ValueError  naming what is wrong with the file"""
    if not is_regular(path):
        raise ValueError("not a regular file: links and pipes are not followed")
    size = path.stat().st_size
    if size > LARGEST_RECORD:
        raise ValueError(f"{size} bytes, more than the {LARGEST_RECORD} that a record may have")
    return path.read_bytes().decode("utf-8")


def content_digest(path):
    with open(path, "rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()
