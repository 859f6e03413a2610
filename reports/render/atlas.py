"""The atlas: one tile for every figure, table and stated result of the sources, filled by the records that claim it."""
import csv
import dataclasses
import pathlib
import tomllib

from render.pages import tally
from render.records import TIERS

_REPORTS = pathlib.Path(__file__).resolve().parent.parent
TILES = _REPORTS / "atlas.toml"
RECORD = _REPORTS / "record"
AS_DECLARED = ("pass", "declared fail")


@dataclasses.dataclass
class Tile:
    id: str
    kind: str
    place: str
    title: str
    content: str
    picture: tuple = None          # (record, figure, Drawn)
    table: tuple = None            # (record, table)
    records: list = dataclasses.field(default_factory=list)      # the best first
    kept: str = ""                 # the tier whose evidence of record reproduces it

    def rank(self, record):
        """Ours with the parameters of the source before others, of the longest tier before others."""
        published = record.published_set(self.id)
        return (not record.own, not (published and published["here"]), -TIERS.index(record.tier))

    @property
    def published(self):
        """The parameters of the source."""
        return next((one for one in (record.published_set(self.id) for record in self.records) if one), None)

    @property
    def at_source(self):
        """Our runs with the parameters of the source. A verification shows what nobody computed: a sketch, a formula."""
        own = [record for record in self.records if record.own]
        declared = [record for record in own if record.published_set(self.id)]
        if declared:
            return [record for record in declared if record.published_set(self.id)["here"]]
        return [record for record in own if record.kind == "verification"] if self.kind != "computed" else []

    @property
    def judged(self):
        """The runs whose verdicts are the tile's."""
        return self.at_source or self.records

    @property
    def verdicts(self):
        return tally(claim for record in self.judged for claim in record.claims)

    @property
    def crashed(self):
        return any(record.status == "error" for record in self.judged)

    @property
    def state(self):
        """reproduced: a run with the parameters of the source shows it, every claim of such runs as declared; reduced:
        shown by a shorter tier than they need; shown: with other parameters, or not as declared; empty."""
        if self.at_source:
            return "shown" if any(record.unexpected for record in self.at_source) else "reproduced"
        if not self.records:
            return "empty"
        reduced = self.published and any(
            record.own and record.standard and TIERS.index(record.tier) < TIERS.index(self.published["tier"])
            for record in self.records)
        return "reduced" if reduced else "shown"

    @property
    def parameters(self):
        """[(name, value, unit, value of the best record if another)] of the source, those first that differ."""
        if not self.published:
            return []
        ran = self.records[0].parameters
        found = [(name, value, ran[name]["unit"] if name in ran else "1",
                  ran[name]["value"] if name in ran and ran[name]["value"] != value else None)
                 for name, value in self.published["values"].items()]
        return sorted(found, key=lambda one: one[3] is None)


def read(path=TILES):
    """[(source dictionary, [Tile])] in the order of the file."""
    content = tomllib.loads(pathlib.Path(path).read_text(encoding="utf-8"))
    return [(source, [Tile(**tile) for tile in source["tile"]]) for source in content["source"]]


def fill(sources, records, drawn, kept=None):
    """Gives every tile its records and a picture (or a table); returns [(record, id)] of tiles that do not exist.

    @param kept  as kept_sets() gives it
    """
    tiles = {tile.id: tile for _, members in sources for tile in members}
    unknown = []
    for record in records:
        for name in record.tiles:
            if name in tiles:
                tiles[name].records.append(record)
            else:
                unknown.append((record, name))
    for tile in tiles.values():
        tile.records.sort(key=tile.rank)
        for record in tile.records:
            _illustrate(tile, record, drawn)
        if tile.published:
            case = next(record.case for record in tile.records if record.published_set(tile.id))
            tile.kept = (kept or {}).get((case, tile.published["tiles"][0]), "")
    return unknown


def _illustrate(tile, record, drawn):
    """The figure that names the tile, else the table that does, else (for the case as a whole) its first figure."""
    pictures = sorted(record.shown, key=lambda figure: tile.id not in figure["atlas"])
    named = [figure for figure in pictures if tile.id in figure["atlas"]]
    own_tables = [table for table in record.tables if tile.id in table["atlas"]]
    for figure in named or ([] if own_tables else pictures):
        result = drawn[record.stem, figure["id"]]
        if tile.picture is None and result.path is not None:
            tile.picture = (record, figure, result)
    if tile.table is None and own_tables:
        tile.table = (record, own_tables[0])


def kept_sets(folder=RECORD):
    """{(case, published set): tier} of the evidence of record, where every claim is as declared."""
    kept = {}
    for tier in TIERS:
        path = pathlib.Path(folder) / f"{tier}.csv"
        if not path.is_file():
            continue
        verdicts = {}
        with path.open(encoding="utf-8", newline="") as file:
            for row in csv.DictReader(file):
                if row["set"]:
                    verdicts.setdefault((row["case"], row["set"]), []).append(row["verdict"])
        kept.update({place: tier for place, found in verdicts.items() if all(one in AS_DECLARED for one in found)})
    return kept


def strip(sources, most=8):
    """Tiles with a picture, for the first screen: as many of each source as there is room for."""
    shown = [[tile for tile in members if tile.picture] for _, members in sources]
    return [tile for members in shown for tile in members[:most // max(len(shown), 1) + 1]][:most]


def count(sources):
    """{state: how many tiles are in it}, and "all"."""
    states = [tile.state for _, members in sources for tile in members]
    return {"all": len(states), **{state: states.count(state) for state in ("reproduced", "reduced", "shown", "empty")}}


def in_words(counts):
    """The counts in one phrase."""
    words = {"reproduced": "reproduced", "reduced": "shown at reduced size (the parameters of their sources run in a longer tier)",
             "shown": "shown with other parameters or not as expected", "empty": "empty"}
    return ", ".join(f"{counts[state]} {said}" for state, said in words.items() if counts[state] or state == "reproduced")
