#!/usr/bin/env bash
# What `make bench` does once the programs are built: bench.sh BUILD
set -euo pipefail
out=$1/bench
mkdir -p "$out"
export PYTHONDONTWRITEBYTECODE=1 # beside the sources
"$1/benchmark" "$out"

entries=verification/benchmark problems=$out/problems
mkdir -p "$problems"
"$1/entries" "$problems"
/usr/bin/python3 "$entries/scipy_entry.py" >"$problems/SciPy.csv" # Debian's SciPy is for Debian's Python
all=("$problems"/event\ {1e-6,1e-9,1e-12}.csv "$problems"/{published\ RK4,SciPy,CVODE,GSL,Odeint}.csv
  "$entries/LIGGGHTS.csv") # by make validate
"$entries/score.py" "${all[@]}" | tee "$out/problems.md"
"$entries/score.py" --csv "${all[@]}" >"$out/problems.csv"
figures/draw.sh "$entries/problems.svg" "data = '$out/problems.csv'" "$entries/problems.gp"

figures/draw.sh verification/benchmark/work-precision.svg "data = '$out/work-precision.csv'" \
  verification/benchmark/work-precision.gp
