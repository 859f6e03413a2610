"""A Debian changelog from CHANGELOG.md: one entry per released version, newest first.

    python3 ci/debian/changelog.py CHANGELOG.md changelog.Debian.gz --version 0.1.0 --revision 1 --maintainer 'A <a@b>'

Headings are "## 0.1.0 - 2026-05-01" or "## [0.1.0] - 2026-05-01"; the points below become the entry's. The entry of the
version to be packaged is written even where CHANGELOG.md has none yet; what stands under "Unreleased" is part of it.
"""
import argparse
import datetime
import email.utils
import gzip
import os
import pathlib
import re
import subprocess
import textwrap

HEADING = re.compile(r"^## \[?(?P<version>[0-9][\w.]*|Unreleased)\]?\D*(?P<date>\d{4}-\d\d-\d\d)?", re.IGNORECASE)


def releases(text):
    """[(version, date or None, [point, ...])] in the order of the file."""
    found, point = [], False
    for line in text.splitlines():
        heading = HEADING.match(line)
        if heading:
            found.append((heading["version"].lower(), heading["date"], []))
            point = False
        elif found and re.match(r"^[-*] ", line):
            found[-1][2].append(line[2:].strip())
            point = True
        elif point and re.match(r"^ +\S", line):
            found[-1][2][-1] += " " + line.strip()
        else:
            point = False
    return found


def with_version(found, version):
    """The same, the version to be packaged on top, with what is not released yet."""
    pending = [point for name, _, points in found if name == "unreleased" for point in points]
    found = [release for release in found if release[0] != "unreleased"]
    if found and found[0][0] == version:
        return [(version, found[0][1], pending + found[0][2]), *found[1:]]
    return [(version, None, pending), *found]


def last_change(folder):
    """When the source last changed: what reproducible builds say, or the last commit, or this file."""
    if "SOURCE_DATE_EPOCH" in os.environ:
        return int(os.environ["SOURCE_DATE_EPOCH"])
    commit = subprocess.run(["git", "-C", folder, "log", "-1", "--format=%ct"], capture_output=True, text=True)
    if commit.returncode == 0 and commit.stdout.strip():
        return int(commit.stdout)
    return int(pathlib.Path(__file__).stat().st_mtime)


def plain(point):
    """Markdown's links and marks as the text that they stand for."""
    point = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", point)
    return re.sub(r"[`*]", "", point)


def entry(version, date, points, revision, maintainer, fallback):
    seconds = fallback
    if date:
        seconds = datetime.datetime.fromisoformat(date).replace(hour=12, tzinfo=datetime.timezone.utc).timestamp()
    when = email.utils.format_datetime(datetime.datetime.fromtimestamp(seconds, datetime.timezone.utc))
    body = [textwrap.fill(plain(point), 78, initial_indent="  * ", subsequent_indent="    ")
            for point in points or [f"Version {version}."]]
    return "\n".join([f"seiche ({version}-{revision}) unstable; urgency=medium", "", *body, "",
                      f" -- {maintainer}  {when}", ""])


def main():
    parser = argparse.ArgumentParser(description="A Debian changelog from CHANGELOG.md.")
    parser.add_argument("changes", type=pathlib.Path)
    parser.add_argument("output", type=pathlib.Path)
    parser.add_argument("--version", required=True)
    parser.add_argument("--revision", required=True)
    parser.add_argument("--maintainer", required=True)
    options = parser.parse_args()
    text = options.changes.read_text() if options.changes.exists() else ""
    fallback = last_change(options.changes.parent)
    entries = [entry(*release, options.revision, options.maintainer, fallback)
               for release in with_version(releases(text), options.version)]
    options.output.write_bytes(gzip.compress("\n".join(entries).encode(), mtime=0))


if __name__ == "__main__":
    main()
