"""The HDF5 side of a record: which figures it holds (as digests, for the cache), which arrays, and their data."""
import hashlib

LARGEST_FIGURES = 2 * 10**7     # [number], in all figures of a record; a file of kilobytes may declare far more


def _text(value):
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


def attributes(node):
    """Attributes as plain str, int, float."""
    plain = {}
    for name, value in node.attrs.items():
        if hasattr(value, "item") and getattr(value, "size", 1) == 1:
            value = value.item()
        plain[name] = _text(value) if isinstance(value, bytes) else value
    return plain


def survey(path):
    """What is in the file: {"figures": {id: digest of all its data and attributes}, "arrays": [{name, shape, ...}]}."""
    import h5py
    with h5py.File(path, "r") as file:
        _check(file)
        figures = {}
        for name, group in file["figures"].items() if "figures" in file else ():
            figures[name] = _group_digest(group)
        listed = []

        def visit(name, node):
            if isinstance(node, h5py.Dataset):
                about = attributes(node)
                listed.append({"name": name, "shape": list(node.shape), "type": str(node.dtype),
                               "unit": str(about.get("unit", "")), "meaning": str(about.get("meaning", ""))})

        if "arrays" in file:
            file["arrays"].visititems(visit)
    return {"figures": figures, "arrays": listed}


def _check(file):
    """All that the file shows lies in it, once, and can be held.

    @throws ValueError  naming the object
    """
    import h5py
    numbers, seen, waiting = 0, set(), [("", file)]
    while waiting:
        above, group = waiting.pop()
        for name in group:
            place = f"{above}/{name}"
            if not isinstance(group.get(name, getlink=True), h5py.HardLink):
                raise ValueError(f"{place} is a link; a record holds its data itself")
            node = group[name]
            address = h5py.h5o.get_info(node.id).addr
            if address in seen:
                raise ValueError(f"{place} is there under another name too")
            seen.add(address)
            if isinstance(node, h5py.Group):
                waiting.append((place, node))
            elif isinstance(node, h5py.Dataset):
                if node.external or node.is_virtual:
                    raise ValueError(f"the data of {place} lie in another file")
                numbers += (node.size or 0) if place.startswith("/figures/") else 0
    if numbers > LARGEST_FIGURES:
        raise ValueError(f"its figures declare {numbers} numbers, more than {LARGEST_FIGURES}")


def _group_digest(group):
    import h5py
    state = hashlib.sha256()

    def add(name, node):
        state.update(repr((name, sorted(attributes(node).items(), key=lambda item: item[0]))).encode())
        if isinstance(node, h5py.Dataset):
            state.update(repr((node.shape, str(node.dtype))).encode() + node[()].tobytes())

    add("", group)
    group.visititems(add)
    return state.hexdigest()


def read_figure(path, figure_id):
    """The panels of one figure as dictionaries: attributes, and series with float arrays x, y (and y_error, or z)."""
    import h5py
    import numpy
    with h5py.File(path, "r") as file:
        group = file[f"figures/{figure_id}"]
        figure = attributes(group)
        figure["panels"] = []
        for panel_name in sorted(name for name in group if name.startswith("panel_")):
            panel = attributes(group[panel_name])
            panel["series"] = []
            for series_name in sorted(name for name in group[panel_name] if name.startswith("series_")):
                node = group[panel_name][series_name]
                series = attributes(node)
                for name, data in node.items():
                    values = numpy.asarray(data[()], dtype=float)
                    series[name] = values if series.get("style") in ("surface", "plan") else values.ravel()
                panel["series"].append(series)
            figure["panels"].append(panel)
    return figure
