"""How sharp the checks are: how much of its limit each claim uses.

A claim that uses nearly all of it may fail on the next machine; one that uses next to nothing would let a defect a
hundred times larger through.
"""
import dataclasses
import math

MARGINAL = 0.9
LOOSE = 0.01
SHOWN = 40          # of the loose ones
EDGES = (0.0, 1e-4, 1e-3, 1e-2, 0.1, 0.3, 0.6, 0.9, 1.0)


@dataclasses.dataclass
class Used:
    """A claim that was met, with the share of its limit that it uses."""
    record: object
    claim: object
    share: float


def share(claim):
    """Of its limit, what a claim uses; None where that says nothing: features, failures, what was not measured."""
    limit, measured, expected = claim.criterion["limit"], claim.measured, claim.expected
    if claim.kind == "qualitative" or claim.verdict != "pass" or not limit or measured is None or expected is None:
        return None
    # An order is judged with its interval, a bound with the uncertainty of what was measured.
    spread = (claim.uncertainty or 0.0) if claim.kind in ("order", "bound", "roundoff") else 0.0
    used = (abs(measured - expected) + spread) / limit
    return used if math.isfinite(used) else None


def survey(records):
    """What the page shows: per kind how many claims use how much, and the lists of marginal and loose ones."""
    used = [Used(record, claim, share(claim)) for record in records for claim in record.claims]
    used = [one for one in used if one.share is not None]
    kinds = {}
    for one in used:
        counts = kinds.setdefault(one.claim.kind, [0] * len(EDGES))
        counts[0 if one.share == 0 else 1 + next((k for k, edge in enumerate(EDGES[1:-1]) if one.share < edge),
                                                 len(EDGES) - 2)] += 1
    return {"kinds": kinds, "columns": columns(), "count": len(used),
            "exact": sum(1 for one in used if one.share == 0),
            "marginal": sorted((one for one in used if one.share > MARGINAL), key=lambda one: -one.share),
            "loose": sorted((one for one in used if 0 < one.share < LOOSE), key=lambda one: one.share)}


def columns():
    """Headings of the table: "0", "below 0.0001", ..., "0.9 to 1"."""
    heads = ["0", f"below {EDGES[1]:g}"]
    return heads + [f"{low:g} to {high:g}" for low, high in zip(EDGES[1:], EDGES[2:])]
