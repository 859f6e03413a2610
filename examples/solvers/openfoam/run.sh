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
  wave_attenuation)
    echo "along $((63 * cells / 10)); up $((13 * cells / 10));"
    # The wave and the instants are those that the case asks for, t=FIRST:LAST:COUNT.
    reference=$("${SEICHE:-seiche}" score wave_attenuation --template | sed -n 's/^# the reference: //p')
    wave=${reference#*--set } instants=${reference##*,t=}
    wave=${wave%% *}
    IFS=: read -r first last _ <<<"$instants"
    awk "BEGIN { printf \"interval %.12g;\nendTime %.12g;\n\", $first, $last }" >system/instants
    ;;
  *) echo "run.sh: no case $name" >&2; exit 2 ;;
esac >system/cells

run() { "$@" >"log.$1" 2>&1 || { tail -n 20 "log.$1" >&2; exit 1; }; }
run blockMesh
# from_exact NAME SETTINGS: the start is an exact wave at t = 0; the fields take the place of uniform ones.
from_exact() {
  run postProcess -func writeCellCentres -time 0
  "${SEICHE:-seiche}" exact "$1" --set "$2" --write openfoam --centres 0/C --up y --out 0 >log.seiche
  for field in alpha.water U; do sed -i "s/^internalField .*/#include \"$field.internalField\"/" "0/$field"; done
}
case $name in
  standing_wave) from_exact standing amplitude=0.05,gravity=9.81 ;;
  solitary_wave) from_exact solitary amplitude=0.3,gravity=9.81 ;;
  wave_attenuation) from_exact stokes "$wave" ;;
  *) run setFields ;;
esac
run "$solver"
