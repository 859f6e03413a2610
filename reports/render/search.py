"""The index of the first screen's search: a script, so that a report opened as a file finds it."""
import json
import re

WORD = re.compile(r"[^\W_]{3,}")
LONGEST = 60        # words of an article that are kept


def write(path, matrix, cases):
    """[[title, page, words]] of problems, models, and cases; and what else a reader may call things."""
    entries = [[problem.title, f"problems/{problem.id}.html", f"{problem.words} {problem.quantity} {problem.group}".lower()]
               for problem in matrix["problems"]]
    entries += [[model["title"], f"models/{model['id']}.html", f"{model['equations']} {model['avoid']}".lower()]
                for model in matrix["models"]]
    for case in cases:
        if case.first.kind == "validation":
            entries.append([case.first.title, case.first.page, _words(case)])
        else:
            entries += [[record.title, f"{record.page}#{record.stem}", record.source.lower()] for record in case.records[:1]]
    path.parent.mkdir(parents=True, exist_ok=True)
    said = json.dumps({"entries": entries, "synonyms": matrix["synonyms"]}, ensure_ascii=False, separators=(",", ":"))
    path.write_text("window.searchIndex=" + said.replace("<", "\\u003c") + ";\n", encoding="utf-8")


def _words(case):
    """Names, sources, solvers, quantities and the article, each word once."""
    first = case.first
    said = [case.name.replace("_", " "), first.group.replace("_", " "), first.source]
    said += [record.solver for record in case.records] + [claim.quantity for claim in first.claims]
    found = dict.fromkeys(WORD.findall(" ".join(said).lower()))
    article = dict.fromkeys(word for word in WORD.findall(first.article.lower()) if word not in found)
    return " ".join([*found, *list(article)[:LONGEST]])
