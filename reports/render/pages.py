"""Pages from templates: the overview, one page per case, how to read it, and everything in one for printing."""
import collections
import fnmatch
import math
import pathlib
import re

import jinja2
from markupsafe import Markup

from render import costs, matrix, power, quantities
from render.experiments import scatter_figure
from render.records import KINDS, VERDICTS, slug

_HERE = pathlib.Path(__file__).resolve().parent
SIGNS = {"pass": "✓", "fail": "✗", "inconclusive": "?", "error": "!", "none": "–"}
FIRST_LOOK = "first-look"   # the table that a page shows before anything else
KIND_NAMES = {"roundoff": "round-off", "order": "order", "bound": "bound", "uncertainty": "uncertainty",
              "qualitative": "qualitative"}


def environment(typesetter, cache):
    """The templates with everything they call. @param cache  folder of the user's own, where they stay compiled"""
    pages = jinja2.Environment(loader=jinja2.FileSystemLoader(_HERE / "templates"), autoescape=True,
                               bytecode_cache=jinja2.FileSystemBytecodeCache(str(cache)),
                               undefined=jinja2.StrictUndefined, trim_blocks=True, lstrip_blocks=True)
    pages.filters.update(number=quantities.number, value=quantities.value, unit=quantities.unit,
                         duration=quantities.duration, percent=percent, block=typesetter.block, inline=typesetter.inline,
                         words=lambda text: text.replace("_", " "), slug=slug, plural=plural, capital=capital)
    pages.globals.update(SIGNS=SIGNS, KINDS=KINDS, KIND_NAMES=KIND_NAMES, with_uncertainty=quantities.with_uncertainty,
                         gauge=gauge, tally=tally, limit_html=limit_html, readable=readable, short_commit=short_commit,
                         scatter_figure=scatter_figure, plain=quantities.plain, cost_figure=costs.figure,
                         cost_of=costs.of)
    return pages


def plural(count, noun, many=None):
    return f"{count} {noun if count == 1 else many or noun + 's'}"


def percent(share):
    """Two digits without a power of ten, so that numbers below each other compare."""
    if share is None:
        return ""
    return Markup("&lt;\u00a0" if 0 < abs(share) < 1e-5 else "") + Markup(f"{quantities.plain(100 * max(share, 1e-5) if share else 0, 2)}\u00a0%")


def capital(text):
    return text[:1].upper() + text[1:]


def short_commit(provenance):
    return provenance["commit"][:10] + (" with uncommitted changes" if provenance["dirty"] else "")


def tally(claims):
    """[(verdict, unexpected, count)] of some claims: what surprises first."""
    counted = collections.Counter((claim.verdict, claim.unexpected) for claim in claims)
    return sorted(((verdict, unexpected, count) for (verdict, unexpected), count in counted.items()),
                  key=lambda item: (not item[1], VERDICTS.index(item[0])))


def readable(claim, number):
    """A measured or expected value: words for what is present or absent, else the number with its unit."""
    if claim.kind == "qualitative" and number in (0, 1):
        return Markup("present" if number else "absent")
    return quantities.number(number)


def limit_html(claim):
    """How far measured may be from expected."""
    limit, criterion = claim.criterion["limit"], claim.criterion
    if claim.kind == "qualitative" or limit is None:
        return Markup("")
    html = Markup("± ") + quantities.number(limit, 3)
    if claim.kind == "bound" and criterion.get("relative") and claim.expected:
        html += Markup(f' <span class="aside">({quantities.plain(100 * limit / abs(claim.expected), 3)} %)</span>')
    return html


def gauge(claim):
    """A small drawing of measured between its limits; nothing where that makes no sense.

    The band is what the criterion allows, the tick its centre, the dot the measurement with its uncertainty.
    """
    limit, measured, expected = claim.criterion["limit"], claim.measured, claim.expected
    if not limit or measured is None or expected is None or limit < 0 or claim.kind == "qualitative":
        return Markup("")
    distance = (measured - expected) / limit
    spread = 0 if claim.uncertainty is None else claim.uncertainty / limit
    one_sided = expected == 0 and measured >= 0 and claim.kind in ("roundoff", "bound")
    low, high = (-0.06, 1.5) if one_sided else (-1.6, 1.6)
    if not (math.isfinite(distance) and math.isfinite(spread)):
        return Markup("")

    def place(value):
        return 4 + 112 * (min(max(value, low), high) - low) / (high - low)

    left, right = place(0 if one_sided else -1), place(1)
    dot = place(distance)
    parts = [f'<path class="axis" d="M4 8H116"/>'
             f'<rect class="band" x="{left:.1f}" y="2.5" width="{right - left:.1f}" height="11"/>',
             f'<path class="centre" d="M{place(0):.1f} 2.5V13.5"/>']
    if spread > 0:
        parts.append(f'<path class="spread" d="M{place(distance - spread):.1f} 8H{place(distance + spread):.1f}"/>')
    if distance > high or distance < low:
        way = 1 if distance > high else -1
        parts.append(f'<path class="dot" d="M{dot:.1f} 4v8l{4 * way} -4z"/>')
    else:
        parts.append(f'<circle class="dot" cx="{dot:.1f}" cy="8" r="3.1"/>')
    said = f"{abs(distance):.3g} of the limit"
    return Markup(f'<svg class="gauge {claim.verdict}" viewBox="0 0 120 16" role="img" aria-label="{said}">'
                  f'<title>{said}</title>{"".join(parts)}</svg>')


def overview(cases, broken, problems):
    """What the first page says at a glance."""
    records = [record for case in cases for record in case.records]
    own = [record for record in records if record.own] or records
    others = [record for record in records if not record.own and own is not records]
    claims = [claim for record in own for claim in record.claims]
    count = collections.Counter((claim.verdict, claim.unexpected) for claim in claims)
    surprises, declared = [], []
    for record in records:
        surprises += [(record, claim) for claim in record.claims if claim.unexpected]
        declared += [(record, claim) for claim in record.claims if claim.declared_failure]
    return {
        "claims": len(claims), "records": len(records), "count": count,
        "surprises": surprises, "declared": declared,
        "crashed": [record for record in records if record.status == "error"],
        "broken": broken, "problems": problems,
        "unexpected_count": len(surprises),
        "own_unexpected": sum(1 for record, _ in surprises if record not in others),
        "evidence": _evidence(own) + _others(others), "deviations": by_cause(declared),
        "wall_time": sum(record.wall_time or 0 for record in own),
        "slowest": sorted(own, key=lambda record: -(record.wall_time or 0))[:5],
        "quiet": not (surprises or broken or any(record.status == "error" for record in records)),
        "provenance": facts(own), "tiers": sorted({record.tier for record in own}),
    }


def _evidence(records):
    """[(title, what it is, claims that hold, claims)] of verification, theory and laboratory; experiments, not their data."""
    kinds = {"Verification": "orders, invariants, exact solutions", "Theory and sources": "exact solutions, published figures",
             "Laboratory": "experiments within their uncertainty"}
    found, beside = {name: [] for name in kinds}, 0
    for record in records:
        name = ("Verification" if record.kind == "verification" else
                "Laboratory" if record.group == "laboratory" else "Theory and sources")
        found[name] += [claim for claim in record.claims if name != "Laboratory" or claim.kind == "uncertainty"]
        beside += sum(1 for claim in record.claims if name == "Laboratory" and claim.kind != "uncertainty")
    kinds["Laboratory"] += f"; {beside} further claims" if beside else ""
    return [(name, kinds[name], sum(1 for claim in claims if claim.verdict == "pass"), len(claims))
            for name, claims in found.items()]


def _others(records):
    """The same of the results of other solvers, where there are some."""
    claims = [claim for record in records for claim in record.claims]
    return [("Other solvers", f"claims on {plural(len(records), 'scored result')}",
             sum(1 for claim in claims if claim.verdict == "pass"), len(claims))] if records else []


def cause_of(case, claim, causes):
    """The title of the first cause that names the claim of the case."""
    return next((cause["title"] for cause in causes
                 if any(fnmatch.fnmatchcase(f"{case}/{claim}", pattern) for pattern in cause["claims"])), "Other causes")


def by_cause(declared):
    """[(cause, [(record, claim)], [((case, page), how many)])] of known deviations, the most frequent cause first."""
    causes, groups = matrix.causes(), collections.defaultdict(list)
    for record, claim in declared:
        groups[cause_of(record.case, claim.id, causes)].append((record, claim))
    return [(cause, members, collections.Counter((record.case, record.page) for record, _ in members).most_common())
            for cause, members in sorted(groups.items(), key=lambda item: (-len(item[1]), item[0]))]


def facts(records):
    """Each fact of provenance with the values it took, most frequent first."""
    gathered = {name: collections.Counter() for name in
                ("commit", "machine", "system", "compiler", "flags", "build", "threads", "libraries", "version")}
    dates = []
    for record in records:
        p = record.provenance
        told = {"commit": short_commit(p), "machine": f"{p['processor']}, {plural(p['cores'], 'core')}",
                "system": p["system"], "compiler": p["compiler"], "flags": p["flags"], "build": p["build_type"],
                "threads": str(p["threads"]), "version": p["version"],
                "libraries": ", ".join(f"{name} {version}" for name, version in sorted(p["libraries"].items()))}
        for name, text in told.items():
            gathered[name].update([text])
        dates.append(p["date"])
    result = {name: [text for text, _ in counter.most_common() if text] for name, counter in gathered.items()}
    result["first"], result["last"] = (_date(min(dates)), _date(max(dates))) if dates else ("", "")
    return result


def _date(text):
    """2026-03-01 12:30 UTC from ISO 8601; anything else as it is."""
    match = re.fullmatch(r"(\d{4}-\d\d-\d\d)T(\d\d:\d\d)(?::\d\d(?:\.\d+)?)?(?:Z|\+00:00)?", text)
    return f"{match[1]} {match[2]} UTC" if match else text


def grouped(cases):
    """[(kind, [(group, [case])])] in the order of the report."""
    kinds = collections.OrderedDict()
    for case in cases:
        kinds.setdefault(case.first.kind, collections.OrderedDict()).setdefault(case.first.group, []).append(case)
    return [(kind, list(groups.items())) for kind, groups in kinds.items()]


def is_first_look(table):
    """Questions with their answers; a table of that name with anything else in it is a table."""
    return table["id"] == FIRST_LOOK and all(len(row) == 2 and all(isinstance(entry, str) for entry in row)
                                             for row in table["rows"])


def case_view(case, drawn, tile_titles):
    """What a case page needs beside the records: figures and claims of several solvers side by side."""
    figures, tables, claims, parameters, measurements = ({} for _ in range(5))
    first_looks = []
    for record in case.records:
        for figure in record.shown:
            figures.setdefault(figure["id"], []).append((record, figure, drawn[record.stem, figure["id"]]))
        for table in record.tables:
            if is_first_look(table):
                first_looks.append((record, table["rows"]))
                continue
            tables.setdefault(table["id"], []).append((record, table))
        for claim in record.claims:
            claims.setdefault(claim.id, {})[record.stem] = claim
        for name, parameter in record.parameters.items():
            parameters.setdefault(name, {})[record.stem] = parameter
        for name, measured in record.measurements.items():
            measurements.setdefault(name, {})[record.stem] = measured
    tiles = dict.fromkeys(tile for record in case.records for tile in record.tiles)
    return {"case": case, "costs": costs.survey(case.records), "first_looks": first_looks, "figures": figures,
            "tables": tables, "claims_by_id": claims, "parameters": parameters,
            "measurements": measurements, "power": [power.table(rows) for rows in [power.read().get(case.name)] if rows],
            "tiles": [(tile, tile_titles[tile]) for tile in tiles if tile in tile_titles]}
