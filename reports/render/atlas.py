"""The atlas: one tile for every figure, table and stated result of the sources, filled by the records that claim it."""
import dataclasses
import json
import pathlib
import sys
import tomllib

from render import files, pictures
from render.pages import tally
from render.records import TIERS

_REPORTS = pathlib.Path(__file__).resolve().parent.parent
TILES = _REPORTS / "atlas.toml"
WORDS = ("reproduced", "reproduced by another method", "source contradicted", "reduced size", "picture only", "not yet")
ORIGINS = {"stated": "Stated by the source", "chosen": "Chosen, the source is silent", "different": "Different from the source"}
AS_DECLARED = ("pass", "declared fail")

@dataclasses.dataclass
class Tile:
    id: str
    kind: str
    place: str
    title: str
    content: str
    beyond: list = dataclasses.field(default_factory=list)       # claims of what the source does not state: they leave the word
    picture: tuple = None          # (record, figure, Drawn)
    table: tuple = None            # (record, table)
    records: list = dataclasses.field(default_factory=list)      # the best first
    kept: str = ""                 # the baseline that reproduces it: tier, commit and day

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
        return [record for record in own if record.kind == "verification"] if self.kind == "set-up" else []

    @property
    def plate(self):
        """The kept picture of the published size, where no run here has it."""
        return None if self.at_source else pictures.of(self.id)

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
    def word(self):
        """One of WORDS, by the runs with the parameters of the source, or by what longer tiers would have of them."""
        if not self.at_source:
            longer = self.published and any(
                record.own and record.standard and TIERS.index(record.tier) < TIERS.index(self.published["tier"])
                for record in self.records)
            return "reduced size" if longer else "not yet"
        if any(record.unexpected for record in self.at_source):
            return "not yet"
        return self.word_of([record.published_set(self.id) for record in self.at_source],
                            {claim.id for record in self.at_source for claim in record.claims if claim.verdict != "pass"})[0]

    def word_of(self, sets, failed):
        """A word and the claims that decide it, by claims that fail as declared in runs with the parameters of the source: all
        claims of what it states hold, with its method and parameters or with others, or where only its method as written
        misses some; or those alone fail whose failure proves the source wrong. A sketch is a picture. Anything else is not
        yet reproduced."""
        if self.kind == "set-up":
            return "picture only", set()
        failed = failed - set(self.beyond)
        missed = {name for name in failed if "as_written" in name}
        wrong = failed & {name for one in sets for name in one["contradicted"]}
        if failed - missed - wrong:
            return "not yet", failed - missed - wrong
        if wrong and not missed:
            return "source contradicted", wrong
        other = missed or any(one["differs"] or one["different"] for one in sets)
        return ("reproduced by another method" if other else "reproduced"), missed

    @property
    def parameters(self):
        """[(where from, [(name, value, unit, the source's value, value of the best record if another)])] of the set."""
        if not self.published:
            return []
        ran, set_ = self.records[0].parameters, self.published
        found = {origin: [] for origin in ORIGINS}
        for name, value in set_["values"].items():
            here = ran.get(name, {"unit": "1", "value": value})
            found[set_["origins"][name]].append((name, value, here["unit"], set_["different"].get(name),
                                                 here["value"] if here["value"] != value else None))
        return [(ORIGINS[origin], members) for origin, members in found.items() if members]

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

def kept_sets(folder=files.RECORD):
    """{(case, published set): tier, commit and day} of the baseline results, where every claim is as declared."""
    kept, folder = {}, pathlib.Path(folder)
    runs = {(row["tier"], row["case"], row["set"]): f", commit {row['commit']} of {row['date']}"
            for row in files.table(folder / "long_runs.csv")}
    for tier in TIERS:
        verdicts = {}
        for row in files.table(folder / f"{tier}.csv"):
            if row["set"]:
                verdicts.setdefault((row["case"], row["set"]), []).append(row["verdict"])
        kept.update({place: tier + runs.get((tier, *place), "") for place, found in verdicts.items()
                     if all(one in AS_DECLARED for one in found)})
    return kept

def baseline_words(cases, folder=files.RECORD):
    """{case: {tile: word, with the claims that decide it}} of the baseline results, for `seiche list --published`.

    @param cases  as `seiche list --json` has them
    """
    tiles = {tile.id: tile for _, members in read() for tile in members}
    rows = {tier: files.table(pathlib.Path(folder) / f"{tier}.csv") for tier in TIERS}
    words = {}
    for case in cases:
        for set_ in case["published"]:
            # Sets of the same values are one run, by the name of the first.
            place = case["name"], next(one for one in case["published"] if one["values"] == set_["values"])["tiles"][0]
            run = [row for row in rows[set_["tier"]] if (row["case"], row["set"]) == place]
            failed = {row["claim"] for row in run if row["verdict"] != "pass"}
            unexpected = {row["claim"] for row in run if row["verdict"] not in AS_DECLARED}
            for tile in set_["tiles"]:
                word, why = ("not yet", unexpected) if unexpected or not run else tiles[tile].word_of([set_], failed)
                why = ", ".join(sorted(why)) if run else "no baseline results"
                words.setdefault(case["name"], {})[tile] = f"{word}: {why}" if why else word
    return words

def strip(sources, most=8):
    """Tiles with a picture, for the first screen: as many of each source as there is room for."""
    shown = [[tile for tile in members if tile.picture] for _, members in sources]
    return [tile for members in shown for tile in members[:most // max(len(shown), 1) + 1]][:most]

def count(sources):
    """{word: how many tiles have it}, and "all"."""
    words = [tile.word for _, members in sources for tile in members]
    return {"all": len(words), **{word: words.count(word) for word in WORDS}}

def in_words(counts):
    """The counts in one phrase."""
    return ", ".join(f"{counts[word]} {word}" for word in WORDS if counts[word] or word == "reproduced")

if __name__ == "__main__":  # seiche list --json | python3 -m render.atlas > reports/record/tiles.json
    print(json.dumps(baseline_words(json.load(sys.stdin)["cases"]), indent=1))
