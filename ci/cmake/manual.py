"""A manual page from a template and from what the program's own --help prints.

    python3 ci/cmake/manual.py build/release/seiche validation/command/seiche.1.in seiche.1.gz --version 0.1.0

The template is roff; @NAME@, @SYNOPSIS@, @OPTIONS@, @COMMANDS@, @EXIT_STATUS@ and @VERSION@ are filled in. Nothing
depends on the day or the machine: the same program gives the same bytes.
"""
import argparse
import dataclasses
import gzip
import pathlib
import re
import subprocess

INDENT = 30         # of explanations in the help of CLI11


@dataclasses.dataclass
class Help:
    description: str
    usage: str                              # without the program's name
    groups: dict[str, list[tuple[str, str]]]    # "Options" -> (term, explanation)...
    footer: list[str]


def read_help(program, *words):
    """What `program words --help` prints, taken apart."""
    text = subprocess.run([program, *words, "--help"], capture_output=True, text=True, check=True, timeout=60).stdout
    description, _, rest = text.partition("Usage:")
    usage, *lines = rest.splitlines()
    groups, footer, entries = {}, [], None
    for line in lines:
        if line in ("Positionals:", "Options:", "Run and report:", "Score and compare:", "Maintenance:"):
            entries = groups.setdefault(line[:-1], [])
        elif entries is None or (line and not line.startswith("  ")):
            entries = None
            footer.append(line)
        elif line.startswith(" " * INDENT):
            term, explanation = entries[-1]
            entries[-1] = (term, f"{explanation} {line.strip()}".strip())
        elif line:
            term, _, explanation = line.strip().partition("  ")
            entries.append((term, explanation.strip()))
    usage = usage.strip().removeprefix(program).strip()
    return Help(description.strip(), usage, groups, [line for line in footer if line])


def prose(text):
    """Text as roff: hyphens of options are minus signs, which can be copied to a command line."""
    text = text.replace("\\", "\\e")
    text = re.sub(r"(?<![\w)])-|-(?=-)", r"\-", text)
    return re.sub(r"(?m)^([.'])", r"\\&\1", text)


def literal(text):
    """Text that is typed: every hyphen a minus sign."""
    return re.sub(r"(?m)^([.'])", r"\\&\1", text.replace("\\", "\\e").replace("-", r"\-"))


# An option's value in the help of CLI11: "TEXT", "TEXT:{csv,json}=csv", "UINT:INT in [1 - 1024]", "TEXT ...", "FLOAT x 2".
VALUE = re.compile(r"^(?P<kind>\w+)?(?::(?P<check>.*?))?(?:=(?P<default>.*?))?(?: x (?P<count>\d+))?(?P<many> \.\.\.)?"
                   r"(?: REQUIRED)?$")
KINDS = {"TEXT": "text", "INT": "number", "UINT": "number", "FLOAT": "number"}


def entry(term, explanation):
    """Names bold, what stands for a value slanted; what values are allowed follows the explanation."""
    names, _, rest = term.partition(" ")
    value = VALUE.match(rest)
    if not value:
        raise SystemExit(f"manual.py: {term} is not understood")
    notes = []
    check = value["check"] or ""
    if found := re.match(r"\w+ in \[(.*) - (.*)\]$", check):
        notes.append(f"from {found[1]} to {found[2]}")
    elif check.startswith("{") and not all(choice in explanation for choice in check[1:-1].split(",")):
        notes.append(f"one of {check[1:-1].replace(',', ', ')}")
    if value["default"]:
        notes.append(f"default {value['default']}")
    shown = ", ".join(rf"\fB{literal(name)}\fR" for name in names.split(","))
    if value["kind"] and names.startswith("-"):
        kind = KINDS.get(value["kind"], value["kind"])
        shown += rf" \fI{','.join([kind] * int(value['count'] or 1))}\fR"
    if value["many"]:
        shown += r" \&..."
    text = "; ".join([explanation, *notes] if explanation else notes)
    return f".TP\n{shown}\n{prose(text)}"


def entries(pairs):
    return "\n".join(entry(*pair) for pair in pairs)


def footer(lines):
    """Indented lines are examples and stay as they are."""
    roff, example = [], False
    for line in lines:
        if line.startswith("  ") != example:
            example = not example
            roff.append(".PP\n.EX" if example else ".EE\n.PP")
        roff.append(literal(line) if example else prose(line))
    return "\n".join([".PP", *roff, *([".EE"] if example else [])]) if roff else ""


def command(program, name, about, common_footer):
    """A command's section. CLI11 shows the program's footer where a command has none of its own."""
    said = read_help(program, name)
    own_footer = [] if said.footer == common_footer else said.footer
    parts = [rf".SS {pathlib.Path(program).name} {name}", prose(about) + ".",
             entries(said.groups.get("Positionals", []) + without_help(said)), footer(own_footer)]
    return "\n".join(part for part in parts if part), said.usage


def without_help(said):
    return [(name, text) for name, text in said.groups.get("Options", []) if not name.startswith("-h,")]


def exit_status(lines):
    """"Exit status: 0 all well, 1 not so." as a list; the footer that says so must be there."""
    found = re.search(r"Exit status: (.*)\.$", " ".join(lines))
    if not found:
        raise SystemExit("manual.py: --help says nothing of the exit status")
    return "\n".join(f".TP\n.B {number}\n{prose(text)}"
                     for number, text in re.findall(r"(\d) (.*?)(?:[,;] (?=\d )|$)", found[1]))


def page(program, template, version):
    name = pathlib.Path(program).name
    said = read_help(program)
    about, _, _ = said.description.partition("\n")
    about = re.sub(rf"^{name}( [\d.]+)?: ", "", about).rstrip(".")
    commands = [command(program, sub, text, said.footer) for heading, group in said.groups.items()
                if heading not in ("Positionals", "Options") for sub, text in group]
    usages = [usage for _, usage in commands] or [said.usage]
    filled = {
        "VERSION": version,
        "NAME": rf"{literal(name)} \- {prose(about)}",
        "SYNOPSIS": "\n.br\n".join(rf"\fB{literal(name)}\fR {literal(usage)}" for usage in usages),
        "OPTIONS": entries(said.groups.get("Positionals", []) + said.groups["Options"]),
        "COMMANDS": "\n".join(text for text, _ in commands),
        "EXIT_STATUS": exit_status(said.footer),
    }
    return re.sub(r"@(\w+)@", lambda field: filled[field[1]], template)


def main():
    parser = argparse.ArgumentParser(description="A manual page from a program's own --help.")
    parser.add_argument("program")
    parser.add_argument("template", type=pathlib.Path)
    parser.add_argument("output", type=pathlib.Path, help="compressed, as manuals are installed")
    parser.add_argument("--version", required=True)
    options = parser.parse_args()
    text = page(str(pathlib.Path(options.program).resolve()), options.template.read_text(), options.version)
    options.output.parent.mkdir(parents=True, exist_ok=True)
    options.output.write_bytes(gzip.compress(text.encode(), mtime=0))


if __name__ == "__main__":
    main()
