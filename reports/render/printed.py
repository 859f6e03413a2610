"""Formulas of the sources as printed and as solved, with the evidence of what the printed form gives."""
import fnmatch
import pathlib
import tomllib

FORMULAS = pathlib.Path(__file__).resolve().parent.parent / "formulas.toml"


def survey(sources, cases, path=FORMULAS):
    """[(source dictionary, [(formula, [(record, claim)])])] for the sources of the atlas, with the claims that the report has."""
    formulas = tomllib.loads(pathlib.Path(path).read_text(encoding="utf-8"))["formula"]
    return [(source, [(one, _claims(one, cases)) for one in formulas if one["source"] == source["id"]])
            for source, _ in sources]


def _claims(formula, cases):
    wanted = [name.split(": ") for name in formula.get("claims", [])]
    return [(case.first, claim) for name, pattern in wanted for case in cases if case.name == name and case.first.own
            for claim in case.first.claims if fnmatch.fnmatchcase(claim.id, pattern)]
