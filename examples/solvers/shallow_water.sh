# Set-ups of seiche's cases of shallow water, sourced by the run.sh of each solver with the case's name in `name`.
# Bed, depth and velocity at t = 0 are expressions of x that C and awk read alike. At an end is a `wall`, or a `stream` that
# goes on as it is; `inflow` holds the discharge at the left end and `outflow` the depth at the right one.
left=wall right=wall bed=0 velocity=0 inflow='' outflow=''

# behind FRONT STILL: velocity behind a bore
behind() { awk "BEGIN { printf \"%.12g\", ($1 - $2) * sqrt(9.81 / 2 * ($1 + $2) / ($1 * $2)) }"; }

case $name in
  riemann) length=50 end=6 depth='x < 20 ? 1 : 0.1' ;;
  moving_bore) length=120 end=8 left=stream depth='x < 40 ? 2 : 1' velocity="x < 40 ? $(behind 2 1) : 0" ;;
  colliding_bores)
    length=100 left=stream right=stream
    depth='x < 30 ? 2 : x < 70 ? 1 : 1.5'
    velocity="x < 30 ? $(behind 2 1) : x < 70 ? 0 : -$(behind 1.5 1)"
    end=$(awk "BEGIN { print 40 / ($(behind 2 1) * 2 + $(behind 1.5 1) * 3) + 2 }") # they meet, and two seconds
    ;;
  bore_reflection)
    length=10 end=2.6 left=stream
    depth='x < 5 ? 1 : 0.6343140641800991' velocity="x < 5 ? $(behind 1 0.6343140641800991) : 0"
    ;;
  thacker)
    length=3.75 end=6.03 interval=0.0201 bed='0.5 * ((x - 1.875) * (x - 1.875) - 1)'
    depth='(x - 1.375) * (x - 1.375) < 1 ? 0.5 * (1 - (x - 1.375) * (x - 1.375)) : 0'
    ;;
  steady_bump)
    length=25 end=100 inflow=4.42 outflow=2
    bed='x > 8 && x < 12 ? 0.2 - 0.05 * (x - 10) * (x - 10) : 0'
    depth="2 - ($bed)" velocity="4.42 / (2 - ($bed))"
    ;;
  gated_dam_break) length=2 end=0.7 interval=0.01 depth='x < 0.38 ? 0.15 : 0.038' ;;
  *) echo "run.sh: no case $name" >&2; exit 2 ;;
esac
since=${interval:+0}
since=${since:-$end} interval=${interval:-$end} # the first instant that is kept, and the time between two
