"""Sample runs

    /usr/bin/python3 reports/render/__main__.py build/evidence --out build/evidence/report --jobs 2
    cd reports && /usr/bin/python3 -m render ../build/evidence --out ../build/report --pdf ../build/report.pdf
"""
import pathlib
import sys

_HERE = pathlib.Path(__file__).resolve().parent
# Run by path, Python puts this folder itself on the path, where modules of ours could hide those of others.
sys.path[:] = [entry for entry in sys.path if pathlib.Path(entry or ".").resolve() != _HERE]
sys.path.insert(0, str(_HERE.parent))

from render.command import main  # noqa: E402

if __name__ == "__main__":
    sys.exit(main())
