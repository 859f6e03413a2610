#!/usr/bin/env bash
# Runs one of these cases with OpenFOAM, version 1912 or near: run.sh CASE FOLDER CELLS
# CELLS: over the width of the column, over the depth, or over the channel; see README.md.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
name=$1 folder=$2 cells=$3
export WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}

mkdir -p "$folder"
run() { "$@" >"log.$1" 2>&1 || { tail -n 20 "log.$1" >&2; exit 1; }; }

if [[ ! -d $here/$name ]]; then
  source "$here/../shallow_water.sh"
  cp -r "$here/shallow_water/." "$folder"
  cd "$folder"
  declare -A flow=([wall]=slip [stream]=zeroGradient)
  # Values of the cells; steps of a Courant number of an eighth at the start, a whole number of them to an instant.
  awk "
    BEGIN {
      for (i = 0; i < $cells; ++i) {
        x = (i + 0.5) * $length / $cells; h = $depth; u = $velocity; z = $bed
        printf \"%.12g\\n\", h >\"h\"; printf \"(%.12g 0 0)\\n\", h * u >\"hU\"; printf \"%.12g\\n\", z >\"h0\"
        speed = sqrt(9.81 * h) + (u < 0 ? -u : u); if (speed > fastest) fastest = speed
      }
      kept = int(8 * $interval * fastest * $cells / $length) + 1
      printf \"along $cells; length $length; endTime $end; kept %d; deltaT %.15g;\\n\", kept, $interval / kept
    }" >system/setup
  for field in 0/h 0/hU constant/h0; do
    type=$([[ $field == 0/hU ]] && echo vector || echo scalar) values=${field#*/}
    { echo "internalField nonuniform List<$type> $cells ("; cat "$values"; echo ");"; } >"$field.internalField"
    rm "$values"
  done
  {
    if [[ $inflow ]]; then echo "leftFlow fixedValue; inflow $inflow; rightFlow zeroGradient;"
    else echo "leftFlow ${flow[$left]}; inflow 0; rightFlow ${flow[$right]};"; fi
    if [[ $outflow ]]; then echo "rightDepth fixedValue; outflow $outflow;"; else echo "rightDepth zeroGradient; outflow 1;"; fi
  } >>system/setup
  run blockMesh
  run shallowWaterFoam
  exit
fi
cp -r "$here/two_phase/." "$here/$name/." "$folder"
cd "$folder"
case $name in
  collapsing_column) echo "along $((10 * cells)); up $((3 * cells));" ;;
  gated_dam_break_vof) echo "along $((10 * cells)); up $((14 * cells / 10));" ;;
  dam_break_wall_pressure) echo "along $((161 * cells / 30)); up $((2 * cells));" ;;
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
run interFoam
