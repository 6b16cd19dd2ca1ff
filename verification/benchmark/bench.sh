#!/usr/bin/env bash
# What `make bench` does once the programs are built: bench.sh BUILD
set -euo pipefail
out=$1/bench
mkdir -p "$out"
"$1/benchmark" "$out"
figures/draw.sh verification/benchmark/work-precision.svg "data = '$out/work-precision.csv'" \
  verification/benchmark/work-precision.gp
