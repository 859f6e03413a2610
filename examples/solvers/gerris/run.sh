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
  *)
    source "$here/../shallow_water.sh"
    awk "BEGIN { for (i = 0; i < $cells; ++i) print (i + 0.5) * $length / $cells, 0, 0 }" >points
    declare -A boundary=([wall]='Boundary' [stream]='Boundary { BcNeumann U 0 BcNeumann P 0 }')
    at_left=${boundary[$left]} at_right=${boundary[$right]}
    if [[ $inflow ]]; then at_left="Boundary { BcDirichlet U $inflow BcNeumann P 0 }"; fi
    if [[ $outflow ]]; then at_right="Boundary { BcNeumann U 0 BcDirichlet P $outflow }"; fi
    {
      # A row of boxes, one cell each. profile.txt: depth P, discharge U and velocity u of every cell, at every instant.
      cat <<END
$cells $((cells - 1)) GfsRiver GfsBox GfsGEdge {} {
  PhysicalParams { L = $(awk "BEGIN { print $length / $cells }") g = 9.81 }
  MapTransform { tx = $(awk "BEGIN { print $length / 2 / $cells }") }
  Refine 0
  AdvectionParams { cfl = 0.5 gradient = gfs_center_minmod_gradient }
  Init {} { Zb = ($bed) P = ($depth) V = 0 }
  Init {} { U = P*($velocity) }
  Init { istep = 1 } { u = (P > 1e-6 ? U/P : 0.) }
  Time { end = $end }
  OutputLocation { start = $since step = $interval } profile.txt points { precision = %.10g }
}
END
      echo "GfsBox { left = $at_left }"
      for ((i = 2; i < cells; ++i)); do echo "GfsBox {}"; done
      echo "GfsBox { right = $at_right }"
      for ((i = 1; i < cells; ++i)); do echo "$i $((i + 1)) right"; done
    } >"$name.gfs"
    ;;
esac
gerris2D "$name.gfs"
