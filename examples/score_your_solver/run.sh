#!/usr/bin/env bash
# Scores two textbook solvers beside ours on the dam break of case `riemann`. Usage: run.sh [FOLDER for the results]
# SEICHE and PYTHON choose the programs; without SEICHE it is the checkout's, or the one on the PATH.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
built=$here/../../build/release/seiche
if [[ -x $built ]]; then seiche=${SEICHE:-$built}; else seiche=${SEICHE:-seiche}; fi
python=${PYTHON:-python3}
out=${1:-score_your_solver}
mkdir -p "$out"

# 1. What is asked for: columns, units, points.
"$seiche" score riemann --template > "$out/template.csv"

# 2. Two results that are not ours: one as CSV, one as HDF5 with names of its own.
"$python" "$here/textbook_finite_volume.py" --flux rusanov --order 1 --output "$out/rusanov.csv"
"$python" "$here/textbook_finite_volume.py" --flux hll --order 2 --output "$out/hll_muscl.h5"

# 3. Their scores, each a record beside that of our own run. Status 1 would mean that a claim is not met.
"$seiche" run riemann --set particles=200 --out "$out/evidence"
"$seiche" score riemann --data "$out/rusanov.csv" --solver textbook-rusanov --out "$out/evidence"
"$seiche" score riemann --data "$out/hll_muscl.h5" --map position=x,depth=h,velocity=u --solver textbook-hll-muscl \
  --out "$out/evidence"

# On three sizes: the order of the solver, and what one per cent would take.
for cells in 100 200 400; do
  "$python" "$here/textbook_finite_volume.py" --flux hll --order 2 --cells "$cells" --output "$out/hll_$cells.csv"
done
"$seiche" score riemann --data "$out/hll_100.csv" --data "$out/hll_200.csv" --data "$out/hll_400.csv" \
  --sizes 0.5,0.25,0.125 --solver textbook-hll-sizes --out "$out/evidence"

# 4. Side by side, as text and as a page.
"$seiche" compare "$out/evidence"
"$seiche" report "$out/evidence"
echo "page: $out/evidence/report/cases/riemann.html"
