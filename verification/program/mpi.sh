#!/usr/bin/env bash
# The same sweep by threads and by ranks gives the same bytes, even if a rank is killed during it. Needs
# a program built with MPI.
set -euo pipefail
rotor=$(realpath "$1")
work=$(realpath "$(mktemp -d)")
trap 'rm -rf "$work"' EXIT
cd "$work"
cat >sweep.toml <<'TOML'
[parameters]
tolerance = 1e-7
[[axis]]
quantity = "friction"
values = [0.3, 0.08]
[sample]
count = 700
[[sample.over]]
quantity = "mass_loss_time"
uniform = [29.05, 29.15]
TOML
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
ranks() { mpirun --oversubscribe -n "$@" >/dev/null; }

"$rotor" sweep sweep.toml --out threads.csv >/dev/null
for count in 1 2 3; do
  ranks $count "$rotor" sweep sweep.toml --out ranks.csv
  cmp threads.csv ranks.csv
  rm ranks.csv
done

# Ranks are killed repeatedly, the last one first; others may end with it.
for pause in 0.3 0.5 0.7; do
  ranks 3 "$rotor" sweep sweep.toml --out ranks.csv 2>/dev/null &
  sleep $pause
  pkill -KILL -n -f "rotor sweep sweep.toml --out ranks.csv" || true
  wait $! || true
done
[ -e ranks.csv ] || ranks 3 "$rotor" sweep sweep.toml --out ranks.csv
cmp threads.csv ranks.csv

# An error is reported once.
[ "$(ranks 3 "$rotor" sweep nowhere.toml --out x.csv 2>&1 | grep -c 'nowhere.toml: cannot be read')" = 1 ]
# So is the refusal of threads under mpirun.
[ "$(ranks 3 "$rotor" sweep sweep.toml --out x.csv --jobs 2 2>&1 | grep -c -e '--jobs: under mpirun')" = 1 ]
[ ! -e x.csv ]
echo "Threads and 1, 2, 3 ranks agree to the byte, also after a rank was killed."
