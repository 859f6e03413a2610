"""What is wrong with a junit.xml: its form (schemas/junit.xsd), and totals that are not those of its test cases."""

import pathlib

from lxml import etree

SCHEMA = pathlib.Path(__file__).resolve().parent / "schemas" / "junit.xsd"
OUTCOMES = {"failures": "failure", "errors": "error", "skipped": "skipped"}


def faults(path):
    document = etree.parse(str(path))
    schema = etree.XMLSchema(etree.parse(str(SCHEMA)))
    if not schema.validate(document):
        return [str(error) for error in schema.error_log]
    found = []
    names = [(test.get("classname"), test.get("name")) for test in document.iter("testcase")]
    found += [f"{name} is there twice" for name in sorted(set(names)) if names.count(name) > 1]
    for node in [document.getroot(), *document.iter("testsuite")]:
        tests = list(node.iter("testcase"))
        counted = {"tests": len(tests)}
        counted |= {total: sum(1 for _ in node.iter(element)) for total, element in OUTCOMES.items()}
        found += [f"{node.get('name')}: {total}={node.get(total)}, counted {count}"
                  for total, count in counted.items() if node.get(total) != str(count)]
        time = sum(float(test.get("time")) for test in tests)
        if abs(float(node.get("time")) - time) > 1e-3 * (1 + len(tests)):
            found.append(f"{node.get('name')}: time={node.get('time')}, sum {time:.3f}")
    return found


def outcomes(path):
    """{(suite, test case): (element, type, message)} of all test cases; None for one that passed."""
    found = {}
    for test in etree.parse(str(path)).iter("testcase"):
        shown = [node for node in test if node.tag in OUTCOMES.values()]
        found[test.get("classname"), test.get("name")] = (
            (shown[0].tag, shown[0].get("type"), shown[0].get("message")) if shown else None)
    return found
