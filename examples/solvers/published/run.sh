#!/usr/bin/env bash
# Scores results that other people have published, as README.md describes them: run.sh [FOLDER]
# The records go to FOLDER (default: evidence). SEICHE names the program. A claim that is not met is a result and no
# failure.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
out=${1:-evidence}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

score() { "${SEICHE:-seiche}" score "$@" --out "$out" || (($? == 1)); }

score thacker_bowl --table gauges --set periods=0.1 --dx 0.02439 --solver GeoClaw --data "$here/geoclaw/gauge00001.txt"

# r0 of 2 m above the rim in the middle: radius * depth / (depth + 2)
bowl=motion=pulsating,radius=430620,depth=50,start_radius=$(awk 'BEGIN { printf "%.10g", 430620 * 50 / 52 }')
for hour in 18 24; do
  score thacker_bowl --table section --set "$bowl,time=$((3600 * hour))" --columns x,eta --solver "Thetis-${hour}h" \
    --data "$here/thetis/${hour}h.csv"
done

# Time from 17 periods after the start: the origin of the measured records is arbitrary.
awk '{ print $1 - 17 * 2.02, $2 }' "$here/basilisk/bar.ref" >"$scratch/bar.txt"
score luth_bar --columns t,eta --gauges bar=17.3 --dx 0.02441 --solver Basilisk --data "$scratch/bar.txt"
