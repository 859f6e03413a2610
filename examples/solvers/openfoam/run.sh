#!/usr/bin/env bash
# Runs one of these cases with OpenFOAM, version 1912 or near: run.sh CASE FOLDER CELLS
# CELLS: over the width of the column, over the depth, or over the channel; see README.md.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
name=$1 folder=$2 cells=$3
export WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}

mkdir -p "$folder"
solver=interFoam
if [[ $name == wet_dam_break ]]; then solver=shallowWaterFoam; else cp -r "$here/two_phase/." "$folder"; fi
cp -r "$here/$name/." "$folder"
cd "$folder"
case $name in
  collapsing_column) echo "along $((10 * cells)); up $((3 * cells));" ;;
  wet_dam_break) echo "along $cells;"; echo "deltaT $(awk "BEGIN { print 2.0 / $cells }");" >system/step ;;
  standing_wave) echo "along $((5 * cells / 2)); up $((13 * cells / 10));" ;;
  solitary_wave) echo "along $((42 * cells / 2)); up $((16 * cells / 10));" ;;
  *) echo "run.sh: no case $name" >&2; exit 2 ;;
esac >system/cells

run() { "$@" >"log.$1" 2>&1 || { tail -n 20 "log.$1" >&2; exit 1; }; }
run blockMesh
case $name in
  standing_wave) "${PYTHON:-python3}" "$here/exact_fields.py" standing --set amplitude=0.05 ;;
  solitary_wave) "${PYTHON:-python3}" "$here/exact_fields.py" solitary --set amplitude=0.3,gravity=9.81 --velocity ;;
  *) run setFields ;;
esac
run "$solver"
