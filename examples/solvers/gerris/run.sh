#!/usr/bin/env bash
# Runs one of these cases with Gerris: run.sh CASE FOLDER CELLS
# CELLS: over the three widths of the column's box (a power of two), or over the channel; see README.md.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
name=$1 folder=$2 cells=$3
mkdir -p "$folder"
cd "$folder"
case $name in
  collapsing_column)
    level=$(awk "BEGIN { print int(log($cells) / log(2) + 0.5) }")
    awk "BEGIN { for (i = 0; i < 4 * $cells; ++i) print (i + 0.5) * 0.17145 / $cells, 0.085725 / $cells, 0 }" >points
    sed "s/@LEVEL@/$level/" "$here/collapsing_column.gfs.in" >collapsing_column.gfs
    ;;
  wet_dam_break)
    awk "BEGIN { for (i = 0; i < $cells; ++i) print (i + 0.5) * 50 / $cells, 0, 0 }" >points
    {
      echo "$cells $((cells - 1)) $(grep -v '^#' "$here/wet_dam_break.gfs.in" |
        sed "s/@CELL@/$(awk "BEGIN { print 50 / $cells }")/; s/@HALF@/$(awk "BEGIN { print 25 / $cells }")/")"
      echo "GfsBox { left = Boundary }"
      for ((i = 2; i < cells; ++i)); do echo "GfsBox {}"; done
      echo "GfsBox { right = Boundary }"
      for ((i = 1; i < cells; ++i)); do echo "$i $((i + 1)) right"; done
    } >wet_dam_break.gfs
    ;;
  *) echo "run.sh: no case $name" >&2; exit 2 ;;
esac
gerris2D "$name.gfs"
