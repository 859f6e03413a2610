"""Pictures of runs with the parameters of a source that are too long for the quick tier, kept with the baseline results.

    python3 -m render.pictures DIR      writes reports/record/pictures/TILE.webp of the runs that the folder holds
"""
import pathlib
import sys

from render import arrays, figures, files, records

KEPT = files.RECORD / "pictures"


def of(tile):
    """The kept picture of a tile, or None."""
    path = KEPT / f"{tile}.webp"
    return path if files.is_regular(path) else None


def draw(directory, folder=KEPT):
    """Draws the first figure that names a tile, for every tile of whose set a longer tier's record is there."""
    import matplotlib.pyplot
    figures.prepare()
    from render.panels import DRAWINGS
    loaded, _ = records.load(directory, lambda kind, key, function: function())
    drawn = []
    for record in loaded:
        for figure in record.shown:
            for tile in figure["atlas"]:
                set_ = record.published_set(tile)
                if tile in drawn or not (set_ and set_["here"]) or record.tier == records.TIERS[0]:
                    continue
                content = arrays.read_figure(pathlib.Path(directory) / record.data, figure["id"])
                picture = DRAWINGS[figure["drawing"]](content, False)
                folder.mkdir(parents=True, exist_ok=True)
                picture.savefig(folder / f"{tile}.webp", format="webp", dpi=110, pil_kwargs={"quality": 80})
                matplotlib.pyplot.close("all")
                drawn.append(tile)
    return drawn


if __name__ == "__main__":
    print("\n".join(draw(sys.argv[1])))
