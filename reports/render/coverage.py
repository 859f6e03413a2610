"""Which lines the quick tier runs, as the last run of ci/checks/coverage left it: by room, and the files behind the others."""
import dataclasses
import pathlib

from render import files

WANTED = 0.9        # of a room's lines


@dataclasses.dataclass
class Room:
    name: str
    files: list = dataclasses.field(default_factory=list)       # [(file, lines, ran)]

    @property
    def lines(self):
        return sum(lines for _, lines, _ in self.files)

    @property
    def ran(self):
        return sum(ran for _, _, ran in self.files)

    @property
    def share(self):
        return self.ran / self.lines

    @property
    def wanting(self):
        return self.share < WANTED

    @property
    def behind(self):
        """Files whose share is below what is wanted, the most lines that never ran first."""
        return sorted((one for one in self.files if one[2] < WANTED * one[1]), key=lambda one: one[2] - one[1])


def room_of(file):
    """solver/seiche/exact of solver/seiche/exact/entries/bore.cpp: models have a room each, others none inside rooms."""
    parts = pathlib.PurePosixPath(file).parent.parts
    depth = 4 if parts[:3] == ("solver", "seiche", "models") else 3 if parts[0] == "solver" else 2
    return "/".join(parts[:depth])


def read(path=files.RECORD / "coverage.csv"):
    """[(file, lines, ran)] of the record."""
    return [(row["file"], int(row["lines"]), int(row["ran"])) for row in files.table(path)]


def survey(rows):
    """The rooms by name. @param rows  [(file, lines, ran)], no file without lines"""
    rooms = {}
    for row in sorted(rows):
        rooms.setdefault(room_of(row[0]), Room(room_of(row[0]))).files.append(row)
    return [rooms[name] for name in sorted(rooms)]
