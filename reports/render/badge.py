"""The state of all records in one line, as the JSON that shields.io's endpoint badge reads."""
import json

from render.pages import plural


def badge(cases, broken):
    """{schemaVersion, label, message, color}: green only when every verdict is known and as declared."""
    records = [record for case in cases for record in case.records]
    claims = [claim for record in records for claim in record.claims]
    unfinished = sum(1 for record in records if record.status == "error")
    unexpected = sum(1 for claim in claims if claim.unexpected)
    passed = sum(1 for claim in claims if claim.verdict == "pass")
    failures = sum(1 for claim in claims if claim.declared_failure)

    said = [f"{passed} of {len(claims)} claims pass"]
    said += [phrase for count, phrase in [(failures, plural(failures, "declared failure")),
                                          (unexpected, f"{unexpected} unexpected"),
                                          (unfinished, f"{unfinished} unfinished"),
                                          (len(broken), plural(len(broken), "broken record"))] if count]
    wrong = bool(unexpected or unfinished or broken)
    color = "red" if wrong else "lightgrey" if not claims else "green" if failures else "brightgreen"
    return {"schemaVersion": 1, "label": "seiche", "message": ", ".join(said), "color": color, "isError": wrong}


def write(path, cases, broken):
    path.write_text(json.dumps(badge(cases, broken)) + "\n", encoding="utf-8")
