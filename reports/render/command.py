"""The command line: evidence directory in, report directory out."""
import argparse
import os
import pathlib
import shutil
import sys
import tempfile

from render.store import MARKER


def main(arguments=None):
    options = _options(arguments)
    evidence = pathlib.Path(options.evidence)
    out = pathlib.Path(options.out or evidence / "report")
    if not any(evidence.glob("*.json")):
        return _refuse(f"folder {evidence} holds no record: 'seiche run --tier quick --out {evidence}' makes them")
    if out.exists() and not out.is_dir():
        return _refuse(f"--out {out} is a file; give a directory")
    if out.is_dir() and any(out.iterdir()) and not (out / MARKER).exists():
        return _refuse(f"--out {out} holds files that are not a report; give a new or empty directory")
    browser = None
    if options.pdf:
        from render import pdf
        browser = pdf.find_browser()
        if browser is None:
            return _refuse("--pdf needs a headless browser: install chromium, chromium-browser or google-chrome")
    try:
        import h5py  # noqa: F401  read later, figure by figure, where its absence would only leave figures out
        from render import report
    except ImportError as error:
        return _refuse(f"{sys.executable}: {error}; install python3-jinja2, python3-markdown, python3-numpy, python3-h5py,"
                       " python3-matplotlib, python3-jsonschema, or name an interpreter that has them by SEICHE_PYTHON")
    try:
        out.parent.mkdir(parents=True, exist_ok=True)
        stage = pathlib.Path(tempfile.mkdtemp(prefix=f".{out.name}.", dir=out.parent))
    except OSError as error:
        return _refuse(str(error))
    try:
        stage.chmod(0o777 & ~_umask())
        said = report.build(evidence, stage, out, options)
        _swap(stage, out)
    except OSError as error:
        return _refuse(str(error), 3)
    finally:
        shutil.rmtree(stage, ignore_errors=True)
    print(f"{out / 'index.html'}: {said}")
    if options.pdf:
        try:
            pdf.print_page(browser, out / "print.html", pathlib.Path(options.pdf))
        except pdf.PrintError as error:
            return _refuse(str(error), 3)
        print(options.pdf)
    return 0


def _options(arguments):
    parser = argparse.ArgumentParser(prog="render", description="HTML report of evidence records.")
    parser.add_argument("evidence", metavar="EVIDENCE_DIR", help="directory of <case>.json and <case>.h5")
    parser.add_argument("--out", metavar="OUT_DIR", help="the report's directory (default: EVIDENCE_DIR/report)")
    parser.add_argument("--jobs", type=int, default=min(2, os.cpu_count() or 1),
                        help="drawing processes (default: %(default)s)")
    parser.add_argument("--title", default="Verification and validation of water-wave solvers")
    parser.add_argument("--pdf", metavar="FILE", help="also print the whole report to FILE")
    parser.add_argument("--with-data", action="store_true", help="also copy the records and their arrays")
    parser.add_argument("--scorable", metavar="PHENOMENON/CASE,...", default="",
                        help="cases that score others, as the overview names them")
    options = parser.parse_args(arguments)
    if options.jobs < 1:
        parser.error(f"--jobs {options.jobs} must be at least 1")
    return options


def _swap(stage, out):
    """Puts the finished report in its place; the former one goes only once the new one stands."""
    former = None
    if out.exists():
        former = pathlib.Path(tempfile.mkdtemp(prefix=f".{out.name}.old.", dir=out.parent))
        os.replace(out, former / "report")
    os.replace(stage, out)
    if former:
        shutil.rmtree(former, ignore_errors=True)


def _umask():
    mask = os.umask(0)
    os.umask(mask)
    return mask


def _refuse(sentence, status=2):
    print(f"render: {sentence}", file=sys.stderr)
    return status
