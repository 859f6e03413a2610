"""Mutants: small random changes of the code, and whether a check noticed, as the last run of ci/mutate left it."""
import dataclasses
import math

from render import files

Z = 1.959964        # 95 % of a normal distribution lie within


@dataclasses.dataclass
class Room:
    name: str
    rows: list = dataclasses.field(default_factory=list)

    def count(self, outcome):
        return sum(row["outcome"] == outcome for row in self.rows)

    @property
    def counted(self):
        """Those that a check could have noticed."""
        return len(self.rows) - self.count("equivalent")

    @property
    def rate(self):
        return self.count("killed") / self.counted if self.counted else None

    @property
    def interval(self):
        """Wilson's, of the rate."""
        if not self.counted:
            return None
        n, p = self.counted, self.rate
        middle, half = p + Z * Z / (2 * n), Z * math.sqrt(p * (1 - p) / n + Z * Z / (4 * n * n))
        return (middle - half) / (1 + Z * Z / n), (middle + half) / (1 + Z * Z / n)

    @property
    def survivors(self):
        return sorted((row for row in self.rows if row["outcome"] in ("survived", "record only", "equivalent")),
                      key=lambda row: (row["outcome"] == "equivalent", row["file"], int(row["line"])))


def read():
    """Rows of the record."""
    return files.table(files.RECORD / "mutation.csv")


def survey(rows):
    """What the page shows: the mutants by room, all of them together, and the seeded faults by room."""
    random, seeded = {}, {}
    for row in rows:
        rooms = seeded if row["seed"] == "seeded" else random
        rooms.setdefault(row["room"], Room(row["room"])).rows.append(row)
    rooms = [random[name] for name in sorted(random)]
    drawn = [row for room in rooms for row in room.rows]
    return {"rooms": rooms, "all": Room("All parts", drawn), "seeded": [seeded[name] for name in sorted(seeded)],
            "seeds": sorted({row["seed"] for row in drawn}), "commits": sorted({row["commit"] for row in drawn})}
