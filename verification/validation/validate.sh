#!/usr/bin/env bash
# What `make validate` does once everything is built: runs the accidents by LIGGGHTS, and draws one beside the engine's:
#   validate.sh BUILD [CASES]
# With CASES nothing outside BUILD is written.
set -euo pipefail
build=$1 cases=${2:-} out=$1/validation
mkdir -p "$out"
if [ -n "$cases" ]; then
  "$build/validate" "$out" "$out/cases.csv" "$cases"
  picture=$out
else
  "$build/validate" "$out" reference-data/independent.csv
  "$build/validate" "$out" # enters LIGGGHTS to the problems of rub, too
  mv "$out/LIGGGHTS.csv" verification/benchmark
  picture=verification/validation
fi
"$build/rotor" run --equations corrected --from 29.1 --until 29.1344 --columns time_s,normal_force_N \
  --trace "$out/engine.csv" >/dev/null
figures/draw.sh "$picture/validation.svg" "folder = '$out'" verification/validation/validation.gp
