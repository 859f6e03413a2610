"""The atlas: one tile for every figure, table and stated result of the sources, filled by the records that claim it."""
import dataclasses
import pathlib
import tomllib

from render.pages import tally

TILES = pathlib.Path(__file__).resolve().parent.parent / "atlas.toml"


@dataclasses.dataclass
class Tile:
    id: str
    kind: str
    place: str
    title: str
    content: str
    picture: tuple = None          # (record, figure, Drawn)
    table: tuple = None            # (record, table)
    records: list = dataclasses.field(default_factory=list)

    @property
    def verdicts(self):
        return tally(claim for record in self.records for claim in record.claims)

    @property
    def crashed(self):
        return any(record.status == "error" for record in self.records)

    @property
    def reproduced(self):
        """A run of ours at a tier's own parameters shows it, and every claim of every such run came out as declared."""
        own = [record for record in self.records if record.own and record.standard]
        return bool(own) and not any(record.unexpected for record in own)


def read(path=TILES):
    """[(source dictionary, [Tile])] in the order of the file."""
    content = tomllib.loads(pathlib.Path(path).read_text(encoding="utf-8"))
    return [(source, [Tile(**tile) for tile in source["tile"]]) for source in content["source"]]


def fill(sources, records, drawn):
    """Gives every tile its records and a picture (or a table); returns [(record, id)] of tiles that do not exist."""
    tiles = {tile.id: tile for _, members in sources for tile in members}
    unknown = []
    for record in sorted(records, key=lambda record: not record.own):
        for name in record.tiles:
            if name not in tiles:
                unknown.append((record, name))
                continue
            tile = tiles[name]
            tile.records.append(record)
            pictures = sorted(record.figures, key=lambda figure: name not in figure["atlas"])
            named = [figure for figure in pictures if name in figure["atlas"]]
            own_tables = [table for table in record.tables if name in table["atlas"]]
            # The figure that names the tile, else the table that does, else (for the case as a whole) its first figure.
            for figure in named or ([] if own_tables else pictures):
                result = drawn[record.stem, figure["id"]]
                if tile.picture is None and result.path is not None:
                    tile.picture = (record, figure, result)
            if tile.table is None and own_tables:
                tile.table = (record, own_tables[0])
    return unknown
