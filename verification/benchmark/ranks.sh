#!/usr/bin/env bash
# How long a sweep takes with one rank, two, and twice as many as this machine has cores: the
# shortest of three, without what an empty sweep takes to start and to end.
set -euo pipefail
rotor=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
sweep() { # points
  printf '[parameters]\ntolerance = 1e-7\n[sample]\ncount = %s\n[[sample.over]]\nquantity = "friction"\nuniform = [0.2, 0.4]\n' "$1"
}
sweep 8000 >long.toml
sweep 1 >short.toml
seconds() { # file ranks
  local best=1e9 start
  for _ in 1 2 3; do
    start=$EPOCHREALTIME
    mpirun --oversubscribe -n "$2" "$rotor" sweep "$1" --out r.csv >/dev/null
    best=$(echo "$best $start $EPOCHREALTIME" | awk '{ t = $3 - $2; print t < $1 ? t : $1 }')
    rm r.csv
  done
  echo "$best"
}
for ranks in 1 2 $((2 * $(nproc))); do
  echo "$ranks $(nproc) $(seconds long.toml $ranks) $(seconds short.toml $ranks) ${one:-}"  |
    awk '{ t = $3 - $4; one = NF > 4 ? $5 : t; busy = $1 < $2 ? $1 : $2
           printf "%2d rank(s): %.2f s for 8,000 points, %.0f %% of %d cores\n", $1, t, 100 * one / t / busy, busy }' |
    tee line
  one=${one:-$(awk '{ print $3 }' line)}
done
